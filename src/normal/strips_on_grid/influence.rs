//! Influence of a strip with semi-elliptical pressure on the displacement of the half-space.
//!
//! A strip of half length a that carries p(x) = q sqrt(1 - (x/a)²) per unit of width displaces the surface at distances Δx along and
//! Δy across from its centre by q D(Δx/a, Δy/a)/(π E*), both bodies together:
//!
//! ```text
//! D(ξ, σ) = ∫_-1^1 sqrt(1 - t²)/sqrt((ξ - t)² + σ²) dt
//! ξ = 0:    D = 2 s (K - E),  s² = 1 + σ², m = 1/s²;  d(a D)/da = 2 K/s
//! else:     D = M + 2 τ g + G (τ² + (0.6 τ³ + 0.5 τ⁴) m²),  τ = 1 - sqrt(1 - η²)
//!           M = 2 ζ (K - E),  g = K/ζ - M,  G = (g + M m/2)/3,  m = 1/ζ²
//! ```
//!
//! with the spheroidal coordinates ζ ± η = distances from the two ends of the strip over its half length. Laplace's equation makes the terms
//! up to τ² exact, and with them the logarithm on the strip itself; those after it are fitted. The fall from the centre, D(0, σ) - D(ξ, σ), is
//! 0.1 % off at most, for every ξ and σ.

use multiversion::multiversion;

use crate::math::elliptic::{complete, first_and_second_split};
use crate::math::quadrature::GaussLegendre;
use crate::math::real::Real;

/// What squared distances over half lengths are more than they are: where a node meets itself there is no logarithm. Those entries are not used.
const LEAST: f64 = 1e-24;
/// The same for 1 - η², which rounding may take below zero.
const LEAST_ACROSS: f64 = 1e-14;
/// Factors of τ³ and τ⁴.
const FITTED: [f64; 2] = [0.6, 0.5];
/// Polynomials in c = σ²/(1 + σ²) of a strip's fall along itself, to [`STATION`]: W = (R - L ln c)/(1 + σ²)^(3/2), 3e-5 off.
const REGULAR: [f64; 5] = [
    0.096_999_662_635,
    0.358_785_903_426,
    -1.666_682_358_609,
    1.262_334_982_842,
    0.333_406_510_947,
];
const LOGARITHMIC: [f64; 4] =
    [STATION_LOGARITHM, -0.032_020_367_424, 0.691_695_405_367, 1.203_516_755_636];
/// Polynomial of the fall of the factor of the logarithm, over (1 + σ²)²: 2e-4 off.
const LOG_FALL: [f64; 6] = [
    STATION_LOGARITHM,
    0.299_547_019_189,
    -0.120_334_585_504,
    0.432_152_398_157,
    -0.387_879_834_162,
    0.225_532_632_249,
];
/// 1 - sqrt(1 - [`STATION`]²).
const STATION_LOGARITHM: f64 = 0.285_857_157_145_715;

/// Where along a strip the displacement is compared with that at its centre, share of the half length.
///
/// Pressures that are not quite semi-elliptical are met on the whole, not at the centre alone: with 0.7 the normal force of slender patches
/// is within 0.25 %, with the curvature at the centre within 2 %.
pub const STATION: f64 = 0.7;

/// D and d(a D)/da of sources at `y` with half lengths `a` > 0 for points straight across at `at`.
#[multiversion(targets("x86_64+avx512f+avx512dq", "x86_64+avx2", "aarch64+neon"))]
pub fn straight(at: f64, y: &[f64], a: &[f64], d: &mut [f64], slope: &mut [f64]) {
    for (((y, a), d), slope) in y.iter().zip(a).zip(d.iter_mut()).zip(slope.iter_mut()) {
        (*d, *slope) = straight_pair(y - at, *a);
    }
}

/// What a source does to a point.
#[derive(Clone, Copy, Debug)]
pub struct Influence<T = f64> {
    /// D, d(a D)/da and ∂D/∂ξ.
    pub d: T,
    pub slope: T,
    pub along: T,
    /// The same of the factor F of -ln σ² in D, continued away from the strip as F = sqrt(1 - η²)/ζ².
    pub log: T,
    pub log_slope: T,
    pub log_along: T,
}

