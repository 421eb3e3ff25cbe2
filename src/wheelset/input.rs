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
    /// Coefficient of friction, ≥ 0 [-].
    pub friction: f64,
}

impl Default for Input {
    /// The nominal position in the middle of the track, just lifted, at rest.
    fn default() -> Self {
        let element::Input { wheel, rails, wheel_load, track_s, friction } =
            element::Input::default();
        let [x, _, z] = wheel.position;
        Self {
            wheelset: WheelMotion { position: [x, 0.0, z], ..wheel },
            sides: [SideInput { rails, wheel_load, friction }; 2],
            track_s,
        }
    }
}

impl Input {
    /// All numbers zero: no rates.
    #[must_use]
    pub fn at_rest() -> Self {
        let element::Input { wheel, rails, wheel_load, track_s, friction } =
            element::Input::from_array([0.0; element::input::INPUTS]);
        let sides = [SideInput { rails, wheel_load, friction }; 2];
        Self { wheelset: wheel, sides, track_s }
    }

    /// The input of the element on one side, whose marker is `along` [m] to the right of the centre.
    #[must_use]
    pub fn of_side(&self, side: usize, along: f64) -> element::Input {
        let SideInput { rails, wheel_load, friction } = self.sides[side];
        element::Input {
            wheel: self.wheelset.along_axle(along),
            wheel_load,
            rails,
            track_s: self.track_s,
            friction,
        }
    }

    /// Whether every input is finite and friction is not negative.
    ///
    /// # Errors
    /// The first input at fault, by its name.
    pub fn check(&self) -> Result<(), ContactError> {
        // The centre is checked as a wheel would be, the sides with it, so that names can be told apart.
        for (k, side) in SIDES.into_iter().enumerate() {
            let SideInput { rails, wheel_load, friction } = self.sides[k];
            let (wheel, track_s) = (self.wheelset, self.track_s);
            let as_wheel = element::Input { wheel, wheel_load, rails, track_s, friction };
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
