//! Figures of a run, as SVG; and the look they share.

pub mod along_rail;
mod axes;
mod canvas;
pub mod conicity;
pub mod contact;
mod contours;
pub mod errors;
pub mod fatigue;
pub mod fit;
pub mod icon;
pub mod motion;
mod panel;
mod patch_panel;
pub mod patches;
pub mod roots;
pub mod stress;
pub mod sweep;
pub mod wear;

use std::ops::Range;
use std::path::Path;

use anyhow::{Context, Result};

use self::canvas::{Area, px};
use crate::output;
use crate::wheelset::track::Track;

/// Draws into the file `path`, `size` pixels wide and high.
fn save(path: &Path, size: (u32, u32), draw: impl FnOnce(&Area<'_>) -> Result<()>) -> Result<()> {
    let svg = canvas::svg(size, |area| draw(&area.margin(px(8), 0, 0, 0)))
        .with_context(|| format!("cannot draw {}", path.display()))?;
    output::write(path, svg.as_bytes())
}

/// Every few of `all`, about `most` of them, and the last one.
fn thinned<T>(all: &[T], most: usize) -> Vec<&T> {
    let every = all.len().div_ceil(most).max(1);
    let mut shown: Vec<&T> = all.iter().step_by(every).collect();
    if all.len() % every != 1 % every {
        shown.extend(all.last());
    }
    shown
}

/// The stretch of distance that holds the ramp, cut to what is drawn.
fn ramp_stretch(track: &Track, drawn: &Range<f64>) -> Range<f64> {
    let end = track.ramp_start + track.ramp_length;
    track.ramp_start.clamp(drawn.start, drawn.end)..end.clamp(drawn.start, drawn.end)
}

/// Range of `values` widened by a margin, never empty; `least` is its smallest width.
fn range_of(values: impl Iterator<Item = f64>, least: f64) -> Range<f64> {
    let (low, high) = values
        .filter(|value| value.is_finite())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
    if low > high {
        return -0.5 * least..0.5 * least;
    }
    let missing = (least - (high - low)).max(0.0);
    let margin = 0.08 * (high - low) + 0.5 * missing;
    low - margin..high + margin
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_one_is_shown_once() {
        let numbers = [0, 1, 2, 3, 4, 5];
        assert_eq!(thinned(&numbers, 9), [&0, &1, &2, &3, &4, &5]);
        assert_eq!(thinned(&numbers, 3), [&0, &2, &4, &5]);
        assert_eq!(thinned(&numbers[..5], 3), [&0, &2, &4]);
        assert!(thinned::<u8>(&[], 3).is_empty());
    }

    #[test]
    fn ranges_are_never_empty() {
        assert_eq!(range_of([].into_iter(), 2.0), -1.0..1.0);
        let range = range_of([3.0].into_iter(), 1.0);
        assert!(range.start < 3.0 && range.end > 3.0);
        let range = range_of([0.0, 10.0].into_iter(), 1.0);
        assert!(range.start < 0.0 && range.end > 10.0);
    }
}

#[cfg(test)]
mod drawing {
    use wheelrail::element::output::Wrench;

    use super::*;
    use crate::wheelset::body::State;
    use crate::wheelset::record::{Patch, Record};
    use crate::wheelset::track::RampShape;

    #[test]
    fn a_run_is_drawn_with_titles_axes_and_bands() {
        let track =
            Track { ramp_start: 5.0, ramp_length: 1.0, ramp: 0.005, shape: RampShape::Linear };
        let records: Vec<Record> = (0..2000).map(|i| record(&track, 0.03 * f64::from(i))).collect();
        let folder = tempfile::tempdir().unwrap();
        let read = |name| std::fs::read_to_string(folder.path().join(name)).unwrap();
        motion::draw(&folder.path().join("m.svg"), "S1002 on 60E1", &track, &records).unwrap();
        patches::draw(&folder.path().join("p.svg"), "S1002 on 60E1", &track, &records).unwrap();
        let (motion, patches) = (read("m.svg"), read("p.svg"));
        assert!(motion.contains("Wheelset: S1002 on 60E1") && motion.contains("distance [m]"));
        assert!(patches.contains("Left rail head") && patches.contains("Right wheel"));
        assert!(patches.matches("<rect").count() > 1000, "bands are missing");
    }

    fn record(track: &Track, distance: f64) -> Record {
        let behind = (distance - 5.5).max(0.0);
        let wave = (-0.05 * behind).exp() * (0.7 * behind).cos();
        let track_y = track.lateral(distance).position;
        let y = if behind > 0.0 { 0.005 - 0.005 * wave } else { 0.0 };
        let patch = |sign: f64| Patch {
            normal_force: 5e4 + sign * 1e7 * (y - track_y),
            rail_y: -0.002 + sign * 4.0 * (y - track_y),
            wheel_y: 0.001 + sign * 5.0 * (y - track_y),
            width: 0.012,
            ..Patch::default()
        };
        Record {
            time: distance / 15.0,
            track_y,
            state: State { distance, y, yaw: 0.003 * wave, ..State::default() },
            wrenches: [Wrench::default(); 2],
            patches: [vec![patch(1.0)], vec![patch(-1.0)]],
        }
    }
}
