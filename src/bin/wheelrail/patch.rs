//! `wheelrail patch`: planar contact problems, one for every row of a table.

mod columns;
mod separation;

use std::collections::HashMap;
use std::path::PathBuf;
use std::time::Instant;

use anyhow::{Context, Result};
use clap::Args;
use wheelrail::planar::{PlanarCase, PlanarResult, solve};

use crate::args::TableFiles;
use crate::cases::Cases;
use crate::output;

use columns::Case;

/// Results, in the order of their columns.
const RESULTS: [&str; 11] = [
    "normal_force_n",
    "max_pressure_mpa",
    "area_mm2",
    "length_mm",
    "width_mm",
    "fx_n",
    "fy_n",
    "mz_nmm",
    "patches",
    "fallback",
    "time_us",
];

/// Times a case is solved; the median is reported.
const REPEATS: usize = 5;

/// Solve planar contact problems, one for every row of a table
///
/// A planar problem is the separation f(y) of two bodies across the rolling direction, a rolling radius along it, and an
/// approach or a load. Forces and moment act on the upper body, the wheel; x is forward, y to the right; the moment is
/// about the origin of the separation file.
///
/// Columns of CASES, in any order; those marked * are needed:
///   separation *              CSV file with columns y_mm and f_mm, relative to CASES
///   radius_mm *               rolling radius of the normal section along x
///   approach_mm or load_n *   one of them in each row
///   creepage_longitudinal, creepage_lateral, spin_per_mm     (0)
///   friction                  (0.3)
///   young_modulus_mpa, poisson_ratio              of both bodies (210000, 0.28)
///   rail_young_modulus_mpa, rail_poisson_ratio    of the lower body (as the upper)
///   normal_model, shape_fit, tangential_model, strips, elements_along, bound, flexibilities
///                             names and start values as in the FMU (normal.model, …)
///   elements_across           accepted; the models with strips do not use it
///
/// An empty cell is as if the column were left out. Lines that begin with # are comments. The column time_us of the
/// result is the time of one solution on this machine, the median of five.
// The text is shown as it stands by --help.
#[allow(clippy::doc_markdown)]
#[derive(Args, Debug)]
#[command(verbatim_doc_comment)]
pub struct Arguments {
    /// Where the cases come from and the results go.
    #[command(flatten)]
    pub files: TableFiles,
}

/// Solves all rows.
///
/// # Errors
/// With row and column: an unknown column, a missing file, a value that is refused. Rows before it are written.
pub fn run(arguments: &Arguments) -> Result<()> {
    let cases = Cases::read(&arguments.files.cases)?;
    columns::check(&cases)?;
    let path = arguments.files.output.as_deref();
    let mut table = output::table(path)?;
    let mut header_due = true;
    let progress = output::progress(cases.len(), path)?;
    let mut separations: HashMap<PathBuf, Vec<[f64; 2]>> = HashMap::new();
    for row in cases.rows() {
        let case = Case::read(&cases, &row)?;
        if !separations.contains_key(&case.separation) {
            let points = separation::read(&case.separation)
                .with_context(|| row.cell_place(case.separation_column))?;
            separations.insert(case.separation.clone(), points);
        }
        let planar = case.planar(&separations[&case.separation]);
        let (result, time) = timed(&planar).with_context(|| row.place())?;
        // Only now, so that a table that cannot be solved leaves nothing but its error.
        if std::mem::take(&mut header_due) {
            table.write_record(RESULTS)?;
        }
        table.write_record(cells(&result, time))?;
        progress.inc(1);
    }
    progress.finish_and_clear();
    Ok(table.flush()?)
}

/// The solution and the median time it took [s].
fn timed(case: &PlanarCase<'_>) -> Result<(PlanarResult, f64)> {
    let mut times = [0.0; REPEATS];
    let mut result = solve(case)?;
    for time in &mut times {
        let begin = Instant::now();
        result = std::hint::black_box(solve(std::hint::black_box(case))?);
        *time = begin.elapsed().as_secs_f64();
    }
    times.sort_by(f64::total_cmp);
    Ok((result, times[REPEATS / 2]))
}

fn cells(result: &PlanarResult, time: f64) -> [String; RESULTS.len()] {
    let number = |value: f64| format!("{value:?}");
    [
        number(result.normal_force),
        number(1e-6 * result.max_pressure),
        number(1e6 * result.area),
        number(1e3 * result.length),
        number(1e3 * result.width),
        number(result.fx),
        number(result.fy),
        number(1e3 * result.mz),
        result.patches.to_string(),
        // A number like all other columns.
        u8::from(result.fallback).to_string(),
        format!("{:.2}", 1e6 * time),
    ]
}
