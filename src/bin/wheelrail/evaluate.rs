//! `wheelrail evaluate`: the contact element for every row of a table.

use std::borrow::Cow;
use std::fmt::Write;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use clap::Args;
use wheelrail::element::{Element, Input, Parameters};
use wheelrail::error::ContactError;
use wheelrail::variables::{Causality, VARIABLES, Values, Variable, find};

use crate::batch;
use crate::cases::{CaseReader, Row};
use crate::element_rows::{placed, set, variables};
use crate::models::is_slow;
use crate::named_files::NamedFiles;
use crate::options::TableFiles;
use crate::output;
use crate::remarks::{Found, ProfileRemarks, Remarks};

/// Evaluate the contact element for every row of a table
///
/// The header of CASES names inputs and parameters of the FMU, such as wheel.y, wheel.z, side or
/// normal.model; what is left out, or an empty cell, keeps its start value (docs/fmi.md lists
/// them). Inputs may have their short names of Python too: y, vx, load, friction. Enumerations are
/// given by the names or numbers of their items, profile files relative to CASES. The result has one
/// row for each case: the columns of CASES, then every output and calculated parameter, or those of
/// --outputs. A column id is passed on. Lines that begin with # are comments.
///
/// Columns are parted by commas, or by semicolons or tabs, and then decimal commas are read too;
/// the result is parted as CASES is, with decimal points.
/// Rows are evaluated on all cores, or as many threads as the environment variable
/// RAYON_NUM_THREADS says, and written in their order as they are done. A file gets its name when
/// it is complete: what is done of it before, when the run is stopped or a row is refused, stays in
/// FILE.partial.
#[derive(Args, Debug)]
#[command(verbatim_doc_comment)]
pub struct Arguments {
    /// Where the cases come from and the results go.
    #[command(flatten)]
    pub files: TableFiles,
    /// Outputs that are written, by FMI name, parted by commas; * stands for anything; without it
    /// all of them
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    pub outputs: Vec<String>,
}

/// Evaluates all rows.
pub fn run(arguments: &Arguments) -> Result<()> {
    let (cases, path) = (arguments.files.cases.as_path(), arguments.files.output.as_deref());
    output::check_names([cases], [path])?;
    // A wrong cell is told at once; what is no file on disk can be read only once.
    let count = if cases.is_file() { Some(check(cases, path)?) } else { None };
    let reader = CaseReader::open(cases)?;
    let columns = variables(reader.header(), &[])?;
    let computed = selected(&arguments.outputs)?;
    let delimiter = reader.header().delimiter();
    let given: Vec<String> =
        reader.header().columns().map(|name| quoted(name, delimiter).into_owned()).collect();
    let head = given.iter().map(String::as_str).chain(computed.iter().map(|v| v.name));
    let head = head.collect::<Vec<_>>().join(delimiter.encode_utf8(&mut [0; 4])) + "\n";
    let files = NamedFiles::new(reader.header().folder(), &[path]);
    let folder = reader.header().folder();
    let table = output::table(path)?;
    let progress = output::progress(count, path)?;
    let mut header_due = true;
    let mut remarks = Remarks::default();
    let result = batch::in_order(
        &progress,
        reader,
        batch::all_cores(),
        || (Evaluator::new(folder.clone()), files.clone()),
        |(evaluator, files), row| {
            let mut values = Values::default();
            set(&mut values, &columns, &row)?;
            files.check(&values.parameters).with_context(|| row.place())?;
            let found = evaluator.evaluate(&mut values).map_err(|error| placed(error, &row))?;
            let given = row.cells().filter_map(|(column, ..)| Some(columns[column]?.name));
            let found = found.with_inputs(&values.parameters, given);
            Ok((line(&row, delimiter, &values, &computed)?, found.at(|| row.place())))
        },
        |(line, found)| {
            if !found.is_empty() {
                progress.suspend(|| remarks.tell(&found));
            }
            // Only now, so that a table that cannot be evaluated leaves nothing but its error.
            if std::mem::take(&mut header_due) {
                table.write_line(head.as_bytes())?;
            }
            table.write_line(line.as_bytes())
        },
    );
    remarks.count();
    table.complete(result)
}

/// Reads the whole table for what is unknown or refused; gives the number of its rows.
fn check(path: &Path, result: Option<&Path>) -> Result<usize> {
    let reader = CaseReader::open(path)?;
    let columns = variables(reader.header(), &[])?;
    let mut files = NamedFiles::new(reader.header().folder(), &[result]);
    // What a row leaves out was looked at with the row that gave it.
    let mut values = Values::default();
    let mut count = 0;
    for row in reader {
        let row = row?;
        set(&mut values, &columns, &row)?;
        files.check(&values.parameters).with_context(|| row.place())?;
        count += 1;
    }
    Ok(count)
}

