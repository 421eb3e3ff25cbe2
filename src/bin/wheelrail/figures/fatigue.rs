//! The shakedown map with the contacts of a table, and what their passages do below a profile.

use std::path::Path;

use anyhow::Result;
use plotters::prelude::*;
use wheelrail::fatigue::{FatigueMap, Response};

use super::axes::{Axes, Chart, legend};
use super::canvas::{Area, BLUE, GREEN, GRID, INK, VERMILION, px, text};
use super::contours::Lattice;
use super::panel::{FRAME, captioned};
use super::patches::{color, draw_colours};
use super::save;
use crate::fatigue::contacts::Found;

const WIDTH: u32 = 1180;
/// Heights of the shakedown map and of that of the body.
const HEIGHTS: [u32; 2] = [460, 360];
/// Width of the scale of colours.
const SCALE: u32 = 110;
/// Bands of colour.
const BANDS: usize = 14;
/// Limits p0/k of line contact that rolls freely: first yield by von Mises, and shakedown (Johnson
/// 1985, sections 6.1 and 9.2).
const LINE: [f64; 2] = [3.1, 4.0];
/// Places along and down, within one and a half half widths, at which stresses of line contact are
/// looked at.
const PLACES: [i32; 2] = [120, 60];

/// What is drawn.
pub struct Figure<'a> {
    pub contacts: &'a [Found],
    pub mapped: Option<Mapped<'a>>,
}

/// What passages do below a profile.
pub struct Mapped<'a> {
    pub map: &'a FatigueMap,
    /// Where its arc is shown as 0 [m].
    pub origin: f64,
    /// Whose profile it is.
    pub of: String,
}

impl Figure<'_> {
    /// Draws the figure into the file `path`.
    pub fn draw(&self, path: &Path) -> Result<()> {
        let height = HEIGHTS[0] + if self.mapped.is_some() { HEIGHTS[1] } else { 0 };
        save(path, (WIDTH, height), |area| {
            let (above, below) = area.split_vertically(px(HEIGHTS[0]));
            self.draw_shakedown(&above)?;
            self.mapped.as_ref().map_or(Ok(()), |mapped| mapped.draw(&below))
        })
    }

    fn draw_shakedown(&self, area: &Area<'_>) -> Result<()> {
        let all = || self.contacts.iter().map(|found| &found.fatigue);
        let most = |values: &mut dyn Iterator<Item = f64>, least: f64| values.fold(least, f64::max);
        let right = most(&mut all().map(|own| 1.1 * own.used_friction), 0.6);
        let top = most(&mut all().map(|own| 1.1 * own.load_factor), 1.5 * LINE[1]);
        let caption = "Shakedown map: each contact by its own limits; lines are those of line contact in full slip";
        let mut chart =
            captioned(area, caption.into())?.build_cartesian_2d(0.0..right, 0.0..top)?;
        let titles = ["used friction", "p0/k"];
        Axes { titles, labels: [8, 8], size: 14 }.draw(&mut chart)?;
        let line = |chart: &mut Chart<'_, '_>, points: Vec<(f64, f64)>, ink: RGBColor| {
            chart.draw_series(LineSeries::new(points, ink.stroke_width(px(2)))).map(|_| ())
        };
        let steps = (0..=100).map(|k| right * f64::from(k) / 100.0);
        line(&mut chart, steps.map(|f| (f, line_limit(f))).collect(), INK)?;
        line(&mut chart, vec![(0.0, LINE[0]), (0.25 * right, LINE[0])], GRID)?;
        let words = [("shakedown limit", LINE[1]), ("first yield, rolling freely", LINE[0])];
        for (words, at) in words {
            let place = (0.01 * right, at + 0.045 * top);
            chart.draw_series([Text::new(words, place, text(14))])?;
        }
        let kinds = [
            (Response::Elastic, BLUE, "elastic"),
            (Response::Shakedown, GREEN, "shakes down"),
            (Response::Plastic, VERMILION, "yields in every passage"),
        ];
        for (response, ink, name) in kinds {
            let own = all().filter(|own| own.response == response);
            let points = own.map(|own| {
                Circle::new((own.used_friction, own.load_factor), px(5), ink.mix(0.7).filled())
            });
            chart
                .draw_series(points)?
                .label(name)
                .legend(move |(x, y)| Circle::new((x + px(9) as i32, y), px(5), ink.filled()));
        }
        legend(&mut chart, SeriesLabelPosition::UpperRight, 14)
    }
}

