//! Root locus of a wheelset: growth over frequency, and both over the speed.

use std::path::Path;

use anyhow::Result;
use nalgebra::Complex;
use plotters::prelude::*;

use super::axes::Axes;
use super::canvas::{Area, BLUE, GREY, VERMILION, heading, px};
use super::panel::framed;
use super::{range_of, save};

const SIZE: (u32, u32) = (1100, 480);
/// Eigenvalues that die out faster are those of the stiff contact, which would leave no room to the
/// others [1/s].
const FASTEST: f64 = 60.0;

/// Eigenvalues at a speed.
#[derive(Clone, Debug)]
pub struct Roots {
    /// Speed [m/s].
    pub speed: f64,
    /// Growth and angular frequency, the one that grows most first [1/s].
    pub values: Vec<Complex<f64>>,
}

/// Draws the `roots` at each speed, and the `critical` one.
pub fn draw(path: &Path, title: &str, roots: &[Roots], critical: Option<f64>) -> Result<()> {
    let points: Vec<[f64; 3]> = roots
        .iter()
        .flat_map(|one| one.values.iter().map(|value| [one.speed, value.re, value.im]))
        .filter(|point| point[1] > -FASTEST)
        .map(|[speed, growth, turn]| [speed, growth, turn / std::f64::consts::TAU])
        .collect();
    save(path, SIZE, |area| {
        let area = area.titled(&format!("Eigenvalues of a wheelset: {title}"), heading(26))?;
        let (left, right) = area.split_horizontally(px(SIZE.0 / 2));
        let titles = ["growth rate [1/s]", "frequency [Hz]"];
        panel(&left, titles, points.iter().map(|p| ([p[1], p[2]], p[1])), Some(0.0))?;
        let titles = ["speed [m/s]", "growth rate [1/s]"];
        panel(&right, titles, points.iter().map(|p| ([p[0], p[1]], p[1])), critical)
    })
}

/// Points, each with the growth that gives it its colour, and a line at a `mark`.
fn panel(
    area: &Area<'_>,
    titles: [&str; 2],
    points: impl Iterator<Item = ([f64; 2], f64)>,
    mark: Option<f64>,
) -> Result<()> {
    let points: Vec<([f64; 2], f64)> = points.collect();
    let ranges = [0, 1].map(|axis| range_of(points.iter().map(|(p, _)| p[axis]), 1.0));
    let [x_range, y_range] = ranges;
    let ends = [y_range.start, y_range.end];
    let mut chart = framed(area, [78, 52, 24]).build_cartesian_2d(x_range, y_range)?;
    Axes { titles, labels: [9, 8], size: 17 }.draw(&mut chart)?;
    if let Some(x) = mark {
        let line = ends.map(|y| (x, y));
        chart.draw_series(LineSeries::new(line, GREY.stroke_width(px(2))))?;
    }
    chart.draw_series(points.iter().map(|([x, y], growth)| {
        let color = if *growth > 0.0 { VERMILION } else { BLUE };
        Circle::new((*x, *y), px(3), color.filled())
    }))?;
    Ok(())
}
