//! What all drawings have in common: colours, fonts, the scale, and how they become SVG.
//!
//! The figures of the documents and of the benchmarks are drawn with it too, each with a part of
//! it.
#![allow(dead_code)]

use anyhow::Result;
use plotters::chart::MeshStyle;
use plotters::coord::Shift;
use plotters::coord::ranged1d::{Ranged, ValueFormatter};
use plotters::prelude::*;
use plotters::style::TextStyle;

// Colours told apart by colour-blind readers (Okabe and Ito 2008).
pub const BLUE: RGBColor = RGBColor(0, 114, 178);
pub const VERMILION: RGBColor = RGBColor(213, 94, 0);
pub const GREEN: RGBColor = RGBColor(0, 158, 115);
pub const PURPLE: RGBColor = RGBColor(204, 121, 167);
pub const ORANGE: RGBColor = RGBColor(230, 159, 0);
pub const SKY: RGBColor = RGBColor(86, 180, 233);
pub const GREY: RGBColor = RGBColor(110, 110, 110);
pub const INK: RGBColor = RGBColor(40, 40, 40);
pub const GRID: RGBColor = RGBColor(225, 225, 225);
pub const RAMP: RGBColor = RGBColor(240, 228, 190);

/// Typefaces, the first that there is.
const FONT: &str = "Helvetica, Arial, sans-serif";

/// Coordinates are whole numbers; with this many to a pixel curves are smooth.
const FINENESS: u32 = 8;

/// What is drawn on.
pub type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Lengths of `pixels` in coordinates.
pub const fn px(pixels: u32) -> u32 {
    FINENESS * pixels
}

/// Plain text, `size` pixels high.
pub fn text(size: u32) -> TextStyle<'static> {
    (FONT, px(size)).into_font().color(&INK)
}

/// A title, `size` pixels high.
pub fn heading(size: u32) -> TextStyle<'static> {
    (FONT, px(size), FontStyle::Bold).into_font().color(&INK)
}

/// What `draw` draws on an area `size` pixels wide and high, as SVG.
pub fn svg(size: (u32, u32), draw: impl FnOnce(&Area<'_>) -> Result<()>) -> Result<String> {
    let mut svg = String::new();
    {
        let area = SVGBackend::with_string(&mut svg, (px(size.0), px(size.1))).into_drawing_area();
        area.fill(&WHITE)?;
        draw(&area)?;
        area.present()?;
    }
    // The viewBox keeps the fine coordinates; only the size that is asked for becomes that of the
    // figure.
    let dimensions = |width, height| format!("width=\"{width}\" height=\"{height}\"");
    Ok(svg.replacen(&dimensions(px(size.0), px(size.1)), &dimensions(size.0, size.1), 1))
}

/// Axes with lines of the grid at their labels alone, which are `size` pixels high.
pub fn style_axes<X, Y>(mesh: &mut MeshStyle<'_, '_, X, Y, SVGBackend<'_>>, size: u32)
where
    X: Ranged + ValueFormatter<<X as Ranged>::ValueType>,
    Y: Ranged + ValueFormatter<<Y as Ranged>::ValueType>,
{
    mesh.set_all_tick_mark_size(px(4))
        .bold_line_style(GRID.stroke_width(px(1)))
        .light_line_style(TRANSPARENT)
        .axis_style(INK.stroke_width(px(1)))
        .label_style(text(size))
        .axis_desc_style(text(size + 1));
}

/// The sign of a curve or of marks in the legend.
pub fn sign((x, y): (i32, i32), colour: RGBColor) -> Rectangle<(i32, i32)> {
    let [width, half] = [16, 2].map(|pixels| px(pixels) as i32);
    Rectangle::new([(x, y - half), (x + width, y + half)], colour.filled())
}

/// Label of an axis value, without digits that say nothing.
#[allow(clippy::trivially_copy_pass_by_ref)] // The signature of plotters' formatters.
pub fn label(value: &f64) -> String {
    // Adding zero turns a negative zero into a plain one.
    ((value * 1e6).round() / 1e6 + 0.0).to_string()
}
