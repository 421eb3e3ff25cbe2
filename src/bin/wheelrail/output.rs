//! Where tables of results go, and the progress of long inputs.

use std::fs::File;
use std::io::{self, IsTerminal, Write};
use std::path::Path;

use anyhow::{Context, Result};
use indicatif::{ProgressBar, ProgressStyle};

/// A writer of a table to the file `path`, or to standard output without one.
///
/// # Errors
/// If the file cannot be made.
pub fn table(path: Option<&Path>) -> Result<csv::Writer<Box<dyn Write>>> {
    let target: Box<dyn Write> = match path {
        Some(path) => {
            let file =
                File::create(path).with_context(|| format!("cannot write {}", path.display()))?;
            Box::new(file)
        }
        None => Box::new(io::stdout().lock()),
    };
    Ok(csv::Writer::from_writer(target))
}

/// A bar for `rows` cases on standard error; hidden where the rows themselves go to the terminal.
///
/// # Errors
/// Never: the template is fixed.
pub fn progress(rows: usize, path: Option<&Path>) -> Result<ProgressBar> {
    if path.is_none() && io::stdout().is_terminal() {
        return Ok(ProgressBar::hidden());
    }
    let style = ProgressStyle::with_template(
        "{bar:40.blue} {pos} of {len} cases, {elapsed} elapsed, {eta} to go",
    )?;
    Ok(ProgressBar::new(rows as u64).with_style(style))
}
