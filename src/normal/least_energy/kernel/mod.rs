//! Mutual potential of two parallel strips with semi-elliptical loads, averaged over the hats of
//! finite elements: tabulated functions.
//!
//! Two strips of half lengths a_i and a_j lie abreast, d apart, each with a unit load spread as a
//! semi-ellipse ρ along itself. Their potential is
//!
//! ```text
//! E(d, a_i, a_j) = ∫∫ ρ_i(x) ρ_j(x') / sqrt((x - x')² + d²) dx dx'      [1/m]
//! ```
//!
//! The kernel K is the mean of E over the hats of both strips, which stand h apart and reach from
//! one neighbour to the next. Rows 0 to 4 are for pairs of that many hats apart; row 5 is E itself
//! at the distance h, for pairs further apart. With p = a_i², q = a_j²,
//!
//! ```text
//! w = (p + q) / (2 h²)      t = (p - q) / (p + q)      K h = F(w) + sqrt(t² + σ(w)) G(w)
//! ```
//!
//! The logarithm that strips close together feel makes a kink of K over t where they are equally
//! long, which their distance rounds off: σ = 1/40 + 1/(A w + B), with A and B by row such that the
//! derivatives of K by the lengths are closest. F and G are fitted over t (`generate.rs`): K is off
//! by less than 1e-3 for lengths up to twice one another, and by 1e-2 beside a strip without length.
//! In w they are cubic splines, twice differentiable, eight pieces to each octave. Against the
//! functions fitted these are off by at most 4e-6 K, their derivatives w d/dw by 1e-4 K and
//! w² d²/dw² by 5e-3 K.
//!
//! Below w = 2^-16 (strips shorter than 1/256 of their distance) the cubic of the first piece goes
//! on: it is smooth, and stays finite where the logarithm of rows 0 and 1 does not. Above 2^18
//! (longer than 512 times their distance) the law of long strips goes on, (α ln w + β)/sqrt(w), and
//! F and G rest from 1.5 2^26 on.

#[cfg(test)]
mod generate;
#[cfg(test)]
mod tests;

use crate::math::real::Real;
use crate::math::spline::{SplineEnd, interpolating_slopes};
use crate::math::until_unload::UntilUnload;

/// Rows: 0 to 4 hats apart, and further.
pub(super) const ROWS: usize = 6;

/// The table begins at w = 2 to this power.
pub(super) const FIRST_EXPONENT: i32 = -16;

/// The table ends at w = 2 to this power.
pub(super) const END_EXPONENT: i32 = 18;

/// Binary digits of w after the first one that, with its exponent, number the piece.
pub(super) const PIECE_BITS: u32 = 3;

/// Pieces from one power of two to the next, equally long.
pub(super) const PIECES_PER_OCTAVE: usize = 1 << PIECE_BITS;

/// Pieces of a row.
pub(super) const PIECES: usize =
    PIECES_PER_OCTAVE * (END_EXPONENT - FIRST_EXPONENT).unsigned_abs() as usize;

/// Coefficients of a piece: four of F, four of G.
pub(super) const COEFFICIENTS: usize = 8;

/// Number that the exponent and the first [`PIECE_BITS`] digits of w form where the table begins.
pub(super) const FIRST_PIECE: i64 = (1023 + FIRST_EXPONENT as i64) << PIECE_BITS;

/// Room for all pieces, a power of two.
pub(super) const TABLE: usize = 2048;

/// Pieces of a row with those of the law of long strips, and one in which the functions rest.
pub(super) const ROW_PIECES: usize = TABLE / ROWS;

/// End of the tabulated functions.
#[cfg(test)]
pub(super) const GREATEST_W: f64 = (1_u64 << END_EXPONENT) as f64;

/// Where the functions rest.
pub(super) const LAST_W: f64 = (1.0
    + ((ROW_PIECES - 1) % PIECES_PER_OCTAVE) as f64 / PIECES_PER_OCTAVE as f64)
    * (1_u64 << ((ROW_PIECES - 1) / PIECES_PER_OCTAVE)) as f64
    / (1_u64 << -FIRST_EXPONENT) as f64;

/// What rounds |t| off at strips of equal length however close they are, 1/40, and A and B of each
/// row. Fitted: the greatest error of dK/dt over |t| < 1/2 at w from 0.03 to 3e4. From two hats apart
/// on what counts is the distance, k h: A is that of two points over k².
pub(super) const SOFTEST: f64 = 0.025;
pub(super) const SOFTNESS: [[f64; 2]; ROWS] =
    [[1.2, 16.7], [0.17, 12.9], [0.2 / 4.0, 1.6], [0.2 / 9.0, 1.6], [0.2 / 16.0, 1.6], [0.2, 1.6]];

