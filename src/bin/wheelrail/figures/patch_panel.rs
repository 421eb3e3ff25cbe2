//! Panels of a contact area: pressure, traction, adhesion and slip, to scale and with margins, by one
//! of two models; and the scales beside them.

use std::ops::Range;

use anyhow::Result;
use plotters::prelude::*;
use wheelrail::planar::{Adherence, ContactField, PlanarResult};

use super::axes::Axes;
use super::canvas::{Area, INK, px, text};
use super::panel::{FRAME, captioned};
use super::patches::{color, draw_colours};

/// Height of the drawing itself: patches that are flatter or higher get wider margins.
const HEIGHTS: [f64; 2] = [150.0, 480.0];
/// Margin around the loaded area, over its greater extent.
const MARGIN: f64 = 0.1;
/// Arrows along the longer side of a patch.
const ARROWS: usize = 11;
const ADHESION: RGBColor = RGBColor(160, 205, 235);
const SLIP: RGBColor = RGBColor(240, 180, 130);

/// One kind of models.
pub struct Side {
    /// Names of the models.
    pub name: String,
    /// Their fields, one for each zone or for all together.
    pub fields: Vec<ContactField>,
    /// Their resultants.
    pub result: PlanarResult,
}

/// What a panel shows.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    Pressure,
    Traction,
    State,
}

/// All of them, from above.
const ROWS: [Quantity; 3] = [Quantity::Pressure, Quantity::Traction, Quantity::State];

/// What all panels of a figure have in common.
pub struct Panels {
    /// Height of the drawing in a panel, in pixels.
    height: u32,
    /// Extents of y and x, of the same scale [mm].
    ranges: [Range<f64>; 2],
    /// Greatest pressure and traction [MPa].
    greatest: [f64; 2],
}

impl Panels {
    /// Those of `sides`, `width` pixels wide each.
    pub fn new(sides: &[Side; 2], width: u32) -> Self {
        let fields = || sides.iter().flat_map(|side| &side.fields);
        let mut ranges = extent(fields());
        let width = f64::from(width - FRAME[0] - FRAME[1]);
        let [across, along] = ranges.each_ref().map(|range| range.end - range.start);
        let height = (width * along / across).clamp(HEIGHTS[0], HEIGHTS[1]).round();
        // Millimetres to a pixel, the same in both directions.
        let scale = (across / width).max(along / height);
        for (range, pixels) in ranges.iter_mut().zip([width, height]) {
            let middle = 0.5 * (range.start + range.end);
            *range = middle - 0.5 * scale * pixels..middle + 0.5 * scale * pixels;
        }
        let pressures = fields().flat_map(|field| &field.pressure).copied();
        let tractions = fields().flat_map(|field| &field.traction).map(|t| t[0].hypot(t[1]));
        let greatest = [pressures.fold(1.0, f64::max), tractions.fold(0.0, f64::max)];
        Self { height: height as u32, ranges, greatest: greatest.map(|p| 1e-6 * p) }
    }

