//! Rounds of marches through all strips, each with the gradients that the tractions of the round
//! before it cause.

#[cfg(target_arch = "x86_64")]
use pulp::{NullaryFnOnce, x86::V3};

use super::functions::Four;
use super::influence::{Influence, Own, Pair, Ratio};
use super::march::{CELLS, LANES, Marched, Sums, march, profile};
use crate::kinematics::creepage::Creepage;
use crate::math::dual::Dual;
use crate::math::fixed_vec::FixedVec;
use crate::math::real::Real;

/// Marches: with more of them errors against boundary elements stay what they are.
const ROUNDS: usize = 3;
/// Pairs of strips that are kept from round to round; further ones are looked up again.
const MAX_PAIRS: usize = 1024;

/// Strips with fewer than this number in between are as wide as they are; over others, at one and a
/// half widths at least, the influence hardly bends.
const NEAR: usize = 1;

/// A loaded strip that rolls forward.
#[derive(Clone, Copy, Debug)]
pub struct Strip<T = f64> {
    /// Place across [m].
    pub y: T,
    /// Half length > 0 [m].
    pub half_length: T,
    /// Width > 0 [m].
    pub width: T,
    /// Friction limit per width > 0 [N/m].
    pub limit: T,
    /// Number of its zone.
    pub zone: usize,
    /// Rigid slip in its middle.
    pub creepage: Creepage<T>,
}

/// Tractions of a strip in sums: what it does to the body that creeps, with the other sign.
#[derive(Clone, Copy, Debug, Default)]
pub struct Resultant<T = f64> {
    /// Moments ∫ f x^k over the strip, k = 0, 1, along the track and across [N, N m].
    pub moments: [[T; 2]; 2],
    /// Share of its length that slips [-].
    pub slip_share: f64,
}

/// Moments of the tractions of a strip, arranged for products with a [`Pair`].
#[derive(Clone, Copy, Debug)]
struct Moments<T> {
    /// (1, 0, 1, 2), then (0, 1, 0, -) and (2, -, 2, -); what is not used is any of them.
    odd: Four<T>,
    even: [Four<T>; 2],
}

/// A strip and how it stands.
#[derive(Clone, Copy, Debug)]
struct State<T> {
    strip: Strip<T>,
    own: Own<T>,
    /// Along the track and across.
    moments: [Moments<T>; 2],
    gradients: [Four<T>; 2],
    resultant: Resultant<T>,
}

/// Solver with its memory; it keeps no result.
#[derive(Clone, Debug)]
pub struct Solver<T = f64> {
    states: FixedVec<State<T>>,
    pairs: FixedVec<Pair<T>>,
}

impl<T: Real> Moments<T> {
    fn none() -> Self {
        let none = [T::from(0.0); 4];
        Self { odd: none, even: [none; 2] }
    }
}

impl<T: Real> Solver<T> {
    /// For up to `strips` strips; more allocate.
    pub fn new(strips: usize) -> Self {
        let pairs = (strips * strips.saturating_sub(1) / 2).min(MAX_PAIRS);
        Self { states: FixedVec::new(strips), pairs: FixedVec::new(pairs) }
    }

    /// Takes the strips of the next solution.
    pub fn take(&mut self, strips: impl Iterator<Item = Strip<T>>) {
        self.states.clear();
        self.states.extend(strips.map(|strip| State {
            strip,
            own: Own::default(),
            moments: [Moments::none(); 2],
            gradients: [[T::from(0.0); 4]; 2],
            resultant: Resultant::default(),
        }));
    }

    /// Tractions of the strips, in the order in which they were taken.
    pub fn resultants(&self) -> impl Iterator<Item = &Resultant<T>> {
        self.states.iter().map(|state| &state.resultant)
    }

    /// Solves for bodies of this Poisson's ratio and shear modulus [Pa].
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn solve_all<const F: bool>(&mut self, poisson_ratio: f64, shear_modulus: T) {
        let influence = Influence::shared();
        let ratio = Ratio::of(poisson_ratio);
        for i in 0..self.states.len() {
            let Strip { half_length, width, .. } = self.states[i].strip;
            let reach = reach(&self.states, i);
            self.states[i].own = influence.own::<F, T>(half_length, width, reach, &ratio);
        }
        self.pairs.clear();
        let room = self.pairs.capacity();
        for (i, below) in self.states.iter().enumerate() {
            for (between, above) in self.states.iter().skip(i + 1).enumerate() {
                if self.pairs.len() < room {
                    self.pairs.push(pair::<F, T>(influence, below, above, between, &ratio));
                }
            }
        }
        let factor = T::from(-2.0 / std::f64::consts::PI.powi(2)) / shear_modulus;
        for round in 0..ROUNDS {
            if round > 0 {
                self.couple::<F>(influence, &ratio, factor);
            }
            self.march_all::<F>(shear_modulus, |_, _, _, _| {});
        }
    }

