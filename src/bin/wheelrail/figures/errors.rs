//! Errors of fast models over a table of cases.

use std::path::Path;

use anyhow::Result;
use plotters::prelude::*;

use super::axes::Axes;
use super::canvas::{Area, BLUE, GREEN, ORANGE, PURPLE, SKY, VERMILION, heading, px, text};
use super::panel::framed;
use super::{range_of, save};

const SIZE: (u32, u32) = (1180, 790);
/// Height of a row of the legend, and how many names it holds.
const LEGEND: (u32, u32) = (24, 5);
const COLOURS: [RGBColor; 6] = [BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY];

/// Errors of normal force, pressure, area and creep force over an abscissa.
pub struct Line {
    /// What the line stands for.
    pub name: String,
    /// Abscissa and errors [%].
    pub points: Vec<(f64, [Option<f64>; 4])>,
}

const TITLES: [&str; 4] =
    ["Normal force [%]", "Greatest pressure [%]", "Area [%]", "Creep force [% of friction limit]"];

/// Draws the errors of `models` into the file `path`; `abscissa` names what they are drawn over.
pub fn draw(path: &Path, models: &str, abscissa: &str, lines: &[Line]) -> Result<()> {
    let named = if lines.len() > 1 { lines } else { &[] };
    let rows = (named.len() as u32).div_ceil(LEGEND.1);
    save(path, (SIZE.0, SIZE.1 + LEGEND.0 * rows), |area| {
        let title = format!("Errors of {models} against boundary elements");
        let area = area.titled(&title, heading(24))?;
        let (legend, area) = area.split_vertically(px(LEGEND.0 * rows));
        draw_legend(&legend, named)?;
        for (quantity, cell) in area.split_evenly((2, 2)).iter().enumerate() {
            draw_panel(cell, abscissa, lines, quantity)?;
        }
        Ok(())
    })
}

/// Names and colours of the lines, over all panels.
fn draw_legend(area: &Area<'_>, lines: &[Line]) -> Result<()> {
    let column = px(SIZE.0 / LEGEND.1) as i32;
    let count = (lines.len() as u32).min(LEGEND.1) as i32;
    let start = (px(SIZE.0) as i32 - count * column) / 2;
    for (index, line) in (0..).zip(lines) {
        let colour = COLOURS[index % COLOURS.len()];
        let place = [index as u32 % LEGEND.1, index as u32 / LEGEND.1];
        let x = start + place[0] as i32 * column + px(30) as i32;
        let y = px(LEGEND.0 * place[1] + LEGEND.0 / 2) as i32;
        let end = x + px(24) as i32;
        area.draw(&PathElement::new(vec![(x, y), (end, y)], colour.stroke_width(px(3))))?;
        let corner = (end + px(8) as i32, y - px(6) as i32);
        area.draw(&Text::new(line.name.as_str(), corner, text(15)))?;
    }
    Ok(())
}

fn draw_panel(area: &Area<'_>, abscissa: &str, lines: &[Line], quantity: usize) -> Result<()> {
    let points = || lines.iter().flat_map(|line| &line.points);
    let x = range_of(points().map(|point| point.0), 1e-9);
    // Zero is always seen.
    let values = points().filter_map(|point| point.1[quantity]).chain([0.0]);
    let mut chart = framed(area, [60, 46, 18])
        .caption(TITLES[quantity], heading(17))
        .build_cartesian_2d(x, range_of(values, 1.0))?;
    Axes { titles: [abscissa, ""], labels: [7, 7], size: 14 }.draw(&mut chart)?;
    for (index, line) in lines.iter().enumerate() {
        let colour = COLOURS[index % COLOURS.len()];
        let drawn = line.points.iter().filter_map(|(x, y)| Some((*x, y[quantity]?)));
        chart.draw_series(LineSeries::new(drawn.clone(), colour.stroke_width(px(2))))?;
        chart.draw_series(drawn.map(|point| Circle::new(point, px(3), colour.filled())))?;
    }
    Ok(())
}
