//! `MiniProf` files (.whl, .ban): a header, a blank line, and points with two or more columns.
//!
//! The header is free text or `key=value`. Used are `ColumnDef` (which columns are X and Y; without
//! it the first two), `XYPoints` (the number of points, to notice a file that is cut off) and any
//! mention of the unit. Offsets, alignment and reference points in the header are left alone.
//!
//! **Units**: millimetres unless the header says inch, or a `Units=` entry says `in`. If it says
//! neither, a profile less than 10 units across is taken for one in inches: no wheel or rail is
//! that small in millimetres, nor that large in inches.
//!
//! **Frame of the files**: in a wheel file X counts from the flange back to the field side and Y
//! outwards from the axle, so that the flange tip is at about +28 mm and our z is their Y. In a
//! rail file Y points up and the measured gauge face is at positive X: both are mirrored. If only
//! one side of a rail reaches 14 mm below its top, that side is taken for the gauge side, whatever
//! its sign. A rail with Y down, as rollers of test rigs are found, is turned up.
//!
//! Among the points what follows `#`, `!`, `%` or `"` is a comment.
//!
//! **Origin**: wheels are moved to their nominal rolling circle, 70 mm from the flange back, and
//! rails to their highest point.

use crate::geometry::profiles::point_noise::last_digit;
use crate::geometry::profiles::profile::{ProfileError, ProfileKind};
use crate::geometry::profiles::profile_points::{FilePoint, ProfilePoints, Remedies};
use crate::io::point_lines::{PointLines, comment_of, parted};
use crate::io::stated::Stated;
use crate::io::table::{Line, lines, number, numbers};
use crate::math::real::Real;

const REMEDIES: Remedies = Remedies {
    units: "write Units=mm or Units=inch into the header",
    mirror_y: "change the sign of the X column, or write # mirror_y 1 and # shift_y_mm",
    mirror_z: "change the sign of the Y column, or write # mirror_z 1 (MiniProf: flange tip positive, rail sides negative)",
};

const EXPECTED: &str = "after the header every line needs the numbers of the columns in ColumnDef (X and Y at \
                        least); correct or delete the line";

const INCH: f64 = 0.0254;
const MM: f64 = 1e-3;
/// Widest profile taken to be in inches if the header does not say, in units of the file.
const WIDEST_IN_INCHES: f64 = 10.0;

/// Whether a text looks like a `MiniProf` file.
pub(crate) fn is_recognised(content: &str) -> bool {
    content.trim_start().trim_start_matches('#').starts_with("MINI")
        || lines(content)
            .any(|l| l.text.starts_with("XYPoints=") || l.text.starts_with("ColumnDef="))
}

#[derive(Debug, Default)]
struct Header {
    /// Columns of X and Y, from 0.
    columns: Option<[usize; 2]>,
    /// Number of points that the header announces.
    count: Option<usize>,
    /// Length of the unit [m].
    unit: Option<f64>,
}

pub(crate) fn read(
    file: &str,
    content: &str,
    kind: ProfileKind,
    stated: &Stated,
) -> Result<ProfilePoints, ProfileError> {
    let all: Vec<Line> = lines(content).collect();
    let Some(start) = first_point(&all) else {
        return Err(ProfileError::UnknownFormat {
            file: file.into(),
            line: all.len(),
            what: "it ends without a line of numbers".into(),
        });
    };
    let header = read_header(file, &all[..start])?;

    let pick = header.columns.unwrap_or([0, 1]);
    let mut found = PointLines::new(file, pick, 2..=usize::MAX, EXPECTED);
    for line in &all[start..] {
        found.read(*line)?;
    }
    let (last_digit, remarks) = (last_digit(&found.coordinates()), found.remarks(0));
    let (mut points, left_out) = (found.points, found.left_out);
    if let Some(count) = header.count.filter(|&count| count > points.len() + left_out) {
        return Err(ProfileError::Truncated {
            file: file.into(),
            line: points.last().map_or(start, |p| p.line),
            what: format!("it has {} points and its header announces {count}", points.len()),
        });
    }
    let unit = stated.unit.or(header.unit).unwrap_or_else(|| unit_from_extent(&points));
    let sign = if kind == ProfileKind::Rail { -1.0 } else { 1.0 };
    for p in &mut points {
        p.point = p.point.map(|x| x * unit * sign);
    }
    Ok(ProfilePoints {
        file: file.into(),
        points,
        last_digit: last_digit * unit,
        unit_is_stated: header.unit.is_some(),
        is_measured_rail: kind == ProfileKind::Rail,
        remedies: REMEDIES,
        remarks,
        ..ProfilePoints::default()
    })
}

