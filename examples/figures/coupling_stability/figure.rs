//! Error of the energy over the communication step, both logarithmic.

use std::error::Error;

use plotters::prelude::*;

use super::scheme::Scheme;
use crate::canvas::{
    Area, BLUE, GREEN, GRID, ORANGE, PURPLE, VERMILION, heading, px, sign, style_axes, svg, text,
};

/// Errors of one scheme.
pub struct Curve {
    pub scheme: Scheme,
    /// Step [s] and error, as a share of the energy at the start.
    pub points: Vec<[f64; 2]>,
    /// Longest stable step, if there is one [s].
    pub limit: Option<f64>,
}

const TITLES: [&str; 2] = [
    "Normal damping of 1e5 N s/m: energy left after 20 ms, error",
    "Without damping: energy gained or lost in 20 ms",
];
const COLOURS: [RGBColor; 5] = [VERMILION, ORANGE, PURPLE, BLUE, GREEN];
const SIZE: [u32; 2] = [760, 380];
/// Errors shown, as shares of the energy at the start.
const ERRORS: [f64; 2] = [1e-7, 10.0];

/// Draws one panel under the other into `file`: with damping, without.
pub fn save(file: &str, panels: &[Vec<Curve>; 2]) -> Result<(), Box<dyn Error>> {
    let drawing = svg((SIZE[0], 2 * SIZE[1]), |area| {
        for ((area, curves), title) in area.split_evenly((2, 1)).iter().zip(panels).zip(TITLES) {
            panel(area, curves, title)?;
        }
        Ok(())
    })?;
    Ok(std::fs::write(file, drawing)?)
}

fn panel(area: &Area<'_>, curves: &[Curve], title: &str) -> anyhow::Result<()> {
    let steps = 1e-3..3.0;
    let mut chart = ChartBuilder::on(area)
        .caption(title, heading(15))
        .margin(px(8))
        .x_label_area_size(px(40))
        .y_label_area_size(px(58))
        .build_cartesian_2d(steps.log_scale(), (ERRORS[0]..ERRORS[1]).log_scale())?;
    let mut mesh = chart.configure_mesh();
    style_axes(&mut mesh, 12);
    mesh.x_desc("Communication step [ms]")
        .y_desc("Share of the energy at the start")
        .x_label_formatter(&|v| format!("{v}"))
        .y_label_formatter(&|v| format!("{v:.0e}"))
        .draw()?;
    for (curve, colour) in curves.iter().zip(COLOURS) {
        let inside = |p: &&[f64; 2]| p[1].is_finite() && p[1] < ERRORS[1];
        let points = curve.points.iter().take_while(inside);
        let points = points.map(|p| (1e3 * p[0], p[1].max(ERRORS[0])));
        // Where curves lie on each other the last one is the thinner.
        let width = if curve.scheme == Scheme::Linearised { 5 } else { 2 };
        let style = colour.stroke_width(px(width));
        let drawn = chart.draw_series(LineSeries::new(points, style))?;
        drawn.label(curve.scheme.name()).legend(move |at| sign(at, colour));
        // Where swings begin to grow.
        if let Some(limit) = curve.limit.map(|limit| 1e3 * limit).filter(|limit| *limit > 1e-3) {
            let line = [(limit, ERRORS[0]), (limit, 10.0 * ERRORS[0])];
            chart.draw_series(LineSeries::new(line, colour.stroke_width(px(4))))?;
        }
    }
    if title != TITLES[0] {
        return Ok(());
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperLeft)
        .margin(px(6))
        .legend_area_size(px(24))
        .background_style(WHITE.mix(0.85))
        .border_style(GRID)
        .label_font(text(12))
        .draw()?;
    Ok(())
}
