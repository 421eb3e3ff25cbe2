//! Measured creep curves and the law that was fitted to them.

use std::path::Path;

use anyhow::Result;
use plotters::prelude::*;

use super::axes::Axes;
use super::canvas::{BLUE, GREEN, GREY, ORANGE, PURPLE, SKY, VERMILION, heading, px, text};
use super::panel::framed;
use super::{range_of, save};

const SIZE: (u32, u32) = (1100, 560);
/// Width of the legend, and from one of its lines to the next.
const LEGEND: (u32, u32) = (200, 22);
const COLOURS: [RGBColor; 7] = [BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY, GREY];

/// Points of one load and speed: creepage and adhesion.
pub struct Curve {
    /// Load and speed.
    pub name: String,
    /// As measured.
    pub measured: Vec<(f64, f64)>,
    /// As fitted, in growing creepage.
    pub fitted: Vec<(f64, f64)>,
}

/// Draws points and lines of all curves into the file `path`.
pub fn draw(path: &Path, curves: &[Curve]) -> Result<()> {
    save(path, SIZE, |area| {
        let (area, legend) = area.split_horizontally(px(SIZE.0 - LEGEND.0));
        let all = || curves.iter().flat_map(|curve| curve.measured.iter().chain(&curve.fitted));
        let x = range_of(all().map(|point| 100.0 * point.0).chain([0.0]), 1e-6);
        let y = range_of(all().map(|point| point.1).chain([0.0]), 1e-6);
        let mut chart = framed(&area, [70, 46, 8])
            .caption("Measured points and fitted law", heading(18))
            .build_cartesian_2d(x, y)?;
        let titles = ["Creepage [%]", "Adhesion: force over normal force [-]"];
        Axes { titles, labels: [10, 8], size: 14 }.draw(&mut chart)?;
        for (line, (curve, colour)) in (2..).zip(curves.iter().zip(COLOURS.into_iter().cycle())) {
            let percent = |&(x, y): &(f64, f64)| (100.0 * x, y);
            let thick = colour.stroke_width(px(2));
            chart.draw_series(LineSeries::new(curve.fitted.iter().map(percent), thick))?;
            let dots = curve.measured.iter().map(percent);
            chart.draw_series(dots.map(|at| Circle::new(at, px(3), colour.filled())))?;
            let middle = px(LEGEND.1 * line) as i32;
            legend.draw(&PathElement::new([(0, middle), (px(22) as i32, middle)], thick))?;
            legend.draw(&Circle::new((px(11) as i32, middle), px(3), colour.filled()))?;
            let corner = (px(30) as i32, middle - px(6) as i32);
            legend.draw(&Text::new(curve.name.clone(), corner, text(13)))?;
        }
        Ok(())
    })
}
