//! Sections below a contact with contours of the equivalent stress, and stresses along lines.

mod lines;

use std::path::Path;

use anyhow::Result;
use plotters::prelude::*;
use wheelrail::error::ContactError;
use wheelrail::subsurface::{Greatest, Measure, State, SurfaceLoad, evenly, lattice};

use super::axes::Axes;
use super::canvas::{Area, VERMILION, heading, px};
use super::contours::Lattice;
use super::panel::{FRAME, captioned};
use super::patches::{color, draw_colours};
use super::save;
use lines::draw_lines;

const WIDTH: u32 = 1280;
const TITLE: u32 = 56;
/// Height of the charts of lines.
const LINES: u32 = 330;
/// Width of the scale of colours.
const SCALE: u32 = 110;
/// Height of a section without its axes: flat ones are shown to a greater depth.
const HEIGHTS: [f64; 2] = [200.0, 480.0];
/// Points of a section along the surface and down.
const POINTS: [usize; 2] = [161, 101];
/// Points of a line.
const LINE: usize = 201;
/// Half the width of a section over the greater extent of the patch.
const REACH: f64 = 0.75;
/// Bands of colour at most.
const BANDS: f64 = 14.0;

/// A vertical plane: its points, each depth over all places along the surface, and what is there.
pub struct Section {
    /// Places along the surface, x or y, and depths [m].
    axes: [Vec<f64>; 2],
    /// The points (x, y, depth) [m].
    pub points: Vec<[f64; 3]>,
    /// Displacements and stresses.
    pub states: Vec<State>,
}

/// What is drawn.
pub struct Figure<'a> {
    title: String,
    load: &'a SurfaceLoad,
    /// Sections along and across rolling through the greatest von Mises stress.
    pub sections: [Section; 2],
    /// Greatest values of all measures, in their order.
    pub greatest: [Greatest; 4],
}

fn states(load: &SurfaceLoad, points: &[[f64; 3]]) -> Result<Vec<State>, ContactError> {
    let mut states = vec![State::default(); points.len()];
    load.states(points, &mut states)?;
    Ok(states)
}

impl<'a> Figure<'a> {
    /// Computes what is drawn of `load`; none without contact.
    pub fn new(title: String, load: &'a SurfaceLoad) -> Result<Option<Self>, ContactError> {
        let Some([x, y]) = load.extent() else { return Ok(None) };
        let Some(greatest) = Measure::ALL.iter().map(|m| load.greatest(*m)).collect() else {
            return Ok(None);
        };
        let greatest: Vec<Greatest> = greatest;
        let Ok(greatest) = <[Greatest; 4]>::try_from(greatest) else { return Ok(None) };
        let sides = [x, y].map(|[low, high]| high - low);
        let reach = REACH * sides[0].max(sides[1]);
        let width = f64::from((WIDTH - SCALE) / 2 - FRAME[0] - FRAME[1]);
        let height =
            (width * (sides[0] * sides[1]).sqrt() / (2.0 * reach)).clamp(HEIGHTS[0], HEIGHTS[1]);
        // To scale.
        let depths = evenly(0.0, 2.0 * reach * height / width, POINTS[1]);
        let [px, py, _] = greatest[0].point;
        let section = |axis: usize| -> Result<Section, ContactError> {
            let [low, high] = [x, y][axis];
            let middle = 0.5 * (low + high);
            let along = evenly(middle - reach, middle + reach, POINTS[0]);
            let points = depths.iter().flat_map(|z| match axis {
                0 => lattice(&along, &[py], &[*z]),
                _ => lattice(&[px], &along, &[*z]),
            });
            let points: Vec<[f64; 3]> = points.collect();
            Ok(Section { states: states(load, &points)?, points, axes: [along, depths.clone()] })
        };
        let sections = [section(0)?, section(1)?];
        Ok(Some(Self { title, load, sections, greatest }))
    }

    /// Draws the figure into the file `path`.
    pub fn draw(&self, path: &Path) -> Result<()> {
        let [along, depth] = &self.sections[0].axes;
        let [width, deep] = [along, depth].map(|axis| axis[axis.len() - 1] - axis[0]);
        let drawn = f64::from((WIDTH - SCALE) / 2 - FRAME[0] - FRAME[1]);
        let sections = (drawn * deep / width).round() as u32 + FRAME[2] + FRAME[3];
        let greatest = self.greatest[0].value / self.load.max_pressure();
        let step = step(greatest);
        let count = (greatest / step) as u32;
        let levels: Vec<f64> = (1..=count).map(|k| f64::from(k) * step).collect();
        save(path, (WIDTH, TITLE + sections + LINES), |area| {
            let area = area.titled(&self.title, heading(21))?;
            let (above, below) = area.split_vertically(px(sections));
            let (both, scale) = above.split_horizontally(px(WIDTH - SCALE));
            for (axis, cell) in both.split_evenly((1, 2)).iter().enumerate() {
                self.draw_section(cell, axis, &levels)?;
            }
            let range = 0.0..(levels.len() + 1) as f64 * step;
            draw_colours(&scale, &range, "von Mises stress over p0", [FRAME[2], FRAME[3]])?;
            let halves = below.split_evenly((1, 2));
            self.draw_line_down(&halves[0])?;
            self.draw_shear(&halves[1])
        })
    }

