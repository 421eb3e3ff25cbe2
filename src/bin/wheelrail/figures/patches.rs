//! Where the patches run on rail heads and wheels, as bands coloured by the greatest pressure.

use std::ops::Range;
use std::path::Path;

use anyhow::Result;
use plotters::prelude::*;

use super::axes::Axes;
use super::canvas::{Area, INK, RAMP, heading, label, px, text};
use super::panel::framed;
use super::{ramp_stretch, range_of, save, thinned};
use crate::wheelset::record::{Patch, Record};
use crate::wheelset::track::Track;

const SIZE: (u32, u32) = (1240, 860);
/// Columns into which the distance is cut; more would not be seen and make the file large.
const COLUMNS: usize = 400;
const SCALE_WIDTH: u32 = 110;
const SCALE_STEPS: u32 = 64;
/// Least range of the colours: smaller differences of pressure are not worth a colour [GPa].
const MIN_SCALE: f64 = 0.3;

/// Lightness grows evenly from dark violet to yellow (matplotlib's viridis, CC0, nine of its
/// colours).
const VIRIDIS: [(u8, u8, u8); 9] = [
    (68, 1, 84),
    (71, 44, 122),
    (59, 81, 139),
    (44, 113, 142),
    (33, 144, 141),
    (39, 173, 129),
    (92, 200, 99),
    (170, 220, 50),
    (253, 231, 37),
];

/// Lateral position of a patch on one of the bodies [m].
type Position = fn(&Patch) -> f64;

/// Draws the figure into the file `path`.
pub fn draw(path: &Path, title: &str, track: &Track, records: &[Record]) -> Result<()> {
    save(path, SIZE, |area| draw_inner(area, title, track, records))
}

fn draw_inner(area: &Area<'_>, title: &str, track: &Track, records: &[Record]) -> Result<()> {
    let area = area.titled(&format!("Contact patches: {title}"), heading(26))?;
    let (charts, scale) = area.split_horizontally(px(SIZE.0 - SCALE_WIDTH));
    let shown = thinned(records, COLUMNS);
    let pressures = shown.iter().flat_map(|r| r.patches.iter().flatten()).map(pressure);
    let pressures_range = range_of(pressures, MIN_SCALE);

    let cells = charts.split_evenly((2, 2));
    // The left wheel on the left; records hold the right one first.
    let columns = [(1, "Left"), (0, "Right")];
    let rows: [(Position, &str); 2] = [(|p| p.rail_y, "rail head"), (|p| p.wheel_y, "wheel")];
    for (row, (position, body)) in rows.into_iter().enumerate() {
        let values = shown.iter().flat_map(|r| r.patches.iter().flatten()).flat_map(|p| {
            let (y, half) = (1e3 * position(p), 0.5e3 * p.width);
            [y - half, y + half]
        });
        let y_range = range_of(values, 20.0);
        for (column, (wheel, side)) in columns.into_iter().enumerate() {
            let panel = Panel {
                title: format!("{side} {body}"),
                y_title: format!("y on the {body} [mm], field side up"),
                y_range: y_range.clone(),
                wheel,
                position,
                pressures: pressures_range.clone(),
            };
            panel.draw(&cells[2 * row + column], track, &shown)?;
        }
    }
    draw_colours(&scale, &pressures_range, "greatest pressure of the patch [GPa]", [140, 140])?;
    draw_ramp_sign(&scale)?;
    Ok(())
}

/// One body over distance.
struct Panel {
    title: String,
    y_title: String,
    y_range: Range<f64>,
    wheel: usize,
    position: Position,
    /// Pressures at the ends of the colours [GPa].
    pressures: Range<f64>,
}

impl Panel {
    fn draw(&self, area: &Area<'_>, track: &Track, shown: &[&Record]) -> Result<()> {
        let distance = |index: usize| shown[index].state.distance;
        let last = shown.len() - 1;
        let x_range = 0.0..distance(last).max(1e-3);
        let mut chart = framed(area, [66, 50, 18])
            .caption(&self.title, heading(19))
            .build_cartesian_2d(x_range.clone(), self.y_range.clone())?;
        let ramp = ramp_stretch(track, &x_range);
        if ramp.start < ramp.end {
            let corners = [(ramp.start, self.y_range.start), (ramp.end, self.y_range.end)];
            chart.draw_series(std::iter::once(Rectangle::new(corners, RAMP.filled())))?;
        }
        let titles = ["distance [m]", &self.y_title];
        Axes { titles, labels: [7, 7], size: 16 }.draw(&mut chart)?;
        let bands = shown.iter().enumerate().flat_map(|(index, record)| {
            let (start, next) = (distance(index), distance((index + 1).min(last)));
            // Half under the next band, which is drawn over it, so that no seam shows.
            let end = (1.5 * next - 0.5 * start).min(distance(last));
            // Light ones last: a small patch is seen before a large one.
            record.patches[self.wheel].iter().map(move |patch| {
                let (y, half) = (1e3 * (self.position)(patch), 0.5e3 * patch.width);
                let color = color(share(pressure(patch), &self.pressures));
                Rectangle::new([(start, y - half), (end, y + half)], color.filled())
            })
        });
        chart.draw_series(bands)?;
        // Where there are several, their edges tell them apart.
        let several = shown.iter().enumerate().filter(|(_, r)| r.patches[self.wheel].len() > 1);
        let edges = several.flat_map(|(index, record)| {
            let (start, end) = (distance(index), distance((index + 1).min(last)));
            record.patches[self.wheel].iter().flat_map(move |patch| {
                let (y, half) = (1e3 * (self.position)(patch), 0.5e3 * patch.width);
                [y - half, y + half]
                    .map(|y| PathElement::new(vec![(start, y), (end, y)], INK.stroke_width(px(1))))
            })
        });
        chart.draw_series(edges)?;
        Ok(())
    }
}

