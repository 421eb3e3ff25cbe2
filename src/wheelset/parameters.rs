//! What is fixed once a wheelset is made.

use super::sides::{LEFT, RIGHT};
use crate::element::parameters::{Motion, Side};
use crate::element::{self, FreeRolling};
use crate::error::ContactError;
use crate::open::Open;

/// Distance of the tape circle, the origin of the wheel profiles, from the flange back [m].
pub const TAPE_CIRCLE: f64 = 0.07;

/// Everything fixed over a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameters {
    /// Distance of the flange backs, > 0, 1.36 by default; the wheel markers are the distance of the
    /// tape circle farther out on both sides [m].
    pub flange_back_distance: f64,
    /// File with the irregularities of the rails over the station (five columns, see
    /// `io::irregularity_file`); none if empty, as by default.
    pub irregularity_file: String,
    /// Right and left wheel with their rails; each `side` is that of its place, whatever it says.
    pub sides: [element::Parameters; 2],
    #[doc(hidden)]
    pub open: Open,
}

impl Default for Parameters {
    fn default() -> Self {
        Self::of_both(&element::Parameters::default())
    }
}

impl Parameters {
    /// The same for both sides, flange backs 1.36 m apart. Rails placed by position get their
    /// mirror images, wherever `one` is.
    pub fn of_both(one: &element::Parameters) -> Self {
        let sides = [Side::Right, Side::Left].map(|side| one.on_side(side));
        Self {
            flange_back_distance: 1.36,
            irregularity_file: String::new(),
            sides,
            open: Open::default(),
        }
    }

    /// Distance of each wheel marker from the centre, positive to the right [m].
    pub fn markers(&self) -> [f64; 2] {
        let half = 0.5 * self.flange_back_distance + TAPE_CIRCLE;
        [half, -half]
    }

    /// What turns the axle, if not its input.
    pub(super) fn rolling(&self) -> Option<[FreeRolling; 2]> {
        let [right, left] = &self.sides;
        Some([FreeRolling::of(right)?, FreeRolling::of(left)?])
    }

    /// The parameters of each element, and whether the distance is admitted; elements check their
    /// own.
    pub(super) fn checked(&self) -> Result<[element::Parameters; 2], ContactError> {
        let distance = self.flange_back_distance;
        if !(distance.is_finite() && distance > 0.0) {
            let allowed = "a finite number greater than 0";
            return Err(ContactError::bad_value("flange_back_distance", distance, allowed));
        }
        let [right, left] = &self.sides;
        if right.vertical_mode != left.vertical_mode {
            let (name, value) = ("vertical.mode".into(), "penetration and load".into());
            let allowed = "the same on both sides".into();
            return Err(ContactError::BadText { name, value, allowed });
        }
        if right.motion != left.motion {
            let (name, value) = ("motion".into(), "given and rolling".into());
            let allowed = "the same on both sides".into();
            return Err(ContactError::BadText { name, value, allowed });
        }
        let mut sides = [right.clone(), left.clone()];
        for side in &mut sides {
            // The axle turns both wheels.
            side.motion = Motion::Given;
        }
        sides[RIGHT].side = Side::Right;
        sides[LEFT].side = Side::Left;
        Ok(sides)
    }
}
