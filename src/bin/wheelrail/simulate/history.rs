//! What is kept of a run.

use std::path::Path;

use anyhow::Result;

use crate::output;
use crate::wheelset::record::{Patch, Record, SIDES};

/// Patches of each wheel that get columns of their own, heaviest first.
const LISTED_PATCHES: usize = 3;

/// Writes `records` as a table with units in the header.
pub fn write(path: &Path, records: &[Record]) -> Result<()> {
    let table = output::table(Some(path))?;
    records.iter().try_for_each(|record| table.write_named(&row(record)))?;
    table.finish()
}

/// The cells of a row with the names of their columns.
fn row(record: &Record) -> Vec<(String, String)> {
    let state = &record.state;
    let mut cells: Vec<(String, String)> = [
        ("time_s", record.time),
        ("distance_m", state.distance),
        ("track_y_mm", 1e3 * record.track_y),
        ("y_mm", 1e3 * state.y),
        ("z_mm", 1e3 * state.z),
        ("roll_mrad", 1e3 * state.roll),
        ("yaw_mrad", 1e3 * state.yaw),
        ("pitch_rate_rad_s", state.pitch_rate),
    ]
    .map(|(name, value)| (name.to_owned(), significant(value)))
    .into();
    for ((side, wrench), patches) in SIDES.iter().zip(&record.wrenches).zip(&record.patches) {
        for (of, unit, vector) in [("force", "n", wrench.force), ("moment", "nm", wrench.moment)] {
            let axes = ["x", "y", "z"].into_iter().zip(vector);
            cells.extend(
                axes.map(|(axis, value)| {
                    (format!("{side}_{of}_{axis}_{unit}"), significant(value))
                }),
            );
        }
        cells.push((format!("{side}_patch_count"), patches.len().to_string()));
        for index in 0..LISTED_PATCHES {
            let number = index + 1;
            // A patch that does not exist leaves its cells empty: it is nowhere.
            let text =
                |value| if index < patches.len() { significant(value) } else { String::new() };
            let patch = patches.get(index).copied().unwrap_or_default();
            cells.extend(
                of_patch(&patch)
                    .map(|(name, value)| (format!("{side}_patch{number}_{name}"), text(value))),
            );
        }
    }
    cells
}

fn of_patch(patch: &Patch) -> [(&'static str, f64); 7] {
    [
        ("normal_force_n", patch.normal_force),
        ("contact_angle_deg", patch.contact_angle.to_degrees()),
        ("rail_y_mm", 1e3 * patch.rail_y),
        ("wheel_y_mm", 1e3 * patch.wheel_y),
        ("width_mm", 1e3 * patch.width),
        ("position_y_mm", 1e3 * patch.position_y),
        ("rolling_radius_mm", 1e3 * patch.rolling_radius),
    ]
}

/// Nine significant digits, without an exponent where that is shorter.
fn significant(value: f64) -> String {
    let rounded: f64 = format!("{value:.8e}").parse().unwrap_or(value);
    if rounded != 0.0 && rounded.abs() < 1e-4 {
        format!("{rounded:e}")
    } else {
        rounded.to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_nine_digits() {
        assert_eq!(significant(1.0 / 3.0), "0.333333333");
        assert_eq!(significant(-50_000.000_01), "-50000");
        assert_eq!(significant(1.23e-7), "1.23e-7");
        assert_eq!(significant(0.0), "0");
    }
}
