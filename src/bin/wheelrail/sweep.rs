//! `wheelrail sweep`: the element along a path of inputs, and where its outputs jump or are rough.

mod path;
mod results;

use std::path::PathBuf;

use anyhow::{Context, Result, bail};
use clap::Args;
use wheelrail::element::Element;
use wheelrail::variables::{Causality, Kind, VARIABLES, Values, Variable, find};

use crate::cases::Cases;
use crate::element_rows::read_values;
use crate::options::{TableFiles, assignment};
use crate::output;
use crate::remarks::{Found, Remarks};

use path::Path;
use results::{Results, Swept};

/// Step along a path of inputs: the largest jump and the roughness of every output
///
/// The rows of CASES, a table as for evaluate, are the corners of the path: inputs go from row to
/// row on straight lines; parameters are those of the first row. Around the steps in which an
/// output changes most against its neighbours the path is halved again and again, so that a jump is
/// told from a steep slope: `jump` is what is left of the change, share of the largest value on the
/// path. `roughness` is the median second difference over the same, where the output changes. One
/// row for each output that changes; `at` counts rows from 1: 1.25 is a quarter of the way from the
/// first to the second. With --vary the path is run once for each value of a parameter, to compare
/// models.
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

/// Steps along the path.
pub fn run(arguments: &Arguments) -> Result<()> {
    let path = &arguments.files.cases;
    let destination = arguments.files.output.as_deref();
    let outputs = [destination, arguments.history.as_deref(), arguments.figure.as_deref()];
    output::check_names([path.as_path()], outputs)?;
    let cases = Cases::read(path)?;
    let corners: Vec<Values> =
        read_values(&cases, &[], &outputs)?.into_iter().map(|(_, values)| values).collect();
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
    let progress = output::progress(Some(count * variants.len()), destination)?;
    let mut swept = Vec::new();
    let mut remarks = Remarks::default();
    for Variant { name, corners } in variants {
        let (values, outputs) = (corners[0].clone(), outputs.clone());
        let element = Element::new(&values.parameters, &values.input, &[cases.header().folder()])?;
        let found =
            Found::default().with_start(&element).with_profiles(element.profile_remarks().to_vec());
        progress.suspend(|| remarks.tell(&found.at(|| "row 1".into())));
        let mut path = Path { element, corners, values, outputs };
        let mut history = Vec::with_capacity(count + 1);
        for step in 0..=count {
            history.push(path.at(step as f64 / steps as f64)?);
            // Rows count from 1.
            let row = || format!("row {}", (steps + step) as f64 / steps as f64);
            let found = Found::evaluated(
                &path.element,
                &path.values.parameters,
                &path.values.input,
                &path.values.output,
            )
            .at(row);
            if !found.is_empty() {
                progress.suspend(|| remarks.tell(&found));
            }
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
    let results = Results { varied, outputs, swept, steps };
    results.write(destination)?;
    if let Some(file) = &arguments.history {
        results.write_history(file)?;
    }
    if let Some(file) = &arguments.figure {
        results.draw(file)?;
    }
    Ok(())
}

/// The path with one value of the parameter that is varied.
struct Variant {
    /// That value; empty where none is.
    name: String,
    corners: Vec<Values>,
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
