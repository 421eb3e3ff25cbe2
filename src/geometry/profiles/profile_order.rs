//! Whether the points of a profile follow it: reversals, strays and crossings.

use crate::geometry::profiles::profile_error::{ProfileError, rounded_mm};
use crate::geometry::profiles::profile_points::{FilePoint, ProfilePoints, extent};
use crate::math::real::Real;

/// The direction reverses where it turns by more than 120°.
const COSINE_OF_REVERSAL: f64 = -0.5;

/// Reversals over less than this share of the wavelength are noise, which smoothing removes.
const NOISE_SHARE: f64 = 0.05;

/// Largest share of the points that may be stray.
const STRAY_SHARE: f64 = 0.02;

/// Smallest distance over which a reversal is looked for [m].
const SMALLEST_STEP: f64 = 1e-6;

/// Number of steps across a profile at which crossings are looked for.
const CROSSING_STEPS: f64 = 1000.0;

/// Whether the points follow the profile: no reversals beyond what smoothing at `wavelength` [m]
/// removes, and no crossing.
pub(crate) fn order(profile: &ProfilePoints, wavelength: f64) -> Result<(), ProfileError> {
    let thinned = thin(&profile.points, reversal_step(wavelength));
    if let Some(at) = thinned.windows(3).position(reverses) {
        let back = thinned[at + 1];
        return Err(ProfileError::DoublesBack {
            file: profile.file.clone(),
            line: back.line,
            y_mm: rounded_mm(back.point[0]),
            z_mm: rounded_mm(back.point[1]),
        });
    }
    let step = extent(&thinned) / CROSSING_STEPS;
    let coarse = thin(&thinned, step);
    if let Some((first, second)) = crossing(&coarse) {
        return Err(ProfileError::SelfCrossing {
            file: profile.file.clone(),
            line: coarse[first].line,
            other_line: coarse[second].line,
        });
    }
    Ok(())
}

/// Distance below which reversals are noise that smoothing at `wavelength` removes [m].
fn reversal_step(wavelength: f64) -> f64 {
    SMALLEST_STEP.max(NOISE_SHARE * wavelength)
}

/// Whether the direction reverses at the middle one of three points.
fn reverses(triple: &[FilePoint]) -> bool {
    let [a, b, c] = [0, 1, 2].map(|i| triple[i].point);
    let (u, v) = ([b[0] - a[0], b[1] - a[1]], [c[0] - b[0], c[1] - b[1]]);
    let lengths = u[0].hypotenuse(u[1]) * v[0].hypotenuse(v[1]);
    u[0] * v[0] + u[1] * v[1] < COSINE_OF_REVERSAL * lengths
}

/// Lines of the points without which the rest does not double back; none where that takes too many
/// of them.
///
/// At a reversal one of two points is astray: the one at which the direction turns, or the next.
/// Left out is the one without which the points about it turn least.
pub(crate) fn strays(points: &[FilePoint], wavelength: f64) -> Vec<usize> {
    let mut left = thin(points, reversal_step(wavelength));
    let most = ((STRAY_SHARE * left.len() as f64) as usize).max(1);
    let mut strays = Vec::new();
    while let Some(at) = left.windows(3).position(reverses) {
        if strays.len() == most {
            return Vec::new();
        }
        let reversals_without = |k: usize| {
            let about = &left[k.saturating_sub(3)..(k + 4).min(left.len())];
            let rest: Vec<FilePoint> =
                about.iter().filter(|p| p.line != left[k].line).copied().collect();
            rest.windows(3).filter(|triple| reverses(triple)).count()
        };
        let fewer = reversals_without(at + 2) < reversals_without(at + 1);
        strays.push(left.remove(if fewer { at + 2 } else { at + 1 }).line);
    }
    strays.sort_unstable();
    strays
}

/// The first point, and those at least `distance` from the one kept before.
fn thin(points: &[FilePoint], distance: f64) -> Vec<FilePoint> {
    let mut kept = vec![points[0]];
    for p in &points[1..] {
        let from = kept[kept.len() - 1].point;
        if (p.point[0] - from[0]).hypotenuse(p.point[1] - from[1]) >= distance {
            kept.push(*p);
        }
    }
    kept
}

/// The first two stretches between points, not neighbours, that cross.
fn crossing(points: &[FilePoint]) -> Option<(usize, usize)> {
    let count = points.len().saturating_sub(1);
    for i in 0..count {
        let (a, b) = (points[i].point, points[i + 1].point);
        let [y, z] = [0, 1].map(|k| [a[k].min(b[k]), a[k].max(b[k])]);
        for j in i + 2..count {
            let (c, d) = (points[j].point, points[j + 1].point);
            // Most pairs lie apart: this is what keeps the search fast.
            if c[0].max(d[0]) < y[0]
                || c[0].min(d[0]) > y[1]
                || c[1].max(d[1]) < z[0]
                || c[1].min(d[1]) > z[1]
            {
                continue;
            }
            let side = |p: [f64; 2], q: [f64; 2], r: [f64; 2]| {
                (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
            };
            let apart = side(a, b, c) * side(a, b, d) > 0.0 || side(c, d, a) * side(c, d, b) > 0.0;
            if !apart {
                return Some((i, j));
            }
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::profiles::profile::{ProfileKind, ProfileRemark};
    use crate::geometry::profiles::profile_points::tests::{points_of, sampled};

    const RAIL: ProfileKind = ProfileKind::Rail;

    fn refused(points: &[[f64; 2]], kind: ProfileKind, wavelength: f64) -> ProfileError {
        points_of(points).into_profile(kind, wavelength).unwrap_err()
    }

    #[test]
    fn a_few_stray_points_are_left_out_and_named() {
        let clean = sampled("60E1", RAIL, 1e-3);
        let expected = points_of(&clean).into_profile(RAIL, 0.0).unwrap();
        let mut exchanged = clean.clone();
        exchanged.swap(60, 63);
        let mut aside = clean.clone();
        aside.insert(60, [clean[60][0] - 2.3e-3, clean[60][1] + 4e-4]);
        for points in [exchanged, aside] {
            let mended = points_of(&points).into_profile(RAIL, 0.0).unwrap();
            let ProfileRemark::PointsLeftOut { lines, .. } = &mended.remarks[0] else {
                panic!("{:?}", mended.remarks);
            };
            assert!(lines.len() <= 2 && lines.iter().all(|l| (60..=65).contains(l)), "{lines:?}");
            assert!(mended.remarks[0].to_string().contains(&lines[0].to_string()));
            for i in 0..100 {
                let s = mended.curve.end() * f64::from(i) / 100.0;
                approx::assert_relative_eq!(
                    mended.curve.at(s).point[1],
                    expected.curve.at(s).point[1],
                    epsilon = 2e-6
                );
            }
        }
    }

    #[test]
    fn fine_noise_is_refused_without_and_taken_with_smoothing() {
        let points: Vec<_> = sampled("60E1", RAIL, 2e-5)
            .iter()
            .enumerate()
            .map(|(i, p)| [p[0] + 1.5e-5 * f64::from((i % 3) as u8), p[1]])
            .collect();
        let error = refused(&points, RAIL, 0.0);
        assert!(error.to_string().contains("profile.smoothing"), "{error}");
        assert!(points_of(&points).into_profile(RAIL, 2e-3).is_ok());
    }
}
