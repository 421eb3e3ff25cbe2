//! Does it matter that contact patches are curved? A free wheelset behind a lateral ramp of 5 mm
//! (Piotrowski and Kik 2008, section 5). Arguments: figure, distance [m].

use std::error::Error;

use super::chart::{self, Chart, Corner, Series};
use super::free_wheelset::{FreeWheelset, SPEED};
use wheelrail::conicity::{RollingRadiusDifference, TrackedWheelset};
use wheelrail::element::Parameters;
use wheelrail::element::parameters::{CreepageModel, NormalModel, TangentialModel};

/// Time step [s], ramp [m] from 1 to 2 m, radii of the arcs of wheel and rail [m].
const STEP: f64 = 1e-3;
const RAMP: f64 = 5e-3;
const ARCS: [f64; 2] = [0.5, 0.3];

pub fn draw(arguments: &[String]) -> Result<(), Box<dyn Error>> {
    let figure = arguments.first();
    let length: f64 = arguments.get(1).map_or(Ok(40.0), |text| text.parse())?;
    let real = paper();
    let radii = TrackedWheelset::new(&real, 1.5, &[])?.sweep(1e-4, 5e-6);
    let conicity = RollingRadiusDifference::of(&radii).and_then(|d| d.equivalent_conicity(5e-5));
    let conicity = conicity.ok_or("no conicity")?;
    // The contact angle of the arcs, and where the rails stand so that they have it.
    let angle = (conicity * (ARCS[0] - ARCS[1]) / ARCS[0]).atan();
    let gauge = 2.0 * (0.75 - (ARCS[0] - ARCS[1]) * angle.sin() - 0.035);
    eprintln!("tan γe {conicity:.4}; arcs: contact angle {angle:.4} rad, gauge {gauge:.4} m");
    let mut cone = pair(&format!("conical:{conicity}"), "arc:0.3");
    cone.rails[0].inclination = conicity;
    let arcs = Parameters { gauge, ..pair("arc:0.5", "arc:0.3") };
    let titles = ["Cone on arc", "Arc on arc", "S1002 on 60E1"];
    let mut charts = Vec::new();
    println!("pair,creepage,wavelength_m,decay_per_wave,heat_j");
    for (title, pair) in titles.into_iter().zip([cone, arcs, real]) {
        let mut series = Vec::new();
        for model in [CreepageModel::Kinematic, CreepageModel::Flat, CreepageModel::Curved] {
            let (points, heat) = run(&pair, model, length)?;
            let [wave, decay] = oscillation(&points);
            println!("{title},{model:?},{wave:.2},{decay:.3},{heat:.2}");
            series.push(Series::line(format!("{model:?}").to_lowercase(), points));
        }
        let (x, y) = ("distance [m]", "lateral displacement [mm]");
        charts.push(Chart {
            title,
            x,
            y,
            downwards: false,
            height: 260,
            legend: Corner::UpperRight,
            legend_room: 0.0,
            series,
        });
    }
    figure.map_or(Ok(()), |path| chart::save(path, &charts))
}

/// The models of the paper.
fn paper() -> Parameters {
    Parameters {
        normal_model: NormalModel::PiotrowskiKik,
        tangential_model: TangentialModel::Fastsim,
        strips: 12,
        ..Parameters::default()
    }
}

fn pair(wheel: &str, rail: &str) -> Parameters {
    let mut parameters = paper();
    (parameters.wheel.profile, parameters.rails[0].profile) = (wheel.into(), rail.into());
    parameters.rails[0].inclination = 0.0;
    parameters
}

/// Distances [m] and lateral displacements [mm], and the heat turned out behind the ramp [J].
type Run = (Vec<[f64; 2]>, f64);

/// A run behind the ramp.
fn run(pair: &Parameters, model: CreepageModel, length: f64) -> Result<Run, Box<dyn Error>> {
    let mut wheelset = FreeWheelset::new(pair, model)?;
    let mut state = wheelset.start()?;
    let (mut points, mut heat) = (Vec::new(), 0.0);
    for step in 0..(length / (SPEED * STEP)) as usize {
        let distance = step as f64 * SPEED * STEP;
        wheelset.rail_y = RAMP * (distance - 1.0).clamp(0.0, 1.0);
        if step % 5 == 0 {
            points.push([distance, 1e3 * state[0]]);
        }
        wheelset.advance(&mut state, STEP)?;
        heat += if distance > 2.0 { wheelset.power * STEP } else { 0.0 };
    }
    Ok((points, heat))
}

/// Wavelength [m] and how much smaller each wave is than the one before, from the turning points
/// behind the ramp.
fn oscillation(points: &[[f64; 2]]) -> [f64; 2] {
    let behind = points.iter().position(|p| p[0] > 2.0).unwrap_or(points.len());
    let turning =
        points[behind..].windows(3).filter(|p| (p[1][1] - p[0][1]) * (p[2][1] - p[1][1]) < 0.0);
    let turning: Vec<[f64; 2]> = turning.map(|p| [p[1][0], (p[1][1] - 1e3 * RAMP).abs()]).collect();
    let [Some(first), Some(last)] = [turning.first(), turning.last()] else { return [0.0; 2] };
    let waves = 0.5 * (turning.len() - 1) as f64;
    [(last[0] - first[0]) / waves, 1.0 - (last[1] / first[1]).powf(1.0 / waves)]
}
