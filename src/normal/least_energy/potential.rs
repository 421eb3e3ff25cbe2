//! Mutual potentials of four strips with one, and their derivatives by the squares of both half
//! lengths.

use super::displaced::Growths;
use super::kernel::{COEFFICIENTS, FIRST_EXPONENT, LAST_W, PIECE_BITS, SOFTEST, TABLE, Table};
use super::lanes::{Four, Lanes, Simd};
use super::pairs::Pairs;

/// Binary digits of w behind those that tell its piece, less those of a number of coefficients.
const DIGITS: i32 = (f64::MANTISSA_DIGITS - 1 - PIECE_BITS - COEFFICIENTS.trailing_zeros()) as i32;
/// Where a piece begins in the table.
const PIECE: u64 = ((TABLE - 1) * COEFFICIENTS) as u64;
/// Where the table begins.
const SMALLEST_W: f64 = 1.0 / (1_u64 << -FIRST_EXPONENT) as f64;

/// Potentials K [1/m] and their derivatives by the squares p of the half lengths of the four strips
/// and q of the one.
#[derive(Clone, Copy)]
pub(super) struct Potentials<S: Simd> {
    pub value: Four<S>,
    pub by_p: Four<S>,
    pub by_q: Four<S>,
    pub by_pp: Four<S>,
    pub by_pq: Four<S>,
    pub by_qq: Four<S>,
}

impl<S: Simd> Potentials<S> {
    /// Those of displaced strips, from these at the same h: with what h changes, of which there is
    /// this `growth`; second derivatives where they are wanted.
    #[inline(always)]
    fn displaced<const SECOND: bool>(
        self,
        simd: S,
        growth: &Growths<S>,
        [p, q]: [Four<S>; 2],
        per_sum: Four<S>,
    ) -> Self {
        let k = self;
        let rate = growth.rate * per_sum;
        let half = simd.splat(0.5);
        let zero = simd.splat(0.0);
        // By L and H: derivatives of K and of its derivatives by p and q.
        let by_l = (p * k.by_p).add_product(q, k.by_q);
        let by_h = zero - by_l.add_product(half, k.value);
        let more = rate * by_h;
        let (by_p, by_q) = (k.by_p + more, k.by_q + more);
        if !SECOND {
            return Self { by_p, by_q, ..k };
        }
        let p_by_l = k.by_p.add_product(p, k.by_pp).add_product(q, k.by_pq);
        let q_by_l = k.by_q.add_product(p, k.by_pq).add_product(q, k.by_qq);
        let p_by_h = zero - p_by_l.add_product(half, k.by_p);
        let q_by_h = zero - q_by_l.add_product(half, k.by_q);
        let l_by_h = zero - (p * p_by_l).add_product(q, q_by_l).add_product(half, by_l);
        let h_by_h = zero - l_by_h.add_product(half, by_h);
        let turn = (growth.bend - growth.rate) * per_sum * per_sum;
        let same = (rate * rate * h_by_h).add_product(turn, by_h);
        Self {
            by_p,
            by_q,
            by_pp: k.by_pp + (rate * p_by_h * 2.0) + same,
            by_pq: k.by_pq + rate * (p_by_h + q_by_h) + same,
            by_qq: k.by_qq + (rate * q_by_h * 2.0) + same,
            ..k
        }
    }
}

/// Value, derivative and half of the second derivative of a cubic at `x`.
#[inline(always)]
fn cubic<S: Simd>(c: &[Four<S>; 4], x: Four<S>) -> [Four<S>; 3] {
    let one = c[2].add_product(c[3], x);
    let two = one.add_product(c[3], x);
    let half_second = two.add_product(c[3], x);
    let inner = c[1].add_product(one, x);
    [c[0].add_product(inner, x), inner.add_product(two, x), half_second]
}

/// The coefficients of F and G at `w`, as the table has them.
#[inline(always)]
fn coefficients<S: Simd>(simd: S, table: &Table, pairs: &Pairs, w: Four<S>) -> [[Four<S>; 4]; 2] {
    let places = w.max(simd.splat(SMALLEST_W)).digits::<DIGITS>(pairs.row, PIECE);
    let [a, b, c, d] = places;
    let f = [row(table, a, 0), row(table, b, 0), row(table, c, 0), row(table, d, 0)];
    let e = [row(table, a, 4), row(table, b, 4), row(table, c, 4), row(table, d, 4)];
    [Four::columns(simd, f), Four::columns(simd, e)]
}

/// Four coefficients from one on.
#[inline(always)]
fn row(table: &Table, place: u64, from: usize) -> Lanes {
    let at = place as usize + from;
    [table[at], table[at + 1], table[at + 2], table[at + 3]]
}

