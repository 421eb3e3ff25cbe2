//! Number, size and direction of the points of a profile, before a curve is laid through them.

use crate::geometry::profiles::profile_error::{ProfileError, rounded_mm};
use crate::geometry::profiles::profile_kind::ProfileKind;
use crate::geometry::profiles::profile_points::{FilePoint, ProfilePoints, extent, range};

/// Fewest points of a profile.
const FEWEST_POINTS: usize = 8;
/// Admitted diagonal of a profile [m].
const EXTENT: [f64; 2] = [0.010, 1.0];
/// Diagonal that a profile in another unit than stated must have [m].
const LIKELY_EXTENT: [f64; 2] = [0.02, 0.5];
/// A flange rises at least this much over the nominal rolling circle, and nothing else does [m].
const FLANGE_RISE: f64 = 0.008;
/// A rim face is closer to the end of a profile than this; a flange reaches further [m].
const RIM_FACE: f64 = 0.010;
/// A head that lies lower than its sides by more than this on average stands on its head [m].
const HEAD_SAG: f64 = 1e-4;
/// Depth below the top at which a gauge face is recognised [m].
const GAUGE_DEPTH: f64 = 0.014;
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
    (LIKELY_EXTENT[0]..=LIKELY_EXTENT[1]).contains(&(factor * extent(&profile.points)))
}

pub(crate) fn size(profile: &ProfilePoints) -> Result<(), ProfileError> {
    let extent = extent(&profile.points);
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

/// What is to be mirrored so that z points down, and on a wheel the flange is at negative y;
/// refused is a wheel on which y = 0 is not.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::profiles::profile_points::tests::{points_of, sampled};

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
    fn a_wheel_without_flange_needs_none_but_needs_its_nominal_rolling_circle() {
        let points = sampled("conical:0.05", WHEEL, 1e-3);
        assert!(points_of(&points).into_profile(WHEEL, 0.0).is_ok());
        let off: Vec<_> = points.iter().map(|p| [p[0] - 0.1, p[1]]).collect();
        let error = refused(&off, WHEEL, 0.0);
        assert!(matches!(error, ProfileError::OffRunningCircle { line: 1, .. }), "{error}");
        assert!(error.to_string().contains("nominal rolling circle"), "{error}");
    }

    #[test]
    fn a_rim_face_is_not_taken_for_a_flange() {
        let mut points: Vec<[f64; 2]> =
            (0..20).map(|i| [-0.07, -0.02 + 0.001 * f64::from(i)]).collect();
        points.extend(sampled("cylindrical", WHEEL, 1e-3));
        assert!(points_of(&points).into_profile(WHEEL, 2e-3).is_ok());
    }
}
