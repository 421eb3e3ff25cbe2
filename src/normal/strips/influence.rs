//! Influence of a strip with semi-elliptical pressure on the displacement of the half-space.
//!
//! A strip of half length a that carries p(x) = q sqrt(1 - (x/a)²) per unit of width displaces the surface at distances Δx along and
//! Δy across from its centre by q D(Δx/a, Δy/a)/(π E*), both bodies together:
//!
//! ```text
//! D(ξ, σ) = ∫_-1^1 sqrt(1 - t²)/sqrt((ξ - t)² + σ²) dt
//! ξ = 0:    D = 2 s (K - E),  s² = 1 + σ², m = 1/s²;  -∂²D/∂ξ² = D/s²;  d(a D)/da = 2 K/s
//! else:     D = M + 2 (1 - sqrt(1 - η²)) (K/ζ - M),  M = 2 ζ (K - E), m = 1/ζ²
//! ```
//!
//! with the spheroidal coordinates ζ ± η = distances from the two ends of the strip over its half length: exact to η², and in the logarithm
//! on the strip itself. Against the integral the second form is less than 1 % off for |η| ≤ 0.5; it only counts on yawed flanges.

use multiversion::multiversion;

use crate::math::elliptic::{complete, first_and_second_split};
use crate::math::quadrature::GaussLegendre;
use crate::math::real::Real;

/// Least squared distance over half length, where a node meets itself; those entries are not used.
const LEAST: f64 = 1e-24;
/// Greatest squared distance over half length: strips that shrink to nothing are as good as that far away.
const MOST: f64 = 1e24;

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
    /// D and d(a D)/da.
    pub d: T,
    pub slope: T,
    /// -∂²D/∂ξ² over D.
    pub bend: T,
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
    centred((sigma * sigma).at_least(LEAST))
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

/// -∂²D/∂x² over D [1/m²] of a source of half length `a` at distances `dx` along and `dy` across: see [`shifted_at`].
// Inside each instruction set or not at all: a call would not be vectorised.
#[allow(clippy::inline_always)]
#[inline(always)]
pub fn bend<T: Real>(a: T, dx: T, dy: T) -> T {
    let inverse = T::from(1.0) / a;
    shifted_at(dx * inverse, dy * inverse).bend * inverse * inverse
}

/// The influence at ξ and σ, with
///
/// ```text
/// -∂²D/∂ξ² = D (1 + c η²)/ζ²,   c = -3 + 3.35 m + 0.75 m³,   m = 1/ζ²
/// ```
///
/// exact for η = 0 and far away, fitted in between: 1 % off for η = 0.3, 6 % for η = 0.4, on the strip itself and less elsewhere.
// Inside each instruction set or not at all: a call would not be vectorised.
#[allow(clippy::inline_always)]
#[inline(always)]
pub fn shifted_at<T: Real>(xi: T, sigma: T) -> Influence<T> {
    let xi = xi.abs();
    let squared = (sigma * sigma).at_least(LEAST);
    let far = ((xi + 1.0) * (xi + 1.0) + squared).sqrt();
    let near = ((xi - 1.0) * (xi - 1.0) + squared).sqrt();
    let zeta = (far + near) * 0.5;
    let inverse = T::from(1.0) / zeta;
    let (eta, m) = (xi * inverse, inverse * inverse);
    let eta2 = eta * eta;
    let root = (-eta2 + 1.0).at_least(1e-12).sqrt();
    // ζ² - 1 = σ²/(1 - η²), more than σ²: on the strip the former difference is all rounding.
    let Influence { d, slope, .. } = centred((zeta * zeta - 1.0).max(squared));
    let share = (-root + 1.0) * 2.0;
    Influence {
        d: d + share * (slope * 0.5 - d),
        slope: slope * root,
        bend: (eta2 * (m * (m * 0.75 * m + 3.35) - 3.0) + 1.0) * m,
    }
}

/// The influence at ξ = 0 for σ².
// Inside each instruction set or not at all: a call would not be vectorised.
#[allow(clippy::inline_always)]
#[inline(always)]
fn centred<T: Real>(squared: T) -> Influence<T> {
    let squared = squared.at_most(MOST);
    let sum = squared + 1.0;
    let bend = T::from(1.0) / sum;
    let s = sum.sqrt();
    let complement = squared * bend;
    let [k0, k1, e0, e1] = first_and_second_split(complement);
    let log = complement.normal_ln();
    let first = k0 - log * k1;
    let second = e0 - log * e1;
    let double = s * 2.0;
    Influence { d: double * (first - second), slope: double * first * bend, bend }
}

