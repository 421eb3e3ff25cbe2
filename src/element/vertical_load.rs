//! Given load: the height of the wheel at which the rails carry it.
//!
//! The load is the vertical force on all rails together, z in the track frame, of everything that acts: normal forces and what creep
//! forces on inclined contacts add to them or take away. The force on the wheel is then the load, reversed, whatever the contact
//! angle. There is no normal damping: a given load is that of a wheel at rest on its rails. What is defined beyond the ordinary:
//!
//! | situation | height | force | fallback |
//! |---|---|---|---|
//! | load of 0 or below: a lifted wheel | first touch, as for ever smaller loads | none | no |
//! | wheel beside all rails | that of the input | none | if there is a load |
//! | more load than the rails carry down to 40 mm below the first touch | that of the greatest force met | that force | yes |
//! | the force jumps past the load, as Piotrowski-Kik's does where contacts merge | the jump's | that on the carrying side | yes |
//!
//! Going down from where nothing touches in steps that double up to 2 mm, the first height that carries the load ends the bracket; the root in it is
//! found by guesses from force ~ penetration^(3/2) and then by bracketed secants in force^(2/3), which is nearly straight. Both are
//! counted: no input makes them fail or go on for ever.

use super::evaluate::Element;
use super::input::Input;
use super::output::Output;
use crate::math::root::bracketed;

/// Bounds of the first step down from where nothing touches [m].
const FIRST_STEP: [f64; 2] = [1e-5, 5e-4];
/// Longest step: no wheel passes through a rail in it [m].
const LONGEST_STEP: f64 = 2e-3;
/// Load over penetration^(3/2) of a wheel on a rail, for the first step [N/m^1.5].
const STIFFNESS: f64 = 7e10;
/// Steps down, 40 mm, after which no more load is looked for, and steps up where the bounds were wrong.
const MOST_STEPS: usize = 27;
/// Guesses from the power law before the bracketed search.
const GUESSES: usize = 4;
/// Difference from the load, as a share of it, that ends the search.
const ACCURACY: f64 = 1e-11;
/// Difference that counts as a fallback: share of the load and force [N].
const MISSED: [f64; 2] = [1e-6, 1e-3];

/// One height and the vertical force that the rails carry there.
#[derive(Clone, Copy, Debug)]
struct Trial {
    z: f64,
    force: f64,
}

impl Element {
    /// Puts the wheel of `input` (right side) at the height at which the rails carry its load and leaves the forces there; returns
    /// how many fallbacks that took.
    pub(super) fn carry_load(&mut self, input: &mut Input, output: &mut Output) -> u64 {
        let load = input.wheel_load;
        let own_height = input.wheel.position[2];
        // The given height must not matter, not even in the last digit.
        input.wheel.position[2] = -self.nominal_radius;
        let clear = self.height_near_touch(input);
        if load <= 0.0 || !clear.is_finite() {
            let touching = if clear.is_finite() { self.first_touch(input) } else { None };
            input.wheel.position[2] = touching.unwrap_or(own_height);
            self.models.patches.clear();
            *output = Output::default();
            return u64::from(load > 0.0);
        }
        let mut left_out = 0;
        let mut try_height = |element: &mut Self, input: &mut Input, z: f64| {
            input.wheel.position[2] = z;
            left_out = element.forces(input, output);
            Trial { z, force: -output.wheel.force[2] }
        };
        // Down to the first height that carries the load.
        let mut step = (load / STIFFNESS).powf(2.0 / 3.0).clamp(FIRST_STEP[0], FIRST_STEP[1]);
        let mut above = try_height(self, input, clear);
        for _ in 0..MOST_STEPS {
            // The bounds are meant to be clear; a rail that rolls far may make them wrong.
            if above.force < load {
                break;
            }
            above = try_height(self, input, above.z - step);
            step = (2.0 * step).min(LONGEST_STEP);
        }
        let mut best = above;
        let mut below = None;
        for _ in 0..MOST_STEPS {
            let trial = try_height(self, input, above.z + step);
            if trial.force > best.force {
                best = trial;
            }
            if trial.force >= load {
                below = Some(trial)
            } else {
                above = trial
            }
            step = (2.0 * step).min(LONGEST_STEP);
        }
        let mut found = below.unwrap_or(best);
        if below.is_some() && above.force < load {
            let is_met = |trial: Trial| (trial.force - load).abs() <= ACCURACY * load;
            let mut trial = found;
            for _ in 0..GUESSES {
                let Some(z) = self.power_law_height(load, trial) else { break };
                if !(z > above.z && z < found.z) || is_met(found) {
                    break;
                }
                trial = try_height(self, input, z);
                if trial.force >= load {
                    found = trial
                } else {
                    above = trial
                }
                if is_met(trial) {
                    found = trial;
                    break;
                }
            }
            if !is_met(found) {
                let straight = |force: f64| {
                    let share = force / load;
                    share.signum() * share.abs().powf(2.0 / 3.0) - 1.0
                };
                let ends = [above, found].map(|end| (end.z, straight(end.force)));
                bracketed(ends[0], ends[1], f64::EPSILON * self.nominal_radius, |z| {
                    let trial = try_height(self, input, z);
                    if trial.force >= load && trial.z < found.z {
                        found = trial;
                    }
                    if is_met(trial) {
                        found = trial;
                        return 0.0;
                    }
                    straight(trial.force)
                });
            }
        }
        if found.force <= 0.0 {
            // Beside the rails after all.
            input.wheel.position[2] = own_height;
            self.models.patches.clear();
            *output = Output::default();
            return 1;
        }
        if input.wheel.position[2].to_bits() != found.z.to_bits() {
            found = try_height(self, input, found.z);
        }
        let is_missed = (found.force - load).abs() > MISSED[0] * load + MISSED[1];
        left_out + u64::from(is_missed)
    }

    /// The height at which the contact of the heaviest patch would carry all of `load` if force grew as penetration^(3/2), after an
    /// evaluation at `trial`.
    fn power_law_height(&self, load: f64, trial: Trial) -> Option<f64> {
        let patches = self.models.patches.iter();
        let patch = patches.max_by(|a, b| a.normal_force.total_cmp(&b.normal_force))?;
        let cosine = patch.contact_angle.cos();
        let growth = (load / trial.force).powf(2.0 / 3.0) - 1.0;
        let z = trial.z + patch.penetration / cosine * growth;
        (trial.force > 0.0 && cosine > 0.1).then_some(z)
    }

    /// A height of the marker a little above first touch with any rail; infinite beside all of them [m].
    fn height_near_touch(&self, input: &Input) -> f64 {
        (self.rails.iter().enumerate())
            .filter_map(|(k, rail)| Some(rail.as_ref()?.height_near_touch(k, input)))
            .fold(f64::INFINITY, f64::min)
    }
}
