//! Given loads: the height and the roll of a wheelset at which each side carries its load.
//!
//! Each element finds the height of its wheel at any roll. The axle is rigid, which one roll angle
//! fits:
//!
//! ```text
//! z_right(roll) - z_left(roll) = 2 b sin roll cos yaw
//! ```
//!
//! It is found from 0 on and never from the roll of the input, by the stiffness of the contacts or,
//! where that does not lead to it, by bracketed secants. Where there is none up to [`MAX_ROLL`], as
//! of wheels beside their rails, the roll nearest to it counts, and a fallback.

use super::both_wheels::BothWheels;
use super::{Input, LEFT, Output, RIGHT, SIDES, TrackTurn, Wheelset, on_side};
use crate::element::{Carried, Element, Expected, LONGEST, MOST_POSES, PosedWheel};
use crate::error::ContactError;
use crate::math::root::outward;
use crate::normal::Pose;

/// Greatest roll that is looked at [rad].
const MAX_ROLL: f64 = 0.1;
/// First step from 0 [rad].
const FIRST_STEP: f64 = 1e-3;
/// Roll angles are found to this [rad]: the heights to 1e-15 m.
const RESOLUTION: f64 = 1e-15;
/// What the step beyond the last pose may leave of the balances, over loads and their depths: 3e-15 m
/// of the heights, by which the roll fits both. A side whose forces are not known then finds its own.
const LEFT_NEXT: f64 = 3e-11;
/// What may be missing at the roll found [m].
const MISSED: f64 = 1e-12;

impl Wheelset {
    /// The input with the height and roll found for its loads, and whether none was; sides that are
    /// known to carry theirs with the forces of the last pose have these in `trial`.
    ///
    /// # Errors
    /// The input at fault, by its name.
    pub(super) fn carry_loads(
        &mut self,
        input: &Input,
        trial: &mut Output,
    ) -> Result<(Input, bool), ContactError> {
        let mut at = *input;
        // The given roll and height must not matter, not even in the last digit.
        at.wheelset.position[2] = -1.0;
        let (found, is_missed) = self.carry_loads_about(&at, trial)?;
        if input.track == TrackTurn::default() {
            return Ok((found, is_missed));
        }
        // On a track that turns velocities go with the height, and friction with them bears some of
        // the load: the search is made again with the velocities of the height found.
        self.carry_loads_about(&found, trial)
    }

