//! Boundary elements on wheels and rails: conformal contact by CONTACT, energy, contacts that share
//! a rail.

use std::fmt::Write;

use wheelrail::element::parameters::{CreepageModel, NormalModel, TangentialModel, VerticalMode};
use wheelrail::element::{Element, Input, Output, Parameters};

use crate::common::summary::Summary;
use crate::common::wheel::{benchmark, evaluate, of_wheelset, pressed};
use crate::common::{read_table, spread, value, write_report};
use crate::tolerance;

fn boundary(elements: usize) -> Parameters {
    Parameters {
        normal_model: NormalModel::BoundaryElement,
        tangential_model: TangentialModel::BoundaryElement,
        creepage_model: CreepageModel::Curved,
        normal_elements: [elements; 2],
        damping: 0.0,
        ..Parameters::default()
    }
}

/// Median, 95 % and worst of the errors of every so many states: greatest pressure, and the force
/// within the reference's plane over the friction limit.
fn conformal_errors(every: usize, elements: usize) -> [[f64; 3]; 2] {
    let table = read_table("contact_25_1/conformal.csv");
    let mut element =
        benchmark(Parameters { vertical_mode: VerticalMode::Load, ..boundary(elements) });
    let mut report = String::from("id,max_pressure,force,normal_residual,tangential_residual\n");
    let mut errors: [Vec<f64>; 2] = Default::default();
    for row in table.rows.iter().step_by(every) {
        let v = |name: &str| value(&table, row, name);
        let output = evaluate(&mut element, &of_wheelset(&v));
        assert_eq!((output.patch_count, output.fallback_count), (1, 0), "{}", &row[0]);
        assert!(output.normal_residual <= tolerance::BOUNDARY_GAP, "{output:?}");
        assert!(output.tangential_residual <= tolerance::BOUNDARY_SLIP, "{output:?}");
        let pressure = 1e-6 * output.patches[0].max_pressure / v("p1_pmax_MPa") - 1.0;
        // The tractions of a curved patch turn, and so do its pressures: compared is all force in
        // the reference's plane.
        let (sine, cosine) = v("p1_angle_rad").sin_cos();
        let missed = [("fx_rail_N", 0), ("fy_rail_N", 1), ("fz_rail_total_N", 2)]
            .map(|(name, c)| output.rails[0].force[c] - v(name));
        let across = missed[1] * cosine + missed[2] * sine;
        let force = missed[0].hypot(across) / (0.3 * v("p1_N_N"));
        let [gap, slip] = [output.normal_residual, output.tangential_residual];
        writeln!(report, "{},{pressure:.5},{force:.5},{gap:.1e},{slip:.1e}", &row[0]).unwrap();
        errors[0].push(pressure.abs());
        errors[1].push(force);
    }
    write_report("conformal.csv", &report);
    if every == 1 {
        let mut summary = Summary::new("conformal");
        let [pressure, force] =
            errors.each_ref().map(|errors| errors.iter().map(|error| 100.0 * error));
        summary.add("greatest pressure [%]", pressure, "0.5 / 2 / -");
        summary.add("force in the contact plane [% of the friction limit]", force, "0.3 / 1.5 / 4");
        summary.write();
    }
    errors.map(spread)
}

fn judge_conformal(every: usize, elements: usize) {
    let found = conformal_errors(every, elements);
    println!("max pressure, force in plane: {found:.5?}");
    for (found, bound) in found.iter().zip(tolerance::BOUNDARY_CONFORMAL) {
        for (found, bound) in found.iter().zip(bound) {
            assert!(*found <= bound, "{found:?} {bound:?}");
        }
    }
}

#[test]
fn conformal_contacts_are_those_of_the_contact_program() {
    judge_conformal(6, 20);
}

#[test]
#[ignore = "minutes unoptimized"]
fn all_conformal_contacts_are_those_of_the_contact_program() {
    judge_conformal(1, 40);
}

/// Poses of S1002: rail, lateral shift [m] and yaw [rad], depth below first touch [m].
const POSES: [(&str, f64, f64, f64); 4] = [
    ("60E1", 4e-3, 3e-3, 1e-4),
    ("60E1", 6.3e-3, -0.01, 1e-4),
    ("60E1", 7.4e-3, -0.01, 2e-4),
    // Two zones.
    ("54E1", 5e-3, 0.02, 1e-4),
];

fn frictionless(rail: &str, shift: f64, yaw: f64, depth: f64) -> (Element, Input) {
    let mut parameters = Parameters { tangential_model: TangentialModel::None, ..boundary(24) };
    parameters.rails[0].profile = rail.into();
    let mut input = Input::default();
    input.wheel.position[1] += shift;
    input.wheel.yaw = yaw;
    let mut element = Element::new(&parameters, &input, &[]).unwrap();
    let input = pressed(&mut element, &input, depth);
    (element, input)
}

