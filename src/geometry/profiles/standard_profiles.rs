//! The profiles of the standards, from their formulas: wheel S1002, rails 60E1, 60E2 and 54E1.
//!
//! Sources: EN 13715 (S1002, flange height 28 mm, thickness 32.5 mm, wheel width 135 mm) and EN
//! 13674-1 (rails). Names are compared without regard to case.

use crate::geometry::curves::curve::Curve;
use crate::geometry::curves::curve_sections::{Section, arc, curve_of, graph, line};
use crate::geometry::profiles::analytic_profiles::analytic;
use crate::geometry::profiles::profile::{Profile, ProfileError, ProfileKind};
use crate::geometry::profiles::rail_heads::{SideEnd, head};

/// Names of the built-in wheel profiles, for messages; R in metres.
pub const WHEEL_NAMES: &str = "S1002, conical:TANGENT, cylindrical, arc:R (hollow), convex:R";
/// Names of the built-in rail profiles, for messages; R in metres.
pub const RAIL_NAMES: &str = "60E1 (UIC60), 60E2, 54E1 (UIC54), flat, arc:R";

/// Names of the built-in profiles of a body, for messages.
pub fn built_in_names(kind: ProfileKind) -> &'static str {
    match kind {
        ProfileKind::Wheel => WHEEL_NAMES,
        ProfileKind::Rail => RAIL_NAMES,
    }
}

/// The built-in or analytic profile of that name, or nothing if the name is none of them.
///
/// # Errors
/// A built-in name of the other body, or an analytic name without an admitted number.
pub fn built_in(name: &str, kind: ProfileKind) -> Result<Option<Profile>, ProfileError> {
    let found = match name.to_ascii_uppercase().as_str() {
        "S1002" => Some((ProfileKind::Wheel, s1002())),
        "60E1" | "UIC60" => Some((ProfileKind::Rail, rail_60e1())),
        "60E2" => Some((ProfileKind::Rail, rail_60e2())),
        "54E1" | "UIC54" => Some((ProfileKind::Rail, rail_54e1())),
        _ => None,
    };
    match found {
        Some((of, curve)) if of == kind => {
            Ok(Some(Profile { name: name.into(), kind, curve, remarks: Vec::new() }))
        }
        Some(_) => {
            Err(ProfileError::OtherBody { name: name.into(), kind, built_in: built_in_names(kind) })
        }
        None => analytic(name, kind),
    }
}

const MM: f64 = 1e-3;

// Coefficients of S1002 in millimetres, y positive to the field side, z down; lowest power first.
const ZONE_A: [f64; 2] = [1.364_323_640, -0.066_666_667];
#[rustfmt::skip]
const ZONE_B: [f64; 9] = [
    0.0, -3.358_537_058e-2, 1.565_681_624e-3, -2.810_427_944e-5, 5.844_240_864e-8,
    -1.562_379_023e-8, 5.309_217_349e-15, -5.957_839_843e-12, 2.646_656_573e-13,
];
#[rustfmt::skip]
const ZONE_C: [f64; 8] = [
    -4.320_221_063e3, -1.038_384_026e3, -1.065_501_873e2, -6.051_367_875, -2.054_332_446e-1,
    -4.169_739_389e-3, -4.687_195_829e-5, -2.252_755_540e-7,
];
// Limits of the zones of S1002 [mm]. The field end is that of the 135 mm wide wheel, without its
// chamfer.
const FIELD_END: f64 = 65.0;
const AB: f64 = 32.157_96;
const BC: f64 = -26.0;
const CD: f64 = -35.0;
const DE: f64 = -38.426_669_071;
const EF: f64 = -39.764_473_993;
const FG: f64 = -49.662_510_381;
const GH: f64 = -62.764_705_882;
const FLANGE_BACK: f64 = -70.0;
// Centre and radius of the arcs of the flange [mm].
const ARC_D: ([f64; 2], f64) = ([-26.210_665, 16.446], 13.0);
const ARC_F: ([f64; 2], f64) = ([-58.558_326_413, 8.834_924_130], 20.0);
const ARC_G: ([f64; 2], f64) = ([-55.0, 16.0], 12.0);
const ARC_H: ([f64; 2], f64) = ([-49.5, 9.519_259_302], 20.5);
/// Height up to which the flange back is carried, which a check rail touches [mm].
const FLANGE_BACK_TOP: f64 = -20.0;
/// Distance of the points through which the polynomial zones are laid [mm].
const POINT_DISTANCE: f64 = 0.25;