/// How much less a source does at [`STATION`] ahead of and behind a point of another strip, on the mean.
#[derive(Clone, Copy, Debug)]
pub struct Fall<T = f64> {
    /// What it does less, and its derivatives as in [`Influence`], that by ξ being the one by the logarithm of the half length of the other strip.
    pub d: T,
    pub slope: T,
    pub pull: T,
    pub log: T,
    pub log_slope: T,
    pub log_pull: T,
}

/// D and d(a D)/da of a source of half length `a` straight across at a distance.
// Inside each instruction set or not at all: a call would not be vectorised.
#[allow(clippy::inline_always)]
#[inline(always)]
pub fn straight_pair<T: Real>(distance: T, a: T) -> (T, T) {
    let Influence { d, slope, .. } = centred_at(distance / a);
    (d, slope)
}

/// The influence straight across at σ.
// Inside each instruction set or not at all: a call would not be vectorised.
#[allow(clippy::inline_always)]
#[inline(always)]
pub fn centred_at<T: Real>(sigma: T) -> Influence<T> {
    let squared = sigma * sigma + LEAST;
    let sum = squared + 1.0;
    let m = T::from(1.0) / sum;
    let s = sum.sqrt();
    let [first, _, difference] = complete_integrals(squared * m);
    let double = s * 2.0;
    Influence {
        d: double * difference,
        slope: double * first * m,
        along: T::from(0.0),
        log: m,
        log_slope: m * (m * -2.0 + 3.0),
        log_along: T::from(0.0),
    }
}

/// As [`straight`], for points `x` along from the track origin and sources centred at `xs`.
#[multiversion(targets("x86_64+avx512f+avx512dq", "x86_64+avx2", "aarch64+neon"))]
pub fn skewed(at: [f64; 2], xs: &[f64], y: &[f64], a: &[f64], d: &mut [f64], slope: &mut [f64]) {
    for ((((x, y), a), d), slope) in xs.iter().zip(y).zip(a).zip(d.iter_mut()).zip(slope.iter_mut())
    {
        (*d, *slope) = skewed_pair(x - at[0], y - at[1], *a);
    }
}

/// D and d(a D)/da of a source of half length `a` at distances `dx` along and `dy` across.
// Inside each instruction set or not at all: a call would not be vectorised.
#[allow(clippy::inline_always)]
#[inline(always)]
pub fn skewed_pair<T: Real>(dx: T, dy: T, a: T) -> (T, T) {
    let inverse = T::from(1.0) / a;
    let Influence { d, slope, .. } = shifted_at(dx * inverse, dy * inverse);
    (d, slope)
}

/// The influence at ξ and σ.
// Inside each instruction set or not at all: a call would not be vectorised.
#[allow(clippy::inline_always)]
#[inline(always)]
pub fn shifted_at<T: Real>(xi: T, sigma: T) -> Influence<T> {
    let squared = sigma * sigma + LEAST;
    let far = ((xi + 1.0) * (xi + 1.0) + squared).sqrt();
    let near = ((xi - 1.0) * (xi - 1.0) + squared).sqrt();
    let zeta = (far + near) * 0.5;
    let inverse = T::from(1.0) / zeta;
    let (eta, m) = (xi * inverse, inverse * inverse);
    let eta2 = eta * eta;
    let root2 = -eta2 + (1.0 + LEAST_ACROSS);
    let root = root2.sqrt();
    let tau = -root + 1.0;
    // ζ² - 1, all rounding on the strip itself.
    let beyond = squared / root2;
    let [first, second, difference] = complete_integrals(beyond * m);
    let zeroth = zeta * 2.0 * difference;
    let linear = first * inverse - zeroth;
    let square = (linear + zeroth * m * 0.5) * (1.0 / 3.0);
    let m2 = m * m;
    let tau2 = tau * tau;
    let fitted = tau2 * tau * (tau * FITTED[1] + FITTED[0]) * m2;
    let d = zeroth + tau * 2.0 * linear + square * (tau2 + fitted);
    // (ζ² - 1) ∂/∂ζ of the three, and of D; and ∂D/∂τ.
    let by_zeta0 = zeta * zeroth - first * 2.0;
    let by_zeta1 = -(second + by_zeta0);
    let by_zeta2 = (by_zeta1 + (by_zeta0 * 0.5 - beyond * zeroth * inverse) * m) * (1.0 / 3.0);
    let by_zeta = by_zeta0 + tau * 2.0 * by_zeta1 + by_zeta2 * (tau2 + fitted)
        - square * fitted * beyond * inverse * 4.0;
    let by_tau = linear * 2.0
        + square * (tau * 2.0 + tau2 * (tau * (4.0 * FITTED[1]) + 3.0 * FITTED[0]) * m2);
    let share = T::from(1.0) / (far * near);
    let along = eta * (by_zeta + zeta * root * by_tau) * share;
    let across = root * (root * zeta * by_zeta - eta2 * beyond * by_tau) * share;
    let log = root * m;
    Influence {
        d,
        slope: d - xi * along - across,
        along,
        log,
        log_slope: log * (share * (beyond * 2.0 + eta2) + 1.0),
        log_along: -(log * eta * share * (beyond * inverse * 2.0 + zeta)),
    }
}

