//! Where results go: files that get their names only when they are complete, tables on standard
//! output, and the progress of long inputs.

mod table;

use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use indicatif::{ProgressBar, ProgressStyle};

pub use table::Table;
use table::cannot_write;
use wheelrail::io::{full_name, write_whole};

/// A table in the file `path`, or on standard output without one.
pub fn table(path: Option<&Path>) -> Result<Table> {
    Table::new(path)
}

/// Writes the file `path`: what had that name before stays until the new one is complete.
pub fn write(path: &Path, content: &[u8]) -> Result<()> {
    write_whole(path, content).with_context(|| cannot_write(path))
}

/// Refuses the name of a figure that is none of an SVG.
pub fn check_figure(path: &Path) -> Result<()> {
    if path.extension().is_none_or(|end| !end.eq_ignore_ascii_case("svg")) {
        bail!("{}: figures are SVG; write a name that ends in .svg", path.display());
    }
    Ok(())
}

/// Writes a text to standard output.
pub fn say(text: &str) -> Result<()> {
    let mut out = io::stdout().lock();
    let written = out.write_all(text.as_bytes()).and_then(|()| out.flush());
    written.context("cannot write standard output")
}

/// Checks that no result has the name of what the same command reads, or of another result.
pub fn check_names<'a>(
    inputs: impl IntoIterator<Item = &'a Path>,
    outputs: impl IntoIterator<Item = Option<&'a Path>>,
) -> Result<()> {
    // Devices, pipes and folders may be named twice.
    let identity = |path| full_name(path).filter(|full| full.is_file() || !full.exists());
    let inputs: Vec<PathBuf> = inputs.into_iter().filter_map(identity).collect();
    let mut taken = Vec::new();
    for output in outputs.into_iter().flatten() {
        let Some(file) = identity(output) else { continue };
        let shown = output.display();
        if inputs.contains(&file) {
            bail!("cannot write {shown}: this command reads it; give the result another name");
        }
        if taken.contains(&file) {
            bail!("cannot write {shown}: another result goes there; give each a name of its own");
        }
        taken.push(file);
    }
    Ok(())
}

/// A bar for `rows` cases on standard error, or without their number a count; hidden where the rows
/// themselves go to the terminal.
pub fn progress(rows: Option<usize>, path: Option<&Path>) -> Result<ProgressBar> {
    if path.is_none() && io::stdout().is_terminal() {
        return Ok(ProgressBar::hidden());
    }
    let Some(rows) = rows else {
        let style = ProgressStyle::with_template("{pos} cases, {elapsed} elapsed")?;
        return Ok(ProgressBar::no_length().with_style(style));
    };
    let style = ProgressStyle::with_template(
        "{bar:40.blue} {pos} of {len} cases, {elapsed} elapsed, {eta} to go",
    )?;
    Ok(ProgressBar::new(rows as u64).with_style(style))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_results_may_go_to_a_device() {
        let null = Path::new("/dev/null");
        assert!(check_names([], [Some(null), Some(null), None]).is_ok());
    }

    #[test]
    fn what_cannot_be_written_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let error = format!("{:#}", write(folder.path(), b"").unwrap_err());
        let wanted = format!("cannot write {}: ", folder.path().display());
        assert!(error.starts_with(&wanted), "{error}");
    }
}