    /// Gradients that all strips cause, without the share that each has in its own march.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn couple<const F: bool>(&mut self, influence: &Influence, ratio: &Ratio, factor: T) {
        for state in self.states.iter_mut() {
            let [x, y] = &state.moments;
            let Own { along, across, .. } = &state.own;
            state.gradients = [[T::from(0.0); 4]; 2];
            add_product::<F, T>(&mut state.gradients[0], along, &x.odd);
            add_product::<F, T>(&mut state.gradients[1], across, &y.odd);
        }
        let mut kept = self.pairs.iter();
        for i in 0..self.states.len() {
            let (lower, upper) = self.states.split_at_mut(i + 1);
            let below = &mut lower[i];
            let moments = below.moments;
            let mut gradients = below.gradients;
            for (between, above) in upper.iter_mut().enumerate() {
                let anew;
                let pair = if let Some(pair) = kept.next() {
                    pair
                } else {
                    anew = pair::<F, T>(influence, below, above, between, ratio);
                    &anew
                };
                let crossed = pair.crossed.map(|four| four.map(|c| -c));
                receive::<F, T>(&mut gradients, pair, &crossed, &above.moments);
                receive::<F, T>(&mut above.gradients, pair, &pair.crossed, &moments);
            }
            below.gradients = gradients;
        }
        for state in self.states.iter_mut() {
            for gradient in state.gradients.iter_mut().flatten() {
                *gradient *= factor;
            }
        }
    }

    /// Marches through all strips; `each` gets the number of the first of some strips, a cell, their
    /// tractions there and whether they slip.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn march_all<const F: bool>(
        &mut self,
        shear_modulus: T,
        mut each: impl FnMut(usize, usize, &[[T; LANES]; 2], &[bool; LANES]),
    ) {
        for (block, states) in self.states.chunks_mut(LANES).enumerate() {
            let mut marched = Marched::default();
            for (lane, state) in states.iter().enumerate() {
                let growth = state.growth(shear_modulus);
                for (lanes, growth) in marched.growth.iter_mut().zip(growth) {
                    for (lanes, growth) in lanes.iter_mut().zip(growth) {
                        lanes[lane] = growth;
                    }
                }
                marched.bound[lane] = state.strip.limit / (state.strip.half_length * 2.0);
            }
            let sums = march::<F, T>(&marched, |cell, tractions, slip| {
                each(LANES * block, cell, tractions, slip);
            });
            for (lane, state) in states.iter_mut().enumerate() {
                state.take_sums(&sums, lane);
            }
        }
    }
}

/// Distances to both sides over which others have tractions like those of strip `i`: by as much less
/// as anything up to them has a lower limit.
#[allow(clippy::inline_always)]
#[inline(always)]
fn reach<T: Real>(states: &[State<T>], i: usize) -> [T; 2] {
    let own = &states[i].strip;
    let over = |strips: &mut dyn Iterator<Item = &State<T>>| {
        let (mut reach, mut least) = (own.width * 0.5, own.limit);
        for State { strip, .. } in strips.take_while(|state| state.strip.zone == own.zone) {
            least = least.min(strip.limit);
            reach += strip.width * (least / own.limit);
        }
        reach
    };
    [over(&mut states[..i].iter().rev()), over(&mut states[i + 1..].iter())]
}

/// What two strips do to each other, with `between` strips in between; stretches of one strip, which
/// are ahead of each other, do nothing.
#[allow(clippy::inline_always)]
#[inline(always)]
fn pair<const F: bool, T: Real>(
    influence: &Influence,
    below: &State<T>,
    above: &State<T>,
    between: usize,
    ratio: &Ratio,
) -> Pair<T> {
    let [below, above] = [&below.strip, &above.strip];
    let distance = above.y - below.y;
    if distance <= 0.0 {
        return Pair::default();
    }
    let square =
        (below.half_length * below.half_length + above.half_length * above.half_length) * 0.5;
    if between < NEAR {
        influence.wide::<F, T>(distance, (below.width + above.width) * 0.5, square, ratio)
    } else {
        influence.narrow::<F, T>(distance, square, ratio)
    }
}

/// Adds the gradients that another strip causes; what is crossed has the sign of the side on which it
/// is.
#[allow(clippy::inline_always)]
#[inline(always)]
fn receive<const F: bool, T: Real>(
    [along, across]: &mut [Four<T>; 2],
    pair: &Pair<T>,
    crossed: &[Four<T>; 2],
    [x, y]: &[Moments<T>; 2],
) {
    add_product::<F, T>(along, &pair.along, &x.odd);
    add_product::<F, T>(across, &pair.across, &y.odd);
    for (crossed, (x, y)) in crossed.iter().zip(x.even.iter().zip(&y.even)) {
        add_product::<F, T>(along, crossed, y);
        add_product::<F, T>(across, crossed, x);
    }
}

