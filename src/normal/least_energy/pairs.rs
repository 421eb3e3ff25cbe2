//! The distance of every two strips, as their mutual potential is tabulated over it.
//!
//! A load per width that is linear between nodes is a sum of hats. The potential of two strips is
//! averaged over both hats, for hats of equal widths that are up to four nodes apart in tables, else
//! as that of two points. Other hats get the spacing h of equal ones with the same mean logarithm of
//! the distance, from the distance D of their centroids and their variances v:
//!
//! ```text
//! h² = (D² - v_i - v_j)/(k² - 1/3)                                        k ≥ 2 nodes apart
//! h² = D² (1 + 3/2 (-0.4836 e + 1.9765 e² - 0.3389 q))                    beside each other
//! h² = w² (1 + 0.1821 r²)                                                 a hat and itself
//! e = (v_i + v_j)/D² - 1/3,  q = (μ_i - μ_j)/D³ (third moments),  r = (right - left)/(right + left)
//! ```
//!
//! Strips of a yawed wheel are displaced along x by Δx as well: see `displaced`.

use std::array::from_fn;

use super::displaced::{Growth, Growths};
use super::kernel::{COEFFICIENTS, FIRST_PIECE, Kernel, ROW_PIECES, ROWS, SOFTNESS, TABLE};
use super::lanes::{Four, LANES, Lanes, Simd};
use super::lattice::Lattice;
use super::problem::Problem;
use crate::math::dual::Dual;
use crate::math::fixed_vec::FixedVec;
use crate::math::real::{Function, Real};

/// Row of the table for pairs far apart.
const FAR: usize = ROWS - 1;

const BESIDE: [f64; 3] = [-0.4836, 1.9765, -0.3389];
const ITSELF: f64 = 0.1821;
/// k² and 1/(k² - 1/3) of nodes k apart.
const APART: [[f64; 2]; 3] = [[4.0, 3.0 / 11.0], [9.0, 3.0 / 26.0], [16.0, 3.0 / 47.0]];
/// Least square of the distance of two hats over the sum of their variances: where a line folds,
/// those of two intervals may lie in one place.
const CLOSEST: f64 = 2.0;
/// Places from one interval of overlap to the next: none of their nodes are near each other.
const INTERVAL: f64 = 1e6;
/// A place where no hat is, and a centroid [m].
const NOWHERE: f64 = 1e12;
const FAR_AWAY: f64 = 1e3;

/// What the distance of a strip to others follows from.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Hat<T = f64> {
    /// Number of the node, with a leap from one interval of overlap to the next.
    place: T,
    /// Centroid [m] and variance of the hat [m²].
    centre: T,
    variance: T,
    /// Squares of the spacings of the hat and itself, and of the one before it [m²].
    own: T,
    beside: T,
    /// Place along the track [m].
    x: T,
}

impl<T: Real> Hat<T> {
    /// The hat of node `i` of `lattice`.
    pub fn new(lattice: &Lattice<T>, i: usize) -> Self {
        let node = &lattice.nodes[i];
        let [centre, variance, third] = moments(node.y, node.reach);
        let beside = if i > 0 {
            let node = &lattice.nodes[i - 1];
            let before = moments(node.y, node.reach);
            beside(centre - before[0], variance + before[1], third - before[2])
        } else {
            T::from(0.0)
        };
        Self {
            place: T::from(i as f64 + INTERVAL * node.interval as f64),
            centre,
            variance,
            own: own_square(node.reach),
            beside,
            x: node.x,
        }
    }

    /// Potential K of its strip and that of `other` with these squares of the half lengths, and
    /// its derivatives by these; what may have been `kept` is that of the same strips with the same
    /// lengths.
    pub fn potential(
        &self,
        other: &Self,
        kernel: &Kernel,
        squares: [T; 2],
        kept: &mut KeptPair,
    ) -> [T; 3] {
        let (away, shift) = (other.centre - self.centre, other.x - self.x);
        let place = other.place.value() - self.place.value();
        let variances = other.variance + self.variance;
        let near = match place {
            0.0 => self.own,
            1.0 => other.beside,
            -1.0 => self.beside,
            _ => T::from(0.0),
        };
        let numbers = [away, shift, variances, near, squares[0], squares[1]];
        T::as_whole_again(numbers, &PairOf { kernel, place }, kept)
    }
}

/// What was found of a pair of strips, for derivatives backwards.
pub(super) type KeptPair = Option<[Dual<6>; 3]>;

