//! What forces act on a wheel pressed onto the rail? `cargo
//! run --release --no-default-features --example single_wheel`

use wheelrail::element::{Element, Input, Output, Parameters};
use wheelrail::error::ContactError;

fn main() -> Result<(), ContactError> {
    let parameters = Parameters::default();
    let mut input = Input::default();
    // A right wheel 5 mm towards the gauge face, yawed by 2 mrad.
    input.wheel.position[1] = 0.755;
    input.wheel.yaw = 2e-3;
    let mut element = Element::new(&parameters, &input, &[])?;

    // Rolling forward at 20 m/s, 0.1 mm below the height at which it just touches there.
    input.wheel.position[2] = element.nominal_wheel_z() + 1e-4;
    input.wheel.velocity[0] = 20.0;
    input.wheel.pitch_rate = -20.0 / parameters.wheel.nominal_radius;
    let mut output = Output::default();
    element.evaluate(&input, &mut output)?;

    let [x, y, z] = output.wheel.force.map(|force| 1e-3 * force);
    println!("force on the wheel: x {x:.2} kN, y {y:.2} kN, z {z:.2} kN (down)");
    for patch in output.patches() {
        println!(
            "patch at y = {:.1} mm: N = {:.2} kN, p_max = {:.0} MPa, angle {:.2} deg, creepage {:.5} {:.5} {:.3} 1/m, slip {:.0} %",
            1e3 * patch.position[1],
            1e-3 * patch.normal_force,
            1e-6 * patch.max_pressure,
            patch.contact_angle.to_degrees(),
            patch.creepage[0],
            patch.creepage[1],
            patch.creepage[2],
            1e2 * patch.slip_share
        );
    }
    Ok(())
}