    /// What is drawn, a row each: without tractions the pressure alone.
    pub fn rows(&self) -> &'static [Quantity] {
        if self.greatest[1] > 0.0 { &ROWS } else { &ROWS[..1] }
    }

    /// Height of a panel with its axes, in pixels.
    pub fn height(&self) -> u32 {
        self.height + FRAME[2] + FRAME[3]
    }

    /// Draws what one of the models has found.
    pub fn draw(&self, area: &Area<'_>, side: &Side, quantity: Quantity) -> Result<()> {
        let result = &side.result;
        let caption = match quantity {
            Quantity::Pressure => format!(
                "{}: at most {:.0} MPa, N {:.2} kN{}",
                side.name,
                1e-6 * result.max_pressure,
                1e-3 * result.normal_force,
                // Of a model without tractions, without friction or creepage.
                if self.greatest[1] > 0.0 { "" } else { ", no traction" },
            ),
            Quantity::Traction => format!(
                "Traction on the wheel: Fx {:.2} kN, Fy {:.2} kN",
                1e-3 * result.fx,
                1e-3 * result.fy
            ),
            Quantity::State if side.fields.iter().any(|field| field.slip.is_some()) => {
                "Adhesion and slip; arrows: slip of the wheel".into()
            }
            Quantity::State => "Adhesion and slip".into(),
        };
        let [y, x] = self.ranges.clone();
        let mut chart = captioned(area, caption)?.build_cartesian_2d(y, x)?;
        let labels = [8, (self.height / 40) as usize];
        Axes { titles: ["y, to the right [mm]", "x, rolling up [mm]"], labels, size: 14 }
            .draw(&mut chart)?;
        for field in &side.fields {
            let cells = runs(field, |k| self.colour(field, k, quantity))
                .into_iter()
                .map(|(corners, colour)| Rectangle::new(corners, colour.filled()));
            chart.draw_series(cells)?;
            let arrows = match quantity {
                Quantity::Pressure => None,
                Quantity::Traction => Some(&field.traction),
                Quantity::State => field.slip.as_ref(),
            };
            for line in arrows.into_iter().flat_map(|arrows| arrow_lines(field, arrows)) {
                // A light line on a dark one is seen on every colour.
                for (ink, width) in [(INK, 4), (WHITE, 2)] {
                    let style = ink.stroke_width(px(width));
                    chart.draw_series([PathElement::new(line.clone(), style)])?;
                }
            }
        }
        Ok(())
    }

    /// Colour of an element, where it carries pressure.
    fn colour(&self, field: &ContactField, k: usize, quantity: Quantity) -> Option<RGBColor> {
        let [x, y] = field.traction[k];
        match quantity {
            _ if field.pressure[k] <= 0.0 => None,
            Quantity::Pressure => Some(shade(1e-6 * field.pressure[k] / self.greatest[0])),
            Quantity::Traction => Some(shade(1e-6 * x.hypot(y) / self.greatest[1])),
            Quantity::State => match field.adherence[k] {
                Adherence::None => None,
                Adherence::Adhesion => Some(ADHESION),
                Adherence::Slip => Some(SLIP),
            },
        }
    }

    /// Draws what the colours of a row of panels mean.
    pub fn draw_scale(&self, area: &Area<'_>, quantity: Quantity) -> Result<()> {
        let margins = [FRAME[2], FRAME[3]];
        match quantity {
            Quantity::Pressure => {
                draw_colours(area, &(0.0..self.greatest[0]), "pressure [MPa]", margins)
            }
            Quantity::Traction => {
                draw_colours(area, &(0.0..self.greatest[1]), "traction [MPa]", margins)
            }
            Quantity::State => {
                for (row, (name, colour)) in (0..).zip([("adhesion", ADHESION), ("slip", SLIP)]) {
                    let (x, y, side) = (px(8) as i32, px(FRAME[2]) as i32, px(16) as i32);
                    let y = y + row * px(26) as i32;
                    let square = [(x, y), (x + side, y + side)];
                    area.draw(&Rectangle::new(square, colour.filled()))?;
                    area.draw(&Text::new(name, (x + side + px(6) as i32, y), text(14)))?;
                }
                Ok(())
            }
        }
    }
}

/// Extents of y and x of the loaded elements, with a margin [mm].
fn extent<'a>(fields: impl Iterator<Item = &'a ContactField>) -> [Range<f64>; 2] {
    let mut range = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for field in fields {
        let grid = &field.grid;
        for k in (0..grid.len()).filter(|&k| field.pressure[k] > 0.0) {
            let place = [grid.y(k / grid.along), grid.x(k % grid.along)];
            let sizes = [grid.dy, grid.dx];
            for (range, (value, size)) in range.iter_mut().zip(place.into_iter().zip(sizes)) {
                *range = [range[0].min(value - 0.5 * size), range[1].max(value + 0.5 * size)];
            }
        }
    }
    if range[0][0] > range[0][1] {
        return [-1.0..1.0, -1.0..1.0];
    }
    let margin = MARGIN * range.iter().map(|[low, high]| high - low).fold(0.0, f64::max);
    range.map(|[low, high]| 1e3 * (low - margin)..1e3 * (high + margin))
}

/// Colours that differ by less are not told apart.
const SHADES: f64 = 48.0;

fn shade(share: f64) -> RGBColor {
    color((share * SHADES).round() / SHADES)
}

