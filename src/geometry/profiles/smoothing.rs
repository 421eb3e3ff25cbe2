//! Smoothing splines through the points of a profile, and how far they may move its surface.

use crate::geometry::curves::curve::Knot;
use crate::math::real::Real;
use crate::math::spline::{penalty_of_wavelength, smoothing_spline};

/// How far smoothing may move the surface besides taking noise off [m]: a twentieth of the overlap
/// of a loaded contact.
const MOST_MOVED: f64 = 3e-6;
/// The same over what noise leaves in the middle value of a window.
const MOST_DEVIATIONS: f64 = 4.5;
/// Factor from a wavelength that moves the surface too far to the next one.
const SHORTENED: f64 = 0.7;

/// The longest wavelength up to `wavelength` that leaves the surface of points with `noise` where it
/// is; 0 where none does [m].
pub(crate) fn bounded(points: &[[f64; 2]], wavelength: f64, noise: f64) -> f64 {
    let spacing = chord_lengths(points).last().map_or(0.0, |length| length / points.len() as f64);
    let mut bounded = wavelength;
    while bounded > 0.0 && moves_too_far(points, bounded, noise) {
        bounded *= SHORTENED;
        // Waves as short as that are none of the points.
        if bounded < spacing {
            return 0.0;
        }
    }
    bounded
}

/// Whether smoothing at `wavelength` moves the surface itself: the middle one of its distances from
/// the points over half a wavelength, which noise and single points off the surface hardly change.
fn moves_too_far(points: &[[f64; 2]], wavelength: f64, noise: f64) -> bool {
    let knots = smooth(points, wavelength);
    let moved: Vec<f64> = (knots.iter().zip(points))
        .map(|(knot, p)| {
            let [ty, tz] = knot.tangent;
            let across = (p[0] - knot.point[0]) * tz - (p[1] - knot.point[1]) * ty;
            across / ty.hypotenuse(tz).max(f64::MIN_POSITIVE)
        })
        .collect();
    let (mut from, mut to) = (0, 0);
    let mut window = Vec::new();
    knots.iter().any(|knot| {
        while knots[from].s < knot.s - 0.25 * wavelength {
            from += 1;
        }
        while to < knots.len() && knots[to].s <= knot.s + 0.25 * wavelength {
            to += 1;
        }
        window.clear();
        window.extend_from_slice(&moved[from..to]);
        let count = window.len();
        let (_, middle, _) = window.select_nth_unstable_by(count / 2, f64::total_cmp);
        middle.abs() > MOST_MOVED + MOST_DEVIATIONS * noise / (count as f64).sqrt()
    })
}

/// Knots of the smoothed curve through distinct points.
pub(crate) fn smooth(points: &[[f64; 2]], wavelength: f64) -> Vec<Knot> {
    let penalty = penalty_of_wavelength(wavelength);
    let mut fitted = fit(points, &chord_lengths(points), penalty);
    if penalty > 0.0 {
        // The chords of noisy points are longer than the profile: take the length from the smoothed
        // one. Two points may then fall together, and the parameter must grow all the same.
        let rough = chord_lengths(points);
        let smoothed: Vec<[f64; 2]> = fitted.iter().map(|k| k.point).collect();
        let mut s = vec![0.0];
        for (i, pair) in smoothed.windows(2).enumerate() {
            let least = 0.01 * (rough[i + 1] - rough[i]);
            s.push(s[i] + (pair[1][0] - pair[0][0]).hypotenuse(pair[1][1] - pair[0][1]).max(least));
        }
        fitted = fit(points, &s, penalty);
    }
    fitted
}

fn fit(points: &[[f64; 2]], s: &[f64], penalty: f64) -> Vec<Knot> {
    let [y, z] = [0, 1].map(|i| {
        let values: Vec<f64> = points.iter().map(|p| p[i]).collect();
        smoothing_spline(s, &values, penalty)
    });
    (0..s.len())
        .map(|i| Knot {
            s: s[i],
            point: [y.values[i], z.values[i]],
            tangent: [y.slopes[i], z.slopes[i]],
        })
        .collect()
}

fn chord_lengths(points: &[[f64; 2]]) -> Vec<f64> {
    let mut s = vec![0.0];
    for pair in points.windows(2) {
        s.push(s[s.len() - 1] + (pair[1][0] - pair[0][0]).hypotenuse(pair[1][1] - pair[0][1]));
    }
    s
}
