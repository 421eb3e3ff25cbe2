//! Elastically supported rails without mass, quasi-static: where they rest on their springs under a
//! wheel.
//!
//! The deflection d is that at which the springs hold what the contacts put on the rails,
//!
//! ```text
//! K d = F(d),   K = diag(k_y, k_z)
//! ```
//!
//! Under a wheel of given height it is found by Newton's method with the exact derivatives of F,
//! each step shortened until the correction that follows it is the smaller one (natural
//! monotonicity test: Deuflhard, Newton Methods for Nonlinear Problems, section 3.3); where it is
//! much smaller Broyden's correction of the derivatives serves for the next step; under a given
//! load, which says how far the rails sink, by secants for the lateral deflection alone, bracketed or
//! beside where it is expected.
//! Where a normal model jumps past the equilibrium the forces are those beside the jump, and a
//! fallback.

use super::derivative_memory::DIRECTIONS;
use super::derivatives::Height;
use super::input::{INPUTS, Input, PLACES, move_all};
use super::load_by_stiffness::Carried;
use super::output::Output;
use super::parameters::VerticalMode;
use super::parameters::foundation::TrackState;
use super::rail::moving_contact::Kink;
use super::wheel_on_rails::Element;
use crate::math::real::Real;
use crate::math::root::outward;

/// Steps of Newton's method after which the equilibrium counts as missed.
const MAX_STEPS: usize = 40;
/// A matrix serves for one more step, with Broyden's correction, where the correction that followed
/// a step was this share of it or less.
const KEPT: f64 = 0.1;
/// Shortest share of a step.
const SHORTEST: f64 = 1.0 / 1024.0;
/// Deflections are found to this [m]: 1e-9 of a small wheel load on a stiff contact.
const RESOLUTION: f64 = 1e-14;
/// Correction left from which on the equilibrium counts as missed [m]: a thousandth of what wheel
/// and rail overlap.
const MISSED: f64 = 1e-7;
/// Under a given load, longest first way aside, and greatest one that is looked for [m].
const FIRST_WAY: f64 = 1e-3;
const MAX_WAY: f64 = 0.05;
/// Step aside after which the height that was found for the last deflection is a start [m].
const NEAR: f64 = 1e-5;
/// Greatest growth of the deflection that springs let rails have with that which they have, up to
/// which there is one solution about, which moves on with the inputs [-].
const MOST_GROWTH: f64 = 0.5;
/// Load over penetration^(3/2) of a wheel on a rail, for the first guess [N/m^1.5].
const STIFFNESS: f64 = 7e10;

/// A lateral deflection of rails under a given load.
#[derive(Clone, Copy, Debug)]
struct Aside {
    /// The deflection, and how much farther the springs would let the rails go [m].
    y: f64,
    left: f64,
    /// How the deflection that the springs would let them have goes with that which they have [-].
    growth: f64,
    fallbacks: u64,
}

/// Trials of lateral deflections, each from the one before where that is near.
struct Trials<'a> {
    element: &'a mut Element,
    given: &'a Input,
    sunk: f64,
    last: Aside,
    carried: Option<Carried>,
}

impl<'a> Trials<'a> {
    fn new(element: &'a mut Element, given: &'a Input) -> Self {
        let sunk = element.sunk_under_load(given);
        let last = Aside { y: 0.0, left: f64::INFINITY, growth: 0.0, fallbacks: 0 };
        Self { element, given, sunk, last, carried: None }
    }

    /// How much farther the springs would let rails go from `y` [m].
    fn left(&mut self, y: f64, input: &mut Input, output: &mut Output) -> f64 {
        let step = y - self.last.y;
        self.element.expect(self.carried.filter(|_| step.abs() <= NEAR));
        let ([left, _], fallbacks) =
            self.element.try_deflection(self.given, [y, self.sunk], input, output);
        self.carried = self.element.carried;
        let growth = 1.0 + (left - self.last.left) / step;
        let growth = if growth.is_finite() { growth } else { 0.0 };
        self.last = Aside { y, left, growth, fallbacks };
        left
    }
}

