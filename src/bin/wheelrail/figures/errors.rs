//! Errors of fast models over a table of cases.

use std::path::Path;

use anyhow::Result;
use plotters::prelude::*;

use super::axes::Axes;
use super::{Area, GRID, heading, px, range_of, save, text};

const SIZE: (u32, u32) = (1180, 760);

/// Told apart by colour-blind readers (Okabe and Ito 2008).
const COLOURS: [RGBColor; 6] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
];

/// Errors of normal force, pressure, area and creep force over an abscissa.
pub struct Line {
    /// What the line stands for.
    pub name: String,
    /// Abscissa and errors [%].
    pub points: Vec<(f64, [Option<f64>; 4])>,
}

const TITLES: [&str; 4] =
    ["Normal force [%]", "Greatest pressure [%]", "Area [%]", "Creep force [% of friction limit]"];

/// Draws the errors into the file `path`; `abscissa` names what they are drawn over.
///
/// # Errors
/// If it cannot be written.
pub fn draw(path: &Path, abscissa: &str, lines: &[Line]) -> Result<()> {
    save(path, SIZE, |area| {
        let area = area.titled("Errors against boundary elements", heading(24))?;
        for (quantity, cell) in area.split_evenly((2, 2)).iter().enumerate() {
            draw_panel(cell, abscissa, lines, quantity)?;
        }
        Ok(())
    })
}

fn draw_panel(area: &Area<'_>, abscissa: &str, lines: &[Line], quantity: usize) -> Result<()> {
    let points = || lines.iter().flat_map(|line| &line.points);
    let x = range_of(points().map(|point| point.0), 1e-9);
    // Zero is always seen.
    let values = points().filter_map(|point| point.1[quantity]).chain([0.0]);
    let mut chart = ChartBuilder::on(area)
        .caption(TITLES[quantity], heading(17))
        .margin(px(8))
        .margin_right(px(18))
        .x_label_area_size(px(46))
        .y_label_area_size(px(60))
        .build_cartesian_2d(x, range_of(values, 1.0))?;
    Axes { titles: [abscissa, ""], labels: [7, 7], size: 14 }.draw(&mut chart)?;
    for (index, line) in lines.iter().enumerate() {
        let colour = COLOURS[index % COLOURS.len()];
        let drawn = line.points.iter().filter_map(|(x, y)| Some((*x, y[quantity]?)));
        chart
            .draw_series(LineSeries::new(drawn.clone(), colour.stroke_width(px(2))))?
            .label(&line.name)
            .legend(move |(x, y)| {
                let ends = vec![(x, y), (x + px(22) as i32, y)];
                PathElement::new(ends, colour.stroke_width(px(2)))
            });
        chart.draw_series(drawn.map(|point| Circle::new(point, px(3), colour.filled())))?;
    }
    if quantity == 0 && lines.len() > 1 {
        chart
            .configure_series_labels()
            .legend_area_size(px(28))
            .label_font(text(14))
            .background_style(WHITE.mix(0.8))
            .border_style(GRID)
            .draw()?;
    }
    Ok(())
}
