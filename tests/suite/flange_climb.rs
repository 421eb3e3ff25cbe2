//! Nadal's limit of flange climb: the ratio of guiding force to wheel load of a flange that slides
//! down the rail.

use crate::common::wheel::{element, evaluate, pressed, rolling, the_patch};
use crate::tolerance;
use approx::assert_relative_eq;
use wheelrail::element::parameters::CreepageModel;
use wheelrail::element::{Element, Input, Parameters};

/// A wheel `shift` [m] beside the middle that rolls on its flange alone, without longitudinal
/// creepage, and slides down with it.
fn sliding(element: &mut Element, shift: f64, friction: f64) -> Input {
    let input = Input { friction, ..rolling(shift, 1.0) };
    let mut input = pressed(element, &input, 5e-5);
    let patch = the_patch(&evaluate(element, &input));
    let (sine, cosine) = patch.contact_angle.sin_cos();
    // Far more than what spin, 2 a metre over a patch of millimetres, makes of it.
    let slide = 0.5;
    input.wheel.pitch_rate = -1.0 / patch.rolling_radius;
    input.wheel.velocity[1] = -slide * cosine;
    input.wheel.velocity[2] = -slide * sine;
    input
}

/// Guiding force over wheel load.
fn ratio(element: &mut Element, input: &Input) -> f64 {
    let [_, y, z] = evaluate(element, input).wheel.force;
    y / z
}

#[test]
fn a_flange_that_slides_down_has_nadals_ratio() {
    for creepage_model in [CreepageModel::Flat, CreepageModel::Curved] {
        let mut element = element(&Parameters { creepage_model, ..Parameters::default() });
        // Contact angles of 70.0, 68.8 and 65.3 degrees.
        for shift in [7.5e-3, 8.2e-3, 9e-3] {
            for friction in [0.2, 0.3, 0.4] {
                let input = sliding(&mut element, shift, friction);
                let found = ratio(&mut element, &input);
                let angle = the_patch(&evaluate(&mut element, &input)).contact_angle;
                let lean = -angle.tan();
                let nadal = (lean - friction) / (1.0 + friction * lean);
                println!("{:.2} degrees, friction {friction}: {found:.4}", -angle.to_degrees());
                assert_relative_eq!(found, nadal, max_relative = tolerance::FULL_SLIDING);
                // Friction that is spent along the track does not hold the flange up.
                let mut braked = input;
                braked.wheel.pitch_rate *= 0.5;
                assert!(ratio(&mut element, &braked) > found + 0.05, "{shift} {friction}");
            }
        }
    }
}