/// Functions in the table: F and G of each row.
const FUNCTIONS: usize = 2 * ROWS;

/// The committed table.
const FILE: &str = include_str!("strips.kernel");

/// The kernel in memory.
#[derive(Clone, Debug)]
pub struct Kernel {
    /// Row by row and piece by piece c0 to c3 of F, then of G: c0 + w (c1 + w (c2 + w c3)).
    ///
    /// Powers of w itself, not of the way from the last knot, which need not be found then. The
    /// terms are those of a Taylor series about w = 0, none much larger than their sum: values are
    /// exact to 1e-15, second derivatives to 1e-14 of the function.
    pub(super) coefficients: Box<Table>,
}
pub(super) type Table = [f64; TABLE * COEFFICIENTS];

/// Knot number `knot` of w.
fn knot(knot: usize) -> f64 {
    let octave = 2f64.powi(FIRST_EXPONENT + (knot / PIECES_PER_OCTAVE) as i32);
    octave * (1.0 + (knot % PIECES_PER_OCTAVE) as f64 / PIECES_PER_OCTAVE as f64)
}

/// Place of the first coefficient of the piece of row `row` that holds `w`; the first or the last
/// piece outside the table.
#[inline]
pub(super) fn piece(row: usize, w: f64) -> usize {
    debug_assert!(row < ROWS);
    let number = (w.to_bits() >> (f64::MANTISSA_DIGITS - 1 - PIECE_BITS)) as i64 - FIRST_PIECE;
    (row * ROW_PIECES + number.clamp(0, ROW_PIECES as i64 - 1) as usize) * COEFFICIENTS
}

/// A cubic and its derivative.
#[inline]
fn cubic<T: Real>(c: &[f64], w: T) -> [T; 2] {
    let second = w * c[3] + c[2];
    let first = second * w + c[1];
    [first * w + c[0], (w * c[3] + second) * w + first]
}

/// (α ln w + β)/sqrt(w): strips far longer than their distance feel its logarithm.
struct LongStrips {
    alpha: f64,
    beta: f64,
}

impl LongStrips {
    /// The law with this value and slope at `w`.
    fn new(w: f64, value: f64, slope: f64) -> Self {
        let alpha = (slope * w + 0.5 * value) * w.sqrt();
        Self { alpha, beta: value * w.sqrt() - alpha * w.ln() }
    }

    fn value(&self, w: f64) -> f64 {
        (self.alpha * w.ln() + self.beta) / w.sqrt()
    }

    fn slope(&self, w: f64) -> f64 {
        (self.alpha / w.sqrt() - 0.5 * self.value(w)) / w
    }
}

/// Coefficients in powers of w of the cubic with these values and slopes at both ends of the piece
/// that begins at `from` and is `long`.
fn powers([from, long]: [f64; 2], values: [f64; 2], slopes: [f64; 2]) -> [f64; 4] {
    let [before, after] = slopes.map(|slope| slope * long);
    let rise = values[1] - values[0];
    let (c2, c3) = (3.0 * rise - 2.0 * before - after, before + after - 2.0 * rise);
    let r = from / long;
    [
        values[0] - r * (before - r * (c2 - r * c3)),
        (before - r * (2.0 * c2 - 3.0 * r * c3)) / long,
        (c2 - 3.0 * r * c3) / (long * long),
        c3 / (long * long * long),
    ]
}

/// Numbers of a table in their order; none if one of them cannot be read.
fn numbers(text: &str) -> Option<Vec<f64>> {
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    lines.flat_map(str::split_whitespace).map(|number| number.parse().ok()).collect()
}

