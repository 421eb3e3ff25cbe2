//! SIMPACK profile files (.prw wheel, .prr rail).
//!
//! `key = value` entries in the blocks `header` and `spline`, and points between `point.begin` and
//! `point.end`; what follows `!` outside quotes is a comment, among the points also what follows
//! `#`, `%` or `"`. The entries are applied in the order of their numbers in the files:
//!
//! 1. `point.dist.min`: a point closer to the one before is dropped
//! 2. `shift.y`, `shift.z`: added
//! 3. `rotate`: about x, from y towards z
//! 4. `bound.y.min|max`, `bound.z.min|max`: points outside are dropped; off unless min < max
//! 5. `mirror.y`, `mirror.z`: sign changed if 1
//! 6. `inversion`: order reversed if 1; without effect here, since the order follows from y
//! 7. `units.len.f`, `units.ang.f`: units of the file in one metre, one radian (1000 for
//!    millimetres); 1 if left out
//!
//! `type` in the header (0 rail, 1 wheel) must be that of the body. `approx.smooth` and the weights
//! of a third column are not used: smoothing is set by its wavelength. The frame is ours: y to the
//! field side and z down for the right side. So a rail that is lower in its middle than at its
//! sides is a groove and stays one.

use crate::geometry::profiles::point_noise::last_digit;
use crate::geometry::profiles::profile::{ProfileError, ProfileKind};
use crate::geometry::profiles::profile_points::{FilePoint, ProfilePoints, Remedies};
use crate::io::point_lines::PointLines;
use crate::io::table::{Line, lines, number};
use crate::math::real::Real;

const REMEDIES: Remedies = Remedies {
    units: "set units.len.f to the number of units in a metre, 1000 for millimetres",
    mirror_y: "set mirror.y = 1 (or 0 if it is 1), and shift.y",
    mirror_z: "set mirror.z = 1 (or 0 if it is 1)",
};

const EXPECTED: &str =
    "give two numbers, y and z, and at most a third, the weight; correct or delete the line";

/// Whether a text looks like a SIMPACK profile.
pub(crate) fn is_recognised(content: &str) -> bool {
    lines(content).any(|l| without_comment(l.text) == "point.begin")
}

/// Entries that change the points; those that are left out change nothing.
#[derive(Debug)]
struct Entries {
    point_distance: f64,
    shift: [f64; 2],
    rotate: f64,
    bounds: [[f64; 2]; 2],
    mirror: [bool; 2],
    units_per_metre: f64,
    units_per_radian: f64,
}

impl Default for Entries {
    fn default() -> Self {
        Self {
            point_distance: 0.0,
            shift: [0.0; 2],
            rotate: 0.0,
            bounds: [[1.0, 0.0]; 2],
            mirror: [false; 2],
            units_per_metre: 1.0,
            units_per_radian: 1.0,
        }
    }
}

/// Which block of the file a line stands in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Block {
    Outside,
    Header,
    Spline,
    Points,
    Done,
}

pub(crate) fn read(
    file: &str,
    content: &str,
    kind: ProfileKind,
) -> Result<ProfilePoints, ProfileError> {
    let mut entries = Entries::default();
    let mut found = PointLines::new(file, [0, 1], 2..=3, EXPECTED);
    let mut block = Block::Outside;
    let mut last = 1;
    for mut line in lines(content) {
        line.text = without_comment(line.text);
        if line.text.is_empty() {
            continue;
        }
        last = line.number;
        block = match (block, line.text) {
            (Block::Done, "point.begin") => {
                let allowed = "a file can hold one profile only: give each its own file";
                return Err(line.refused(file, allowed));
            }
            (Block::Outside, "header.begin") => Block::Header,
            (Block::Outside, "spline.begin") => Block::Spline,
            (Block::Header, "header.end") => Block::Outside,
            (_, "point.begin") => Block::Points,
            (Block::Points, "point.end") => Block::Done,
            (Block::Points, _) => {
                found.read(line)?;
                block
            }
            (Block::Header, text) => {
                check_type(file, &line, text, kind)?;
                block
            }
            // The factors and flags may as well follow the points.
            (Block::Spline | Block::Done, text) => {
                entries.read(file, &line, text)?;
                block
            }
            (Block::Outside, _) => block,
        };
    }
    match block {
        Block::Done => {}
        Block::Points => {
            let what = "the points do not end with point.end".into();
            return Err(ProfileError::Truncated { file: file.into(), line: last, what });
        }
        _ => {
            let what = "there is no point.begin".into();
            return Err(ProfileError::UnknownFormat { file: file.into(), line: last, what });
        }
    }
    let last_digit = last_digit(&found.coordinates()) / entries.units_per_metre;
    let remarks = found.remarks(0);
    Ok(ProfilePoints {
        file: file.into(),
        points: entries.apply(found.points),
        last_digit,
        direction_is_stated: kind == ProfileKind::Rail,
        // The running circle, where the points reach it.
        origin_is_stated: true,
        remedies: REMEDIES,
        remarks,
        ..ProfilePoints::default()
    })
}

