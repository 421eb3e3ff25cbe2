//! What an evaluation of a wheelset depends on besides its parameters.

use super::rail_frame::RailFrame;
use super::sides::{SIDES, name_on_side};
use super::track::{RailLine, TrackTurn};
use crate::element;
use crate::element::input::{RailMotion, WheelMotion};
use crate::element::parameters::RAILS;
use crate::error::ContactError;
use crate::math::numbers::{Numbers, numbers};
use crate::open::Open;

/// All inputs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Input<T = f64> {
    /// Motion of the centre of the wheelset, midway between the wheel markers, in the track frame,
    /// which goes along the track with its velocity along x.
    pub wheelset: WheelMotion<T>,
    /// What is under the right wheel and under the left one.
    pub sides: [SideInput<T>; 2],
    /// Station along the track [m].
    pub track_s: T,
    /// How the track frame turns along the track.
    pub track: TrackTurn<T>,
}

/// Rails and friction of one side; values are those of the real side in the track frame, not
/// mirrored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SideInput<T = f64> {
    /// The rails, `rail[1]` first.
    pub rails: [RailMotion<T>; RAILS],
    /// Vertical force of the wheel on its rails together, down, if the loads are given and not
    /// height and roll [N].
    pub wheel_load: T,
    /// Coefficient of friction where it is the same everywhere, ≥ 0 [-].
    pub friction: T,
    /// Coefficient of friction of the tread of the rails where they have regions, ≥ 0 [-].
    pub tread_friction: T,
    /// Coefficient of friction of their gauge faces, ≥ 0 [-].
    pub gauge_face_friction: T,
    /// Where the rails lie beside their design line.
    pub line: RailLine<T>,
    /// Pitch angle of the wheel against that of the wheelset, of wheels that turn by themselves
    /// [rad].
    pub own_pitch: T,
    /// Pitch rate of the wheel against that of the wheelset [rad/s].
    pub own_pitch_rate: T,
}

numbers!(Input: wheelset, sides, track_s, track);
numbers!(
    SideInput: rails, wheel_load, friction, tread_friction, gauge_face_friction, line, own_pitch,
    own_pitch_rate
);

impl SideInput {
    /// The input of an element with a `wheel` of this side.
    pub(super) fn with(&self, wheel: WheelMotion, track_s: f64) -> element::Input {
        element::Input {
            wheel,
            wheel_load: self.wheel_load,
            rails: self.rails,
            track_s,
            friction: self.friction,
            tread_friction: self.tread_friction,
            gauge_face_friction: self.gauge_face_friction,
            // By name, so that a further input is not left out here without a word.
            open: Open::default(),
        }
    }

    /// # Errors
    /// What is not in its range of what an element has not, by its name on a `side`.
    fn check(&self, side: &str) -> Result<(), ContactError> {
        self.line.check(side)?;
        for (name, value) in
            [("own_pitch", self.own_pitch), ("own_pitch_rate", self.own_pitch_rate)]
        {
            if !value.is_finite() {
                let name = format!("{side}.wheel.{name}");
                return Err(ContactError::bad_value(name, value, "a finite number"));
            }
        }
        Ok(())
    }
}

impl Default for Input {
    /// The nominal position in the middle of the track, just lifted, at rest; rails, load and friction
    /// as by default of an [`element::Input`].
    fn default() -> Self {
        let input = element::Input::default();
        let [x, _, z] = input.wheel.position;
        let side = SideInput {
            rails: input.rails,
            wheel_load: input.wheel_load,
            friction: input.friction,
            tread_friction: input.tread_friction,
            gauge_face_friction: input.gauge_face_friction,
            line: RailLine::default(),
            own_pitch: 0.0,
            own_pitch_rate: 0.0,
        };
        Self {
            wheelset: WheelMotion { position: [x, 0.0, z], ..input.wheel },
            sides: [side; 2],
            track_s: input.track_s,
            track: TrackTurn::default(),
        }
    }
}

impl Input {
    /// All numbers zero: no rates.
    pub fn at_rest() -> Self {
        Self::default().each(&mut |_| 0.0)
    }

    /// The input of the element on one side, whose marker is `along` [m] to the right of the
    /// centre, in the frame of its rails.
    pub fn of_side(&self, side: usize, along: f64) -> element::Input {
        let own = &self.sides[side];
        let mut wheel = self.track.against_ground(&self.wheelset).along_axle(along);
        wheel.pitch += own.own_pitch;
        wheel.pitch_rate += own.own_pitch_rate;
        if let Some(frame) = self.rail_frame(side, along) {
            wheel = frame.motion(&wheel);
        }
        own.with(wheel, self.track_s)
    }

    /// The frame of the rails of a side, where it is not that of the track.
    pub(super) fn rail_frame(&self, side: usize, along: f64) -> Option<RailFrame<f64>> {
        let Self { track, sides, .. } = self;
        let line = &sides[side].line;
        let is_other = *line != RailLine::default() || *track != TrackTurn::default();
        is_other.then(|| RailFrame::new(line, track, self.wheelset.position[0], along))
    }

    /// Whether every input is finite and friction is not negative.
    ///
    /// # Errors
    /// The first input at fault, by its name.
    pub fn check(&self) -> Result<(), ContactError> {
        self.track.check()?;
        // The centre is checked as a wheel would be, the sides with it, so that names can be told
        // apart.
        for (k, side) in SIDES.into_iter().enumerate() {
            let as_wheel = self.sides[k].with(self.wheelset, self.track_s);
            as_wheel.check().map_err(|error| {
                error.renamed(|name| match name.strip_prefix("wheel.") {
                    Some(coordinate) if coordinate != "load" => format!("wheelset.{coordinate}"),
                    _ => name_on_side(name, side),
                })
            })?;
            self.sides[k].check(side)?;
        }
        Ok(())
    }
}
