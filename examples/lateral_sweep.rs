//! Where does a wheel touch as it moves sideways? CSV on standard output.
//! `cargo run --release --no-default-features --example lateral_sweep > sweep.csv`

use wheelrail::element::{Element, Input, Output, Parameters};
use wheelrail::error::ContactError;

/// Wheel load at every position [N].
const LOAD: f64 = 80e3;

fn main() -> Result<(), ContactError> {
    let mut input = Input::default();
    let mut output = Output::default();
    let mut element = Element::new(&Parameters::default(), &input, &[])?;
    println!("shift_mm,wheel_z_mm,patch,wheel_y_mm,rail_y_mm,rolling_radius_mm,angle_deg,load_kn");
    for step in -80..=80 {
        let shift = 1e-4 * f64::from(step);
        input.wheel.position[1] = 0.75 + shift;
        press(&mut element, &mut input, &mut output)?;
        for (number, patch) in output.patches.iter().enumerate().filter(|(_, p)| p.rail > 0) {
            println!(
                "{:.1},{:.4},{},{:.3},{:.3},{:.4},{:.3},{:.3}",
                1e3 * shift,
                1e3 * input.wheel.position[2],
                number + 1,
                1e3 * patch.wheel_y,
                1e3 * patch.rail_y,
                1e3 * patch.rolling_radius,
                patch.contact_angle.to_degrees(),
                1e-3 * patch.normal_force
            );
        }
    }
    Ok(())
}

/// Finds the height at which the wheel carries the load, by bisection.
fn press(
    element: &mut Element,
    input: &mut Input,
    output: &mut Output,
) -> Result<(), ContactError> {
    let touching = element.touching_height(input);
    let (mut low, mut high) = (touching, touching + 5e-4);
    for _ in 0..50 {
        input.wheel.position[2] = 0.5 * (low + high);
        element.evaluate(input, output)?;
        // Down is positive: the force on the wheel is negative.
        let bound = if -output.wheel.force[2] < LOAD { &mut low } else { &mut high };
        *bound = input.wheel.position[2];
    }
    Ok(())
}
