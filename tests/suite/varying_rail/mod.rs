//! Rails whose section varies along the track: slices and tables of sections.

mod against_contact;
mod boundary_elements;
mod corrugation;
pub mod crossing;
mod drifting_sections;
mod equal_sections;
mod parts;
mod steep_sides;

use self::crossing::crossing;
use crate::allocations;
use crate::common;
use crate::tolerance;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::fmt::Write;
use std::fs;

use crate::common::contact_plane::{OnPlane, Whose, errors_on_plane, on_planes};
use crate::common::random::Random;
use crate::common::varying::{
    crown, errors_against_contact, of_slices, outputs_of, rail_of, slices,
};
use crate::common::vectors::assert_balanced;
use crate::common::wheel::{evaluate, random_input, rolling, the_patch};
use crate::common::{median_and_worst, spread};
use approx::assert_relative_eq;
use tempfile::TempDir;
use wheelrail::element::input::{INPUT_NAMES, RailMotion};
use wheelrail::element::parameters::{
    CreepageModel, FrictionDistribution, NormalModel, Placement, Side, TangentialModel,
    VerticalMode, WearModel,
};
use wheelrail::element::{Element, Input, Output, Parameters};

/// A rail of slices in its own frame at y = 0.75 m.
fn parameters() -> Parameters {
    of_slices(Parameters::default())
}

fn element(parameters: &Parameters, folder: &TempDir) -> Element {
    Element::new(parameters, &Input::default(), &[folder.path().to_path_buf()]).unwrap()
}

#[test]
fn slices_that_are_all_the_same_are_one_profile() {
    let folder = TempDir::new().unwrap();
    let table = "station_m,profile\n-1,60E1\n-0.02,60E1\n0.03,60E1\n2,60E1\n";
    fs::write(folder.path().join("rail.csv"), table).unwrap();
    for mirrored in [false, true] {
        let mut even = Parameters::default();
        even.rails[0].mirrored = mirrored;
        let mut varying = even.clone();
        varying.rails[0].profile = "rail.csv".into();
        let (mut even, mut varying) = (element(&even, &folder), element(&varying, &folder));
        assert_eq!(even.nominal_wheel_z().to_bits(), varying.nominal_wheel_z().to_bits());
        let mut random = Random::new(7);
        for _ in 0..100 {
            let mut input = random_input(&mut even, &mut random);
            // A search ends at a nanometre. On the flank of a yawed wheel, whose line leads there,
            // that turns the frame and the force with it.
            input.wheel.yaw = 0.0;
            input.track_s = random.about(3.0);
            let (one, other) = (evaluate(&mut even, &input), evaluate(&mut varying, &input));
            assert_eq!(one.patch_count, other.patch_count);
            let largest = one.wheel.force.iter().fold(0.0_f64, |most, force| most.max(force.abs()));
            let scale = largest * tolerance::SIMILARITY + tolerance::NO_FORCE;
            for i in 0..3 {
                assert_relative_eq!(one.wheel.force[i], other.wheel.force[i], epsilon = scale);
                assert_relative_eq!(one.wheel.moment[i], other.wheel.moment[i], epsilon = scale);
            }
        }
    }
}