fn check_type(file: &str, line: &Line, text: &str, kind: ProfileKind) -> Result<(), ProfileError> {
    let Some((key, value)) = text.split_once('=') else { return Ok(()) };
    if key.trim() != "type" {
        return Ok(());
    }
    match (value.trim(), kind) {
        ("0", ProfileKind::Rail) | ("1", ProfileKind::Wheel) => Ok(()),
        ("0" | "1", _) => {
            Err(ProfileError::WrongKind { file: file.into(), line: line.number, kind })
        }
        _ => Err(line.refused(file, "the type must be 0 (rail) or 1 (wheel)")),
    }
}

impl Entries {
    fn read(&mut self, file: &str, line: &Line, text: &str) -> Result<(), ProfileError> {
        let Some((key, value)) = text.split_once('=') else { return Ok(()) };
        let refused = |allowed| line.refused(file, allowed);
        let finite = || {
            number(value.trim())
                .filter(|n| n.is_finite())
                .ok_or_else(|| refused("it must be a finite number"))
        };
        let positive = || {
            finite().ok().filter(|&n| n > 0.0).ok_or_else(|| {
                refused("it must be a positive number: units in a metre or a radian, 1000 for millimetres")
            })
        };
        let flag = || match value.trim() {
            "0" => Ok(false),
            "1" => Ok(true),
            _ => Err(refused("it must be 0 (no) or 1 (yes)")),
        };
        match key.trim() {
            "point.dist.min" => self.point_distance = finite()?,
            "shift.y" => self.shift[0] = finite()?,
            "shift.z" => self.shift[1] = finite()?,
            "rotate" => self.rotate = finite()?,
            "bound.y.min" => self.bounds[0][0] = finite()?,
            "bound.y.max" => self.bounds[0][1] = finite()?,
            "bound.z.min" => self.bounds[1][0] = finite()?,
            "bound.z.max" => self.bounds[1][1] = finite()?,
            "mirror.y" => self.mirror[0] = flag()?,
            "mirror.z" => self.mirror[1] = flag()?,
            "inversion" => _ = flag()?,
            "units.len.f" => self.units_per_metre = positive()?,
            "units.ang.f" => self.units_per_radian = positive()?,
            _ => {}
        }
        Ok(())
    }

    /// The points in metres and in the frame of the profile.
    fn apply(&self, points: Vec<FilePoint>) -> Vec<FilePoint> {
        let mut kept: Option<[f64; 2]> = None;
        let (sin, cos) = (self.rotate / self.units_per_radian).sin_cos();
        let inside = |value: f64, bound: [f64; 2]| {
            bound[0] >= bound[1] || (bound[0]..=bound[1]).contains(&value)
        };
        points
            .into_iter()
            .filter(|p| {
                let [y, z] = p.point;
                let far =
                    kept.is_none_or(|k| (y - k[0]).hypotenuse(z - k[1]) >= self.point_distance);
                if far {
                    kept = Some(p.point);
                }
                far
            })
            .map(|p| {
                let (y, z) = (p.point[0] + self.shift[0], p.point[1] + self.shift[1]);
                FilePoint { point: [cos * y - sin * z, sin * y + cos * z], ..p }
            })
            .filter(|p| inside(p.point[0], self.bounds[0]) && inside(p.point[1], self.bounds[1]))
            .map(|p| {
                let sign = self.mirror.map(|mirrored| if mirrored { -1.0 } else { 1.0 });
                let point = [0, 1].map(|i| sign[i] * p.point[i] / self.units_per_metre);
                FilePoint { point, ..p }
            })
            .collect()
    }
}

/// A line without its comment; an exclamation mark in quotes starts none.
fn without_comment(text: &str) -> &str {
    let mut quoted = false;
    let end = text.find(|c: char| {
        quoted ^= c == '\'';
        c == '!' && !quoted
    });
    text[..end.unwrap_or(text.len())].trim()
}

#[cfg(test)]
mod tests {
    use std::fmt::Write;

    use approx::assert_relative_eq;

    use super::*;
    use crate::geometry::profiles::profile_points::tests::sampled;

    const WHEEL: ProfileKind = ProfileKind::Wheel;

