//! Error of the energy over the communication step, both logarithmic.

use std::error::Error;

use plotters::prelude::*;

use super::scheme::Scheme;

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
// Colours told apart by colour-blind readers (Okabe and Ito 2008).
const COLOURS: [RGBColor; 5] = [
    RGBColor(213, 94, 0),
    RGBColor(230, 159, 0),
    RGBColor(204, 121, 167),
    RGBColor(0, 114, 178),
    RGBColor(0, 158, 115),
];
const INK: RGBColor = RGBColor(40, 40, 40);
const GRID: RGBColor = RGBColor(225, 225, 225);
const FONT: &str = "Helvetica, Arial, sans-serif";
/// Coordinates are whole numbers; with this many to a pixel curves are smooth.
const FINENESS: u32 = 8;
const SIZE: [u32; 2] = [760, 380];
/// Errors shown, as shares of the energy at the start.
const ERRORS: [f64; 2] = [1e-7, 10.0];

const fn px(pixels: u32) -> u32 {
    FINENESS * pixels
}

/// Draws one panel under the other into `file`: with damping, without.
pub fn save(file: &str, panels: &[Vec<Curve>; 2]) -> Result<(), Box<dyn Error>> {
    let [width, height] = [SIZE[0], 2 * SIZE[1]];
    let mut svg = String::new();
    {
        let area = SVGBackend::with_string(&mut svg, (px(width), px(height))).into_drawing_area();
        area.fill(&WHITE)?;
        for ((area, curves), title) in area.split_evenly((2, 1)).iter().zip(panels).zip(TITLES) {
            panel(area, curves, title)?;
        }
        area.present()?;
    }
    let size = |factor: u32| format!("width=\"{}\" height=\"{}\"", width * factor, height * factor);
    std::fs::write(file, svg.replacen(&size(FINENESS), &size(1), 1))?;
    Ok(())
}

fn panel(
    area: &DrawingArea<SVGBackend<'_>, plotters::coord::Shift>,
    curves: &[Curve],
    title: &str,
) -> Result<(), Box<dyn Error>> {
    let text = |size: u32| (FONT, px(size)).into_font().color(&INK);
    let steps = 1e-3..3.0;
    let mut chart = ChartBuilder::on(area)
        .caption(title, (FONT, px(15)).into_font().style(FontStyle::Bold).color(&INK))
        .margin(px(8))
        .x_label_area_size(px(40))
        .y_label_area_size(px(58))
        .build_cartesian_2d(steps.log_scale(), (ERRORS[0]..ERRORS[1]).log_scale())?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(GRID.stroke_width(FINENESS))
        .axis_style(INK.stroke_width(FINENESS))
        .label_style(text(12))
        .axis_desc_style(text(13))
        .x_desc("Communication step [ms]")
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
        let style = colour.stroke_width(width * FINENESS);
        chart.draw_series(LineSeries::new(points, style))?.label(curve.scheme.name()).legend(
            move |(x, y)| {
                let corner = (x + px(16) as i32, y + px(2) as i32);
                Rectangle::new([(x, y - px(2) as i32), corner], colour.filled())
            },
        );
        // Where swings begin to grow.
        if let Some(limit) = curve.limit.map(|limit| 1e3 * limit).filter(|limit| *limit > 1e-3) {
            let line = [(limit, ERRORS[0]), (limit, 10.0 * ERRORS[0])];
            chart.draw_series(LineSeries::new(line, colour.stroke_width(4 * FINENESS)))?;
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
