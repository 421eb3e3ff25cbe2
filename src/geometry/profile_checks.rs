//! What the points of a profile must satisfy before a curve is laid through them.

use crate::geometry::profile::{ProfileError, ProfileKind};
use crate::geometry::profile_points::{FilePoint, ProfilePoints};

/// Fewest points of a profile.
const FEWEST_POINTS: usize = 8;
/// Admitted diagonal of a profile [m].
const EXTENT: [f64; 2] = [0.010, 1.0];
/// A flange rises at least this much over the running circle, and nothing else does [m].
const FLANGE_RISE: f64 = 0.008;
/// A rim face is closer to the end of a profile than this; a flange reaches further [m].
const RIM_FACE: f64 = 0.010;
/// A head that lies lower than its sides by more than this on average stands on its head [m].
const HEAD_SAG: f64 = 1e-4;
/// The direction reverses where it turns by more than 120°.
const COSINE_OF_REVERSAL: f64 = -0.5;
/// Reversals over less than this share of the wavelength are noise, which smoothing removes.
const NOISE_SHARE: f64 = 0.05;
/// Smallest distance over which a reversal is looked for [m].
const SMALLEST_STEP: f64 = 1e-6;
/// Number of steps across a profile at which crossings are looked for.
const CROSSING_STEPS: f64 = 1000.0;

const MM: f64 = 1e-3;

pub(crate) fn enough(profile: &ProfilePoints) -> Result<(), ProfileError> {
    let found = profile.points.len();
    if found >= FEWEST_POINTS {
        return Ok(());
    }
    let line = profile.points.iter().map(|p| p.line).max().unwrap_or(1);
    Err(ProfileError::TooFewPoints {
        file: profile.file.clone(),
        line,
        found,
        needed: FEWEST_POINTS,
    })
}

pub(crate) fn size(profile: &ProfilePoints) -> Result<(), ProfileError> {
    let [y, z] = [0, 1].map(|i| range(&profile.points, i));
    let extent = (y[1] - y[0]).hypot(z[1] - z[0]);
    if (EXTENT[0]..=EXTENT[1]).contains(&extent) {
        return Ok(());
    }
    Err(ProfileError::WrongUnits {
        file: profile.file.clone(),
        line: profile.points[0].line,
        extent_mm: rounded_mm(extent),
        remedy: profile.remedies.units,
    })
}

/// Whether z points down, and on a wheel whether y = 0 is on it and the flange at negative y.
///
/// The points run from the flange (gauge) to the field side.
pub(crate) fn orientation(profile: &ProfilePoints, kind: ProfileKind) -> Result<(), ProfileError> {
    match kind {
        ProfileKind::Wheel => wheel_orientation(profile),
        ProfileKind::Rail => rail_orientation(profile),
    }
}

fn wheel_orientation(profile: &ProfilePoints) -> Result<(), ProfileError> {
    let file = || profile.file.clone();
    let points = &profile.points;
    let y = range(points, 0);
    let running_circle = points.iter().position(|p| p.point[0] >= 0.0);
    let (Some(centre), true) = (running_circle, y[0] < 0.0) else {
        return Err(ProfileError::OffRunningCircle {
            file: file(),
            line: points[0].line.min(points[points.len() - 1].line),
            from_mm: rounded_mm(y[0]),
            to_mm: rounded_mm(y[1]),
        });
    };
    let height = points[centre].point[1];
    let leaves = |p: &&FilePoint| (p.point[1] - height).abs() > FLANGE_RISE;
    let on_flange_side = points[..centre].iter().rev().find(leaves);
    let on_field_side = points[centre..].iter().find(leaves);
    match (on_flange_side, on_field_side) {
        (Some(p), _) if p.point[1] < height && p.point[0] > y[0] + RIM_FACE => {
            Err(ProfileError::ZUp {
                file: file(),
                line: p.line,
                what: "the flange goes to negative z, and z is positive down",
                remedy: profile.remedies.mirror_z,
            })
        }
        (flange, Some(p)) if p.point[1] > height && flange.is_none_or(|f| f.point[1] < height) => {
            Err(ProfileError::FlangeOnFieldSide {
                file: file(),
                line: p.line,
                remedy: profile.remedies.mirror_y,
            })
        }
        _ => Ok(()),
    }
}

