//! Sections that are all the same are one profile.

use std::fs;
use tempfile::TempDir;
use wheelrail::element::parameters::{NormalModel, VerticalMode};
use wheelrail::element::{Element, Input, Output, Parameters};

use super::element;
use crate::common::random::Random;
use crate::common::wheel::{evaluate, rolling};
use crate::tolerance;

/// One profile, and a table that has it at five stations.
fn both(parameters: &Parameters) -> [Element; 2] {
    let folder = TempDir::new().unwrap();
    let table = "station_m,profile\n-1,60E1\n-0.5,60E1\n0,60E1\n0.5,60E1\n1,60E1\n";
    fs::write(folder.path().join("rail.csv"), table).unwrap();
    let mut varying = parameters.clone();
    varying.rails[0].profile = "rail.csv".into();
    [parameters, &varying].map(|parameters| element(parameters, &folder))
}

/// A wheel at a lateral place, with roll, yaw and station.
fn at([y, roll, yaw, station]: [f64; 4]) -> Input {
    let mut input = Input { track_s: station, ..rolling(0.0, 20.0) };
    input.wheel.position[1] = y;
    (input.wheel.roll, input.wheel.yaw) = (roll, yaw);
    input
}

/// Asserts that the wheel begins to touch both at the same height and as often below it, and neither
/// above.
fn first_touch([even, varying]: &mut [Element; 2], input: &Input, depth: f64, above: f64) {
    let mut input = *input;
    let [one, other] = [&mut *even, &mut *varying].map(|element| element.touching_height(&input));
    assert!((one - other).abs() < tolerance::TOUCHING_HEIGHT, "{one}, {other}: {input:?}");
    input.wheel.position[2] = one + depth;
    let [one, other] =
        [&mut *even, &mut *varying].map(|element| evaluate(element, &input).patch_count);
    assert!(one == other && one > 0, "{one}, {other} contacts: {input:?}");
    input.wheel.position[2] -= depth + above;
    for element in [even, varying] {
        assert_eq!(evaluate(element, &input).patch_count, 0, "{input:?}");
    }
}

fn random_poses(poses: usize, seed: u64) {
    let mut random = Random::new(seed);
    let mut both = both(&Parameters::default());
    for _ in 0..poses {
        let y = random.within(0.745, 0.76);
        let input = at([y, random.about(0.02), random.about(0.08), random.about(0.4)]);
        let (depth, above) = (random.within(1e-6, 2e-4), random.within(1e-7, 0.03));
        first_touch(&mut both, &input, depth, above);
    }
}

/// Greatest difference of force, moment over a metre and height, over the force and a metre.
fn apart(one: &Output, other: &Output) -> f64 {
    let size = one.wheel.force.iter().fold(tolerance::NO_FORCE, |most, own| most.max(own.abs()));
    let wrenches = [one, other].map(|output| [output.wheel.force, output.wheel.moment].concat());
    let loads = wrenches[0].iter().zip(&wrenches[1]).map(|(a, b)| (a - b).abs() / size);
    loads.fold((one.wheel_z - other.wheel_z).abs(), f64::max)
}

/// Asserts that wheels on both have the same forces: `poses` of them at a given height by each
/// real-time model, and as many under a given load by strips without friction. Forces of the other
/// models jump, and on a gauge face friction bears part of the load: such loads may have several
/// heights, of which rounding decides.
fn random_forces(poses: usize, seed: u64) {
    let mut random = Random::new(seed);
    let at_height = [
        NormalModel::Strips,
        NormalModel::PiotrowskiKik,
        NormalModel::PiotrowskiKikCorrected,
        NormalModel::Hertz,
    ];
    let at_height =
        at_height.map(|model| (model, VerticalMode::Penetration, tolerance::EQUAL_SECTIONS));
    let under_load = (NormalModel::Strips, VerticalMode::Load, tolerance::EQUAL_SECTIONS_LOADED);
    for (normal_model, vertical_mode, allowed) in at_height.into_iter().chain([under_load]) {
        let own = Parameters { normal_model, vertical_mode, ..Parameters::default() };
        let [mut even, mut varying] = both(&own);
        for _ in 0..poses {
            let y = random.within(0.745, 0.76);
            let mut input = at([y, random.about(0.02), random.about(0.08), random.about(0.4)]);
            input.wheel.velocity[1] = random.about(0.05);
            (input.wheel.roll_rate, input.wheel.yaw_rate) =
                (random.about(0.05), random.about(0.05));
            input.wheel.position[2] = even.touching_height(&input) + random.within(1e-6, 2e-4);
            input.wheel_load = random.within(1e3, 1e5);
            if vertical_mode == VerticalMode::Load {
                input.friction = 0.0;
            }
            let (one, other) = (evaluate(&mut even, &input), evaluate(&mut varying, &input));
            let what = || format!("{normal_model:?} {vertical_mode:?} {input:?}");
            assert!(one.patch_count > 0, "{}", what());
            let counts = |output: &Output| (output.patch_count, output.fallback_count);
            assert_eq!(counts(&one), counts(&other), "{}", what());
            let found = apart(&one, &other);
            assert!(found <= allowed, "{found:e} {}", what());
        }
    }
}

#[test]
fn equal_sections_carry_as_one_profile_does() {
    random_forces(100, 3);
}

#[test]
#[ignore = "long: cargo test --release --test suite varying_rail:: -- --ignored"]
fn twenty_thousand_wheels_are_carried_by_equal_sections_as_by_one_profile() {
    random_forces(4000, 4);
}

#[test]
fn equal_sections_are_touched_where_one_profile_is() {
    random_poses(500, 1);
    let mut both = both(&Parameters::default());
    // Rows of the gauge face without a point of the wheel opposite.
    let input = at([
        0.758_576_175_428_153_9,
        0.003_538_766_539_036_542_4,
        -0.038_384_296_293_473_8,
        -0.236_502_196_717_855_5,
    ]);
    first_touch(&mut both, &input, 1e-4, 1e-7);
    // The line runs from the flange back to the rim far at once, above the side of the rail.
    let beside = [
        ([0.745_505, -8.356_198_7e-3, -0.046_372_131, 0.091_968_167], 0.027),
        ([0.748_725_18, 1.396_697_1e-3, -0.047_381_231, 0.322_503_1], 0.023),
        ([0.750_097_82, 7.938_803e-3, 0.046_661_815, -0.240_031_03], 0.021),
        ([0.748_284_78, -4.070_715_5e-3, -0.046_377_202, 0.283_310_12], 0.019),
    ];
    for (pose, above) in beside {
        first_touch(&mut both, &at(pose), 1e-4, above);
    }
}

#[test]
#[ignore = "long: cargo test --release --test suite varying_rail:: -- --ignored"]
fn twenty_thousand_wheels_touch_equal_sections_where_they_touch_one_profile() {
    random_poses(20_000, 2);
}
