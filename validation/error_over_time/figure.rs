//! Error over time, both logarithmic: a disc where the height is given, a ring where the load is.

use std::ops::Range;

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use wheelrail::element::parameters::{NormalModel, TangentialModel};

use crate::canvas::{
    Area, BLUE, GREEN, GREY, INK, ORANGE, VERMILION, heading, px, style_axes, svg, text,
};
use crate::choices::{DEFAULT_NODES, MARCHES, Normal};
use crate::common::{column, read_table, value};
use crate::labels::{Frame, Labels};
use crate::rows::{NormalRow, Row};
use crate::wheel::TREAD;

const PATH: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/figures/error_over_time.svg");
const SIZE: (u32, u32) = (1240, 620);

/// A mark: times with a height and a load given [µs], error [%], colour and how it looks.
struct Mark {
    times: [f64; 2],
    error: f64,
    colour: RGBColor,
    shape: Shape,
    /// Empty where there is none.
    name: String,
}

impl Mark {
    fn at(&self) -> (f64, f64) {
        (self.times[0], self.error)
    }
}

#[derive(Clone, Copy, PartialEq)]
enum Shape {
    Disc,
    /// What the element starts with.
    Default,
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
        let faster = other.times[TREAD] < own.times[TREAD] * (1.0 + SLACK);
        let better = other.contact[0] < own.contact[0] * (1.0 - SLACK);
        let much_faster = other.times[TREAD] < own.times[TREAD] * (1.0 - SLACK);
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

fn microseconds(height: f64, load: f64) -> [f64; 2] {
    [1e6 * height, 1e6 * load]
}

fn shape(is_default: bool) -> Shape {
    if is_default { Shape::Default } else { Shape::Disc }
}

fn pressure_panel(area: &Area<'_>, rows: &[NormalRow]) {
    let marks: Vec<Mark> = rows
        .iter()
        .map(|row| {
            let Normal { model, count } = row.normal;
            let is_default = model == NormalModel::Strips && count == DEFAULT_NODES;
            Mark {
                times: microseconds(row.times[TREAD], row.load_time),
                error: 100.0 * row.mean_pressure,
                colour: colour(model),
                shape: shape(is_default),
                name: if is_default { format!("{count}, default") } else { count.to_string() },
            }
        })
        .collect();
    panel(
        area,
        "Greatest pressure: mean error against CONTACT, 32 real patches [%]",
        &marks,
        &[],
        "strips or elements across; time without creep force",
    );
}

fn force_panel(area: &Area<'_>, rows: &[Row]) {
    let front: Vec<&Row> = front(rows).into_iter().map(|i| &rows[i]).collect();
    let mut marks: Vec<Mark> = rows
        .iter()
        .filter(|row| row.choice.rolling.model != TangentialModel::Linear)
        .map(|row| {
            let (normal, rolling) = (row.choice.normal, row.choice.rolling);
            let is_default = row.choice.is_default();
            let is_of_default = normal.model == NormalModel::Strips && rolling == MARCHES;
            let is_on_front = front.iter().any(|other| other.choice == row.choice);
            let name = match normal.model {
                _ if is_default => format!("{}, default", normal.count),
                NormalModel::BoundaryElement => normal.count.to_string(),
                _ if is_of_default => normal.count.to_string(),
                _ if is_on_front || normal.model == NormalModel::Hertz => rolling.name(),
                _ => String::new(),
            };
            Mark {
                times: microseconds(row.times[TREAD], row.load_time),
                error: 100.0 * row.contact[0],
                colour: colour(normal.model),
                shape: shape(is_default),
                name,
            }
        })
        .collect();
    let mut line: Vec<(f64, f64)> =
        front.iter().map(|row| (1e6 * row.times[TREAD], 100.0 * row.contact[0])).collect();
    line.sort_by(|a, b| a.0.total_cmp(&b.0));
    let table = read_table("contact_25_1/times.csv");
    marks.extend(table.rows.iter().map(|row| {
        let method = &row[column(&table, "method")];
        let time = 1e3 * value(&table, row, "median_ms");
        Mark {
            times: [time; 2],
            error: 100.0 * value(&table, row, "mean_error"),
            colour: INK,
            shape: if method.starts_with("FULL") { Shape::Triangle } else { Shape::Cross },
            name: format!("CONTACT {method}"),
        }
    }));
    panel(
        area,
        "Creep force: mean error against CONTACT, 656 states of real patches [% of the limit]",
        &marks,
        &line,
        "strips or elements across (with marches), or the tangential model",
    );
}

fn widened(values: impl Iterator<Item = f64>, [below, above]: [f64; 2]) -> Range<f64> {
    let (low, high) = values.fold((f64::MAX, f64::MIN), |(low, high), v| (low.min(v), high.max(v)));
    low / below..high * above
}

fn panel(area: &Area<'_>, title: &str, marks: &[Mark], front: &[(f64, f64)], numbers: &str) {
    let x = widened(marks.iter().flat_map(|m| m.times), [1.5, 2.0]);
    // Room for the legend below.
    let y = widened(marks.iter().map(|m| m.error), [9.0, 1.6]);
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
        let thin = mark.colour.mix(0.6).stroke_width(px(1));
        let [height, load] = mark.times.map(|time| (time, mark.error));
        let is_ours = matches!(mark.shape, Shape::Disc | Shape::Default);
        if is_ours {
            chart.draw_series(LineSeries::new([height, load], thin)).expect("drawing");
            chart.draw_series([Circle::new(load, px(4), WHITE.filled())]).expect("drawing");
            let ring = mark.colour.stroke_width(px(1));
            chart.draw_series([Circle::new(load, px(4), ring)]).expect("drawing");
        }
        let style = mark.colour.filled();
        let drawn = match mark.shape {
            Shape::Disc => chart.draw_series([Circle::new(height, px(4), style)]).map(drop),
            Shape::Default => chart.draw_series([Circle::new(height, px(7), style)]).map(drop),
            Shape::Cross => chart
                .draw_series([Cross::new(height, px(4), mark.colour.stroke_width(px(2)))])
                .map(drop),
            Shape::Triangle => {
                chart.draw_series([TriangleMarker::new(height, px(6), style)]).map(drop)
            }
        };
        drawn.expect("drawing");
    }
    let place = |(x, y): (f64, f64)| {
        let (base_x, base_y) = area.get_base_pixel();
        let (x, y) = chart.backend_coord(&(x, y));
        (x - base_x, y - base_y)
    };
    let (x, y) = chart.plotting_area().get_pixel_range();
    let (base_x, base_y) = area.get_base_pixel();
    let frame = Frame {
        across: x.start - base_x..x.end - base_x,
        down: y.start - base_y..y.end - base_y - LEGEND,
    };
    let mut labels = Labels::new(frame);
    for mark in marks {
        let [height, load] = mark.times.map(|time| place((time, mark.error)));
        labels.keep_clear(height, px(8) as i32);
        labels.keep_clear(load, px(5) as i32);
        labels.keep_clear_between(height, load);
    }
    for mark in marks.iter().filter(|mark| !mark.name.is_empty()) {
        labels.put(area, place(mark.at()), &mark.name);
    }
    legend(area, marks, numbers);
}

