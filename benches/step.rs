//! Time of one evaluation of the element in named scenes.
//!
//! Every evaluation gets an input that differs from the one before by 0.1 nm of height, so that
//! nothing is reused.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use wheelrail::element::parameters::{
    CreepageModel, NormalModel, TangentialModel, VerticalMode, WearDistribution, WearModel,
};
use wheelrail::element::{Element, Gradient, Input, Output, Parameters};

/// A scene: lateral shift of the wheel [m], height against first touch (down positive) [m],
/// parameters.
struct Scene {
    name: &'static str,
    shift: f64,
    depth: f64,
    yaw: f64,
}

const SCENES: [Scene; 5] = [
    Scene { name: "lifted", shift: 0.0, depth: -1e-3, yaw: 0.0 },
    Scene { name: "tread", shift: -3e-3, depth: 6e-5, yaw: 1e-3 },
    Scene { name: "two_zones", shift: 0.0, depth: 4e-5, yaw: 1e-3 },
    Scene { name: "flange", shift: 8e-3, depth: 6e-5, yaw: 5e-3 },
    Scene { name: "tread_and_flange", shift: 5.35e-3, depth: 1e-4, yaw: 1e-3 },
];

fn scene(scene: &Scene, parameters: &Parameters) -> (Element, Input) {
    // On the front of a corrugation, and beside a flat.
    let mut input = Input { track_s: 0.008, ..Input::default() };
    input.wheel.position[1] += scene.shift;
    input.wheel.yaw = scene.yaw;
    input.wheel.velocity = [20.0, 0.0, 0.0];
    input.wheel.pitch_rate = -20.0 / 0.46;
    let element = Element::new(parameters, &input, &[]).expect("built-in profiles");
    input.wheel.position[2] = element.nominal_wheel_z() + scene.depth;
    // The load that goes with this height.
    let given = Parameters { vertical_mode: VerticalMode::Penetration, ..parameters.clone() };
    let mut output = Output::default();
    let mut pressed = Element::new(&given, &input, &[]).expect("built-in profiles");
    pressed.evaluate(&input, &mut output).expect("finite input");
    input.wheel_load = -output.wheel.force[2];
    (element, input)
}

fn evaluate(c: &mut Criterion, group: &str, parameters: &Parameters) {
    let mut group = c.benchmark_group(group);
    for case in &SCENES {
        let (mut element, mut input) = scene(case, parameters);
        let mut output = Output::default();
        element.evaluate(&input, &mut output).expect("finite input");
        let patches = output.patch_count;
        let mut step = 1e-10;
        group.bench_function(format!("{}/{patches}_patches", case.name), |b| {
            b.iter(|| {
                step = -step;
                input.wheel.position[2] += step;
                input.wheel_load += 1e6 * step;
                element.evaluate(black_box(&input), &mut output).expect("finite input");
                black_box(output.wheel.force[2])
            });
        });
    }
    group.finish();
}

/// The models of the paper, with 12 strips and 20 elements along each.
fn paper() -> Parameters {
    Parameters {
        normal_model: NormalModel::PiotrowskiKik,
        creepage_model: CreepageModel::Flat,
        tangential_model: TangentialModel::Fastsim,
        strips: 12,
        elements_along: 20,
        ..Parameters::default()
    }
}

/// The models by default, those of the paper, also with 30 strips and elements, and others in the
/// place of each.
fn models(c: &mut Criterion) {
    let with = |change: fn(&mut Parameters)| {
        let mut parameters = paper();
        change(&mut parameters);
        parameters
    };
    let fine = Parameters { strips: 30, elements_along: 30, ..paper() };
    evaluate(c, "as_it_starts", &Parameters::default());
    evaluate(c, "piotrowski_kik+fastsim_12x20", &paper());
    evaluate(c, "piotrowski_kik+fastsim_30x30", &fine);
    for (name, parameters) in [
        ("piotrowski_kik+none", with(|p| p.tangential_model = TangentialModel::None)),
        ("hertz+fastsim", with(|p| p.normal_model = NormalModel::Hertz)),
        ("piotrowski_kik+fastrip", with(|p| p.tangential_model = TangentialModel::Fastrip)),
        ("piotrowski_kik+tables", with(|p| p.tangential_model = TangentialModel::Tables)),
        (
            "piotrowski_kik+fastsim_corrected",
            with(|p| p.tangential_model = TangentialModel::FastsimCorrected),
        ),
    ] {
        evaluate(c, name, &parameters);
    }
}

/// The strip model by its number of strips, with flat creepage; 15 elements along.
fn strips(c: &mut Criterion) {
    for strips in [12, 16, 20, 24, 40] {
        let parameters =
            Parameters { normal_model: NormalModel::Strips, strips, elements_along: 15, ..paper() };
        evaluate(c, &format!("strips_{strips}+fastsim"), &parameters);
        let parameters = Parameters { tangential_model: TangentialModel::Tables, ..parameters };
        evaluate(c, &format!("strips_{strips}+tables"), &parameters);
    }
}

