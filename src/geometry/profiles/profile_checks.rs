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
/// A head beside a groove is higher than what leads down into it by more than this [m].
const HEAD_BESIDE_GROOVE: f64 = 1e-3;
/// Widths below which a file holds no whole profile [m].
const NARROWEST_WHEEL: f64 = 0.03;
const NARROWEST_RAIL: f64 = 0.015;
/// Distance of the running circle from the end of a wheel below which it is at the edge [m].
const EDGE: f64 = 0.008;
/// Height of the running circle over the nominal one beyond which its zero is another [m]: wheels are
/// turned before they are worn so far.
const WORN_AWAY: f64 = 0.010;
/// How far around the running circle its slope is taken [m], and the steepest slope of a tread [-].
const AROUND: f64 = 0.003;
const STEEPEST_TREAD: f64 = 0.4;
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
    // Or on the field side, where both are to be mirrored; a roller may be cut off at one side, but is
    // steep nowhere.
    let is_inside = |p: &FilePoint| p.point[0] < y[1] - RIM_FACE;
    let is_steep = |pair: &[FilePoint]| {
        let [across, down] = [0, 1].map(|axis| (pair[1].point[axis] - pair[0].point[axis]).abs());
        is_inside(&pair[1]) && down > across
    };
    let flange_up = flange_up.or_else(|| {
        on_field_side
            .filter(|p| is_up(p) && is_inside(p) && points[centre..].windows(2).any(is_steep))
            .filter(|_| on_flange_side.is_none_or(|p| !is_up(p) && p.point[0] <= y[0] + RIM_FACE))
    });
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
    let is_low = area < -HEAD_SAG * (last[0] - first[0]);
    (is_low && falls_and_rises(points)).then_some(Mirror { axis: 1, line, what })
}

/// Whether the points go down to the lowest one and up again, as a head that stands on its head
/// does; a grooved rail has a head beside its groove.
fn falls_and_rises(points: &[FilePoint]) -> bool {
    let z = |p: &FilePoint| p.point[1];
    let lowest = (0..points.len()).max_by(|a, b| z(&points[*a]).total_cmp(&z(&points[*b])));
    let (left, right) = points.split_at(lowest.unwrap_or(0));
    is_steady(left.iter().map(z)) && is_steady(right.iter().rev().map(z))
}

/// Whether heights grow, but for less than what a head is higher than its sides.
fn is_steady(mut heights: impl Iterator<Item = f64>) -> bool {
    let mut lowest = f64::NEG_INFINITY;
    heights.all(|z| {
        lowest = lowest.max(z);
        lowest - z < HEAD_BESIDE_GROOVE
    })
}

/// What is unlikely about the place of a wheel's running circle and the width of the points, in
/// words; `points` are in order and where the profile has them.
pub(crate) fn unlikely(profile: &ProfilePoints, kind: ProfileKind) -> Option<String> {
    let points = &profile.points;
    let y = range(points, 0);
    let [from, to] = y.map(|y| 1e3 * y);
    let width = to - from;
    let narrowest = if kind == ProfileKind::Wheel { NARROWEST_WHEEL } else { NARROWEST_RAIL };
    if width < 1e3 * narrowest {
        return Some(format!(
            "the {kind} is {width:.1} mm wide, from y = {from:.1} to {to:.1} mm: that is a part of a profile, or in another unit"
        ));
    }
    if kind == ProfileKind::Rail {
        return None;
    }
    if -y[0] < EDGE || y[1] < EDGE {
        return Some(format!(
            "y = 0, the nominal running circle, lies at the edge of the wheel, which goes from y = {from:.1} to {to:.1} mm"
        ));
    }
    let around: Vec<_> =
        points.iter().filter(|p| p.point[0].abs() < AROUND).map(|p| p.point).collect();
    let [first, last] = [around.first()?, around.last()?];
    let slope = (last[1] - first[1]) / (last[0] - first[0]).max(f64::MIN_POSITIVE);
    (slope.abs() > STEEPEST_TREAD).then(|| {
        format!(
            "y = 0, the nominal running circle, lies on a flank of {:.0} degrees, in the flange",
            slope.abs().atan().to_degrees()
        )
    })
}

/// What is unlikely about the height at the running circle of a wheel whose z counts from there, in
/// words.
pub(crate) fn off_circle(profile: &ProfilePoints) -> Option<String> {
    let height = profile.points.iter().find(|p| p.point[0] >= 0.0)?.point[1];
    (height.abs() > WORN_AWAY).then(|| {
        format!(
            "z = {:.1} mm at y = 0, where it counts from: the radius there is the nominal one plus that",
            1e3 * height
        )
    })
}

/// Whether a wheel with positive y has its flange at the far end: then y counts from the field
/// side, and where the running circle is is not said.
pub(crate) fn flange_is_far(profile: &ProfilePoints) -> Option<usize> {
    let points = &profile.points;
    let mut heights: Vec<f64> = points.iter().map(|p| p.point[1]).collect();
    heights.sort_by(f64::total_cmp);
    let tread = heights[heights.len() / 2];
    let off = |p: &&FilePoint| (p.point[1] - tread).abs();
    let tip = points.iter().max_by(|a, b| off(a).total_cmp(&off(b)))?;
    let [from, to] = range(points, 0);
    // A rim face or a chamfer at the very end goes the other way from the axle than a flange.
    let is_flange = off(&tip) > FLANGE_RISE && to - tip.point[0] > RIM_FACE / 4.0;
    (is_flange && tip.point[0] > 0.5 * (from + to)).then_some(tip.line)
}

/// Whether only the side at positive y of a rail goes down as deep as a gauge face does.
pub(crate) fn gauge_side_is_positive(profile: &ProfilePoints) -> bool {
    let points = profile.points.iter().map(|p| p.point);
    let Some(top) = points.clone().min_by(|a, b| a[1].total_cmp(&b[1])) else { return false };
    // The walls of a groove are not the sides of the rail.
    let ends = [profile.points[0], profile.points[profile.points.len() - 1]];
    if ends.iter().all(|end| end.point[1] < top[1] + GAUGE_DEPTH) {
        return false;
    }
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
