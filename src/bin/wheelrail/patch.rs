//! `wheelrail patch`: planar contact problems, one for every row of a table.

mod columns;
mod separation;

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::{Context, Result};
use clap::Args;
use wheelrail::planar::{PlanarCase, PlanarResult, solve};

use crate::args::TableFiles;
use crate::batch;
use crate::cases::Cases;
use crate::output;

pub use columns::Case;

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
///   normal_model, shape_fit, tangential_model, strips, elements_along, points, bound, flexibilities
///                             names and start values as in the FMU (normal.model, …)
///   elements_across           with elements_along the boundary elements over the contact (40 by 40)
///
/// An empty cell is as if the column were left out. Lines that begin with # are comments. The column time_us of the
/// result is the time of one solution on this machine, the median of five; boundary elements are timed once, several cases at
/// once on all cores.
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
/// With row and column: an unknown column, a missing file, a value that is refused.
pub fn run(arguments: &Arguments) -> Result<()> {
    let cases = Cases::read(&arguments.files.cases)?;
    let path = arguments.files.output.as_deref();
    let planar = PlanarCases::read(&cases)?;
    let cases = arguments.files.cases.as_path();
    output::check_names(planar.separation_files().chain([cases]), [path])?;
    let table = output::table(path)?;
    let mut header_due = true;
    let progress = output::progress(Some(planar.cases.len()), path)?;
    // Times of fast models are those of a machine that does nothing else.
    let slow = planar.cases.iter().any(Case::is_slow);
    let result = batch::in_order(
        planar.cases.iter().map(Ok),
        if slow { batch::all_cores() } else { 1 },
        || (),
        |(), case| timed(&planar.planar(case), case.is_slow()).context(case.place.clone()),
        |(result, time)| {
            // Only now, so that a table that cannot be solved leaves nothing but its error.
            if std::mem::take(&mut header_due) {
                table.write_record(RESULTS)?;
            }
            table.write_record(cells(&result, time))?;
            progress.inc(1);
            Ok(())
        },
    );
    progress.finish_and_clear();
    table.complete(result)
}

/// All cases of a table with their separations.
pub struct PlanarCases {
    /// The cases in order.
    pub cases: Vec<Case>,
    separations: HashMap<PathBuf, Vec<[f64; 2]>>,
}

impl PlanarCases {
    /// Reads the cases and the files they name.
    ///
    /// # Errors
    /// With row and column: an unknown column, a missing file, a value that is refused.
    pub fn read(cases: &Cases) -> Result<Self> {
        columns::check(cases)?;
        let mut all = Self { cases: Vec::new(), separations: HashMap::new() };
        for row in cases.rows() {
            let case = Case::read(cases, row)?;
            if !all.separations.contains_key(&case.separation) {
                let points = separation::read(&case.separation)
                    .with_context(|| row.cell_place(case.separation_column))?;
                all.separations.insert(case.separation.clone(), points);
            }
            all.cases.push(case);
        }
        Ok(all)
    }

    /// The files of the separations.
    pub fn separation_files(&self) -> impl Iterator<Item = &Path> {
        self.separations.keys().map(PathBuf::as_path)
    }

    /// A case with the points of its separation.
    pub fn planar<'a>(&'a self, case: &Case) -> PlanarCase<'a> {
        case.planar(&self.separations[&case.separation])
    }
}

/// The solution and the time it took [s]: the median of five, that of the first where the models are `slow`.
///
/// # Errors
/// A value that is refused, a load that cannot be carried.
pub fn timed(case: &PlanarCase<'_>, slow: bool) -> Result<(PlanarResult, f64)> {
    let once = || -> Result<(PlanarResult, f64)> {
        let begin = Instant::now();
        let result = std::hint::black_box(solve(std::hint::black_box(case))?);
        Ok((result, begin.elapsed().as_secs_f64()))
    };
    let first = once()?;
    if slow {
        return Ok(first);
    }
    let mut times = [0.0; REPEATS];
    for time in &mut times {
        *time = once()?.1;
    }
    times.sort_by(f64::total_cmp);
    Ok((first.0, times[REPEATS / 2]))
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
