//! One contact: profiles, pressure, tractions, adhesion and slip, by two kinds of models side by
//! side.

use std::path::Path;

use anyhow::Result;
use plotters::prelude::*;
use wheelrail::element::FlatContact;

use super::axes::Axes;
use super::canvas::{Area, BLUE, GREY, PURPLE, VERMILION, heading, px, text};
use super::patch_panel::{Panels, Side};
use super::save;

const WIDTH: u32 = 1280;
const PROFILES: u32 = 350;
const TITLE: u32 = 60;
/// Width of the signs and scales beside the panels.
const SCALE: u32 = 110;
/// Height of the legend above the profiles.
const LEGEND: u32 = 26;
/// How deep the enlarged overlap is drawn, over the width of the picture.
const LENS: f64 = 0.05;
/// The same over its height.
const LENS_OF_HEIGHT: f64 = 0.3;

/// What is drawn.
pub struct Figure {
    /// What the contact is.
    pub title: String,
    /// All contacts of the wheel; none for a planar case.
    pub contacts: Vec<FlatContact>,
    /// Index of the one whose patch is drawn.
    pub drawn: usize,
    /// The models of the row, and boundary elements.
    pub sides: [Side; 2],
}

impl Figure {
    /// Draws the figure into the file `path`.
    pub fn draw(&self, path: &Path) -> Result<()> {
        let profiles = if self.contacts.is_empty() { 0 } else { PROFILES };
        let panels = Panels::new(&self.sides, (WIDTH - SCALE) / 2);
        save(
            path,
            (WIDTH, TITLE + profiles + panels.rows().len() as u32 * panels.height()),
            |area| {
                let area = area.titled(&self.title, heading(24))?;
                let (top, patches) = area.split_vertically(px(profiles));
                if profiles > 0 {
                    self.draw_profiles(&top)?;
                }
                let mut rest = patches;
                for &quantity in panels.rows() {
                    let (row, below) = rest.split_vertically(px(panels.height()));
                    let (both, scale) = row.split_horizontally(px(WIDTH - SCALE));
                    for (cell, side) in both.split_evenly((1, 2)).iter().zip(&self.sides) {
                        panels.draw(cell, side, quantity)?;
                    }
                    panels.draw_scale(&scale, quantity)?;
                    rest = below;
                }
                Ok(())
            },
        )
    }

    /// How many times the overlap is drawn: 1, 2 or 5 times a power of ten, for a picture that is
    /// `width` wide and, maybe stretched, `height` high [m].
    fn enlargement(&self, width: f64, height: f64) -> f64 {
        let deepest = self.contacts.iter().map(|c| c.penetration).fold(1e-9, f64::max);
        let wanted = (LENS * width).min(LENS_OF_HEIGHT * height) / deepest;
        let wanted = wanted.max(1.0);
        let power = 10.0_f64.powf(wanted.log10().floor());
        power * [5.0, 2.0, 1.0].into_iter().find(|step| step * power <= wanted).unwrap_or(1.0)
    }

    fn draw_profiles(&self, area: &Area<'_>) -> Result<()> {
        let outlines = || self.contacts.iter().flat_map(|c| [&c.wheel, &c.rail_head]);
        let range = |c: usize| {
            let values = outlines().flatten().map(|point| 1e3 * point[c]);
            super::range_of(values, 1.0)
        };
        // The track's z points down.
        let z = range(1);
        let y = range(0);
        let enlarged = self.enlargement(1e-3 * (y.end - y.start), 1e-3 * (z.end - z.start));
        let (legend, area) = area.split_vertically(px(LEGEND));
        let names = [
            ("rail", GREY),
            ("wheel", BLUE),
            (&*format!("overlap before the bodies deform, {enlarged} times as deep"), PURPLE),
            ("contact point of the patch below", VERMILION),
        ];
        draw_legend(&legend, &names)?;
        let mut chart = ChartBuilder::on(&area)
            .margin(px(6))
            .margin_right(px(16))
            .x_label_area_size(px(44))
            .y_label_area_size(px(60))
            .build_cartesian_2d(y, z.end..z.start)?;
        Axes { titles: ["y, to the field side [mm]", "z, down [mm]"], labels: [8, 6], size: 14 }
            .draw(&mut chart)?;
        for (index, contact) in self.contacts.iter().enumerate() {
            let lens = lens(contact, enlarged).map(|[y, z]| (1e3 * y, 1e3 * z));
            chart
                .draw_series([Polygon::new(lens.collect::<Vec<_>>(), PURPLE.mix(0.7).filled())])?;
            for (outline, color) in [(&contact.rail_head, GREY), (&contact.wheel, BLUE)] {
                let points = outline.iter().map(|p| (1e3 * p[0], 1e3 * p[1]));
                chart.draw_series(LineSeries::new(points, color.stroke_width(px(2))))?;
            }
            let [y, z] = contact.position.map(|value| 1e3 * value);
            let size = if index == self.drawn { px(6) } else { px(4) };
            chart.draw_series([Circle::new((y, z), size, VERMILION.filled())])?;
        }
        Ok(())
    }
}

/// Outline of the overlap (y, z) [m]: along the contact plane and, `enlarged` times, into the rail.
fn lens(contact: &FlatContact, enlarged: f64) -> impl Iterator<Item = [f64; 2]> {
    let (sin, cos) = contact.contact_angle.sin_cos();
    let [y0, z0] = contact.position;
    let at =
        move |along: f64, into: f64| [y0 + along * cos - into * sin, z0 + along * sin + into * cos];
    let depth = contact.penetration;
    let touching = move |point: &&[f64; 2]| point[1] < depth;
    let there = contact.separation.iter().filter(touching).map(move |p| at(p[0], 0.0));
    let back = contact.separation.iter().rev().filter(touching);
    there.chain(back.map(move |p| at(p[0], enlarged * (depth - p[1]))))
}

/// Names and colours in a row, above what they belong to.
fn draw_legend(area: &Area<'_>, names: &[(&str, RGBColor)]) -> Result<()> {
    let (mut x, y) = (px(60) as i32, px(LEGEND / 2) as i32);
    for (name, colour) in names {
        let end = x + px(22) as i32;
        area.draw(&PathElement::new(vec![(x, y), (end, y)], colour.stroke_width(px(4))))?;
        area.draw(&Text::new(*name, (end + px(8) as i32, y - px(6) as i32), text(14)))?;
        // A letter is about half as wide as it is high.
        x = end + px(40 + 7 * name.chars().count() as u32) as i32;
    }
    Ok(())
}
