//! Wear of wheel and rail alongside the dynamics.

mod common;
mod tolerance;

use approx::assert_relative_eq;
use wheelrail::element::parameters::{
    CreepageModel, NormalModel, Side, TangentialModel, VerticalMode, WearDistribution, WearModel,
};
use wheelrail::element::{Element, Input, Output, Parameters, WornBody};

/// A wheel at 20 m/s with a little yaw and shift, 70 µm deep.
fn input(element: &Element, side: Side, shift: f64, depth: f64) -> Input {
    let mut input = Input::default();
    let sign = if side == Side::Left { -1.0 } else { 1.0 };
    input.wheel.position[1] = sign * (0.75 + shift);
    input.wheel.position[2] = element.nominal_wheel_z() + depth;
    input.wheel.yaw = 2e-3;
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

/// Lateral sway over the contact's whole range on the tread.
fn sway(time: f64) -> f64 {
    -2e-3 + 2.5e-3 * (std::f64::consts::TAU * 1.7 * time).sin()
}

#[test]
fn worn_volume_is_the_integral_of_the_law() {
    for normal in [NormalModel::PiotrowskiKik, NormalModel::Strips, NormalModel::Hertz] {
        for distribution in [WearDistribution::Interpenetration, WearDistribution::Strips] {
            for creepage in [CreepageModel::Flat, CreepageModel::Curved] {
                let mut p = parameters(WearModel::FrictionalWork);
                (p.normal_model, p.creepage_model, p.strips) = (normal, creepage, 15);
                p.wear.distribution = distribution;
                p.wear.wheel.frictional_work.coefficient = 2e-9;
                let mut element = Element::new(&p, &Input::default(), &[]).unwrap();
                let mut output = Output::default();
                let (mut work, h) = (0.0, 1e-3);
                for step in 0..100 {
                    let at = input(&element, Side::Right, sway(f64::from(step) * h), 7e-5);
                    // The power before the step; an update leaves that of the new profile.
                    element.evaluate(&at, &mut output).unwrap();
                    work += output.frictional_power * h;
                    element.advance(&at, &mut output, h).unwrap();
                }
                let expected = 1e6 * 2e-9 * work / 7850.0;
                assert!(expected > 0.0);
                assert_relative_eq!(output.wheel_wear.volume, expected, max_relative = 1e-6);
                assert_relative_eq!(
                    output.rail_wear[0].volume,
                    0.5 * expected,
                    max_relative = 1e-6
                );
                println!(
                    "{normal:?} {distribution:?} {:?} {:?}",
                    output.wheel_wear, output.rail_wear[0]
                );
            }
        }
    }
}
