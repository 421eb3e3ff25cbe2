//! Given load: the rails carry it, at every place and in every state; what is defined where they
//! cannot.

use crate::common::random::Random;
use crate::common::wheel::{element, evaluate, mirrored, random_input, rolling};
use crate::common::write_report;
use crate::tolerance;
use wheelrail::element::parameters::{CreepageModel, NormalModel, Side, VerticalMode};
use wheelrail::element::{Element, Input, Output, Parameters};

fn loaded() -> Parameters {
    Parameters { vertical_mode: VerticalMode::Load, ..Parameters::default() }
}

/// The same element with given height and without damping.
fn pressed_element(parameters: &Parameters) -> Element {
    element(&Parameters {
        vertical_mode: VerticalMode::Penetration,
        damping: 0.0,
        ..parameters.clone()
    })
}

#[test]
fn the_rails_carry_the_load_wherever_the_wheel_is_and_the_height_gives_the_same_forces() {
    let variants = [
        loaded(),
        Parameters {
            normal_model: NormalModel::PiotrowskiKikCorrected,
            creepage_model: CreepageModel::Curved,
            ..loaded()
        },
        Parameters { normal_model: NormalModel::Hertz, ..loaded() },
    ];
    for parameters in variants {
        let mut carried = element(&parameters);
        let mut pressed = pressed_element(&parameters);
        let mut random = Random::new(31);
        let (mut missed, mut searches, mut worst_off) = (0, Vec::new(), 0.0_f64);
        for _ in 0..500 {
            let mut input = random_input(&mut pressed, &mut random);
            input.wheel_load = 1e3 * 10f64.powf(random.within(-1.0, 2.3));
            let (before, fallbacks) = (carried.work().searches, carried.fallbacks());
            let output = evaluate(&mut carried, &input);
            searches.push(carried.work().searches - before);
            let mut given = input;
            given.wheel.position[2] = output.wheel_z;
            let same = evaluate(&mut pressed, &given);
            let forces = same.wheel.force.into_iter().zip(output.wheel.force);
            let square: f64 = output.wheel.force.iter().map(|force| force * force).sum();
            let scale = square.max(input.wheel_load.powi(2)) / input.wheel_load;
            for (same, found) in forces {
                let off = (same - found).abs();
                worst_off = worst_off.max(off / scale);
                let [share, floor] = tolerance::LOAD_AND_HEIGHT;
                assert!(off <= share * scale + floor, "{off:e} {input:?}");
            }
            let miss = (output.wheel.force[2] + input.wheel_load).abs();
            let [share, floor] = tolerance::CARRIED_LOAD;
            if carried.fallbacks() > fallbacks {
                // At a jump of the model, on the side that carries, or on the other one where that
                // carries more than twice the load.
                missed += 1;
                given.wheel.position[2] += 1e-9;
                let beyond = evaluate(&mut pressed, &given).load_carried;
                let is_jump = beyond > 2.0 * input.wheel_load;
                assert!(output.load_carried >= input.wheel_load || is_jump, "{input:?}");
            } else {
                // What rounding of coordinates of a metre does.
                let mut at = |z: f64| {
                    given.wheel.position[2] = z;
                    evaluate(&mut pressed, &given).wheel.force[2]
                };
                let [above, below] =
                    [-f64::EPSILON, f64::EPSILON].map(|by| at(output.wheel_z + by));
                let most = share * input.wheel_load + floor.max(0.5 * (above - below).abs());
                assert!(miss < most, "{miss:e} {input:?}");
            }
            // The given height has no effect.
            input.wheel.position[2] -= 0.3;
            let again = evaluate(&mut carried, &input);
            assert_eq!(again.wheel, output.wheel);
        }
        searches.sort_unstable();
        let [median, worst] = [searches[searches.len() / 2], searches[searches.len() - 1]];
        println!(
            "{:?}: {missed} jumps, searches {median}, {worst}, forces {worst_off:.1e} off",
            parameters.normal_model
        );
        assert!(median <= 6 && worst <= 150, "{median} {worst}");
        assert!(missed <= 10, "{missed}");
    }
}

#[test]
fn height_and_forces_are_continuous_in_the_load_down_to_none() {
    let mut element = element(&loaded());
    let mut input = rolling(0.0, 20.0);
    input.wheel.velocity[1] = 0.05;
    let touching = element.touching_height(&input);
    input.wheel_load = 0.0;
    let lifted = evaluate(&mut element, &input);
    let mut expected = Output::default();
    expected.wheel_z = touching;
    assert_eq!(lifted, expected);
    input.wheel_load = -5e3;
    assert_eq!(evaluate(&mut element, &input), lifted);
    let mut before = touching;
    for power in -60..=54 {
        input.wheel_load = 10f64.powf(f64::from(power) / 10.0);
        let output = evaluate(&mut element, &input);
        assert!(output.wheel_z >= before, "{} after {before}", output.wheel_z);
        // N ~ δ^(3/2), roughly.
        let expected = (input.wheel_load / 7e10).powf(2.0 / 3.0);
        assert!(output.wheel_z - touching < 2.0 * expected + 1e-12, "{}", output.wheel_z);
        before = output.wheel_z;
    }
    assert_eq!(element.fallbacks(), 0);
}

