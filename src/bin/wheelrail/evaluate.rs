//! `wheelrail evaluate`: the contact element for every row of a table.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use clap::Args;
use wheelrail::element::parameters::{NormalModel, TangentialModel};
use wheelrail::element::{Element, Input, Parameters};
use wheelrail::error::ContactError;
use wheelrail::variables::{Causality, VARIABLES, Values, Variable, find};

use crate::args::TableFiles;
use crate::batch;
use crate::cases::{CaseReader, Cases, Header, Row};
use crate::named_files::NamedFiles;
use crate::output;
use crate::remarks::{Found, ProfileRemarks, Remarks};

/// Evaluate the contact element for every row of a table
///
/// The header of CASES names inputs and parameters of the FMU, such as wheel.y, wheel.z, side or normal.model; what
/// is left out, or an empty cell, keeps its start value (docs/fmi.md lists them). Enumerations are
/// given by the names of their items, profile files relative to CASES. The result has one row for each case and one
/// column for every output and calculated parameter. Lines that begin with # are comments.
///
/// Columns are parted by commas, or by semicolons or tabs, and then decimal commas are read too. Rows are evaluated on all
/// cores, or as many threads as the environment variable RAYON_NUM_THREADS says, and written in their order as they are
/// done. A file gets its name when it is complete: what is done of it before, when the run is stopped or a row is refused,
/// stays in FILE.partial.
// The text is shown as it stands by --help.
#[allow(clippy::doc_markdown)]
#[derive(Args, Debug)]
#[command(verbatim_doc_comment)]
pub struct Arguments {
    /// Where the cases come from and the results go.
    #[command(flatten)]
    pub files: TableFiles,
}

/// Evaluates all rows.
///
/// # Errors
/// With row and column: an unknown name, a value or profile that is refused. Rows before one whose profile is refused are written.
pub fn run(arguments: &Arguments) -> Result<()> {
    let (cases, path) = (arguments.files.cases.as_path(), arguments.files.output.as_deref());
    output::check_names([cases], [path])?;
    // A wrong cell is told at once; what is no file on disk can be read only once.
    let count = if cases.is_file() { Some(check(cases, path)?) } else { None };
    let reader = CaseReader::open(cases)?;
    let columns = variables(reader.header())?;
    let computed: Vec<&Variable> = VARIABLES
        .iter()
        .filter(|v| matches!(v.causality, Causality::Output | Causality::CalculatedParameter))
        .collect();
    let files = NamedFiles::new(reader.header().folder(), &[path]);
    let folder = reader.header().folder();
    let table = output::table(path)?;
    let progress = output::progress(count, path)?;
    let mut header_due = true;
    let mut remarks = Remarks::default();
    let result = batch::in_order(
        reader,
        batch::all_cores(),
        || (Evaluator::new(folder.clone()), files.clone()),
        |(evaluator, files), row| {
            let mut values = Values::default();
            set(&mut values, &columns, &row)?;
            files.check(&values.parameters).with_context(|| row.place())?;
            let found = evaluator.evaluate(&mut values).map_err(|error| placed(error, &row))?;
            Ok((line(&values, &computed)?, found.at(|| row.place())))
        },
        |(line, found)| {
            if !found.is_empty() {
                progress.suspend(|| remarks.tell(&found));
            }
            // Only now, so that a table that cannot be evaluated leaves nothing but its error.
            if std::mem::take(&mut header_due) {
                table.write_record(computed.iter().map(|v| v.name))?;
            }
            table.write_line(line.as_bytes())?;
            progress.inc(1);
            Ok(())
        },
    );
    progress.finish_and_clear();
    table.complete(result)
}