    /// A wheel with the given type and entries, its points scaled and changed by `change`.
    fn file(kind: u8, entries: &str, change: impl Fn([f64; 2]) -> [f64; 2]) -> String {
        let mut text = format!(
            "! made for a test\nheader.begin\n  version = 1 ! one\n  type = {kind}\nheader.end\nspline.begin\n\
             {entries}\n  comment = 'wow! it''s a \"wheel\" 100 %'\n  point.begin\n"
        );
        for point in sampled("S1002", WHEEL, 5e-4) {
            let [y, z] = change(point);
            writeln!(text, "    {y:.9E}\t{z:.9E}").unwrap();
        }
        text + "  point.end\nspline.end\n"
    }

    fn check_is_s1002(text: &str) {
        let profile = read("a.prw", text, WHEEL).unwrap().into_profile(WHEEL, 0.0).unwrap();
        let bounds = profile.bounds();
        assert_relative_eq!(bounds.z[1], 0.028, epsilon = 1e-6);
        assert_relative_eq!(bounds.y[0], -0.070, epsilon = 1e-6);
        assert_relative_eq!(bounds.y[1], 0.065, epsilon = 1e-6);
        assert_relative_eq!(
            profile.curve.at(profile.curve.start()).point[1],
            -0.02,
            epsilon = 1e-6
        );
    }

    #[test]
    fn units_mirrors_shifts_and_rotation_are_applied() {
        let mm = "units.len.f = 1000.";
        check_is_s1002(&file(1, "", |p| p));
        check_is_s1002(&file(1, mm, |p| p.map(|x| x * 1e3)));
        check_is_s1002(&file(1, "mirror.y = 1\ninversion = 1", |p| [-p[0], p[1]]));
        check_is_s1002(&file(1, "mirror.z = 1\ninversion = 0", |p| [p[0], -p[1]]));
        check_is_s1002(&file(1, &format!("shift.y = -10.0\nshift.z = 2\n{mm}"), |p| {
            [p[0] * 1e3 + 10.0, p[1] * 1e3 - 2.0]
        }));
        // The rotation acts before the mirror, from y towards z.
        let (sin, cos) = 0.3f64.sin_cos();
        check_is_s1002(&file(1, "rotate = 300\nunits.ang.f = 1000\nmirror.y = 1", |[y, z]| {
            [-cos * y + sin * z, sin * y + cos * z]
        }));
        check_is_s1002(&file(1, "rotate = 1\nunits.ang.f = 1D308", |p| p));
    }

    #[test]
    fn bounds_and_point_distance_drop_points() {
        let count =
            |entries: &str| read("a.prw", &file(1, entries, |p| p), WHEEL).unwrap().points.len();
        let all = count("");
        assert_eq!(count("bound.y.min = 1\nbound.y.max = 0"), all);
        assert!(count("bound.y.min = -0.03\nbound.y.max = 0.03") < all / 2);
        assert!(count("point.dist.min = 0.0009") < all * 6 / 10);
    }

    #[test]
    fn a_file_of_the_other_body_is_refused() {
        let error = read("a.prr", &file(0, "", |p| p), WHEEL).unwrap_err();
        assert!(matches!(error, ProfileError::WrongKind { line: 4, .. }), "{error}");
        assert!(error.to_string().contains("this is not a wheel profile"), "{error}");
        let error = read("a.prr", &file(7, "", |p| p), WHEEL).unwrap_err();
        assert!(matches!(error, ProfileError::BadHeader { line: 4, .. }), "{error}");
    }

    #[test]
    fn entries_that_cannot_be_used_are_named() {
        for entry in
            ["units.len.f = 0", "units.len.f = mm", "mirror.y = 2", "shift.y = nan", "rotate ="]
        {
            let error = read("a.prw", &file(1, entry, |p| p), WHEEL).unwrap_err();
            assert!(matches!(error, ProfileError::BadHeader { line: 7, .. }), "{entry}: {error}");
            assert!(error.to_string().contains(entry), "{error}");
            assert!(error.to_string().contains("must be"), "{error}");
        }
    }

    #[test]
    fn files_cut_off_spoilt_or_empty_are_refused_at_their_line() {
        let whole = file(1, "", |p| p);
        let cut = &whole[..whole.find("  point.end").unwrap()];
        let error = read("a.prw", cut, WHEEL).unwrap_err();
        assert!(matches!(error, ProfileError::Truncated { .. }), "{error}");
        let spoilt = whole.replacen('\t', "\tx", 1);
        let error = read("a.prw", &spoilt, WHEEL).unwrap_err();
        assert!(matches!(error, ProfileError::BadLine { line: 10, .. }), "{error}");
        let error = read("a.prw", "header.begin\n", WHEEL).unwrap_err();
        assert!(matches!(error, ProfileError::UnknownFormat { line: 1, .. }), "{error}");
        let error = read("a.prw", &whole.repeat(2), WHEEL).unwrap_err();
        assert!(error.to_string().contains("one profile only"), "{error}");
    }
}
