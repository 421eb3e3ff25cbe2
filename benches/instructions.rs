//! What options cost, in instructions of one evaluation on the tread; written into docs/benchmarks.md.
//!
//! Where they go: `valgrind --tool=callgrind target/release/deps/instructions-… --evaluate 0 1000`, and `callgrind_annotate`.

mod callgrind;
mod page;

use std::env;
use std::fmt::Write;
use std::hint::black_box;

use wheelrail::element::parameters::{CreepageModel, NormalModel, TangentialModel};
use wheelrail::element::{Element, Input, Output, Parameters};

/// An option as the table names it, what it changes, and the depth of the wheel below first touch [m].
type Case = (&'static str, fn(&mut Parameters), f64);

const DEPTH: f64 = 6e-5;
const CASES: [Case; 10] = [
    ("none on", |_| (), DEPTH),
    ("none on, lifted wheel", |_| (), -1e-3),
    ("`normal.model` = hertz", |p| p.normal_model = NormalModel::Hertz, DEPTH),
    ("`normal.model` = piotrowski_kik", |p| p.normal_model = NormalModel::PiotrowskiKik, DEPTH),
    (
        "`normal.model` = piotrowski_kik_corrected",
        |p| p.normal_model = NormalModel::PiotrowskiKikCorrected,
        DEPTH,
    ),
    ("`creepage.model` = kinematic", |p| p.creepage_model = CreepageModel::Kinematic, DEPTH),
    ("`creepage.model` = flat", |p| p.creepage_model = CreepageModel::Flat, DEPTH),
    ("`tangential.model` = linear", |p| p.tangential_model = TangentialModel::Linear, DEPTH),
    ("`tangential.model` = tables", |p| p.tangential_model = TangentialModel::Tables, DEPTH),
    ("`tangential.model` = fastsim", |p| p.tangential_model = TangentialModel::Fastsim, DEPTH),
];
/// Step of the height between evaluations, so that nothing is reused [m].
const STEP: f64 = 1e-10;

fn main() {
    let arguments: Vec<String> = env::args().skip(1).collect();
    if let [flag, index, evaluations] = arguments.as_slice()
        && flag == callgrind::COUNT
    {
        let number = |text: &String| text.parse::<usize>().expect("a number");
        evaluate(&CASES[number(index)], number(evaluations));
        return;
    }
    // Run as a test it does nothing.
    if !arguments.iter().any(|argument| argument == "--bench") {
        return;
    }
    let counts = (0..CASES.len()).map(|index| callgrind::instructions(&[index.to_string()]));
    let Some(counts) = counts.collect::<Option<Vec<f64>>>() else {
        println!("instructions are counted by Valgrind, which is not installed");
        return;
    };
    let mut text = String::from("| | instructions | |\n|---|---|---|\n");
    for (k, ((name, _, depth), count)) in CASES.iter().zip(&counts).enumerate() {
        let more = match 100.0 * (count / counts[0] - 1.0) {
            more if k > 0 && *depth > 0.0 && more.abs() < 0.5 => "0".into(),
            more if k > 0 && *depth > 0.0 => format!("{more:+.0} %"),
            _ => String::new(),
        };
        writeln!(text, "| {name} | {count:.0} | {more} |").expect("a text");
    }
    print!("{text}");
    page::write("instructions", &text);
}

/// A wheel that runs, in steps of height.
fn evaluate((_, change, depth): &Case, evaluations: usize) {
    let mut parameters = Parameters::default();
    change(&mut parameters);
    let mut input = Input::default();
    input.wheel.position[1] -= 3e-3;
    input.wheel.yaw = 1e-3;
    input.wheel.velocity = [20.0, 0.0, 0.0];
    input.wheel.pitch_rate = -20.0 / 0.46;
    let mut element = Element::new(&parameters, &input, &[]).expect("built-in profiles");
    input.wheel.position[2] = element.nominal_wheel_z() + depth;
    let (mut output, mut step) = (Output::default(), STEP);
    // What happens once only comes with the first.
    for _ in 0..=evaluations {
        step = -step;
        input.wheel.position[2] += step;
        element.evaluate(black_box(&input), &mut output).expect("a good input");
        black_box(&output);
    }
}
