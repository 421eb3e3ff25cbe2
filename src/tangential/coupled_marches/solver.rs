//! Rounds of marches through all strips, each with the gradients that the tractions of the round
//! before it cause.

#[cfg(target_arch = "x86_64")]
use pulp::x86::V3;

use super::influence::{Influence, Pair, Ratio, WIDEST, inverse_square};
use super::march::{ALONG, CELLS, LANES, Marched, Sums, march};
use super::parts::{ZoneParts, Zones};
use super::state::{Resultant, State, Strip, receive};
use crate::math::fixed_vec::FixedVec;
use crate::math::real::Real;
use crate::math::vectors::Work;
use crate::tangential::tables::tabulated::ForceTable;

/// Marches: with more of them errors against boundary elements stay what they are.
const ROUNDS: usize = 3;
/// Pairs of strips that are kept from round to round; further ones are looked up again.
const MAX_PAIRS: usize = 1024;

/// Strips with fewer than this number in between are as wide as they are; over others, at one and a
/// half widths at least, the influence hardly bends.
const NEAR: usize = 1;

/// Solver with its memory.
#[derive(Clone, Debug)]
pub struct Solver<T = f64> {
    states: FixedVec<State<T>>,
    /// What the reach of each strip is found from.
    neighbours: FixedVec<Neighbours<T>>,
    /// Sums of the strips that were marched through last.
    sums: Box<Sums<T>>,
    /// Pairs of the first strips with all above them, row by row.
    pairs: Vec<Pair<T>>,
    /// The zones of which the strips are.
    zones: Zones<T>,
}

impl<T: Real> Solver<T> {
    /// For up to `strips` strips; more allocate.
    pub fn new(strips: usize) -> Self {
        let pairs = (strips * strips.saturating_sub(1) / 2).min(MAX_PAIRS);
        let pairs = vec![Pair::default(); pairs];
        let (states, neighbours) = (FixedVec::new(strips), FixedVec::new(strips.div_ceil(LANES)));
        Self { states, neighbours, sums: Box::default(), pairs, zones: Zones::new() }
    }

    /// Strips that there is room for.
    pub fn most_strips(&self) -> usize {
        self.states.capacity()
    }

    /// Takes the strips of the next solution.
    pub fn take(&mut self, strips: impl Iterator<Item = Strip<T>>) {
        let count = self.put(0, strips);
        self.states.truncate(count);
    }

    /// Puts `strips` in their places from number `first` on; returns the number after the last one.
    fn put(&mut self, first: usize, strips: impl Iterator<Item = Strip<T>>) -> usize {
        let mut next = first;
        for strip in strips {
            if let Some(state) = self.states.get_mut(next) {
                state.strip = strip;
            } else {
                self.states.push(State::new(strip));
            }
            next += 1;
        }
        next
    }

    /// Tractions of the strips, in the order in which they were taken.
    pub fn resultants(&self) -> impl Iterator<Item = &Resultant<T>> {
        self.states.iter().map(|state| &state.resultant)
    }

    /// Lays out flexibilities and pairs for bodies of this `ratio`, and marches as often as `rounds`.
    #[inline(always)]
    fn begin<const F: bool>(&mut self, ratio: &Ratio<T>, rounds: usize) {
        let influence = Influence::shared();
        self.neighbours.clear();
        for states in self.states.chunks(LANES) {
            self.neighbours.push(Neighbours::of(states));
        }
        for state in self.states.iter_mut() {
            let Strip { half_length, width, .. } = state.strip;
            let reach = reach(&state.strip, &self.neighbours);
            state.begin(influence.own::<F, T>(half_length, width, reach, ratio));
        }
        let mut room = &mut self.pairs[..];
        for (i, below) in self.states.iter().enumerate() {
            let others = &self.states[i + 1..];
            let Some((row, further)) = room.split_at_mut_checked(others.len()) else { break };
            room = further;
            // Here and below closures of iterators might be compiled apart, for any processor.
            for (between, (above, kept)) in others.iter().zip(row).enumerate() {
                *kept = pair::<F, T>(influence, below, above, between, ratio);
            }
        }
        self.march_all::<F>(|_, _, _, _| {});
        self.go_on::<F>(ratio, rounds - 1);
    }

    /// Marches on for some rounds.
    #[inline(always)]
    fn go_on<const F: bool>(&mut self, ratio: &Ratio<T>, rounds: usize) {
        let influence = Influence::shared();
        for _ in 0..rounds {
            self.couple::<F>(influence, ratio);
            self.march_all::<F>(|_, _, _, _| {});
        }
    }

