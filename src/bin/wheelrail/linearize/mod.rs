//! `wheelrail linearize`: eigenmodes of a wheelset about the middle of the track, and its critical
//! speed.

mod linear_wheelset;

use std::path::{Path, PathBuf};

use anyhow::{Result, bail};
use clap::Args;
use nalgebra::Complex;
use wheelrail::wheelset::{Input, Parameters, TAPE_CIRCLE, Wheelset};

use crate::figures::roots::{self, Roots};
use crate::options::{ContactOptions, Pair, check_positive};
use crate::output;
use crate::remarks::{Found, Remarks};
use crate::wheelset::options::WheelsetOptions;
use linear_wheelset::{LinearWheelset, STATES, eigenvalues};

/// Equations of motion of a wheelset about even rolling, and their eigenvalues over the speed
///
/// The wheelset is that of simulate, in the middle of a straight track; contact forces have exact
/// derivatives. The table has one row for each speed and eigenvalue, those that grow most first:
/// growth rate, frequency and damping ratio; of a pair one. Printed is the lowest speed from which
/// on a disturbance grows.
#[derive(Args, Debug)]
#[command(verbatim_doc_comment, allow_negative_numbers = true)]
pub struct Arguments {
    /// File for the table, CSV; without it standard output
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// File for the root locus, SVG
    #[arg(long, value_name = "FILE")]
    pub figure: Option<PathBuf>,
    /// File for the system matrix at the first speed, CSV
    #[arg(long, value_name = "FILE")]
    pub matrix: Option<PathBuf>,
    /// Profiles and what else is set.
    #[command(flatten)]
    pub contact: ContactOptions,
    /// Coefficient of friction
    #[arg(long, value_name = "VALUE", default_value_t = 0.3, help_heading = "Contact")]
    pub friction: f64,
    /// Lowest speed [m/s]
    #[arg(long, value_name = "M/S", default_value_t = 5.0, help_heading = "Speeds")]
    pub from: f64,
    /// Highest speed [m/s]
    #[arg(long, value_name = "M/S", default_value_t = 120.0, help_heading = "Speeds")]
    pub to: f64,
    /// Number of speeds
    #[arg(long, value_name = "NUMBER", default_value_t = 47, help_heading = "Speeds")]
    pub speeds: u32,
    /// The wheelset and its suspension.
    #[command(flatten)]
    pub wheelset: WheelsetOptions,
}

/// Speeds at most.
const MAX_SPEEDS: u32 = 10_000;
/// The critical speed is found to this [m/s].
const RESOLUTION: f64 = 1e-6;
/// Computes the table and, if asked for, draws the figure.
pub fn run(arguments: &Arguments) -> Result<()> {
    check(arguments)?;
    let values = arguments.contact.shared_values()?;
    let pair = Pair::of(&values.parameters);
    let outputs = [&arguments.output, &arguments.figure, &arguments.matrix];
    output::check_names(pair.profiles(), outputs.map(Option::as_deref))?;
    let mut parameters = Parameters::of_both(&values.parameters);
    parameters.flange_back_distance = arguments.wheelset.running_circles - 2.0 * TAPE_CIRCLE;
    let here = [PathBuf::from(".")];
    let mut contact = Wheelset::new(&parameters, &Input::default(), &here)?;
    let remarks = contact.elements()[0].profile_remarks().to_vec();
    Remarks::default().tell(&Found::default().with_profiles(remarks));
    let mut wheelset = LinearWheelset {
        contact: &mut contact,
        body: arguments.wheelset.body(),
        suspension: arguments.wheelset.suspension(),
        friction: arguments.friction,
    };
    if let Some(path) = &arguments.matrix {
        write_matrix(&mut wheelset, arguments.from, path)?;
    }
    let mut at = |speed: f64| -> Result<Roots> {
        let start = wheelset.equilibrium(speed)?;
        Ok(Roots { speed, values: eigenvalues(&wheelset.system(&start)?) })
    };
    let last = f64::from(arguments.speeds - 1).max(1.0);
    let speed = |i: u32| arguments.from + (arguments.to - arguments.from) * f64::from(i) / last;
    let roots: Vec<Roots> = (0..arguments.speeds).map(|i| at(speed(i))).collect::<Result<_>>()?;
    let critical = critical_speed(&roots, &mut at)?;
    let table = output::table(arguments.output.as_deref())?;
    for one in &roots {
        for (number, value) in one.values.iter().enumerate() {
            table.write_named(&cells(one.speed, number + 1, *value))?;
        }
    }
    table.finish()?;
    if let Some(path) = &arguments.figure {
        roots::draw(path, &pair.to_string(), &roots, critical)?;
    }
    if arguments.output.is_some() {
        output::say(&told(&roots, critical))?;
    }
    Ok(())
}

