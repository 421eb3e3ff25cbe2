//! Profiles with closed-form contact, for tests and for trying models: cones, cylinders, arcs, a
//! flat.
//!
//! Named by a word and, after a colon, a number: the tangent of a cone's angle or a radius in
//! metres.
//!
//! | body | name | shape |
//! |---|---|---|
//! | wheel | `conical:0.05` | z = -0.05 y: the radius shrinks to the field side; 135 mm wide, no flange |
//! | wheel | `cylindrical` | z = 0 |
//! | wheel | `arc:0.5` | hollow tread, a concave arc of radius 0.5 m: z = R - √(R² - y²) |
//! | wheel | `convex:0.3` | crowned tread, a convex arc of radius 0.3 m: z = √(R² - y²) - R |
//! | rail | `flat` | flat top, 70 mm wide with its edges rounded by 3 mm, vertical sides |
//! | rail | `arc:0.3` | crowned top of radius 0.3 m: z = R - √(R² - y²); edges and sides as those of `flat` |

use std::f64::consts::FRAC_PI_2;

use crate::geometry::curves::curve::Curve;
use crate::geometry::curves::curve_sections::{Section, arc, curve_of, line, mirrored};
use crate::geometry::profiles::profile::{Profile, ProfileError, ProfileKind};

/// Lateral range of the wheels [m].
const WHEEL_RANGE: [f64; 2] = [-0.070, 0.065];
/// Half width of the rails [m].
const RAIL_HALF_WIDTH: f64 = 0.035;
/// Radius that rounds the edges of the rails [m].
const RAIL_EDGE_RADIUS: f64 = 0.003;
/// Depth to which the sides of the rails go [m].
const RAIL_DEPTH: f64 = 0.030;
/// Admitted radii [m].
const RADII: [f64; 2] = [0.08, 1000.0];
const RADIUS_ALLOWED: &str = "a radius from 0.08 to 1000 m, as in arc:0.3";

/// The analytic profile of that name, or nothing if the name is none of them.
///
/// # Errors
/// A name with a colon whose number is missing or not admitted.
pub(crate) fn analytic(name: &str, kind: ProfileKind) -> Result<Option<Profile>, ProfileError> {
    let lower = name.to_ascii_lowercase();
    let (word, number) = match lower.split_once(':') {
        Some((word, number)) => (word, Some(number)),
        None => (lower.as_str(), None),
    };
    let admitted = |range: [f64; 2], allowed: &'static str| {
        number
            .and_then(|n| n.trim().parse::<f64>().ok())
            .filter(|n| (range[0]..=range[1]).contains(n))
            .ok_or_else(|| ProfileError::BadNumber { name: name.into(), allowed })
    };
    let curve = match (kind, word, number) {
        (ProfileKind::Wheel, "cylindrical", None) => cone(0.0),
        (ProfileKind::Wheel, "conical", _) => cone(admitted(
            [-1.0, 1.0],
            "the tangent of the cone angle, -1 to 1, as in conical:0.05",
        )?),
        (ProfileKind::Wheel, "arc", _) => hollow(admitted(RADII, RADIUS_ALLOWED)?),
        (ProfileKind::Wheel, "convex", _) => crowned(admitted(RADII, RADIUS_ALLOWED)?),
        (ProfileKind::Rail, "flat", None) => flat_rail(),
        (ProfileKind::Rail, "arc", _) => arc_rail(admitted(RADII, RADIUS_ALLOWED)?),
        _ => return Ok(None),
    };
    Ok(Some(Profile { name: name.into(), kind, curve, remarks: Vec::new() }))
}

fn cone(tangent: f64) -> Curve {
    let at = |y: f64| [y, -tangent * y];
    curve_of(&[line(at(WHEEL_RANGE[0]), at(0.0)), line(at(0.0), at(WHEEL_RANGE[1]))])
}

fn hollow(radius: f64) -> Curve {
    let angle = |y: f64| (y / radius).asin() - FRAC_PI_2;
    curve_of(&[arc([0.0, radius], radius, angle(WHEEL_RANGE[0]), angle(WHEEL_RANGE[1]))])
}

fn crowned(radius: f64) -> Curve {
    let angle = |y: f64| FRAC_PI_2 - (y / radius).asin();
    curve_of(&[arc([0.0, -radius], radius, angle(WHEEL_RANGE[0]), angle(WHEEL_RANGE[1]))])
}