    /// Gradients that all strips cause, without the share that each has in its own march, over the
    /// factor that goes with a [`Pair`].
    #[inline(always)]
    fn couple<const F: bool>(&mut self, influence: &Influence, ratio: &Ratio<T>) {
        for state in self.states.iter_mut() {
            state.begin_gradients();
        }
        let mut kept = &self.pairs[..];
        for i in 0..self.states.len() {
            let (lower, upper) = self.states.split_at_mut(i + 1);
            let below = &mut lower[i];
            let moments = below.moments;
            let mut gradients = below.gradients;
            if let Some((pairs, further)) = kept.split_at_checked(upper.len()) {
                kept = further;
                for (above, pair) in upper.iter_mut().zip(pairs) {
                    receive::<F, false, T>(&mut gradients, pair, &above.moments);
                    receive::<F, true, T>(&mut above.gradients, pair, &moments);
                }
            } else {
                kept = &[];
                for (between, above) in upper.iter_mut().enumerate() {
                    let pair = pair::<F, T>(influence, below, above, between, ratio);
                    receive::<F, false, T>(&mut gradients, &pair, &above.moments);
                    receive::<F, true, T>(&mut above.gradients, &pair, &moments);
                }
            }
            below.gradients = gradients;
        }
    }

    /// Marches through all strips; `each` gets the number of the first of some strips, a cell, their
    /// tractions there and whether they slip.
    #[inline(always)]
    fn march_all<const F: bool>(
        &mut self,
        mut each: impl FnMut(usize, usize, &[[T; LANES]; 2], &[bool; LANES]),
    ) {
        let Self { states, sums, .. } = self;
        for (block, states) in states.chunks_mut(LANES).enumerate() {
            let mut marched = Marched::default();
            for (lane, state) in states.iter().enumerate() {
                for component in 0..2 {
                    let growth = state.growth[component].under::<F>(&state.gradients[component]);
                    for (lanes, growth) in marched.growth[component].iter_mut().zip(growth) {
                        lanes[lane] = growth;
                    }
                }
                marched.bound[lane] = state.bound;
            }
            march::<F, T>(&marched, sums, |cell, tractions, slip| {
                each(LANES * block, cell, tractions, slip);
            });
            for (lane, state) in states.iter_mut().enumerate() {
                state.take_sums(sums, lane);
            }
        }
    }
}

/// Some strips by columns, of which others feel something; a place without a strip has no limit.
#[derive(Clone, Copy, Debug, Default)]
struct Neighbours<T> {
    y: [T; LANES],
    limit: [T; LANES],
    width: [T; LANES],
}

impl<T: Real> Neighbours<T> {
    #[inline(always)]
    fn of(states: &[State<T>]) -> Self {
        let mut own = Self::default();
        for (lane, State { strip, .. }) in states.iter().enumerate() {
            own.y[lane] = strip.y;
            own.limit[lane] = strip.limit;
            own.width[lane] = strip.width;
        }
        own
    }
}

/// Distances to both sides over which a strip of the tractions of `own` would be felt by it as the
/// `others` are: the share of a strip is that of its limit in the own one, at most 1, and it is felt
/// by
///
/// ```text
/// ∫ a/(a + |y - y_i|)² dy
/// ```
///
/// over its width, a the own half length. It only has to be close: what is felt exactly comes in from
/// round to round. Zones beside each other are felt as much as parts of one.
#[inline(always)]
fn reach<T: Real>(own: &Strip<T>, others: &[Neighbours<T>]) -> [T; 2] {
    let zero = T::from(0.0);
    let a = own.half_length;
    let per_limit = a / own.limit;
    let mut felt = [[zero; LANES]; 2];
    for Neighbours { y, limit, width } in others {
        for lane in 0..LANES {
            let (away, half) = (y[lane] - own.y, width[lane] * 0.5);
            let share = (limit[lane] * per_limit).min(a) * width[lane];
            let middle = away.abs() + a;
            let by = share / ((middle - half).max(a) * (middle + half));
            // Itself, and stretches of one strip, which are ahead of each other, are on no side.
            felt[0][lane] += if away < 0.0 { by } else { zero };
            felt[1][lane] += if away > 0.0 { by } else { zero };
        }
    }
    let mut reach = [own.width / (own.width + a * 2.0); 2];
    for (reach, lanes) in reach.iter_mut().zip(felt) {
        for part in lanes {
            *reach += part;
        }
        let felt = reach.at_most(WIDEST / (WIDEST + 1.0));
        *reach = a * felt / (-felt + 1.0);
    }
    reach
}

