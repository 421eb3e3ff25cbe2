//! Lateral displacement and yaw of the wheelset over the distance run.

use std::path::Path;

use anyhow::Result;
use plotters::prelude::*;

use super::axes::Axes;
use super::canvas::{Area, BLUE, GREY, GRID, RAMP, VERMILION, heading, px, text};
use super::panel::framed;
use super::{ramp_stretch, range_of, save, thinned};
use crate::wheelset::record::Record;
use crate::wheelset::track::Track;

/// Length of the line of a legend entry, in coordinates.
const LINE: i32 = px(26) as i32;
const SIZE: (u32, u32) = (1100, 760);
/// Points of a curve at most; more are not seen.
const POINTS: usize = 1000;

/// One curve of a panel.
pub(super) struct Series<'a> {
    pub label: &'a str,
    pub color: RGBColor,
    pub dashed: bool,
    pub points: Vec<(f64, f64)>,
}

/// Draws the figure into the file `path`.
pub fn draw(path: &Path, title: &str, track: &Track, records: &[Record]) -> Result<()> {
    save(path, SIZE, |area| draw_inner(area, title, track, records))
}

fn draw_inner(area: &Area<'_>, title: &str, track: &Track, records: &[Record]) -> Result<()> {
    let area = area.titled(&format!("Wheelset: {title}"), heading(26))?;
    let (above, below) = area.split_vertically(px(362));
    let over = |quantity: fn(&Record) -> f64| -> Vec<(f64, f64)> {
        let shown = thinned(records, POINTS).into_iter();
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
    panel(&above, "lateral displacement [mm], to the right", None, Some(track), &lateral)?;
    let yaw = [Series {
        label: "wheelset",
        color: VERMILION,
        dashed: false,
        points: over(|r| 1e3 * r.state.yaw),
    }];
    panel(&below, "yaw [mrad], nose to the right", Some("distance [m]"), Some(track), &yaw)?;
    Ok(())
}

/// One panel; the ramp of the `track` is shaded where there is one.
pub(super) fn panel(
    area: &Area<'_>,
    y_title: &str,
    x_title: Option<&str>,
    track: Option<&Track>,
    series: &[Series<'_>],
) -> Result<()> {
    let distances = series[0].points.iter().map(|point| point.0);
    let (x_start, x_end) = (
        distances.clone().fold(f64::INFINITY, f64::min),
        distances.fold(f64::NEG_INFINITY, f64::max),
    );
    let x_range = x_start..x_end.max(x_start + 1e-3);
    let values = series.iter().flat_map(|s| s.points.iter().map(|point| point.1));
    let y_range = range_of(values, 0.1);
    let mut chart = framed(area, [78, if x_title.is_some() { 52 } else { 28 }, 24])
        .build_cartesian_2d(x_range.clone(), y_range.clone())?;
    let ramp = track.map_or(0.0..0.0, |track| ramp_stretch(track, &x_range));
    let corners = [(ramp.start, y_range.start), (ramp.end, y_range.end)];
    if ramp.start < ramp.end {
        chart
            .draw_series(std::iter::once(Rectangle::new(corners, RAMP.filled())))?
            .label("ramp")
            .legend(|(x, y)| {
                Rectangle::new([(x, y - LINE / 4), (x + LINE, y + LINE / 4)], RAMP.filled())
            });
    }
    let titles = [x_title.unwrap_or_default(), y_title];
    Axes { titles, labels: [13, 7], size: 17 }.draw(&mut chart)?;
    for one in series {
        let style = one.color.stroke_width(px(if one.dashed { 2 } else { 3 }));
        let points = one.points.iter().copied();
        let drawn = if one.dashed {
            chart.draw_series(DashedLineSeries::new(points, px(9), px(5), style))?
        } else {
            chart.draw_series(LineSeries::new(points, style))?
        };
        let dashed = one.dashed;
        drawn.label(one.label).legend(move |(x, y)| {
            let gap = if dashed { LINE / 8 } else { 0 };
            let middle = x + LINE / 2;
            let first = PathElement::new(vec![(x, y), (middle - gap, y)], style);
            let second = PathElement::new(vec![(middle + gap, y), (x + LINE, y)], style);
            EmptyElement::at((0, 0)) + first + second
        });
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .background_style(WHITE.mix(0.85))
        .border_style(GRID.stroke_width(px(1)))
        .legend_area_size(px(34))
        .margin(px(10))
        .label_font(text(17))
        .draw()?;
    Ok(())
}