/// What takes the singularity out of the sums at a strip: its own influence at σ, and its fall along itself to [`STATION`].
#[derive(Clone, Copy, Debug)]
pub struct Own<T = f64> {
    /// D, d(a D)/da and the factor of the logarithm.
    pub d: T,
    pub slope: T,
    pub log: T,
    /// Fall W and d(a W)/da, and those of the factor of the logarithm.
    pub fall: T,
    pub fall_slope: T,
    pub log_fall: T,
    pub log_fall_slope: T,
}

/// The influence of a strip in itself at σ.
// Inside each instruction set or not at all: a call would not be vectorised.
#[allow(clippy::inline_always)]
#[inline(always)]
pub fn own_at<T: Real>(sigma: T) -> Own<T> {
    let squared = sigma * sigma + LEAST;
    let sum = squared + 1.0;
    let m = T::from(1.0) / sum;
    let s = sum.sqrt();
    let complement = squared * m;
    let log = complement.normal_ln();
    let [first, _, difference] = with_logarithm(complement, log);
    let [r, l] = [value_and_slope(&REGULAR, complement), value_and_slope(&LOGARITHMIC, complement)];
    let m2 = m * m;
    let share = m2 * s;
    let factor = value_and_slope(&LOG_FALL, complement);
    let log_fall = m2 * factor[0];
    let value = r[0] - log * l[0];
    let fall = share * value;
    // σ ∂W/∂σ
    let by_sigma =
        (m * (complement * (r[1] - log * l[1]) - l[0]) * 2.0 - complement * value * 3.0) * share;
    Own {
        d: s * 2.0 * difference,
        slope: s * 2.0 * first * m,
        log: m,
        fall,
        fall_slope: fall - by_sigma,
        log_fall,
        log_fall_slope: log_fall + complement * (log_fall * 4.0 - m2 * m * factor[1] * 2.0),
    }
}

/// A polynomial and its derivative.
// Inside each instruction set or not at all: a call would not be vectorised.
#[allow(clippy::inline_always)]
#[inline(always)]
fn value_and_slope<T: Real, const N: usize>(factors: &[f64; N], at: T) -> [T; 2] {
    let (mut value, mut slope) = (T::from(factors[N - 1]), T::from(0.0));
    for &factor in factors[..N - 1].iter().rev() {
        slope = slope * at + value;
        value = value * at + factor;
    }
    [value, slope]
}

/// How much less than `centre`, its influence straight across, a source does on the mean at `station`, in its half lengths, ahead of and
/// behind a point at σ.
// Inside each instruction set or not at all: a call would not be vectorised.
#[allow(clippy::inline_always)]
#[inline(always)]
pub fn fall<T: Real>(centre: &Influence<T>, station: T, sigma: T) -> Fall<T> {
    let at = shifted_at(station, sigma);
    let [d, slope] = [centre.d - at.d, centre.slope - at.slope];
    Fall {
        d,
        slope,
        pull: -(station * at.along),
        log: centre.log - at.log,
        log_slope: centre.log_slope - at.log_slope,
        log_pull: -(station * at.log_along),
    }
}

