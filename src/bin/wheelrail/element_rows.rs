//! Rows of a table as values of the element's variables.

use std::path::Path;

use anyhow::{Context, Result, bail};
use wheelrail::error::ContactError;
use wheelrail::variables::{Values, Variable, find};

use crate::cases::{Cases, Header, Row};
use crate::named_files::NamedFiles;

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
///
/// # Errors
/// The column that names none, or one that is computed.
pub fn variables(header: &Header) -> Result<Vec<&'static Variable>> {
    header.columns().map(|name| settable(header, name)).collect()
}

/// Sets what a row has.
///
/// # Errors
/// With row and column, a value that is refused.
pub fn set(values: &mut Values, columns: &[&Variable], row: &Row) -> Result<()> {
    for (column, _, text) in row.cells() {
        values.set_from_text(columns[column], text).with_context(|| row.cell_place(column))?;
    }
    Ok(())
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
