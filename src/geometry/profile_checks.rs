//! What the points of a profile must satisfy before a curve is laid through them.

use crate::geometry::profile::{ProfileError, ProfileKind};
use crate::geometry::profile_points::{FilePoint, ProfilePoints};

/// Fewest points of a profile.
const FEWEST_POINTS: usize = 8;
/// Admitted diagonal of a profile [m].
const EXTENT: [f64; 2] = [0.010, 1.0];
/// Diagonal that a profile in another unit than stated must have [m].
const LIKELY_EXTENT: [f64; 2] = [0.02, 0.5];
/// A flange rises at least this much over the running circle, and nothing else does [m].
const FLANGE_RISE: f64 = 0.008;
/// A rim face is closer to the end of a profile than this; a flange reaches further [m].
const RIM_FACE: f64 = 0.010;
/// A head that lies lower than its sides by more than this on average stands on its head [m].
const HEAD_SAG: f64 = 1e-4;
/// Depth below the top at which a gauge face is recognised [m].
const GAUGE_DEPTH: f64 = 0.014;
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

/// Whether the points scaled by `factor` have the size of a profile for sure.
pub(crate) fn is_likely(profile: &ProfilePoints, factor: f64) -> bool {
    (LIKELY_EXTENT[0]..=LIKELY_EXTENT[1]).contains(&(factor * extent(profile)))
}

fn extent(profile: &ProfilePoints) -> f64 {
    let [y, z] = [0, 1].map(|i| range(&profile.points, i));
    (y[1] - y[0]).hypot(z[1] - z[0])
}

pub(crate) fn size(profile: &ProfilePoints) -> Result<(), ProfileError> {
    let extent = extent(profile);
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

/// The axis along which a profile lies the wrong way round.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Mirror {
    /// 0 for y, 1 for z.
    pub axis: usize,
    /// A line that shows it.
    pub line: usize,
    /// What shows it.
    pub what: &'static str,
}

/// What is to be mirrored so that z points down, and on a wheel the flange is at negative y; refused is a wheel on which y = 0 is not.
///
/// The points run from the flange (gauge) to the field side.
pub(crate) fn orientation(
    profile: &ProfilePoints,
    kind: ProfileKind,
) -> Result<Option<Mirror>, ProfileError> {
    match kind {
        ProfileKind::Wheel => wheel_orientation(profile),
        ProfileKind::Rail => Ok(rail_orientation(profile)),
    }
}

fn wheel_orientation(profile: &ProfilePoints) -> Result<Option<Mirror>, ProfileError> {
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
    let is_up = |p: &FilePoint| p.point[1] < height;
    // A rim face bends away too, but only at the end; a roller bends away on both sides.
    let flange_up = on_flange_side
        .filter(|p| is_up(p) && p.point[0] > y[0] + RIM_FACE)
        .filter(|_| !on_field_side.is_some_and(is_up));
    if let Some(p) = flange_up {
        let what = "the flange goes to negative z, and z is positive down";
        return Ok(Some(Mirror { axis: 1, line: p.line, what }));
    }
    let beyond = on_field_side.filter(|p| !is_up(p) && on_flange_side.is_none_or(is_up));
    let what = "the flange is at positive y, which is the field side";
    Ok(beyond.map(|p| Mirror { axis: 0, line: p.line, what }))
}

fn rail_orientation(profile: &ProfilePoints) -> Option<Mirror> {
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
    let what = "the head lies below its sides, and z is positive down";
    let line = points[points.len() / 2].line;
    (area < -HEAD_SAG * (last[0] - first[0])).then_some(Mirror { axis: 1, line, what })
}

/// Whether only the side at positive y of a rail goes down as deep as a gauge face does.
pub(crate) fn gauge_side_is_positive(profile: &ProfilePoints) -> bool {
    let points = profile.points.iter().map(|p| p.point);
    let Some(top) = points.clone().min_by(|a, b| a[1].total_cmp(&b[1])) else { return false };
    let is_deep = |side: f64| {
        points.clone().any(|p| p[1] > top[1] + GAUGE_DEPTH && (p[0] - top[0]) * side > 0.0)
    };
    is_deep(1.0) && !is_deep(-1.0)
}

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

/// Distance below which reversals are noise that smoothing at `wavelength` removes [m].
fn reversal_step(wavelength: f64) -> f64 {
    SMALLEST_STEP.max(NOISE_SHARE * wavelength)
}

/// Whether the direction reverses at the middle one of three points.
fn reverses(triple: &[FilePoint]) -> bool {
    let [a, b, c] = [0, 1, 2].map(|i| triple[i].point);
    let (u, v) = ([b[0] - a[0], b[1] - a[1]], [c[0] - b[0], c[1] - b[1]]);
    let lengths = u[0].hypot(u[1]) * v[0].hypot(v[1]);
    u[0] * v[0] + u[1] * v[1] < COSINE_OF_REVERSAL * lengths
}

