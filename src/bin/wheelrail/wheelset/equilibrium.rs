//! The state from which a run starts: rolling freely in the middle of the track.

use anyhow::{Result, bail};

use super::body::State;
use super::{Moment, Wheel, Wheelset};

/// Steps after which the search gives up; six are usual.
const MAX_STEPS: usize = 60;
/// Unbalanced force at which the search ends, as a share of the load.
const ACCURACY: f64 = 1e-8;
/// Overlap of wheel and rail at which the search begins, more than usual loads give [m].
const FIRST_PENETRATION: f64 = 1e-4;
/// Difference of roll by which its stiffness is found, and its longest step [rad].
const ROLL: f64 = 1e-8;
const MAX_ROLL: f64 = 1e-4;

impl<W: Wheel> Wheelset<W> {
    /// Finds height and pitch rate at which the centred wheelset rolls without vertical
    /// acceleration and without driving moment, by Newton's method; the suspension then rests at
    /// that height.
    ///
    /// The centre is at the heights `right` and `left` where the right and the left wheel would
    /// just touch [m]: on rails that do not stand alike the axle rolls until nothing turns it.
    pub fn find_equilibrium(&mut self, [right, left]: [f64; 2]) -> Result<State> {
        let touching_z = 0.5 * (right + left);
        let weight = self.suspension.load + self.body.mass * super::GRAVITY;
        let radius = -touching_z;
        let mut state = State {
            z: touching_z + FIRST_PENETRATION,
            roll: 0.5 * (right - left) / self.body.half_marker_distance,
            pitch_rate: -self.speed / radius,
            ..State::default()
        };
        // Beyond a fraction of a percent the creep force is bounded by friction and its slope tells
        // nothing: steps are limited, and the limit shrinks when the root is overrun.
        let mut largest_turn = 0.005 * state.pitch_rate.abs();
        let mut last_moment = 0.0;
        for _ in 0..MAX_STEPS {
            let (force, [roll, moment]) = self.unbalanced(&state)?;
            let turned = roll.abs() >= ACCURACY * weight * radius;
            if force.abs() < ACCURACY * weight
                && moment.abs() < ACCURACY * weight * radius
                && !turned
            {
                self.suspension.resting_z = state.z;
                return Ok(state);
            }
            if moment * last_moment < 0.0 {
                largest_turn *= 0.7;
            }
            last_moment = moment;
            let (dz, turn) = (1e-8, 1e-7 * state.pitch_rate.abs());
            let (force_above, _) = self.unbalanced(&State { z: state.z - dz, ..state })?;
            let pitch_rate = state.pitch_rate + turn;
            let (_, [_, moment_beside]) = self.unbalanced(&State { pitch_rate, ..state })?;
            let stiffness = (force_above - force) / dz;
            if stiffness <= 0.0 {
                bail!(
                    "no equilibrium found: at z = {:.6} m the wheels do not carry (unbalanced force {force:.0} N)",
                    state.z
                );
            }
            if turned {
                let (_, [beside, _]) =
                    self.unbalanced(&State { roll: state.roll + ROLL, ..state })?;
                let stiffness = (roll - beside) / ROLL;
                if stiffness > 0.0 {
                    state.roll += (roll / stiffness).clamp(-MAX_ROLL, MAX_ROLL);
                }
            }
            state.z += (force / stiffness).clamp(-0.5 * FIRST_PENETRATION, FIRST_PENETRATION);
            let slope = (moment - moment_beside) / turn;
            if slope > 0.0 {
                state.pitch_rate += (moment / slope).clamp(-largest_turn, largest_turn);
            }
        }
        let (force, [_, moment]) = self.unbalanced(&state)?;
        bail!(
            "no equilibrium found in {MAX_STEPS} steps: {force:.3} N and {moment:.3} N m remain at z = {:.6} m",
            state.z
        )
    }

    /// Unbalanced vertical force [N], and moments of roll and about the axle [N m]; the springs
    /// carry just their load.
    fn unbalanced(&mut self, state: &State) -> Result<(f64, [f64; 2])> {
        self.suspension.resting_z = state.z;
        let force = self.force(state, Moment::Initialization)?;
        Ok((force.z, [force.roll, force.pitch]))
    }
}

#[cfg(test)]
mod tests {
    use super::super::conical_wheel::wheelset;

    #[test]
    fn load_and_rolling_are_balanced() {
        let mut wheelset = wheelset(15.0, 0.05);
        let state = wheelset.find_equilibrium([-0.46; 2]).unwrap();
        let force = wheelset.force(&state, super::Moment::Initialization).unwrap();
        assert!(force.z.abs() < 1e-3 && force.pitch.abs() < 1e-3, "{force:?}");
        assert!(state.pitch_rate < 0.0, "rolling forward has a negative pitch rate");
    }

    #[test]
    fn a_wheelset_that_nothing_carries_is_an_error() {
        let mut wheelset = wheelset(15.0, 0.05);
        for wheel in &mut wheelset.wheels {
            wheel.stiffness = 0.0;
        }
        let message = wheelset.find_equilibrium([-0.46; 2]).unwrap_err().to_string();
        assert!(message.starts_with("no equilibrium found: at z = "), "{message}");
    }
}
