//! Irregularities of both rails of a track over the station, as five columns of text.
//!
//! `station_m`, then the deviations `right_y_mm`, `right_z_mm`, `left_y_mm` and `left_z_mm` of the
//! rails from their design lines, y to the right and z down.

use std::path::PathBuf;

use crate::error::ContactError;
use crate::io::deviation_rows::DeviationRows;
use crate::io::named_file::parsed;

/// Irregularities are admitted as steep as the inputs of slopes are.
const ROWS: DeviationRows<5> = DeviationRows {
    columns: "the five columns station_m right_y_mm right_z_mm left_y_mm left_z_mm",
    unit: 1.0,
    most_slope: 0.1,
};

/// The points of the file that the parameter `parameter` names: an absolute path or one that is
/// looked for in `folders`. Of each of the four deviations the pairs of station and deviation [m],
/// in the order of the columns.
///
/// # Errors
/// The parameter, the file and what is wrong with it, with its line.
pub fn load_irregularities(
    parameter: &str,
    name: &str,
    folders: &[PathBuf],
) -> Result<[Vec<[f64; 2]>; 4], ContactError> {
    parsed(parameter, name, folders, points)
}

/// The points of a file.
fn points(content: &str) -> Result<[Vec<[f64; 2]>; 4], String> {
    let rows = ROWS.read(content)?;
    Ok([1, 2, 3, 4].map(|column| rows.iter().map(|row| [row[0], row[column]]).collect()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stations_are_metres_and_deviations_millimetres() {
        let text = "station_m,right_y_mm,right_z_mm,left_y_mm,left_z_mm\n# measured\n0,1,2,3,4\n1,2,2,3,4\n2 2 2 3 4\n3;2;2;3;4,0\n";
        let [right_y, _, left_y, left_z] = points(text).unwrap();
        assert_eq!(right_y[..2], [[0.0, 1e-3], [1.0, 2e-3]]);
        assert_eq!((left_y[3], left_z[3]), ([3.0, 3e-3], [3.0, 4e-3]));
    }

    #[test]
    fn what_is_wrong_is_named_with_its_line() {
        for (text, words) in [
            ("0 0 0 0 0\n1 0 0 0 101\n", "no steeper than 0.1 (line 2)"),
            (
                "0 0 0\n",
                "five columns station_m right_y_mm right_z_mm left_y_mm left_z_mm (line 1)",
            ),
        ] {
            let error = points(text).unwrap_err();
            assert!(error.contains(words), "{error}");
        }
    }
}
