//! What an evaluation of a wheelset depends on besides its parameters.

use super::{SIDES, name_on_side};
use crate::element;
use crate::element::input::{RailMotion, WheelMotion};
use crate::element::parameters::RAILS;
use crate::error::ContactError;

/// All inputs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Input {
    /// Motion of the centre of the wheelset, midway between the wheel markers.
    pub wheelset: WheelMotion,
    /// What is under the right wheel and under the left one.
    pub sides: [SideInput; 2],
    /// Station along the track [m].
    pub track_s: f64,
}

/// Rails and friction of one side; values are those of the real side in the track frame, not mirrored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SideInput {
    /// The rails, `rail[1]` first.
    pub rails: [RailMotion; RAILS],
    /// Vertical force of the wheel on its rails together, down, if the loads are given and not height and roll [N].
    pub wheel_load: f64,
    /// Coefficient of friction where it is the same everywhere, ≥ 0 [-].
    pub friction: f64,
    /// Coefficient of friction of the tread of the rails where they have regions, ≥ 0 [-].
    pub tread_friction: f64,
    /// Coefficient of friction of their gauge faces, ≥ 0 [-].
    pub gauge_face_friction: f64,
}

impl SideInput {
    /// What of the input of a wheel is of its side.
    fn of(input: &element::Input) -> Self {
        let &element::Input {
            rails,
            wheel_load,
            friction,
            tread_friction,
            gauge_face_friction,
            ..
        } = input;
        Self { rails, wheel_load, friction, tread_friction, gauge_face_friction }
    }

    /// The input of the wheel of this side.
    fn with(&self, wheel: WheelMotion, track_s: f64) -> element::Input {
        let &Self { rails, wheel_load, friction, tread_friction, gauge_face_friction } = self;
        element::Input {
            wheel,
            wheel_load,
            rails,
            track_s,
            friction,
            tread_friction,
            gauge_face_friction,
        }
    }
}

impl Default for Input {
    /// The nominal position in the middle of the track, just lifted, at rest.
    fn default() -> Self {
        let input = element::Input::default();
        let [x, _, z] = input.wheel.position;
        Self {
            wheelset: WheelMotion { position: [x, 0.0, z], ..input.wheel },
            sides: [SideInput::of(&input); 2],
            track_s: input.track_s,
        }
    }
}

impl Input {
    /// All numbers zero: no rates.
    #[must_use]
    pub fn at_rest() -> Self {
        let input = element::Input::from_array([0.0; element::input::INPUTS]);
        let sides = [SideInput::of(&input); 2];
        Self { wheelset: input.wheel, sides, track_s: input.track_s }
    }

    /// The input of the element on one side, whose marker is `along` [m] to the right of the centre.
    #[must_use]
    pub fn of_side(&self, side: usize, along: f64) -> element::Input {
        self.sides[side].with(self.wheelset.along_axle(along), self.track_s)
    }

    /// Whether every input is finite and friction is not negative.
    ///
    /// # Errors
    /// The first input at fault, by its name.
    pub fn check(&self) -> Result<(), ContactError> {
        // The centre is checked as a wheel would be, the sides with it, so that names can be told apart.
        for (k, side) in SIDES.into_iter().enumerate() {
            let as_wheel = self.sides[k].with(self.wheelset, self.track_s);
            as_wheel.check().map_err(|error| {
                error.renamed(|name| match name.strip_prefix("wheel.") {
                    Some(coordinate) if coordinate != "load" => format!("wheelset.{coordinate}"),
                    _ => name_on_side(name, side),
                })
            })?;
        }
        Ok(())
    }
}