fn rail_orientation(profile: &ProfilePoints) -> Result<(), ProfileError> {
    let points = &profile.points;
    let (first, last) = (points[0].point, points[points.len() - 1].point);
    let slope = (last[1] - first[1]) / (last[0] - first[0]).max(f64::MIN_POSITIVE);
    // Height of each stretch over the line between the ends, weighted with its width: spacing does
    // not count.
    let over = |p: &FilePoint| first[1] + slope * (p.point[0] - first[0]) - p.point[1];
    let area: f64 = points
        .windows(2)
        .map(|p| 0.5 * (over(&p[0]) + over(&p[1])) * (p[1].point[0] - p[0].point[0]))
        .sum();
    if area >= -HEAD_SAG * (last[0] - first[0]) {
        return Ok(());
    }
    Err(ProfileError::ZUp {
        file: profile.file.clone(),
        line: points[points.len() / 2].line,
        what: "the head lies below its sides, and z is positive down",
        remedy: profile.remedies.mirror_z,
    })
}

/// Whether the points follow the profile: no reversals beyond what smoothing at `wavelength` [m]
/// removes, and no crossing.
pub(crate) fn order(profile: &ProfilePoints, wavelength: f64) -> Result<(), ProfileError> {
    let thinned = thin(&profile.points, SMALLEST_STEP.max(NOISE_SHARE * wavelength));
    for triple in thinned.windows(3) {
        let [a, b, c] = [0, 1, 2].map(|i| triple[i].point);
        let (u, v) = ([b[0] - a[0], b[1] - a[1]], [c[0] - b[0], c[1] - b[1]]);
        let lengths = u[0].hypot(u[1]) * v[0].hypot(v[1]);
        if u[0] * v[0] + u[1] * v[1] < COSINE_OF_REVERSAL * lengths {
            return Err(ProfileError::DoublesBack {
                file: profile.file.clone(),
                line: triple[1].line,
                y_mm: rounded_mm(b[0]),
                z_mm: rounded_mm(b[1]),
            });
        }
    }
    let [y, z] = [0, 1].map(|i| range(&thinned, i));
    let step = (y[1] - y[0]).hypot(z[1] - z[0]) / CROSSING_STEPS;
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

/// The first point, and those at least `distance` from the one kept before.
fn thin(points: &[FilePoint], distance: f64) -> Vec<FilePoint> {
    let mut kept = vec![points[0]];
    for p in &points[1..] {
        let from = kept[kept.len() - 1].point;
        if (p.point[0] - from[0]).hypot(p.point[1] - from[1]) >= distance {
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

fn range(points: &[FilePoint], axis: usize) -> [f64; 2] {
    points.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], p| {
        [low.min(p.point[axis]), high.max(p.point[axis])]
    })
}

/// A length in millimetres with the digits that a message needs.
fn rounded_mm(length: f64) -> f64 {
    let digits = 1e4;
    (length / MM * digits).round() / digits
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::profile_points::tests::{points_of, sampled};

    const WHEEL: ProfileKind = ProfileKind::Wheel;
    const RAIL: ProfileKind = ProfileKind::Rail;

    fn refused(points: &[[f64; 2]], kind: ProfileKind, wavelength: f64) -> ProfileError {
        points_of(points).into_profile(kind, wavelength).unwrap_err()
    }

    #[test]
    fn wrong_units_are_named_with_the_extent_and_the_remedy() {
        for factor in [1e-3, 1.0 / 25.4, 25.4, 1e3] {
            let points: Vec<_> =
                sampled("60E1", RAIL, 1e-3).iter().map(|p| p.map(|x| x * factor)).collect();
            let error = refused(&points, RAIL, 0.0);
            assert!(matches!(error, ProfileError::WrongUnits { line: 1, .. }), "{error}");
            assert!(error.to_string().contains("do units"), "{error}");
        }
    }

    #[test]
    fn points_out_of_order_are_refused_at_their_line() {
        let mut points = sampled("60E1", RAIL, 1e-3);
        points.swap(60, 63);
        let error = refused(&points, RAIL, 2e-3);
        assert!(
            matches!(error, ProfileError::DoublesBack { line: 60..=64, .. }),
            "{error} {error:?}"
        );
        assert!(error.to_string().contains("put the points in order"), "{error}");
        // Sorted by y, the undercut sides run to and fro.
        let mut sorted = sampled("60E1", RAIL, 1e-3);
        sorted.sort_by(|a, b| a[0].total_cmp(&b[0]));
        assert!(matches!(refused(&sorted, RAIL, 2e-3), ProfileError::DoublesBack { .. }));
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

    #[test]
    fn a_loop_is_refused_with_both_lines() {
        // A loop of 4 mm radius put into the tread, 2 mm wide turns.
        let mut points = sampled("S1002", WHEEL, 1e-3);
        let at = points.len() - 40;
        let [y, z] = points[at];
        let ring = (0..24).map(|i| {
            let angle = 0.25 * f64::from(i);
            [y + 0.004 * angle.sin(), z + 0.004 - 0.004 * angle.cos()]
        });
        points.splice(at + 1..=at + 1, ring);
        let error = refused(&points, WHEEL, 2e-3);
        let ProfileError::SelfCrossing { line, other_line, .. } = error else {
            panic!("{error}");
        };
        assert!(line.abs_diff(at + 1) <= 6, "{line}");
        assert!(other_line.abs_diff(at + 24) <= 6, "{other_line}");
        assert!(error.to_string().contains("delete the loop"), "{error}");
    }

    #[test]
    fn profiles_that_stand_on_their_head_are_refused() {
        for (name, kind) in [("S1002", WHEEL), ("60E1", RAIL), ("arc:0.3", RAIL)] {
            let up: Vec<_> = sampled(name, kind, 5e-4).iter().map(|p| [p[0], -p[1]]).collect();
            let error = refused(&up, kind, 0.0);
            assert!(matches!(error, ProfileError::ZUp { .. }), "{error}");
            assert!(error.to_string().contains("z seems to point up"), "{error}");
            assert!(error.to_string().contains("do mirror z"), "{error}");
        }
    }

    #[test]
    fn a_flange_on_the_field_side_is_refused() {
        let points: Vec<_> = sampled("S1002", WHEEL, 5e-4).iter().map(|p| [-p[0], p[1]]).collect();
        let error = refused(&points, WHEEL, 0.0);
        assert!(matches!(error, ProfileError::FlangeOnFieldSide { .. }), "{error}");
        assert!(error.to_string().contains("do mirror y"), "{error}");
    }

    #[test]
    fn a_wheel_without_flange_needs_none_but_needs_its_running_circle() {
        let points = sampled("conical:0.05", WHEEL, 1e-3);
        assert!(points_of(&points).into_profile(WHEEL, 0.0).is_ok());
        let off: Vec<_> = points.iter().map(|p| [p[0] - 0.1, p[1]]).collect();
        let error = refused(&off, WHEEL, 0.0);
        assert!(matches!(error, ProfileError::OffRunningCircle { line: 1, .. }), "{error}");
        assert!(error.to_string().contains("running circle"), "{error}");
    }

    #[test]
    fn a_rim_face_is_not_taken_for_a_flange() {
        let mut points: Vec<[f64; 2]> =
            (0..20).map(|i| [-0.07, -0.02 + 0.001 * f64::from(i)]).collect();
        points.extend(sampled("cylindrical", WHEEL, 1e-3));
        assert!(points_of(&points).into_profile(WHEEL, 2e-3).is_ok());
    }
}