#[test]
fn a_wheel_on_a_rail_that_rises_stands_on_its_slope() {
    for slope in [0.05, -0.1] {
        let places = (-10..=10).map(|i| 20.0 * f64::from(i));
        let folder = slices(places, |place| crown(1.0, [0.0, -slope * place]));
        let mut parameters = parameters();
        parameters.wheel.profile = "cylindrical".into();
        let mut element = element(&parameters, &folder);
        let mut input = Input { friction: 0.0, ..Input::default() };
        for station in [-0.05, 0.013, 0.04] {
            input.track_s = station;
            let touch = element.touching_height(&input);
            let radius = parameters.wheel.nominal_radius;
            let expected = -slope * station - radius * f64::hypot(1.0, slope);
            // The numbers of the files are rounded at 1e-12 m, and splines go through points of the
            // crown.
            assert_relative_eq!(touch, expected, epsilon = 1e-9);
            input.wheel.position[2] = touch + 1e-4;
            let output = evaluate(&mut element, &input);
            let [fx, _, fz] = output.wheel.force;
            // Pushed along the normal of the slope, which goes through the axle.
            assert_relative_eq!(fx / fz, slope, max_relative = 1e-3);
            let own = output.wheel.moment[1] / (fz * radius);
            assert_relative_eq!(own, 0.0, epsilon = tolerance::SIMILARITY);
            let ahead = radius * slope / f64::hypot(1.0, slope);
            assert_relative_eq!(the_patch(&output).position[0], ahead, epsilon = 2e-5);
        }
    }
}

#[test]
fn a_rail_that_runs_off_sideways_is_a_wheel_that_yaws() {
    let angle = 0.06_f64;
    let places = (-10..=10).map(|i| 20.0 * f64::from(i));
    let oblique =
        slices(places.clone(), |place| crown(1.0 / angle.cos(), [angle.tan() * place, 0.0]));
    let straight = slices(places, |_| crown(1.0, [0.0, 0.0]));
    let mut parameters = parameters();
    parameters.wheel.profile = "conical:0.025".into();
    let (mut oblique, mut straight) =
        (element(&parameters, &oblique), element(&parameters, &straight));
    for shift in [-4e-3, 3e-3] {
        let mut input = Input::default();
        input.wheel.position[1] = 0.75 + shift;
        let mut turned = input;
        turned.wheel.yaw = -angle;
        turned.wheel.position[1] = 0.75 + shift * angle.cos();
        let (one, other) = (oblique.touching_height(&input), straight.touching_height(&turned));
        assert_relative_eq!(one, other, epsilon = 1e-8);
        (input.wheel.position[2], turned.wheel.position[2]) = (one + 1e-4, other + 1e-4);
        let (one, other) = (evaluate(&mut oblique, &input), evaluate(&mut straight, &turned));
        let (one, other) = (the_patch(&one), the_patch(&other));
        assert_relative_eq!(one.normal_force, other.normal_force, max_relative = 2e-3);
        assert_relative_eq!(one.max_pressure, other.max_pressure, max_relative = 5e-3);
        let along = other.position[0] * angle.cos() - (other.position[1] - 0.75) * angle.sin();
        let along = along + shift * angle.cos() * angle.sin();
        assert_relative_eq!(one.position[0], along, epsilon = 2e-4);
    }
}

#[test]
fn a_wheel_rolls_over_a_crossing_without_jumps() {
    // A nose rises beside a head that runs off sideways and down.
    let places = (-8..=12).map(|i| 25.0 * f64::from(i));
    let folder = slices(places, |place| {
        let drop = 0.5 * (0.02 * place).tanh();
        crown(1.0, [0.03 * place, drop - 1e-5 * place * place])
    });
    let mut parameters = parameters();
    parameters.vertical_mode = VerticalMode::Load;
    parameters.wheel.profile = "conical:0.01".into();
    roll_without_jumps(&mut element(&parameters, &folder), 5e-5, 1200);
    // Higher waves are hollow for the wheel, which goes over from crest to crest faster than these
    // steps follow.
    for amplitude in [1e-5, 3e-5] {
        parameters.rails[0].corrugation.amplitude = amplitude;
        roll_without_jumps(&mut element(&parameters, &folder), 5e-5, 1200);
    }
}

