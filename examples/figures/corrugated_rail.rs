//! Lateral creep force of pure spin on a corrugated rail: the example of Piotrowski and Kik (2008),
//! figure 27.

use std::error::Error;

use super::chart::{self, Chart, Corner, Series};
use wheelrail::element::{Element, Input, Output, Parameters};

const LOAD: f64 = 50e3;
const SPEED: f64 = 20.0;
const WAVELENGTH: f64 = 0.033;

pub fn draw(arguments: &[String]) -> Result<(), Box<dyn Error>> {
    let (mut forces, mut lengths) = (Vec::new(), Vec::new());
    println!("amplitude_mm,position_mm,lateral_force_kn,patches,length_mm,area_mm2,ahead_mm,fx_kn");
    for amplitude in [0.0, 2e-5, 4e-5, 6e-5] {
        let (mut force, mut length) = (Vec::new(), Vec::new());
        let mut parameters = Parameters::default();
        // A cone of 0.1 rad on a rail that leans as much: a spin of 0.2 1/m on a radius of 0.5 m.
        parameters.wheel.profile = "conical:0.1".into();
        parameters.wheel.nominal_radius = 0.5;
        // Quasi-static, as in the paper.
        parameters.damping = 0.0;
        parameters.rails[0].profile = "arc:0.3".into();
        parameters.rails[0].inclination = 0.1;
        let corrugation = &mut parameters.rails[0].corrugation;
        (corrugation.amplitude, corrugation.wavelength) = (amplitude, WAVELENGTH);
        let mut start = Input { friction: 0.4, ..Input::default() };
        start.wheel.position[1] = 0.7525;
        let mut element = Element::new(&parameters, &start, &[])?;
        for step in 0..=100 {
            let mut input = start;
            input.track_s = WAVELENGTH / 100.0 * f64::from(step);
            input.wheel.velocity[0] = SPEED;
            input.wheel.pitch_rate = -SPEED / 0.5;
            let mut output = Output::default();
            // What is left of creepage at the patch is taken out by the motion of the wheel.
            for _ in 0..2 {
                press(&mut element, &mut input, &mut output)?;
                let load: f64 = output.patches.iter().map(|p| p.normal_force).sum();
                let mean = |k: usize| {
                    let sum =
                        |p: &wheelrail::element::output::Patch| p.normal_force * p.creepage[k];
                    output.patches.iter().map(sum).sum::<f64>() / load
                };
                input.wheel.pitch_rate *= 1.0 + mean(0);
                input.wheel.velocity[1] -= mean(1) * SPEED;
            }
            let patches = || output.patches();
            let lateral: f64 = patches().map(|p| p.creep_force[1]).sum();
            let total: f64 = patches().map(|p| p.length).sum();
            println!(
                "{:.2},{:.2},{:.4},{},{:.3},{:.2},{:.3},{:.4}",
                1e3 * amplitude,
                1e3 * input.track_s,
                1e-3 * lateral,
                output.patch_count,
                1e3 * total,
                1e6 * patches().map(|p| p.area).sum::<f64>(),
                1e3 * patches().map(|p| p.position[0] * p.normal_force).sum::<f64>() / LOAD,
                1e-3 * output.wheel.force[0],
            );
            force.push([1e3 * input.track_s, 1e-3 * lateral]);
            length.push([1e3 * input.track_s, 1e3 * total]);
        }
        let name =
            if amplitude > 0.0 { format!("{:.2} mm", 1e3 * amplitude) } else { "even rail".into() };
        forces.push(Series::line(&name, force));
        lengths.push(Series::line(&name, length));
    }
    if let Some(path) = arguments.first() {
        let x = "station of the axle [mm], crest at 0";
        let chart = |title, y, series| Chart {
            title,
            x,
            y,
            downwards: false,
            legend: Corner::UpperRight,
            legend_room: 0.0,
            height: 300,
            series,
        };
        let first = chart(
            "Pure spin of 0.0002 1/mm under 50 kN, wavelength 33 mm",
            "lateral creep force [kN]",
            forces,
        );
        let second =
            chart("Length of the contact along the rail, gaps left out", "length [mm]", lengths);
        chart::save(path, &[first, second])?;
    }
    Ok(())
}

/// Finds the height at which the normal forces sum to the load, by bisection.
fn press(
    element: &mut Element,
    input: &mut Input,
    output: &mut Output,
) -> Result<(), Box<dyn Error>> {
    let (mut low, mut high) = (element.nominal_wheel_z() - 1e-4, element.nominal_wheel_z() + 4e-4);
    for _ in 0..36 {
        input.wheel.position[2] = 0.5 * (low + high);
        element.evaluate(input, output)?;
        let load: f64 = output.patches.iter().map(|p| p.normal_force).sum();
        let bound = if load < LOAD { &mut low } else { &mut high };
        *bound = input.wheel.position[2];
    }
    Ok(())
}
