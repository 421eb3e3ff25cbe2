//! `wheelrail patch`: planar contact problems, one for every row of a table.

use anyhow::{Context, Result};
use clap::Args;
use wheelrail::planar::PlanarResult;

use crate::batch;
use crate::cases::Cases;
use crate::options::TableFiles;
use crate::output;
use crate::planar_cases::{Case, PlanarCases, contact_cells, timed};

/// Solve planar contact problems, one for every row of a table
///
/// A planar problem is the separation f(y) of two bodies across the rolling direction, a rolling
/// radius along it, and an approach or a load. Forces and moment act on the upper body, the wheel;
/// x is forward, y to the right; the moment is about the origin of the separation file.
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
///   elements_across           with elements_along the boundary elements over the contact (40 by 40)
///
/// An empty cell is as if the column were left out. Lines that begin with # are comments. The
/// column time_us of the result is the time of one solution on this machine, the median of five;
/// boundary elements are timed once, several cases at once on all cores.
#[derive(Args, Debug)]
#[command(verbatim_doc_comment)]
pub struct Arguments {
    /// Where the cases come from and the results go.
    #[command(flatten)]
    pub files: TableFiles,
}

/// Solves all rows.
pub fn run(arguments: &Arguments) -> Result<()> {
    let cases = Cases::read(&arguments.files.cases)?;
    let path = arguments.files.output.as_deref();
    output::check_names([arguments.files.cases.as_path()], [path])?;
    let planar = PlanarCases::read(&cases, &[path])?;
    let table = output::table(path)?;
    let progress = output::progress(Some(planar.cases.len()), path)?;
    // Times of fast models are those of a machine that does nothing else.
    let slow = planar.cases.iter().any(Case::is_slow);
    let result = batch::in_order(
        &progress,
        planar.cases.iter().map(Ok),
        if slow { batch::all_cores() } else { 1 },
        || (),
        |(), case| timed(&planar.planar(case), case.is_slow()).context(case.place.clone()),
        |(result, time)| table.write_named(&cells(&result, time)),
    );
    table.complete(result)
}

fn cells(result: &PlanarResult, time: f64) -> Vec<(&'static str, String)> {
    // A fallback is a number like all other columns.
    let fallback = ("fallback", u8::from(result.fallback).to_string());
    let time = ("time_us", format!("{:.2}", 1e6 * time));
    contact_cells(result).into_iter().chain([fallback, time]).collect()
}
