//! Elastically supported rails without mass, quasi-static: where they rest on their springs under a
//! wheel.
//!
//! The deflection d is that at which the springs hold what the contacts put on the rails,
//!
//! ```text
//! K d = F(d),   K = diag(k_y, k_z)
//! ```
//!
//! Under a wheel of given height it is found with the stiffness of the patches, corrected step by
//! step by Broyden's method as long as steps tell that it does, and else by Newton's method with the
//! exact derivatives of F, each step shortened until the correction that follows it is the smaller
//! one (natural monotonicity test: Deuflhard, Newton Methods for Nonlinear Problems, section 3.3);
//! under a given load, which says how far the rails sink, the lateral deflection is found in the
//! [`balance`](super::balance) of the load or, where that does not lead to the first one on the way
//! out for sure, by bracketed secants.
//! Where a normal model jumps past the equilibrium the forces are those beside the jump, and a
//! fallback.

use super::balance::{Carried, Expected};
use super::derivative_memory::DIRECTIONS;
use super::derivatives::Height;
use super::input::{INPUTS, Input, PLACES, move_all};
use super::load_by_stiffness::{To, Way};
use super::output::{Output, heaviest};
use super::parameters::foundation::TrackState;
use super::parameters::{FoundationModel, VerticalMode};
use super::rail::moving_contact::Kink;
use super::rested::{Rested, without_height};
use super::wheel_on_rails::Element;
use crate::math::real::Real;
use crate::math::root::outward;
use crate::normal::Pose;

/// Steps of Newton's method after which the equilibrium counts as missed.
const MAX_STEPS: usize = 40;
/// A matrix serves for one more step, with Broyden's correction, where the correction that followed
/// a step was this share of it or less.
const KEPT: f64 = 0.3;
/// Shortest share of a step.
const SHORTEST: f64 = 1.0 / 1024.0;
/// Deflections are found to this [m]: 1e-9 of a small wheel load on a stiff contact.
const RESOLUTION: f64 = 1e-14;
/// Under a wheel of given height they are found to this share of the penetration if that is less,
/// half of 1e-9 of the force, or to the last digits of coordinates [m].
const RESOLVED: f64 = 3e-10;
const ROUNDING: f64 = 1e-15;
/// Correction left from which on the equilibrium counts as missed [m]: a thousandth of what wheel
/// and rail overlap.
const MISSED: f64 = 1e-7;
/// Under a given load, longest first way aside, and greatest one that is looked for [m].
const FIRST_WAY: f64 = 1e-3;
const MAX_WAY: f64 = 0.05;
/// Step aside after which the height that was found for the last deflection is a start [m].
const NEAR: f64 = 1e-5;
/// Greatest growth of the deflection that springs let rails have with that which they have, on the
/// way out from none, up to which there is one solution about [-].
const MOST_GROWTH: f64 = 0.5;

/// Trials of lateral deflections under a given load, each from the one before where that is near.
struct Trials<'a> {
    element: &'a mut Element,
    given: &'a Input,
    sunk: f64,
    last: f64,
    carried: Option<Carried>,
}

impl Trials<'_> {
    /// How much farther the springs would let rails go from `y` [m].
    fn left(&mut self, y: f64, input: &mut Input, output: &mut Output) -> f64 {
        let step = y - self.last;
        let carried = self.carried.filter(|_| step.abs() <= NEAR);
        self.element.expect(carried.map(|carried| Expected::About(carried, Pose::Near)));
        let ([left, _], _) = self.element.try_deflection(self.given, [y, self.sunk], input, output);
        (self.carried, self.last) = (self.element.carried, y);
        left
    }
}

impl Element {
    /// The same on rails that rest on their foundation.
    pub(super) fn rest(&mut self, input: &mut Input, output: &mut Output) -> (TrackState, u64) {
        let (deflection, left, fallbacks) = match self.vertical_mode {
            VerticalMode::Penetration => self.rest_under_height(input, output),
            VerticalMode::Load => self.rest_under_load(input, output),
        };
        let state = TrackState { deflection, ..TrackState::default() };
        (state, fallbacks + u64::from(left.abs() > MISSED))
    }