/// Height of the room for the legend.
const LEGEND: i32 = px(150) as i32;

/// Colours of the normal models and what marks mean, lower left.
fn legend(area: &Area<'_>, marks: &[Mark], numbers: &str) {
    let (_, height) = area.dim_in_pixel();
    let models = [
        NormalModel::Hertz,
        NormalModel::PiotrowskiKik,
        NormalModel::PiotrowskiKikCorrected,
        NormalModel::Strips,
        NormalModel::BoundaryElement,
    ];
    let style = || text(11).pos(Pos::new(HPos::Left, VPos::Center));
    let bottom = height as i32 - px(64) as i32;
    let line = |number: usize| bottom - (number as u32 * px(15)) as i32;
    let write = |number: usize, words: &str| {
        area.draw(&Text::new(words.to_owned(), (px(92) as i32, line(number)), style()))
            .expect("drawing");
    };
    let sign = |number: usize| (px(82) as i32, line(number));
    write(0, &format!("numbers: {numbers}"));
    area.draw(&Circle::new(sign(1), px(4), INK.stroke_width(px(1)))).expect("drawing");
    write(1, "load given");
    area.draw(&Circle::new(sign(2), px(4), INK.filled())).expect("drawing");
    write(2, "height given, in the colour of the normal model:");
    let drawn = |model: &NormalModel| marks.iter().any(|mark| mark.colour == colour(*model));
    for (number, model) in models.into_iter().filter(drawn).rev().enumerate() {
        let normal = Normal { model, count: 0 };
        area.draw(&Circle::new(sign(number + 3), px(4), colour(model).filled())).expect("drawing");
        write(number + 3, normal.model_name());
    }
}
