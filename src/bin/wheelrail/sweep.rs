//! `wheelrail sweep`: the element along a path of inputs, and where its outputs jump or are rough.

use std::path::PathBuf;

use anyhow::{Context, Result, bail};
use clap::Args;
use wheelrail::element::{Element, Input};
use wheelrail::variables::{Causality, Kind, VARIABLES, Value, Values, Variable, find};

use crate::args::TableFiles;
use crate::cases::Cases;
use crate::evaluate::read_values;
use crate::figures::sweep::{self as figure, Curve};
use crate::output;
use crate::simulate::assignment;

/// Step along a path of inputs: the largest jump and the roughness of every output
///
/// The rows of CASES, a table as for evaluate, are the corners of the path: inputs go from row to row on straight lines;
/// parameters are those of the first row. Around the steps in which an output changes most against its neighbours the
/// path is halved again and again, so that a jump is told from a steep slope: `jump` is what is left of the change, share
/// of the largest value on the path. `roughness` is the median second difference over the same, where the output changes. One row for each
/// output that changes; `at` counts rows from 1: 1.25 is a quarter of the way from the first to the second.
/// With --vary the path is run once for each value of a parameter, to compare models.
// The text is shown as it stands by --help.
#[allow(clippy::doc_markdown)]
#[derive(Args, Debug)]
#[command(verbatim_doc_comment)]
pub struct Arguments {
    /// Where the path comes from and the result goes.
    #[command(flatten)]
    pub files: TableFiles,
    /// Steps from one row to the next
    #[arg(long, default_value_t = 1000, value_parser = clap::value_parser!(u32).range(4..=10_000_000))]
    pub steps: u32,
    /// Run the path with each of these values of a parameter
    #[arg(long, value_name = "NAME=VALUE,VALUE,...", value_parser = assignment)]
    pub vary: Option<(String, String)>,
    /// Every step as CSV
    #[arg(long, value_name = "FILE")]
    pub history: Option<PathBuf>,
    /// Forces and creepages along the path, with the jumps marked, as SVG
    #[arg(long, value_name = "FILE")]
    pub figure: Option<PathBuf>,
}

/// Steps that are looked at closely, for each output.
const SUSPECTS: usize = 4;
/// How often such a step is halved: down to rounding.
const HALVINGS: u32 = 48;
/// Changes below this share of the largest value are rounding.
const ROUNDING: f64 = 1e-12;

/// Jumps below this share of the largest value are not marked in figures.
const LEAST_DRAWN: f64 = 1e-9;

/// What was found of one output.
struct Found {
    variable: &'static Variable,
    largest: f64,
    roughness: f64,
    jump: f64,
    at: f64,
}

/// An element and the path of its input.
struct Path {
    element: Element,
    corners: Vec<Values>,
    values: Values,
    outputs: Vec<&'static Variable>,
}

/// Steps along the path.
///
/// # Errors
/// With row and column what evaluate refuses; a path of fewer than two rows; files that cannot be written.
pub fn run(arguments: &Arguments) -> Result<()> {
    let cases = Cases::read(&arguments.files.cases)?;
    let corners: Vec<Values> = read_values(&cases)?.into_iter().map(|(_, values)| values).collect();
    if corners.len() < 2 {
        bail!("{}: a path has at least two rows", arguments.files.cases.display());
    }
    if let Some(row) = corners.iter().position(|c| c.parameters != corners[0].parameters) {
        bail!(
            "{}: row {} has other parameters than the first: only inputs change along a path",
            arguments.files.cases.display(),
            row + 1
        );
    }
    let variants = variants(arguments.vary.as_ref(), corners)?;
    let outputs: Vec<&'static Variable> = VARIABLES
        .iter()
        .filter(|v| v.causality == Causality::Output && v.kind == Kind::Real)
        .collect();
    let steps = arguments.steps as usize;
    let count = (variants[0].corners.len() - 1) * steps;
    let destination = arguments.files.output.as_deref();
    let progress = output::progress(count * variants.len(), destination)?;
    let mut swept = Vec::new();
    for Variant { name, corners } in variants {
        let (values, outputs) = (corners[0].clone(), outputs.clone());
        let element = Element::new(&values.parameters, &values.input, &[cases.folder()])?;
        let mut path = Path { element, corners, values, outputs };
        let mut history = Vec::with_capacity(count + 1);
        for step in 0..=count {
            history.push(path.at(step as f64 / steps as f64)?);
            progress.inc(1);
        }
        let mut found = Vec::new();
        for output in 0..path.outputs.len() {
            if let Some(row) = path.examine(output, &history, steps)? {
                found.push(row);
            }
        }
        swept.push(Swept { name, history, found });
    }
    progress.finish_and_clear();
    let varied = arguments.vary.as_ref().map(|(name, _)| name.as_str());
    write_found(varied, &swept, destination)?;
    if let Some(file) = &arguments.history {
        write_history(varied, &outputs, &swept, steps, file)?;
    }
    if let Some(file) = &arguments.figure {
        draw(varied, &outputs, &swept, steps, file)?;
    }
    Ok(())
}

