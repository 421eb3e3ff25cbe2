//! Plain text with two columns: `y_mm`, positive to the field side, and `z_mm`, positive down.
//!
//! Columns are separated by blanks, tabs, commas or semicolons (with semicolons a comma is a
//! decimal point). What follows `#`, `!`, `%` or `"` is a comment. Headings may stand before the
//! first point. The points follow the profile, from either end. Wheel: y = 0 on the nominal rolling
//! circle, or on the flange back if no y is negative. Rail: any origin.
//!
//! A comment of its own may state how the file is meant; then nothing is guessed:
//!
//! | comment | meaning |
//! | --- | --- |
//! | `# smoothing_mm 0.5` | wavelength at which this file is to be smoothed, whatever `profile.smoothing` says; files written by [`text`] have 0 |
//! | `# unit m` | unit of both columns: `m`, `mm` or `in` |
//! | `# mirror_y 1` | the sign of y is to be changed (1) or not (0) |
//! | `# mirror_z 0` | the sign of z is to be changed (1) or not (0): a groove is no head that stands upside down |

use std::fmt::Write;

use crate::geometry::profiles::point_noise::last_digit;
use crate::geometry::profiles::profile::{Profile, ProfileError};
use crate::geometry::profiles::profile_points::{ProfilePoints, Remedies};
use crate::io::point_lines::{PointLines, parted};
use crate::io::table::{Line, lines, number};

const REMEDIES: Remedies = Remedies {
    units: "both columns should be in millimetres, or a line # unit m, mm or in say otherwise",
    mirror_y: "change the sign of the first column, or write # mirror_y 1",
    mirror_z: "change the sign of the second column, or write # mirror_z 1 (0 if it is meant as it stands)",
};

const EXPECTED: &str = "give two numbers, y_mm z_mm, on each line, with decimal points (or decimal commas and \
                        semicolons between the columns), and comments after #";

/// One line of headings is part of the format.
const HEADINGS: usize = 1;

/// What the comments of a file state.
#[derive(Debug, Default)]
struct Stated {
    /// [m]
    smoothing: Option<f64>,
    /// [m]
    unit: Option<f64>,
    mirror: [Option<bool>; 2],
}

pub(crate) fn read(file: &str, content: &str) -> Result<ProfilePoints, ProfileError> {
    let mut found = PointLines::new(file, [0, 1], 2..=2, EXPECTED);
    let mut stated = Stated::default();
    for line in lines(content) {
        let (data, comment) = parted(line.text);
        if data.is_empty() {
            stated.read(file, line, comment)?;
        }
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
    let factor = stated.mirror.map(|mirror| if mirror == Some(true) { -unit } else { unit });
    let (last_digit, remarks) = (unit * last_digit(&found.coordinates()), found.remarks(HEADINGS));
    let mut points = found.points;
    for p in &mut points {
        p.point = [factor[0] * p.point[0], factor[1] * p.point[1]];
    }
    Ok(ProfilePoints {
        file: file.into(),
        points,
        last_digit,
        unit_is_stated: stated.unit.is_some(),
        direction_is_stated: stated.mirror[1].is_some(),
        is_measured_rail: false,
        smoothing: stated.smoothing,
        remedies: REMEDIES,
        remarks,
    })
}

const MM: f64 = 1e-3;

impl Stated {
    /// Reads a comment; other text than the entries is a comment.
    fn read(&mut self, file: &str, line: Line, comment: &str) -> Result<(), ProfileError> {
        let mut words = comment.split_whitespace();
        let (Some(key), Some(value), None) = (words.next(), words.next(), words.next()) else {
            return Ok(());
        };
        let refused = |allowed| line.refused(file, allowed);
        let flag = || match value {
            "0" => Ok(Some(false)),
            "1" => Ok(Some(true)),
            _ => Err(refused("mirror_y and mirror_z are 0 (no) or 1 (yes)")),
        };
        match key {
            SMOOTHING => {
                let wavelength = number(value).map(|mm| MM * mm);
                let admitted = wavelength.filter(|w| (0.0..=0.05).contains(w));
                let allowed = "smoothing_mm is a wavelength from 0 (no smoothing) to 50 mm";
                self.smoothing = Some(admitted.ok_or_else(|| refused(allowed))?);
            }
            "unit" => {
                let unit = match value {
                    "m" => 1.0,
                    "mm" => MM,
                    "in" => 0.0254,
                    _ => return Err(refused("the unit is m, mm or in")),
                };
                self.unit = Some(unit);
            }
            "mirror_y" => self.mirror[0] = flag()?,
            MIRROR_Z => self.mirror[1] = flag()?,
            _ => {}
        }
        Ok(())
    }
}

const SMOOTHING: &str = "smoothing_mm";
const MIRROR_Z: &str = "mirror_z";

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
    fn what_the_comments_state_is_taken() {
        let stated = "# unit m\n# smoothing_mm 0.5\n# mirror_y 1\n# mirror_z 0\n";
        let read = read("rail.txt", &format!("{stated}0.001 0.002\n")).unwrap();
        approx::assert_relative_eq!(read.points[0].point[0], -0.001);
        approx::assert_relative_eq!(read.points[0].point[1], 0.002);
        approx::assert_relative_eq!(read.smoothing.unwrap(), 5e-4);
        approx::assert_relative_eq!(read.last_digit, 1e-3);
        assert!(read.unit_is_stated && read.direction_is_stated);
        // Prose that begins with one of the words states nothing.
        let prose = super::read("rail.txt", "# unit of both columns: mm\n1 2\n").unwrap();
        assert!(!prose.unit_is_stated);
        for bad in ["# unit furlong", "# mirror_z yes", "# smoothing_mm 60"] {
            let error = super::read("rail.txt", &format!("{bad}\n1 2\n")).unwrap_err();
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

    #[test]
    fn a_text_without_numbers_is_no_profile() {
        let error = read("notes.txt", "\nDear reader,\nthis is a letter.\n").unwrap_err();
        assert!(matches!(&error, ProfileError::UnknownFormat { line: 2, .. }), "{error}");
        assert!(error.to_string().contains("y_mm z_mm"), "{error}");
    }
}