/// Lines of points that follow each other from which on they are no part of a header, which may hold
/// a few numbers too.
const FEWEST_IN_A_ROW: usize = 5;

/// Where the points begin: after the last blank line before the first lines of numbers that follow
/// each other, even if the first point is spoilt; without a blank line where these lines begin.
fn first_point(all: &[Line]) -> Option<usize> {
    // A spoilt point begins with a number all the same.
    let begins_with_number = |line: &Line| {
        let first = line.text.split([' ', '\t', ',', ';']).find(|c| !c.is_empty());
        first.is_some_and(|column| number(column).is_some())
    };
    let is_point = |line: &Line| numbers(parted(line.text).0).is_some_and(|n| n.len() >= 2);
    let is_comment = |line: &Line| comment_of(line.text).is_some();
    let in_a_row = |from: usize| {
        let row = all[from..].iter().filter(|l| !is_comment(l)).take(FEWEST_IN_A_ROW);
        row.take_while(|l| is_point(l)).count()
    };
    let rows = (0..all.len()).filter(|&i| is_point(&all[i]));
    let first = rows.clone().find(|&i| in_a_row(i) == FEWEST_IN_A_ROW).or_else(|| {
        // Of so few points the first ones.
        rows.clone().next()
    })?;
    let blank = all[..first].iter().rposition(|l| l.text.is_empty()).map(|i| i + 1);
    let is_of_points = |from: &usize| {
        *from > 1 && all[*from..first].iter().all(|l| begins_with_number(l) || is_comment(l))
    };
    Some(blank.filter(is_of_points).unwrap_or(first))
}

fn read_header(file: &str, header: &[Line]) -> Result<Header, ProfileError> {
    let mut found = Header::default();
    for line in header {
        let refused = |allowed| line.refused(file, allowed);
        let (key, value) = line.text.split_once('=').unwrap_or(("", line.text));
        let value = value.trim();
        match key.trim().trim_matches('"').to_ascii_lowercase().as_str() {
            "columndef" if !value.is_empty() => {
                let place = |name: &str| {
                    value
                        .split(',')
                        .position(|c| c.trim().trim_matches('"').eq_ignore_ascii_case(name))
                };
                let (Some(x), Some(y)) = (place("X"), place("Y")) else {
                    return Err(refused(
                        "ColumnDef must name the columns X and Y, as in ColumnDef=X,Y",
                    ));
                };
                found.columns = Some([x, y]);
            }
            "xypoints" if !value.is_empty() => {
                let count =
                    value.parse().map_err(|_| refused("XYPoints must be the number of points"))?;
                found.count = Some(count);
            }
            "unit" | "units" | "xyunit" | "xyunits" if !value.is_empty() => {
                let unit = unit_named(value).or_else(|| {
                    let short = value.trim_matches('"');
                    short.eq_ignore_ascii_case("in").then_some(INCH)
                });
                found.unit = Some(unit.ok_or_else(|| refused("the unit must be mm or inch"))?);
            }
            // Free text counts only where it is not the value of some other entry, such as a file
            // name.
            "" => found.unit = unit_named(value).or(found.unit),
            _ => {}
        }
    }
    Ok(found)
}

/// The unit that a text mentions as a word [m].
fn unit_named(text: &str) -> Option<f64> {
    text.split(|c: char| !c.is_alphabetic()).find_map(|word| {
        match word.to_ascii_lowercase().as_str() {
            "inch" | "inches" | "imperial" => Some(INCH),
            "mm" | "millimetre" | "millimetres" | "millimeter" | "millimeters" | "metric" => {
                Some(MM)
            }
            _ => None,
        }
    })
}

fn unit_from_extent(points: &[FilePoint]) -> f64 {
    let extent = |i: usize| {
        let values = points.iter().map(|p| p.point[i]);
        values.clone().fold(f64::NEG_INFINITY, f64::max) - values.fold(f64::INFINITY, f64::min)
    };
    if extent(0).hypotenuse(extent(1)) < WIDEST_IN_INCHES { INCH } else { MM }
}

#[cfg(test)]
mod tests {
    use std::fmt::Write;

    use approx::assert_relative_eq;

    use super::*;

    fn read(file: &str, content: &str, kind: ProfileKind) -> Result<ProfilePoints, ProfileError> {
        let stated = Stated::of(file, content)?;
        super::read(file, content, kind, &stated).map(|points| stated.apply(points))
    }
    use crate::geometry::profiles::profile_points::tests::sampled;