/// Sums and products lane by lane.
#[allow(clippy::inline_always)]
#[inline(always)]
fn add_product<const F: bool, T: Real>(sum: &mut Four<T>, a: &Four<T>, b: &Four<T>) {
    for lane in 0..4 {
        sum[lane] = sum[lane].add_product::<F>(a[lane], b[lane]);
    }
}

#[allow(clippy::inline_always)]
impl<T: Real> State<T> {
    /// Growth of the tractions over a cell, along the track and across.
    #[inline(always)]
    fn growth(&self, shear_modulus: T) -> [[T; 3]; 2] {
        let Strip { half_length: a, creepage, .. } = &self.strip;
        let a = *a;
        let rigid = [[creepage.longitudinal, T::from(0.0)], [creepage.lateral, creepage.spin * a]];
        let step = shear_modulus * a * (2.0 / CELLS as f64);
        let mut growth = [[T::from(0.0); 3]; 2];
        for component in 0..2 {
            let [zeroth, first, second, other_first] = self.gradients[component];
            // Of x² to T₂.
            let square = second * a * a * 0.5;
            let [flexibility, by_first, by_second] = self.own.flexibility[component];
            let per_flexibility = step / flexibility;
            let [constant, linear] = rigid[component];
            growth[component] = [
                (constant - zeroth - square) * per_flexibility,
                (linear - (first + other_first) * a) * by_first * per_flexibility,
                -(square * by_second * per_flexibility),
            ];
        }
        growth
    }

    /// Takes the moments of the tractions after a march.
    #[inline(always)]
    fn take_sums(&mut self, sums: &Sums<T>, lane: usize) {
        let a = self.strip.half_length;
        let length = a * (2.0 / CELLS as f64) * self.strip.width;
        for component in 0..2 {
            let [zeroth, first, second] = sums.moments[component];
            let zeroth = zeroth[lane] * length;
            let first = first[lane] * length * a;
            let second = second[lane] * length * a * a;
            self.moments[component] = Moments {
                odd: [first, zeroth, first, second],
                even: [[zeroth, first, zeroth, first], [second; 4]],
            };
            self.resultant.moments[component] = [zeroth, first];
        }
        self.resultant.slip_share = sums.slipping[lane] / CELLS as f64;
    }
}

/// Derivatives that are found at once.
pub const DIRECTIONS: usize = 4;

/// Tractions of a cell over its bound, and whether it slips; leading edge first.
pub type Cells = [([f64; 2], bool); CELLS];

impl Solver {
    /// Solves for bodies of this Poisson's ratio and shear modulus [Pa]; tractions of the strips
    /// taken, against their slip.
    #[must_use]
    pub fn tractions(&mut self, poisson_ratio: f64, shear_modulus: f64) -> Vec<Cells> {
        self.solve(poisson_ratio, shear_modulus);
        let strips: Vec<Strip> = self.states.iter().map(|state| state.strip).collect();
        let mut found = vec![[([0.0; 2], false); CELLS]; strips.len()];
        self.march_all::<FUSED>(shear_modulus, |first, cell, [x, y], slip| {
            for (lane, strip) in strips.iter().enumerate().skip(first).take(LANES) {
                let bound = strip.limit / (strip.half_length * 2.0) * profile(cell);
                let n = lane - first;
                found[lane][cell] = ([x[n] / bound, y[n] / bound], slip[n]);
            }
        });
        found
    }

    /// Solves for bodies of this Poisson's ratio and shear modulus [Pa].
    pub fn solve(&mut self, poisson_ratio: f64, shear_modulus: f64) {
        self.solve_by_any(poisson_ratio, shear_modulus);
    }
}

impl Solver<Dual<DIRECTIONS>> {
    /// As of plain numbers.
    pub fn solve(&mut self, poisson_ratio: f64, shear_modulus: Dual<DIRECTIONS>) {
        self.solve_by_any(poisson_ratio, shear_modulus);
    }
}

/// Whether every processor that this is compiled for adds a product in one instruction.
const FUSED: bool = cfg!(any(target_feature = "fma", target_arch = "aarch64"));

impl<T: Real> Solver<T> {
    /// Solves with the instructions that the processor has, found out at run time.
    fn solve_by_any(&mut self, poisson_ratio: f64, shear_modulus: T) {
        #[cfg(target_arch = "x86_64")]
        if let Some(simd) = V3::try_new() {
            return simd.vectorize(Solution { solver: self, poisson_ratio, shear_modulus });
        }
        self.solve_all::<FUSED>(poisson_ratio, shear_modulus);
    }
}

/// A solution, to be compiled for AVX2 with products that are added at once.
#[cfg(target_arch = "x86_64")]
struct Solution<'a, T> {
    solver: &'a mut Solver<T>,
    poisson_ratio: f64,
    shear_modulus: T,
}

#[cfg(target_arch = "x86_64")]
impl<T: Real> NullaryFnOnce for Solution<'_, T> {
    type Output = ();

    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn call(self) {
        self.solver.solve_all::<true>(self.poisson_ratio, self.shear_modulus);
    }
}