/// As [`fall`], for a point shifted by ξ.
// Inside each instruction set or not at all: a call would not be vectorised.
#[allow(clippy::inline_always)]
#[inline(always)]
pub fn shifted_fall<T: Real>(centre: &Influence<T>, station: T, xi: T, sigma: T) -> Fall<T> {
    let [ahead, behind] = [xi + station, xi - station];
    let (a, b) = (shifted_at(ahead, sigma), shifted_at(behind, sigma));
    let mean = |a: T, b: T| (a + b) * 0.5;
    let moved = |a: T, b: T| (a - b) * 0.5 * station;
    let (d, slope) = (centre.d - mean(a.d, b.d), centre.slope - mean(a.slope, b.slope));
    Fall {
        d,
        slope,
        pull: -moved(a.along, b.along),
        log: centre.log - mean(a.log, b.log),
        log_slope: centre.log_slope - mean(a.log_slope, b.log_slope),
        log_pull: -moved(a.log_along, b.log_along),
    }
}

/// K, E and K - E for the complement of the parameter.
// Inside each instruction set or not at all: a call would not be vectorised.
#[allow(clippy::inline_always)]
#[inline(always)]
fn complete_integrals<T: Real>(complement: T) -> [T; 3] {
    with_logarithm(complement, complement.normal_ln())
}

/// The same with the logarithm of the complement.
// Inside each instruction set or not at all: a call would not be vectorised.
#[allow(clippy::inline_always)]
#[inline(always)]
fn with_logarithm<T: Real>(complement: T, log: T) -> [T; 3] {
    let [k0, k1, e0, e1] = first_and_second_split(complement);
    let (first, second) = (k0 - log * k1, e0 - log * e1);
    [first, second, first - second]
}

/// The integrals over the distance across, Ψ(σ) = ∫_0^σ D and ∫_0^σ W, tabulated over ln σ with exact slopes.
///
/// Cubic interpolation at steps of 0.05: 2e-8 of the value.
#[derive(Clone, Debug)]
pub struct Integrals {
    /// (value, derivative by ln σ) of both integrals.
    table: Vec<[f64; 4]>,
}

/// What is integrated, close to the strip: `constant` - 2 `factor` ln σ.
#[derive(Clone, Copy, Debug)]
struct Near {
    constant: f64,
    factor: f64,
}

/// D and W close to the strip.
const NEAR: [Near; 2] = [
    Near { constant: 4.0 * std::f64::consts::LN_2 - 2.0, factor: 1.0 },
    Near { constant: REGULAR[0], factor: STATION_LOGARITHM },
];

impl Near {
    fn influence<T: Real>(&self, log: T) -> T {
        log * (-2.0 * self.factor) + self.constant
    }

    fn integral<T: Real>(&self, sigma: T, log: T) -> T {
        sigma * (log * (-2.0 * self.factor) + (self.constant + 2.0 * self.factor))
    }
}

const TABLE_START: f64 = -18.0;
const TABLE_STEP: f64 = 0.05;
const TABLE_LENGTH: usize = 600;

impl Integrals {
    /// Makes the table.
    #[must_use]
    pub fn new() -> Self {
        let rule = GaussLegendre::new(4);
        let influences = |sigma: f64| {
            let squared = sigma * sigma;
            let c = complete(squared / (1.0 + squared));
            [2.0 * (1.0 + squared).sqrt() * c.first_minus_second, own_at(sigma).fall]
        };
        let mut sums = NEAR.map(|near| near.integral(TABLE_START.exp(), TABLE_START));
        let mut table = Vec::with_capacity(TABLE_LENGTH);
        for i in 0..TABLE_LENGTH {
            let at = TABLE_START + TABLE_STEP * i as f64;
            let sigma = at.exp();
            let [d, fall] = influences(sigma);
            table.push([sums[0], sigma * d, sums[1], sigma * fall]);
            for (node, weight) in rule.nodes.iter().zip(&rule.weights) {
                let sigma = (at + 0.5 * TABLE_STEP * (1.0 + node)).exp();
                let width = 0.5 * TABLE_STEP * weight * sigma;
                for (sum, influence) in sums.iter_mut().zip(influences(sigma)) {
                    *sum += width * influence;
                }
            }
        }
        Self { table }
    }