/// Rolls a wheel from 30 mm before the origin of the track on in `count` steps of length `step`
/// [m].
pub fn roll_without_jumps(element: &mut Element, step: f64, count: i32) {
    let mut input = rolling(0.0, 20.0);
    input.wheel_load = 80e3;
    let mut last: Vec<[f64; 3]> = Vec::new();
    let mut output = Output::default();
    for i in 0..count {
        input.track_s = -0.03 + step * f64::from(i);
        input.wheel.pitch = -input.track_s / 0.46;
        element.evaluate(&input, &mut output).unwrap();
        let limit = input.friction * input.wheel_load;
        last.push([output.wheel_z, output.wheel.force[0] / limit, output.wheel.force[1] / limit]);
    }
    // The height at which a ball would carry as much more or less as a force may jump.
    let height = output.patches[0].penetration * tolerance::WALK_JUMPS[0] / 1.5;
    for window in last.windows(4) {
        let allowed = [height, tolerance::WALK_JUMPS[1], tolerance::WALK_JUMPS[1]];
        for (k, allowed) in allowed.into_iter().enumerate() {
            let [a, b, c, d] = [0, 1, 2, 3].map(|i| window[i][k]);
            // Third differences are those of a jump alone: waves of the surface are 25 mm long, and
            // their curvature bends at a slice.
            let jump = (d - 3.0 * c + 3.0 * b - a).abs();
            assert!(jump < allowed, "{k}: {jump}");
        }
    }
}

#[test]
fn what_does_not_go_with_slices_is_refused_by_name() {
    let folder = slices([0.0, 10.0].into_iter(), |_| crown(1.0, [0.0, 0.0]));
    let refused = |change: &dyn Fn(&mut Parameters), words: &str| {
        let mut parameters = parameters();
        change(&mut parameters);
        let made = Element::new(&parameters, &Input::default(), &[folder.path().to_path_buf()]);
        let message = made.unwrap_err().to_string();
        for part in ["rail[1].profile", "rail.slcs", words] {
            assert!(message.contains(part), "{message}");
        }
    };
    refused(&|p| p.wear.model = WearModel::Archard, "wear.model");
    let by_profile = |p: &mut Parameters| {
        p.friction_distribution = FrictionDistribution::Profile;
        p.friction_profile = "friction.csv".into();
    };
    refused(&by_profile, "friction.distribution");
}

#[test]
fn every_real_time_normal_model_carries_a_wheel_on_a_slope() {
    let places = (-10..=10).map(|i| 20.0 * f64::from(i));
    let folder = slices(places, |place| crown(1.0, [0.0, -0.05 * place]));
    let models = [NormalModel::Hertz, NormalModel::PiotrowskiKik, NormalModel::Strips];
    let forces = models.map(|model| {
        let mut parameters = parameters();
        parameters.normal_model = model;
        parameters.wheel.profile = "conical:0.025".into();
        let mut element = element(&parameters, &folder);
        let mut input = Input::default();
        input.wheel.position[2] = element.touching_height(&input) + 1e-4;
        let output = evaluate(&mut element, &input);
        assert!((the_patch(&output).position[0] - 0.023).abs() < 1e-3);
        the_patch(&output).normal_force
    });
    for force in forces {
        assert!((force / forces[2] - 1.0).abs() < 0.2, "{forces:?}");
    }
}

#[test]
fn forces_on_wheel_and_rail_are_in_balance_and_the_left_side_is_a_mirror() {
    let folder = crossing();
    let mut parameters = parameters();
    parameters.wheel.profile = "conical:0.025".into();
    let mut right = element(&parameters, &folder);
    parameters.side = Side::Left;
    parameters.rails[0].position[0] *= -1.0;
    let mut left = element(&parameters, &folder);
    // The highest point of the first section, that of the wing 150 mm before the origin.
    let marker = [0.0, 0.75 - 0.0115, 0.00015];
    let mut random = Random::new(3);
    for _ in 0..40 {
        let mut input = random_input(&mut right, &mut random);
        input.rails[0] = RailMotion::default();
        // On the crowns, not on their ends.
        input.wheel.position[1] = 0.75 + random.about(2e-3);
        (input.wheel.roll, input.wheel.yaw) = (random.about(1e-3), random.about(5e-3));
        input.track_s = random.about(0.1);
        input.wheel.position[2] = right.touching_height(&input) + 8e-5;
        let sides = [&mut right, &mut left];
        let output = assert_balanced(sides, &input, marker, tolerance::SIMILARITY);
        assert!(output.patch_count > 0);
    }
}

