//! Given loads: the height and the roll of a wheelset at which each side carries its load.
//!
//! Each element finds the height of its wheel at any roll. The axle is rigid, which one roll angle
//! fits:
//!
//! ```text
//! z_right(roll) - z_left(roll) = 2 b sin roll cos yaw
//! ```
//!
//! It is found by bracketed secants, from 0 and never from the roll of the input. Where there is
//! none up to [`MAX_ROLL`], as of wheels beside their rails, the roll nearest to it counts, and a
//! fallback.

use super::{Input, LEFT, Output, RIGHT, TrackTurn, Wheelset};
use crate::element::Element;
use crate::error::ContactError;
use crate::math::root::outward;

/// Greatest roll that is looked at [rad].
const MAX_ROLL: f64 = 0.1;
/// First step from 0 [rad].
const FIRST_STEP: f64 = 1e-3;
/// Roll angles are found to this [rad]: the heights to 1e-15 m.
const RESOLUTION: f64 = 1e-15;
/// What may be missing at the roll found [m].
const MISSED: f64 = 1e-12;

impl Wheelset {
    /// The input with the height and roll found for its loads, and whether none was.
    ///
    /// # Errors
    /// The input at fault, by its name.
    pub(super) fn carry_loads(&mut self, input: &Input) -> Result<(Input, bool), ContactError> {
        let mut at = *input;
        // The given roll and height must not matter, not even in the last digit.
        at.wheelset.position[2] = -1.0;
        let (found, is_missed) = self.carry_loads_about(&at)?;
        if input.track == TrackTurn::default() {
            return Ok((found, is_missed));
        }
        // On a track that turns velocities go with the height, and friction with them bears some of
        // the load: the search is made again with the velocities of the height found.
        self.carry_loads_about(&found)
    }

    /// The same with velocities that belong to the height in `input`.
    fn carry_loads_about(&mut self, input: &Input) -> Result<(Input, bool), ContactError> {
        let mut trial = Output::default();
        let mut at = *input;
        at.wheelset.roll = 0.0;
        let counts = self.elements.each_ref().map(Element::fallbacks);
        let between = self.markers[RIGHT] - self.markers[LEFT];
        // Numbers that leave their range on the way to the markers are refused here, and by no roll
        // after it.
        self.sides(&at, &mut trial, Element::evaluate)?;
        let mut missing = |roll: f64| {
            at.wheelset.roll = roll;
            if self.sides(&at, &mut trial, Element::evaluate).is_err() {
                return 0.0;
            }
            trial.sides[RIGHT].wheel_z - trial.sides[LEFT].wheel_z - between * at.wheelset.axle().z
        };
        let level = missing(0.0);
        // What is missing falls with the roll.
        let first = FIRST_STEP.copysign(level);
        let (_, rest) = outward(level, first, MAX_ROLL, RESOLUTION, &mut missing);
        let heights =
            [RIGHT, LEFT].map(|k| trial.sides[k].wheel_z - self.markers[k] * at.wheelset.axle().z);
        at.wheelset.position[2] = 0.5 * (heights[RIGHT] + heights[LEFT]);
        // Only what the evaluation that follows falls back to counts.
        for (element, count) in self.elements.iter_mut().zip(counts) {
            element.set_fallbacks(count);
        }
        Ok((at, rest.abs() > MISSED))
    }
}