    /// Both integrals at σ > 0, each with D or W there.
    #[must_use]
    pub fn at<T: Real>(&self, sigma: T) -> [[T; 2]; 2] {
        let log = sigma.at_least(f64::MIN_POSITIVE).ln();
        let last = (TABLE_LENGTH - 2) as f64;
        let place = (log - TABLE_START) / TABLE_STEP;
        if place < 0.0 {
            return NEAR.map(|near| [near.integral(sigma, log), near.influence(log)]);
        }
        let cell = place.value().min(last).floor();
        // Beyond the table only the logarithm grows: its slope carries on.
        let t = (place - cell).at_most(1.0);
        let beyond = (place - cell - t) * TABLE_STEP;
        let ([a, b], h) = ([self.table[cell as usize], self.table[cell as usize + 1]], TABLE_STEP);
        let cubic = |k: usize| {
            let (u, v) = (-t + 1.0, t);
            u * u * (v * 2.0 + 1.0) * a[k]
                + v * v * (u * 2.0 + 1.0) * b[k]
                + u * h * v * (u * a[k + 1] - v * b[k + 1])
        };
        [0, 2].map(|k| {
            let slope = (-t + 1.0) * a[k + 1] + t * b[k + 1];
            [cubic(k) + beyond * b[k + 1], slope / sigma]
        })
    }
}

/// C_ij = (∫ ln|t_i - t| over the share of node j) - w_j ln|t_i - t_j| for the nodes of `rule`: what a Gauss-Legendre sum of a smooth
/// function times the logarithm lacks. Rows i, zero on the diagonal.
///
/// From ∫_-1^1 ln|x - t| P_l(t) dt = 2 (Q_{l+1} - Q_{l-1})/(2 l + 1), l ≥ 1.
#[must_use]
pub fn logarithm_corrections(rule: &GaussLegendre) -> Vec<f64> {
    let n = rule.nodes.len();
    let legendre: Vec<Vec<f64>> = rule.nodes.iter().map(|&x| recursion(1.0, x, x, n)).collect();
    let mut corrections = vec![0.0; n * n];
    for (i, &x) in rule.nodes.iter().enumerate() {
        let q0 = 0.5 * ((1.0 + x) / (1.0 - x)).ln();
        let q = recursion(q0, x * q0 - 1.0, x, n + 1);
        let moment = |l: usize| {
            if l == 0 {
                (1.0 + x) * (1.0 + x).ln() + (1.0 - x) * (1.0 - x).ln() - 2.0
            } else {
                2.0 * (q[l + 1] - q[l - 1]) / (2 * l + 1) as f64
            }
        };
        for j in 0..n {
            if j == i {
                continue;
            }
            let product: f64 =
                (0..n).map(|l| 0.5 * (2 * l + 1) as f64 * legendre[j][l] * moment(l)).sum();
            corrections[i * n + j] = rule.weights[j] * (product - (x - rule.nodes[j]).abs().ln());
        }
    }
    corrections
}

