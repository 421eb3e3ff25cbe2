//! A profile file of any content: refused with the parameter's name, or a profile on which a wheel
//! rolls.

use std::fs;

use arbitrary::Unstructured;
use wheelrail::element::{Element, Input, Parameters};

use super::values::evaluate;

const EXTENSIONS: [&str; 6] = ["txt", "csv", "prw", "prr", "whl", "ban"];

/// The first byte tells extension and body, the rest is the file.
pub fn check(data: &[u8]) {
    let Some((&first, content)) = data.split_first() else { return };
    let extension = EXTENSIONS[usize::from(first % 6)];
    let is_wheel = (first / 6) % 2 == 0;
    let smoothing = if first / 12 % 2 == 0 { 0.0 } else { 0.004 };
    let folder = tempfile::tempdir().expect("a folder");
    let name = format!("profile.{extension}");
    fs::write(folder.path().join(&name), content).expect("a file");
    let mut parameters = Parameters { profile_smoothing: smoothing, ..Parameters::default() };
    let parameter = if is_wheel {
        parameters.wheel.profile = name;
        "wheel.profile"
    } else {
        parameters.rails[0].profile = name;
        "rail[1].profile"
    };
    let start = Input::default();
    match Element::new(&parameters, &start, &[folder.path().to_owned()]) {
        Err(refusal) => {
            let text = refusal.to_string();
            let named = [parameter, "wheel.nominal_radius", "track.gauge", "rail[1].inclination"];
            assert!(named.iter().any(|name| text.contains(name)), "{text}");
        }
        Ok(mut element) => roll(&mut element, &parameters, content),
    }
}

fn roll(element: &mut Element, parameters: &Parameters, content: &[u8]) {
    let mut u = Unstructured::new(content);
    let touching = element.nominal_wheel_z();
    assert!(touching.is_finite());
    for step in 0..12 {
        let mut input = super::values::input(&mut u).unwrap_or_default();
        if step < 8 {
            input = Input::default();
            input.wheel.position[1] += 2e-3 * f64::from(step - 4);
            input.wheel.position[2] = touching + 5e-5;
            input.wheel.velocity[0] = 20.0;
            input.wheel.pitch_rate = -43.0;
        }
        evaluate(element, parameters, &input);
    }
}
