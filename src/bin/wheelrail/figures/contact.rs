//! One contact: profiles, pressure, tractions, adhesion and slip, by two kinds of models side by
//! side.

use std::ops::Range;
use std::path::Path;

use anyhow::Result;
use plotters::prelude::*;
use wheelrail::element::FlatContact;
use wheelrail::planar::{Adherence, ContactField, PlanarResult};

use super::axes::Axes;
use super::canvas::{Area, BLUE, GREY, GRID, INK, VERMILION, heading, px, text};
use super::patches::color;
use super::save;

const WIDTH: u32 = 1180;
const PROFILES: u32 = 330;
const PATCHES: u32 = 3 * 330;
const TITLE: u32 = 60;
/// Length of a line in the legend, in coordinates.
const SAMPLE: i32 = px(22) as i32;
/// Arrows along the longer side of a patch.
const ARROWS: usize = 14;
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

/// What is drawn.
pub struct Figure {
    /// What the contact is.
    pub title: String,
    /// Coefficient of friction.
    pub friction: f64,
    /// All contacts of the wheel; none for a planar case.
    pub contacts: Vec<FlatContact>,
    /// Index of the one whose patch is drawn.
    pub drawn: usize,
    /// The models of the row, and boundary elements.
    pub sides: [Side; 2],
}

/// What a panel shows.
#[derive(Clone, Copy)]
enum Quantity {
    Pressure,
    Traction,
    State,
}