#[test]
fn a_load_that_nothing_carries_has_a_defined_result_and_is_counted() {
    let mut element = element(&loaded());
    let mut input = rolling(0.0, 20.0);
    input.wheel_load = 1e15;
    let most = evaluate(&mut element, &input);
    assert_eq!(most.fallback_count, 1);
    assert!(most.wheel.force[2] < -1e6 && most.wheel.force[2] > -1e15, "{:?}", most.wheel);
    input.wheel_load = 1e300;
    assert_eq!(evaluate(&mut element, &input).wheel, most.wheel);
    // Beside the rail.
    input.wheel.position[1] = 0.3;
    input.wheel_load = 5e4;
    let beside = evaluate(&mut element, &input);
    let mut expected = Output::default();
    (expected.wheel_z, expected.fallback_count) = (input.wheel.position[2], 3);
    assert_eq!(beside, expected);
    input.wheel_load = 0.0;
    assert_eq!(evaluate(&mut element, &input).fallback_count, 3);
}

#[test]
fn a_load_is_carried_or_said_not_to_be_and_no_force_is_beyond_its_order() {
    use NormalModel::{Hertz, PiotrowskiKik, PiotrowskiKikCorrected, Strips};
    for (normal_model, poses) in
        [(Hertz, 150), (PiotrowskiKik, 250), (PiotrowskiKikCorrected, 150), (Strips, 20)]
    {
        let mut element = element(&Parameters { normal_model, ..loaded() });
        let mut random = Random::new(33);
        let mut missed = 0;
        for _ in 0..poses {
            // From inside the gauge face to beyond the field side of the rail, where wheels come
            // down beside it or into its sides.
            let mut input = rolling(random.within(-0.16, 0.12), 0.0);
            (input.wheel.yaw, input.wheel.roll) = (random.about(0.05), random.about(0.05));
            input.rails[0].roll = random.about(0.1);
            input.friction = 0.0;
            input.wheel_load = 10f64.powf(random.within(1.0, 6.0));
            let load = input.wheel_load;
            let before = element.fallbacks();
            let output = evaluate(&mut element, &input);
            assert!((output.load_carried + output.wheel.force[2]).abs() <= 0.0);
            let [share, floor] = tolerance::MISSED_LOAD;
            let is_carried = (output.load_carried - load).abs() <= share * load + floor;
            missed += i32::from(!is_carried);
            assert!(is_carried || element.fallbacks() > before, "{output:?} {input:?}");
            assert!(output.load_carried <= 2.0 * load + floor, "{output:?} {input:?}");
            assert!(output.load_carried >= 0.0, "{output:?} {input:?}");
        }
        println!("{normal_model:?}: {missed} of {poses} not carried");
        assert!(missed > 0);
    }
}

#[test]
fn a_left_wheel_carries_its_load_as_the_mirror_image_of_a_right_one() {
    let mut right = element(&loaded());
    let mut left = Element::new(
        &Parameters { side: Side::Left, ..loaded() },
        &mirrored(&Input::default()),
        &[],
    )
    .unwrap();
    let mut random = Random::new(32);
    for _ in 0..50 {
        let mut input = random_input(&mut right, &mut random);
        input.wheel_load = random.within(0.0, 1.5e5);
        let (r, l) = (evaluate(&mut right, &input), evaluate(&mut left, &mirrored(&input)));
        assert_eq!(r.wheel_z.to_bits(), l.wheel_z.to_bits());
        assert!((r.wheel.force[1] + l.wheel.force[1]).abs() <= 0.0);
    }
}

#[test]
fn the_height_follows_the_wheel_across_the_rail_without_steps_where_the_force_has_none() {
    use std::fmt::Write;
    let mut report = String::from("y_mm,wheel_z_mm,force_y_n\n");
    let mut element = element(&loaded());
    let mut input = rolling(0.0, 20.0);
    input.wheel_load = 5e4;
    // On the tread outside the places where the two minima swap.
    let mut heights = Vec::new();
    for i in 0..=2000 {
        let shift = -5e-3 + 1e-6 * f64::from(i);
        input.wheel.position[1] = 0.75 + shift;
        let output = evaluate(&mut element, &input);
        heights.push(output.wheel_z);
        writeln!(report, "{},{},{}", 1e3 * shift, 1e3 * output.wheel_z, output.wheel.force[1])
            .unwrap();
    }
    let second = heights.windows(3).map(|h| (h[0] - 2.0 * h[1] + h[2]).abs()).fold(0.0, f64::max);
    write_report("height_under_load.csv", &report);
    assert!(second < tolerance::HEIGHT_ROUGHNESS, "{second:e}");
}

#[test]
fn a_load_on_tread_and_gauge_face_is_carried_where_the_wheel_stands_upright_between_them() {
    let mut element =
        element(&Parameters { vertical_mode: VerticalMode::Load, ..Parameters::default() });
    let mut input = rolling(0.0, 20.0);
    let wheel = &mut input.wheel;
    wheel.position[1] = 0.748_849_512_159_364_3;
    (wheel.roll, wheel.yaw) = (-0.015_004_591_607_284_571, -0.031_477_582_893_000_074);
    wheel.velocity[1] = 0.022_962_158_866_193_766;
    (wheel.roll_rate, wheel.yaw_rate) = (0.002_037_044_589_819_237, -0.030_426_938_512_800_26);
    input.wheel_load = 40_100.443_938_739_83;
    let output = evaluate(&mut element, &input);
    let [share, force] = tolerance::CARRIED_LOAD;
    let missed = (output.wheel.force[2] + input.wheel_load).abs();
    assert!(missed <= share * input.wheel_load + force, "{missed}");
    assert_eq!(output.fallback_count, 0);
}
