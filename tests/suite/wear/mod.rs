//! Wear of wheel and rail alongside the dynamics.

mod updates;

use crate::tolerance;
use std::f64::consts::TAU;

use approx::assert_relative_eq;
use wheelrail::element::parameters::{
    CreepageModel, FoundationModel, Motion, NormalModel, Side, TangentialModel, VerticalMode,
    WearDistribution, WearModel,
};
use wheelrail::element::{Element, Input, Output, Parameters};
use wheelrail::geometry::profile::Profile;

/// A wheel at 20 m/s with a little yaw, shifted, `depth` below first touch in the middle.
fn input(element: &Element, side: Side, shift: f64, depth: f64) -> Input {
    let mut input = Input::default();
    let sign = if side == Side::Left { -1.0 } else { 1.0 };
    input.wheel.position[1] = sign * (0.75 + shift);
    input.wheel.position[2] = element.nominal_wheel_z() + depth;
    input.wheel.yaw = sign * 2e-3;
    input.wheel.velocity = [20.0, 0.0, 0.0];
    input.wheel.pitch_rate = -20.05 / 0.46;
    input.wheel_load = 7e4;
    input
}

fn parameters(model: WearModel) -> Parameters {
    let mut parameters = Parameters::default();
    parameters.wear.model = model;
    parameters.wear.acceleration_factor = 1e6;
    parameters
}

fn element(parameters: &Parameters) -> Element {
    let mut start = Input::default();
    if parameters.side == Side::Left {
        start.wheel.position[1] = -0.75;
    }
    Element::new(parameters, &start, &[]).unwrap()
}

/// Lateral sway over the tread.
fn sway(time: f64) -> f64 {
    -2e-3 + 2.5e-3 * (TAU * 1.7 * time).sin()
}

#[test]
fn worn_volume_is_the_integral_of_the_law() {
    let normal = [NormalModel::PiotrowskiKik, NormalModel::Strips, NormalModel::Hertz];
    let distributions = [WearDistribution::Interpenetration, WearDistribution::Strips];
    for (case, normal_model) in normal.into_iter().enumerate() {
        let mut p = parameters(WearModel::FrictionalWork);
        (p.normal_model, p.strips) = (normal_model, 11);
        p.creepage_model = [CreepageModel::Flat, CreepageModel::Curved][case % 2];
        p.tangential_model = [TangentialModel::Fastsim, TangentialModel::Fastrip][case / 2];
        p.wear.wheel.frictional_work.coefficient = 2e-9;
        for distribution in distributions {
            p.wear.distribution = distribution;
            let mut element = element(&p);
            let mut output = Output::default();
            let (mut work, h) = (0.0, 2.5e-3);
            for step in 0..24 {
                let at = input(&element, Side::Right, sway(f64::from(step) * h), 7e-5);
                // The power before the step; an update leaves that of the new profile.
                element.evaluate(&at, &mut output).unwrap();
                work += output.frictional_power * h;
                element.advance(&at, &mut output, h).unwrap();
            }
            let expected = 1e6 * 2e-9 * work / 7850.0;
            let bound = tolerance::WORN_VOLUME;
            assert!(expected > 0.0);
            assert_relative_eq!(output.wheel_wear.volume, expected, max_relative = bound);
            assert_relative_eq!(output.rail_wear[0].volume, 0.5 * expected, max_relative = bound);
            // The profiles have lost as much: all of it, as the last step ended an interval.
            let state = element.wear_state().unwrap();
            assert!(state.wheel.pending.iter().all(|&v| v == 0.0));
            let rail = element.worn_rail(0).unwrap();
            let unworn = Element::new(&Parameters::default(), &Input::default(), &[]).unwrap();
            let lost = area(&unworn.worn_rail(0).unwrap()) - area(&rail);
            assert_relative_eq!(
                lost * p.wear.rail_distance,
                output.rail_wear[0].volume,
                max_relative = bound
            );
            println!(
                "{normal_model:?} {distribution:?}: depth {:e}, {:e}",
                output.wheel_wear.depth, output.rail_wear[0].depth
            );
        }
    }
}

/// Area under a rail profile, on the side of its material, against a line far below [m²].
fn area(profile: &Profile) -> f64 {
    let knots: Vec<f64> = profile.curve.knots().collect();
    let nodes = [-0.906_179_845_938_664, -0.538_469_310_105_683, 0.0];
    let weights = [0.236_926_885_056_189, 0.478_628_670_499_366, 0.568_888_888_888_889];
    let mut sum = 0.0;
    for pair in knots.windows(2) {
        let half = 0.5 * (pair[1] - pair[0]);
        for (i, (node, weight)) in nodes.iter().zip(weights).enumerate() {
            for sign in [-1.0, 1.0].into_iter().take(if i == 2 { 1 } else { 2 }) {
                let p = profile.curve.at(pair[0] + half * (1.0 + sign * node));
                sum -= half * weight * p.point[1] * p.first[0];
            }
        }
    }
    sum
}

