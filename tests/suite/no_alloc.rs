//! An evaluation allocates nothing, whatever the wheel does.

use crate::allocations;
use crate::common::wheel::mirrored;
use wheelrail::element::parameters::{
    CreepageModel, Flexibilities, NormalModel, Side, TangentialModel, TractionBound, VerticalMode,
    WearDistribution, WearModel,
};
use wheelrail::element::{Element, Input, Output, Parameters};

/// Height at which a wheel shifted by 5.16 mm is pressed 30 µm into tread and flange root [m].
const TWO_PATCHES_Z: f64 = -0.460_228;

/// A wheel on its way over the rail: lifted, on the tread, on two patches, on the flange.
fn path(step: u32) -> Input {
    let t = f64::from(step);
    let mut input =
        Input { wheel_load: 8e4 * (0.41 * t).sin(), track_s: 0.37 * t, ..Input::default() };
    let wheel = &mut input.wheel;
    wheel.position[1] = 0.75 + 7e-3 * (0.037 * t).sin();
    wheel.position[2] = -0.46 + 3e-4 * (1.0 + (0.41 * t).sin());
    wheel.roll = 4e-3 * (0.11 * t).sin();
    wheel.yaw = 3e-2 * (0.07 * t).cos();
    wheel.velocity = [25.0 * (0.013 * t).cos(), 0.1 * (0.2 * t).sin(), 0.05];
    wheel.pitch_rate = -54.0 * (0.013 * t).cos();
    if step.is_multiple_of(4) {
        // Between tread and flange root: two patches.
        wheel.position[1] = 0.755_16 + 1e-5 * (0.17 * t).sin();
        wheel.position[2] = TWO_PATCHES_Z + 1e-5 * (0.41 * t).sin();
        (wheel.roll, wheel.yaw) = (0.0, 0.0);
        return input;
    }
    input.rails[0].y = 1e-3 * (0.05 * t).sin();
    input.rails[0].roll = 1e-2 * (0.03 * t).sin();
    input.friction = if step.is_multiple_of(50) { 0.0 } else { 0.35 };
    input
}

#[test]
fn the_counter_counts() {
    let before = allocations::count();
    let list = std::hint::black_box(vec![1, 2, 3]);
    assert_eq!(allocations::count(), before + 1);
    drop(list);
}

#[test]
fn a_thousand_evaluations_allocate_nothing_with_any_model() {
    let plain = (CreepageModel::Flat, Flexibilities::Three);
    let variants = [
        (NormalModel::PiotrowskiKik, TangentialModel::Fastsim, plain),
        (
            NormalModel::PiotrowskiKik,
            TangentialModel::Fastsim,
            (CreepageModel::Curved, Flexibilities::Blended),
        ),
        (NormalModel::PiotrowskiKik, TangentialModel::None, plain),
        (NormalModel::PiotrowskiKikCorrected, TangentialModel::Linear, plain),
        (
            NormalModel::PiotrowskiKik,
            TangentialModel::Fastsim,
            (CreepageModel::Kinematic, Flexibilities::Blended),
        ),
        (NormalModel::Hertz, TangentialModel::Fastsim, plain),
        (NormalModel::PiotrowskiKik, TangentialModel::Fastrip, plain),
        (NormalModel::Strips, TangentialModel::Fastsim, plain),
        (NormalModel::PiotrowskiKik, TangentialModel::Tables, plain),
        (
            NormalModel::PiotrowskiKik,
            TangentialModel::FastsimCorrected,
            (CreepageModel::Curved, Flexibilities::Blended),
        ),
        (
            NormalModel::Strips,
            TangentialModel::Marches,
            (CreepageModel::Curved, Flexibilities::Blended),
        ),
    ];
    for (k, (normal_model, tangential_model, (creepage_model, flexibilities))) in
        variants.into_iter().enumerate()
    {
        let parameters = Parameters {
            side: if k == 1 { Side::Left } else { Side::Right },
            normal_model,
            tangential_model,
            creepage_model,
            flexibilities,
            vertical_mode: if k == 4 { VerticalMode::Load } else { VerticalMode::Penetration },
            bound: if k == 1 { TractionBound::Elliptic } else { TractionBound::Parabolic },
            strips: if normal_model == NormalModel::Strips { 9 } else { 30 },
            ..Parameters::default()
        };
        let start = if k == 1 { mirrored(&path(0)) } else { path(0) };
        let mut element = Element::new(&parameters, &start, &[]).unwrap();
        let mut output = Output::default();
        // How often there was no patch, one, and more; how often one on the flange.
        let mut seen = [0; 4];
        let before = allocations::count();
        for step in 0..1000 {
            let input = if k == 1 { mirrored(&path(step)) } else { path(step) };
            element.evaluate(&input, &mut output).unwrap();
            seen[output.patch_count.clamp(0, 2) as usize] += 1;
            seen[3] += usize::from(output.patches[0].contact_angle.abs() > 0.7);
        }
        assert_eq!(allocations::count(), before);
        println!("none, one, several patches, flange: {seen:?}");
        assert!(seen.iter().all(|&n| n >= 20), "the path is too dull: {seen:?}");
    }
}

