//! Planar contact problems of a table, with the separations they name.

mod columns;
mod separation;
mod timed;

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use wheelrail::planar::{PlanarCase, PlanarResult};

pub use columns::Case;
pub use timed::timed;

use crate::cases::Cases;
use crate::output;

/// Force, size and number of contacts as cells of a result, with the names of their columns.
pub fn contact_cells(found: &PlanarResult) -> [(&'static str, String); 9] {
    let number = |value: f64| format!("{value:?}");
    [
        ("normal_force_n", number(found.normal_force)),
        ("max_pressure_mpa", number(1e-6 * found.max_pressure)),
        ("area_mm2", number(1e6 * found.area)),
        ("length_mm", number(1e3 * found.length)),
        ("width_mm", number(1e3 * found.width)),
        ("fx_n", number(found.fx)),
        ("fy_n", number(found.fy)),
        ("mz_nmm", number(1e3 * found.mz)),
        ("patches", found.patches.to_string()),
    ]
}

/// All cases of a table with their separations.
pub struct PlanarCases {
    /// The cases in order.
    pub cases: Vec<Case>,
    separations: HashMap<PathBuf, Vec<[f64; 2]>>,
}

impl PlanarCases {
    /// Reads the cases and the files they name, none of which is one of `results`.
    pub fn read(cases: &Cases, results: &[Option<&Path>]) -> Result<Self> {
        Self::read_with(cases, &[], results)
    }

    /// The same, with boundary elements where the table names no models, of a table with `others`
    /// among its columns.
    pub fn of_boundary_elements(
        cases: &Cases,
        others: &[&str],
        results: &[Option<&Path>],
    ) -> Result<Self> {
        let mut all = Self::read_with(cases, others, results)?;
        let [normal, tangential] =
            ["normal_model", "tangential_model"].map(|name| cases.column(name));
        for (case, row) in all.cases.iter_mut().zip(cases.rows()) {
            let open = |column: Option<usize>| column.and_then(|column| row.cell(column)).is_none();
            case.solve_by_boundary_elements(open(normal), open(tangential));
        }
        Ok(all)
    }

    fn read_with(cases: &Cases, others: &[&str], results: &[Option<&Path>]) -> Result<Self> {
        columns::check(cases, others)?;
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
        let files = all.separations.keys().map(PathBuf::as_path);
        output::check_names(files, results.iter().copied())?;
        Ok(all)
    }

    /// The case in row number `row`, from 1, and what it is called in titles.
    pub fn row(&self, row: usize) -> (PlanarCase<'_>, String) {
        let case = &self.cases[row - 1];
        let name = case.separation.file_name().unwrap_or(case.separation.as_os_str());
        (self.planar(case), format!("{}, row {row}", name.display()))
    }

    /// A case with the points of its separation.
    pub fn planar<'a>(&'a self, case: &Case) -> PlanarCase<'a> {
        case.planar(&self.separations[&case.separation])
    }
}