/// The integrals over the distance across, Ψ(σ) = ∫_0^σ D and ∫_0^σ D/(1 + σ²), tabulated over ln σ with exact slopes.
///
/// Cubic interpolation at steps of 0.05: 2e-8 of the value.
#[derive(Clone, Debug)]
pub struct Integrals {
    /// (value, derivative by ln σ) of both integrals.
    table: Vec<[f64; 4]>,
}

const TABLE_START: f64 = -18.0;
const TABLE_STEP: f64 = 0.05;
const TABLE_LENGTH: usize = 600;

impl Integrals {
    /// Makes the table.
    #[must_use]
    pub fn new() -> Self {
        let rule = GaussLegendre::new(4);
        let exact = |sigma: f64| {
            let squared = sigma * sigma;
            let c = complete(squared / (1.0 + squared));
            2.0 * (1.0 + squared).sqrt() * c.first_minus_second
        };
        let start = TABLE_START.exp();
        // D = 2 ln 4 - 2 - 2 ln σ close to the strip.
        let first = start * (4.0 * 2f64.ln() - 2.0 * TABLE_START);
        let mut sums = [first, first];
        let mut table = Vec::with_capacity(TABLE_LENGTH);
        for i in 0..TABLE_LENGTH {
            let at = TABLE_START + TABLE_STEP * i as f64;
            let sigma = at.exp();
            let slope = sigma * exact(sigma);
            table.push([sums[0], slope, sums[1], slope / (1.0 + sigma * sigma)]);
            for (node, weight) in rule.nodes.iter().zip(&rule.weights) {
                let sigma = (at + 0.5 * TABLE_STEP * (1.0 + node)).exp();
                let value = 0.5 * TABLE_STEP * weight * sigma * exact(sigma);
                sums[0] += value;
                sums[1] += value / (1.0 + sigma * sigma);
            }
        }
        Self { table }
    }

    /// Both integrals at σ > 0, and D there.
    #[must_use]
    pub fn at<T: Real>(&self, sigma: T) -> [T; 3] {
        let log = sigma.at_least(f64::MIN_POSITIVE).ln();
        let last = (TABLE_LENGTH - 2) as f64;
        let place = (log - TABLE_START) / TABLE_STEP;
        if place < 0.0 {
            // Below the table its first term holds to rounding.
            let value = sigma * (log * -2.0 + 4.0 * 2f64.ln());
            return [value, value, log * -2.0 + (4.0 * 2f64.ln() - 2.0)];
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
        let slope = (-t + 1.0) * a[1] + t * b[1];
        [cubic(0) + beyond * b[1], cubic(2), slope / sigma]
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
    fn the_skewed_influence_is_within_its_stated_error() {
        for xi in [0.0, 0.1, 0.3, 0.5] {
            for sigma in [0.03, 0.1, 0.3, 1.0, 3.0] {
                let (mut d, mut slope) = ([0.0], [0.0]);
                skewed([0.0, 0.0], &[xi], &[sigma], &[1.0], &mut d, &mut slope);
                assert_relative_eq!(d[0], integral(xi, sigma), max_relative = 1e-2);
            }
        }
    }

    #[test]
    fn the_table_holds_the_integral_of_the_influence() {
        let table = Integrals::new();
        for sigma in [1e-9, 1e-6, 0.013, 0.7, 5.3, 321.0] {
            let [value, weighted, _] = table.at(sigma);
            let rule = GaussLegendre::new(40);
            let (mut sum, mut weighted_sum) = (0.0, 0.0);
            // σ = e^-v: the logarithm becomes smooth.
            let (low, high) = (-40.0, sigma.ln());
            for cell in 0..60 {
                let (a, h) = (low + (high - low) * f64::from(cell) / 60.0, (high - low) / 60.0);
                for (node, weight) in rule.nodes.iter().zip(&rule.weights) {
                    let s = (a + 0.5 * h * (1.0 + node)).exp();
                    let c = complete(s * s / (1.0 + s * s));
                    let d = 2.0 * (1.0 + s * s).sqrt() * c.first_minus_second;
                    sum += 0.5 * h * weight * s * d;
                    weighted_sum += 0.5 * h * weight * s * d / (1.0 + s * s);
                }
            }
            assert_relative_eq!(value, sum, max_relative = 1e-6);
            assert_relative_eq!(weighted, weighted_sum, max_relative = 1e-6);
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