/// The potential of a pair of strips and its derivatives by the squares of their half lengths, as
/// functions of the distance of their centroids, of how far one is ahead of the other, of the sum of
/// their variances, of the square of the spacing where they are beside each other and of the squares of
/// their half lengths.
struct PairOf<'a> {
    kernel: &'a Kernel,
    /// How many places they are apart.
    place: f64,
}

impl Function<6, 3> for PairOf<'_> {
    fn at<T: Real>(&self, numbers: [T; 6]) -> [T; 3] {
        let &Self { kernel, place } = self;
        let [away, shift, variances, near, p, q] = numbers;
        let distance = (away * away).max(variances * CLOSEST);
        let far = distance - variances;
        let mut square = if place.abs() < 1.5 {
            near
        } else {
            let apart = APART.into_iter().find(|apart| (apart[0] - place * place).abs() < 0.5);
            apart.map_or(far, |[_, inverse]| far * inverse)
        };
        let sum = p + q;
        let mut growth = None;
        if place != 0.0 && shift.value() != 0.0 {
            let own = Growth::new(shift * shift / distance, sum * 0.5 / distance);
            square *= own.factor;
            growth = Some(own);
        }
        let inverse = T::from(1.0) / square;
        let row = FAR.min(place.abs() as usize);
        let [value, by_p, by_q] = kernel.value(row, [p, q], inverse * 0.5, inverse.sqrt());
        let Some(Growth { rate, .. }) = growth else { return [value, by_p, by_q] };
        // K goes with the inverse of all lengths.
        let by_distance = -(value * 0.5) - p * by_p - q * by_q;
        let more = rate / sum * by_distance;
        [value, by_p + more, by_q + more]
    }
}

/// Centroid of a hat, and second and third moments about it.
fn moments<T: Real>(y: T, [l, r]: [T; 2]) -> [T; 3] {
    let (skew, squares) = (r - l, l * l + l * r + r * r);
    let third = skew * (squares * 2.0 + l * r * 3.0) * (1.0 / 270.0);
    [y + skew * (1.0 / 3.0), squares * (1.0 / 18.0), third]
}

/// Square of the spacing for a hat and itself.
fn own_square<T: Real>([left, right]: [T; 2]) -> T {
    let (width, skew) = ((left + right) * 0.5, (right - left) * 0.5);
    width * width + skew * skew * ITSELF
}

/// Square of the spacing for hats beside each other, `away` from each other, from the sum of their
/// variances and the difference of their third moments.
fn beside<T: Real>(away: T, variances: T, thirds: T) -> T {
    let square = away * away;
    let inverse = T::from(1.0) / square;
    let e = variances * inverse - 1.0 / 3.0;
    let q = thirds * inverse / away;
    square * (q * (1.5 * BESIDE[2]) + e * (e * (1.5 * BESIDE[1]) + 1.5 * BESIDE[0]) + 1.0)
}

/// Four pairs as the table wants them.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Pairs {
    /// 1/(2 h²) [m^-2].
    pub half_inverse_square: Lanes,
    /// Cosine of the angle between the normals over h [1/m].
    pub inverse: Lanes,
    /// What rounds the kink over t off, A/(2 h²) [m^-2] and B.
    pub soft_rate: Lanes,
    pub soft_base: Lanes,
    /// Square of the displacement over that of the distance, (Δx/D)² [-], and 1/(2 D²) [m^-2].
    pub displacement: Lanes,
    pub half_inverse_distance: Lanes,
    /// φ (p + q) of `displaced` [m²].
    pub nearness: Lanes,
    /// First coefficient of their rows of the table, less what the digits of the least w form.
    pub row: [u64; LANES],
}

/// Hats of the nodes that are taken, four by four.
#[derive(Clone, Debug)]
pub(super) struct Hats {
    fours: FixedVec<Hat<Lanes>>,
    /// Whether strips are displaced along x.
    pub is_skewed: bool,
}

impl Hats {
    pub fn new(most: usize) -> Self {
        let fours = FixedVec::new(most.div_ceil(LANES));
        Self { fours, is_skewed: false }
    }