#[test]
fn heights_converge_with_the_fourth_power_of_the_distance_of_slices() {
    let wave = std::f64::consts::TAU / 0.3;
    let height = |s: f64| -1e-3 * (wave * s).cos();
    let mut parameters = parameters();
    parameters.wheel.profile = "cylindrical".into();
    let radius = parameters.wheel.nominal_radius;
    let worst = [30.0, 15.0, 7.5].map(|apart| {
        let count = (600.0 / apart) as i32;
        let places = (-count..=count).map(|i| apart * f64::from(i));
        let folder = slices(places, |place| crown(1.0, [0.0, 1e3 * height(1e-3 * place)]));
        let mut element = element(&parameters, &folder);
        let mut worst: f64 = 0.0;
        for i in 0..30 {
            let mut input = Input { track_s: 0.01 * f64::from(i) + 1e-3, ..Input::default() };
            input.wheel.position[0] = 2e-3;
            let station = input.track_s + input.wheel.position[0];
            // Newton's method on the slope of the distance from the wheel's circle.
            let mut x = 0.0_f64;
            for _ in 0..30 {
                let root = (radius * radius - x * x).sqrt();
                let slope = 1e-3 * wave * (wave * (station + x)).sin() + x / root;
                let bend = 1e-3 * wave * wave * (wave * (station + x)).cos()
                    + radius * radius / root.powi(3);
                x -= slope / bend;
            }
            let exact = height(station + x) - (radius * radius - x * x).sqrt();
            worst = worst.max((element.touching_height(&input) - exact).abs());
        }
        worst
    });
    // Rounded files are left at the end.
    assert!(worst[0] / worst[1] > 12.0 && worst[1] / worst[2] > 12.0, "{worst:?}");
    assert!(worst[2] < tolerance::VARYING_HEIGHT, "{worst:?}");
}

#[test]
fn a_contact_laid_flat_is_as_round_as_wheel_and_rail_together() {
    let places = (-10..=10).map(|i| 20.0 * f64::from(i));
    let folder = slices(places, |place| crown(1.0, [0.0, 0.5e-3 * place * place]));
    let mut parameters = parameters();
    parameters.wheel.profile = "cylindrical".into();
    let mut element = element(&parameters, &folder);
    let mut input = Input::default();
    input.wheel.position[2] = element.touching_height(&input) + 1e-4;
    let flat = element.flat_contacts(&input).unwrap();
    let radius = 1.0 / (1.0 / parameters.wheel.nominal_radius + 1.0);
    // Ends of the rail without curvature are ten slices away, each of which leaves a quarter of
    // their effect.
    assert_relative_eq!(flat[0].radius, radius, max_relative = 1e-5);
}

#[test]
fn evaluations_on_a_crossing_allocate_nothing() {
    let folder = crossing();
    let mut parameters = parameters();
    let modes = [VerticalMode::Penetration, VerticalMode::Load];
    for (mode, amplitude) in modes.into_iter().flat_map(|mode| [(mode, 0.0), (mode, 5e-5)]) {
        parameters.vertical_mode = mode;
        parameters.rails[0].corrugation.amplitude = amplitude;
        let mut element = element(&parameters, &folder);
        let mut output = Output::default();
        let mut touched = 0;
        let before = allocations::count();
        for i in 0..150 {
            let t = f64::from(i);
            let mut input = rolling(5e-3 * (0.3 * t).sin(), 20.0);
            input.track_s = 0.25 * (0.05 * t).sin();
            input.wheel.yaw = 0.02 * (0.7 * t).sin();
            input.wheel.position[2] = -0.46 + 4e-4 * (0.11 * t).sin();
            if i % 20 == 0 {
                // Right through the rail.
                input.wheel.position[2] += 0.012;
            }
            input.wheel_load = 5e4 * (0.2 * t).sin();
            element.evaluate(&input, &mut output).unwrap();
            touched += i32::from(output.patch_count > 0);
        }
        assert_eq!(allocations::count(), before);
        assert!(touched > 40, "{touched}");
    }
}