/// Values 0 to `last` of a solution of Legendre's recursion at x.
fn recursion(zeroth: f64, first: f64, x: f64, last: usize) -> Vec<f64> {
    let mut values = vec![zeroth, first];
    for l in 1..last {
        let l_float = l as f64;
        values.push(
            ((2.0 * l_float + 1.0) * x * values[l] - l_float * values[l - 1]) / (l_float + 1.0),
        );
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// D by the midpoint rule in the angle, the singularity taken out.
    fn integral(xi: f64, sigma: f64) -> f64 {
        let n = 4000;
        let s0 = (1.0 - xi * xi).max(0.0).sqrt();
        let mut sum = 0.0;
        for i in 0..n {
            let angle = (f64::from(i) + 0.5) * std::f64::consts::PI / f64::from(n);
            let (t, s) = (angle.cos(), angle.sin());
            sum += (s - s0) * s / ((xi - t).powi(2) + sigma * sigma).sqrt();
        }
        sum * std::f64::consts::PI / f64::from(n)
            + s0 * (((1.0 - xi) / sigma).asinh() + ((1.0 + xi) / sigma).asinh())
    }

    #[test]
    fn the_centred_influence_is_its_integral() {
        for sigma in [0.01, 0.1, 0.5, 1.0, 3.0, 10.0] {
            let (mut d, mut slope) = ([0.0], [0.0]);
            straight(0.0, &[sigma], &[1.0], &mut d, &mut slope);
            assert_relative_eq!(d[0], integral(0.0, sigma), max_relative = 3e-5);
            // d(a D(σ/a))/da
            let step = 1e-4;
            let at = |a: f64| a * integral(0.0, sigma / a);
            let difference = (at(1.0 + step) - at(1.0 - step)) / (2.0 * step);
            assert_relative_eq!(slope[0], difference, max_relative = 1e-4);
        }
    }

    #[test]
    fn the_fall_along_a_strip_is_within_its_stated_error() {
        for xi in [0.3, 0.5, STATION, 0.9, 1.1, 1.5, 3.0] {
            for sigma in [0.03, 0.1, 0.3, 1.0, 3.0] {
                let centre = centred_at(sigma);
                let exact = integral(0.0, sigma) - integral(xi, sigma);
                let fall = fall(&centre, xi, sigma).d;
                assert_relative_eq!(fall, exact, max_relative = 1e-3, epsilon = 1e-5);
                let (mut d, mut slope) = ([0.0], [0.0]);
                skewed([0.0, 0.0], &[xi], &[sigma], &[1.0], &mut d, &mut slope);
                assert_relative_eq!(centre.d - d[0], fall, max_relative = 1e-12);
            }
        }
    }

    #[test]
    fn derivatives_are_those_of_the_influence() {
        let step = 1e-5;
        for (xi, sigma) in
            [(0.0, 0.2), (0.4, 0.05), (-0.7, 0.5), (0.95, 0.1), (1.3, 0.2), (-4.0, 2.0)]
        {
            let at = shifted_at(xi, sigma);
            let difference = |f: &dyn Fn(f64) -> f64| (f(step) - f(-step)) / (2.0 * step);
            let along = difference(&|h| shifted_at(xi + h, sigma).d);
            assert_relative_eq!(at.along, along, max_relative = 1e-5, epsilon = 1e-7);
            let log_along = difference(&|h| shifted_at(xi + h, sigma).log);
            assert_relative_eq!(at.log_along, log_along, max_relative = 1e-5, epsilon = 1e-7);
            // a D(ξ/a, σ/a) and, the pressure going with a, a F(ξ/a, σ/a).
            let scaled = |h: f64| shifted_at(xi / (1.0 + h), sigma / (1.0 + h));
            let slope = difference(&|h| (1.0 + h) * scaled(h).d);
            assert_relative_eq!(at.slope, slope, max_relative = 1e-5, epsilon = 1e-7);
            let log_slope = difference(&|h| (1.0 + h) * scaled(h).log);
            assert_relative_eq!(at.log_slope, log_slope, max_relative = 1e-5, epsilon = 1e-7);
        }
    }

    #[test]
    fn derivatives_are_those_of_the_fall() {
        let step = 1e-5;
        for (station, xi, sigma) in [(0.7, 0.1, 0.05), (0.4, -0.3, 0.5), (1.2, 0.05, 0.2)] {
            let at = |station: f64, xi: f64, sigma: f64| {
                shifted_fall(&shifted_at(xi, sigma), station, xi, sigma)
            };
            let here = at(station, xi, sigma);
            let difference = |f: &dyn Fn(f64) -> f64| (f(step) - f(-step)) / (2.0 * step);
            let pull = difference(&|h| at(station * (1.0 + h), xi, sigma).d);
            assert_relative_eq!(here.pull, pull, max_relative = 1e-5, epsilon = 1e-7);
            let log_pull = difference(&|h| at(station * (1.0 + h), xi, sigma).log);
            assert_relative_eq!(here.log_pull, log_pull, max_relative = 1e-5, epsilon = 1e-7);
            // With the distance between the strips, the station held.
            let wider =
                difference(&|h| (1.0 + h) * at(station, xi * (1.0 + h), sigma * (1.0 + h)).d);
            let held = 2.0 * here.d - here.slope - here.pull;
            assert_relative_eq!(held, wider, max_relative = 1e-5, epsilon = 1e-7);
        }
        // Without a shift both are the same.
        let centre = shifted_at(0.0, 0.3);
        let (one, other) = (fall(&centre, 0.6, 0.3), shifted_fall(&centre, 0.6, 0.0, 0.3));
        assert_relative_eq!(one.d, other.d, max_relative = 1e-12);
        assert_relative_eq!(one.slope, other.slope, max_relative = 1e-12);
        assert_relative_eq!(one.pull, other.pull, max_relative = 1e-12);
    }

    #[test]
    fn a_strip_falls_along_itself_as_along_others() {
        assert_relative_eq!(STATION_LOGARITHM, 1.0 - (1.0 - STATION * STATION).sqrt());
        for sigma in [1e-5, 1e-3, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0] {
            let (own, centre) = (own_at(sigma), centred_at(sigma));
            let fall = fall(&centre, STATION, sigma);
            assert_relative_eq!(own.d, centre.d, max_relative = 1e-14);
            assert_relative_eq!(own.slope, centre.slope, max_relative = 1e-14);
            assert_relative_eq!(own.fall, fall.d, max_relative = 3e-5, epsilon = 2e-6);
            assert_relative_eq!(own.log_fall, fall.log, max_relative = 2e-4);
            let step = 1e-5 * sigma;
            let difference = own_at(sigma + step).fall - own_at(sigma - step).fall;
            let slope = own.fall - sigma * difference / (2.0 * step);
            assert_relative_eq!(own.fall_slope, slope, max_relative = 1e-6);
            let difference = own_at(sigma + step).log_fall - own_at(sigma - step).log_fall;
            let slope = own.log_fall - sigma * difference / (2.0 * step);
            assert_relative_eq!(own.log_fall_slope, slope, max_relative = 1e-6);
        }
    }

    #[test]
    fn the_table_holds_the_integrals_of_the_influence() {
        let table = Integrals::new();
        for sigma in [1e-9, 1e-6, 0.013, 0.7, 5.3, 321.0] {
            let rule = GaussLegendre::new(40);
            let mut sums = [0.0; 2];
            // σ = e^-v: the logarithm becomes smooth.
            let (low, high) = (-40.0, sigma.ln());
            for cell in 0..60 {
                let (a, h) = (low + (high - low) * f64::from(cell) / 60.0, (high - low) / 60.0);
                for (node, weight) in rule.nodes.iter().zip(&rule.weights) {
                    let s = (a + 0.5 * h * (1.0 + node)).exp();
                    let own = own_at(s);
                    sums[0] += 0.5 * h * weight * s * own.d;
                    sums[1] += 0.5 * h * weight * s * own.fall;
                }
            }
            // Single influences stay what they are below 1e-12 and lose digits far away, where the table has them.
            let share = if (1e-7..10.0).contains(&sigma) { 1e-6 } else { 1e-3 };
            for (found, sum) in table.at(sigma).into_iter().zip(sums) {
                assert_relative_eq!(found[0], sum, max_relative = share);
            }
            let own = own_at(sigma);
            for (found, own) in table.at(sigma).into_iter().zip([own.d, own.fall]) {
                assert_relative_eq!(found[1], own, max_relative = 1e-2);
            }
        }
    }

    #[test]
    fn corrected_sums_integrate_a_polynomial_times_the_logarithm() {
        let rule = GaussLegendre::new(9);
        let corrections = logarithm_corrections(&rule);
        for i in 0..9 {
            let x = rule.nodes[i];
            // φ = t - t_i vanishes at the node; ∫ (t - x) ln|t - x| = [u² (2 ln|u| - 1)/4]
            let sum: f64 = (0..9)
                .filter(|&j| j != i)
                .map(|j| {
                    let u = rule.nodes[j] - x;
                    u * (rule.weights[j] * u.abs().ln() + corrections[i * 9 + j])
                })
                .sum();
            let antiderivative = |u: f64| u * u * (2.0 * u.abs().ln() - 1.0) / 4.0;
            assert_relative_eq!(
                sum,
                antiderivative(1.0 - x) - antiderivative(-1.0 - x),
                epsilon = 1e-12
            );
        }
    }
}