    const WHEEL: ProfileKind = ProfileKind::Wheel;
    const RAIL: ProfileKind = ProfileKind::Rail;

    /// A wheel as `MiniProf` writes it: from the flange back, in the given unit, after the given
    /// header.
    fn wheel_file(header: &str, unit: f64) -> String {
        let mut text = format!("{header}\n\n");
        for [y, z] in sampled("S1002", WHEEL, 5e-4) {
            writeln!(text, "{:.6} {:.6} 0.000", (y + 0.07) / unit, z / unit).unwrap();
        }
        text
    }

    /// The gauge half of a rail as `MiniProf` writes it, its gauge side at the given sign of X.
    fn rail_file(header: &str, gauge_sign: f64) -> String {
        let mut text = format!("{header}\n\n");
        for [y, z] in
            sampled("60E1", RAIL, 5e-4).into_iter().filter(|p| p[0] < 0.012 && p[1] < 0.03)
        {
            writeln!(text, "0.0 {:.6} {:.6}", -gauge_sign * y / MM + 3.0, 5.0 - z / MM).unwrap();
        }
        text
    }

    #[test]
    fn wheels_in_millimetres_and_inches_come_out_the_same() {
        let headers = [
            ("MINIPROF 101 1994\nfile.prd\n32.58 37.11 14.71  (Sd/Sh/qR)", MM),
            ("MINIPROF 101 1994\nfile.prd", INCH),
            ("Filename=inch.whl\nUnits=mm", MM),
            ("Filename=mm.whl\nUnits=inch", INCH),
            ("Units=\"in\"\nXYPoints=10", INCH),
            ("measured in inches", INCH),
            ("XYPoints=20\nColumnDef=X,Y,A", MM),
        ];
        for (header, unit) in headers {
            let text = wheel_file(header, unit);
            let profile = read("a.whl", &text, WHEEL).unwrap().into_profile(WHEEL, 0.0).unwrap();
            let bounds = profile.bounds();
            assert_relative_eq!(bounds.z[1], 0.028, epsilon = 1e-6);
            assert_relative_eq!(bounds.y[0], -0.070, epsilon = 1e-6);
            assert_relative_eq!(bounds.y[1], 0.065, epsilon = 1e-6);
        }
    }

    #[test]
    fn rails_are_turned_upright_with_their_gauge_side_to_negative_y_and_their_top_to_the_origin() {
        for sign in [1.0, -1.0] {
            let text = rail_file("ColumnDef=A,X,Y", sign);
            let profile = read("a.ban", &text, RAIL).unwrap().into_profile(RAIL, 0.0).unwrap();
            let bounds = profile.bounds();
            assert_relative_eq!(bounds.z[0], 0.0, epsilon = 1e-12);
            assert!((0.029..0.031).contains(&bounds.z[1]), "{bounds:?}");
            assert_relative_eq!(bounds.y[0], -0.0368, epsilon = 2e-4);
            assert_relative_eq!(bounds.y[1], 0.012, epsilon = 1e-3);
            assert!(profile.curve.at(profile.curve.start()).point[1] > 0.02);
        }
    }

    #[test]
    fn entries_and_lines_that_cannot_be_used_are_named() {
        for header in ["ColumnDef=A,B", "XYPoints=many", "Units=furlong"] {
            let text = wheel_file(&format!("MINIPROF\n{header}"), MM);
            let error = read("a.whl", &text, WHEEL).unwrap_err();
            assert!(matches!(error, ProfileError::BadHeader { line: 2, .. }), "{error}");
            assert!(error.to_string().contains(header), "{error}");
        }
        let spoilt = wheel_file("MINIPROF", MM).replacen("0.000\n", "0.0x0\n", 1);
        let error = read("a.whl", &spoilt, WHEEL).unwrap_err();
        assert!(matches!(error, ProfileError::BadLine { line: 3, .. }), "{error}");
        assert!(error.to_string().contains("ColumnDef"), "{error}");
        let error = read("a.whl", "MINIPROF\n\n", WHEEL).unwrap_err();
        assert!(matches!(error, ProfileError::UnknownFormat { .. }), "{error}");
    }

    #[test]
    fn files_are_recognised_by_their_header() {
        assert!(is_recognised("MINIPROF 101\n"));
        assert!(is_recognised("Filename=x\nXYPoints=3\n"));
        assert!(!is_recognised("1 2\n3 4\n"));
    }
}
