//! Rails that are rollers of a rig.

use crate::allocations;
use crate::common;
use crate::tolerance;
use std::fmt::Write;
use std::fs;

use crate::common::random::Random;
use crate::common::roller::{Errors, errors_against_contact};
use crate::common::vectors::assert_balanced;
use crate::common::wheel::{evaluate, pressed, random_input, rolling, the_patch};
use approx::assert_relative_eq;
use tempfile::TempDir;
use wheelrail::element::input::RailMotion;
use wheelrail::element::parameters::{
    CreepageModel, FrictionDistribution, NormalModel, Placement, Side, TangentialModel,
    VerticalMode, WearModel,
};
use wheelrail::element::{Element, Input, Output, Parameters};

const ROLLER: f64 = 0.8;

/// A wheel on a roller.
fn parameters(wheel: &str, rail: &str) -> Parameters {
    let mut parameters = Parameters::default();
    parameters.wheel.profile = wheel.into();
    parameters.rails[0].profile = rail.into();
    parameters.rails[0].roller_radius = ROLLER;
    parameters
}

fn element(parameters: &Parameters) -> Element {
    common::wheel::element(parameters)
}

/// A wheel that stands still and turns on a roller that runs at `speed` as it would at that speed
/// on a rail.
fn on_rig(shift: f64, speed: f64) -> Input {
    let mut input = rolling(shift, speed);
    input.wheel.velocity[0] = 0.0;
    input.rails[0].pitch_rate = speed / ROLLER;
    input
}

#[test]
fn a_wheel_beside_the_top_of_a_roller_stands_on_the_line_of_both_axles() {
    let mut parameters = parameters("cylindrical", "arc:0.3");
    (parameters.rails[0].placement, parameters.rails[0].position) =
        (Placement::Position, [0.75, 0.02]);
    parameters.rails[0].inclination = 0.0;
    let mut element = element(&parameters);
    let radius = parameters.wheel.nominal_radius;
    for x in [-0.05, 0.0, 0.011, 0.08] {
        let mut input = Input { friction: 0.0, track_s: 17.0, ..Input::default() };
        input.wheel.position[0] = x;
        let both = ROLLER + radius;
        let touch = element.touching_height(&input);
        assert_relative_eq!(touch, 0.02 + ROLLER - (both * both - x * x).sqrt(), epsilon = 1e-9);
        input.wheel.position[2] = touch + 1e-4;
        let output = evaluate(&mut element, &input);
        let patch = the_patch(&output);
        // The load of a penetration of 0.1 mm lies that much off a line of 1.26 m.
        assert_relative_eq!(patch.position[0], x * ROLLER / both, epsilon = 2e-4 * x.abs() + 1e-9);
        // Frictionless, so that nothing turns either of them.
        let [fx, _, fz] = output.wheel.force;
        let depth = ROLLER + 0.02 - input.wheel.position[2];
        assert_relative_eq!(fx / fz, -x / depth, max_relative = 1e-3);
        let torque = output.rails[0].moment[1] - ROLLER * output.rails[0].force[0];
        let scale = fz.abs() * ROLLER;
        assert_relative_eq!(torque / scale, 0.0, epsilon = 1e-3 * x.abs() + 1e-9);
        assert_relative_eq!(output.wheel.moment[1] / scale, 0.0, epsilon = tolerance::SIMILARITY);
    }
    let mut input = Input::default();
    input.wheel.position[0] = 0.9;
    assert!(element.touch(&input).is_none());
}

#[test]
fn wheel_and_roller_together_are_as_round_as_both() {
    let mut parameters = parameters("cylindrical", "arc:0.3");
    parameters.rails[0].inclination = 0.0;
    let mut element = element(&parameters);
    let input = pressed(&mut element, &Input::default(), 1e-4);
    let flat = element.flat_contacts(&input).unwrap();
    let radius = parameters.wheel.nominal_radius;
    assert_relative_eq!(flat[0].radius, 1.0 / (1.0 / radius + 1.0 / ROLLER), max_relative = 1e-9);
}

