//! Line charts as SVG, one under the other, for the figures.

use std::error::Error;
use std::path::Path;

pub use plotters::chart::SeriesLabelPosition as Corner;
use plotters::prelude::*;

// Colours told apart by colour-blind readers (Okabe and Ito 2008).
const COLOURS: [RGBColor; 4] =
    [RGBColor(0, 114, 178), RGBColor(213, 94, 0), RGBColor(0, 158, 115), RGBColor(110, 110, 110)];
const INK: RGBColor = RGBColor(40, 40, 40);
const GRID: RGBColor = RGBColor(225, 225, 225);
const FONT: &str = "Helvetica, Arial, sans-serif";
/// Coordinates are whole numbers; with this many to a pixel curves are smooth.
const FINENESS: u32 = 8;
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

const fn px(pixels: u32) -> u32 {
    FINENESS * pixels
}

/// Draws `charts` one under the other into the file `path`.
pub fn save(path: impl AsRef<Path>, charts: &[Chart]) -> Result<(), Box<dyn Error>> {
    let height: u32 = charts.iter().map(|chart| chart.height).sum();
    let mut svg = String::new();
    {
        let area = SVGBackend::with_string(&mut svg, (px(WIDTH), px(height))).into_drawing_area();
        area.fill(&WHITE)?;
        let mut rest = area;
        for chart in charts {
            let (own, below) = rest.split_vertically(px(chart.height));
            draw(&own, chart)?;
            rest = below;
        }
        rest.present()?;
    }
    let dimensions =
        |factor: u32| format!("width=\"{}\" height=\"{}\"", WIDTH * factor, height * factor);
    std::fs::write(path, svg.replacen(&dimensions(FINENESS), &dimensions(1), 1))?;
    Ok(())
}

fn draw(
    area: &DrawingArea<SVGBackend<'_>, plotters::coord::Shift>,
    chart: &Chart,
) -> Result<(), Box<dyn Error>> {
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
    let text = |size: u32| (FONT, px(size)).into_font().color(&INK);
    let mut context = ChartBuilder::on(area)
        .caption(chart.title, (FONT, px(15)).into_font().style(FontStyle::Bold).color(&INK))
        .margin(px(8))
        .x_label_area_size(px(40))
        .y_label_area_size(px(58))
        .build_cartesian_2d(range(0), y)?;
    context
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(GRID.stroke_width(FINENESS))
        .axis_style(INK.stroke_width(FINENESS))
        .label_style(text(12))
        .axis_desc_style(text(13))
        .x_desc(chart.x)
        .y_desc(chart.y)
        .x_label_formatter(&label)
        .y_label_formatter(&label)
        .draw()?;
    for (series, colour) in chart.series.iter().zip(COLOURS.iter().cycle()) {
        let style = colour.stroke_width(2 * FINENESS);
        let strokes = series.points.split(|p| p[0].is_nan());
        let strokes = strokes.map(|stroke| stroke.iter().map(|p| (p[0], p[1])).collect::<Vec<_>>());
        let drawn = if series.dots {
            let radius = if series.points.len() > MANY { px(2) } else { px(4) };
            let points = strokes.flatten();
            context.draw_series(points.map(|p| Circle::new(p, radius, colour.filled())))?
        } else {
            context.draw_series(strokes.map(|stroke| PathElement::new(stroke, style)))?
        };
        drawn.label(&series.name).legend(move |(x, y)| {
            Rectangle::new(
                [(x, y - px(2) as i32), (x + px(16) as i32, y + px(2) as i32)],
                colour.filled(),
            )
        });
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

#[allow(clippy::trivially_copy_pass_by_ref)] // The signature of plotters' formatters.
fn label(value: &f64) -> String {
    ((value * 1e6).round() / 1e6 + 0.0).to_string()
}