    fn draw_section(&self, area: &Area<'_>, axis: usize, levels: &[f64]) -> Result<()> {
        let section = &self.sections[axis];
        let place = self.greatest[0].point;
        let words = [
            format!("Along rolling, at y = {:.2} mm", 1e3 * place[1]),
            format!("Across, at x = {:.2} mm", 1e3 * place[0]),
        ];
        let mm = section.axes.each_ref().map(|own| own.iter().map(|x| 1e3 * x).collect::<Vec<_>>());
        let [x, z] = mm.each_ref().map(|own| own[0]..own[own.len() - 1]);
        let mut chart =
            captioned(area, words[axis].clone())?.build_cartesian_2d(x.clone(), z.end..z.start)?;
        let titles = [["x, rolling to the right [mm]", "y, to the right [mm]"][axis], "depth [mm]"];
        Axes { titles, labels: [8, 7], size: 14 }.draw(&mut chart)?;
        let p0 = self.load.max_pressure();
        let values: Vec<f64> =
            section.states.iter().map(|state| state.stress.von_mises() / p0).collect();
        let shade = |band: usize| color(band as f64 / levels.len().max(1) as f64);
        let whole = Rectangle::new([(x.start, z.start), (x.end, z.end)], shade(0).filled());
        chart.draw_series([whole])?;
        let lattice = Lattice { axes: [&mm[0], &mm[1]], values: &values };
        for own in lattice.loops(levels) {
            chart.draw_series([Polygon::new(own.points.clone(), shade(own.band).filled())])?;
            let closed = own.points.iter().chain(own.points.first()).copied();
            chart.draw_series([PathElement::new(
                closed.collect::<Vec<_>>(),
                WHITE.mix(0.45).stroke_width(px(1)),
            )])?;
        }
        let at = (1e3 * place[axis], 1e3 * place[2]);
        let to_axis = PathElement::new(vec![(x.start, at.1), at], WHITE.stroke_width(px(1)));
        chart.draw_series([to_axis])?;
        for (size, ink) in [(6, WHITE), (4, VERMILION)] {
            chart.draw_series([Circle::new(at, px(size), ink.filled())])?;
        }
        let words = format!(
            "{:.3} p0 = {:.0} MPa, {:.2} mm deep",
            self.greatest[0].value / p0,
            1e-6 * self.greatest[0].value,
            at.1
        );
        // In the lower right corner.
        let share = |right: f64, down: f64| {
            (x.start + right * (x.end - x.start), z.start + down * (z.end - z.start))
        };
        let back = Rectangle::new([share(0.55, 0.90), share(0.99, 0.98)], WHITE.mix(0.85).filled());
        chart.draw_series([back])?;
        chart.draw_series([Text::new(words, share(0.565, 0.915), heading(14))])?;
        Ok(())
    }

    /// Equivalent stresses on the vertical through the greatest von Mises stress.
    fn draw_line_down(&self, area: &Area<'_>) -> Result<()> {
        let [x, y, _] = self.greatest[0].point;
        let depths = &self.sections[0].axes[1];
        let depths = evenly(0.0, depths[depths.len() - 1], LINE);
        let found = states(self.load, &lattice(&[x], &[y], &depths))?;
        let lines = Measure::ALL.map(|measure| {
            let over = |state: &State| measure.of(&state.stress) / self.load.max_pressure();
            let points = depths.iter().zip(&found).map(|(z, state)| (1e3 * z, over(state)));
            (words(measure), points.collect())
        });
        let title = format!("Below x = {:.2} mm, y = {:.2} mm", 1e3 * x, 1e3 * y);
        draw_lines(area, &title, "depth [mm]", &lines, SeriesLabelPosition::LowerRight)
    }

    /// Shear on planes parallel to the surface in the section along rolling, at the depth where it is
    /// greatest along rolling.
    fn draw_shear(&self, area: &Area<'_>) -> Result<()> {
        let section = &self.sections[0];
        let shear = |k: &usize| section.states[*k].stress.xz.abs();
        let most = (0..section.states.len()).max_by(|a, b| shear(a).total_cmp(&shear(b)));
        let Some([_, y, z]) = most.map(|k| section.points[k]) else { return Ok(()) };
        let along = &section.axes[0];
        let along = evenly(along[0], along[along.len() - 1], LINE);
        let found = states(self.load, &lattice(&along, &[y], &[z]))?;
        let p0 = self.load.max_pressure();
        let line = |f: fn(&State) -> f64| {
            along.iter().zip(&found).map(|(x, state)| (1e3 * x, f(state) / p0)).collect()
        };
        let lines = [
            ("orthogonal shear along rolling", line(|state| state.stress.xz)),
            ("orthogonal shear across", line(|state| state.stress.yz)),
        ];
        let title = format!("At y = {:.2} mm, {:.2} mm deep", 1e3 * y, 1e3 * z);
        let legend = SeriesLabelPosition::UpperRight;
        draw_lines(area, &title, "x, rolling to the right [mm]", &lines, legend)
    }
}

/// A step of the contours: 1, 2 or 5 times a power of ten.
fn step(greatest: f64) -> f64 {
    let wanted = (greatest / BANDS).max(1e-6);
    let power = 10f64.powf(wanted.log10().floor());
    [1.0, 2.0, 5.0, 10.0].map(|s| s * power).into_iter().find(|s| *s >= wanted).unwrap_or(wanted)
}

fn words(measure: Measure) -> &'static str {
    match measure {
        Measure::VonMises => "von Mises",
        Measure::Tresca => "Tresca",
        Measure::Hydrostatic => "hydrostatic",
        _ => "orthogonal shear",
    }
}
