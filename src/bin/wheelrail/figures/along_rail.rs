//! A wheel along a rail whose section varies: its height, the loads it puts on the rails, and its
//! forces.

use std::path::Path;

use anyhow::Result;

use super::canvas::{Area, BLUE, GREEN, GREY, VERMILION, heading, px};
use super::motion::{Series, panel};
use super::{save, thinned};
use crate::wheelset::record::Record;

const SIZE: (u32, u32) = (1100, 1100);
/// Points of a curve at most; more are not seen.
const POINTS: usize = 2000;

/// Draws the figure of the right wheel, `half_axle` [m] from the middle of the axle, into the file
/// `path`, for a run from `station` on [m].
pub fn draw(
    path: &Path,
    title: &str,
    [station, half_axle]: [f64; 2],
    records: &[Record],
) -> Result<()> {
    save(path, SIZE, |area| draw_inner(area, title, [station, half_axle], records))
}

fn draw_inner(
    area: &Area<'_>,
    title: &str,
    [station, half_axle]: [f64; 2],
    records: &[Record],
) -> Result<()> {
    let area = area.titled(&format!("Right wheel: {title}"), heading(26))?;
    let (above, rest) = area.split_vertically(px(330));
    let (middle, below) = rest.split_vertically(px(330));
    let shown = thinned(records, POINTS);
    let over = |quantity: &dyn Fn(&Record) -> f64| -> Vec<(f64, f64)> {
        shown.iter().map(|r| (station + r.state.distance, quantity(r))).collect()
    };
    let line = |label, color, points| Series { label, color, dashed: false, points };
    let height = |r: &Record| r.state.z + half_axle * r.state.roll.sin();
    let first = records.first().map_or(0.0, height);
    let way = [line("wheel", BLUE, over(&|r| 1e3 * (first - height(r))))];
    panel(&above, "height of the wheel [mm], up", None, None, &way)?;
    let load = |rail: i32| {
        over(&|r| {
            let own = r.patches[0].iter().filter(|patch| patch.rail == rail);
            1e-3 * own.map(|patch| patch.normal_force).sum::<f64>()
        })
    };
    let mut loads = vec![line("rail 1", BLUE, load(1))];
    if records.iter().flat_map(|record| &record.patches[0]).any(|patch| patch.rail == 2) {
        loads.push(line("rail 2", VERMILION, load(2)));
    }
    panel(&middle, "normal force [kN]", None, None, &loads)?;
    let force = |k: usize| over(&|r| 1e-3 * r.wrenches[0].force[k]);
    let vertical = over(&|r| -1e-3 * r.wrenches[0].force[2]);
    let forces = [
        line("vertical, up", GREY, vertical),
        line("longitudinal", GREEN, force(0)),
        line("lateral, to the right", VERMILION, force(1)),
    ];
    panel(&below, "force on the wheel [kN]", Some("station [m]"), None, &forces)
}

#[cfg(test)]
mod tests {
    use wheelrail::element::output::Wrench;

    use super::*;
    use crate::wheelset::body::State;
    use crate::wheelset::record::Patch;

    fn record(distance: f64, rails: &[i32]) -> Record {
        let patch = |&rail: &i32| Patch { rail, normal_force: 5e4, ..Patch::default() };
        Record {
            time: distance,
            track_y: 0.0,
            state: State { distance, ..State::default() },
            wrenches: [Wrench::default(); 2],
            patches: [rails.iter().map(patch).collect(), Vec::new()],
        }
    }

    #[test]
    fn both_rails_are_drawn_over_the_station() {
        let folder = tempfile::tempdir().unwrap();
        let drawn = |records: &[Record]| {
            let path = folder.path().join("a.svg");
            draw(&path, "S1002 on a crossing", [-3.5, 0.75], records).unwrap();
            std::fs::read_to_string(path).unwrap()
        };
        let figure = drawn(&[record(0.0, &[1]), record(0.1, &[1, 2]), record(0.2, &[2])]);
        for part in ["station [m]", "rail 1", "rail 2", "-3.4"] {
            assert!(figure.contains(part), "{part}");
        }
        assert!(!drawn(&[record(0.0, &[1]), record(0.1, &[1])]).contains("rail 2"));
    }
}