/// The path with one value of the parameter that is varied.
struct Variant {
    /// That value; empty where none is.
    name: String,
    corners: Vec<Values>,
}

/// What a variant gave.
struct Swept {
    name: String,
    history: Vec<Vec<f64>>,
    found: Vec<Found>,
}

/// The path once for each value that is asked for.
fn variants(vary: Option<&(String, String)>, corners: Vec<Values>) -> Result<Vec<Variant>> {
    let Some((name, values)) = vary else {
        return Ok(vec![Variant { name: String::new(), corners }]);
    };
    let place = || format!("--vary {name}");
    let variable = find(name).with_context(place)?;
    if variable.causality != Causality::Parameter {
        bail!("--vary {name}: it is no parameter; inputs vary along the path");
    }
    let variant = |value: &str| {
        let mut corners = corners.clone();
        for corner in &mut corners {
            corner.set_from_text(variable, value).with_context(place)?;
        }
        Ok(Variant { name: value.into(), corners })
    };
    values.split(',').map(|value| variant(value.trim())).collect()
}

impl Path {
    /// The outputs at `place`, from 0 at the first row.
    fn at(&mut self, place: f64) -> Result<Vec<f64>> {
        let last = self.corners.len() - 2;
        let leg = (place.floor() as usize).min(last);
        let share = place - leg as f64;
        let (from, to) = (&self.corners[leg].input, &self.corners[leg + 1].input);
        self.values.input = between(&self.values, from, to, share);
        self.element.evaluate(&self.values.input, &mut self.values.output)?;
        let read = self.outputs.iter().map(|variable| match self.values.get(variable) {
            Value::Real(value) => value,
            _ => 0.0,
        });
        Ok(read.collect())
    }

    /// Largest value, roughness and jump of one output; none if it stays what it is.
    fn examine(
        &mut self,
        output: usize,
        history: &[Vec<f64>],
        steps: usize,
    ) -> Result<Option<Found>> {
        let value = |i: usize| history[i][output];
        let largest = history.iter().map(|row| row[output].abs()).fold(0.0, f64::max);
        let change = |i: usize| value(i + 1) - value(i);
        let count = history.len() - 1;
        if (0..count).all(|i| change(i).abs() <= ROUNDING * largest) {
            return Ok(None);
        }
        // Where it rests, as on a lifted wheel, there is nothing to be rough.
        let mut bends: Vec<f64> = (1..count)
            .filter(|&i| change(i).abs() > 0.0)
            .map(|i| (change(i) - change(i - 1)).abs() / largest)
            .collect();
        // How much a step stands out from its neighbours.
        let stands_out = |i: usize| {
            let neighbours = change(i.max(1) - 1) + change((i + 1).min(count - 1));
            (change(i) - 0.5 * neighbours).abs()
        };
        let mut suspects: Vec<usize> = (0..count).collect();
        suspects.sort_by(|&a, &b| stands_out(b).total_cmp(&stands_out(a)));
        let (mut jump, mut at) = (0.0, 0.0);
        for &step in suspects.iter().take(SUSPECTS) {
            let (size, place) = self.halve(output, step, steps)?;
            if size > jump {
                (jump, at) = (size, place);
            }
        }
        bends.sort_by(f64::total_cmp);
        let roughness = bends.get(bends.len() / 2).copied().unwrap_or_default();
        let jump = if jump > ROUNDING * largest { jump / largest } else { 0.0 };
        let variable = self.outputs[output];
        Ok(Some(Found { variable, largest, roughness, jump, at: at + 1.0 }))
    }

