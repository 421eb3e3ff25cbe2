//! The distances of many strips from one ([`hat`](super::hat)), four at a time.

use std::array::from_fn;

use super::displaced::Displacement;
use super::hat::{APART, CLOSEST, FAR, Hat};
use super::kernel::{COEFFICIENTS, FIRST_PIECE, ROW_PIECES, ROWS, SOFTNESS, TABLE};
use super::lanes::{Four, LANES, Lanes, Simd};
use super::problem::Problem;
use crate::math::fixed_vec::FixedVec;

/// A place where no hat is, and a centroid [m].
const NOWHERE: f64 = 1e12;
const FAR_AWAY: f64 = 1e3;

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
    /// How far they are displaced, where strips are.
    pub displacement: Displacement,
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
                let displaced = shift * shift * inverse;
                let displaced = places.where_equal(0.0, simd.splat(0.0), displaced);
                pairs.displacement = Displacement::new(displaced, inverse * 0.5);
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