    /// Puts the rails of `input`, which are `given`, at a deflection; how much farther the springs
    /// would let them go under the forces there, and the fallbacks.
    fn try_deflection(
        &mut self,
        given: &Input,
        deflection: [f64; 2],
        input: &mut Input,
        output: &mut Output,
    ) -> ([f64; 2], u64) {
        *input = given.with_rails_moved(deflection, [0.0; 2]);
        let fallbacks = self.respond_to_rails(input, output);
        let [_, y, z] = output.wheel.force;
        let stiffness = self.foundation.stiffness;
        ([0, 1].map(|i| [-y, -z][i] / stiffness[i] - deflection[i]), fallbacks)
    }

    /// Deflection under a wheel of given height, what is left of the way to it [m], and the
    /// fallbacks.
    fn rest_under_height(
        &mut self,
        input: &mut Input,
        output: &mut Output,
    ) -> ([f64; 2], f64, u64) {
        let given = *input;
        if let Some(Rested { under, deflection, left, .. }) = self.rested
            && under == given
        {
            let (_, fallbacks) = self.try_deflection(&given, deflection, input, output);
            return (deflection, left, fallbacks);
        }
        let mut deflection = [0.0; 2];
        let (mut rest, mut fallbacks) = self.try_deflection(&given, deflection, input, output);
        if let Some(share) = self.share_left(rest) {
            deflection = rest.map(|rest| rest * share);
            (rest, fallbacks) = self.try_deflection(&given, deflection, input, output);
        }
        let penetrations = self.models.patches.iter().map(|patch| patch.penetration);
        let share = RESOLVED * penetrations.fold(0.0, f64::max);
        let resolution = share.clamp(ROUNDING, RESOLUTION);
        // Under a lifted wheel they rest at once.
        let mut left = length(rest);
        let (mut steps, mut kept) = (0, Some(self.yielding()));
        while left > resolution && steps < MAX_STEPS {
            steps += 1;
            let matrix = kept
                .unwrap_or_else(|| self.compliance(&given.with_rails_moved(deflection, [0.0; 2])));
            let step = solve(matrix, rest).unwrap_or(rest);
            left = length(step);
            let mut share = 1.0;
            let accepted = loop {
                let trial = [0, 1].map(|i| deflection[i] + share * step[i]);
                let found = self.try_deflection(&given, trial, input, output);
                let next = solve(matrix, found.0).map_or(f64::INFINITY, length);
                let most = if kept.is_some() { KEPT } else { 1.0 - 0.25 * share };
                if next <= most * left || next <= resolution {
                    break Some((trial, found, next));
                }
                share *= 0.5;
                if kept.is_some() || share < SHORTEST || share * left < resolution {
                    break None;
                }
            };
            let Some((trial, found, next)) = accepted else {
                if kept.take().is_some() {
                    continue;
                }
                // The forces are to be those of the deflection.
                (_, fallbacks) = self.try_deflection(&given, deflection, input, output);
                break;
            };
            kept = (next <= KEPT * left).then(|| corrected(matrix, found.0, step));
            (deflection, (rest, fallbacks), left) = (trial, found, next);
        }
        self.rested = Some(Rested { under: given, deflection, left, carried: None });
        (deflection, left, fallbacks)
    }

    /// The same under a given load, which alone says how far the rails sink: what is left is one
    /// equation for the lateral deflection, which on a flange has more than one solution. That on
    /// the way out from none is taken.
    fn rest_under_load(&mut self, input: &mut Input, output: &mut Output) -> ([f64; 2], f64, u64) {
        let given = *input;
        let under = without_height(&given);
        let rested = self.rested.filter(|rested| rested.under == under).unwrap_or_else(|| {
            let carried = self.aside_by_stiffness(&given, input, output);
            let (y, left) = match carried {
                Some(carried) => (carried.aside, 0.0),
                None => self.aside_from_none(&given, input, output),
            };
            let deflection = [y, self.sunk_under_load(&given)];
            Rested { under, deflection, left, carried }
        });
        let Rested { deflection, left, carried, .. } = rested;
        // The forces are those of rails that are put there, whatever led to it, also long ago.
        let known = carried.map(|carried| Expected::About(carried, Pose::New));
        self.expected = self.expected.or(known);
        let (_, fallbacks) = self.try_deflection(&given, deflection, input, output);
        self.rested = Some(rested);
        (deflection, left, fallbacks)
    }