    /// The same with velocities that belong to the height in `input`.
    fn carry_loads_about(
        &mut self,
        input: &Input,
        trial: &mut Output,
    ) -> Result<(Input, bool), ContactError> {
        let mut at = *input;
        at.wheelset.roll = 0.0;
        let counts = self.elements.each_ref().map(Element::fallbacks);
        let between = self.markers[RIGHT] - self.markers[LEFT];
        if let Some(found) = self.roll_by_stiffness(input, trial)? {
            return Ok((found, false));
        }
        // Numbers that leave their range on the way to the markers are refused here, and by no roll
        // after it.
        self.sides(&at, trial, Element::evaluate)?;
        let mut missing = |roll: f64| {
            at.wheelset.roll = roll;
            if self.sides(&at, trial, Element::evaluate).is_err() {
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

    /// The same by the stiffness of both contacts, a pose of both wheels at a time: height and roll
    /// are unknowns of one balance of both. Nothing where that does not lead to where both are
    /// carried.
    ///
    /// # Errors
    /// The input at fault, by its name.
    fn roll_by_stiffness(
        &mut self,
        input: &Input,
        trial: &mut Output,
    ) -> Result<Option<Input>, ContactError> {
        let mut at = *input;
        at.wheelset.roll = 0.0;
        // What was expected by a search before this one is of another roll.
        self.elements.iter_mut().for_each(|element| element.expect(None));
        let Some(mut about) = self.guess_loads(&mut at, trial)? else { return Ok(None) };
        let (mut both, mut pose) = (None::<BothWheels>, Pose::New);
        for _ in 0..MOST_POSES {
            let Some(posed) = self.pose_both(&at, &mut about, pose, trial)? else {
                return Ok(None);
            };
            if let Some(both) = &mut both {
                both.take(&at, &posed);
            }
            let both = both.get_or_insert_with(|| BothWheels::at(&at, self.markers, &posed));
            let Some(step) = both.next(&mut at, &mut about) else { return Ok(None) };
            if at.wheelset.roll.abs() >= MAX_ROLL || (pose == Pose::Near && step > LONGEST) {
                return Ok(None);
            }
            if both.left_next() <= LEFT_NEXT {
                for k in [RIGHT, LEFT] {
                    let side = at.of_side(k, self.markers[k]);
                    about[k].z = side.wheel.position[2];
                    let element = &mut self.elements[k];
                    element.known_to_rest(&side, &about[k]);
                    let further = both.further(k);
                    let is_found =
                        further.is_some_and(|part| element.go_on(part, &mut trial.sides[k]));
                    element.expect(Some(if is_found {
                        Expected::Found(about[k])
                    } else {
                        Expected::About(about[k], Pose::Near)
                    }));
                }
                return Ok(Some(at));
            }
            pose = Pose::Near;
        }
        Ok(None)
    }

    /// A pose of both wheels where the wheelset of `at` has them, with what is known `about` how
    /// each is carried.
    ///
    /// # Errors
    /// The input at fault, by its name.
    fn pose_both(
        &mut self,
        at: &Input,
        about: &mut [Carried; 2],
        pose: Pose,
        trial: &mut Output,
    ) -> Result<Option<[PosedWheel; 2]>, ContactError> {
        let mut posed = [None; 2];
        for k in [RIGHT, LEFT] {
            let side = at.of_side(k, self.markers[k]);
            side.check().map_err(|e| on_side(e, SIDES[k]))?;
            about[k].z = side.wheel.position[2];
            let output = &mut trial.sides[k];
            posed[k] = self.elements[k].pose_under_load(&side, &about[k], pose, output);
        }
        let [Some(right), Some(left)] = posed else { return Ok(None) };
        Ok(Some([right, left]))
    }

    /// Puts the wheelset of `at` where each side by itself carries its load about, the axle between
    /// them, from no roll on, and says how that is.
    ///
    /// # Errors
    /// The input at fault, by its name.
    fn guess_loads(
        &mut self,
        at: &mut Input,
        trial: &mut Output,
    ) -> Result<Option<[Carried; 2]>, ContactError> {
        let mut guessed = [None; 2];
        let (mut heights, mut slopes) = ([0.0; 2], [0.0; 2]);
        for k in [RIGHT, LEFT] {
            let side = at.of_side(k, self.markers[k]);
            side.check().map_err(|e| on_side(e, SIDES[k]))?;
            let output = &mut trial.sides[k];
            let Some((found, down_with_roll)) = self.elements[k].guess_load(&side, output) else {
                return Ok(None);
            };
            (guessed[k], slopes[k]) = (Some(found), down_with_roll);
            // In the frame of the rails, and in that of the track.
            let z = found.z;
            let of_track = at.wheelset.along_axle(self.markers[k]).position[2];
            let frame = at.rail_frame(k, self.markers[k]);
            heights[k] =
                frame.map_or(z, |frame| frame.height(of_track, [side.wheel.position[2], z]));
        }
        let [Some(right), Some(left)] = guessed else { return Ok(None) };
        let between = self.markers[RIGHT] - self.markers[LEFT];
        let missing = heights[RIGHT] - heights[LEFT] - between * at.wheelset.axle().z;
        at.wheelset.roll = missing / (between - slopes[RIGHT] + slopes[LEFT]);
        let axle = at.wheelset.axle().z;
        let middles = [RIGHT, LEFT]
            .map(|k| heights[k] + slopes[k] * at.wheelset.roll - self.markers[k] * axle);
        at.wheelset.position[2] = 0.5 * (middles[RIGHT] + middles[LEFT]);
        Ok((at.wheelset.roll.abs() < MAX_ROLL).then_some([right, left]))
    }
}
