//! How is a measured profile used, and what if its file is wrong?
//! `cargo run --release --no-default-features --example own_profile`

use std::path::PathBuf;

use wheelrail::element::{Element, Input, Output, Parameters};
use wheelrail::error::ContactError;

fn main() -> Result<(), ContactError> {
    // Relative names are looked for in these folders, in order.
    let folders = [PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/fmu/resources/profiles"))];
    let mut parameters = Parameters::default();
    for profile in ["S1002", "S1002_worn.txt"] {
        parameters.wheel.profile = profile.into();
        let mut input = Input::default();
        let mut element = Element::new(&parameters, &input, &folders)?;
        input.wheel.position[2] = element.nominal_wheel_z() + 1e-4;
        let mut output = Output::default();
        element.evaluate(&input, &mut output)?;
        println!(
            "{profile}: touches at z = {:.4} mm; 0.1 mm below {:.1} kN on {} patch(es), the heaviest at {:.1} mm on the wheel",
            1e3 * element.nominal_wheel_z(),
            -1e-3 * output.wheel.force[2],
            output.patch_count,
            1e3 * output.patches[0].wheel_y
        );
    }
    parameters.wheel.profile = "no_such_wheel.prw".into();
    if let Err(error) = Element::new(&parameters, &Input::default(), &folders) {
        println!("refused: {error}");
    }
    Ok(())
}
