//! Wheels at large angles of attack against brute force: the turned surface of revolution over the
//! rail's cylinder.

use crate::common;
use crate::common::wheel::{element, evaluate, pressed, rolling};
use crate::tolerance;
use wheelrail::element::Parameters;
use wheelrail::element::parameters::{NormalModel, TangentialModel};
use wheelrail::geometry::contact_line::{ContactLine, WheelPose};
use wheelrail::geometry::curve::Curve;
use wheelrail::geometry::profile::ProfileKind;
use wheelrail::geometry::rail::placed_rail::PlacedRail;
use wheelrail::io::load_profile;

const RADIUS: f64 = 0.46;

fn s1002() -> Curve {
    load_profile("wheel", "S1002", ProfileKind::Wheel, 0.0, &[]).unwrap().curve
}

fn rail_60e1() -> PlacedRail {
    let rail = load_profile("rail", "60E1", ProfileKind::Rail, 0.0, &[]).unwrap();
    PlacedRail::by_gauge(&rail.curve, 0.025, 1.435, 0.014, false).unwrap()
}

/// A point of a wheel that is yawed but not rolled: profile parameter `s`, angle `angle` ahead of
/// down; marker at the origin.
fn wheel_surface(curve: &Curve, yaw: f64, s: f64, angle: f64) -> [f64; 3] {
    let [profile_y, profile_z] = curve.at(s).point;
    let radius = RADIUS + profile_z;
    let (along, down) = (radius * angle.sin(), radius * angle.cos());
    let (sine, cosine) = yaw.sin_cos();
    [cosine * along - sine * profile_y, sine * along + cosine * profile_y, down]
}

/// The deepest point of the wheel in the rail: distance and place along x, by ever finer scans of
/// the surface.
fn deepest(
    curve: &Curve,
    rail: &PlacedRail,
    marker: [f64; 2],
    yaw: f64,
    [from, to]: [f64; 2],
) -> [f64; 2] {
    let (mut s_middle, mut s_half) = (0.5 * (from + to), 0.5 * (to - from));
    let (mut a_middle, mut a_half) = (0.0, 0.4);
    let mut best = [f64::INFINITY, 0.0];
    for pass in 0..8 {
        let count = if pass == 0 { 150 } else { 30 };
        let (mut s_best, mut a_best) = (s_middle, a_middle);
        for i in -count..=count {
            let s = s_middle + s_half * f64::from(i) / f64::from(count);
            for j in -count..=count {
                let angle = a_middle + a_half * f64::from(j) / f64::from(count);
                let [x, y, z] = wheel_surface(curve, yaw, s.clamp(from, to), angle);
                let point = [y + marker[0], z + marker[1]];
                if best[0] < 2e-3 && point[1] < -0.05 {
                    continue;
                }
                let distance = rail.nearest(point, rail.coarse_nearest(point), 1e-12).distance;
                if distance < best[0] {
                    best = [distance, x];
                    (s_best, a_best) = (s, angle);
                }
            }
        }
        (s_middle, a_middle) = (s_best, a_best);
        (s_half, a_half) = (4.0 * s_half / f64::from(count), 4.0 * a_half / f64::from(count));
    }
    best
}

#[test]
fn the_places_of_contact_at_3_and_6_degrees_are_those_of_the_turned_surface() {
    let (curve, rail) = (s1002(), rail_60e1());
    let mut element = element(&Parameters::default());
    let mut report = String::from("yaw_deg,shift_mm,x_mm,brute_x_mm,depth_um,brute_depth_um\n");
    let (mut ahead, mut worst) = (0f64, [0f64; 2]);
    for degrees in [-6f64, -3.0, 3.0, 6.0] {
        let yaw = degrees.to_radians();
        for shift in [-3e-3, 2e-3, 6e-3, 9e-3] {
            let mut input = rolling(shift, 20.0);
            input.wheel.yaw = yaw;
            let input = pressed(&mut element, &input, 5e-5);
            let output = evaluate(&mut element, &input);
            let patch =
                output.patches.iter().max_by(|a, b| a.penetration.total_cmp(&b.penetration));
            let patch = patch.unwrap();
            let marker = [
                input.wheel.position[1] - rail.marker[0],
                input.wheel.position[2] - rail.marker[1],
            ];
            let part = [curve.start(), curve.end()];
            let [distance, x] = deepest(&curve, &rail, marker, yaw, part);
            ahead = ahead.max(patch.position[0].abs());
            report += &format!(
                "{degrees},{},{},{},{},{}\n",
                1e3 * shift,
                1e3 * patch.position[0],
                1e3 * x,
                1e6 * patch.penetration,
                -1e6 * distance
            );
            worst[0] = worst[0].max((patch.penetration + distance).abs());
            worst[1] = worst[1].max((patch.position[0] - x).abs());
        }
    }
    common::write_report("yawed_wheel.csv", &report);
    println!("{report}worst: {worst:?}");
    assert!(ahead > 0.05, "flanges touch far from the axle: {ahead}");
    assert!(worst[0] < tolerance::YAWED_DEPTH, "{worst:?}");
    assert!(worst[1] < tolerance::YAWED_PLACE, "{worst:?}");
}

