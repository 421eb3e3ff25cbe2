//! Rows of a file of deviations: a coordinate that grows, and what a body deviates there.
//!
//! Columns are separated by blanks, tabs, commas or semicolons; what follows `#` or `!` is a
//! comment; one line of headings may stand first.

use crate::io::table::{Line, numbers, rows as rows_of};

/// What the rows of a file of deviations have to be; the first column is the coordinate, the others
/// are deviations in millimetres.
#[derive(Clone, Copy, Debug)]
pub(super) struct DeviationRows<const COLUMNS: usize> {
    /// The columns, in words: "the two columns station_m height_mm".
    pub columns: &'static str,
    /// Unit of the coordinate [m].
    pub unit: f64,
    /// Steepest deviations that are admitted [-].
    pub most_slope: f64,
}

/// Shortest step of the coordinate [m].
const MIN_STEP: f64 = 1e-6;
/// Fewest rows that a twice differentiable line goes through.
const FEWEST: usize = 4;

impl<const COLUMNS: usize> DeviationRows<COLUMNS> {
    /// The rows of a file [m]; or what they should be, with the line.
    pub fn read(&self, content: &str) -> Result<Vec<[f64; COLUMNS]>, String> {
        let Self { columns, unit, most_slope } = *self;
        let mut rows: Vec<[f64; COLUMNS]> = Vec::new();
        let mut is_first = true;
        for Line { number, text } in rows_of(content) {
            let may_be_headings = std::mem::take(&mut is_first);
            let Some(found) = numbers(text) else {
                if may_be_headings {
                    continue;
                }
                return Err(format!("numbers in {columns} (line {number})"));
            };
            let Ok(mut row) = <[f64; COLUMNS]>::try_from(found) else {
                return Err(format!("{columns} (line {number})"));
            };
            for (column, value) in row.iter_mut().enumerate() {
                *value *= if column == 0 { unit } else { 1e-3 };
            }
            if row.iter().any(|value| !value.is_finite()) {
                return Err(format!("finite numbers (line {number})"));
            }
            if let Some(last) = rows.last() {
                let step = row[0] - last[0];
                if step <= MIN_STEP {
                    return Err(format!(
                        "a first column that grows by a micrometre or more from line to line (line {number})"
                    ));
                }
                let is_steep = |(now, last): (&f64, &f64)| (now - last).abs() > most_slope * step;
                if row[1..].iter().zip(&last[1..]).any(is_steep) {
                    return Err(format!("deviations no steeper than {most_slope} (line {number})"));
                }
            }
            rows.push(row);
        }
        if rows.len() < FEWEST {
            return Err(format!("at least four lines with {columns}"));
        }
        Ok(rows)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ROWS: DeviationRows<3> =
        DeviationRows { columns: "the three columns s_m y_mm z_mm", unit: 1.0, most_slope: 0.2 };

    #[test]
    fn coordinates_have_their_unit_and_deviations_are_millimetres() {
        let text = "s_m,y_mm,z_mm\n# measured\n\n0,1,2\n1,2,3\n2 3 4 ! by hand\n3;4;5,5\n";
        let rows = DeviationRows { unit: 0.5, ..ROWS }.read(text).unwrap();
        assert_eq!(rows[1..], [[0.5, 2e-3, 3e-3], [1.0, 3e-3, 4e-3], [1.5, 4e-3, 5.5e-3]]);
    }
}
