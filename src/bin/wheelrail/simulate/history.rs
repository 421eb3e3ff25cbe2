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
    table.write_record(header())?;
    records.iter().try_for_each(|record| table.write_record(row(record)))?;
    table.finish()
}

fn header() -> Vec<String> {
    let mut names: Vec<String> = [
        "time_s",
        "distance_m",
        "track_y_mm",
        "y_mm",
        "z_mm",
        "roll_mrad",
        "yaw_mrad",
        "pitch_rate_rad_s",
    ]
    .map(String::from)
    .into();
    for side in SIDES {
        for name in ["force_x_n", "force_y_n", "force_z_n"] {
            names.push(format!("{side}_{name}"));
        }
        for name in ["moment_x_nm", "moment_y_nm", "moment_z_nm", "patch_count"] {
            names.push(format!("{side}_{name}"));
        }
        for patch in 1..=LISTED_PATCHES {
            for name in [
                "normal_force_n",
                "contact_angle_deg",
                "rail_y_mm",
                "wheel_y_mm",
                "width_mm",
                "position_y_mm",
                "rolling_radius_mm",
            ] {
                names.push(format!("{side}_patch{patch}_{name}"));
            }
        }
    }
    names
}

fn row(record: &Record) -> Vec<String> {
    let state = &record.state;
    let mut cells: Vec<String> = [
        record.time,
        state.distance,
        1e3 * record.track_y,
        1e3 * state.y,
        1e3 * state.z,
        1e3 * state.roll,
        1e3 * state.yaw,
        state.pitch_rate,
    ]
    .map(significant)
    .into();
    for (wrench, patches) in record.wrenches.iter().zip(&record.patches) {
        cells.extend(wrench.force.map(significant));
        cells.extend(wrench.moment.map(significant));
        cells.push(patches.len().to_string());
        for index in 0..LISTED_PATCHES {
            let patch = patches.get(index);
            // A patch that does not exist leaves its cells empty: it is nowhere.
            cells.extend(patch.map_or_else(|| vec![String::new(); 7], patch_cells));
        }
    }
    cells
}

fn patch_cells(patch: &Patch) -> Vec<String> {
    vec![
        significant(patch.normal_force),
        significant(patch.contact_angle.to_degrees()),
        significant(1e3 * patch.rail_y),
        significant(1e3 * patch.wheel_y),
        significant(1e3 * patch.width),
        significant(1e3 * patch.position_y),
        significant(1e3 * patch.rolling_radius),
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
    use wheelrail::element::output::Wrench;

    use super::*;
    use crate::wheelset::body::State;

    #[test]
    fn every_row_has_as_many_cells_as_the_header() {
        let record = Record {
            time: 0.1,
            track_y: 0.0,
            state: State::default(),
            wrenches: [Wrench::default(); 2],
            patches: [vec![Patch::default(); 5], vec![]],
        };
        assert_eq!(row(&record).len(), header().len());
    }

    #[test]
    fn numbers_keep_nine_digits() {
        assert_eq!(significant(1.0 / 3.0), "0.333333333");
        assert_eq!(significant(-50_000.000_01), "-50000");
        assert_eq!(significant(1.23e-7), "1.23e-7");
        assert_eq!(significant(0.0), "0");
    }
}