/// p0/k up to which line contact in full slip with this friction shakes down: 1 over the greatest shear
/// stress on planes parallel to the surface, by McEwen's formulas (Johnson 1985, eqs 4.49 and 7.8).
fn line_limit(friction: f64) -> f64 {
    let mut greatest = friction;
    for i in -PLACES[0]..=PLACES[0] {
        for j in 1..=PLACES[1] {
            let x = 1.5 * f64::from(i) / f64::from(PLACES[0]);
            let z = 1.5 * f64::from(j) / f64::from(PLACES[1]);
            let sum = 1.0 - x * x + z * z;
            let root = (sum * sum + 4.0 * x * x * z * z).sqrt();
            let (m, n) = ((0.5 * (root + sum)).sqrt(), (0.5 * (root - sum)).sqrt() * x.signum());
            let square = m * m + n * n;
            let pressed = -n * (m * m - z * z) / square;
            let drawn = -(m * (1.0 + (z * z + n * n) / square) - 2.0 * z);
            greatest = greatest.max((pressed + friction * drawn).abs());
        }
    }
    1.0 / greatest
}

impl Mapped<'_> {
    fn draw(&self, area: &Area<'_>) -> Result<()> {
        let (map, depths) = (self.map, self.map.depths());
        let mpa = |k: usize| 1e-6 * map.cells()[k].dang_van;
        let greatest = (0..map.cells().len()).map(mpa).fold(0.0, f64::max).max(1e-6);
        // Where passages came near.
        let touched: Vec<usize> = (0..map.arcs().len())
            .filter(|i| (0..depths.len()).any(|j| mpa(i * depths.len() + j) > 0.1 * greatest))
            .collect();
        let [Some(&first), Some(&last)] = [touched.first(), touched.last()] else { return Ok(()) };
        let [first, last] = [first.saturating_sub(1), (last + 1).min(map.arcs().len() - 1)];
        let arcs: Vec<f64> =
            map.arcs()[first..=last].iter().map(|s| 1e3 * (s - self.origin)).collect();
        let down: Vec<f64> = depths.iter().map(|z| 1e3 * z).collect();
        if arcs.len() < 2 || down.len() < 2 {
            return Ok(());
        }
        let values: Vec<f64> = (0..down.len())
            .flat_map(|j| (first..=last).map(move |i| i * depths.len() + j))
            .map(mpa)
            .collect();
        let (drawn, scale) = area.split_horizontally(px(WIDTH - SCALE));
        let caption = format!("Greatest equivalent stress of Dang Van below {}", self.of);
        let (x, z) = (arcs[0]..arcs[arcs.len() - 1], down[down.len() - 1]..0.0);
        let mut chart = captioned(&drawn, caption)?.build_cartesian_2d(x.clone(), z.clone())?;
        let titles = ["arc of the profile from its y = 0 [mm]", "depth [mm]"];
        Axes { titles, labels: [10, 7], size: 14 }.draw(&mut chart)?;
        let levels: Vec<f64> = (1..BANDS).map(|k| greatest * k as f64 / BANDS as f64).collect();
        let shade = |band: usize| color(band as f64 / levels.len() as f64);
        let whole = Rectangle::new([(x.start, down[0]), (x.end, z.start)], shade(0).filled());
        chart.draw_series([whole])?;
        let lattice = Lattice { axes: [&arcs, &down], values: &values };
        for own in lattice.loops(&levels) {
            chart.draw_series([Polygon::new(own.points, shade(own.band).filled())])?;
        }
        draw_colours(&scale, &(0.0..greatest), "MPa", [FRAME[2], FRAME[3]])?;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn line_contact_has_its_known_limits() {
        for (friction, limit) in [(0.0, 4.0), (0.25, 3.04), (0.3, 2.90), (0.4, 2.5)] {
            let found = line_limit(friction);
            assert!((found / limit - 1.0).abs() < 0.005, "{friction}: {found}");
        }
    }
}