impl Figure {
    /// Draws the figure into the file `path`.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn draw(&self, path: &Path) -> Result<()> {
        let profiles = if self.contacts.is_empty() { 0 } else { PROFILES };
        save(path, (WIDTH, TITLE + profiles + PATCHES), |area| {
            let area = area.titled(&self.title, heading(24))?;
            let (top, patches) = area.split_vertically(px(profiles));
            if profiles > 0 {
                self.draw_profiles(&top)?;
            }
            let cells = patches.split_evenly((3, 2));
            let quantities = [Quantity::Pressure, Quantity::Traction, Quantity::State];
            for (row, quantity) in quantities.into_iter().enumerate() {
                for (column, side) in self.sides.iter().enumerate() {
                    self.draw_panel(&cells[2 * row + column], side, quantity)?;
                }
            }
            Ok(())
        })
    }

    fn draw_profiles(&self, area: &Area<'_>) -> Result<()> {
        let outlines = || self.contacts.iter().flat_map(|c| [&c.wheel, &c.rail_head]);
        let range = |c: usize| {
            let values = outlines().flatten().map(|point| 1e3 * point[c]);
            super::range_of(values, 1.0)
        };
        // The track's z points down.
        let z = range(1);
        let mut chart = ChartBuilder::on(area)
            .caption("Wheel and rail near the contacts", heading(17))
            .margin(px(6))
            .margin_right(px(16))
            .x_label_area_size(px(44))
            .y_label_area_size(px(60))
            .build_cartesian_2d(range(0), z.end..z.start)?;
        Axes { titles: ["y, to the field side [mm]", "z, down [mm]"], labels: [8, 6], size: 14 }
            .draw(&mut chart)?;
        for (index, contact) in self.contacts.iter().enumerate() {
            for (name, outline, color) in
                [("rail", &contact.rail_head, GREY), ("wheel", &contact.wheel, BLUE)]
            {
                let points = outline.iter().map(|p| (1e3 * p[0], 1e3 * p[1]));
                let style = color.stroke_width(px(2));
                let line = chart.draw_series(LineSeries::new(points, style))?;
                if index == 0 {
                    let sample = move |(x, y)| PathElement::new([(x, y), (x + SAMPLE, y)], style);
                    line.label(name).legend(sample);
                }
            }
            let [y, z] = contact.position.map(|value| 1e3 * value);
            let size = if index == self.drawn { px(6) } else { px(4) };
            let point = chart.draw_series([Circle::new((y, z), size, VERMILION.filled())])?;
            if index == self.drawn {
                let sample = |(x, y)| Circle::new((x + SAMPLE / 2, y), px(5), VERMILION.filled());
                point.label("contact point of the patch below").legend(sample);
            }
        }
        // The rail head falls off to both sides.
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::LowerMiddle)
            .legend_area_size(px(30))
            .margin(px(8))
            .background_style(WHITE.mix(0.85))
            .border_style(GRID)
            .label_font(text(14))
            .draw()?;
        Ok(())
    }

    /// Extent of both solutions [mm], x and y of equal scale as far as the panel's shape lets them.
    fn ranges(&self) -> [Range<f64>; 2] {
        let mut range = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        for field in self.sides.iter().flat_map(|side| &side.fields) {
            let grid = &field.grid;
            for k in (0..grid.len()).filter(|&k| field.pressure[k] > 0.0) {
                let place = [grid.y(k / grid.along), grid.x(k % grid.along)];
                for (range, (value, size)) in
                    range.iter_mut().zip(place.into_iter().zip([grid.dy, grid.dx]))
                {
                    *range = [range[0].min(value - size), range[1].max(value + size)];
                }
            }
        }
        range.map(|[low, high]| {
            let margin = 0.06 * (high - low);
            1e3 * (low - margin)..1e3 * (high + margin)
        })
    }

    /// Greatest pressure of both solutions [MPa].
    fn greatest(&self) -> f64 {
        let fields = self.sides.iter().flat_map(|side| &side.fields);
        1e-6 * fields.flat_map(|field| &field.pressure).copied().fold(1.0, f64::max)
    }

    fn draw_panel(&self, area: &Area<'_>, side: &Side, quantity: Quantity) -> Result<()> {
        let [y, x] = self.ranges();
        let result = &side.result;
        let greatest = self.greatest();
        let caption = match quantity {
            Quantity::Pressure => format!(
                "{}: p ≤ {:.0} MPa, colours to {greatest:.0}; N {:.2} kN",
                side.name,
                1e-6 * result.max_pressure,
                1e-3 * result.normal_force
            ),
            Quantity::Traction => format!(
                "Traction on the wheel, colours to {:.0} MPa; Fx {:.2} kN, Fy {:.2} kN",
                self.friction * greatest,
                1e-3 * result.fx,
                1e-3 * result.fy
            ),
            Quantity::State if side.fields.iter().any(|field| field.slip.is_some()) => {
                "Adhesion blue, slip area orange; arrows: slip of the wheel".into()
            }
            Quantity::State => "Adhesion blue, slip area orange".into(),
        };
        let mut chart = ChartBuilder::on(area)
            .caption(caption, heading(14))
            .margin(px(6))
            .margin_right(px(14))
            .x_label_area_size(px(42))
            .y_label_area_size(px(60))
            .build_cartesian_2d(y, x)?;
        Axes { titles: ["y [mm]", "x, rolling up [mm]"], labels: [8, 6], size: 14 }
            .draw(&mut chart)?;
        for field in &side.fields {
            let colour = |k: usize| {
                let [px, py] = field.traction[k];
                match quantity {
                    _ if field.pressure[k] <= 0.0 => None,
                    Quantity::Pressure => Some(shade(1e-6 * field.pressure[k] / greatest)),
                    Quantity::Traction => {
                        let scale = (self.friction * greatest).max(1e-9);
                        Some(shade(1e-6 * px.hypot(py) / scale))
                    }
                    Quantity::State => match field.adherence[k] {
                        Adherence::None => None,
                        Adherence::Adhesion => Some(ADHESION),
                        Adherence::Slip => Some(SLIP),
                    },
                }
            };
            let cells = runs(field, colour)
                .into_iter()
                .map(|(corners, colour)| Rectangle::new(corners, colour.filled()));
            chart.draw_series(cells)?;
            let arrows = match quantity {
                Quantity::Pressure => None,
                Quantity::Traction => Some(&field.traction),
                Quantity::State => field.slip.as_ref(),
            };
            if let Some(arrows) = arrows {
                let ink = if matches!(quantity, Quantity::State) { INK } else { WHITE };
                for line in arrow_lines(field, arrows) {
                    chart.draw_series([PathElement::new(line, ink.stroke_width(px(1)))])?;
                }
            }
        }
        Ok(())
    }
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

/// Arrows (y, x) [mm] for every few elements, the longest as long as their distance.
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
        let [vx, vy] = vectors[k].map(|v| 0.9 * reach * v / longest);
        let tip = (y + 0.5 * vy, x + 0.5 * vx);
        // Barbs at a third of the length, to both sides.
        let barb =
            |side: f64| (tip.0 - 0.3 * vy + side * 0.16 * vx, tip.1 - 0.3 * vx - side * 0.16 * vy);
        vec![(y - 0.5 * vy, x - 0.5 * vx), tip, barb(1.0), tip, barb(-1.0)]
    });
    arrows.collect()
}
