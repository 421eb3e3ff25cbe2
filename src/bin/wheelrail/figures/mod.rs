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
pub mod patch_panel;
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