/// S1002 with flange back; origin on the nominal rolling circle, 70 mm from the flange back.
///
/// Departure from the standard: its digits leave steps of 0.12 and 0.04 µm and breaks of up to 3e-4
/// degrees where zone C meets D and B. A cubic added over zone C, nowhere above 0.12 µm, closes
/// both, so that tangents are continuous throughout. Curvature jumps between zones, as the standard
/// has it.
fn s1002() -> Curve {
    let zone_b = |y: f64| polynomial(&ZONE_B, y);
    let ([yd, zd], rd) = ARC_D;
    let root = (rd * rd - (CD - yd).powi(2)).sqrt();
    let at_d = [zd - root, (CD - yd) / root];
    let (at_b, raw_d, raw_b) = (zone_b(BC), polynomial(&ZONE_C, CD), polynomial(&ZONE_C, BC));
    let zone_c = |y: f64| {
        let raw = polynomial(&ZONE_C, y);
        let steps = [at_d[0] - raw_d[0], at_b[0] - raw_b[0]];
        let breaks = [at_d[1] - raw_d[1], at_b[1] - raw_b[1]];
        let blend = cubic_between(CD, BC, steps, breaks, y);
        [raw[0] + blend[0], raw[1] + blend[1]]
    };
    let zone_a = |y: f64| [y * MM, polynomial(&ZONE_A, y)[0] * MM];
    // Ends of the flank E, on the arcs so that the digits of its line leave no gap.
    let flank = [on_lower_half(ARC_F, EF), on_upper_half(ARC_D, DE)];
    let joint_h = on_lower_half(ARC_H, GH);
    curve_of(&[
        line([FLANGE_BACK * MM, FLANGE_BACK_TOP * MM], [FLANGE_BACK * MM, ARC_H.0[1] * MM]),
        arc_through(ARC_H, [FLANGE_BACK, ARC_H.0[1]], joint_h),
        arc_through(ARC_G, on_lower_half(ARC_G, GH), on_lower_half(ARC_G, FG)),
        arc_through(ARC_F, on_lower_half(ARC_F, FG), flank[0]),
        line(flank[0].map(|x| x * MM), flank[1].map(|x| x * MM)),
        arc_through(ARC_D, flank[1], [CD, at_d[0]]),
        polynomial_zone(CD, BC, zone_c),
        polynomial_zone(BC, AB, zone_b),
        line(zone_a(AB), zone_a(FIELD_END)),
    ])
}

fn on_lower_half((centre, radius): ([f64; 2], f64), y: f64) -> [f64; 2] {
    [y, centre[1] + (radius * radius - (y - centre[0]).powi(2)).sqrt()]
}

fn on_upper_half((centre, radius): ([f64; 2], f64), y: f64) -> [f64; 2] {
    [y, centre[1] - (radius * radius - (y - centre[0]).powi(2)).sqrt()]
}

/// Arc between two points on it, not through the polar angle ±π; mm in, m out.
fn arc_through((centre, radius): ([f64; 2], f64), from: [f64; 2], to: [f64; 2]) -> Section {
    let angle = |p: [f64; 2]| {
        let angle = (p[1] - centre[1]).atan2(p[0] - centre[0]);
        // The flange back end of H lies at π itself; the arcs turn on the field side of that.
        if angle < -std::f64::consts::FRAC_PI_2 { angle + std::f64::consts::TAU } else { angle }
    };
    arc(centre.map(|c| c * MM), radius * MM, angle(from), angle(to))
}

fn polynomial_zone(from: f64, to: f64, zone: impl Fn(f64) -> [f64; 2]) -> Section {
    let pieces = ((to - from) / POINT_DISTANCE).ceil();
    let y: Vec<f64> =
        (0..=pieces as usize).map(|i| (from + (to - from) * i as f64 / pieces) * MM).collect();
    graph(&y, |y| {
        let [z, slope] = zone(y / MM);
        [z * MM, slope]
    })
}

/// Value and slope of a polynomial, lowest power first.
fn polynomial(coefficients: &[f64], y: f64) -> [f64; 2] {
    coefficients
        .iter()
        .rev()
        .fold([0.0, 0.0], |[value, slope], c| [value * y + c, slope * y + value])
}

/// Value and slope at `y` of the cubic with given values and slopes at `from` and `to`.
fn cubic_between(from: f64, to: f64, values: [f64; 2], slopes: [f64; 2], y: f64) -> [f64; 2] {
    let h = to - from;
    let u = (y - from) / h;
    let rise = values[1] - values[0];
    let c = 3.0 * rise - h * (2.0 * slopes[0] + slopes[1]);
    let d = h * (slopes[0] + slopes[1]) - 2.0 * rise;
    let value = values[0] + u * (h * slopes[0] + u * (c + u * d));
    [value, slopes[0] + u * (2.0 * c + 3.0 * u * d) / h]
}

/// 60E1, formerly UIC60.
fn rail_60e1() -> Curve {
    head(&[[0.300, 0.010_228], [0.080, 0.026_026_5]], 0.013, SideEnd::Underside(0.051))
}

