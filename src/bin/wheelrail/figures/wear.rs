//! Profiles before and after, and the wear depth between them.

use std::path::Path;

use anyhow::Result;
use plotters::prelude::*;

use super::axes::{Axes, legend};
use super::canvas::{Area, BLUE, VERMILION, heading, px};
use super::panel::framed;
use super::{range_of, save};

/// Width of one body's column and height of the figure [pixels].
const COLUMN: u32 = 640;
const HEIGHT: u32 = 640;

/// One body: what is drawn of it, in millimetres.
pub struct WornBody {
    /// What it is.
    pub title: String,
    /// Names of the two profiles.
    pub names: [String; 2],
    /// Their points (y, z).
    pub profiles: [Vec<(f64, f64)>; 2],
    /// Wear depth over y of the unworn profile.
    pub depth: Vec<(f64, f64)>,
}

/// Draws the bodies side by side into the file `path`.
pub fn draw(path: &Path, bodies: &[WornBody]) -> Result<()> {
    save(path, (COLUMN * bodies.len() as u32, HEIGHT), |area| {
        for (area, body) in area.split_evenly((1, bodies.len())).iter().zip(bodies) {
            let area = area.titled(&body.title, heading(22))?;
            let (above, below) = area.split_vertically(px(HEIGHT / 2));
            let lines: Vec<_> =
                body.names.iter().zip(&body.profiles).map(|(n, p)| (n.as_str(), p)).collect();
            panel(&above, "z [mm]", true, &lines)?;
            panel(&below, "wear depth [mm]", false, &[("", &body.depth)])?;
        }
        Ok(())
    })
}

fn panel(
    area: &Area<'_>,
    y_title: &str,
    is_down: bool,
    lines: &[(&str, &Vec<(f64, f64)>)],
) -> Result<()> {
    let all = || lines.iter().flat_map(|(_, points)| points.iter());
    let (x, y) = (range_of(all().map(|p| p.0), 1.0), range_of(all().map(|p| p.1), 1e-6));
    let y = if is_down { y.end..y.start } else { y };
    let mut chart = framed(area, [86, 52, 24]).build_cartesian_2d(x, y)?;
    Axes { titles: ["y [mm]", y_title], labels: [10, 10], size: 15 }.draw(&mut chart)?;
    for ((name, points), color) in lines.iter().zip([BLUE, VERMILION]) {
        let line = LineSeries::new(points.iter().copied(), color.stroke_width(px(2)));
        let drawn = chart.draw_series(line)?;
        if !name.is_empty() {
            drawn.label(*name).legend(move |(x, y)| {
                PathElement::new([(x, y), (x + px(18) as i32, y)], color.stroke_width(px(3)))
            });
        }
    }
    if lines.len() > 1 {
        legend(&mut chart, SeriesLabelPosition::UpperRight, 15)?;
    }
    Ok(())
}