/// Corners (y, x) [mm] of the rectangles of one colour along the rows of a field. Each reaches a
/// little under the next, so that no seam shows.
fn runs(
    field: &ContactField,
    colour: impl Fn(usize) -> Option<RGBColor>,
) -> Vec<([(f64, f64); 2], RGBColor)> {
    let grid = &field.grid;
    let mut rectangles = Vec::new();
    for j in 0..grid.across {
        let mut i = 0;
        while i < grid.along {
            let own = colour(j * grid.along + i);
            let first = i;
            while i < grid.along && colour(j * grid.along + i) == own {
                i += 1;
            }
            let Some(own) = own else { continue };
            let (y, over) = (grid.y(j), 0.04);
            let right = if j + 1 < grid.across { 0.5 + over } else { 0.5 };
            let corners = [
                (1e3 * (y - 0.5 * grid.dy), 1e3 * (grid.x(i - 1) - 0.5 * grid.dx)),
                (1e3 * (y + right * grid.dy), 1e3 * (grid.x(first) + (0.5 + over) * grid.dx)),
            ];
            rectangles.push((corners, own));
        }
    }
    rectangles
}

/// Arrows (y, x) [mm] for every few elements, the longest a fifth longer than their distance.
fn arrow_lines(field: &ContactField, vectors: &[[f64; 2]]) -> Vec<Vec<(f64, f64)>> {
    let grid = &field.grid;
    let every = [grid.along.div_ceil(ARROWS), grid.across.div_ceil(ARROWS)];
    let reach = 1e3 * (every[0] as f64 * grid.dx).min(every[1] as f64 * grid.dy);
    let loaded = |k: &usize| field.pressure[*k] > 0.0;
    let longest = (0..grid.len()).filter(loaded).map(|k| vectors[k][0].hypot(vectors[k][1]));
    let longest = longest.fold(0.0, f64::max);
    if longest <= 0.0 {
        return Vec::new();
    }
    let chosen = (0..grid.len()).filter(loaded).filter(|&k| {
        let place = [k % grid.along, k / grid.along];
        (0..2).all(|c| place[c] % every[c] == every[c] / 2)
    });
    let arrows = chosen.map(|k| {
        let (x, y) = (1e3 * grid.x(k % grid.along), 1e3 * grid.y(k / grid.along));
        let [vx, vy] = vectors[k].map(|v| 1.2 * reach * v / longest);
        let tip = (y + 0.5 * vy, x + 0.5 * vx);
        // Barbs at a third of the length, to both sides.
        let barb =
            |side: f64| (tip.0 - 0.3 * vy + side * 0.16 * vx, tip.1 - 0.3 * vx - side * 0.16 * vy);
        vec![(y - 0.5 * vy, x - 0.5 * vx), tip, barb(1.0), tip, barb(-1.0)]
    });
    arrows.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use wheelrail::element::Parameters;
    use wheelrail::planar::{Indentation, fields, solve};

    /// Both sides of a small patch that is long or wide.
    fn sides(radius: f64) -> [Side; 2] {
        let separation: Vec<[f64; 2]> =
            (-50..=50).map(|k| 1e-4 * f64::from(k)).map(|y| [y, y * y / 0.6]).collect();
        let load = Indentation::Load(1e4);
        let case = Parameters::default().planar_case(&separation, radius, load, [0.0; 3], 0.3);
        [(); 2].map(|()| Side {
            name: String::new(),
            fields: fields(&case).unwrap(),
            result: solve(&case).unwrap(),
        })
    }

    #[test]
    fn panels_are_to_scale_and_have_margins() {
        for radius in [0.05, 0.3, 5.0] {
            let sides = sides(radius);
            let panels = Panels::new(&sides, 500);
            let [across, along] = panels.ranges.each_ref().map(|range| range.end - range.start);
            let [width, height] = [500 - FRAME[0] - FRAME[1], panels.height].map(f64::from);
            assert_eq!(panels.rows().len(), 1, "without creepage there is pressure alone");
            assert!((across / width - along / height).abs() < 1e-9 * across / width);
            let loaded = extent(sides[0].fields.iter());
            for (range, loaded) in panels.ranges.iter().zip(&loaded) {
                assert!(range.start <= loaded.start + 1e-9 && range.end >= loaded.end - 1e-9);
            }
        }
    }
}