impl Kernel {
    /// The committed table, laid out on first use in the process; takes about a millisecond then.
    ///
    /// # Panics
    /// If the file in the library has another size than the code, which a test excludes.
    pub fn shared() -> &'static Self {
        static KERNEL: UntilUnload<Kernel> = UntilUnload::new();
        KERNEL.get_or_init(|| Self::from_text(FILE).expect("the table in the library is whole"))
    }

    /// The kernel of a table as `generate.rs` writes it; none where it has another size.
    fn from_text(text: &str) -> Option<Self> {
        let numbers = numbers(text)?;
        if numbers.len() != (PIECES + 3) * FUNCTIONS {
            return None;
        }
        let knots: Vec<f64> = (0..=PIECES).map(knot).collect();
        let mut coefficients = vec![0.0; TABLE * COEFFICIENTS];
        for function in 0..FUNCTIONS {
            let column: Vec<f64> =
                numbers.iter().skip(function).step_by(FUNCTIONS).copied().collect();
            let (values, ends) = column.split_at(PIECES + 1);
            let ends = [ends[0] / knots[0], ends[1] / knots[PIECES]];
            let slopes = interpolating_slopes(&knots, values, ends.map(SplineEnd::Clamped));
            let long = LongStrips::new(knots[PIECES], values[PIECES], ends[1]);
            for piece in 0..ROW_PIECES {
                let pair = |of: &[f64]| [of[piece], of[piece + 1]];
                let [from, to] = [piece, piece + 1].map(knot);
                let powers = if piece < PIECES {
                    powers([from, to - from], pair(values), pair(&slopes))
                } else if piece + 1 < ROW_PIECES {
                    let ends = [from, to];
                    powers(
                        [from, to - from],
                        ends.map(|w| long.value(w)),
                        ends.map(|w| long.slope(w)),
                    )
                } else {
                    [long.value(from), 0.0, 0.0, 0.0]
                };
                let at = ((function / 2) * ROW_PIECES + piece) * COEFFICIENTS + 4 * (function % 2);
                coefficients[at..at + 4].copy_from_slice(&powers);
            }
        }
        Some(Self { coefficients: coefficients.try_into().ok()? })
    }

    /// F, F', G and G' of row `row` at `w` ≤ [`LAST_W`].
    #[inline]
    fn functions<T: Real>(&self, row: usize, w: T) -> [[T; 2]; 2] {
        let at = piece(row, w.value());
        let c = &self.coefficients[at..at + COEFFICIENTS];
        [cubic(&c[..4], w), cubic(&c[4..], w)]
    }

    /// K [1/m], dK/dp and dK/dq [1/m³] of a pair of strips.
    ///
    /// `row` is how many hats they are apart, at most the last row. `p` and `q` [m²] are the
    /// squares of their half lengths, not negative, one of them positive; `half_inverse_square`
    /// [1/m²] is 1/(2 h²) and `inverse` [1/m] 1/h, or that times what K is to be multiplied by.
    #[inline]
    pub(super) fn value<T: Real>(
        &self,
        row: usize,
        [p, q]: [T; 2],
        half_inverse_square: T,
        inverse: T,
    ) -> [T; 3] {
        let one = T::from(1.0);
        let inverse_sum = one / (p + q);
        let t = (p - q) * inverse_sum;
        let [rate, base] = SOFTNESS[row];
        let softness = one / ((p + q) * half_inverse_square * rate + base);
        let root = (t * t + softness + SOFTEST).sqrt();
        let root_by_p = -softness * softness * half_inverse_square * (0.5 * rate) / root;
        let mut w_by_p = half_inverse_square;
        let mut w = (p + q) * w_by_p;
        if w > LAST_W {
            (w, w_by_p) = (T::from(LAST_W), T::from(0.0));
        }
        let [[f, f_by_w], [g, g_by_w]] = self.functions(row, w);
        // dt/dp = (1 - t)/(p + q), dt/dq = -(1 + t)/(p + q).
        let by_w = (f_by_w + root * g_by_w) * w_by_p + g * root_by_p;
        let by_t = g * t / root * inverse_sum;
        let by_p = by_w + by_t * (one - t);
        let by_q = by_w - by_t * (one + t);
        [inverse * (f + root * g), inverse * by_p, inverse * by_q]
    }

    /// As [`value`](Self::value), then d²K/dp², d²K/dpdq and d²K/dq² [1/m⁵] as its derivatives
    /// vary.
    #[cfg(test)]
    pub(super) fn second(&self, row: usize, p: f64, q: f64, inverse_square: f64) -> [f64; 6] {
        use crate::math::dual::Dual;
        let [p, q] = [Dual::<2>::variable(p, 0), Dual::variable(q, 1)];
        let [half, inverse] = [inverse_square / 2.0, inverse_square.sqrt()].map(Dual::from);
        let [value, by_p, by_q] = self.value(row, [p, q], half, inverse);
        [value.value, by_p.value, by_q.value, by_p.slopes[0], by_p.slopes[1], by_q.slopes[1]]
    }
}
