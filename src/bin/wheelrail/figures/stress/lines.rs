//! Stresses along lines.

use anyhow::Result;
use plotters::prelude::*;

use crate::figures::axes::{Axes, legend};
use crate::figures::canvas::{Area, BLUE, GREEN, PURPLE, VERMILION, heading, px};
use crate::figures::range_of;

/// Draws `lines`, each with its name, over one axis.
pub fn draw_lines(
    area: &Area<'_>,
    title: &str,
    x_title: &str,
    lines: &[(&str, Vec<(f64, f64)>)],
    at: SeriesLabelPosition,
) -> Result<()> {
    let all = || lines.iter().flat_map(|(_, points)| points);
    let (start, end) =
        all().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), p| (a.min(p.0), b.max(p.0)));
    let range = range_of(all().map(|p| p.1), 1e-3);
    let mut chart = ChartBuilder::on(area)
        .caption(title, heading(14))
        .margin(px(6))
        .margin_right(px(20))
        .x_label_area_size(px(44))
        .y_label_area_size(px(66))
        .build_cartesian_2d(start..end, range)?;
    Axes { titles: [x_title, "stress over p0"], labels: [9, 7], size: 14 }.draw(&mut chart)?;
    for ((name, points), ink) in lines.iter().zip([VERMILION, BLUE, GREEN, PURPLE]) {
        let line = LineSeries::new(points.iter().copied(), ink.stroke_width(px(2)));
        chart.draw_series(line)?.label(*name).legend(move |(x, y)| {
            PathElement::new([(x, y), (x + px(18) as i32, y)], ink.stroke_width(px(3)))
        });
    }
    legend(&mut chart, at, 14)
}
