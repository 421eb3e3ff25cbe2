//! Deviations of a rail over its station or of a wheel over its angle, as two columns of text.
//!
//! Rail: `station_m`, `height_mm` up positive; of a roller the station is the arc around it, less
//! than a turn from first to last. Wheel: `angle_deg`, `radius_mm` the deviation of the
//! radius; the angle by which the wheel has to roll forward from pitch 0 until it stands there,
//! less than a revolution from first to last.

use std::path::PathBuf;

use crate::error::ContactError;
use crate::io::deviation_rows::DeviationRows;
use crate::io::named_file::parsed;

/// Of which body a file of deviations is.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Deviations {
    /// A rail.
    Rail,
    /// A wheel of that nominal radius [m].
    Wheel {
        /// Nominal radius [m].
        radius: f64,
    },
    /// A roller whose highest point has that radius [m].
    Roller {
        /// Radius of the circle on which the stations are [m].
        radius: f64,
    },
}

/// Steepest deviations that are admitted [-].
const MAX_SLOPE: f64 = 0.3;

/// The points (coordinate, deviation) of the file that the parameter `parameter` names [m]: an
/// absolute path or one that is looked for in `folders`; of a wheel the coordinate is the arc of
/// its nominal rolling circle.
///
/// # Errors
/// The parameter, the file and what is wrong with it, with its line.
pub fn load_deviations(
    parameter: &str,
    name: &str,
    body: Deviations,
    folders: &[PathBuf],
) -> Result<Vec<[f64; 2]>, ContactError> {
    parsed(parameter, name, folders, |content| points(content, body))
}

/// The points of a file.
fn points(content: &str, body: Deviations) -> Result<Vec<[f64; 2]>, String> {
    let (columns, unit) = match body {
        Deviations::Rail | Deviations::Roller { .. } => {
            ("the two columns station_m height_mm", 1.0)
        }
        Deviations::Wheel { radius } => {
            ("the two columns angle_deg radius_mm", radius.to_radians())
        }
    };
    let mut points = DeviationRows { columns, unit, most_slope: MAX_SLOPE }.read(content)?;
    if let Deviations::Wheel { radius } | Deviations::Roller { radius } = body {
        let turn = std::f64::consts::TAU * radius;
        let (first, last) = (points[0], points[points.len() - 1]);
        let rest = turn - (last[0] - first[0]);
        if rest < -1e-6 {
            return Err(match body {
                Deviations::Wheel { .. } => "angles within one revolution".into(),
                _ => format!("stations within one turn of the roller, {turn:.6} m"),
            });
        }
        if rest <= 1e-6 {
            // The revolution is closed by its first point, said twice.
            points.pop();
        } else if (first[1] - last[1]).abs() > MAX_SLOPE * rest {
            return Err(format!("deviations no steeper than {MAX_SLOPE} from last to first line"));
        }
    }
    Ok(points)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn a_rail_has_stations_in_metres_and_heights_in_millimetres() {
        let text = "station_m,height_mm\n# measured\n0,0.0\n0.01,0.05\n0.02,0\n0.03,-0.05\n";
        let points = points(text, Deviations::Rail).unwrap();
        assert_eq!(points.len(), 4);
        assert_relative_eq!(points[1][0], 0.01);
        assert_relative_eq!(points[1][1], 5e-5);
    }

    #[test]
    fn a_wheel_has_angles_that_close_a_revolution() {
        let wheel = Deviations::Wheel { radius: 0.5 };
        let points = points("0 0\n90 0.1\n180 0\n270 -0.1\n360 0\n", wheel).unwrap();
        assert_eq!(points.len(), 4);
        assert_relative_eq!(points[2][0], std::f64::consts::PI * 0.5, max_relative = 1e-12);
    }
}