#[test]
fn a_roller_that_turns_under_a_wheel_is_a_rail_under_one_that_rolls_on() {
    for shift in [-4e-3, 0.0, 5e-3] {
        let mut element = element(&Parameters {
            damping: 0.0,
            creepage_model: CreepageModel::Flat,
            ..parameters("S1002", "60E1")
        });
        let mut moving = rolling(shift, 20.0);
        moving.wheel.yaw = 3e-3;
        let moving = pressed(&mut element, &moving, 1e-4);
        let mut standing = moving;
        standing.wheel.velocity[0] = 0.0;
        // The roller's surface goes back as fast as the wheel went forward, where it is as far from
        // its axle as at its marker.
        standing.rails[0].pitch_rate = 20.0 / ROLLER;
        let (one, other) = (evaluate(&mut element, &moving), evaluate(&mut element, &standing));
        let (one, other) = (one.patches[0], other.patches[0]);
        assert_relative_eq!(one.normal_force, other.normal_force, max_relative = 1e-9);
        let radius = ROLLER - one.position[2];
        let forward = 20.0 * radius / ROLLER;
        // Slip in place of creepage, since the speeds of reference differ.
        let slips = [(one, 20.0), (other, forward)].map(|(patch, forward)| {
            let reference = 0.5 * (forward + 20.0 / 0.46 * patch.rolling_radius);
            patch.creepage.map(|creepage| creepage * reference)
        });
        let [one_slip, slip] = slips;
        assert_relative_eq!(one_slip[0] + forward - 20.0, slip[0], epsilon = 1e-6);
        // Behind its top the roller's surface comes up.
        let rise = 20.0 * one.position[0] / ROLLER * one.contact_angle.sin();
        assert_relative_eq!(one_slip[1] + rise, slip[1], epsilon = 1e-6);
        // A roller that turns spins with its own cone too.
        let cone = 20.0 * one.contact_angle.sin() / ROLLER;
        assert_relative_eq!(one_slip[2] + cone, slip[2], epsilon = 1e-5);
    }
}

/// Power that wheel and roller put into their contact [W].
fn power(input: &Input, output: &Output) -> f64 {
    let ((sin_yaw, cos_yaw), (sin_roll, cos_roll)) =
        (input.wheel.yaw.sin_cos(), input.wheel.roll.sin_cos());
    let axle = [-sin_yaw, cos_yaw * cos_roll, cos_yaw * sin_roll];
    let about_axle: f64 = axle.iter().zip(output.wheel.moment).map(|(a, m)| a * m).sum();
    let pushed: f64 =
        input.wheel.velocity.iter().zip(output.wheel.force).map(|(v, force)| v * force).sum();
    let roller = output.rails[0];
    let torque = roller.moment[1] - ROLLER * roller.force[0];
    pushed + about_axle * input.wheel.pitch_rate + torque * input.rails[0].pitch_rate
}

#[test]
fn what_wheel_and_roller_lose_is_the_frictional_power() {
    let parameters = Parameters { damping: 0.0, ..parameters("S1002", "60E1") };
    let mut element = element(&parameters);
    let mut random = Random::new(5);
    for _ in 0..40 {
        let mut input = random_input(&mut element, &mut random);
        (input.wheel.roll_rate, input.wheel.yaw_rate) = (0.0, 0.0);
        input.rails[0] = RailMotion::default();
        let speed = random.about(30.0);
        input.wheel.velocity = [0.0, random.about(0.1), 0.0];
        input.wheel.pitch_rate = -speed / 0.46 * (1.0 + random.about(5e-3));
        input.rails[0].pitch_rate = speed / ROLLER;
        let input = pressed(&mut element, &input, 1e-4);
        let output = evaluate(&mut element, &input);
        // The normal force is the same without friction.
        let smooth = Input { friction: 0.0, ..input };
        let pressing = power(&smooth, &evaluate(&mut element, &smooth));
        let taken = power(&input, &output) - pressing;
        let size = output.wheel.force[2].abs() * speed.abs();
        assert!(output.frictional_power > 0.0);
        assert_relative_eq!(
            taken / size,
            -output.frictional_power / size,
            epsilon = tolerance::SIMILARITY
        );
        // Normal forces turn a roller by what the centroid of their load is off the line of the
        // axles.
        let turning = (pressing - smooth_push(&smooth, &mut element)).abs();
        // A hundredth of what friction may do.
        assert!(turning < 3e-3 * size, "{turning} {size}");
    }
}

/// Power of the wheel against the normal force alone [W].
fn smooth_push(input: &Input, element: &mut Element) -> f64 {
    let output = evaluate(element, input);
    input.wheel.velocity.iter().zip(output.wheel.force).map(|(v, force)| v * force).sum()
}