    /// How a given load is carried on rails that rest aside, by the stiffness of the contacts; nothing
    /// where that does not lead to it, or not to the first deflection on the way out for sure.
    fn aside_by_stiffness(
        &mut self,
        given: &Input,
        input: &mut Input,
        output: &mut Output,
    ) -> Option<Carried> {
        let held = self.held_under_load(given).filter(|_| given.wheel_load > 0.0)?;
        let (about, at_once) = self.guess_held(&held, given, output)?;
        let way = Way { about, pose: Pose::New, to: To::OneBefore };
        let found = self.balanced(held, way, given, input, output)?;
        let growth = 1.0 - at_once / found.carried.aside;
        let is_sure = growth.abs() < MOST_GROWTH && found.left_out == 0;
        is_sure.then_some(found.carried)
    }

    /// Under a load, rails are known to rest aside as it is `carried` on them.
    pub(crate) fn known_to_rest(&mut self, input: &Input, carried: &Carried) {
        let given = self.side.mirror(*input);
        if self.foundation.model == FoundationModel::Massless {
            let deflection = [carried.aside, self.sunk_under_load(&given)];
            let (under, carried) = (without_height(&given), Some(*carried));
            self.rested = Some(Rested { under, deflection, left: 0.0, carried });
        }
    }

    /// How far rails sink under a given load [m].
    fn sunk_under_load(&self, given: &Input) -> f64 {
        given.wheel_load.max(0.0) / self.foundation.stiffness[1]
    }

    /// The lateral deflection that is met first on the way out from none.
    fn aside_from_none(
        &mut self,
        given: &Input,
        input: &mut Input,
        output: &mut Output,
    ) -> (f64, f64) {
        let sunk = self.sunk_under_load(given);
        let mut trials = Trials { element: self, given, sunk, last: 0.0, carried: None };
        let level = trials.left(0.0, input, output);
        let first = level.clamp(-FIRST_WAY, FIRST_WAY);
        outward(level, first, MAX_WAY, RESOLUTION, |y| trials.left(y, input, output))
    }

    /// About what share of the forces of the last evaluation is left on rails that give way to them,
    /// by the heaviest of its patches, where the springs would let them go by `rest` [m].
    fn share_left(&self, rest: [f64; 2]) -> Option<f64> {
        let patch = heaviest(&self.models.patches)?;
        let (sine, cosine) = patch.contact_angle.sin_cos();
        let away = (rest[1] * cosine - rest[0] * sine) / patch.penetration;
        if away.is_nan() || away <= 0.0 {
            return None;
        }
        // With the share x of the penetration: 1 - x = away x^(3/2). Newton's method from above, on
        // a convex curve.
        let mut x = 1.0_f64.min(away.powf(-2.0 / 3.0));
        for _ in 0..4 {
            let root = x.sqrt();
            x -= (away * x * root - (1.0 - x)) / (1.5 * away * root + 1.0);
        }
        Some(x * x.sqrt())
    }

    /// The matrix 1 - K⁻¹ ∂F/∂d for rails in the place that `at` has.
    fn compliance(&mut self, at: &Input) -> [[f64; 2]; 2] {
        let slopes = self.rail_slopes(at);
        let stiffness = self.foundation.stiffness;
        [0, 1].map(|i| [0, 1].map(|j| f64::from(u8::from(i == j)) - slopes[i][j] / stiffness[i]))
    }

