//! Influence of a strip with semi-elliptical pressure on the displacement of the half-space.
//!
//! A strip of half length a that carries p(x) = q sqrt(1 - (x/a)²) per unit of width displaces the
//! surface at distances Δx along and Δy across from its centre by q D(Δx/a, Δy/a)/(π E*), both
//! bodies together:
//!
//! ```text
//! D(ξ, σ) = ∫_-1^1 sqrt(1 - t²)/sqrt((ξ - t)² + σ²) dt
//! ξ = 0:    D = 2 s (K - E),  s² = 1 + σ², m = 1/s²;  d(a D)/da = 2 K/s
//! else:     D = M + 2 τ g + G (τ² + (0.6 τ³ + 0.5 τ⁴) m²),  τ = 1 - sqrt(1 - η²)
//!           M = 2 ζ (K - E),  g = K/ζ - M,  G = (g + M m/2)/3,  m = 1/ζ²
//! ```
//!
//! with the spheroidal coordinates ζ ± η = distances from the two ends of the strip over its half
//! length. Laplace's equation makes the terms up to τ² exact, and with them the logarithm on the
//! strip itself; those after it are fitted. The drop from the centre, D(0, σ) - D(ξ, σ), is 0.1 %
//! off at most, for every ξ and σ.

use crate::math::real::Real;

/// Where along a strip the displacement is compared with that at its centre, share of the half
/// length.
///
/// Pressures that are not quite semi-elliptical are met on the whole, not at the centre alone,
/// where slender patches would be off.
pub const STATION: f64 = 0.7;
/// Added to squared distances over squared half lengths, so that a cell of no width has a finite
/// logarithm [-].
const SQUARE_OFFSET: f64 = 1e-24;
/// Added to 1 - η², which rounding may take below zero [-].
const ACROSS_OFFSET: f64 = 1e-14;
/// Factors of τ³ and τ⁴.
const FITTED: [f64; 2] = [0.6, 0.5];
/// K = P - Q ln c in powers of c = 1 - m, 5e-7 off: P and Q.
const FIRST: [[f64; 4]; 2] = [
    [1.386_295_767_323, 0.098_248_990_749, 0.055_096_482_068, 0.031_154_642_428],
    [0.499_999_910_748, 0.124_665_910_229, 0.059_380_646_795, 0.010_581_661_183],
];
/// The same of (K - E)/m, 3e-6 off.
const DIFFERENCE: [[f64; 4]; 2] = [
    [0.386_303_316_717, 0.050_700_989_463, 0.181_806_206_713, 0.166_584_829_456],
    [0.499_999_431_992, 0.372_822_579_574, 0.277_524_671_773, 0.058_391_559_327],
];
/// ln x = 2 f (1 + f² (L0 + L1 f² + L2 f⁴)), f = (x - 1)/(x + 1), x between 1/√2 and √2: 2e-10 off.
const LOGARITHM: [f64; 3] = [0.333_334_083_717_78, 0.199_867_993_116_03, 0.149_806_980_824_2];

/// What a strip does at a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Influence<T = f64> {
    /// D, d(a D)/da and ∂D/∂ξ.
    pub d: T,
    pub slope: T,
    pub along: T,
}

/// The influence straight across at σ.
// Inside each instruction set or not at all: a call would not be vectorised.
#[allow(clippy::inline_always)]
#[inline(always)]
pub(super) fn centred_at<T: Real>(sigma: T) -> Influence<T> {
    let squared = sigma * sigma + SQUARE_OFFSET;
    let sum = squared + 1.0;
    let m = T::from(1.0) / sum;
    let [first, difference] = complete(squared * m, m);
    let double = sum.sqrt() * 2.0;
    Influence { d: double * difference, slope: double * first * m, along: T::from(0.0) }
}

/// The influence at ξ and σ.
// Inside each instruction set or not at all: a call would not be vectorised.
#[allow(clippy::inline_always)]
#[inline(always)]
pub(super) fn shifted_at<T: Real>(xi: T, sigma: T) -> Influence<T> {
    let squared = sigma * sigma + SQUARE_OFFSET;
    let far = ((xi + 1.0) * (xi + 1.0) + squared).sqrt();
    let near = ((xi - 1.0) * (xi - 1.0) + squared).sqrt();
    let zeta = (far + near) * 0.5;
    let product = far * near;
    let zeta2 = zeta * zeta;
    // ζ² (1 - η²)
    let root2_zeta2 = zeta2 - xi * xi + zeta2 * ACROSS_OFFSET;
    // One division for three.
    let all = T::from(1.0) / (zeta * root2_zeta2 * product);
    let inverse = all * root2_zeta2 * product;
    let share = all * zeta * root2_zeta2;
    let (eta, m) = (xi * inverse, inverse * inverse);
    let eta2 = eta * eta;
    let root = (root2_zeta2 * m).sqrt();
    let tau = -root + 1.0;
    // ζ² - 1, all rounding on the strip itself, and over ζ².
    let complement = squared * (all * zeta * product);
    let beyond = complement * zeta2;
    let [first, difference] = complete(complement, m);
    let zeroth = zeta * 2.0 * difference;
    let second = first - difference;
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
    let along = eta * (by_zeta + zeta * root * by_tau) * share;
    let across = root * (root * zeta * by_zeta - eta2 * beyond * by_tau) * share;
    Influence { d, slope: d - xi * along - across, along }
}

