//! Impact of a wheel at a crossing: from a wing rail that leads off to a nose that rises, at three
//! speeds, beside the formula for a dip. The rails are left as files in the folder of the figure.

use std::error::Error;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use super::chart::{self, Chart, Corner, Series};
use wheelrail::element::parameters::{Placement, TangentialModel, VerticalMode};
use wheelrail::element::{Element, Input, Output, Parameters};

/// Load of the suspension [N], masses of wheel and crossing [kg], stiffness and damping under the
/// crossing [N/m, N s/m].
const LOAD: f64 = 80e3;
const WHEEL_MASS: f64 = 700.0;
const CROSSING_MASS: f64 = 150.0;
const TRACK_STIFFNESS: f64 = 8e7;
const TRACK_DAMPING: f64 = 1.2e5;
const STEP: f64 = 2e-5;
/// Steps between two points that are kept.
const KEPT: usize = 4;
/// Where the run begins and ends, and from where forces count [m].
const STRETCH: [f64; 3] = [-0.5, 0.7, -0.1];

pub fn draw(arguments: &[String]) -> Result<(), Box<dyn Error>> {
    let asked = arguments.first().map(PathBuf::from);
    let scratch = std::env::temp_dir().join("wheelrail-crossing");
    let folder = asked.clone().unwrap_or(scratch);
    fs::create_dir_all(&folder)?;
    write_rails(&folder)?;

    let rolled = roll_slowly(&folder)?;
    let [angle, stiffness, at] = dip(&rolled);
    eprintln!(
        "dip of {:.1} mrad at {:.0} mm, contact stiffness {stiffness:.2e} N/m",
        1e3 * angle,
        1e3 * at
    );
    println!("speed_km_h,peak_kn,formula_kn");
    let mut forces = Vec::new();
    for speed in [20.0, 60.0, 100.0_f64] {
        let history = roll(&folder, speed / 3.6)?;
        let counted = history.iter().filter(|p| p[0] > 1e3 * STRETCH[2]);
        let peak = counted.map(|p| p[1]).fold(0.0, f64::max);
        let formula = 1e-3 * first_peak(angle, stiffness, speed / 3.6);
        println!("{speed},{peak:.1},{formula:.1}");
        forces.push(Series::line(format!("{speed} km/h, formula {formula:.0} kN"), history));
    }
    if asked.is_some() {
        save(&folder.join("crossing.svg"), &rolled, forces)?;
    }
    Ok(())
}

/// Top of a rail across [mm]: a crown of radius 300 mm with corners of 13 mm, from `left` to
/// `right` at height `z` in its middle.
fn section(left: f64, right: f64, z: f64) -> String {
    const CORNER: f64 = 13.0;
    const CROWN: f64 = 300.0;
    let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
    // Where crown and corner have the same tangent, and where the corner has fallen to 80 degrees.
    let steepest = 80_f64.to_radians();
    let reach = half - CORNER * steepest.sin();
    let joint = (reach / (CROWN - CORNER)).asin();
    let mut side = Vec::new();
    for i in 0..=30 {
        let angle = joint * f64::from(i) / 30.0;
        side.push([CROWN * angle.sin(), CROWN * (1.0 - angle.cos())]);
    }
    let centre = [(CROWN - CORNER) * joint.sin(), CROWN - (CROWN - CORNER) * joint.cos()];
    for i in 1..=40 {
        let angle = joint + (steepest - joint) * f64::from(i) / 40.0;
        side.push([centre[0] + CORNER * angle.sin(), centre[1] - CORNER * angle.cos()]);
    }
    let [y, low] = side[side.len() - 1];
    side.extend((1..=20).map(|i| {
        let along = f64::from(i);
        [y + along * steepest.cos(), low + along * steepest.sin()]
    }));
    let mirrored = side.iter().skip(1).rev().map(|[y, z]| [-y, *z]);
    mirrored.chain(side.iter().copied()).fold(
        String::from("# mirror_z 0\n"),
        |mut text, [y, dz]| {
            let _ = writeln!(text, "{:.6} {:.6}", middle + y, z + dz);
            text
        },
    )
}

