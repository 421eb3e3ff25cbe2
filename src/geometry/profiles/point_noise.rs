//! Noise of the points of a profile, and the smoothing that it needs.
//!
//! **Noise.** The difference of fifth order of six neighbours, taken across the profile for the
//! distances that the points have and scaled to the variance of one point, is next to nothing on a
//! line, an arc or any smooth curve; noise passes whole. Where the curvature jumps a few
//! differences are large, which a median does not see. What is left of the shape grows at least
//! with the square of the distance of the points, noise does not: with every second point
//!
//! ```text
//! r₁² = σ² + S²,   r₂² ≥ σ² + 16 S²      σ² = max(0, (16 r₁² - r₂²) / 15),    r = 1.4826 median |difference|
//! ```
//!
//! so that points too far apart to show noise have none. This is done for three overlapping halves
//! of the points, and the noisiest counts: noise along z leaves no trace on vertical sides. Points
//! rounded so coarsely that they stand on stairs have differences of zero and of about a step; for
//! those the root mean square of all differences within one step of the digits takes the place of
//! the median. Waviness longer than a few points is shape to this estimate.
//!
//! **Smoothing.** White noise σ at distances h leaves this in the curvature of a smoothing spline
//! that halves a wave of length L, and this in that of the spline through the points:
//!
//! ```text
//! κ = 0.2973 σ √h / q^2.5,   q = L / 2π          κ = 6 σ / h²
//! ```
//!
//! Pressure on a half-space follows the slope: noise errs it by E*/2 · 0.2973 σ √h / q^1.5, and
//! rounding off a jump Δκ of curvature by up to E*/2 · 0.187 Δκ q. Their sum is least where the
//! noise of the curvature is 0.12 Δκ: 1.1 1/m at the jump of 9.2 1/m from 300 to 80 mm on a rail
//! head, hence the bound of 1 1/m. The wavelength is the shortest that keeps it wherever points are
//! so close that the spline through them does not: none for exact points.

use crate::math::real::Real;
use std::f64::consts::TAU;
use std::ops::RangeInclusive;

/// As a smoothing wavelength: chosen from the noise of the points.
pub const AUTOMATIC_SMOOTHING: f64 = -1.0;

/// Admitted wavelengths: negative ones are automatic, and beyond 0.05 m nothing of a flange is left
/// [m].
pub(crate) const ADMITTED_SMOOTHING: RangeInclusive<f64> = AUTOMATIC_SMOOTHING..=0.05;

/// The same in words.
pub(crate) const SMOOTHING_ALLOWED: &str =
    "a wavelength from 0 (no smoothing) to 0.05 m, or -1 to choose it from the noise of the points";

/// Root mean square that noise may leave in the curvature [1/m].
pub(crate) const CURVATURE_NOISE: f64 = 1.0;

/// Longest wavelength that is chosen [m]: beyond it the root of a flange, an arc of 13 mm, is lost.
pub(crate) const LONGEST_CHOSEN: f64 = 0.01;

/// Order of the differences.
const ORDER: usize = 5;
/// From the median of the magnitude of a normal distribution to its standard deviation.
const DEVIATION_OF_MEDIAN: f64 = 1.4826;
/// Growth of the square of a shape's difference when the distance of the points doubles, at least.
const SHAPE_GROWTH: f64 = 16.0;

/// Standard deviation of the noise of points in order along a profile [m].
///
/// `step`: distance of two numbers that differ in their last digit [m]; 0 where there are too many
/// digits to tell.
pub(crate) fn noise(points: &[[f64; 2]], step: f64) -> f64 {
    let (near, far) = (differences(points, 1), differences(points, 2));
    // Quarters, so that halves overlap.
    let half = |all: &[f64], quarter: usize| -> f64 {
        let (from, to) = (quarter * all.len() / 4, (quarter + 2) * all.len() / 4);
        DEVIATION_OF_MEDIAN * median(all[from..to].iter().map(|d| d.abs()).collect())
    };
    let apart_from_shape = (0..3)
        .map(|quarter| {
            let (r1, r2) = (half(&near, quarter), half(&far, quarter));
            let square = (SHAPE_GROWTH * r1 * r1 - r2 * r2) / (SHAPE_GROWTH - 1.0);
            square.max(0.0).sqrt()
        })
        .fold(0.0, f64::max);
    let within: Vec<f64> = near.iter().copied().filter(|d| d.abs() <= step).collect();
    let squares: f64 = within.iter().map(|d| d * d).sum();
    let of_rounding = (squares / within.len().max(1) as f64).sqrt();
    apart_from_shape.max(of_rounding)
}

/// Shortest wavelength that keeps the noise of the curvature at its bound, for points at distances
/// `spacing` with `noise` [m]; 0 where the curve through the points does.
pub(crate) fn chosen_wavelength(spacing: impl Iterator<Item = f64>, noise: f64) -> f64 {
    let closest = (6.0 * noise / CURVATURE_NOISE).sqrt();
    let widest = spacing.filter(|&h| h < closest).fold(0.0, f64::max);
    TAU * (CURVATURE_PASSED * noise * widest.sqrt() / CURVATURE_NOISE).powf(0.4)
}

/// Noise left in the curvature, times q^2.5 over σ √h: root of ∫ x⁴/(1 + x⁴)² dx / 2π.
const CURVATURE_PASSED: f64 = 0.2973;