/// What the shaded stretch is, above the scale; edges are those of two-point contact.
fn draw_ramp_sign(area: &Area<'_>) -> Result<()> {
    let (x, y) = (px(14) as i32, px(60) as i32);
    let side = px(16) as i32;
    area.draw(&Rectangle::new([(x, y), (x + side, y + side)], RAMP.filled()))?;
    area.draw(&Text::new("ramp", (x + side + px(6) as i32, y), text(16)))?;
    let y = y + px(28) as i32;
    let line = vec![(x, y + side / 2), (x + side, y + side / 2)];
    area.draw(&PathElement::new(line, INK.stroke_width(px(2))))?;
    for (row, words) in (0..).zip(["edges of", "two patches"]) {
        let place = (x + side + px(6) as i32, y + row * px(17) as i32);
        area.draw(&Text::new(words, place, text(14)))?;
    }
    Ok(())
}

/// Draws the colours of a quantity from the one end of its range to the other; `margins` above and
/// below in pixels.
pub fn draw_colours(
    area: &Area<'_>,
    range: &Range<f64>,
    title: &str,
    margins: [u32; 2],
) -> Result<()> {
    let mut chart = ChartBuilder::on(area)
        .margin_top(px(margins[0]))
        .margin_bottom(px(margins[1]))
        .margin_right(px(10))
        .set_label_area_size(LabelAreaPosition::Right, px(70))
        .build_cartesian_2d(0.0..1.0, range.clone())?;
    chart
        .configure_mesh()
        .disable_mesh()
        .disable_x_axis()
        .set_all_tick_mark_size(px(5))
        .axis_style(INK.stroke_width(px(1)))
        .y_labels(6)
        .y_label_formatter(&label)
        .label_style(text(16))
        .axis_desc_style(text(17))
        .y_desc(title)
        .draw()?;
    let width = (range.end - range.start) / f64::from(SCALE_STEPS);
    let band = |index: u32| {
        let low = range.start + width * f64::from(index);
        let color = color(share(low, range));
        // Up to the end, under the bands to come, so that no seam shows.
        Rectangle::new([(0.0, low), (1.0, range.end)], color.filled())
    };
    chart.draw_series((0..SCALE_STEPS).map(band))?;
    Ok(())
}

/// Greatest pressure of a patch [GPa].
fn pressure(patch: &Patch) -> f64 {
    1e-9 * patch.max_pressure
}

/// Where `pressure` lies in the range of the colours, 0 to 1.
fn share(pressure: f64, pressures: &Range<f64>) -> f64 {
    (pressure - pressures.start) / (pressures.end - pressures.start)
}

/// Colour of a share from 0 to 1.
pub fn color(share: f64) -> RGBColor {
    let place = share.clamp(0.0, 1.0) * (VIRIDIS.len() - 1) as f64;
    let index = (place as usize).min(VIRIDIS.len() - 2);
    let part = place - index as f64;
    let ((r0, g0, b0), (r1, g1, b1)) = (VIRIDIS[index], VIRIDIS[index + 1]);
    let mix = |a: u8, b: u8| (f64::from(a) + part * (f64::from(b) - f64::from(a))).round() as u8;
    RGBColor(mix(r0, r1), mix(g0, g1), mix(b0, b1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_run_from_dark_to_light() {
        let lightness = |share| {
            let RGBColor(r, g, b) = color(share);
            0.2126 * f64::from(r) + 0.7152 * f64::from(g) + 0.0722 * f64::from(b)
        };
        let steps: Vec<f64> = (0..=20).map(|i| lightness(f64::from(i) / 20.0)).collect();
        assert!(steps.windows(2).all(|pair| pair[1] > pair[0]), "{steps:?}");
    }
}