/// Outputs and calculated parameters by their names and patterns; all of them without any.
fn selected(wanted: &[String]) -> Result<Vec<&'static Variable>> {
    let is_computed =
        |v: &&Variable| matches!(v.causality, Causality::Output | Causality::CalculatedParameter);
    let all: Vec<&Variable> = VARIABLES.iter().filter(is_computed).collect();
    let mut found = Vec::new();
    for pattern in wanted {
        let fitting = all.iter().filter(|v| fits(v.name, pattern));
        let new: Vec<_> = fitting.filter(|v| !found.contains(*v)).copied().collect();
        found.extend(new);
        if !all.iter().any(|v| fits(v.name, pattern)) {
            let near = find(pattern)
                .map_or_else(|e| e.to_string(), |v| format!("{} is no output", v.name));
            bail!("--outputs {pattern}: {near}");
        }
    }
    Ok(if wanted.is_empty() { all } else { found })
}

/// Whether a name fits a pattern in which * stands for anything.
fn fits(name: &str, pattern: &str) -> bool {
    let Some((begin, rest)) = pattern.split_once('*') else { return name == pattern };
    name.strip_prefix(begin).is_some_and(|name| {
        (0..=name.len()).any(|k| name.is_char_boundary(k) && fits(&name[k..], rest))
    })
}

/// A cell as it stands, in quotation marks where it holds what parts cells.
fn quoted(cell: &str, delimiter: char) -> Cow<'_, str> {
    if cell.contains([delimiter, '"']) {
        format!("\"{}\"", cell.replace('"', "\"\"")).into()
    } else {
        cell.into()
    }
}

/// A row as a line of the result: its own cells, then the computed values, numbers that need no
/// quotation marks.
fn line(row: &Row, delimiter: char, values: &Values, computed: &[&Variable]) -> Result<String> {
    let mut line = String::with_capacity(16 * computed.len());
    for cell in row.all_cells() {
        line.push_str(&quoted(cell, delimiter));
        line.push(delimiter);
    }
    for (k, variable) in computed.iter().enumerate() {
        if k > 0 {
            line.push(delimiter);
        }
        values.write_text(variable, &mut line)?;
    }
    line.write_char('\n')?;
    Ok(line)
}

/// The elements of the parameters that came last, so that rows that share parameters share an
/// element.
struct Evaluator {
    folder: PathBuf,
    /// The one used last first.
    elements: Vec<Box<(Parameters, Element)>>,
}

/// Elements that a thread keeps. One takes 0.3 MB and 0.6 ms to make; those of boundary elements
/// take more memory, and nothing against one evaluation: of them only the last is kept.
const MAX_ELEMENTS: usize = 64;

impl Evaluator {
    fn new(folder: PathBuf) -> Self {
        Self { folder, elements: Vec::new() }
    }

    /// Evaluates a row; gives what is odd about its place, and what was found in files of profiles
    /// that had to be read for it.
    fn evaluate(&mut self, values: &mut Values) -> Result<Found, ContactError> {
        let Values { parameters, input, output, .. } = values;
        let (element, profiles) = self.element(parameters, input)?;
        // Every row is a start of its own.
        element.set_fallbacks(0);
        element.set_start(input);
        element.evaluate(input, output)?;
        values.nominal = element.nominal_wheel_z();
        let found = Found::evaluated(element, parameters, input, output);
        Ok(found.with_start(element).with_profiles(profiles))
    }

    /// The element with these parameters, and what was found in the files of profiles if it had to
    /// be made.
    fn element(
        &mut self,
        parameters: &Parameters,
        input: &Input,
    ) -> Result<(&mut Element, ProfileRemarks), ContactError> {
        let mut found = ProfileRemarks::new();
        if let Some(k) = self.elements.iter().position(|made| made.0 == *parameters) {
            self.elements[..=k].rotate_right(1);
        } else {
            let element = Element::new(parameters, input, std::slice::from_ref(&self.folder))?;
            found = element.profile_remarks().to_vec();
            self.elements.truncate(MAX_ELEMENTS - 1);
            if is_slow(parameters.normal_model, parameters.tangential_model) {
                self.elements.retain(|made| !is_slow(made.0.normal_model, made.0.tangential_model));
            }
            self.elements.insert(0, Box::new((parameters.clone(), element)));
        }
        Ok((&mut self.elements[0].1, found))
    }
}