#[test]
fn uneven_bodies_and_a_second_rail_allocate_nothing_either() {
    for normal_model in [NormalModel::PiotrowskiKik, NormalModel::Hertz] {
        let mut parameters = Parameters { normal_model, ..Parameters::default() };
        parameters.rails[1].enabled = true;
        parameters.rails[0].corrugation.amplitude = 1e-4;
        parameters.wheel.flat.length = 0.05;
        let mut element = Element::new(&parameters, &path(0), &[]).unwrap();
        let mut output = Output::default();
        let mut most = 0;
        let before = allocations::count();
        for step in 0..300 {
            let mut input = path(step);
            input.wheel.pitch = 0.05 * (0.3 * f64::from(step)).sin();
            element.evaluate(&input, &mut output).unwrap();
            most = most.max(output.patch_count);
        }
        assert_eq!(allocations::count(), before);
        assert!(most > 1, "{most} patches at once");
    }
}

#[test]
fn a_step_that_wears_allocates_nothing_before_the_update() {
    for (normal_model, distribution) in [
        (NormalModel::PiotrowskiKik, WearDistribution::Interpenetration),
        (NormalModel::Strips, WearDistribution::Interpenetration),
        (NormalModel::Hertz, WearDistribution::Strips),
    ] {
        let mut parameters = Parameters { normal_model, strips: 9, ..Parameters::default() };
        parameters.wear.model = WearModel::Archard;
        parameters.wear.distribution = distribution;
        parameters.wear.acceleration_factor = 1e4;
        parameters.wear.update_interval = 1e3;
        let mut element = Element::new(&parameters, &path(0), &[]).unwrap();
        let mut output = Output::default();
        let mut state = element.wear_state();
        let before = allocations::count();
        for step in 0..300 {
            element.advance(&path(step), &mut output, 1e-4).unwrap();
            element.copy_wear_state(&mut state);
        }
        assert_eq!(allocations::count(), before);
        assert!(output.wheel_wear.volume > 0.0);
        element.update_profiles();
        let before = allocations::count();
        element.advance(&path(3), &mut output, 1e-4).unwrap();
        assert_eq!(allocations::count(), before);
    }
}

#[test]
fn a_refused_input_leaves_only_its_message_behind() {
    let mut element = Element::new(&Parameters::default(), &path(0), &[]).unwrap();
    let mut output = Output::default();
    let mut input = path(1);
    input.wheel.yaw = f64::NAN;
    assert!(element.evaluate(&input, &mut output).is_err());
    let before = allocations::count();
    element.evaluate(&path(2), &mut output).unwrap();
    assert_eq!(allocations::count(), before);
}
