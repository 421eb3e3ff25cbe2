//! Planar contact problems of a table, with the separations they name.

mod columns;
mod separation;
mod timed;

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use wheelrail::planar::PlanarCase;

pub use columns::Case;
pub use separation::number;
pub use timed::timed;

use crate::cases::Cases;

/// All cases of a table with their separations.
pub struct PlanarCases {
    /// The cases in order.
    pub cases: Vec<Case>,
    separations: HashMap<PathBuf, Vec<[f64; 2]>>,
}

impl PlanarCases {
    /// Reads the cases and the files they name.
    pub fn read(cases: &Cases) -> Result<Self> {
        Self::read_with(cases, &[])
    }

    /// The same, with boundary elements where the table names no models, of a table with `others`
    /// among its columns.
    pub fn of_boundary_elements(cases: &Cases, others: &[&str]) -> Result<Self> {
        let mut all = Self::read_with(cases, others)?;
        let [normal, tangential] =
            ["normal_model", "tangential_model"].map(|name| cases.column(name));
        for (case, row) in all.cases.iter_mut().zip(cases.rows()) {
            let open = |column: Option<usize>| column.and_then(|column| row.cell(column)).is_none();
            case.solve_by_boundary_elements(open(normal), open(tangential));
        }
        Ok(all)
    }

    fn read_with(cases: &Cases, others: &[&str]) -> Result<Self> {
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
