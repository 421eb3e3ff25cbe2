//! Does summing up wear dig holes? A wheel that wanders irregularly over a rail and wears in few, long steps, with the wear of each step
//! left where the strips lie, and spread as Piotrowski and Kik (2008, section 6) do it.
//! `cargo run --release --no-default-features --example wear_distribution -- wear_distribution.svg`

mod chart;

use std::error::Error;

use chart::{Chart, Series};
use wheelrail::element::parameters::{VerticalMode, WearDistribution, WearModel};
use wheelrail::element::{Element, Input, Output, Parameters, WornBody};

/// Steps of the run and between updates of the profile.
const STEPS: usize = 200;
const UPDATES: [usize; 2] = [10, 200];
/// Waves longer than this are the shape of the wear, shorter ones its waviness [m].
const SHAPE: f64 = 8e-3;

fn main() -> Result<(), Box<dyn Error>> {
    println!(
        "steps_between_updates,distribution,mean_depth_mm,waviness_um,share_of_mean,force_jump"
    );
    let mut charts = Vec::new();
    for (between, title) in UPDATES
        .into_iter()
        .zip(["A new profile every 10 steps", "One new profile, after 200 steps"])
    {
        let mut series = Vec::new();
        for (distribution, name) in [
            (WearDistribution::Strips, "plain summing"),
            (WearDistribution::Interpenetration, "spread by interpenetration"),
        ] {
            let (depth, jump) = run(distribution, between)?;
            let [mean, waviness] = waviness(&depth);
            println!(
                "{between},{distribution:?},{:.4},{:.2},{:.4},{jump:.4}",
                1e3 * mean,
                1e6 * waviness,
                waviness / mean
            );
            let points = depth.iter().map(|p| p.map(|x| 1e3 * x));
            series
                .push(Series::line(name, points.filter(|p| p[0] > -45.0 && p[0] < 35.0).collect()));
        }
        charts.push(Chart {
            title,
            x: "y on the wheel's profile [mm]",
            y: "wear depth [mm]",
            downwards: true,
            height: 300,
            legend_below: true,
            series,
        });
    }
    std::env::args().nth(1).map_or(Ok(()), |path| chart::save(path, &charts))
}

/// Wear depth over y on the wheel's profile [m] after the run, and the greatest jump of the lateral force at an update over the load.
fn run(
    distribution: WearDistribution,
    between: usize,
) -> Result<(Vec<[f64; 2]>, f64), Box<dyn Error>> {
    let mut parameters = Parameters { vertical_mode: VerticalMode::Load, ..Parameters::default() };
    parameters.wear.model = WearModel::FrictionalWork;
    parameters.wear.distribution = distribution;
    parameters.wear.smoothing = 0.0;
    let mut input = Input { wheel_load: 8e4, ..Input::default() };
    input.wheel.velocity[0] = 20.0;
    input.wheel.yaw = 1e-3;
    let mut element = Element::new(&parameters, &input, &[])?;
    let (mut output, mut jump) = (Output::default(), 0.0f64);
    for step in 0..STEPS {
        // Irregular, and the same on every machine.
        let place = (0.618_034 * step as f64).fract() - 0.5;
        input.wheel.position[1] = 0.75 - 1e-3 + 8e-3 * place;
        input.wheel.pitch_rate = -20.03 / 0.46;
        element.evaluate(&input, &mut output)?;
        // As much material in every step, 0.05 mm² of the section.
        let volume = 0.05e-6 * std::f64::consts::TAU * 0.46;
        let duration = volume * 7850.0 / (1e-9 * output.frictional_power);
        element.accumulate(&input, &mut output, duration)?;
        if (step + 1) % between == 0 {
            let before = output.wheel.force[1];
            element.update_profiles();
            element.evaluate(&input, &mut output)?;
            jump = jump.max((output.wheel.force[1] - before).abs() / input.wheel_load);
        }
    }
    Ok((element.wear_depth(WornBody::Wheel), jump))
}

/// Mean depth where something is worn off, and the root mean square of what waves shorter than [`SHAPE`] add to it [m].
fn waviness(depth: &[[f64; 2]]) -> [f64; 2] {
    let worn: Vec<&[f64; 2]> = depth.iter().filter(|p| p[1] > 0.0).collect();
    let shape = |at: f64| {
        let weight = |y: f64| (-0.5 * ((y - at) / (0.187 * SHAPE)).powi(2)).exp();
        let sum: f64 = depth.iter().map(|p| weight(p[0])).sum();
        depth.iter().map(|p| weight(p[0]) * p[1]).sum::<f64>() / sum
    };
    let mean = worn.iter().map(|p| p[1]).sum::<f64>() / worn.len() as f64;
    let square = worn.iter().map(|p| (p[1] - shape(p[0])).powi(2)).sum::<f64>() / worn.len() as f64;
    [mean, square.sqrt()]
}
