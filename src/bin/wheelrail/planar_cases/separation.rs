//! Files of separations.

use std::path::Path;

use anyhow::{Context, Result, bail};

use crate::cases::Cases;

/// Points fewer than these do not describe a surface.
const FEWEST_POINTS: usize = 5;

/// Reads the points (y, f) [m] of a file with columns `y_mm` and `f_mm`.
pub fn read(path: &Path) -> Result<Vec<[f64; 2]>> {
    let table = Cases::read(path)?;
    let column = |name: &str| {
        table.column(name).with_context(|| {
            format!("{} has no column {name}: it needs y_mm and f_mm", path.display())
        })
    };
    let (y, f) = (column("y_mm")?, column("f_mm")?);
    let mut points: Vec<[f64; 2]> = Vec::with_capacity(table.rows().len());
    for row in table.rows() {
        let point = [1e-3 * row.number(y)?, 1e-3 * row.number(f)?];
        if points.last().is_some_and(|last| point[0] <= last[0]) {
            bail!("{}: y must grow from row to row", row.cell_place(y));
        }
        points.push(point);
    }
    if points.len() < FEWEST_POINTS {
        bail!(
            "{} has {} points; at least {FEWEST_POINTS} are needed",
            path.display(),
            points.len()
        );
    }
    Ok(points)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read_text(text: &str) -> Result<Vec<[f64; 2]>> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("f.csv");
        std::fs::write(&path, text).unwrap();
        read(&path)
    }

    #[test]
    fn files_that_are_no_separation_are_refused() {
        let message = |text| format!("{:#}", read_text(text).unwrap_err());
        assert!(message("y,f\n1,2\n").contains("has no column y_mm"));
        assert!(message("y_mm,f_mm\n0,0\n1,1\n").contains("has 2 points"));
        let back = message("y_mm,f_mm\n0,0\n2,1\n1,1\n");
        assert!(back.contains("row 3 (line 4), column \"y_mm\": y must grow"), "{back}");
        let word = message("y_mm,f_mm\n0,0\n2,x\n");
        assert!(word.contains("column \"f_mm\": \"x\" is not a finite number"), "{word}");
    }
}
