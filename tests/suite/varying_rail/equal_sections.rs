//! Sections that are all the same are one profile.

use std::fs;
use tempfile::TempDir;
use wheelrail::element::{Element, Input, Parameters};

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
