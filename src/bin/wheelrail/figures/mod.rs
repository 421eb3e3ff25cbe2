//! Figures of a run, as SVG; and the look they share.

pub mod motion;
pub mod patches;

use std::ops::Range;

use plotters::prelude::*;
use plotters::style::TextStyle;

use crate::wheelset::track::Track;

// Colours told apart by colour-blind readers (Okabe and Ito 2008).
const BLUE: RGBColor = RGBColor(0, 114, 178);
const VERMILION: RGBColor = RGBColor(213, 94, 0);
const GREY: RGBColor = RGBColor(110, 110, 110);
const INK: RGBColor = RGBColor(40, 40, 40);
const GRID: RGBColor = RGBColor(225, 225, 225);
const RAMP: RGBColor = RGBColor(240, 228, 190);

const FONT: &str = "Helvetica, Arial, sans-serif";

fn text(size: u32) -> TextStyle<'static> {
    (FONT, size).into_font().color(&INK)
}

fn heading(size: u32) -> TextStyle<'static> {
    (FONT, size, FontStyle::Bold).into_font().color(&INK)
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
    fn ranges_are_never_empty() {
        assert_eq!(range_of([].into_iter(), 2.0), -1.0..1.0);
        let range = range_of([3.0].into_iter(), 1.0);
        assert!(range.start < 3.0 && range.end > 3.0);
        let range = range_of([0.0, 10.0].into_iter(), 1.0);
        assert!(range.start < 0.0 && range.end > 10.0);
    }
}
