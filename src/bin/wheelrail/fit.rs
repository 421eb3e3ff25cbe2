//! `wheelrail fit`: the law of friction of measured creep curves.

mod least_squares;
mod points;

use std::fmt::Write;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail, ensure};
use clap::Args;
use wheelrail::variables::{Values, find};

use crate::cases::Cases;
use crate::options::assignment;
use crate::{figures, output};
use least_squares::{Fit, Parameter};
use points::Points;

/// Fit the law of friction to measured creep curves
///
/// Friction, its fall with the slip velocity and the reduction of the initial slope, by least
/// squares of the adhesion: the force of a rolling contact over its normal force. The bodies touch
/// in an ellipse; steel, unless --set says otherwise.
///
/// Columns of POINTS, in any order; those marked * are needed:
///   creepage_longitudinal *, adhesion *    of one point of a curve, both without sign or both with the same
///   load_n *                               normal force
///   speed_m_s *                            rolling speed
///   creepage_lateral, spin_per_mm          (0)
///
/// Said is each parameter with its standard error, as it can be given to --set of the other
/// commands, and what the data do not determine. A table of the fit goes to --output.
#[derive(Args, Debug)]
#[command(verbatim_doc_comment)]
pub struct Arguments {
    /// Table of measured points, CSV
    #[arg(value_name = "POINTS.csv", required_unless_present = "parameters")]
    pub points: Option<PathBuf>,
    /// File for points and fit, CSV
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// File for a figure of points and fit, SVG
    #[arg(long, value_name = "FILE")]
    pub figure: Option<PathBuf>,
    /// Parameters that are fitted, parted by commas or blanks; the others keep their start values or those of --set
    #[arg(long = "parameters", value_name = "NAMES", value_delimiter = ',', num_args = 1.., default_values = Parameter::NAMES)]
    pub parameters: Vec<String>,
    /// Relative radius of the bodies along rolling [m]
    #[arg(long, value_name = "M", default_value_t = 0.46, help_heading = "Contact")]
    pub radius_along: f64,
    /// Relative radius of the bodies across [m]
    #[arg(long, value_name = "M", default_value_t = 0.3, help_heading = "Contact")]
    pub radius_across: f64,
    /// Set any parameter, such as friction.falling.law or wheel.young_modulus, or
    /// friction.coefficient; may be repeated
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = assignment, help_heading = "Contact")]
    pub settings: Vec<(String, String)>,
}

/// Fits, says what was found and writes table and figure.
pub fn run(arguments: &Arguments) -> Result<()> {
    let mut names = arguments.parameters.clone();
    // Behind names that are parted by blanks the table is taken for the last of them.
    let table = match &arguments.points {
        Some(table) => table.clone(),
        None => match names.pop() {
            Some(last) if Parameter::named(&last).is_none() && !names.is_empty() => last.into(),
            _ => bail!("POINTS.csv is missing: name the table of measured points"),
        },
    };
    let table = table.as_path();
    let outputs = [arguments.output.as_deref(), arguments.figure.as_deref()];
    output::check_names([table], outputs)?;
    let parameters = parameters(&names)?;
    let values = values(&arguments.settings)?;
    for (name, radius) in
        [("radius-along", arguments.radius_along), ("radius-across", arguments.radius_across)]
    {
        ensure!(
            (1e-3..=1e3).contains(&radius),
            "--{name} {radius} is not admitted: a radius from 0.001 to 1000 m"
        );
    }
    let radii = [arguments.radius_along, arguments.radius_across];
    let points = Points::read(&Cases::read(table)?, &values, radii)?;
    ensure!(
        points.all.len() > parameters.len(),
        "{}: {} points do not determine {} parameters; name fewer in --parameters",
        table.display(),
        points.all.len(),
        parameters.len()
    );
    let fit = least_squares::fit(&points, &values, &parameters)?;
    output::say(&told(&fit, points.all.len()))?;
    if let Some(path) = &arguments.output {
        write_table(path, &points, &fit)?;
    }
    if let Some(path) = &arguments.figure {
        figures::fit::draw(path, &curves(&points, &fit))?;
    }
    Ok(())
}

fn parameters(names: &[String]) -> Result<Vec<Parameter>> {
    let mut all = Vec::new();
    for name in names {
        let Some(parameter) = Parameter::named(name) else {
            bail!("--parameters {name}: it has to be one of {}", Parameter::NAMES.join(", "));
        };
        ensure!(!all.contains(&parameter), "--parameters: {name} is there twice");
        all.push(parameter);
    }
    Ok(all)
}

/// Start values with what is set.
fn values(settings: &[(String, String)]) -> Result<Values> {
    let mut values = Values::default();
    let hertz = ("normal.model".to_owned(), "hertz".to_owned());
    for (name, value) in std::iter::once(&hertz).chain(settings) {
        let variable = find(name).with_context(|| format!("--set {name}"))?;
        values.set_from_text(variable, value).with_context(|| format!("--set {name}"))?;
    }
    Ok(values)
}

/// What was found, a line for each parameter.
fn told(fit: &Fit, points: usize) -> String {
    let mut text = String::new();
    for found in &fit.parameters {
        let name = found.parameter.name();
        let bound = found.at_bound.map_or(String::new(), |bound| format!(", at its bound {bound}"));
        let open = if found.is_determined {
            String::new()
        } else {
            ", not determined by the data".to_owned()
        };
        let _ = writeln!(text, "{name}={:.6} +- {:.2e}{bound}{open}", found.value, found.error);
    }
    for (a, b) in &fit.together {
        let _ = writeln!(text, "{} and {} are known together only", a.name(), b.name());
    }
    let _ = writeln!(text, "misfit {:.2e} (root mean square of {points} points)", fit.misfit);
    text
}

fn write_table(path: &Path, points: &Points, fit: &Fit) -> Result<()> {
    let table = output::table(Some(path))?;
    for (point, fitted) in points.all.iter().zip(&fit.adhesion) {
        let [longitudinal, lateral, spin] = point.creepage;
        let numbers = [
            ("creepage_longitudinal", longitudinal),
            ("creepage_lateral", lateral),
            ("spin_per_mm", 1e-3 * spin),
            ("load_n", point.load),
            ("speed_m_s", point.speed),
            ("adhesion", point.adhesion),
            ("fitted", *fitted),
            ("misfit", fitted - point.adhesion),
        ];
        table.write_named(&numbers.map(|(name, number)| (name, format!("{number:?}"))))?;
    }
    table.finish()
}

/// Points and fit of each load and speed, over the creepage.
fn curves(points: &Points, fit: &Fit) -> Vec<figures::fit::Curve> {
    let mut curves: Vec<figures::fit::Curve> = Vec::new();
    for (point, fitted) in points.all.iter().zip(&fit.adhesion) {
        let [longitudinal, lateral, _] = point.creepage;
        let name = format!("{:.1} kN, {:.1} m/s", 1e-3 * point.load, point.speed);
        let creepage = longitudinal.hypot(lateral);
        let own = curves.iter_mut().find(|curve| curve.name == name);
        let (measured, fitted) = ((creepage, point.adhesion), (creepage, *fitted));
        match own {
            Some(curve) => {
                curve.measured.push(measured);
                curve.fitted.push(fitted);
            }
            None => curves.push(figures::fit::Curve {
                name,
                measured: vec![measured],
                fitted: vec![fitted],
            }),
        }
    }
    for curve in &mut curves {
        curve.fitted.sort_by(|a, b| a.0.total_cmp(&b.0));
    }
    curves
}
