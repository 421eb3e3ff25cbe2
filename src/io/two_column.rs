//! Plain text with two columns: `y_mm`, positive to the field side, and `z_mm`, positive down.
//!
//! Columns are separated by blanks, tabs, commas or semicolons (with semicolons a comma is a
//! decimal point). What follows `#`, `!`, `%` or `"` is a comment. Headings may stand before the
//! first point. The points follow the profile, from either end. Wheel: y = 0 on the nominal rolling
//! circle, or on the flange back if no y is negative. Rail: any origin.
//!
//! Comments may state how the file is meant ([`stated`](super::stated)); files written by [`text`] say
//! that they are neither smoothed nor mirrored.

use std::fmt::Write;

use crate::geometry::profiles::point_noise::last_digit;
use crate::geometry::profiles::profile::{Profile, ProfileError};
use crate::geometry::profiles::profile_points::{ProfilePoints, Remedies};
use crate::io::point_lines::PointLines;
use crate::io::stated::{MIRROR_Z, SMOOTHING, Stated};
use crate::io::table::lines;

const REMEDIES: Remedies = Remedies {
    units: "both columns should be in millimetres, or a line # unit m, mm or in say otherwise",
    mirror_y: "change the sign of the first column, or write # mirror_y 1 and # shift_y_mm",
    mirror_z: "change the sign of the second column, or write # mirror_z 1 (0 if it is meant as it stands)",
};

const EXPECTED: &str = "give two numbers, y_mm z_mm, on each line, with decimal points (or decimal commas and \
                        semicolons between the columns), and comments after #";

/// One line of headings is part of the format.
const HEADINGS: usize = 1;

pub(crate) fn read(
    file: &str,
    content: &str,
    stated: &Stated,
) -> Result<ProfilePoints, ProfileError> {
    let mut found = PointLines::new(file, [0, 1], 2..=2, EXPECTED);
    for line in lines(content) {
        found.read(line)?;
    }
    if let (true, Some(first)) = (found.points.is_empty(), found.passed_over.first()) {
        return Err(ProfileError::UnknownFormat {
            file: file.into(),
            line: first.number,
            what: format!("found \"{}\" and no points", first.shown()),
        });
    }
    let unit = stated.unit.unwrap_or(MM);
    let (last_digit, remarks) = (unit * last_digit(&found.coordinates()), found.remarks(HEADINGS));
    let mut points = found.points;
    for p in &mut points {
        p.point = p.point.map(|x| x * unit);
    }
    Ok(ProfilePoints {
        file: file.into(),
        points,
        last_digit,
        remedies: REMEDIES,
        remarks,
        ..ProfilePoints::default()
    })
}

const MM: f64 = 1e-3;

/// The text of a file with the points of a profile, dense enough that the curve between them
/// follows.
pub(crate) fn text(profile: &Profile) -> String {
    let curve = &profile.curve;
    let mut text = format!(
        "# {} profile, from {}; y to the field side, z down\n# {SMOOTHING} 0\n# {MIRROR_Z} 0\ny_mm,z_mm\n",
        profile.kind,
        profile.name.replace(['\n', '\r'], " ")
    );
    let knots: Vec<f64> = curve.knots().collect();
    let mut write = |s: f64| {
        let [y, z] = curve.at(s).point.map(|x| 1e3 * x);
        // Writing to a text cannot fail.
        let _ = writeln!(text, "{y:.10},{z:.10}");
    };
    for pair in knots.windows(2) {
        let pieces = ((pair[1] - pair[0]) / MAX_SPACING).ceil().max(1.0);
        for i in 0..pieces as usize {
            write(pair[0] + (pair[1] - pair[0]) * i as f64 / pieces);
        }
    }
    write(curve.end());
    text
}

/// Greatest distance of the points of a file [m].
const MAX_SPACING: f64 = 1e-4;

#[cfg(test)]
mod tests {
    use super::*;

    fn read(file: &str, content: &str) -> Result<ProfilePoints, ProfileError> {
        let stated = Stated::of(file, content)?;
        super::read(file, content, &stated).map(|points| stated.apply(points))
    }

    #[test]
    fn comments_headings_and_blank_lines_are_passed_over() {
        let read =
            self::read("rail.txt", "# a rail\ny_mm; z_mm\n\n-1,5; 2,0 # first\n! note\n1.0; 3\n")
                .unwrap();
        assert_eq!(read.points.len(), 2);
        assert_eq!(read.points[0].line, 4);
        approx::assert_relative_eq!(read.points[0].point[0], -0.0015);
        approx::assert_relative_eq!(read.points[1].point[1], 0.003);
    }

    #[test]
    fn what_the_comments_state_is_taken() {
        let stated = "# unit m\n# smoothing_mm 0.5\n# mirror_y 1\n# mirror_z 0\n";
        let read = self::read("rail.txt", &format!("{stated}0.001 0.002\n")).unwrap();
        approx::assert_relative_eq!(read.points[0].point[0], -0.001);
        approx::assert_relative_eq!(read.points[0].point[1], 0.002);
        approx::assert_relative_eq!(read.smoothing.unwrap(), 5e-4);
        approx::assert_relative_eq!(read.last_digit, 1e-3);
        assert!(read.unit_is_stated && read.direction_is_stated);
        // Prose that begins with one of the words states nothing.
        let prose = self::read("rail.txt", "# unit of both columns: mm\n1 2\n").unwrap();
        assert!(!prose.unit_is_stated);
        for bad in ["# unit furlong", "# mirror_z yes", "# smoothing_mm 60"] {
            let error = self::read("rail.txt", &format!("{bad}\n1 2\n")).unwrap_err();
            assert!(matches!(error, ProfileError::BadHeader { line: 1, .. }), "{error}");
        }
    }

    #[test]
    fn bad_lines_are_named_with_file_line_and_what_to_give() {
        for (content, line) in
            [("1 2\n3 4 5\n", 2), ("1 2\n3\n", 2), ("1 2\n\nx 4\n", 3), ("1,5 2,5\n", 1)]
        {
            let error = read("rail.txt", content).unwrap_err();
            assert!(
                matches!(&error, ProfileError::BadLine { line: l, .. } if *l == line),
                "{error}"
            );
            let text = error.to_string();
            assert!(text.starts_with(&format!("rail.txt:{line}: ")), "{text}");
            assert!(text.contains("give two numbers"), "{text}");
        }
    }

    #[test]
    fn values_that_are_not_finite_are_named() {
        for value in ["nan", "NaN", "inf", "-Infinity", "1e999"] {
            let error = read("rail.txt", &format!("y z\n1 2\n3 {value}\n")).unwrap_err();
            assert!(matches!(&error, ProfileError::NotFinite { line: 3, .. }), "{error}");
            assert!(error.to_string().contains("rail.txt:3:"), "{error}");
            assert!(error.to_string().contains("delete the point"), "{error}");
        }
    }
}
