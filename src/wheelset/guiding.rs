//! Guiding forces and wheel loads, by which vehicles are approved (EN 14363: Y, Q, Y/Q and the sum
//! of Y).

use super::sides::{LEFT, RIGHT};
use crate::math::numbers::numbers;
use crate::math::real::Real;

/// Forces between one wheel and its rails.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct SideForces<T = f64> {
    /// Y: lateral force of the wheel on its rails, positive away from the middle of the track [N].
    pub guiding_force: T,
    /// Q: vertical force of the wheel on its rails, down [N].
    pub vertical_force: T,
    /// Y/Q, 0 for a wheel that carries nothing [-].
    pub quotient: T,
}

/// Those of both wheels.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Guiding<T = f64> {
    /// Each side.
    pub sides: [SideForces<T>; 2],
    /// Sum of Y: lateral force of the wheelset on the track, positive to the right [N].
    pub track_shifting_force: T,
}

numbers!(SideForces: guiding_force, vertical_force, quotient);
numbers!(Guiding: sides, track_shifting_force);

/// Of the `forces` (x, y, z) on both wheels in the track frame, right first.
pub(super) fn guiding<T: Real>(forces: &[[T; 3]; 2]) -> Guiding<T> {
    let side = |k: usize, outward: f64| {
        let [_, y, z] = forces[k];
        let (guiding_force, vertical_force) = (y * -outward, -z);
        let is_loaded = vertical_force.value() > 0.0;
        let quotient = if is_loaded { guiding_force / vertical_force } else { T::from(0.0) };
        SideForces { guiding_force, vertical_force, quotient }
    };
    let track_shifting_force = -(forces[RIGHT][1] + forces[LEFT][1]);
    Guiding { sides: [side(RIGHT, 1.0), side(LEFT, -1.0)], track_shifting_force }
}