/// Writes `wing.slcs` and `nose.slcs`: places along the track and y from the gauge face, in mm.
fn write_rails(folder: &Path) -> std::io::Result<()> {
    let list = |name: &str, places: &[f64], section: &dyn Fn(f64) -> String| {
        let mut slices = String::new();
        for place in places {
            let file = format!("{name}_{place}.txt");
            fs::write(folder.join(&file), section(*place))?;
            let _ = writeln!(slices, "{place} '{file}'");
        }
        let text = format!("0 1 % places in mm\n{}\n0 0 0\n1\n{slices}", places.len());
        fs::write(folder.join(format!("{name}.slcs")), text)
    };
    // The wing leads off to the field side from the knee on, at 1:9.
    let knee: Vec<f64> = [-1000.0, -600.0, -450.0]
        .into_iter()
        .chain((-30..=100).map(|i| 10.0 * f64::from(i)))
        .collect();
    let led_off = |place: f64| {
        let behind = place + 250.0;
        // Rounded over 100 mm.
        if behind < -50.0 {
            0.0
        } else if behind > 50.0 {
            behind / 9.0
        } else {
            (behind + 50.0).powi(2) / 1800.0
        }
    };
    list("wing", &knee, &|place| section(led_off(place), 72.0 + led_off(place), 0.0))?;
    // The nose grows wider at 1:9 from the gauge face on, and rises at 1:60 until it is as high as
    // the wing was.
    let places: Vec<f64> = (0..=100).map(|i| 10.0 * f64::from(i)).collect();
    list("nose", &places, &|place| {
        let below = (300.0 - place) / 60.0;
        let rounded = if below > 0.5 {
            below
        } else if below < -0.5 {
            0.0
        } else {
            0.5 * (below + 0.5).powi(2)
        };
        section(0.0, 28.0 + (place / 9.0).min(44.0), rounded)
    })
}

/// The wheel over both rails, with the gauge face at half the gauge.
fn element(folder: &Path, mode: VerticalMode, start: &Input) -> Result<Element, Box<dyn Error>> {
    let mut parameters = Parameters { vertical_mode: mode, ..Parameters::default() };
    parameters.tangential_model = TangentialModel::None;
    parameters.profile_smoothing = 0.0;
    for (rail, name) in parameters.rails.iter_mut().zip(["wing.slcs", "nose.slcs"]) {
        (rail.profile, rail.enabled, rail.mirrored) = (name.into(), true, false);
        (rail.placement, rail.position, rail.inclination) = (Placement::Origin, [0.7175, 0.0], 0.0);
    }
    Ok(Element::new(&parameters, start, &[folder.into()])?)
}

/// Station [m], height of the wheel [m], load on the wing and on the nose [N], penetration [m].
type Rolled = [f64; 5];

/// The wheel under its load along the crossing, at rest everywhere.
fn roll_slowly(folder: &Path) -> Result<Vec<Rolled>, Box<dyn Error>> {
    let mut input = Input::default();
    let mut element = element(folder, VerticalMode::Load, &input)?;
    input.wheel_load = LOAD + 9.81 * WHEEL_MASS;
    let mut output = Output::default();
    let mut rolled = Vec::new();
    for i in 0..=1200 {
        input.track_s = STRETCH[0] + 1e-3 * f64::from(i);
        element.evaluate(&input, &mut output)?;
        let patch = output.patches[0];
        rolled.push([
            input.track_s,
            output.wheel_z,
            output.rails[0].force[2],
            output.rails[1].force[2],
            patch.penetration,
        ]);
    }
    Ok(rolled)
}

/// The sharpest dip of the way of the wheel: the angle between the ways down and up 30 mm beside it
/// [rad], the stiffness of a contact there [N/m], and its place [m].
fn dip(rolled: &[Rolled]) -> [f64; 3] {
    const BESIDE: usize = 30;
    let slope = |a: usize, b: usize| (rolled[b][1] - rolled[a][1]) / (rolled[b][0] - rolled[a][0]);
    let angle = |i: usize| slope(i - BESIDE, i) - slope(i, i + BESIDE);
    let inner = BESIDE..rolled.len() - BESIDE;
    let Some(at) = inner.max_by(|a, b| angle(*a).total_cmp(&angle(*b))) else { return [0.0; 3] };
    // On the nose alone; of a ball: 3/2 of load over penetration.
    let [_, _, wing, nose, penetration] = rolled[at + BESIDE];
    [angle(at), 1.5 * (wing + nose) / penetration, rolled[at][0]]
}

