//! A resilient wheel needs no code: the wheel marker is that of its rim, a body of its own. What a
//! flat does to rail and axle. `cargo run --release --no-default-features --example
//! resilient_wheel`

use wheelrail::element::parameters::{FlatShape, TangentialModel};
use wheelrail::element::{Element, Input, Output, Parameters};
use wheelrail::error::ContactError;

/// Load of the suspension [N], masses of rim and of centre with axle [kg], rubber between them,
/// speed [m/s].
const LOAD: f64 = 60e3;
const RIM: f64 = 120.0;
const CENTRE: f64 = 480.0;
const SPEED: f64 = 15.0;
const STEP: f64 = 1e-5;

fn main() -> Result<(), ContactError> {
    println!("wheel,radial_stiffness_n_per_m,peak_contact_force_kn,peak_axle_acceleration_m_s2");
    // Solid wheels are as stiff as a hundred springs of rubber.
    for (name, stiffness, damping) in [("solid", 1e10, 1e5), ("resilient", 1e8, 4e4)] {
        let [force, acceleration] = roll(stiffness, damping)?;
        println!("{name},{stiffness:.0e},{:.1},{acceleration:.0}", 1e-3 * force);
    }
    Ok(())
}

/// Greatest contact force [N] and acceleration of the axle [m/s²] over a worn flat.
fn roll(stiffness: f64, damping: f64) -> Result<[f64; 2], ContactError> {
    let mut parameters = Parameters::default();
    let flat = &mut parameters.wheel.flat;
    (flat.length, flat.angle, flat.shape) = (0.06, 0.3, FlatShape::Worn);
    parameters.tangential_model = TangentialModel::None;
    let (mut input, mut output) = (Input::default(), Output::default());
    input.wheel.position[1] = 0.747;
    input.wheel.velocity[0] = SPEED;
    input.wheel.pitch_rate = -SPEED / 0.46;
    let mut element = Element::new(&parameters, &input, &[])?;
    // The rim at rest under both weights, the centre hanging on the rubber above it.
    let [rim_weight, weight] = [9.81 * RIM, LOAD + 9.81 * CENTRE];
    let (mut low, mut high) = (element.nominal_wheel_z(), -0.459);
    for _ in 0..60 {
        input.wheel.position[2] = 0.5 * (low + high);
        element.evaluate(&input, &mut output)?;
        let carried = -output.wheel.force[2] >= rim_weight + weight;
        *(if carried { &mut high } else { &mut low }) = input.wheel.position[2];
    }
    let mut centre = [input.wheel.position[2] + weight / stiffness, 0.0];
    let (mut peak, mut shock) = (0f64, 0f64);
    while input.wheel.position[0] < 0.4 {
        let rim = &mut input.wheel;
        rim.pitch = -rim.position[0] / 0.46;
        element.evaluate(&input, &mut output)?;
        let rim = &mut input.wheel;
        let rubber =
            stiffness * (centre[0] - rim.position[2]) + damping * (centre[1] - rim.velocity[2]);
        let acceleration = (weight - rubber) / CENTRE;
        (peak, shock) = (peak.max(-output.wheel.force[2]), shock.max(acceleration.abs()));
        centre[1] += STEP * acceleration;
        centre[0] += STEP * centre[1];
        rim.velocity[2] += STEP * (rim_weight + rubber + output.wheel.force[2]) / RIM;
        rim.position[2] += STEP * rim.velocity[2];
        rim.position[0] += STEP * SPEED;
    }
    Ok([peak, shock])
}