/// Distance of two numbers that differ in the last digit that nine of ten of the coordinates have,
/// in their unit; 0 where there are more than ten decimals.
pub(crate) fn last_digit(coordinates: &[f64]) -> f64 {
    let has = |decimals: i32| {
        let is_whole = |x: f64| (x - x.round()).abs() < 1e-4;
        let scale = 10f64.powi(decimals);
        10 * coordinates.iter().filter(|&x| is_whole(x * scale)).count() >= 9 * coordinates.len()
    };
    (0..=10).find(|&decimals| has(decimals)).map_or(0.0, |decimals| 10f64.powi(-decimals))
}

/// Differences of every `stride`-th of neighbouring points across the profile, scaled to the
/// variance of one point [m].
fn differences(points: &[[f64; 2]], stride: usize) -> Vec<f64> {
    let reach = ORDER * stride;
    (0..points.len().saturating_sub(reach))
        .filter_map(|i| {
            let of: [[f64; 2]; ORDER + 1] = std::array::from_fn(|k| points[i + k * stride]);
            difference(&of)
        })
        .collect()
}

/// Divided difference of heights over the chord; nothing where points stand above each other.
fn difference(points: &[[f64; 2]; ORDER + 1]) -> Option<f64> {
    let chord = [points[ORDER][0] - points[0][0], points[ORDER][1] - points[0][1]];
    let length = chord[0].hypotenuse(chord[1]);
    // Along the chord in its lengths, and across it in metres.
    let local = points.map(|p| {
        let (y, z) = (p[0] - points[0][0], p[1] - points[0][1]);
        let along = (y * chord[0] + z * chord[1]) / (length * length);
        (along, (z * chord[0] - y * chord[1]) / length)
    });
    let weights: [f64; ORDER + 1] = std::array::from_fn(|k| {
        let others = (0..=ORDER).filter(|&j| j != k);
        others.map(|j| local[k].0 - local[j].0).product::<f64>().recip()
    });
    let norm = weights.iter().map(|w| w * w).sum::<f64>().sqrt();
    let difference = weights.iter().zip(local).map(|(w, p)| w * p.1).sum::<f64>() / norm;
    difference.is_finite().then_some(difference)
}

/// The middle value; 0 of none.
fn median(mut values: Vec<f64>) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    let middle = values.len() / 2;
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::profiles::profile::ProfileKind;
    use crate::geometry::profiles::profile_points::tests::{sampled, with_noise};

    const BOTH: [(&str, ProfileKind); 2] =
        [("S1002", ProfileKind::Wheel), ("60E1", ProfileKind::Rail)];

    fn rounded(points: &[[f64; 2]], step: f64) -> Vec<[f64; 2]> {
        points.iter().map(|p| p.map(|x| (x / step).round() * step)).collect()
    }

    fn found(points: &[[f64; 2]], step: f64) -> (f64, f64) {
        let spacing = points.windows(2).map(|p| (p[1][0] - p[0][0]).hypotenuse(p[1][1] - p[0][1]));
        let noise = noise(points, step);
        (noise, chosen_wavelength(spacing, noise))
    }

    #[test]
    fn noise_across_and_along_is_found_to_a_third_whatever_the_spacing() {
        for (name, kind) in BOTH {
            for spacing in [1e-4, 2.5e-4, 5e-4] {
                for size in [1e-6, 5e-6, 2e-5] {
                    let (noise, _) =
                        found(&with_noise(&sampled(name, kind, spacing), size, 7), 1e-10);
                    assert!((noise / size - 1.0).abs() < 0.34, "{name} {spacing} {size}: {noise}");
                }
            }
        }
    }

    #[test]
    fn rounding_is_found_as_noise_of_its_own_size() {
        for (name, kind) in BOTH {
            for step in [1e-5, 1e-6, 1e-7] {
                let (noise, _) = found(&rounded(&sampled(name, kind, 2.5e-4), step), step);
                let share = noise / (step / 12f64.sqrt());
                assert!((0.7..2.2).contains(&share), "{name} {step}: {share}");
            }
        }
    }

    #[test]
    fn exact_points_are_not_smoothed_however_far_apart() {
        for (name, kind) in BOTH {
            for spacing in [1e-4, 5e-4, 1e-3, 3e-3, 7e-3] {
                for step in [1e-9, 1e-10] {
                    let points = rounded(&sampled(name, kind, spacing), step);
                    let (noise, wavelength) = found(&points, step);
                    assert!(wavelength <= 0.0, "{name} {spacing} {step}: {noise} {wavelength}");
                }
            }
        }
        let flat: Vec<[f64; 2]> = (0..101).map(|i| [1e-3 * f64::from(i), 0.0]).collect();
        assert!(found(&flat, 1e-3).1 <= 0.0);
    }

    #[test]
    fn digits_are_counted() {
        let exact = 1e-12;
        approx::assert_relative_eq!(last_digit(&[1.25, 0.5, -3.75]), 0.01, epsilon = exact);
        approx::assert_relative_eq!(last_digit(&[50.0, -7.0]), 1.0, epsilon = exact);
        assert!(last_digit(&[0.123_456_789_012_3]) <= 0.0);
    }
}
