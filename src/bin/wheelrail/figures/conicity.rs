//! Rolling radius difference over displacement and equivalent conicity over amplitude.

use std::path::Path;

use anyhow::Result;
use plotters::prelude::*;

use super::axes::Axes;
use super::canvas::{Area, BLUE, VERMILION, heading, px};
use super::panel::framed;
use super::{range_of, save};

const SIZE: (u32, u32) = (1100, 480);

/// Draws the points (y, Δr) [m] and (amplitude [m], conicity) into the file `path`.
pub fn draw(
    path: &Path,
    title: &str,
    difference: &[[f64; 2]],
    conicity: &[[f64; 2]],
) -> Result<()> {
    save(path, SIZE, |area| {
        let area = area.titled(&format!("Rolling radii of a wheelset: {title}"), heading(26))?;
        let (left, right) = area.split_horizontally(px(SIZE.0 / 2));
        let scaled = |points: &[[f64; 2]], scale: f64| -> Vec<(f64, f64)> {
            points.iter().map(|p| (1e3 * p[0], scale * p[1])).collect()
        };
        let titles = ["lateral displacement [mm]", "rolling radius difference [mm]"];
        panel(&left, titles, BLUE, false, scaled(difference, 1e3))?;
        let titles = ["amplitude [mm]", "equivalent conicity tan γe [-]"];
        panel(&right, titles, VERMILION, true, scaled(conicity, 1.0))
    })
}

fn panel(
    area: &Area<'_>,
    [x_title, y_title]: [&str; 2],
    color: RGBColor,
    from_zero: bool,
    points: Vec<(f64, f64)>,
) -> Result<()> {
    let last = points.last().map_or(1.0, |p| p.0);
    let first = if from_zero { 0.0 } else { points.first().map_or(-1.0, |p| p.0) };
    let mut y_range = range_of(points.iter().map(|p| p.1), 0.02);
    if from_zero {
        y_range.start = 0.0;
    }
    let mut chart =
        framed(area, [78, 52, 24]).build_cartesian_2d(first..last.max(first + 1e-3), y_range)?;
    Axes { titles: [x_title, y_title], labels: [9, 8], size: 17 }.draw(&mut chart)?;
    chart.draw_series(LineSeries::new(points, color.stroke_width(px(3))))?;
    Ok(())
}
