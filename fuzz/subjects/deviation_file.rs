//! A file of corrugation, of an out-of-round wheel or of friction, of any content.

use std::fs;

use wheelrail::element::parameters::FrictionDistribution;
use wheelrail::element::{Element, Input, Parameters};

use super::values::evaluate;

/// The first byte tells the body, the rest is the file.
pub fn check(data: &[u8]) {
    let Some((&first, content)) = data.split_first() else { return };
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("file.csv"), content).expect("a file");
    let mut parameters = Parameters { strips: 8, elements_along: 8, ..Parameters::default() };
    let name = || "file.csv".to_owned();
    let parameter = match first % 3 {
        0 => {
            parameters.rails[0].corrugation.file = name();
            "rail[1].corrugation.file"
        }
        1 => {
            parameters.wheel.out_of_round.file = name();
            "wheel.out_of_round.file"
        }
        _ => {
            parameters.friction_distribution = FrictionDistribution::Profile;
            parameters.friction_profile = name();
            "friction.profile"
        }
    };
    match Element::new(&parameters, &Input::default(), &[folder.path().to_owned()]) {
        Err(refusal) => assert!(refusal.to_string().contains(parameter), "{refusal}"),
        Ok(mut element) => {
            for step in 0..4 {
                let mut input = Input::default();
                input.wheel.position[2] = element.nominal_wheel_z() + 5e-5;
                input.track_s = 0.37 * f64::from(step);
                input.wheel.pitch = 1.9 * f64::from(step);
                input.wheel.velocity[0] = 20.0;
                evaluate(&mut element, &parameters, &input);
            }
        }
    }
}