fn check(arguments: &Arguments) -> Result<()> {
    arguments.wheelset.check()?;
    check_positive(&[("from", arguments.from), ("to", arguments.to)])?;
    if arguments.to < arguments.from {
        bail!("--to {} is not admitted: it is below --from {}", arguments.to, arguments.from);
    }
    if !(1..=MAX_SPEEDS).contains(&arguments.speeds) {
        bail!("--speeds {} is not admitted: 1 to {MAX_SPEEDS}", arguments.speeds);
    }
    if !(arguments.friction.is_finite() && arguments.friction > 0.0) {
        bail!(
            "--friction {} is not admitted: it must be a finite number above 0, or nothing drives the wheels",
            arguments.friction
        );
    }
    Ok(())
}

fn growth(roots: &Roots) -> f64 {
    roots.values.first().map_or(0.0, |value| value.re)
}

/// The lowest speed between two of the `roots` from which on something grows, by halving; the first
/// of them where it grows there already.
fn critical_speed(
    roots: &[Roots],
    mut at: impl FnMut(f64) -> Result<Roots>,
) -> Result<Option<f64>> {
    let Some(place) = roots.iter().position(|one| growth(one) > 0.0) else { return Ok(None) };
    let mut high = roots[place].speed;
    if place == 0 {
        return Ok(Some(high));
    }
    let mut low = roots[place - 1].speed;
    while high - low > RESOLUTION {
        let middle = 0.5 * (low + high);
        if growth(&at(middle)?) > 0.0 { high = middle } else { low = middle }
    }
    Ok(Some(0.5 * (low + high)))
}

fn told(roots: &[Roots], critical: Option<f64>) -> String {
    let first = roots.first().map_or(0.0, |one| one.speed);
    match critical {
        None => "Every disturbance dies out at all these speeds\n".into(),
        Some(speed) if speed <= first => {
            format!("A disturbance grows at {first} m/s already: begin with a lower --from\n")
        }
        Some(speed) => {
            format!("Critical speed {speed:.3} m/s ({:.2} km/h)\n", 3.6 * speed)
        }
    }
}

fn cells(speed: f64, number: usize, value: Complex<f64>) -> [(&'static str, String); 5] {
    let size = value.norm();
    let ratio = if size > 0.0 { -value.re / size } else { 0.0 };
    [
        ("speed_m_s", speed.to_string()),
        ("number", number.to_string()),
        ("growth_1_s", format!("{:.6e}", value.re)),
        ("frequency_hz", format!("{:.6e}", value.im / std::f64::consts::TAU)),
        ("damping_ratio", format!("{ratio:.6}")),
    ]
}

fn write_matrix(wheelset: &mut LinearWheelset, speed: f64, path: &Path) -> Result<()> {
    let start = wheelset.equilibrium(speed)?;
    let matrix = wheelset.system(&start)?;
    let table = output::table(Some(path))?;
    table.write_record(std::iter::once("rate_of").chain(STATES))?;
    for (row, name) in STATES.iter().enumerate() {
        let cells = matrix.row(row).iter().map(|value| format!("{value:.9e}")).collect::<Vec<_>>();
        table.write_record(std::iter::once((*name).to_string()).chain(cells))?;
    }
    table.finish()
}
