//! What options cost, in instructions of one evaluation on the tread; written into
//! docs/benchmarks.md.
//!
//! Where they go: `valgrind --tool=callgrind target/release/deps/instructions-… --evaluate 0 1000`,
//! and `callgrind_annotate`.

mod callgrind;
mod page;

use std::env;
use std::f64::consts::TAU;
use std::fmt::Write;
use std::hint::black_box;

use wheelrail::element::parameters::{
    CreepageModel, FrictionDistribution, NormalModel, TangentialModel, VerticalMode,
};
use wheelrail::element::{Element, Input, Output, Parameters};

/// An option, on top of another one.
struct Case {
    /// As the table names it.
    name: &'static str,
    /// What it is compared with, by its place in the table.
    over: usize,
    change: fn(&mut Parameters),
    /// Depth of the wheel below first touch [m].
    depth: f64,
}

const DEPTH: f64 = 6e-5;
/// Place of the fastest models.
const FASTEST: usize = 12;
const CASES: [Case; 37] = [
    option("none on", |_| ()),
    Case { depth: -1e-3, ..option("none on, lifted wheel", |_| ()) },
    option("`normal.model` = hertz", |p| p.normal_model = NormalModel::Hertz),
    option("`normal.model` = piotrowski_kik", |p| p.normal_model = NormalModel::PiotrowskiKik),
    option("`normal.model` = piotrowski_kik_corrected", |p| {
        p.normal_model = NormalModel::PiotrowskiKikCorrected;
    }),
    option("`creepage.model` = kinematic", |p| p.creepage_model = CreepageModel::Kinematic),
    option("`creepage.model` = flat", |p| p.creepage_model = CreepageModel::Flat),
    option("`tangential.model` = linear", |p| p.tangential_model = TangentialModel::Linear),
    option("`tangential.model` = tables", |p| p.tangential_model = TangentialModel::Tables),
    option("`tangential.model` = fastsim", |p| p.tangential_model = TangentialModel::Fastsim),
    option("`tangential.model` = fastsim_corrected", |p| {
        p.tangential_model = TangentialModel::FastsimCorrected;
    }),
    option("`tangential.model` = none", |p| p.tangential_model = TangentialModel::None),
    option("piotrowski_kik + fastsim, flat", fastest),
    option("`friction.distribution` = regions", regions),
    option("`friction.falling.*` and `friction.reduction.*`", falling),
    option("`friction.temperature.*`", hot),
    of_fastest("with `friction.distribution` = regions", |p| {
        fastest(p);
        regions(p);
    }),
    of_fastest("with `friction.distribution` = profile", |p| {
        fastest(p);
        p.friction_distribution = FrictionDistribution::Profile;
        p.friction_profile = PROFILE.into();
    }),
    of_fastest("with `friction.falling.*` and `friction.reduction.*`", |p| {
        fastest(p);
        falling(p);
    }),
    of_fastest("with `friction.temperature.*`", |p| {
        fastest(p);
        hot(p);
    }),
    option("`rail[1].corrugation.*`", corrugated),
    option("`rail[1].profile` with sections", varying),
    option("`rail[1].profile` with sections, corrugated", |p| {
        varying(p);
        corrugated(p);
    }),
    option("`rail[1].roller_radius`", roller),
    option("`rail[1].roller_radius`, corrugated", |p| {
        roller(p);
        corrugated(p);
    }),
    option("`wheel.flat.*`, on the flat", on_flat),
    option("`wheel.out_of_round.*`", out_of_round),
    of_fastest("with `wheel.flat.*`, on the flat", |p| {
        fastest(p);
        on_flat(p);
    }),
    of_fastest("with `wheel.out_of_round.*`", |p| {
        fastest(p);
        out_of_round(p);
    }),
    of_fastest("with `rail[1].corrugation.*`", |p| {
        fastest(p);
        corrugated(p);
    }),
    of_fastest("with `rail[1].profile` with sections", |p| {
        fastest(p);
        varying(p);
    }),
    of_fastest("with `rail[1].profile` with sections, corrugated", |p| {
        fastest(p);
        varying(p);
        corrugated(p);
    }),
    of_fastest("with `rail[1].roller_radius`", |p| {
        fastest(p);
        roller(p);
    }),
    of_fastest("with `rail[1].roller_radius`, corrugated", |p| {
        fastest(p);
        roller(p);
        corrugated(p);
    }),
    option("`vertical.mode` = load", loaded),
    option("`normal.model` = hertz, `vertical.mode` = load", |p| {
        p.normal_model = NormalModel::Hertz;
        loaded(p);
    }),
    of_fastest("with `vertical.mode` = load", |p| {
        fastest(p);
        loaded(p);
    }),
];
/// Load where it is given [N].
const LOAD: f64 = 5e4;
/// Two rail heads in turns, a metre apart.
const SECTIONS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/benches/sections.csv");
const ROLLER: f64 = 0.8;
/// Waves of 33 mm around the roller.
const WAVES: f64 = 152.0;
/// A table of friction by inclination that changes over the tread.
const PROFILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/benches/friction_by_inclination.csv");