    /// Takes the hats of `nodes`.
    pub fn take(&mut self, problem: &Problem, nodes: &[usize]) {
        self.is_skewed = problem.is_skewed;
        self.fours.clear();
        for nodes in nodes.chunks(LANES) {
            // Somewhere else, where there are less than four.
            let none = Hat { place: NOWHERE, centre: FAR_AWAY, ..Hat::default() };
            let hat = |lane: usize| nodes.get(lane).map_or(none, |&i| problem.points[i].hat);
            let hats: [Hat; LANES] = from_fn(hat);
            self.fours.push(Hat {
                place: hats.map(|hat| hat.place),
                centre: hats.map(|hat| hat.centre),
                variance: hats.map(|hat| hat.variance),
                own: hats.map(|hat| hat.own),
                beside: hats.map(|hat| hat.beside),
                x: hats.map(|hat| hat.x),
            });
        }
    }

    /// Measures the pairs of all hats from the four number `from` on with the hat `one`.
    #[inline(always)]
    pub fn measure<S: Simd>(&self, simd: S, from: usize, one: &Hat, pairs: &mut [Pairs]) {
        for (hats, pairs) in self.fours[from..].iter().zip(pairs) {
            let away = simd.four(&hats.centre) - one.centre;
            let variances = simd.four(&hats.variance) + one.variance;
            let distance = (away * away).max(variances * CLOSEST);
            let mut square = distance - variances;
            let places = simd.four(&hats.place) - one.place;
            let [first, .., last] = places.lanes();
            pairs.row = [FIRST_ROW.wrapping_add((FAR * ROW) as u64) & MASK; LANES];
            let mut softness = SOFTNESS[FAR].map(|number| simd.splat(number));
            if first < ROWS as f64 && last > -(ROWS as f64) {
                let apart = places * places;
                for [apart_square, inverse] in APART {
                    square = apart.where_equal(apart_square, square * inverse, square);
                }
                square = places.where_equal(1.0, simd.four(&hats.beside), square);
                square = places.where_equal(-1.0, simd.splat(one.beside), square);
                square = places.where_equal(0.0, simd.four(&hats.own), square);
                for (row, of_row) in SOFTNESS[..FAR].iter().enumerate() {
                    let apart_square = (row * row) as f64;
                    softness = [0, 1].map(|k| {
                        apart.where_equal(apart_square, simd.splat(of_row[k]), softness[k])
                    });
                }
                let row = apart.min(simd.splat((FAR * FAR) as f64)).sqrt();
                pairs.row = (row * ROW as f64 + WHOLE).digits::<0>([FIRST_ROW; LANES], MASK);
            }
            if self.is_skewed {
                let shift = simd.four(&hats.x) - one.x;
                let inverse = simd.splat(1.0) / distance;
                let displacement = shift * shift * inverse;
                let displacement = places.where_equal(0.0, simd.splat(0.0), displacement);
                let half_inverse = inverse * 0.5;
                pairs.displacement = displacement.lanes();
                pairs.half_inverse_distance = half_inverse.lanes();
                pairs.nearness = Growths::nearness(displacement, half_inverse).lanes();
            }
            let inverse = simd.splat(1.0) / square;
            pairs.half_inverse_square = (inverse * 0.5).lanes();
            pairs.soft_rate = (softness[0] * inverse * 0.5).lanes();
            pairs.soft_base = softness[1].lanes();
            pairs.inverse = inverse.sqrt().lanes();
        }
    }

    /// Less than the potentials of the hats of four number `block` with the hat `one`, for these sums
    /// of the squares of the half lengths: those of points as far apart as the loads are in the mean
    /// of squares.
    #[inline(always)]
    pub fn least_potential<S: Simd>(
        &self,
        simd: S,
        block: usize,
        one: &Hat,
        squares: Four<S>,
    ) -> Four<S> {
        let hats = &self.fours[block];
        let (away, shift) = (simd.four(&hats.centre) - one.centre, simd.four(&hats.x) - one.x);
        let distance = (squares * 0.25).add_product(away, away).add_product(shift, shift);
        simd.splat(LEAST_SHARE) / distance.sqrt()
    }
}

/// First coefficient of row 0 of the table, less what the digits of the least w form.
const FIRST_ROW: u64 = ((FIRST_PIECE * COEFFICIENTS as i64) as u64).wrapping_neg();
/// A row, in coefficients.
const ROW: usize = ROW_PIECES * COEFFICIENTS;
/// Share of the potential of points that those in the table are never below.
const LEAST_SHARE: f64 = 0.95;
/// What only counts of a place in the table.
const MASK: u64 = (TABLE * COEFFICIENTS - 1) as u64;
/// Makes whole numbers out of the last binary digits.
const WHOLE: f64 = (1_u64 << 52) as f64;