#[test]
fn the_frictionless_force_is_the_derivative_of_an_energy() {
    for (rail, shift, yaw, depth) in POSES {
        let (mut element, input) = frictionless(rail, shift, yaw, depth);
        let mut at = |y: f64, z: f64| {
            let mut moved = input;
            moved.wheel.position[1] += y;
            moved.wheel.position[2] += z;
            evaluate(&mut element, &moved).wheel.force
        };
        let h = 1e-6;
        let across = (at(0.0, h)[1] - at(0.0, -h)[1]) / (2.0 * h);
        let down = (at(h, 0.0)[2] - at(-h, 0.0)[2]) / (2.0 * h);
        let missed = (across / down - 1.0).abs();
        assert!(missed <= tolerance::BOUNDARY_CONSERVATIVE, "{rail} {shift}: {across} {down}");
        // Round a square of 10 µm, trapezoids of 2 µm: work over what is stored, two fifths of
        // force times depth.
        let mut work = 0.0;
        let mut before: Option<([f64; 2], [f64; 3])> = None;
        for k in 0..=20 {
            let (side, share) = (k / 5, 2e-6 * f64::from(k % 5));
            let place = match side {
                0 => [share, 0.0],
                1 => [1e-5, share],
                2 => [1e-5 - share, 1e-5],
                3 => [0.0, 1e-5 - share],
                _ => [0.0, 0.0],
            };
            let force = at(place[0], place[1]);
            if let Some((from, earlier)) = before {
                work += 0.5 * (force[1] + earlier[1]) * (place[0] - from[0])
                    + 0.5 * (force[2] + earlier[2]) * (place[1] - from[1]);
            }
            before = Some((place, force));
        }
        let force = at(0.0, 0.0);
        let stored = 0.4 * depth * force[1].hypot(force[2]);
        assert!(work.abs() <= tolerance::BOUNDARY_CONSERVATIVE * stored, "{work} of {stored}");
    }
}

#[test]
fn without_friction_there_is_no_force_along_the_track_and_no_moment_about_the_axle() {
    for (rail, shift, yaw, depth) in POSES {
        let (mut element, input) = frictionless(rail, shift, yaw, depth);
        let Output { wheel, .. } = evaluate(&mut element, &input);
        let [_, y, z] = wheel.force;
        let axle = [-yaw.sin(), yaw.cos(), 0.0];
        let about: f64 = (0..3).map(|c| axle[c] * wheel.moment[c]).sum();
        let size = y.hypot(z);
        assert!(about.abs() <= 1e-9 * size * 0.46, "{about}");
        assert!(wheel.force[0].abs() <= 1e-12 * size);
    }
}

#[test]
fn stretches_of_overlap_about_one_place_of_touch_all_carry() {
    // The wheel comes nearest to this rail in one place alone, but overlaps it in two stretches,
    // whose patches are 11 mm apart.
    let mut input = Input::default();
    let wheel = &mut input.wheel;
    (wheel.position[1], wheel.position[2]) = (0.755_970_750_4, -0.460_166_125_9);
    (wheel.roll, wheel.yaw) = (1.784_547e-3, -2.800_297e-3);
    let loads = [boundary(24), Parameters { strips: 80, damping: 0.0, ..Parameters::default() }]
        .map(|p| {
            let p = Parameters { tangential_model: TangentialModel::None, ..p };
            let output = evaluate(&mut Element::new(&p, &input, &[]).unwrap(), &input);
            assert_eq!((output.patch_count, output.fallback_count), (2, 0));
            [0, 1].map(|k| output.patches[k].normal_force)
        });
    for (found, expected) in loads[0].into_iter().zip(loads[1]) {
        assert!((found / expected - 1.0).abs() <= tolerance::BOUNDARY_TWO_ZONES, "{loads:?}");
    }
}

#[test]
fn contacts_of_one_rail_press_each_other_down() {
    // 7 and 11 mm apart on 54E1: alone each would carry up to a tenth more.
    let (mut exact, input) = frictionless("54E1", 5e-3, 0.02, 1e-4);
    let mut parameters = Parameters {
        normal_model: NormalModel::Strips,
        tangential_model: TangentialModel::None,
        damping: 0.0,
        ..Parameters::default()
    };
    parameters.rails[0].profile = "54E1".into();
    let mut strips = Element::new(&parameters, &input, &[]).unwrap();
    let [found, expected] = [&mut exact, &mut strips].map(|element| evaluate(element, &input));
    assert_eq!((found.patch_count, expected.patch_count), (2, 2));
    for c in 1..3 {
        let missed = found.wheel.force[c] / expected.wheel.force[c] - 1.0;
        assert!(missed.abs() <= tolerance::BOUNDARY_TWO_ZONES, "{missed}");
    }
}