/// 1/(2 h²), 1/h and what rounds the kink over t off, of four pairs of these sums of the squares and
/// their reciprocals, with the growth of h² by displacements where there are any.
#[inline(always)]
fn spacing<S: Simd, const SKEWED: bool>(
    simd: S,
    pairs: &Pairs,
    sums: [Four<S>; 2],
) -> ([Four<S>; 3], Option<Growths<S>>) {
    let (g, h) = (simd.four(&pairs.half_inverse_square), simd.four(&pairs.inverse));
    let soft_rate = simd.four(&pairs.soft_rate);
    if !SKEWED {
        return ([g, h, soft_rate], None);
    }
    let growth = Growths::new(simd, &pairs.displacement, sums);
    let less = growth.inverse;
    ([g * less, h * less.sqrt(), soft_rate * less], Some(growth))
}

/// Potentials of four strips of half lengths p^½ with one of q^½, displaced ones if `SKEWED`; second
/// derivatives are not there unless they are asked for.
#[inline(always)]
pub(super) fn potentials<S: Simd, const SECOND: bool, const SKEWED: bool>(
    simd: S,
    table: &Table,
    pairs: &Pairs,
    p: Four<S>,
    q: Four<S>,
) -> Potentials<S> {
    let sum = p + q;
    let sums = [sum, simd.splat(1.0) / sum];
    let (spacing, growth) = spacing::<S, SKEWED>(simd, pairs, sums);
    let abreast = potentials_at::<S, SECOND>(simd, table, pairs, spacing, [p, q], sums);
    match growth {
        Some(growth) => abreast.displaced::<SECOND>(simd, &growth, [p, q], sums[1]),
        None => abreast,
    }
}

/// Those of strips that lie abreast.
#[inline(always)]
fn potentials_at<S: Simd, const SECOND: bool>(
    simd: S,
    table: &Table,
    pairs: &Pairs,
    [g, h, soft_rate]: [Four<S>; 3],
    [p, q]: [Four<S>; 2],
    [sum, reciprocal]: [Four<S>; 2],
) -> Potentials<S> {
    let w = (sum * g).min(simd.splat(LAST_W));
    let [f, e] = coefficients(simd, table, pairs, w);
    let one = simd.splat(1.0);
    let t = (p - q) * reciprocal;
    // σ less what it is at least, its derivative by the sum of the squares, and r = sqrt(t² + σ).
    let soft = one / simd.four(&pairs.soft_base).add_product(soft_rate, sum);
    let softness = soft + SOFTEST;
    let root = softness.add_product(t, t).sqrt();
    let inverse_root = one / root;
    // F and its derivatives, the second one halved; and G.
    let [f, f1, f2] = cubic(&f, w);
    let [e, e1, e2] = cubic(&e, w);
    let value = h * f.add_product(root, e);
    let gh = g * h;
    let eh = e * h;
    let rate = inverse_root * reciprocal;
    let turn = t * rate;
    // - 2 ∂r/∂(p + q).
    let fall = soft * soft * soft_rate * inverse_root;
    let by_sum = (gh * f1.add_product(root, e1)).sub_product(eh * fall, simd.splat(0.5));
    let across = eh * turn;
    let even = by_sum.sub_product(across, t);
    let (by_p, by_q) = (even + across, even - across);
    if !SECOND {
        let none = simd.splat(0.0);
        return Potentials { value, by_p, by_q, by_pp: none, by_pq: none, by_qq: none };
    }
    let half_fall = fall * inverse_root * 0.5;
    let mixed = (gh * e1 * turn).sub_product(across, reciprocal).add_product(across, half_fall);
    let bend = eh * inverse_root * softness * (rate * rate);
    // r'' over 2, and what E and r have in the second derivative, halved.
    let steep = (soft * soft_rate).sub_product(half_fall, simd.splat(0.5)) * fall * 0.5;
    let of_root = (eh * steep).sub_product(gh * e1, fall * 0.5);
    let sums = (g * gh * f2.add_product(root, e2) + of_root).sub_product(t, mixed);
    let all = (sums + sums).add_product(t * t, bend);
    let same = all + bend;
    let skew = mixed.sub_product(t, bend);
    let skew = skew + skew;
    Potentials { value, by_p, by_q, by_pp: same + skew, by_pq: all - bend, by_qq: same - skew }
}

/// As [`potentials`], the values alone.
#[inline(always)]
pub(super) fn potential<S: Simd, const SKEWED: bool>(
    simd: S,
    table: &Table,
    pairs: &Pairs,
    p: Four<S>,
    q: Four<S>,
) -> Four<S> {
    let sum = p + q;
    let reciprocal = simd.splat(1.0) / sum;
    let ([g, h, soft_rate], _) = spacing::<S, SKEWED>(simd, pairs, [sum, reciprocal]);
    let w = (sum * g).min(simd.splat(LAST_W));
    let [f, e] = coefficients(simd, table, pairs, w);
    let t = (p - q) * reciprocal;
    let soft = simd.four(&pairs.soft_base).add_product(soft_rate, sum);
    let root = (simd.splat(1.0) / soft + SOFTEST).add_product(t, t).sqrt();
    let of = |k: usize| f[k].add_product(root, e[k]);
    h * of(0).add_product(w, of(1).add_product(w, of(2).add_product(w, of(3))))
}
