//! Given load: the height of the wheel at which the rails carry it.
//!
//! The load is the vertical force on all rails together, z in the track frame, of everything that
//! acts: normal forces and what creep forces on inclined contacts add to them or take away. The
//! force on the wheel is then the load, reversed, whatever the contact angle. There is no normal
//! damping: a given load is that of a wheel at rest on its rails. What is defined beyond the
//! ordinary:
//!
//! | situation | height | force | fallback |
//! |---|---|---|---|
//! | load of 0 or below: a lifted wheel | first touch, as for ever smaller loads | none | no |
//! | wheel beside all rails | that of the input | none | if there is a load |
//! | more load than the rails carry down to 40 mm below the first touch | that of the greatest force met | that force | yes |
//! | the force jumps past the load to at most twice of it, as Piotrowski-Kik's does where contacts merge | the jump's | that on the carrying side | yes |
//! | the force jumps further, as where the wheel comes down inside the side of a rail | the jump's | that on the other side | yes |
//!
//! The stiffness of the contacts tells how far down the wheel has to go, and few poses are enough
//! (`load_by_stiffness`). Where that does not lead to the load, it is searched for: going down from where
//! nothing touches in steps that double up to 2 mm, the first height that carries the load ends the
//! bracket; the root in it is found by guesses from force ~ penetration^(3/2) and then by bracketed
//! secants in force^(2/3), which is nearly straight. All are counted: no input makes them fail or
//! go on for ever.

use super::balance::Expected;
use super::input::Input;
use super::output::{Output, heaviest};
use super::wheel_on_rails::Element;
use crate::math::root::bracketed;

/// Bounds of the first step down from where nothing touches [m].
pub(super) const FIRST_STEP: [f64; 2] = [1e-5, 5e-4];
/// Longest step: no wheel passes through a rail in it [m].
pub(super) const LONGEST_STEP: f64 = 2e-3;
/// Load over penetration^(3/2) of a wheel on a rail, for the first step [N/m^1.5].
pub(super) const STIFFNESS: f64 = 7e10;
/// Steps down, 40 mm, after which no more load is looked for, and steps up where the bounds were
/// wrong.
pub(super) const MAX_STEPS: usize = 27;
/// Guesses from the power law before the bracketed search.
const GUESSES: usize = 4;
/// Difference from the load, as a share of it, that ends the search.
const ACCURACY: f64 = 1e-11;
/// Difference from the load from which on it counts as not carried: share of the load and force
/// [N].
const MISSED: [f64; 2] = [1e-6, 1e-3];
/// Greatest force at a jump, over the load: those of models are less than half of the force, beyond
/// it the geometry jumps.
const MAX_FORCE: f64 = 2.0;

/// Whether rails that carry `carried` carry the `load` of a wheel [N]; a lifted wheel has none.
pub(crate) fn is_carried(load: f64, carried: f64) -> bool {
    (carried - load.max(0.0)).abs() <= MISSED[0] * load.max(0.0) + MISSED[1]
}

/// One height and the vertical force that the rails carry there.
#[derive(Clone, Copy, Debug)]
struct Trial {
    z: f64,
    force: f64,
}

/// The search for the height; `input` and `output` are those of the last trial.
struct Search<'a> {
    element: &'a mut Element,
    input: &'a mut Input,
    output: &'a mut Output,
    load: f64,
    /// Contacts and zones that found no room at the last trial.
    left_out: u64,
}

impl Element {
    /// Puts the wheel of `input` (right side) at the height at which the rails carry its load and
    /// leaves the forces there; returns how many fallbacks that took.
    pub(super) fn carry_load(&mut self, input: &mut Input, output: &mut Output) -> u64 {
        let load = input.wheel_load;
        let own_height = input.wheel.position[2];
        let expected = self.expected.take();
        self.carried = None;
        if let Some(Expected::Found(carried)) = expected {
            input.wheel.position[2] = carried.z;
            self.carried = Some(carried);
            return 0;
        }
        // The given height must not matter, not even in the last digit.
        input.wheel.position[2] = -self.nominal_radius;
        let clear = self.height_near_touch(input);
        if load > 0.0 && clear.is_finite() {
            if let Some(fallbacks) = self.load_by_stiffness(clear, expected, input, output) {
                return fallbacks;
            }
            let mut search = Search { element: self, input, output, load, left_out: 0 };
            if let Some(fallbacks) = search.run(clear) {
                return fallbacks;
            }
        }
        let touching = if load <= 0.0 { self.first_touch(input) } else { None };
        input.wheel.position[2] = touching.unwrap_or(own_height);
        self.models.patches.clear();
        if let Some(memory) = &mut self.models.memory {
            memory.begin();
        }
        *output = Output::default();
        u64::from(load > 0.0)
    }