/// First peak of the force of a wheel that meets a dip of `angle` [rad] at `speed` [m/s] (Jenkins
/// and others 1974) [N]: wheel and crossing part with the normal speed and meet on the spring of
/// the contact.
fn first_peak(angle: f64, stiffness: f64, speed: f64) -> f64 {
    let masses = CROSSING_MASS / (1.0 + CROSSING_MASS / WHEEL_MASS);
    LOAD + 9.81 * WHEEL_MASS + angle * speed * (stiffness * masses).sqrt()
}

/// Contact force [kN] over the station [mm] at `speed` [m/s], from static equilibrium before the
/// crossing.
fn roll(folder: &Path, speed: f64) -> Result<Vec<[f64; 2]>, Box<dyn Error>> {
    let mut input = Input { track_s: STRETCH[0], ..Input::default() };
    let mut output = Output::default();
    let mut element = element(folder, VerticalMode::Penetration, &input)?;
    input.wheel.velocity[0] = speed;
    input.wheel.pitch_rate = -speed / 0.46;
    let weight = LOAD + 9.81 * WHEEL_MASS;
    let (mut z, mut vz) = (weight / TRACK_STIFFNESS, 0.0);
    for rail in &mut input.rails {
        rail.z = z;
    }
    let (mut low, mut high) = (element.touching_height(&input), -0.455);
    for _ in 0..60 {
        input.wheel.position[2] = 0.5 * (low + high);
        element.evaluate(&input, &mut output)?;
        let bound = if -output.wheel.force[2] < weight { &mut low } else { &mut high };
        *bound = input.wheel.position[2];
    }
    let (mut history, mut steps) = (Vec::new(), 0);
    while input.wheel.position[0] < STRETCH[1] - STRETCH[0] {
        element.evaluate(&input, &mut output)?;
        let contact = -output.wheel.force[2];
        vz += STEP * (contact - TRACK_STIFFNESS * z - TRACK_DAMPING * vz) / CROSSING_MASS;
        z += STEP * vz;
        for rail in &mut input.rails {
            (rail.z, rail.vz) = (z, vz);
        }
        input.wheel.velocity[2] += STEP * (weight - contact) / WHEEL_MASS;
        input.wheel.position[2] += STEP * input.wheel.velocity[2];
        input.wheel.position[0] += STEP * speed;
        steps += 1;
        if steps % KEPT == 0 {
            let station = STRETCH[0] + input.wheel.position[0];
            history.push([1e3 * station, 1e-3 * contact]);
        }
    }
    Ok(history)
}

fn save(path: &Path, rolled: &[Rolled], forces: Vec<Series>) -> Result<(), Box<dyn Error>> {
    let chart = |title, y, series| Chart {
        title,
        x: "station from the tip of the nose [mm]",
        y,
        downwards: y.contains("height"),
        legend: Corner::UpperRight,
        legend_room: 0.25,
        height: 260,
        series,
    };
    let first = rolled[0][1];
    let over = |of: &dyn Fn(&Rolled) -> f64| rolled.iter().map(|r| [1e3 * r[0], of(r)]).collect();
    let way = vec![Series::line("wheel", over(&|r| 1e3 * (r[1] - first)))];
    let loads = vec![
        Series::line("wing", over(&|r| 1e-3 * r[2])),
        Series::line("nose", over(&|r| 1e-3 * r[3])),
    ];
    chart::save(
        path,
        &[
            chart("Way of the wheel, rolled slowly", "height, down [mm]", way),
            chart("Load on wing and nose, rolled slowly", "load [kN]", loads),
            chart("Force on the crossing", "contact force [kN]", forces),
        ],
    )
}