    /// About the same for rails under the patches of the last evaluation: the force of each goes with
    /// the power 3/2 of its penetration, which is along its normal.
    fn yielding(&self) -> [[f64; 2]; 2] {
        let stiffness = self.foundation.stiffness;
        let mut matrix = [[1.0, 0.0], [0.0, 1.0]];
        for patch in self.models.patches.iter() {
            let own = 1.5 * patch.normal_force / patch.penetration;
            let (sine, cosine) = patch.contact_angle.sin_cos();
            let normal = [-sine, cosine];
            let share = patch.creep_force[1] / patch.normal_force;
            let force = [normal[0] - share * cosine, normal[1] - share * sine];
            for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                matrix[i][j] += own / stiffness[i] * force[i] * normal[j];
            }
        }
        matrix
    }

    /// Derivatives of the lateral and vertical force on the rails (rows) by their place, exact
    /// where there are such.
    fn rail_slopes(&mut self, at: &Input) -> [[f64; 2]; 2] {
        let is_loaded = self.vertical_mode == VerticalMode::Load;
        // A wheel under a given load follows the height of its rails.
        let ways = if is_loaded { 1 } else { 2 };
        let height = if is_loaded { Height::Loaded } else { Height::Given };
        let directions = PLACES.map(|place| {
            let mut direction = [0.0; INPUTS];
            move_all(&mut direction, place, 1.0);
            direction
        });
        let mut slopes = [[0.0; 2]; 2];
        let exact = self.rail_rates(&(*at, height), &directions[..ways], |j, force| {
            for i in 0..2 {
                slopes[i][j] = force[i];
            }
        });
        if exact.is_err() {
            self.rail_differences(at, &mut slopes, ways);
        }
        slopes
    }

    /// The same by central differences, for models without derivatives.
    fn rail_differences(&mut self, at: &Input, slopes: &mut [[f64; 2]; 2], ways: usize) {
        /// Half of the way [m].
        const STEP: f64 = 1e-8;
        let mut output = Output::default();
        for j in 0..ways {
            let mut force = |way: f64| {
                let mut deflection = [0.0; 2];
                deflection[j] = way;
                let mut beside = at.with_rails_moved(deflection, [0.0; 2]);
                self.respond_to_rails(&mut beside, &mut output);
                output.wheel.force
            };
            let ([_, y, z], [_, next_y, next_z]) = (force(-STEP), force(STEP));
            (slopes[0][j], slopes[1][j]) =
                ((y - next_y) / (2.0 * STEP), (z - next_z) / (2.0 * STEP));
        }
    }

    /// Ways of the rails in each of the `directions` that the inputs take at `at`, which are put
    /// into these.
    ///
    /// # Errors
    /// What has no derivative there.
    pub(super) fn give_way(
        &mut self,
        at: &(Input, Height),
        directions: &mut [[f64; INPUTS]],
    ) -> Result<[[f64; 2]; DIRECTIONS], Kink> {
        let mut ways = [[0.0; 2]; DIRECTIONS];
        if self.rails_at().is_some() {
            return Ok(ways);
        }
        let stiffness = self.foundation.stiffness;
        self.rail_rates(at, directions, |n, force| {
            ways[n] = [0, 1].map(|i| force[i] / stiffness[i]);
        })?;
        let matrix = self.compliance(&at.0);
        for (direction, way) in directions.iter_mut().zip(&mut ways) {
            *way = solve(matrix, *way).ok_or("the rails find no hold")?;
            for (place, way) in PLACES.into_iter().zip(*way) {
                move_all(direction, place, way);
            }
        }
        Ok(ways)
    }
}

/// The `matrix` with which a whole `step` left the residual `rest`, so that it would have told it
/// (Broyden 1965).
fn corrected(matrix: [[f64; 2]; 2], rest: [f64; 2], step: [f64; 2]) -> [[f64; 2]; 2] {
    let square = step[0] * step[0] + step[1] * step[1];
    [0, 1].map(|i| [0, 1].map(|j| matrix[i][j] - rest[i] * step[j] / square))
}

fn length([y, z]: [f64; 2]) -> f64 {
    y.hypotenuse(z)
}

/// Solution of two equations, if there is one.
pub(super) fn solve([[a, b], [c, d]]: [[f64; 2]; 2], [y, z]: [f64; 2]) -> Option<[f64; 2]> {
    let determinant = a * d - b * c;
    let found = [(d * y - b * z) / determinant, (a * z - c * y) / determinant];
    found.iter().all(|x| x.is_finite()).then_some(found)
}