/// K and K - E for the complement of the parameter and the parameter.
// Inside each instruction set or not at all: a call would not be vectorised.
#[allow(clippy::inline_always)]
#[inline(always)]
fn complete<T: Real>(complement: T, m: T) -> [T; 2] {
    let log = complement.chain(short_ln(complement.value()), || 1.0 / complement.value());
    let split = |[p, q]: &[[f64; 4]; 2]| cubic(p, complement) - log * cubic(q, complement);
    [split(&FIRST), m * split(&DIFFERENCE)]
}

// Inside each instruction set or not at all: a call would not be vectorised.
#[allow(clippy::inline_always)]
#[inline(always)]
fn cubic<T: Real>(factors: &[f64; 4], at: T) -> T {
    let [a, b, c, d] = *factors;
    ((at * d + c) * at + b) * at + a
}

/// Bits of 2^52: an integer put into its low bits makes a float that much larger.
const INTEGER: u64 = 0x4330_0000_0000_0000;
const TWO_TO_52: f64 = 4_503_599_627_370_496.0;
/// Bits of 1/√2, at which a mantissa is taken to the next exponent, and from there to those of 1.
const SPLIT: u64 = 0x3fe6_a09e_667f_3bcd;
const BELOW_ONE: u64 = 0x3ff0_0000_0000_0000 - SPLIT;

/// ln x for finite, normal x > 0, as [`logarithm::ln`](crate::math::logarithm::ln) with fewer
/// terms: 2e-10 off.
// Inside each instruction set or not at all: a call would not be vectorised.
#[allow(clippy::inline_always)]
#[inline(always)]
fn short_ln(x: f64) -> f64 {
    // What is no number stays none.
    let shifted = x.to_bits().wrapping_add(BELOW_ONE);
    let exponent = f64::from_bits(INTEGER | (shifted >> 52)) - (TWO_TO_52 + 1023.0);
    let m = f64::from_bits((shifted & 0x000f_ffff_ffff_ffff) + SPLIT);
    let f = (m - 1.0) / (m + 1.0);
    let s = f * f;
    let [a, b, c] = LOGARITHM;
    exponent * std::f64::consts::LN_2 + 2.0 * f * (((s * c + b) * s + a) * s + 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::logarithm;
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
            let at = centred_at(sigma);
            assert_relative_eq!(at.d, integral(0.0, sigma), max_relative = 3e-5);
            // d(a D(σ/a))/da
            let step = 1e-4;
            let scaled = |a: f64| a * integral(0.0, sigma / a);
            let difference = (scaled(1.0 + step) - scaled(1.0 - step)) / (2.0 * step);
            assert_relative_eq!(at.slope, difference, max_relative = 1e-4);
        }
    }

    #[test]
    fn the_fall_along_a_strip_is_within_its_stated_error() {
        for xi in [0.3, 0.5, STATION, 0.9, 1.1, 1.5, 3.0] {
            for sigma in [0.03, 0.1, 0.3, 1.0, 3.0] {
                let exact = integral(0.0, sigma) - integral(xi, sigma);
                let drop = centred_at(sigma).d - shifted_at(xi, sigma).d;
                assert_relative_eq!(drop, exact, max_relative = 1e-3, epsilon = 1e-5);
            }
        }
    }

    #[test]
    fn both_formulas_agree_on_the_middle_of_a_strip() {
        for sigma in [1e-6, 1e-3, 0.1, 1.0, 30.0] {
            let (one, other) = (centred_at(sigma), shifted_at(0.0, sigma));
            assert_relative_eq!(one.d, other.d, max_relative = 1e-12);
            assert_relative_eq!(one.slope, other.slope, max_relative = 1e-4, epsilon = 1e-5);
            assert_relative_eq!(other.along, 0.0);
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
            assert_relative_eq!(at.along, along, max_relative = 1e-4, epsilon = 1e-5);
            // a D(ξ/a, σ/a)
            let slope =
                difference(&|h| (1.0 + h) * shifted_at(xi / (1.0 + h), sigma / (1.0 + h)).d);
            assert_relative_eq!(at.slope, slope, max_relative = 1e-4, epsilon = 1e-5);
        }
    }

    #[test]
    fn the_short_logarithm_is_within_its_stated_error() {
        for i in -3000..=0 {
            let x = 10f64.powf(f64::from(i) / 100.0) * 0.999_876;
            assert!((short_ln(x) - logarithm::ln(x)).abs() < 3e-10, "ln({x})");
        }
    }
}