/// Reads the whole table for what is unknown or refused; gives the number of its rows.
fn check(path: &Path, result: Option<&Path>) -> Result<usize> {
    let reader = CaseReader::open(path)?;
    let columns = variables(reader.header())?;
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

/// The computed values of a row as a line of the result: numbers, which need no quotation marks.
fn line(values: &Values, computed: &[&Variable]) -> Result<String> {
    let mut line = String::with_capacity(16 * computed.len());
    for (k, variable) in computed.iter().enumerate() {
        if k > 0 {
            line.push(',');
        }
        values.write_text(variable, &mut line)?;
    }
    line.write_char('\n')?;
    Ok(line)
}

/// The rows of a table with the variables they set; none names a file that is one of `results`.
///
/// # Errors
/// With row and column: an unknown name, a value that is refused.
pub fn read_values<'a>(
    cases: &'a Cases,
    results: &[Option<&Path>],
) -> Result<Vec<(&'a Row, Values)>> {
    let columns = variables(cases.header())?;
    let mut files = NamedFiles::new(cases.header().folder(), results);
    let rows = cases.rows().iter().map(|row| {
        let mut values = Values::default();
        set(&mut values, &columns, row)?;
        files.check(&values.parameters).with_context(|| row.place())?;
        Ok((row, values))
    });
    rows.collect()
}

/// The variables that the columns of a table set.
fn variables(header: &Header) -> Result<Vec<&'static Variable>> {
    header.columns().map(|name| settable(header, name)).collect()
}

/// Sets what a row has.
fn set(values: &mut Values, columns: &[&Variable], row: &Row) -> Result<()> {
    for (column, _, text) in row.cells() {
        values.set_from_text(columns[column], text).with_context(|| row.cell_place(column))?;
    }
    Ok(())
}

/// Whether an evaluation takes milliseconds.
pub fn is_slow(parameters: &Parameters) -> bool {
    parameters.normal_model == NormalModel::BoundaryElement
        || parameters.tangential_model == TangentialModel::BoundaryElement
}

fn settable(header: &Header, name: &str) -> Result<&'static Variable> {
    if name == "separation" {
        bail!("{}: a table of planar problems is one for patch", header.column_place(name));
    }
    let variable = find(name).with_context(|| header.column_place(name))?;
    if !variable.is_settable() {
        bail!(
            "{}: it is computed by the element; columns are inputs and parameters",
            header.column_place(name)
        );
    }
    Ok(variable)
}

/// `error` with the column of the variable it names, if the table has it.
pub fn placed(error: ContactError, row: &Row) -> anyhow::Error {
    let (ContactError::BadValue { name, .. }
    | ContactError::BadText { name, .. }
    | ContactError::Profile { name, .. }) = &error
    else {
        return anyhow::Error::new(error).context(row.place());
    };
    let column = row.cells().find(|(_, column, _)| column == name).map(|(column, ..)| column);
    let place = column.map_or_else(|| row.place(), |column| row.cell_place(column));
    anyhow::Error::new(error).context(place)
}

/// The elements of the parameters that came last, so that rows that share parameters share an element.
struct Evaluator {
    folder: PathBuf,
    /// The one used last first.
    elements: Vec<Box<(Parameters, Element)>>,
}

/// Elements that a thread keeps. One takes 0.3 MB and 0.6 ms to make; those of boundary elements take more memory, and nothing
/// against one evaluation: of them only the last is kept.
const MOST_ELEMENTS: usize = 64;

impl Evaluator {
    fn new(folder: PathBuf) -> Self {
        Self { folder, elements: Vec::new() }
    }

    /// Evaluates a row; gives what is odd about its place, and what was found in files of profiles that had to be read for it.
    fn evaluate(&mut self, values: &mut Values) -> Result<Found, ContactError> {
        let Values { parameters, input, output, .. } = values;
        let (element, profiles) = self.element(parameters, input)?;
        // Every row is a start of its own.
        element.set_fallbacks(0);
        element.set_start(input);
        element.evaluate(input, output)?;
        values.nominal = element.nominal_wheel_z();
        Ok(Found::about_places(element).with_profiles(profiles))
    }

    /// The element with these parameters, and what was found in the files of profiles if it had to be made.
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
            self.elements.truncate(MOST_ELEMENTS - 1);
            if is_slow(parameters) {
                self.elements.retain(|made| !is_slow(&made.0));
            }
            self.elements.insert(0, Box::new((parameters.clone(), element)));
        }
        Ok((&mut self.elements[0].1, found))
    }
}
