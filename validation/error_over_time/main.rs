//! Error beside time of every combination of models, in one run:
//! `cargo bench --no-default-features --bench error_over_time`.
//!
//! Errors are those against stored results of the boundary element program CONTACT on planar cases,
//! and against the boundary elements of this crate, solved here, on contacts of a wheel. Written
//! are the tables in docs/benchmarks.md between their marks, the figure
//! docs/figures/error_over_time.svg, and target/reports/error_over_time.csv with everything. It
//! takes minutes; nothing else should run.

#[path = "../../benches/callgrind/mod.rs"]
mod callgrind;
#[path = "../../src/bin/wheelrail/figures/canvas.rs"]
mod canvas;
mod choices;
#[path = "../../tests/suite/common/mod.rs"]
mod common;
mod contact_program;
mod figure;
mod labels;
#[path = "../../benches/page/mod.rs"]
mod page;
mod report;
mod rows;
mod times;
mod wheel;

use std::env;

use choices::{BOUNDARY, Choice, NORMAL, Normal, ROLLING, WITHOUT, boundary};
use common::{median_and_worst, quantiles};
use contact_program::Sets;
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;
use rows::{EllipseRow, NormalRow, Row};
use wheelrail::element::parameters::VerticalMode;

/// What may be given of the vertical motion.
const GIVEN: [VerticalMode; 2] = [VerticalMode::Penetration, VerticalMode::Load];

fn main() {
    let arguments: Vec<String> = env::args().skip(1).collect();
    if let [flag, index, given, evaluations] = arguments.as_slice()
        && flag == callgrind::COUNT
    {
        let number = |text: &str| text.parse().expect("a whole number");
        let input = wheel::timed_input(wheel::TREAD);
        let given = GIVEN[number(given)];
        times::evaluate(Choice::all()[number(index)], given, &input, number(evaluations));
        return;
    }
    if !arguments.iter().any(|argument| argument == "--bench") {
        println!("run by: cargo bench --no-default-features --bench error_over_time");
        return;
    }
    let sets = Sets::read();
    let all = Choice::all();
    let bar = progress("wheel by boundary elements", wheel::COUNT);
    let cases = wheel::cases(|| bar.inc(1));
    bar.finish();

    let bar = progress("errors", all.len() + NORMAL.len() + BOUNDARY.len() + ROLLING.len());
    let ellipses: Vec<EllipseRow> = ROLLING
        .par_iter()
        .map(|&rolling| {
            bar.inc(1);
            EllipseRow { rolling, errors: quantiles(sets.ellipses(rolling)) }
        })
        .collect();
    let normals: Vec<Normal> =
        NORMAL.into_iter().chain(BOUNDARY.map(|count| boundary(count).normal)).collect();
    let mut normal_rows: Vec<NormalRow> = normals
        .par_iter()
        .map(|&normal| {
            bar.inc(1);
            normal_row(&sets, &cases, normal)
        })
        .collect();
    let mut rows: Vec<Row> = all
        .par_iter()
        .map(|&choice| {
            bar.inc(1);
            row(&sets, &cases, choice)
        })
        .collect();
    bar.finish();

    // One after another: times want the machine for themselves.
    let inputs: Vec<_> = (0..wheel::PLACES.len()).map(wheel::timed_input).collect();
    let times = |choice| {
        let [height, load] = GIVEN;
        let tread = &inputs[wheel::TREAD];
        let times = inputs.iter().map(|input| times::time(choice, height, input)).collect();
        (times, times::time(choice, load, tread))
    };
    let bar = progress("times", rows.len() + normal_rows.len());
    for row in &mut normal_rows {
        (row.times, row.load_time) = times(Choice { normal: row.normal, rolling: WITHOUT });
        bar.inc(1);
    }
    for row in &mut rows {
        (row.times, row.load_time) = times(row.choice);
        bar.inc(1);
    }
    bar.finish();

    let bar = progress("instructions", rows.len());
    rows.par_iter_mut().enumerate().for_each(|(index, row)| {
        if !row.choice.normal.is_slow() {
            row.instructions = [0, 1].map(|given: usize| {
                callgrind::instructions(&[index.to_string(), given.to_string()])
            });
        }
        bar.inc(1);
    });
    bar.finish();

    let sizes = sets.sizes();
    report::write(&normal_rows, &rows, &ellipses, sizes);
    figure::draw(&normal_rows, &rows);
}

fn progress(what: &'static str, length: usize) -> ProgressBar {
    let style = ProgressStyle::with_template("{msg:28} {bar:40} {pos}/{len} {elapsed}");
    ProgressBar::new(length as u64).with_style(style.expect("a good template")).with_message(what)
}

const NORMAL_QUANTITIES: [fn(&contact_program::NormalError) -> f64; 3] =
    [|e| e.load, |e| e.pressure, |e| e.area];
const WHEEL_QUANTITIES: [fn(&wheel::Errors) -> f64; 3] = [|e| e.load, |e| e.pressure, |e| e.area];

fn normal_row(sets: &Sets, cases: &[wheel::Case], normal: Normal) -> NormalRow {
    let (errors, fallbacks) = sets.normal(normal);
    let contact = NORMAL_QUANTITIES.map(|q| {
        let of = |one: bool| errors.iter().filter(|e| e.one_region == one).map(q).collect();
        let [median, worst] = median_and_worst(of(true));
        [median, worst, median_and_worst(of(false))[1]]
    });
    let mean_pressure = errors.iter().map(|e| e.pressure).sum::<f64>() / errors.len() as f64;
    let errors = wheel::errors(cases, Choice { normal, rolling: WITHOUT });
    let wheel = WHEEL_QUANTITIES.map(|q| median_and_worst(errors.iter().map(q).collect()));
    NormalRow {
        normal,
        contact,
        mean_pressure,
        wheel,
        fallbacks,
        times: Vec::new(),
        load_time: 0.0,
    }
}

fn row(sets: &Sets, cases: &[wheel::Case], choice: Choice) -> Row {
    let errors = sets.rolling(choice);
    let moment = errors.iter().map(|e| e.moment).sum::<f64>() / errors.len() as f64;
    Row {
        choice,
        contact: quantiles(errors.iter().map(|e| e.force).collect()),
        moment,
        wheel: quantiles(wheel::errors(cases, choice).iter().map(|e| e.force).collect()),
        times: Vec::new(),
        load_time: 0.0,
        instructions: [None; 2],
    }
}
