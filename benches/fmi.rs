//! What the FMI interface adds to an evaluation: a round of one set of twelve inputs, one step and
//! one get of 34 outputs, beside the evaluation of the same inputs by the element alone; and the
//! same of a wheelset.
#![allow(unsafe_code)]

// Clippy lets tests import by wildcard, benches not.
#[allow(clippy::wildcard_imports)]
#[path = "../tests/suite/host/mod.rs"]
mod host;

use std::hint::black_box;

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, criterion_group, criterion_main};
use host::Host;
use wheelrail::element::{Element, Input, Output, Parameters};
use wheelrail::fmi::v2::types::{Status, TRUE, ValueReference};
use wheelrail::fmi::v2::{fmi2DoStep, fmi2GetReal, fmi2SetReal};
use wheelrail::variables::{Causality, Kind, WHEELSET};
use wheelrail::wheelset::{self, Wheelset};

/// Scenes and their heights against first touch, down positive [m].
const SCENES: [(&str, f64); 2] = [("lifted", -1e-3), ("tread", 6e-5)];
const INPUTS: [&str; 12] = [
    "wheel.x",
    "wheel.y",
    "wheel.z",
    "wheel.roll",
    "wheel.yaw",
    "wheel.pitch",
    "wheel.vx",
    "wheel.vy",
    "wheel.vz",
    "wheel.roll_rate",
    "wheel.yaw_rate",
    "wheel.pitch_rate",
];
const OUTPUTS: usize = 34;

/// One round of calls to `host`, with `inputs` at y and z, no angles, and six rates.
fn calls(
    group: &mut BenchmarkGroup<WallTime>,
    host: &Host,
    inputs: &[impl AsRef<str>; 12],
    [y, z]: [f64; 2],
    rates: [f64; 6],
) {
    let inputs = inputs.each_ref().map(|name| host.reference(name.as_ref()));
    let [vx, vy, vz, roll_rate, yaw_rate, pitch_rate] = rates;
    let mut values = [0.0, y, z, 0.0, 0.0, 0.0, vx, vy, vz, roll_rate, yaw_rate, pitch_rate];
    let outputs: Vec<ValueReference> = (host.unit.variables.iter())
        .filter(|v| v.causality == Causality::Output && v.kind == Kind::Real)
        .map(|v| host.reference(v.name))
        .take(OUTPUTS)
        .collect();
    let mut results = [0.0; OUTPUTS];
    let mut step = 1e-10;
    group.bench_function("set_step_get", |b| {
        b.iter(|| {
            step = -step;
            values[2] = z + step;
            // SAFETY: FMI 2.0, 2.1.7: all arrays hold as many elements as their counts say.
            let worst = unsafe {
                let c = host.component;
                fmi2SetReal(c, inputs.as_ptr(), inputs.len(), values.as_ptr())
                    .max(fmi2DoStep(c, 0.0, 1e-4, TRUE))
                    .max(fmi2GetReal(c, outputs.as_ptr(), OUTPUTS, results.as_mut_ptr()))
            };
            assert_eq!(worst, Status::Ok);
            black_box(results[0])
        });
    });
}

fn round(c: &mut Criterion) {
    for (scene, depth) in SCENES {
        let mut group = c.benchmark_group(format!("fmi/{scene}"));
        let mut input = Input::default();
        input.wheel.position[1] -= 3e-3;
        let mut element = Element::new(&Parameters::default(), &input, &[]).expect("built in");
        let z = element.nominal_wheel_z() + depth;
        input.wheel.velocity[0] = 20.0;
        input.wheel.pitch_rate = -20.0 / 0.46;
        // Every evaluation gets another height, so that nothing is reused.
        let mut step = 1e-10;
        let mut output = Output::default();
        group.bench_function("element", |b| {
            b.iter(|| {
                step = -step;
                input.wheel.position[2] = z + step;
                element.evaluate(black_box(&input), &mut output).expect("finite input");
                black_box(output.wheel.force[2])
            });
        });

        let wheel = &input.wheel;
        let rates = [20.0, 0.0, 0.0, 0.0, 0.0, wheel.pitch_rate];
        calls(&mut group, &Host::stepping(), &INPUTS, [wheel.position[1], z], rates);
        group.finish();
    }
}

fn round_of_wheelset(c: &mut Criterion) {
    let mut group = c.benchmark_group("fmi/wheelset");
    let mut input = wheelset::Input::default();
    input.wheelset.position[1] = -1e-3;
    let parameters = wheelset::Parameters::default();
    let mut wheelset = Wheelset::new(&parameters, &input, &[]).expect("built in");
    let z = wheelset.nominal_z() + 2e-4;
    input.wheelset.velocity[0] = 20.0;
    input.wheelset.pitch_rate = -20.0 / 0.46;
    let mut step = 1e-10;
    let mut output = wheelset::Output::default();
    group.bench_function("wheelset", |b| {
        b.iter(|| {
            step = -step;
            input.wheelset.position[2] = z + step;
            wheelset.evaluate(black_box(&input), &mut output).expect("finite input");
            black_box(output.wheelset.force[2])
        });
    });
    assert!(output.sides.iter().all(|side| side.patch_count > 0));
    let inputs = INPUTS.map(|name| name.replace("wheel.", "wheelset."));
    let rates = [20.0, 0.0, 0.0, 0.0, 0.0, input.wheelset.pitch_rate];
    calls(&mut group, &Host::stepping_of(&WHEELSET), &inputs, [-1e-3, z], rates);
    group.finish();
}

criterion_group!(benches, round, round_of_wheelset);
criterion_main!(benches);
