//! `wheelrail evaluate`: the contact element for every row of a table.

use std::path::PathBuf;

use anyhow::{Context, Result, bail};
use clap::Args;
use wheelrail::element::parameters::{NormalModel, TangentialModel};
use wheelrail::element::{Element, Parameters};
use wheelrail::error::ContactError;
use wheelrail::variables::{Causality, VARIABLES, Values, Variable, find};

use crate::args::TableFiles;
use crate::batch;
use crate::cases::{Cases, Row};
use crate::output;

/// Evaluate the contact element for every row of a table
///
/// The header of CASES names inputs and parameters of the FMU, such as wheel.y, wheel.z, side or normal.model; what
/// is left out, or an empty cell, keeps its start value (docs/fmi.md lists them). Enumerations are
/// given by the names of their items, profile files relative to CASES. The result has one row for each case and one
/// column for every output and calculated parameter. Lines that begin with # are comments.
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
/// With row and column: an unknown name, a value or profile that is refused. Rows before it are written.
pub fn run(arguments: &Arguments) -> Result<()> {
    let cases = Cases::read(&arguments.files.cases)?;
    let computed: Vec<&Variable> = VARIABLES
        .iter()
        .filter(|v| matches!(v.causality, Causality::Output | Causality::CalculatedParameter))
        .collect();
    let path = arguments.files.output.as_deref();
    let mut table = output::table(path)?;
    let mut header_due = true;
    let progress = output::progress(cases.len(), path)?;
    let all = read_values(&cases)?;
    let slow = all.iter().any(|(_, values)| is_slow(&values.parameters));
    let mut answer = |values: &Values| -> Result<()> {
        // Only now, so that a table that cannot be evaluated leaves nothing but its error.
        if std::mem::take(&mut header_due) {
            table.write_record(computed.iter().map(|v| v.name))?;
        }
        table.write_record(computed.iter().map(|v| values.text_of(v)))?;
        progress.inc(1);
        Ok(())
    };
    let folder = cases.folder();
    // In a row of cases an element is made once for all that have its parameters.
    let chunk = if slow { 1 } else { all.len() };
    let chunks: Vec<&[(Row<'_>, Values)]> = all.chunks(chunk.max(1)).collect();
    batch::in_order(
        &chunks,
        slow,
        |chunk| {
            let mut evaluator = Evaluator { folder: folder.clone(), current: None };
            let mut results = Vec::with_capacity(chunk.len());
            for (row, values) in *chunk {
                let mut values = values.clone();
                match evaluator.evaluate(&mut values) {
                    Ok(()) => results.push(values),
                    Err(error) => return Ok((results, Some(placed(error, row)))),
                }
            }
            Ok((results, None))
        },
        |_, (results, error)| {
            results.iter().try_for_each(&mut answer)?;
            error.map_or(Ok(()), Err)
        },
    )?;
    progress.finish_and_clear();
    Ok(table.flush()?)
}

/// The rows of a table with the variables they set.
///
/// # Errors
/// With row and column: an unknown name, a value that is refused.
pub fn read_values(cases: &Cases) -> Result<Vec<(Row<'_>, Values)>> {
    let columns: Vec<&Variable> =
        cases.columns().map(|name| settable(cases, name)).collect::<Result<_>>()?;
    let rows = cases.rows().map(|row| {
        let mut values = Values::default();
        for (column, _, text) in row.cells() {
            values.set_from_text(columns[column], text).with_context(|| row.cell_place(column))?;
        }
        Ok((row, values))
    });
    rows.collect()
}

/// Whether an evaluation takes milliseconds.
pub fn is_slow(parameters: &Parameters) -> bool {
    parameters.normal_model == NormalModel::BoundaryElement
        || parameters.tangential_model == TangentialModel::BoundaryElement
}

fn settable(cases: &Cases, name: &str) -> Result<&'static Variable> {
    if name == "separation" {
        bail!("{}: a table of planar problems is one for patch", cases.column_place(name));
    }
    let variable = find(name).with_context(|| cases.column_place(name))?;
    if !variable.is_settable() {
        bail!(
            "{}: it is computed by the element; columns are inputs and parameters",
            cases.column_place(name)
        );
    }
    Ok(variable)
}

/// `error` with the column of the variable it names, if the table has it.
pub fn placed(error: ContactError, row: &Row<'_>) -> anyhow::Error {
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

/// The element of the last row, used again as long as the parameters stay.
struct Evaluator {
    folder: PathBuf,
    current: Option<(Parameters, Element)>,
}

impl Evaluator {
    fn evaluate(&mut self, values: &mut Values) -> Result<(), ContactError> {
        let Values { parameters, input, output, .. } = values;
        let (_, element) = match self.current.take() {
            Some(current) if current.0 == *parameters => self.current.insert(current),
            _ => {
                let element = Element::new(parameters, input, std::slice::from_ref(&self.folder))?;
                self.current.insert((parameters.clone(), element))
            }
        };
        let before = output.fallback_count;
        element.evaluate(input, output)?;
        output.fallback_count -= before;
        // Every row is a start of its own.
        values.nominal = element.touching_height(input);
        Ok(())
    }
}
