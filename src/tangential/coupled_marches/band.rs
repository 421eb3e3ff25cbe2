//! Gradient of displacement along a strip that the tractions of a band beside it cause.
//!
//! Tractions of one strip, spread evenly over a band that begins at the line of the receiving strip
//! and ends at the lateral distance s, have at the distance x ahead of them the gradients
//!
//! ```text
//! P = -s/(x r),  R = -x s/r³,  S = x²/r³ - 1/r,      r² = x² + s²
//! ```
//!
//! of which (1 - ν) P + ν R is along the track by tractions along it, P - ν R across by tractions
//! across, and ν S the one by the other, over π times the shear modulus (Boussinesq and Cerruti).
//! Their derivatives by s are those of a narrow strip at the distance s.
//!
//! Both strips have the half length 1 here. The tractions are those polynomials times the root of
//! 1 - t² that have the moments ∫ f t^k dt of the strip, k = 0, 1, 2, and of the gradient the first
//! three Chebyshev coefficients are kept, as the polynomial Σ g_m t^m.

use crate::math::real::Real;
use std::f64::consts::PI;

/// Moments of the tractions that are felt, and coefficients of the gradient that are kept.
pub(super) const MOMENTS: usize = 3;
/// Places along the receiving strip.
const PLACES: usize = 13;
/// Step of the quadrature over the distance s: of a smooth integrand with poles at s, so that what
/// is left is e^(-2π/0.25).
const STEP: f64 = 0.25;
/// Least odd number of steps between places.
const MIN_STEPS: usize = 9;

/// Coefficients [m][k] of the gradient by the moments, for P, R and S.
pub(super) type Projected = [[[f64; MOMENTS]; MOMENTS]; 3];

/// Gradients P, R and S of a band that ends at `s`.
pub(super) fn band(x: f64, s: f64) -> [f64; 3] {
    let r = x.hypotenuse(s);
    [-s / (x * r), -x * s / r.powi(3), x * x / r.powi(3) - 1.0 / r]
}

/// Their derivatives by `s`.
pub(super) fn narrow(x: f64, s: f64) -> [f64; 3] {
    let r = x.hypotenuse(s);
    let inverse = r.powi(-3);
    let turned = 3.0 * s * inverse / (r * r);
    [-x * inverse, -x * inverse + x * s * turned, s * inverse - x * x * turned]
}

/// Places t on a strip and the weights of a quadrature with the weight sqrt(1 - t²), which never
/// meets the zeros of the Chebyshev polynomial of the order `places`; fine enough for gradients at
/// the distance `s`.
pub(super) fn quadrature(places: usize, s: f64) -> impl Iterator<Item = [f64; 2]> {
    let wanted = PI / (STEP * s * places as f64);
    let count = places * ((wanted as usize) | 1).max(MIN_STEPS);
    (1..count).map(move |j| {
        let angle = PI * j as f64 / count as f64;
        [angle.cos(), PI / count as f64 * angle.sin().powi(2)]
    })
}

/// Zero number `i` of the Chebyshev polynomial of order `order`, from the leading edge on.
pub(super) fn zero(order: usize, i: usize) -> f64 {
    (PI * (2 * i + 1) as f64 / (2 * order) as f64).cos()
}

/// Coefficients of the gradients of `kernel` at the distance `s`.
pub(super) fn projected(kernel: fn(f64, f64) -> [f64; 3], s: f64) -> Projected {
    // By Chebyshev polynomials of the second kind, to those of the first.
    let mut by_chebyshev = [[[0.0; MOMENTS]; MOMENTS]; 3];
    // What tractions and gradients of unlike parity have in common is left out: it vanishes.
    for i in 0..=PLACES / 2 {
        let at = zero(PLACES, i);
        let mirrored = if 2 * i + 1 < PLACES { 2.0 } else { 1.0 };
        let first = [1.0, at, 2.0 * at * at - 1.0].map(|p| mirrored * p);
        for [t, weight] in quadrature(PLACES, s) {
            let second = [weight, weight * 2.0 * t, weight * (4.0 * t * t - 1.0)];
            for (sums, value) in by_chebyshev.iter_mut().zip(kernel(at - t, s)) {
                for (row, first) in sums.iter_mut().zip(first) {
                    for (sum, second) in row.iter_mut().zip(second) {
                        *sum += value * first * second;
                    }
                }
            }
        }
    }
    by_chebyshev.map(|coefficients| {
        let [mut zeroth, mut first, mut second] = coefficients;
        let share = 2.0 / PLACES as f64;
        for (row, share) in [(&mut zeroth, 0.5 * share), (&mut first, share), (&mut second, share)]
        {
            *row = row.map(|c| c * share);
        }
        let rows = [[0, 1, 2].map(|k| zeroth[k] - second[k]), first, second.map(|c| 2.0 * c)];
        rows.map(|[by_0, by_1, by_2]| [by_0 - by_2, 2.0 * by_1, 4.0 * by_2])
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn narrow_strips_are_derivatives_of_bands() {
        let h = 1e-6;
        for (x, s) in [(0.3, 0.1), (-1.2, 0.4), (0.05, 2.0)] {
            let [above, below] = [band(x, s + h), band(x, s - h)];
            for (k, found) in narrow(x, s).into_iter().enumerate() {
                assert_relative_eq!(found, (above[k] - below[k]) / (2.0 * h), max_relative = 1e-7);
            }
        }
    }

    #[test]
    fn far_away_the_first_moment_alone_counts() {
        // ∫ S' f dt = s^-2 at the middle, times the 2/π of the tractions over their moment.
        let s = 300.0;
        let found = projected(narrow, s)[2][0][0];
        assert_relative_eq!(found, std::f64::consts::FRAC_PI_2 / (s * s), max_relative = 1e-4);
    }
}
