//! Planar contact problems of a table, with the separations they name.

mod columns;
mod separation;
mod timed;

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use wheelrail::planar::PlanarCase;

pub use columns::Case;
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
