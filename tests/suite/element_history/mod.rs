//! Wheels whose contacts remember: `tangential.history` = transient in the element and the units.

mod energy;
mod fields;
mod units;
mod wheel;

use wheelrail::element::parameters::{NormalModel, TangentialHistory, TangentialModel};
use wheelrail::element::{ContactHistory, Element, Input, Output, Parameters};

use crate::common::wheel::{element, pressed};

/// Boundary elements, so many along and across a contact, of steady rolling.
fn boundary(elements: usize) -> Parameters {
    Parameters {
        normal_model: NormalModel::BoundaryElement,
        tangential_model: TangentialModel::BoundaryElement,
        normal_elements: [elements; 2],
        ..Parameters::default()
    }
}

/// The same with a history.
fn transient(parameters: &Parameters) -> Parameters {
    Parameters { tangential_history: TangentialHistory::Transient, ..parameters.clone() }
}

/// A wheel that rolls at 20 m/s, shifted and yawed, `depth` below first touch, with a pitch rate
/// that much faster than that of free rolling.
fn rolling(parameters: &Parameters, shift: f64, yaw: f64, depth: f64, faster: f64) -> Input {
    let mut input = Input::default();
    input.wheel.position[1] += shift;
    input.wheel.yaw = yaw;
    input.wheel.velocity[0] = 20.0;
    input.wheel.pitch_rate = -20.0 / 0.46 * (1.0 + faster);
    pressed(&mut element(parameters), &input, depth)
}

fn advance(element: &mut Element, input: &Input, duration: f64) -> Output {
    let mut output = Output::default();
    element.advance(input, &mut output, duration).unwrap();
    output
}

/// Friction limit of all patches [N].
fn limit(output: &Output) -> f64 {
    output.patches().map(|p| p.friction_coefficient * p.normal_force).sum()
}

/// Greatest difference of a force on the wheel over the friction limit.
fn difference(a: &Output, b: &Output) -> f64 {
    let forces = a.wheel.force.into_iter().zip(b.wheel.force);
    forces.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / limit(b)
}

/// All numbers of an output, to the bit.
fn bits(output: &Output) -> String {
    // The shortest digits that are read back as the same number.
    format!("{output:?}")
}

/// An element whose contacts begin without tractions.
fn fresh(parameters: &Parameters) -> Element {
    let mut element = element(parameters);
    assert!(element.set_contact_history(&ContactHistory::without_tractions()));
    element
}