#[test]
fn every_law_wears_wheel_and_rail_and_by_patch_or_strip_the_same_work() {
    for model in [
        WearModel::FrictionalWork,
        WearModel::Usfd,
        WearModel::BritishRail,
        WearModel::Zobory,
        WearModel::Archard,
    ] {
        let p = parameters(model);
        let mut element = element(&p);
        let mut output = Output::default();
        let at = input(&element, Side::Right, -2e-3, 7e-5);
        element.accumulate(&at, &mut output, 1e-3).unwrap();
        let [wheel, rail] = [output.wheel_wear.volume, output.rail_wear[0].volume];
        assert!(wheel > 0.0 && wheel.to_bits() == rail.to_bits(), "{model:?}: {wheel} {rail}");
        if model == WearModel::BritishRail {
            let expected = std::f64::consts::PI * 0.25e-12 * output.wear_number * 20.0 * 1e3;
            assert!(output.wear_number < 100.0);
            assert_relative_eq!(wheel, expected, max_relative = 2e-3);
        }
        // Between the mild rates of the sources: 0.7e-9 to 21e-9 kg/J.
        let rate = wheel * 7850.0 / (1e3 * output.frictional_power);
        assert!((5e-10..5e-8).contains(&rate), "{model:?}: {rate:e} kg/J");
        println!("{model:?}: {rate:e} kg/J");
    }
}

#[test]
fn laws_have_the_names_of_their_variable() {
    let variable = wheelrail::variables::find("wear.model").unwrap();
    let mut values = wheelrail::variables::Values::default();
    for model in [WearModel::Off, WearModel::Usfd, WearModel::BritishRail, WearModel::Archard] {
        values.set_from_text(variable, model.name()).unwrap();
        assert_eq!(values.parameters.wear.model, model);
    }
    let mut p = parameters(WearModel::Archard);
    p.tangential_model = TangentialModel::Linear;
    let refused = Element::new(&p, &Input::default(), &[]).unwrap_err().to_string();
    assert!(refused.starts_with("wear.model = \"archard\""), "{refused}");
}

#[test]
fn forces_do_not_depend_on_recording_and_evaluations_wear_nothing_off() {
    let mut off = element(&Parameters::default());
    let mut on = element(&parameters(WearModel::Usfd));
    let (mut a, mut b) = (Output::default(), Output::default());
    for i in 0..20 {
        let at = input(&off, Side::Right, sway(0.03 * f64::from(i)), 6e-5);
        off.evaluate(&at, &mut a).unwrap();
        on.accumulate(&at, &mut b, 1e-4).unwrap();
        assert!(b.wheel_wear.volume > 0.0);
        let volume = b.wheel_wear.volume;
        for _ in 0..3 {
            on.evaluate(&at, &mut b).unwrap();
        }
        assert_eq!(b.wheel_wear.volume.to_bits(), volume.to_bits());
        (b.wheel_wear, b.rail_wear) = (a.wheel_wear, a.rail_wear);
        assert_eq!(a, b);
    }
    let at = input(&on, Side::Right, 0.0, 6e-5);
    assert!(on.advance(&at, &mut b, -1.0).is_err() && on.advance(&at, &mut b, f64::NAN).is_err());
}

#[test]
fn the_left_side_wears_as_the_right_one_and_a_given_load_as_its_height() {
    let p = parameters(WearModel::FrictionalWork);
    let left = Parameters { side: Side::Left, ..p.clone() };
    let load = Parameters { vertical_mode: VerticalMode::Load, damping: 0.0, ..p.clone() };
    let height = Parameters { damping: 0.0, ..p };
    let mut elements = [&height, &left, &load].map(|p| Box::new(element(p)));
    let mut outputs = [Output::default(); 3];
    for i in 0..12 {
        let shift = sway(0.05 * f64::from(i));
        let mut at = input(&elements[2], Side::Right, shift, 0.0);
        elements[2].evaluate(&at, &mut outputs[2]).unwrap();
        let height = outputs[2].wheel_z;
        elements[2].advance(&at, &mut outputs[2], 1e-3).unwrap();
        at.wheel.position[2] = height;
        elements[0].advance(&at, &mut outputs[0], 1e-3).unwrap();
        let mut mirrored = input(&elements[1], Side::Left, shift, 0.0);
        mirrored.wheel.position[2] = at.wheel.position[2];
        elements[1].advance(&mirrored, &mut outputs[1], 1e-3).unwrap();
    }
    for other in &outputs[1..] {
        assert!(other.wheel_wear.depth > 1e-6);
        let bound = tolerance::WORN_VOLUME;
        assert_relative_eq!(
            other.wheel_wear.volume,
            outputs[0].wheel_wear.volume,
            max_relative = bound
        );
        assert_relative_eq!(
            other.rail_wear[0].depth,
            outputs[0].rail_wear[0].depth,
            max_relative = bound
        );
    }
}