    /// What is left of the change of an output over one step when its half with the larger change is kept, again and again; and where.
    fn halve(&mut self, output: usize, step: usize, steps: usize) -> Result<(f64, f64)> {
        let place = |i: usize| i as f64 / steps as f64;
        let (mut from, mut to) = (place(step), place(step + 1));
        let (mut low, mut high) = (self.at(from)?[output], self.at(to)?[output]);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (from + to);
            if middle <= from || middle >= to {
                break;
            }
            let value = self.at(middle)?[output];
            if (value - low).abs() > (high - value).abs() {
                (to, high) = (middle, value);
            } else {
                (from, low) = (middle, value);
            }
        }
        Ok(((high - low).abs(), from))
    }
}

/// The input `share` of the way from one to another.
fn between(values: &Values, from: &Input, to: &Input, share: f64) -> Input {
    let [mut a, mut b] = [values.clone(), values.clone()];
    (a.input, b.input) = (*from, *to);
    let mut between = a.clone();
    for variable in VARIABLES.iter().filter(|v| v.causality == Causality::Input) {
        if let (Value::Real(low), Value::Real(high)) = (a.get(variable), b.get(variable)) {
            let value = if share >= 1.0 { high } else { low + share * (high - low) };
            // Between two admitted values all are admitted.
            let _ = between.set(variable, Value::Real(value));
        }
    }
    between.input
}

fn write_found(
    varied: Option<&str>,
    swept: &[Swept],
    destination: Option<&std::path::Path>,
) -> Result<()> {
    let mut table = output::table(destination)?;
    let columns = ["output", "unit", "largest", "roughness", "jump", "at"];
    table.write_record(varied.into_iter().chain(columns))?;
    for Swept { name, found, .. } in swept {
        for row in found {
            let at = if row.jump > 0.0 { format!("{:.9}", row.at) } else { String::new() };
            let cells = [
                row.variable.name.to_owned(),
                row.variable.unit.to_owned(),
                format!("{:.6e}", row.largest),
                format!("{:.2e}", row.roughness),
                format!("{:.2e}", row.jump),
                at,
            ];
            table.write_record(varied.map(|_| name.clone()).into_iter().chain(cells))?;
        }
    }
    Ok(table.flush()?)
}

fn write_history(
    varied: Option<&str>,
    outputs: &[&Variable],
    swept: &[Swept],
    steps: usize,
    file: &std::path::Path,
) -> Result<()> {
    let mut table = output::table(Some(file))?;
    let names = ["at"].into_iter().chain(outputs.iter().map(|v| v.name));
    table.write_record(varied.into_iter().chain(names))?;
    for Swept { name, history, .. } in swept {
        for (step, row) in history.iter().enumerate() {
            let at = 1.0 + step as f64 / steps as f64;
            let cells = [at].into_iter().chain(row.iter().copied()).map(|v| format!("{v:?}"));
            table.write_record(varied.map(|_| name.clone()).into_iter().chain(cells))?;
        }
    }
    Ok(table.flush()?)
}

fn draw(
    varied: Option<&str>,
    outputs: &[&Variable],
    swept: &[Swept],
    steps: usize,
    file: &std::path::Path,
) -> Result<()> {
    let curve = |swept: &Swept, output: &str, name: String| {
        let column = outputs.iter().position(|v| v.name == output);
        let drawn = |f: &&Found| f.variable.name == output && f.jump > LEAST_DRAWN;
        let jump = swept.found.iter().find(drawn);
        Curve {
            name,
            points: (swept.history.iter().enumerate())
                .filter_map(|(i, row)| Some((1.0 + i as f64 / steps as f64, row[column?])))
                .collect(),
            jump: jump.map(|f| (f.at, f.jump)),
        }
    };
    let panels: Vec<(String, Vec<Curve>)> = if let Some(varied) = varied {
        let axes = ["x", "y", "z"].into_iter();
        axes.map(|axis| {
            let output = format!("wheel.force.{axis}");
            let curves = swept.iter().map(|s| curve(s, &output, s.name.clone())).collect();
            (format!("{output} [N] by {varied}"), curves)
        })
        .collect()
    } else {
        let forces = ["x", "y", "z"].map(|axis| format!("wheel.force.{axis}"));
        let patches = [1, 2, 3].map(|k| format!("patch[{k}].normal_force"));
        [("Force on the wheel [N]", forces), ("Normal force of the heaviest patches [N]", patches)]
            .map(|(title, names)| {
                let curves = names.map(|name| curve(&swept[0], &name, name.clone()));
                (title.to_owned(), curves.into())
            })
            .into()
    };
    figure::draw(file, &panels)
}
