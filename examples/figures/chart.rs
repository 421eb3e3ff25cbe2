//! Line charts as SVG, one under the other, for the figures.

use std::error::Error;
use std::path::Path;

pub use plotters::chart::SeriesLabelPosition as Corner;
use plotters::prelude::*;

use crate::canvas::{
    Area, BLUE, GREEN, GREY, GRID, VERMILION, heading, label, px, sign, style_axes, svg, text,
};

const COLOURS: [RGBColor; 4] = [BLUE, VERMILION, GREEN, GREY];
/// Width of all charts [pixels].
const WIDTH: u32 = 760;

/// Points that are drawn small if there are more.
const MANY: usize = 50;

/// A curve or, where `dots` is set, a set of points. A point that is not a number ends a stroke of
/// the curve.
pub struct Series {
    pub name: String,
    pub points: Vec<[f64; 2]>,
    pub dots: bool,
}

impl Series {
    /// A curve.
    pub fn line(name: impl Into<String>, points: Vec<[f64; 2]>) -> Self {
        Self { name: name.into(), points, dots: false }
    }

    /// Points.
    pub fn dots(name: impl Into<String>, points: Vec<[f64; 2]>) -> Self {
        Self { name: name.into(), points, dots: true }
    }
}

/// A chart with a title and named axes.
pub struct Chart {
    pub title: &'static str,
    pub x: &'static str,
    pub y: &'static str,
    /// Whether growing values of y go down.
    pub downwards: bool,
    /// The corner in which the legend stands.
    pub legend: Corner,
    /// Share of the range of x that is added at its right end for the legend, and a fifth of that
    /// at the left.
    pub legend_room: f64,
    /// Height [pixels].
    pub height: u32,
    pub series: Vec<Series>,
}

/// Draws `charts` one under the other into the file `path`.
pub fn save(path: impl AsRef<Path>, charts: &[Chart]) -> Result<(), Box<dyn Error>> {
    let height: u32 = charts.iter().map(|chart| chart.height).sum();
    let drawing = svg((WIDTH, height), |area| {
        let mut rest = area.clone();
        for chart in charts {
            let (own, below) = rest.split_vertically(px(chart.height));
            draw(&own, chart)?;
            rest = below;
        }
        Ok(())
    })?;
    Ok(std::fs::write(path, drawing)?)
}

fn draw(area: &Area<'_>, chart: &Chart) -> anyhow::Result<()> {
    let range = |k: usize| {
        let values = chart.series.iter().flat_map(|s| s.points.iter().map(|p| p[k]));
        let (low, high) =
            values.fold((f64::MAX, f64::MIN), |(low, high), v| (low.min(v), high.max(v)));
        let margins = if k == 0 { [0.2 * chart.legend_room, chart.legend_room] } else { [0.06; 2] };
        let [before, behind] = margins.map(|share| share * (high - low).max(1e-9));
        low - before..high + behind
    };
    let y = range(1);
    let y = if chart.downwards { y.end..y.start } else { y };
    let mut context = ChartBuilder::on(area)
        .caption(chart.title, heading(15))
        .margin(px(8))
        .x_label_area_size(px(40))
        .y_label_area_size(px(58))
        .build_cartesian_2d(range(0), y)?;
    let mut mesh = context.configure_mesh();
    style_axes(&mut mesh, 12);
    mesh.x_desc(chart.x)
        .y_desc(chart.y)
        .x_label_formatter(&label)
        .y_label_formatter(&label)
        .draw()?;
    for (series, colour) in chart.series.iter().zip(COLOURS.iter().cycle()) {
        let style = colour.stroke_width(px(2));
        let strokes = series.points.split(|p| p[0].is_nan());
        let strokes = strokes.map(|stroke| stroke.iter().map(|p| (p[0], p[1])).collect::<Vec<_>>());
        let drawn = if series.dots {
            let radius = if series.points.len() > MANY { px(2) } else { px(4) };
            let points = strokes.flatten();
            context.draw_series(points.map(|p| Circle::new(p, radius, colour.filled())))?
        } else {
            context.draw_series(strokes.map(|stroke| PathElement::new(stroke, style)))?
        };
        drawn.label(&series.name).legend(|at| sign(at, *colour));
    }
    if chart.series.len() > 1 {
        context
            .configure_series_labels()
            .position(chart.legend.clone())
            .margin(px(6))
            .legend_area_size(px(24))
            .background_style(WHITE.mix(0.85))
            .border_style(GRID)
            .label_font(text(12))
            .draw()?;
    }
    Ok(())
}
