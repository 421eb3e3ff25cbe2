//! Outputs along a path of inputs.

use std::path::Path;

use anyhow::Result;
use plotters::prelude::*;

use super::axes::Axes;
use super::canvas::{Area, BLUE, GREEN, GREY, ORANGE, PURPLE, VERMILION, heading, px, text};
use super::panel::framed;
use super::{range_of, save};

/// Width of the figure and height of one panel; width of the legend beside the curves, and from one
/// of its lines to the next.
const SIZE: (u32, u32) = (1200, 380);
const LEGEND: (u32, u32) = (290, 20);
const COLOURS: [RGBColor; 6] = [BLUE, VERMILION, GREY, GREEN, ORANGE, PURPLE];

/// One output along the path.
pub struct Curve {
    /// Its FMU name, or what tells it from the others.
    pub name: String,
    /// Place on the path in rows from 1, and value.
    pub points: Vec<(f64, f64)>,
    /// Place and size, share of the largest value, of its largest jump.
    pub jump: Option<(f64, f64)>,
}

/// Draws panels with a title and up to six curves each into the file `path`; a dashed line stands
/// where a curve jumps.
pub fn draw(path: &Path, panels: &[(String, Vec<Curve>)]) -> Result<()> {
    let size = (SIZE.0, SIZE.1 * panels.len() as u32);
    save(path, size, |area| {
        for (cell, (title, curves)) in area.split_evenly((panels.len(), 1)).iter().zip(panels) {
            draw_panel(cell, title, curves)?;
        }
        Ok(())
    })
}

fn draw_panel(area: &Area<'_>, title: &str, curves: &[Curve]) -> Result<()> {
    let (area, legend) = area.split_horizontally(px(SIZE.0 - LEGEND.0));
    let points = || curves.iter().flat_map(|curve| &curve.points);
    let x = range_of(points().map(|point| point.0), 1e-9);
    let y = range_of(points().map(|point| point.1).chain([0.0]), 1e-9);
    let mut chart =
        framed(&area, [80, 46, 18]).caption(title, heading(17)).build_cartesian_2d(x, y.clone())?;
    let titles = ["Place on the path: row of the table", ""];
    Axes { titles, labels: [10, 8], size: 14 }.draw(&mut chart)?;
    for (line, (curve, colour)) in (2..).zip(curves.iter().zip(COLOURS.into_iter().cycle())) {
        if let Some((at, _)) = curve.jump {
            let dashes = DashedLineSeries::new(
                [(at, y.start), (at, y.end)],
                px(6) as i32,
                px(5) as i32,
                colour.mix(0.7).stroke_width(px(1)),
            );
            chart.draw_series(dashes)?;
        }
        let thick = colour.stroke_width(px(2));
        chart.draw_series(LineSeries::new(curve.points.iter().copied(), thick))?;
        let jump = curve.jump.map_or(String::new(), |(_, size)| format!(", jumps by {size:.1e}"));
        let (middle, height) = (px(LEGEND.1 * line) as i32, px(LEGEND.1 / 3) as i32);
        legend.draw(&PathElement::new([(0, middle), (px(22) as i32, middle)], thick))?;
        let name = format!("{}{jump}", curve.name);
        legend.draw(&Text::new(name, (px(30) as i32, middle - height), text(13)))?;
    }
    Ok(())
}