/// What two strips do to each other, with `between` strips in between; stretches of one strip, which
/// are ahead of each other, do nothing.
#[inline(always)]
fn pair<const F: bool, T: Real>(
    influence: &Influence,
    below: &State<T>,
    above: &State<T>,
    between: usize,
    ratio: &Ratio<T>,
) -> Pair<T> {
    let distance = above.strip.y - below.strip.y;
    if distance <= 0.0 {
        return Pair::default();
    }
    let [below, above] = [&below.strip, &above.strip];
    let inverse = inverse_square(below.half_length, above.half_length);
    if between < NEAR {
        let width = (below.width + above.width) * 0.5;
        influence.wide::<F, T>(distance, width, inverse, ratio)
    } else {
        influence.narrow::<F, T>(distance, inverse, ratio)
    }
}

/// Derivatives that are found at once.
pub const DIRECTIONS: usize = 4;

/// Tractions of a cell over its bound, and whether it slips; leading edge first.
pub type Cells = [([f64; 2], bool); CELLS];

impl Solver {
    /// Solves for bodies of this Poisson's ratio; tractions of the strips taken, against their slip.
    pub fn tractions(&mut self, poisson_ratio: f64) -> Vec<Cells> {
        self.solve(poisson_ratio);
        let bounds: Vec<f64> = self.states.iter().map(|state| state.bound).collect();
        let mut found = vec![[([0.0; 2], false); CELLS]; bounds.len()];
        self.march_all::<FUSED>(|first, cell, [x, y], slip| {
            for (lane, bound) in bounds.iter().enumerate().skip(first).take(LANES) {
                let bound = bound * ALONG[cell].profile;
                let n = lane - first;
                found[lane][cell] = ([x[n] / bound, y[n] / bound], slip[n]);
            }
        });
        found
    }

    /// Solves for bodies of this Poisson's ratio, by marches alone.
    pub fn solve(&mut self, poisson_ratio: f64) {
        self.by_any(&Ratio::of(poisson_ratio), Stage::Begin(ROUNDS));
    }
}

impl<T: Real> Solver<T> {
    /// Solves for `zones` with their strips, in the order of their places, on bodies of this Poisson's
    /// ratio, with what marches lack on their ellipses by the `table`.
    pub fn solve_zones(
        &mut self,
        zones: impl Iterator<Item = (ZoneParts<T>, impl Iterator<Item = Strip<T>>)>,
        poisson_ratio: T,
        table: &impl ForceTable,
    ) {
        self.zones.clear();
        let mut first = 0;
        for (parts, strips) in zones {
            let next = self.put(first, strips);
            self.zones.push(parts, next - first);
            first = next;
        }
        self.states.truncate(first);
        let ratio = Ratio::of(poisson_ratio);
        self.by_any(&ratio, Stage::Begin(ROUNDS - 1));
        self.zones.gather(&self.states);
        self.zones.look_up(&ratio, poisson_ratio, table);
        self.zones.hand_on(&mut self.states, &ratio);
        self.by_any(&ratio, Stage::GoOn(1));
        self.zones.spread(&mut self.states);
    }
}

/// Whether every processor that this is compiled for adds a product in one instruction.
const FUSED: bool = cfg!(any(target_feature = "fma", target_arch = "aarch64"));

/// Rounds of marches.
#[derive(Clone, Copy)]
enum Stage {
    /// With what is laid out before.
    Begin(usize),
    /// With what is there.
    GoOn(usize),
}

impl<T: Real> Solver<T> {
    /// Marches with the instructions that the processor has, found out at run time.
    fn by_any(&mut self, ratio: &Ratio<T>, stage: Stage) {
        #[cfg(target_arch = "x86_64")]
        if let Some(simd) = V3::try_new() {
            return simd.vectorize(Work(
                #[inline(always)]
                || self.rounds::<true>(ratio, stage),
            ));
        }
        self.rounds::<FUSED>(ratio, stage);
    }

    #[inline(always)]
    fn rounds<const F: bool>(&mut self, ratio: &Ratio<T>, stage: Stage) {
        match stage {
            Stage::Begin(rounds) => self.begin::<F>(ratio, rounds),
            Stage::GoOn(rounds) => self.go_on::<F>(ratio, rounds),
        }
    }
}