/// 60E2.
fn rail_60e2() -> Curve {
    let arcs = [[0.200, 0.011_889], [0.070, 0.024_456_5], [0.016, 0.035_387]];
    head(&arcs, 0.008, SideEnd::Underside(0.051))
}

/// 54E1, formerly UIC54.
fn rail_54e1() -> Curve {
    head(&[[0.300, 0.010_012], [0.080, 0.024_863_5]], 0.013, SideEnd::Underside(0.049_4))
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    fn profile(name: &str, kind: ProfileKind) -> Profile {
        built_in(name, kind).unwrap().unwrap()
    }

    /// Curve parameter at which y passes `y` [mm], on the lowest of several branches.
    fn at_y(curve: &Curve, y: f64) -> f64 {
        let f = |s: f64| curve.at(s).point[0] - y * MM;
        let knots: Vec<f64> = curve.knots().collect();
        let pair = knots.windows(2).rev().find(|p| f(p[0]) * f(p[1]) <= 0.0).unwrap();
        let (mut low, mut high) = (pair[0], pair[1]);
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            if f(low) * f(middle) <= 0.0 { high = middle } else { low = middle }
        }
        0.5 * (low + high)
    }

    fn z_mm(curve: &Curve, y: f64) -> f64 {
        curve.at(at_y(curve, y)).point[1] / MM
    }

    #[test]
    fn s1002_has_the_dimensions_of_its_standard() {
        let wheel = profile("s1002", ProfileKind::Wheel);
        assert_relative_eq!(z_mm(&wheel.curve, -55.0), 28.0, epsilon = 1e-8);
        assert_relative_eq!(wheel.bounds().z[1], 0.028, epsilon = 1e-11);
        assert_relative_eq!(z_mm(&wheel.curve, -37.5), 10.0, epsilon = 1e-3);
        assert_relative_eq!(z_mm(&wheel.curve, 0.0), 0.0, epsilon = 1e-7);
        assert_relative_eq!(z_mm(&wheel.curve, 60.0), -2.635_676_38, epsilon = 1e-8);
        let flank = wheel.curve.at(at_y(&wheel.curve, -39.0)).first;
        assert_relative_eq!((-flank[1]).atan2(flank[0]).to_degrees(), 70.0, epsilon = 1e-4);
        let bounds = wheel.bounds();
        assert_relative_eq!(bounds.y[0], -0.070, epsilon = 1e-12);
        assert_relative_eq!(bounds.y[1], 0.065, epsilon = 1e-12);
        assert_relative_eq!(bounds.z[0], -0.020, epsilon = 1e-12);
    }

    /// Distance of a point of the curve from the formula of its zone, along the normal [mm].
    fn s1002_deviation(point: [f64; 2]) -> f64 {
        let [y, z] = point.map(|x| x / MM);
        let from_graph = |[value, slope]: [f64; 2]| (z - value) / 1f64.hypot(slope);
        let from_arc = |(c, r): ([f64; 2], f64)| (y - c[0]).hypot(z - c[1]) - r;
        match y {
            _ if y > AB => from_graph(polynomial(&ZONE_A, y)),
            _ if y > BC => from_graph(polynomial(&ZONE_B, y)),
            _ if y > CD => from_graph(polynomial(&ZONE_C, y)),
            _ if y > DE => from_arc(ARC_D),
            _ if y > EF => from_graph([-93.576_667_419 - 2.747_477_419 * y, -2.747_477_419]),
            _ if y > FG => from_arc(ARC_F),
            _ if y > GH => from_arc(ARC_G),
            _ if z > ARC_H.0[1] => from_arc(ARC_H),
            _ => y - FLANGE_BACK,
        }
    }

    #[test]
    fn s1002_lies_on_its_formulas() {
        let curve = profile("S1002", ProfileKind::Wheel).curve;
        let (mut worst, mut worst_c) = (0.0f64, 0.0f64);
        for i in 0..=40_000 {
            let point =
                curve.at(curve.start() + (curve.end() - curve.start()) * f64::from(i) / 4e4).point;
            let deviation = s1002_deviation(point).abs();
            // In zone C the steps of the standard are closed: up to 0.12 µm.
            if (CD * MM..BC * MM).contains(&point[0]) {
                worst_c = worst_c.max(deviation);
            } else {
                worst = worst.max(deviation);
            }
        }
        assert!(worst < 1e-6, "{worst} mm");
        assert!(worst_c < 1.2e-4, "{worst_c} mm");
    }

    #[test]
    fn s1002_is_smooth_at_its_joints_and_bends_smoothly_inside_its_zones() {
        let curve = profile("S1002", ProfileKind::Wheel).curve;
        let knots: Vec<f64> = curve.knots().collect();
        let joints = [FIELD_END, AB, BC, CD, DE, EF, FG, GH, FLANGE_BACK];
        let (mut turn, mut jump) = (0.0f64, 0.0f64);
        for &s in &knots[1..knots.len() - 1] {
            let (before, after) = (curve.at(s - 1e-12), curve.at(s));
            turn = turn
                .max((before.first[0] - after.first[0]).hypot(before.first[1] - after.first[1]));
            let bend = |p: crate::geometry::curves::curve::CurvePoint| {
                p.first[0] * p.second[1] - p.first[1] * p.second[0]
            };
            if joints.iter().all(|y| (y * MM - after.point[0]).abs() > 1e-8) {
                jump = jump.max((bend(before) - bend(after)).abs());
            }
        }
        assert!(turn < 1e-9);
        // Zones F and G miss each other by 7e-8 mm; their pieces of h = 1.2 mm each take half of
        // it, e: 6 e / h² = 1.5e-4, of a curvature of 83 1/m.
        assert!(jump < 1.5e-4, "{jump} 1/m");
    }

    #[test]
    fn the_gaps_closed_at_the_joints_are_those_of_the_digits_of_the_standard() {
        let step = |a: f64, b: f64| a - b;
        let dc = step(on_upper_half(ARC_D, CD)[1], polynomial(&ZONE_C, CD)[0]);
        let cb = step(polynomial(&ZONE_C, BC)[0], polynomial(&ZONE_B, BC)[0]);
        assert_relative_eq!(dc.abs(), 1.18e-4, epsilon = 1e-6);
        assert_relative_eq!(cb.abs(), 3.7e-5, epsilon = 1e-6);
        assert_relative_eq!(
            on_lower_half(ARC_F, FG)[1],
            on_lower_half(ARC_G, FG)[1],
            epsilon = 7e-8
        );
        assert_relative_eq!(
            on_lower_half(ARC_H, GH)[1],
            on_lower_half(ARC_G, GH)[1],
            epsilon = 7e-8
        );
    }

    #[test]
    fn rails_pass_the_nodes_that_follow_from_their_arcs() {
        // y, z [mm] and slope [degrees] where arcs, lines and fillets meet.
        let nodes: [(&str, &[[f64; 3]]); 3] = [
            (
                "60E1",
                &[
                    [10.228, 0.174_404, 1.9538],
                    [26.0265, 2.302_524, 13.3898],
                    [35.999_811, 14.299_958, 87.1376],
                    [37.048_580, 35.275_334, 87.1376],
                    [35.077_552, 38.244_527, 180.0 - 19.9831],
                ],
            ),
            (
                "60E2",
                &[
                    [11.889, 0.353_684, 3.4080],
                    [24.4565, 2.258_192, 13.8264],
                    [35.387, 11.604_764, 67.2405],
                    [35.999_923, 14.300_172, 87.1376],
                ],
            ),
            (
                "54E1",
                &[
                    [10.012, 0.167_113, 1.9126],
                    [24.8635, 2.064_868, 12.6513],
                    [35.000_058, 14.100_052, 87.1376],
                ],
            ),
        ];
        for (name, nodes) in nodes {
            let rail = profile(name, ProfileKind::Rail);
            for &[y, z, slope] in nodes {
                let nearest = |sign: f64| {
                    rail.curve
                        .knots()
                        .map(|s| rail.curve.at(s))
                        .min_by(|a, b| {
                            let d = |p: [f64; 2]| (p[0] - sign * y * MM).hypot(p[1] - z * MM);
                            d(a.point).total_cmp(&d(b.point))
                        })
                        .unwrap()
                };
                for sign in [-1.0, 1.0] {
                    let at = nearest(sign);
                    assert_relative_eq!(at.point[0] / MM, sign * y, epsilon = 1e-6);
                    assert_relative_eq!(at.point[1] / MM, z, epsilon = 1e-6);
                    let angle = (sign * at.first[1]).atan2(at.first[0]).to_degrees();
                    assert_relative_eq!(angle, slope, epsilon = 1e-4);
                }
            }
        }
    }

    #[test]
    fn names_are_found_in_any_case_and_refused_for_the_other_body() {
        for name in ["60e1", "UIC60", "60E2", "uic54", "54E1"] {
            let rail = profile(name, ProfileKind::Rail);
            assert_eq!(rail.name, name);
            let error = built_in(name, ProfileKind::Wheel).unwrap_err();
            assert!(error.to_string().contains("S1002"), "{error}");
        }
        assert!(built_in("S1002", ProfileKind::Rail).unwrap_err().to_string().contains("60E1"));
        assert!(built_in("S1003", ProfileKind::Wheel).unwrap().is_none());
    }
}
