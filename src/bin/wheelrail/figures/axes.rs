//! The axes that all charts share.

use anyhow::Result;
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;

use super::canvas::{GRID, label, px, style_axes, text};

/// A chart of two linear axes.
pub type Chart<'a, 'b> =
    ChartContext<'a, SVGBackend<'b>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

/// Titles of both axes, at most how many labels each has, and the size of the labels in pixels.
#[derive(Clone, Copy, Debug)]
pub struct Axes<'a> {
    pub titles: [&'a str; 2],
    pub labels: [usize; 2],
    pub size: u32,
}

impl Axes<'_> {
    /// Draws both axes and the lines of the grid at their labels.
    pub fn draw(self, chart: &mut Chart<'_, '_>) -> Result<()> {
        let [x, y] = self.titles;
        let mut mesh = chart.configure_mesh();
        style_axes(&mut mesh, self.size);
        mesh.x_labels(self.labels[0])
            .y_labels(self.labels[1])
            .x_label_formatter(&label)
            .y_label_formatter(&label);
        if !x.is_empty() {
            mesh.x_desc(x);
        }
        if !y.is_empty() {
            mesh.y_desc(y);
        }
        mesh.draw()?;
        Ok(())
    }
}

/// Draws the legend of a chart, its labels `size` pixels high.
pub fn legend<'a, 'b: 'a>(
    chart: &mut Chart<'a, 'b>,
    at: SeriesLabelPosition,
    size: u32,
) -> Result<()> {
    chart
        .configure_series_labels()
        .position(at)
        .legend_area_size(px(26))
        .margin(px(6))
        .background_style(WHITE.mix(0.85))
        .border_style(GRID)
        .label_font(text(size))
        .draw()?;
    Ok(())
}