/// The input with a height that is the same for all.
fn without_height(given: &Input) -> Input {
    let mut key = *given;
    key.wheel.position[2] = 0.0;
    key
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
        if let Some((known, deflection, left)) = self.rested
            && known == given
        {
            let (_, fallbacks) = self.try_deflection(&given, deflection, input, output);
            return (deflection, left, fallbacks);
        }
        let mut deflection = self.first_guess(&given);
        let (mut rest, mut fallbacks) = self.try_deflection(&given, deflection, input, output);
        // Under a lifted wheel they rest at once.
        let mut left = length(rest);
        let (mut steps, mut kept) = (0, None);
        while left > RESOLUTION && steps < MAX_STEPS {
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
                if next <= most * left || next <= RESOLUTION {
                    break Some((trial, found, next));
                }
                share *= 0.5;
                if kept.is_some() || share < SHORTEST || share * left < RESOLUTION {
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
        self.rested = Some((given, deflection, left));
        (deflection, left, fallbacks)
    }

    /// The same under a given load, which alone says how far the rails sink: what is left is one
    /// equation for the lateral deflection, which on a flange has more than one solution. That on
    /// the way out from none is taken.
    fn rest_under_load(&mut self, input: &mut Input, output: &mut Output) -> ([f64; 2], f64, u64) {
        let given = *input;
        let key = without_height(&given);
        let (y, left) = match self.rested {
            Some((known, [y, _], left)) if known == key => (y, left),
            _ => {
                let Aside { y, left, .. } = self.aside_from_none(&given, input, output);
                (y, left)
            }
        };
        // The forces are those of rails that are put there, whatever led to it.
        let deflection = [y, self.sunk_under_load(&given)];
        let (_, fallbacks) = self.try_deflection(&given, deflection, input, output);
        self.rested = Some((key, deflection, left));
        (deflection, left, fallbacks)
    }

    /// How the load of `input` is carried on rails without mass, near where that is `expected`, if
    /// they are to be sought there; they are then known to rest there under this input. Nothing
    /// where they do not, or strips do not tell.
    pub(super) fn carried_at_rest(
        &mut self,
        input: &mut Input,
        expected: Option<Carried>,
        output: &mut Output,
    ) -> Option<Carried> {
        let given = *input;
        let near = expected.and_then(|about| self.aside_near(&given, about, input, output));
        let found = near.unwrap_or_else(|| self.aside_from_none(&given, input, output));
        let Aside { y, left, growth, fallbacks } = found;
        if fallbacks > 0 || left.abs() > MISSED {
            return None;
        }
        self.rested = Some((without_height(&given), [y, self.sunk_under_load(&given)], left));
        let aside = (growth.abs() < MOST_GROWTH).then_some(y);
        Some(self.carried?.on_rails(aside))
    }

    /// How far rails sink under a given load [m].
    fn sunk_under_load(&self, given: &Input) -> f64 {
        given.wheel_load.max(0.0) / self.foundation.stiffness[1]
    }

    /// The lateral deflection that is met first on the way out from none.
    fn aside_from_none(&mut self, given: &Input, input: &mut Input, output: &mut Output) -> Aside {
        let mut trials = Trials::new(self, given);
        let level = trials.left(0.0, input, output);
        let first = level.clamp(-FIRST_WAY, FIRST_WAY);
        let (y, left) =
            outward(level, first, MAX_WAY, RESOLUTION, |y| trials.left(y, input, output));
        Aside { y, left, ..trials.last }
    }

    /// That beside the one which is expected, by secants; nothing where they do not lead to one.
    fn aside_near(
        &mut self,
        given: &Input,
        about: Carried,
        input: &mut Input,
        output: &mut Output,
    ) -> Option<Aside> {
        let mut y = about.aside?;
        let mut trials = Trials::new(self, given);
        trials.carried = Some(about);
        trials.last.y = y;
        for _ in 0..MAX_STEPS {
            let before = trials.last.left.abs();
            let left = trials.left(y, input, output);
            if left.abs() <= RESOLUTION {
                return Some(trials.last);
            }
            if !(2.0 * left.abs() < before && trials.last.growth.abs() < MOST_GROWTH) {
                return None;
            }
            y += left / (1.0 - trials.last.growth);
        }
        None
    }

    /// Deflection to begin with under a wheel of given height: rails that only sink, under a
    /// contact as stiff as contacts are.
    fn first_guess(&self, given: &Input) -> [f64; 2] {
        let stiffness = self.foundation.stiffness[1];
        let overlap = given.wheel.position[2] - self.height_near_touch(given);
        // Beside all rails it is minus infinity.
        if overlap <= 0.0 {
            return [0.0; 2];
        }
        // c δ^(3/2) = k (overlap - δ): Newton's method from above, on a convex curve.
        let mut depth = overlap.min((stiffness * overlap / STIFFNESS).powf(2.0 / 3.0));
        for _ in 0..4 {
            let root = depth.sqrt();
            let missing = STIFFNESS * depth * root - stiffness * (overlap - depth);
            depth -= missing / (1.5 * STIFFNESS * root + stiffness);
        }
        [0.0, overlap - depth]
    }

    /// The matrix 1 - K⁻¹ ∂F/∂d for rails in the place that `at` has.
    fn compliance(&mut self, at: &Input) -> [[f64; 2]; 2] {
        let slopes = self.rail_slopes(at);
        let stiffness = self.foundation.stiffness;
        [0, 1].map(|i| [0, 1].map(|j| f64::from(u8::from(i == j)) - slopes[i][j] / stiffness[i]))
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
