//! Impact of wheel flats at different speeds: a wheel under its suspension on a rail that gives
//! way, rolling over a flat.

use std::error::Error;

use super::chart::{self, Chart, Corner, Series};
use wheelrail::element::parameters::{FlatShape, TangentialModel};
use wheelrail::element::{Element, Input, Output, Parameters};

/// Load of the suspension [N], masses of wheel and rail [kg], stiffness and damping under the rail
/// [N/m, N s/m].
const LOAD: f64 = 80e3;
const WHEEL_MASS: f64 = 700.0;
const RAIL_MASS: f64 = 100.0;
const TRACK_STIFFNESS: f64 = 8e7;
const TRACK_DAMPING: f64 = 1.2e5;
/// Length of the flat [m] and its place on the wheel [rad].
const LENGTH: f64 = 0.05;
const ANGLE: f64 = 0.26;
const STEP: f64 = 2e-5;

pub fn draw(arguments: &[String]) -> Result<(), Box<dyn Error>> {
    let mut impacts = Vec::new();
    let mut histories = Vec::new();
    println!("shape,length_mm,speed_km_h,peak_kn,least_kn");
    for (shape, name) in [(FlatShape::Fresh, "fresh"), (FlatShape::Worn, "worn")] {
        let mut parameters = Parameters::default();
        (parameters.wheel.flat.length, parameters.wheel.flat.angle) = (LENGTH, ANGLE);
        parameters.wheel.flat.shape = shape;
        parameters.tangential_model = TangentialModel::None;
        let mut peaks = Vec::new();
        for speed in (10..=160).step_by(10).map(f64::from) {
            let history = roll(&parameters, speed / 3.6)?;
            let force = history.iter().map(|p| p[1]);
            let (least, peak) =
                force.fold((f64::MAX, 0f64), |(least, most), f| (least.min(f), most.max(f)));
            println!("{name},{},{speed},{peak:.1},{least:.1}", 1e3 * LENGTH);
            peaks.push([speed, peak]);
            if [20.0, 100.0].contains(&speed) && shape == FlatShape::Fresh {
                histories.push(Series::line(format!("{name}, {speed} km/h"), history));
            }
        }
        impacts.push(Series::line(name, peaks));
    }
    if let Some(path) = arguments.first() {
        let chart = |title, x, legend, series| Chart {
            title,
            x,
            y: "contact force [kN]",
            downwards: false,
            legend,
            legend_room: 0.0,
            height: 300,
            series,
        };
        let title = "Greatest force on a flat of 50 mm, static load 87 kN";
        let first = chart(title, "speed [km/h]", Corner::LowerRight, impacts);
        let title = "Force around the flat";
        let second = chart(
            title,
            "rolled distance from the middle of the flat [mm]",
            Corner::UpperRight,
            histories,
        );
        chart::save(path, &[first, second])?;
    }
    Ok(())
}

/// Contact force [kN] over the rolled distance from the flat [mm] at `speed` [m/s], from static
/// equilibrium before the flat.
fn roll(parameters: &Parameters, speed: f64) -> Result<Vec<[f64; 2]>, Box<dyn Error>> {
    let mut input = Input::default();
    let mut output = Output::default();
    // The wheel is shifted to where one patch lies on the tread.
    input.wheel.position[1] = 0.747;
    input.wheel.velocity[0] = speed;
    input.wheel.pitch_rate = -speed / 0.46;
    let mut element = Element::new(parameters, &input, &[])?;
    let weight = LOAD + 9.81 * WHEEL_MASS;
    input.rails[0].z = weight / TRACK_STIFFNESS;
    let (mut low, mut high) = (element.touching_height(&input), -0.455);
    for _ in 0..60 {
        input.wheel.position[2] = 0.5 * (low + high);
        element.evaluate(&input, &mut output)?;
        let bound = if -output.wheel.force[2] < weight { &mut low } else { &mut high };
        *bound = input.wheel.position[2];
    }
    let mut history = Vec::new();
    while input.wheel.position[0] < 0.5 {
        input.wheel.pitch = -input.wheel.position[0] / 0.46;
        element.evaluate(&input, &mut output)?;
        let contact = -output.wheel.force[2];
        let rail = &mut input.rails[0];
        let support = TRACK_STIFFNESS * rail.z + TRACK_DAMPING * rail.vz;
        rail.vz += STEP * (contact - support) / RAIL_MASS;
        rail.z += STEP * rail.vz;
        input.wheel.velocity[2] += STEP * (weight - contact) / WHEEL_MASS;
        input.wheel.position[2] += STEP * input.wheel.velocity[2];
        input.wheel.position[0] += STEP * speed;
        history.push([1e3 * (input.wheel.position[0] - ANGLE * 0.46), 1e-3 * contact]);
    }
    Ok(history)
}
