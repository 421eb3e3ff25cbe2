//! Does summing up wear dig holes? A wheel that wanders irregularly over a rail and wears in few,
//! long steps, with the wear of each step left where the strips lie, and spread as Piotrowski and
//! Kik (2008, section 6) do it.

use std::error::Error;

use super::chart::{self, Chart, Corner, Series};
use wheelrail::element::parameters::{VerticalMode, WearDistribution, WearModel};
use wheelrail::element::{Element, Input, Output, Parameters, WornBody};

/// Steps of the run and between updates of the profile.
const STEPS: usize = 200;
const UPDATES: [usize; 2] = [10, 200];
/// Waves shorter than this are waviness [m].
const SHORT: f64 = 2e-3;

pub fn draw(arguments: &[String]) -> Result<(), Box<dyn Error>> {
    // As good as a profile that changes all the time.
    let (reference, _) = run(WearDistribution::Interpenetration, 1)?;
    println!("steps_between_updates,distribution,waviness_um,off_the_reference_um,force_jump");
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
            let waviness = 1e6 * short_waves(&depth);
            let off = 1e6 * mean_square(depth.iter().zip(&reference).map(|(a, b)| a[1] - b[1]));
            println!("{between},{distribution:?},{waviness:.2},{off:.2},{jump:.4}");
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
            legend: Corner::LowerLeft,
            legend_room: 0.0,
            series,
        });
    }
    arguments.first().map_or(Ok(()), |path| chart::save(path, &charts))
}

/// Wear depth over y on the wheel's profile [m] after a run, and the greatest jump of the lateral
/// force at an update over the load.
type Worn = (Vec<[f64; 2]>, f64);

/// A run with so many steps between updates.
fn run(distribution: WearDistribution, between: usize) -> Result<Worn, Box<dyn Error>> {
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

/// What waves shorter than [`SHORT`] add to the depth, root mean square over what is worn off [m].
fn short_waves(depth: &[[f64; 2]]) -> f64 {
    let smooth = |at: f64| {
        let weight = |y: f64| (-0.5 * ((y - at) / (0.187 * SHORT)).powi(2)).exp();
        let sum: f64 = depth.iter().map(|p| weight(p[0])).sum();
        depth.iter().map(|p| weight(p[0]) * p[1]).sum::<f64>() / sum
    };
    mean_square(depth.iter().filter(|p| p[1] > 0.0).map(|p| p[1] - smooth(p[0])))
}

/// Root mean square of the values that are not zero.
fn mean_square(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) =
        values.filter(|v| *v != 0.0).fold((0.0, 0.0), |(sum, count), v| (sum + v * v, count + 1.0));
    if count > 0.0 { f64::sqrt(sum / count) } else { 0.0 }
}