#[test]
fn frictionless_forces_on_a_slope_that_bends_have_an_energy() {
    // The change of the vertical force along the track is that of the longitudinal one with the
    // height.
    let places = (-20..=20).map(|i| 10.0 * f64::from(i));
    let folder = slices(places, |place| crown(1.0, [0.0, 4.0 * (place / 60.0).cos()]));
    let mut parameters = parameters();
    parameters.wheel.profile = "cylindrical".into();
    let mut element = element(&parameters, &folder);
    for station in [-0.06, -0.02, 0.03, 0.08] {
        let mut input = Input { friction: 0.0, track_s: station, ..Input::default() };
        let height = element.touching_height(&input) + 1e-4;
        let mut force = |ahead: f64, down: f64| {
            input.track_s = station + ahead;
            input.wheel.position[2] = height + down;
            evaluate(&mut element, &input).wheel.force
        };
        let (h, d) = (2e-6, 2e-7);
        let along = (force(h, 0.0)[2] - force(-h, 0.0)[2]) / (2.0 * h);
        let down = (force(0.0, d)[0] - force(0.0, -d)[0]) / (2.0 * d);
        assert_relative_eq!(along, down, max_relative = tolerance::VARYING_ENERGY);
    }
}

#[test]
fn before_the_first_of_unlike_sections_the_rail_is_that_section() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("rail.csv"), "station_m,profile\n0,60E1\n2,60E2\n").unwrap();
    let even = Parameters { vertical_mode: VerticalMode::Load, ..Parameters::default() };
    let mut varying = even.clone();
    varying.rails[0].profile = "rail.csv".into();
    let (mut even, mut varying) = (element(&even, &folder), element(&varying, &folder));
    for i in -8..=8 {
        let mut input = rolling(1e-3 * f64::from(i), 10.0);
        (input.track_s, input.wheel_load) = (-1.0, 6e4);
        let (one, other) = (evaluate(&mut even, &input), evaluate(&mut varying, &input));
        // Held to a tenth of the micrometre that is aimed at along rails that vary.
        assert_relative_eq!(one.wheel_z, other.wheel_z, epsilon = 1e-7);
    }
}

#[test]
fn the_station_is_a_direction_like_any_other() {
    let folder = crossing();
    let mut parameters = parameters();
    parameters.vertical_mode = VerticalMode::Load;
    parameters.wheel.profile = "conical:0.025".into();
    let mut element = element(&parameters, &folder);
    let mut input = rolling(0.0, 10.0);
    (input.track_s, input.wheel_load) = (0.05, 6e4);
    let mut columns = Vec::new();
    element.jacobian(&input, &mut columns).unwrap();
    let [x, s] = ["wheel.x", "track.s"]
        .map(|name| columns[INPUT_NAMES.iter().position(|own| *own == name).unwrap()]);
    // On the wing, which falls by 1 in 1000 and runs off by 3 in 100 below a cone of 1 in 40.
    assert_relative_eq!(s.wheel_z, 1e-3 - 0.03 * 0.025, epsilon = 1e-7);
    assert_relative_eq!(x.wheel_z, s.wheel_z, max_relative = tolerance::SIMILARITY);
    let size = s.wheel.force.iter().fold(1.0_f64, |most, force| most.max(force.abs()));
    for k in 0..3 {
        let scale = size * tolerance::SIMILARITY;
        assert_relative_eq!(x.wheel.force[k], s.wheel.force[k], epsilon = scale);
    }
}