#[test]
fn a_state_taken_back_wears_on_bit_for_bit() {
    let mut p = parameters(WearModel::Zobory);
    p.wear.update_interval = 3e-3;
    p.wear.acceleration_factor = 1e5;
    let mut element = element(&p);
    let mut output = Output::default();
    let mut run = |element: &mut Element, range: std::ops::Range<u32>| -> Vec<Output> {
        range
            .map(|i| {
                let at = input(element, Side::Right, sway(0.02 * f64::from(i)), 7e-5);
                element.advance(&at, &mut output, 1e-3).unwrap();
                output
            })
            .collect()
    };
    run(&mut element, 0..8);
    let (state, fallbacks) = (element.wear_state().unwrap(), element.fallbacks());
    let first = run(&mut element, 8..16);
    assert!(first[7].patch_count > 0 && first[7].wheel_wear.depth > 1e-6);
    assert!(element.set_wear_state(&state));
    element.set_fallbacks(fallbacks);
    assert!(run(&mut element, 8..16) == first);
    // Into another element of the same parameters, and not into one of another profile.
    let mut other = self::element(&p);
    assert!(other.set_wear_state(&state));
    other.set_fallbacks(fallbacks);
    assert!(run(&mut other, 8..16) == first);
    p.wheel.profile = "conical:0.05".into();
    assert!(!self::element(&p).set_wear_state(&state));
    assert!(!self::element(&Parameters::default()).set_wear_state(&state));
}

#[test]
fn fatigue_numbers_of_a_patch_are_those_of_their_formulas() {
    let mut element = element(&Parameters::default());
    let mut at = input(&element, Side::Right, -2e-3, 7e-5);
    // Driven: the creep force on the wheel points forward.
    at.wheel.pitch_rate = -20.6 / 0.46;
    let mut output = Output::default();
    element.evaluate(&at, &mut output).unwrap();
    let patch = &output.patches[0];
    assert!(patch.creep_force[0] > 0.0);
    let wear_number = patch.frictional_power / 20.3;
    assert!(wear_number > 175.0, "{wear_number}");
    let damage = 10e-6 * (175.0 - wear_number) / 110.0;
    assert_relative_eq!(patch.tgamma_damage, damage, max_relative = 0.02);
    let used = patch.creep_force[0].hypot(patch.creep_force[1]) / patch.normal_force;
    let index = used - 2.0 * patch.area * 3e8 / (3.0 * patch.normal_force);
    assert_relative_eq!(patch.surface_fatigue_index, index, max_relative = 1e-12);
}

#[test]
fn worn_is_what_the_forces_dissipate_wherever_height_and_rails_are_found() {
    let vertical = [VerticalMode::Penetration, VerticalMode::Load];
    for (k, foundation) in
        [FoundationModel::Rigid, FoundationModel::Massless].into_iter().enumerate()
    {
        for vertical_mode in vertical {
            let mut p =
                Parameters { vertical_mode, motion: Motion::Rolling, ..Parameters::default() };
            p.wear.model = WearModel::FrictionalWork;
            p.foundation.model = foundation;
            let mut element = element(&p);
            let mut input = input(&element, p.side, 5e-3 * k as f64, 1e-4);
            // Not what it rolls with.
            (input.wheel.velocity[0], input.wheel.pitch_rate) = (30.0, -1.0);
            let mut output = Output::default();
            element.accumulate(&input, &mut output, 1e-2).unwrap();
            let law = p.wear.wheel.frictional_work.coefficient / p.wear.wheel.density;
            let volume = law * output.frictional_power * 1e-2;
            assert!(volume > 0.0);
            assert_relative_eq!(
                output.wheel_wear.volume,
                volume,
                max_relative = tolerance::WORN_VOLUME
            );
        }
    }
}
