//! A panel of a figure: what its axes take around the drawing, and a caption above.

use anyhow::Result;
use plotters::prelude::*;

use super::canvas::{Area, heading, px};

/// What the axes take of a panel, in pixels: left, right, above and below, the caption included.
pub const FRAME: [u32; 4] = [66, 14, 36, 48];

/// A chart in `area` whose axes take `left` and `below`, with `right` free, in pixels; a caption and
/// ranges come next.
pub fn framed<'a, 'b>(
    area: &'a Area<'b>,
    [left, below, right]: [u32; 3],
) -> ChartBuilder<'a, 'b, SVGBackend<'b>> {
    let mut chart = ChartBuilder::on(area);
    chart
        .margin(px(8))
        .margin_right(px(right))
        .x_label_area_size(px(below))
        .y_label_area_size(px(left));
    chart
}

/// A chart in `area` with its caption drawn; its axes and ranges come next.
pub fn captioned<'a, 'b>(
    area: &'a Area<'b>,
    caption: String,
) -> Result<ChartBuilder<'a, 'b, SVGBackend<'b>>> {
    let corner = (px(FRAME[0]) as i32, px(12) as i32);
    area.draw(&Text::new(caption, corner, heading(14)))?;
    let mut chart = ChartBuilder::on(area);
    chart
        .margin_top(px(FRAME[2]))
        .margin_bottom(px(6))
        .margin_left(px(6))
        .margin_right(px(FRAME[1]))
        .x_label_area_size(px(FRAME[3] - 6))
        .y_label_area_size(px(FRAME[0] - 6));
    Ok(chart)
}
