//! Error over time, both logarithmic.

use std::ops::Range;

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use wheelrail::element::parameters::{NormalModel, TangentialModel};

use crate::canvas::{
    Area, BLUE, GREEN, GREY, INK, ORANGE, VERMILION, heading, px, style_axes, svg, text,
};
use crate::choices::Normal;
use crate::common::{column, read_table, value};
use crate::{NormalRow, Row};

const PATH: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/figures/error_over_time.svg");
const SIZE: (u32, u32) = (1180, 600);
/// A mark: time [µs], error [%], colour and how it looks.
struct Mark {
    at: (f64, f64),
    colour: RGBColor,
    shape: Shape,
    name: String,
}

#[derive(Clone, Copy, PartialEq)]
enum Shape {
    Disc,
    Cross,
    Triangle,
}

fn colour(model: NormalModel) -> RGBColor {
    match model {
        NormalModel::Hertz => GREY,
        NormalModel::PiotrowskiKik => VERMILION,
        NormalModel::PiotrowskiKikCorrected => ORANGE,
        NormalModel::Strips => BLUE,
        NormalModel::BoundaryElement => GREEN,
        _ => BLACK,
    }
}

/// Share by which another combination must be better to count as better: times are that noisy.
const SLACK: f64 = 0.03;

/// Indices of the combinations that none beats in both time and mean error.
pub fn front(rows: &[Row]) -> Vec<usize> {
    let beats = |other: &Row, own: &Row| {
        let faster = other.times[0] < own.times[0] * (1.0 + SLACK);
        let better = other.contact[0] < own.contact[0] * (1.0 - SLACK);
        let much_faster = other.times[0] < own.times[0] * (1.0 - SLACK);
        let as_good = other.contact[0] < own.contact[0] * (1.0 + SLACK);
        (faster && better) || (much_faster && as_good)
    };
    (0..rows.len()).filter(|&i| !rows.iter().any(|other| beats(other, &rows[i]))).collect()
}

/// Draws both panels.
pub fn draw(normals: &[NormalRow], rows: &[Row]) {
    let drawing = svg(SIZE, |area| {
        let (left, right) = area.split_horizontally(px(SIZE.0 / 2));
        pressure_panel(&left, normals);
        force_panel(&right, rows);
        Ok(())
    });
    std::fs::write(PATH, drawing.expect("drawing")).expect("docs/figures");
}

fn pressure_panel(area: &Area<'_>, rows: &[NormalRow]) {
    let marks: Vec<Mark> = rows
        .iter()
        .map(|row| Mark {
            at: (1e6 * row.times[0], 100.0 * row.mean_pressure),
            colour: colour(row.normal.model),
            shape: Shape::Disc,
            name: row.normal.name(),
        })
        .collect();
    panel(
        area,
        "Greatest pressure: mean error against CONTACT, 32 real patches [%]",
        &marks,
        &[],
        true,
    );
}

fn force_panel(area: &Area<'_>, rows: &[Row]) {
    let mut marks: Vec<Mark> = rows
        .iter()
        .filter(|row| row.choice.rolling.model != TangentialModel::Linear)
        .map(|row| Mark {
            at: (1e6 * row.times[0], 100.0 * row.contact[0]),
            colour: colour(row.choice.normal.model),
            shape: Shape::Disc,
            name: row.choice.name(),
        })
        .collect();
    let front: Vec<(f64, f64)> = {
        let mut points: Vec<(f64, f64)> = front(rows)
            .iter()
            .map(|&i| (1e6 * rows[i].times[0], 100.0 * rows[i].contact[0]))
            .collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        points
    };
    let table = read_table("contact_25_1/times.csv");
    marks.extend(table.rows.iter().map(|row| Mark {
        at: (1e3 * value(&table, row, "median_ms"), 100.0 * value(&table, row, "mean_error")),
        colour: INK,
        shape: if row[column(&table, "method")].starts_with("FULL") {
            Shape::Triangle
        } else {
            Shape::Cross
        },
        name: format!("CONTACT {}", &row[column(&table, "method")]),
    }));
    panel(
        area,
        "Creep force: mean error against CONTACT, real patches [% of friction limit]",
        &marks,
        &front,
        false,
    );
}

