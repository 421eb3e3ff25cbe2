//! Lateral displacement and yaw of the wheelset over the distance run.

use std::path::Path;

use anyhow::{Context, Result};
use plotters::coord::Shift;
use plotters::prelude::*;

use super::{BLUE, GREY, GRID, INK, RAMP, VERMILION, heading, label, ramp_stretch, range_of, text};
use crate::simulate::Record;
use crate::wheelset::track::Track;

const SIZE: (u32, u32) = (1100, 760);
/// Points of a curve at most: coordinates are whole pixels, and closer points look like stairs.
const POINTS: usize = 500;

/// One curve of a panel.
struct Series<'a> {
    label: &'a str,
    color: RGBColor,
    dashed: bool,
    points: Vec<(f64, f64)>,
}

/// Draws the figure into the file `path`.
///
/// # Errors
/// If it cannot be written.
pub fn draw(path: &Path, title: &str, track: &Track, records: &[Record]) -> Result<()> {
    draw_inner(path, title, track, records)
        .with_context(|| format!("cannot draw {}", path.display()))
}

fn draw_inner(path: &Path, title: &str, track: &Track, records: &[Record]) -> Result<()> {
    let area = SVGBackend::new(path, SIZE).into_drawing_area();
    area.fill(&WHITE)?;
    let area = area.titled(&format!("Wheelset: {title}"), heading(26))?;
    let (above, below) = area.split_vertically(372);
    let over = |quantity: fn(&Record) -> f64| -> Vec<(f64, f64)> {
        let shown = records.iter().step_by(records.len().div_ceil(POINTS));
        shown.map(|r| (r.state.distance, quantity(r))).collect()
    };
    let lateral = [
        Series {
            label: "track centre line",
            color: GREY,
            dashed: true,
            points: over(|r| 1e3 * r.track_y),
        },
        Series { label: "wheelset", color: BLUE, dashed: false, points: over(|r| 1e3 * r.state.y) },
    ];
    panel(&above, "lateral displacement [mm], to the right", None, track, &lateral)?;
    let yaw = [Series {
        label: "wheelset",
        color: VERMILION,
        dashed: false,
        points: over(|r| 1e3 * r.state.yaw),
    }];
    panel(&below, "yaw [mrad], nose to the right", Some("distance [m]"), track, &yaw)?;
    area.present()?;
    Ok(())
}

fn panel(
    area: &DrawingArea<SVGBackend<'_>, Shift>,
    y_title: &str,
    x_title: Option<&str>,
    track: &Track,
    series: &[Series<'_>],
) -> Result<()> {
    let distances = series[0].points.iter().map(|point| point.0);
    let (x_start, x_end) = (distances.clone().fold(0.0, f64::min), distances.fold(1e-3, f64::max));
    let x_range = x_start..x_end;
    let values = series.iter().flat_map(|s| s.points.iter().map(|point| point.1));
    let y_range = range_of(values, 0.1);
    let mut chart = ChartBuilder::on(area)
        .margin(8)
        .margin_right(24)
        .x_label_area_size(if x_title.is_some() { 52 } else { 28 })
        .y_label_area_size(78)
        .build_cartesian_2d(x_range.clone(), y_range.clone())?;
    let ramp = ramp_stretch(track, &x_range);
    let corners = [(ramp.start, y_range.start), (ramp.end, y_range.end)];
    if ramp.start < ramp.end {
        chart
            .draw_series(std::iter::once(Rectangle::new(corners, RAMP.filled())))?
            .label("ramp")
            .legend(|(x, y)| Rectangle::new([(x, y - 6), (x + 26, y + 6)], RAMP.filled()));
    }
    let mut mesh = chart.configure_mesh();
    mesh.bold_line_style(GRID)
        .light_line_style(TRANSPARENT)
        .axis_style(INK)
        .x_labels(13)
        .y_labels(7)
        .x_label_formatter(&label)
        .y_label_formatter(&label)
        .label_style(text(17))
        .axis_desc_style(text(19))
        .y_desc(y_title);
    if let Some(x_title) = x_title {
        mesh.x_desc(x_title);
    }
    mesh.draw()?;
    for one in series {
        let style = one.color.stroke_width(if one.dashed { 2 } else { 3 });
        let points = one.points.iter().copied();
        let drawn = if one.dashed {
            chart.draw_series(DashedLineSeries::new(points, 9, 5, style))?
        } else {
            chart.draw_series(LineSeries::new(points, style))?
        };
        let dashed = one.dashed;
        drawn.label(one.label).legend(move |(x, y)| {
            let end = if dashed { x + 11 } else { x + 26 };
            let first = PathElement::new(vec![(x, y), (end, y)], style);
            let second = PathElement::new(vec![(x + 15, y), (x + 26, y)], style);
            EmptyElement::at((0, 0)) + first + second
        });
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .background_style(WHITE.mix(0.85))
        .border_style(GRID)
        .legend_area_size(34)
        .margin(10)
        .label_font(text(17))
        .draw()?;
    Ok(())
}