/// How much the wheel's surface has receded from its contact plane at `x` beyond the point of the
/// line: brute force along the normal (y, z) at constant lateral coordinate.
fn recession(curve: &Curve, yaw: f64, line: &ContactLine, u: f64, x: f64) -> f64 {
    let at = line.at(u);
    let length = at.tangent[0].hypot(at.tangent[1]);
    let t = at.tangent.map(|c| c / length);
    let n = [-t[1], t[0]];
    let (sine, cosine) = yaw.sin_cos();
    // Depth d along the normal at which the point is on the wheel: distance from the axle against
    // the profile there.
    let outside = |d: f64| {
        let point = [at.x + x, at.point[0] + d * n[0], at.point[1] + d * n[1]];
        let along = cosine * point[0] + sine * point[1];
        let across = cosine * point[1] - sine * point[0];
        let radius = along.hypot(point[2]);
        // The parameter of the profile at that lateral coordinate, near the one of the line.
        let mut s = u;
        for _ in 0..60 {
            let p = curve.at(s);
            s -= (p.point[0] - across) / p.first[0].max(0.1);
        }
        radius - RADIUS - curve.at(s).point[1]
    };
    let (mut inside, mut beyond) = (-2e-3, 1e-3);
    for _ in 0..60 {
        let middle = 0.5 * (inside + beyond);
        if outside(middle) < 0.0 { inside = middle } else { beyond = middle }
    }
    -0.5 * (inside + beyond)
}

#[test]
fn the_section_along_the_rail_of_a_yawed_wheel_has_the_radius_of_its_surface() {
    let curve = s1002();
    let mut worst = 0f64;
    // Parameters inside the pieces of constant curvature: flange tip, flank, root, and the tread.
    for yaw in [-0.02, 0.01, 0.02] {
        let pose = WheelPose { marker: [0.0; 3], roll: 0.0, yaw };
        let line = ContactLine::new(&curve, RADIUS, &pose);
        for y in [-0.0475, -0.0444, -0.039_1, -0.0365, -0.02, 0.0, 0.03] {
            let knots: Vec<f64> = curve.knots().collect();
            let s = *knots
                .iter()
                .min_by(|a, b| {
                    let miss = |s: f64| (curve.at(s).point[0] - y).abs();
                    miss(**a).total_cmp(&miss(**b))
                })
                .unwrap();
            let x = 1e-3;
            let both = [-x, x].map(|x| recession(&curve, yaw, &line, s, x));
            let curvature = (both[0] + both[1]) / (x * x);
            let found = 1.0 / line.wheel_point(s).section_radius;
            println!("yaw {yaw} y {y}: surface {curvature:.4}, line {found:.4} 1/m");
            worst = worst.max((found / curvature - 1.0).abs());
        }
    }
    assert!(worst < tolerance::SECTION_CURVATURE, "{worst}");
}

#[test]
fn strips_of_a_yawed_flange_carry_what_boundary_elements_do() {
    // Strips lie further apart along the track than across there.
    for yaw in [-0.03, -0.05, -0.07] {
        let loads = [NormalModel::Strips, NormalModel::BoundaryElement].map(|normal_model| {
            let mut parameters = Parameters::default();
            (parameters.normal_model, parameters.tangential_model) =
                (normal_model, TangentialModel::None);
            let mut element = element(&parameters);
            let mut input = rolling(8e-3, 20.0);
            input.wheel.yaw = yaw;
            let input = pressed(&mut element, &input, 4e-5);
            let output = evaluate(&mut element, &input);
            output.patches.iter().map(|patch| patch.normal_force).sum::<f64>()
        });
        let error = loads[0] / loads[1] - 1.0;
        println!("{yaw}: {loads:.0?} N, {:.2} %", 100.0 * error);
        assert!(error.abs() < tolerance::YAWED_FLANGE, "{yaw}: {loads:?}");
    }
}