/// One option at a time on top of the models of the paper.
fn options(c: &mut Criterion) {
    let with = |change: fn(&mut Parameters)| {
        let mut parameters = paper();
        change(&mut parameters);
        parameters
    };
    let corrugated = with(|p| p.rails[0].corrugation.amplitude = 4e-5);
    let out_of_round = |p: &mut Parameters| {
        (p.wheel.out_of_round.amplitude, p.wheel.out_of_round.order) = (2e-4, 7);
    };
    for (name, parameters) in [
        ("corrected", with(|p| p.normal_model = NormalModel::PiotrowskiKikCorrected)),
        ("kinematic", with(|p| p.creepage_model = CreepageModel::Kinematic)),
        ("curved", with(|p| p.creepage_model = CreepageModel::Curved)),
        ("linear", with(|p| p.tangential_model = TangentialModel::Linear)),
        ("load", with(|p| p.vertical_mode = VerticalMode::Load)),
        ("second_rail_out_of_reach", with(|p| p.rails[1].enabled = true)),
        ("corrugated_rail", corrugated.clone()),
        ("corrugated_rail+hertz", Parameters { normal_model: NormalModel::Hertz, ..corrugated }),
        ("out_of_round_wheel", with(out_of_round)),
        ("wheel_flat", with(|p| (p.wheel.flat.length, p.wheel.flat.angle) = (0.05, 0.02))),
    ] {
        evaluate(c, &format!("option/{name}"), &parameters);
    }
}

/// One evaluation, its derivative in one direction, its Jacobian and its derivatives backwards from
/// one sum of outputs, as multiples of which their cost is stated.
fn derivatives(c: &mut Criterion) {
    let mut group = c.benchmark_group("derivatives");
    for (name, tangential_model, vertical_mode) in [
        ("fastsim", TangentialModel::Fastsim, VerticalMode::Penetration),
        ("tables", TangentialModel::Tables, VerticalMode::Penetration),
        ("load+fastsim", TangentialModel::Fastsim, VerticalMode::Load),
    ] {
        let parameters = Parameters { tangential_model, vertical_mode, ..paper() };
        for case in &SCENES[1..] {
            let (mut element, input) = scene(case, &parameters);
            let mut direction = Input::at_rest();
            direction.wheel.position[1] = 1.0;
            let (mut output, mut columns) = (Output::default(), Vec::new());
            let id = |what: &str| format!("{name}/{}/{what}", case.name);
            group.bench_function(id("evaluation"), |b| {
                b.iter(|| element.evaluate(black_box(&input), &mut output).expect("finite input"));
            });
            group.bench_function(id("direction"), |b| {
                b.iter(|| {
                    let rates = &mut output;
                    let found =
                        element.directional_derivative(black_box(&input), &direction, rates);
                    found.expect("a smooth place");
                });
            });
            group.bench_function(id("jacobian"), |b| {
                b.iter(|| {
                    let found = element.jacobian(black_box(&input), &mut columns);
                    found.expect("a smooth place");
                });
            });
            let mut weights = Output::default();
            (weights.wheel.force, weights.wheel.moment) = ([1.0; 3], [1.0; 3]);
            let mut gradient = Gradient::default();
            group.bench_function(id("backwards"), |b| {
                b.iter(|| {
                    let found =
                        element.adjoint_derivative(black_box(&input), &weights, &mut gradient);
                    found.expect("a smooth place");
                });
            });
        }
    }
    group.finish();
}

/// A step of time with a wear law and without, and an update of the profiles of wheel and rail.
fn wear(c: &mut Criterion) {
    let mut group = c.benchmark_group("wear");
    for case in &SCENES {
        for (name, model, distribution) in [
            ("off", WearModel::Off, WearDistribution::Interpenetration),
            ("strips", WearModel::FrictionalWork, WearDistribution::Strips),
            ("interpenetration", WearModel::FrictionalWork, WearDistribution::Interpenetration),
        ] {
            let mut parameters = paper();
            (parameters.wear.model, parameters.wear.distribution) = (model, distribution);
            parameters.wear.acceleration_factor = 1e3;
            let (mut element, mut input) = scene(case, &parameters);
            let mut output = Output::default();
            let mut step = 1e-10;
            group.bench_function(format!("{}/{name}", case.name), |b| {
                b.iter(|| {
                    step = -step;
                    input.wheel.position[2] += step;
                    element.accumulate(black_box(&input), &mut output, 1e-6).expect("finite");
                    black_box(output.wheel.force[2])
                });
            });
        }
    }
    let mut parameters = paper();
    parameters.wear.model = WearModel::FrictionalWork;
    let (mut element, input) = scene(&SCENES[1], &parameters);
    let mut output = Output::default();
    group.bench_function("update", |b| {
        b.iter(|| {
            element.accumulate(&input, &mut output, 1e-6).expect("finite input");
            element.update_profiles();
        });
    });
    group.finish();
}

criterion_group!(benches, models, strips, options, derivatives, wear);
criterion_main!(benches);