    /// A height of the marker a little above first touch with any rail; infinite beside all of them
    /// [m].
    pub(super) fn height_near_touch(&self, input: &Input) -> f64 {
        (self.rails.iter().enumerate())
            .filter_map(|(k, rail)| Some(rail.as_ref()?.height_near_touch(k, input)))
            .fold(f64::INFINITY, f64::min)
    }
}

impl Search<'_> {
    /// Searches from the height `clear`; returns the number of fallbacks, or nothing where no rail
    /// carries anything.
    fn run(&mut self, clear: f64) -> Option<u64> {
        let mut ends = self.bracket(clear);
        if ends[0].force < self.load && ends[1].force >= self.load {
            ends = self.refine(ends);
        }
        let most = MAX_FORCE * self.load + MISSED[1];
        if ends.iter().all(|end| end.force <= 0.0) {
            return None;
        }
        let found = ends.into_iter().rev().find(|end| end.force <= most)?;
        if self.input.wheel.position[2].to_bits() != found.z.to_bits() {
            self.at(found.z);
        }
        Some(self.left_out + u64::from(!is_carried(self.load, found.force)))
    }

    fn at(&mut self, z: f64) -> Trial {
        self.input.wheel.position[2] = z;
        self.left_out = self.element.forces(self.input, self.output);
        Trial { z, force: -self.output.wheel.force[2] }
    }

    fn is_met(&self, trial: Trial) -> bool {
        (trial.force - self.load).abs() <= ACCURACY * self.load
    }

    /// The last height on the way down that does not carry the load, and the first one that does;
    /// where none does, that of the greatest force.
    fn bracket(&mut self, clear: f64) -> [Trial; 2] {
        let mut step = (self.load / STIFFNESS).powf(2.0 / 3.0).clamp(FIRST_STEP[0], FIRST_STEP[1]);
        let mut above = self.at(clear);
        for _ in 0..MAX_STEPS {
            // The bounds are meant to be clear; a rail that rolls far may make them wrong.
            if above.force < self.load {
                break;
            }
            above = self.at(above.z - step);
            step = (2.0 * step).min(LONGEST_STEP);
        }
        let mut best = above;
        for _ in 0..MAX_STEPS {
            let trial = self.at(above.z + step);
            if trial.force >= self.load {
                return [above, trial];
            }
            if trial.force > best.force {
                best = trial;
            }
            above = trial;
            step = (2.0 * step).min(LONGEST_STEP);
        }
        [above, best]
    }

    /// The heights next to that of the load between one that does not carry it and one that does;
    /// the second one carries it.
    fn refine(&mut self, [mut above, mut below]: [Trial; 2]) -> [Trial; 2] {
        if self.is_met(below) {
            return [above, below];
        }
        let mut last = below;
        for _ in 0..GUESSES {
            let guess = self.power_law_height(last).filter(|&z| z > above.z && z < below.z);
            let Some(z) = guess else { break };
            last = self.at(z);
            if self.is_met(last) {
                return [above, last];
            }
            if last.force >= self.load { below = last } else { above = last }
        }
        let load = self.load;
        let straight = |force: f64| {
            let share = force / load;
            share.signum() * share.abs().powf(2.0 / 3.0) - 1.0
        };
        let [first, second] = [above, below].map(|end| (end.z, straight(end.force)));
        let resolution = f64::EPSILON * self.element.nominal_radius;
        bracketed(first, second, resolution, |z| {
            let trial = self.at(z);
            let is_met = self.is_met(trial);
            if is_met || (trial.force >= load && trial.z < below.z) {
                below = trial;
            } else if trial.force < load && trial.z > above.z {
                above = trial;
            }
            if is_met { 0.0 } else { straight(trial.force) }
        });
        [above, below]
    }

    /// The height at which the contact of the heaviest patch would carry the whole load if force
    /// grew as penetration^(3/2), after an evaluation at `trial`.
    fn power_law_height(&self, trial: Trial) -> Option<f64> {
        let patch = heaviest(&self.element.models.patches)?;
        let cosine = patch.contact_angle.cos();
        let growth = (self.load / trial.force).powf(2.0 / 3.0) - 1.0;
        let z = trial.z + patch.penetration / cosine * growth;
        (trial.force > 0.0 && cosine > 0.1).then_some(z)
    }
}
