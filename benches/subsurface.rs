//! What displacement and stress at a point below the surface cost, in instructions and in time;
//! written into docs/benchmarks.md.

mod callgrind;
mod page;

use std::env;
use std::fmt::Write;
use std::hint::black_box;
use std::time::Instant;

use wheelrail::element::Parameters;
use wheelrail::element::parameters::{NormalModel, TangentialModel};
use wheelrail::planar::{Indentation, PlanarCase};
use wheelrail::subsurface::{Body, Measure, State, SurfaceLoad};

/// Cases: their names, models and boundary elements along and across.
const CASES: [(&str, NormalModel, TangentialModel, usize); 4] = [
    ("20 strips, 20 elements along, marches", NormalModel::Strips, TangentialModel::Marches, 40),
    (
        "20 strips, 20 elements along, pressure alone",
        NormalModel::Strips,
        TangentialModel::None,
        40,
    ),
    (
        "boundary elements, 20 x 20",
        NormalModel::BoundaryElement,
        TangentialModel::BoundaryElement,
        20,
    ),
    (
        "boundary elements, 40 x 40",
        NormalModel::BoundaryElement,
        TangentialModel::BoundaryElement,
        40,
    ),
];
/// Points of a timed run, and runs of which the fastest counts.
const POINTS: usize = 5_000;
const RUNS: usize = 9;

fn main() {
    let arguments: Vec<String> = env::args().skip(1).collect();
    if let [flag, index, points] = arguments.as_slice()
        && flag == callgrind::COUNT
    {
        let number = |text: &String| text.parse::<usize>().expect("a number");
        evaluate(&load(number(index)), number(points));
        return;
    }
    // Run as a test it does nothing.
    if !arguments.iter().any(|argument| argument == "--bench") {
        return;
    }
    let mut text = String::from(
        "| load | instructions a point | µs a point | points a second and core | greatest of all measures [ms] |\n|---|---|---|---|---|\n",
    );
    for (k, (name, ..)) in CASES.iter().enumerate() {
        let count = callgrind::instructions(&[k.to_string()]);
        let count = count.map_or_else(|| "no Valgrind".into(), |count| format!("{count:.0}"));
        let load = load(k);
        let best = (0..RUNS).map(|_| evaluate(&load, POINTS)).fold(f64::INFINITY, f64::min);
        let begin = Instant::now();
        black_box(Measure::ALL.map(|measure| load.greatest(measure)));
        let search = 1e3 * begin.elapsed().as_secs_f64();
        let time = best / POINTS as f64;
        let a_second = 1e3 * (1e-3 / time).round();
        let time = page::microseconds(time);
        writeln!(text, "| {name} | {count} | {time} | {a_second:.0} | {search:.0} |")
            .expect("a text");
    }
    print!("{text}");
    page::write("subsurface", &text);
}

/// The load of a patch of wheel and rail under 80 kN that slips at its trailing edge.
fn load(index: usize) -> SurfaceLoad {
    let (_, normal_model, tangential_model, elements) = CASES[index];
    let separation: Vec<[f64; 2]> =
        (-50..=50).map(|i| 3e-4 * f64::from(i)).map(|y| [y, y * y / 0.6]).collect();
    let creepage = [1e-3, -5e-4, 0.1];
    let given = Indentation::Load(8e4);
    let case = Parameters::default().planar_case(&separation, 0.46, given, creepage, 0.3);
    let case = PlanarCase { normal_model, tangential_model, elements: [elements; 2], ..case };
    SurfaceLoad::below(&case, Body::Rail).expect("a good case")
}

/// Time of `points` points all over the patch and below it [s].
fn evaluate(load: &SurfaceLoad, points: usize) -> f64 {
    let places: Vec<[f64; 3]> = (0..points)
        .map(|k| {
            let k = k as f64;
            [8e-3 * (0.7 * k).sin(), 8e-3 * (1.3 * k).cos(), 6e-3 * (1.0 + (0.11 * k).sin())]
        })
        .collect();
    let mut states = vec![State::default(); points];
    let begin = Instant::now();
    load.states(black_box(&places), &mut states).expect("points of the body");
    black_box(&states);
    begin.elapsed().as_secs_f64()
}
