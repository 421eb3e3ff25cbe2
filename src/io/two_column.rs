//! Plain text with two columns: `y_mm`, positive to the field side, and `z_mm`, positive down.
//!
//! Columns are separated by blanks, tabs, commas or semicolons (with semicolons a comma is a
//! decimal point). What follows `#` or `!` is a comment. One line of headings may stand before the
//! first point. A comment `# smoothing_mm 0.5` stands for the wavelength at which this file is to be smoothed, whatever
//! `profile.smoothing` says; files written by [`text`] have 0. The points follow the profile, from either end. Wheel: y = 0 on the running circle,
//! or on the flange back if no y is negative. Rail: any origin.

use std::fmt::Write;

use crate::geometry::profile::{Profile, ProfileError};
use crate::geometry::profile_points::{FilePoint, ProfilePoints, Remedies};
use crate::io::table::{lines, numbers};

const REMEDIES: Remedies = Remedies {
    units: "both columns must be in millimetres",
    mirror_y: "change the sign of the first column",
    mirror_z: "change the sign of the second column",
};

const EXPECTED: &str = "give two numbers, y_mm z_mm, on each line, with decimal points (or decimal commas and \
                        semicolons between the columns), and comments after #";

pub(crate) fn read(file: &str, content: &str) -> Result<ProfilePoints, ProfileError> {
    let mut points = Vec::new();
    let mut headings = None;
    let mut smoothing = None;
    for mut line in lines(content) {
        smoothing = smoothing.or_else(|| stated_smoothing(line.text));
        line.text = line.text.split(['#', '!']).next().unwrap_or_default().trim();
        if line.text.is_empty() {
            continue;
        }
        if points.is_empty() && headings.is_none() && is_heading(line.text) {
            headings = Some(line);
            continue;
        }
        match line.point(file, [0, 1], 2..=2, EXPECTED) {
            Ok(point) => {
                let point = point.map(|x| x * 1e-3);
                points.push(FilePoint { point, line: line.number });
            }
            // Two lines of words and no point yet: this is some other kind of file.
            Err(_) if points.is_empty() && is_heading(line.text) => {
                return Err(ProfileError::UnknownFormat {
                    file: file.into(),
                    line: headings.map_or(line.number, |h| h.number),
                    what: format!(
                        "found \"{}\" and no numbers",
                        headings.map_or_else(|| line.shown(), |h| h.shown())
                    ),
                });
            }
            Err(error) => return Err(error),
        }
    }
    Ok(ProfilePoints {
        file: file.into(),
        points,
        rail_origin_on_top: false,
        smoothing,
        remedies: REMEDIES,
    })
}

/// The wavelength of a comment that states one [m].
fn stated_smoothing(line: &str) -> Option<f64> {
    let value = line.trim().strip_prefix('#')?.trim().strip_prefix(SMOOTHING)?.trim();
    value.parse().ok().map(|mm: f64| 1e-3 * mm).filter(|w| (0.0..=0.05).contains(w))
}

const SMOOTHING: &str = "smoothing_mm";

/// The text of a file with the points of a profile, dense enough that the curve between them follows.
pub(crate) fn text(profile: &Profile) -> String {
    let curve = &profile.curve;
    let mut text = format!(
        "# {} profile, from {}; y to the field side, z down\n# {SMOOTHING} 0\ny_mm,z_mm\n",
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
        let pieces = ((pair[1] - pair[0]) / MOST_SPACING).ceil().max(1.0);
        for i in 0..pieces as usize {
            write(pair[0] + (pair[1] - pair[0]) * i as f64 / pieces);
        }
    }
    write(curve.end());
    text
}

/// Greatest distance of the points of a file [m].
const MOST_SPACING: f64 = 1e-4;

/// Words only: a line with a number in its first column is a point, good or bad.
fn is_heading(text: &str) -> bool {
    let first = text.split([' ', '\t', ',', ';']).find(|c| !c.is_empty());
    first.is_none_or(|column| numbers(column).is_none()) && numbers(text).is_none()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_headings_and_blank_lines_are_passed_over() {
        let read = read("rail.txt", "# a rail\ny_mm; z_mm\n\n-1,5; 2,0 # first\n! note\n1.0; 3\n")
            .unwrap();
        assert_eq!(read.points.len(), 2);
        assert_eq!(read.points[0].line, 4);
        approx::assert_relative_eq!(read.points[0].point[0], -0.0015);
        approx::assert_relative_eq!(read.points[1].point[1], 0.003);
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

    #[test]
    fn a_text_without_numbers_is_no_profile() {
        let error = read("notes.txt", "\nDear reader,\nthis is a letter.\n").unwrap_err();
        assert!(matches!(&error, ProfileError::UnknownFormat { line: 2, .. }), "{error}");
        assert!(error.to_string().contains("y_mm z_mm"), "{error}");
    }
}