fn flat_rail() -> Curve {
    let top_end = [RAIL_HALF_WIDTH - RAIL_EDGE_RADIUS, 0.0];
    rail_of(line([0.0, 0.0], top_end), top_end, 0.0)
}

fn arc_rail(radius: f64) -> Curve {
    // The edge touches the top from inside: its centre is at radius - edge radius from the top's
    // centre.
    let angle = ((RAIL_HALF_WIDTH - RAIL_EDGE_RADIUS) / (radius - RAIL_EDGE_RADIUS)).asin();
    let end = [radius * angle.sin(), radius - radius * angle.cos()];
    rail_of(arc([0.0, radius], radius, -FRAC_PI_2, angle - FRAC_PI_2), end, angle)
}

/// Rail with the given right half of the top, which ends at `end` with the slope angle `angle`.
fn rail_of(top: Section, end: [f64; 2], angle: f64) -> Curve {
    let centre = [end[0] - RAIL_EDGE_RADIUS * angle.sin(), end[1] + RAIL_EDGE_RADIUS * angle.cos()];
    let edge = arc(centre, RAIL_EDGE_RADIUS, angle - FRAC_PI_2, 0.0);
    let side = line([RAIL_HALF_WIDTH, centre[1]], [RAIL_HALF_WIDTH, RAIL_DEPTH]);
    curve_of(&[mirrored(&side), mirrored(&edge), mirrored(&top), top, edge, side])
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    fn points(name: &str, kind: ProfileKind) -> Vec<[f64; 2]> {
        let curve = analytic(name, kind).unwrap().unwrap().curve;
        (0..=1000)
            .map(|i| curve.start() + (curve.end() - curve.start()) * f64::from(i) / 1000.0)
            .map(|s| curve.at(s).point)
            .collect()
    }

    #[test]
    fn wheels_follow_their_formulas() {
        type Height = fn(f64) -> f64;
        let shapes: [(&str, Height); 4] = [
            ("conical:0.05", |y| -0.05 * y),
            ("Cylindrical", |_| 0.0),
            ("arc:0.5", |y| 0.5 - (0.25 - y * y).sqrt()),
            ("convex:0.3", |y| (0.09 - y * y).sqrt() - 0.3),
        ];
        for (name, z) in shapes {
            let points = points(name, ProfileKind::Wheel);
            assert_relative_eq!(points[0][0], -0.070, epsilon = 1e-12);
            assert_relative_eq!(points[1000][0], 0.065, epsilon = 1e-12);
            for [y, found] in points {
                assert_relative_eq!(found, z(y), epsilon = 2e-11);
            }
        }
    }

    #[test]
    fn rails_have_their_top_their_width_and_vertical_sides() {
        for (name, radius) in [("flat", 1e9), ("ARC:0.3", 0.3), ("arc:0.08", 0.08)] {
            let points = points(name, ProfileKind::Rail);
            assert_relative_eq!(points[0][0], -0.035, epsilon = 1e-12);
            assert_relative_eq!(points[0][1], 0.030, epsilon = 1e-12);
            assert_relative_eq!(points[1000][0], 0.035, epsilon = 1e-12);
            assert_relative_eq!(points[30][0], -0.035, epsilon = 1e-10);
            for [y, z] in points.into_iter().filter(|p| p[0].abs() < 0.032) {
                // y² / (R + √(R² - y²)) is R - √(R² - y²) without cancellation.
                let expected = y * y / (radius + (radius * radius - y * y).sqrt());
                assert_relative_eq!(z, expected, epsilon = 2e-11);
            }
        }
    }

    #[test]
    fn a_number_that_is_missing_or_not_admitted_is_refused() {
        for name in
            ["conical", "conical:", "conical:2", "arc:x", "arc:0.01", "arc:nan", "convex:-1"]
        {
            let error = analytic(name, ProfileKind::Wheel).unwrap_err();
            assert!(error.to_string().contains("as in"), "{error}");
        }
        assert!(analytic("convex:0.3", ProfileKind::Rail).unwrap().is_none());
        assert!(analytic("flat:1", ProfileKind::Rail).unwrap().is_none());
    }
}