const fn option(name: &'static str, change: fn(&mut Parameters)) -> Case {
    Case { name, over: 0, change, depth: DEPTH }
}

const fn of_fastest(name: &'static str, change: fn(&mut Parameters)) -> Case {
    Case { over: FASTEST, ..option(name, change) }
}

fn fastest(parameters: &mut Parameters) {
    parameters.normal_model = NormalModel::PiotrowskiKik;
    parameters.tangential_model = TangentialModel::Fastsim;
    parameters.creepage_model = CreepageModel::Flat;
}

fn regions(parameters: &mut Parameters) {
    parameters.friction_distribution = FrictionDistribution::Regions;
}

fn falling(parameters: &mut Parameters) {
    let law = &mut parameters.friction_law;
    (law.falling_share, law.falling_decay) = (0.4, 0.7);
    (law.reduction, law.reduction_share, law.reduction_decay) = (0.6, 0.3, 0.5);
    parameters.gauge_face_law = *law;
}

fn hot(parameters: &mut Parameters) {
    let heat = &mut parameters.flash_temperature;
    (heat.share, heat.onset, heat.range) = (0.4, 0.0, 400.0);
}

fn varying(parameters: &mut Parameters) {
    parameters.rails[0].profile = SECTIONS.into();
}

fn roller(parameters: &mut Parameters) {
    parameters.rails[0].roller_radius = ROLLER;
}

fn loaded(parameters: &mut Parameters) {
    parameters.vertical_mode = VerticalMode::Load;
}

/// A fresh flat of 50 mm, on which the wheel stands at the pitch 0.
fn on_flat(parameters: &mut Parameters) {
    parameters.wheel.flat.length = 0.05;
}

/// Waves of 96 mm around the wheel.
fn out_of_round(parameters: &mut Parameters) {
    let wave = &mut parameters.wheel.out_of_round;
    (wave.amplitude, wave.order) = (2e-5, 30);
}

fn corrugated(parameters: &mut Parameters) {
    let wave = &mut parameters.rails[0].corrugation;
    (wave.amplitude, wave.wavelength) = (2e-5, TAU * ROLLER / WAVES);
}

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
    for (k, (case, count)) in CASES.iter().zip(&counts).enumerate() {
        let more = match 100.0 * (count / counts[case.over] - 1.0) {
            _ if k == 0 || case.depth < 0.0 => String::new(),
            more if more.abs() < 0.05 => "0".into(),
            more => format!("{more:+.1} %"),
        };
        writeln!(text, "| {} | {count:.0} | {more} |", case.name).expect("a text");
    }
    print!("{text}");
    page::write("instructions", &text);
}

/// A wheel that runs, in steps of height.
fn evaluate(case: &Case, evaluations: usize) {
    let mut parameters = Parameters::default();
    (case.change)(&mut parameters);
    let mut input = Input::default();
    input.wheel.position[1] -= 3e-3;
    input.wheel.yaw = 1e-3;
    // Away from sections and from the tops of waves.
    input.track_s = 0.4003;
    input.wheel.velocity = [20.0, 0.0, 0.0];
    input.wheel.pitch_rate = -20.0 / 0.46;
    input.wheel_load = LOAD;
    let mut element = Element::new(&parameters, &input, &[]).expect("built-in profiles");
    input.wheel.position[2] = element.nominal_wheel_z() + case.depth;
    let (mut output, mut step) = (Output::default(), STEP);
    // What happens once only comes with the first.
    for _ in 0..=evaluations {
        step = -step;
        input.wheel.position[2] += step;
        element.evaluate(black_box(&input), &mut output).expect("a good input");
        black_box(&output);
    }
}