#[test]
fn wheels_of_simple_shapes_on_rollers_are_those_of_contact() {
    let mut report =
        String::from("case,force,pressure,place_m,angle,spin_per_m,creep_force,spin_moment\n");
    for (case, errors) in errors_against_contact(&Parameters::default()) {
        let Errors { force, pressure, place, angle, spin, creep, moment } = errors;
        writeln!(report, "{case},{force:.5},{pressure:.5},{place:.2e},{angle:.2e},{spin:.2e},{creep:.5},{moment:.4}").unwrap();
        assert!(force.abs() <= tolerance::ROLLER_FORCE, "{case} {force}");
        assert!(pressure.abs() <= tolerance::ROLLER_PRESSURE, "{case} {pressure}");
        assert!(place.abs() <= tolerance::VARYING_PLACE, "{case} {place}");
        assert!(angle.abs() <= tolerance::ROLLER_ANGLE, "{case} {angle}");
        assert!(creep <= tolerance::VARYING_FORCE, "{case} {creep}");
    }
    common::write_report("rollers.csv", &report);
}

#[test]
fn boundary_elements_on_rollers_are_those_of_contact_too() {
    let parameters = Parameters {
        normal_model: NormalModel::BoundaryElement,
        tangential_model: TangentialModel::BoundaryElement,
        ..Parameters::default()
    };
    for (case, errors) in errors_against_contact(&parameters) {
        let Errors { force, pressure, place, angle, creep, .. } = errors;
        println!("{case}: {force:.5} {pressure:.5} {place:.2e} {angle:.2e} {creep:.5}");
        assert!(force.abs() <= tolerance::ROLLER_FORCE, "{case} {force}");
        assert!(pressure.abs() <= tolerance::ROLLER_PRESSURE, "{case} {pressure}");
        assert!(place.abs() <= tolerance::VARYING_PLACE, "{case} {place}");
        assert!(angle.abs() <= tolerance::ROLLER_ANGLE, "{case} {angle}");
        assert!(creep <= tolerance::VARYING_FORCE, "{case} {creep}");
    }
}

#[test]
fn forces_on_wheel_and_roller_are_in_balance_and_the_left_side_is_a_mirror() {
    let mut parameters = parameters("S1002", "60E1");
    let mut right = element(&parameters);
    parameters.side = Side::Left;
    let mut left = element(&parameters);
    let marker = common::wheel::rail_marker(&parameters);
    let mut random = Random::new(3);
    for _ in 0..40 {
        let mut input = random_input(&mut right, &mut random);
        input.rails[0] = RailMotion { pitch_rate: random.about(10.0), ..RailMotion::default() };
        let touch = right.touching_height(&input);
        input.wheel.position[2] = touch + 8e-5;
        assert_balanced([&mut right, &mut left], &input, marker, tolerance::SIMILARITY);
    }
}

#[test]
fn evaluations_on_a_roller_allocate_nothing() {
    for mode in [VerticalMode::Penetration, VerticalMode::Load] {
        let mut parameters = parameters("S1002", "60E1");
        parameters.vertical_mode = mode;
        let mut element = element(&parameters);
        let mut output = Output::default();
        let before = allocations::count();
        for i in 0..200 {
            let t = f64::from(i);
            let mut input = on_rig(5e-3 * (0.3 * t).sin(), 20.0);
            input.wheel.position[0] = 0.02 * (0.17 * t).sin();
            input.wheel.yaw = 0.02 * (0.7 * t).sin();
            input.wheel.position[2] = -0.46 + 4e-4 * (0.11 * t).sin();
            input.wheel_load = 5e4 * (0.2 * t).sin();
            element.evaluate(&input, &mut output).unwrap();
        }
        assert_eq!(allocations::count(), before);
    }
}

#[test]
fn what_does_not_go_with_a_roller_is_refused_by_name() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("rail.csv"), "station_m,profile\n0,60E1\n2,60E1\n").unwrap();
    fs::write(folder.path().join("friction.csv"), "friction\n0.3\n").unwrap();
    let refused = |change: &dyn Fn(&mut Parameters), name: &str, words: &str| {
        let mut parameters = parameters("S1002", "60E1");
        change(&mut parameters);
        let folders = [folder.path().to_path_buf()];
        let message =
            Element::new(&parameters, &Input::default(), &folders).unwrap_err().to_string();
        for part in [name, words] {
            assert!(message.contains(part), "{message}");
        }
    };
    let name = "rail[1].roller_radius";
    refused(&|p| p.wear.model = WearModel::Archard, name, "wear.model");
    let profile = |p: &mut Parameters| {
        p.friction_distribution = FrictionDistribution::Profile;
        p.friction_profile = "friction.csv".into();
    };
    refused(&profile, name, "friction.distribution");
    refused(&|p| p.rails[0].profile = "rail.csv".into(), "rail[1].profile", "roller_radius");
    for radius in [-0.8, 0.05, f64::NAN, 1e3] {
        refused(&|p| p.rails[0].roller_radius = radius, name, &radius.to_string());
    }
}