/// Lines of the points without which the rest does not double back; none where that takes too many of them.
///
/// At a reversal one of two points is astray: the one at which the direction turns, or the next. Left out is the one without
/// which the points about it turn least.
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
    use crate::geometry::profile::ProfileRemark;
    use crate::geometry::profile_points::tests::{points_of, sampled};

    const WHEEL: ProfileKind = ProfileKind::Wheel;
    const RAIL: ProfileKind = ProfileKind::Rail;

    fn refused(points: &[[f64; 2]], kind: ProfileKind, wavelength: f64) -> ProfileError {
        points_of(points).into_profile(kind, wavelength).unwrap_err()
    }

    #[test]
    fn wrong_units_are_named_with_the_extent_and_the_remedy() {
        for factor in [1e-2, 1.0 / 25.4, 25.4] {
            let points: Vec<_> =
                sampled("60E1", RAIL, 1e-3).iter().map(|p| p.map(|x| x * factor)).collect();
            let error = refused(&points, RAIL, 0.0);
            assert!(matches!(error, ProfileError::WrongUnits { line: 1, .. }), "{error}");
            assert!(error.to_string().contains("do units"), "{error}");
        }
    }

    #[test]
    fn metres_for_millimetres_and_the_other_way_round_are_mended_and_said() {
        let exact = points_of(&sampled("60E1", RAIL, 1e-3)).into_profile(RAIL, 0.0).unwrap();
        for (factor, unit) in [(1e-3, "metres"), (1e3, "millimetres")] {
            let points: Vec<_> =
                sampled("60E1", RAIL, 1e-3).iter().map(|p| p.map(|x| x * factor)).collect();
            let mended = points_of(&points).into_profile(RAIL, 0.0).unwrap();
            approx::assert_relative_eq!(mended.bounds().z[1], exact.bounds().z[1], epsilon = 1e-12);
            let text = mended.remarks[0].to_string();
            assert!(mended.remarks[0].is_warning(), "{text}");
            assert!(
                text.contains(&format!("read in {unit}")) && text.contains("do units"),
                "{text}"
            );
            let stated = ProfilePoints { unit_is_stated: true, ..points_of(&points) };
            let error = stated.into_profile(RAIL, 0.0).unwrap_err();
            assert!(matches!(error, ProfileError::WrongUnits { .. }), "{error}");
        }
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
    fn points_in_no_order_are_refused() {
        // Sorted by y, the undercut sides run to and fro.
        let mut sorted = sampled("60E1", RAIL, 1e-3);
        sorted.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let error = refused(&sorted, RAIL, 2e-3);
        assert!(matches!(error, ProfileError::DoublesBack { .. }), "{error}");
        assert!(error.to_string().contains("put the points in order"), "{error}");
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
    fn profiles_that_stand_on_their_head_or_are_the_wrong_way_round_are_mirrored() {
        for (name, kind, mirror) in [
            ("S1002", WHEEL, [1.0, -1.0]),
            ("60E1", RAIL, [1.0, -1.0]),
            ("arc:0.3", RAIL, [1.0, -1.0]),
            ("S1002", WHEEL, [-1.0, 1.0]),
        ] {
            let clean = sampled(name, kind, 5e-4);
            let turned: Vec<_> =
                clean.iter().map(|p| [mirror[0] * p[0], mirror[1] * p[1]]).collect();
            let mended = points_of(&turned).into_profile(kind, 0.0).unwrap();
            let expected = points_of(&clean).into_profile(kind, 0.0).unwrap();
            assert_eq!(mended.bounds(), expected.bounds(), "{name}");
            let text = mended.remarks[0].to_string();
            assert!(mended.remarks[0].is_warning() && mended.remarks.len() == 1, "{text}");
            let axis = if mirror[0] < 0.0 { "y" } else { "z" };
            assert!(text.contains(&format!("mirrored in {axis}")), "{text}");
            assert!(text.contains(&format!("do mirror {axis}")), "{text}");
        }
    }

    #[test]
    fn a_groove_is_taken_as_it_stands_where_the_direction_is_stated() {
        let groove: Vec<_> = sampled("arc:0.3", RAIL, 5e-4).iter().map(|p| [p[0], -p[1]]).collect();
        let stated = ProfilePoints { direction_is_stated: true, ..points_of(&groove) };
        let profile = stated.into_profile(RAIL, 0.0).unwrap();
        assert!(profile.bounds().z[0] < -1e-3);
        let text = profile.remarks[0].to_string();
        assert!(text.contains("taken as it stands") && text.contains("do mirror z"), "{text}");
    }

    #[test]
    fn a_roller_that_bends_away_on_both_sides_is_a_wheel() {
        let roller: Vec<[f64; 2]> = (-490..=490)
            .map(|i| 1e-4 * f64::from(i))
            .map(|y| [y, (0.05f64.powi(2) - y * y).sqrt() - 0.05])
            .collect();
        let profile = points_of(&roller).into_profile(WHEEL, 0.0).unwrap();
        assert!(profile.remarks.is_empty(), "{:?}", profile.remarks);
        approx::assert_relative_eq!(profile.bounds().z[1], 0.0, epsilon = 1e-9);
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
