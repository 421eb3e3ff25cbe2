//! Rows of a table as values of the element's variables.

use std::path::Path;

use anyhow::{Context, Result, bail};
use wheelrail::error::ContactError;
use wheelrail::variables::{Causality, UnknownVariable, Values, Variable, find};

use crate::cases::{Cases, Header, Row};
use crate::named_files::NamedFiles;

/// The rows of a table with the variables they set; none names a file that is one of `results`. The
/// columns `others` are none of variables.
pub fn read_values<'a>(
    cases: &'a Cases,
    others: &[&str],
    results: &[Option<&Path>],
) -> Result<Vec<(&'a Row, Values)>> {
    let columns = variables(cases.header(), others)?;
    let mut files = NamedFiles::new(cases.header().folder(), results);
    let rows = cases.rows().iter().map(|row| {
        let mut values = Values::default();
        set(&mut values, &columns, row)?;
        files.check(&values.parameters).with_context(|| row.place())?;
        Ok((row, values))
    });
    rows.collect()
}

/// The variables that the columns of a table set; none is that of a column of labels, and of those
/// called as one of `others`.
pub fn variables(header: &Header, others: &[&str]) -> Result<Vec<Option<&'static Variable>>> {
    let all: Vec<Option<&Variable>> = header
        .columns()
        .map(|name| {
            let is_none = is_label(name) || others.contains(&name);
            if is_none { Ok(None) } else { settable(header, name).map(Some) }
        })
        .collect::<Result<_>>()?;
    for (k, variable) in all.iter().enumerate() {
        if let Some(variable) = variable.filter(|own| all[..k].contains(&Some(*own))) {
            let name = header.columns().nth(k).unwrap_or_default();
            bail!("{}: {} is there twice", header.column_place(name), variable.name);
        }
    }
    Ok(all)
}

/// Whether a column only says which row is which.
pub fn is_label(name: &str) -> bool {
    name.eq_ignore_ascii_case("id")
}

/// Sets what a row has.
pub fn set(values: &mut Values, columns: &[Option<&Variable>], row: &Row) -> Result<()> {
    for (column, _, text) in row.cells() {
        if let Some(variable) = columns[column] {
            values.set_from_text(variable, text).with_context(|| row.cell_place(column))?;
        }
    }
    Ok(())
}

/// The variable of that FMI name, or of the short name that inputs have in Python: y for wheel.y,
/// load for wheel.load, friction for friction.coefficient.
fn by_name(name: &str) -> Result<&'static Variable, UnknownVariable> {
    find(name).or_else(|mut unknown| {
        let long = match name {
            "friction" => "friction.coefficient".to_owned(),
            _ => format!("wheel.{name}"),
        };
        let is_input = |variable: &&Variable| variable.causality == Causality::Input;
        match find(&long) {
            Ok(found) => Some(found).filter(is_input).ok_or(unknown),
            // It may be the short name that has a slip in it.
            Err(other) => {
                if other.distance < unknown.distance {
                    (unknown.nearest, unknown.distance) = (other.nearest, other.distance);
                }
                Err(unknown)
            }
        }
    })
}

fn settable(header: &Header, name: &str) -> Result<&'static Variable> {
    if name == "separation" {
        bail!("{}: a table of planar problems is one for patch", header.column_place(name));
    }
    let variable = by_name(name).with_context(|| header.column_place(name))?;
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