fn widened(values: impl Iterator<Item = f64>) -> Range<f64> {
    let (low, high) = values.fold((f64::MAX, f64::MIN), |(low, high), v| (low.min(v), high.max(v)));
    low / 1.6..high * 1.6
}

fn panel(area: &Area<'_>, title: &str, marks: &[Mark], front: &[(f64, f64)], named: bool) {
    let x = widened(marks.iter().map(|m| m.at.0));
    let y = widened(marks.iter().map(|m| m.at.1));
    let mut chart = ChartBuilder::on(area)
        .caption(title, heading(14))
        .margin(px(10))
        .x_label_area_size(px(44))
        .y_label_area_size(px(56))
        .build_cartesian_2d(x.log_scale(), y.log_scale())
        .expect("drawing");
    let mut mesh = chart.configure_mesh();
    style_axes(&mut mesh, 12);
    mesh.x_desc("One evaluation on the tread, search included [µs]")
        .x_label_formatter(&|v| format!("{v}"))
        .y_label_formatter(&|v| format!("{v}"))
        .draw()
        .expect("drawing");
    chart
        .draw_series(LineSeries::new(front.iter().copied(), INK.mix(0.35).stroke_width(px(2))))
        .expect("drawing");
    for mark in marks {
        let style = mark.colour.filled();
        let drawn = match mark.shape {
            Shape::Disc => chart.draw_series([Circle::new(mark.at, px(4), style)]).map(drop),
            Shape::Cross => chart
                .draw_series([Cross::new(mark.at, px(5), mark.colour.stroke_width(px(2)))])
                .map(drop),
            Shape::Triangle => {
                chart.draw_series([TriangleMarker::new(mark.at, px(6), style)]).map(drop)
            }
        };
        drawn.expect("drawing");
    }
    let labelled: Vec<(&Mark, (i32, i32))> = marks
        .iter()
        .filter(|mark| named || mark.shape != Shape::Disc || front.contains(&mark.at))
        .map(|mark| (mark, chart.backend_coord(&mark.at)))
        .collect();
    name(area, &labelled);
    legend(area, marks);
}

/// Writes the names beside their marks, to the left of those on the right, one under the other
/// where they would cover each other.
fn name(area: &Area<'_>, marks: &[(&Mark, (i32, i32))]) {
    let (width, _) = area.dim_in_pixel();
    let (left_end, _) = area.get_base_pixel();
    let middle = left_end + (width / 2) as i32;
    let mut sorted: Vec<_> = marks.to_vec();
    sorted.sort_by_key(|(_, (_, y))| *y);
    let height = px(13) as i32;
    // Lowest place taken so far, left and right of the middle.
    let mut taken = [i32::MIN; 2];
    for (mark, (x, y)) in sorted {
        let side = usize::from(x > middle);
        let anchor = [HPos::Left, HPos::Right][side];
        let place = y.max(taken[side].saturating_add(height));
        taken[side] = place;
        let x = x + [px(9) as i32, -(px(9) as i32)][side];
        let style = text(11).pos(Pos::new(anchor, VPos::Center));
        let own = area.get_base_pixel();
        let name = Text::new(mark.name.clone(), (x - own.0, place - own.1), style);
        area.draw(&name).expect("drawing");
    }
}

/// Colours of the normal models, lower left.
fn legend(area: &Area<'_>, marks: &[Mark]) {
    let (_, height) = area.dim_in_pixel();
    let models = [
        NormalModel::Hertz,
        NormalModel::PiotrowskiKik,
        NormalModel::PiotrowskiKikCorrected,
        NormalModel::Strips,
        NormalModel::BoundaryElement,
    ];
    let bottom = height as i32 - px(64) as i32;
    for (line, model) in models.into_iter().rev().enumerate() {
        if !marks.iter().any(|mark| mark.colour == colour(model)) {
            continue;
        }
        let y = bottom - (line as u32 * px(15)) as i32;
        let normal = Normal { model, count: 0 };
        let style = text(11).pos(Pos::new(HPos::Left, VPos::Center));
        area.draw(&Circle::new((px(82) as i32, y), px(4), colour(model).filled()))
            .expect("drawing");
        area.draw(&Text::new(normal.model_name(), (px(92) as i32, y), style)).expect("drawing");
    }
}
