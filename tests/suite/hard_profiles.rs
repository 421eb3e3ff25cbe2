//! Profiles that are hard on a contact search: noise, kinks, steps, few and many points, overhangs,
//! conforming and cut ones.
//!
//! The profiles are made here, from the standards' and from closed forms. What must hold on all of
//! them is asserted; how often a solver fell back and how far the normal force bends over 0.1 µm
//! (second difference, over the force) stands in target/reports/hard_profiles.csv.

use crate::tolerance;
use std::fmt::Write;
use std::fs;

use crate::common::random::Random;
use crate::common::{median_and_worst, write_report};
use tempfile::TempDir;
use wheelrail::element::parameters::{AUTOMATIC_SMOOTHING, NormalModel};
use wheelrail::element::{Element, Input, Output, Parameters};
use wheelrail::geometry::profile::ProfileKind;
use wheelrail::io::load_profile;

/// A pair of profiles by what is hard about it: names, or points that become files.
struct Pair {
    name: String,
    wheel: Body,
    rail: Body,
}

enum Body {
    Named(&'static str),
    Points(Vec<[f64; 2]>),
}

/// Points of a standard profile at equal distances along it [m].
fn sampled(name: &str, kind: ProfileKind, count: usize) -> Vec<[f64; 2]> {
    let curve = load_profile("profile", name, kind, 0.0, &[]).unwrap().curve;
    let at = |i: usize| i as f64 / (count - 1) as f64;
    (0..count)
        .map(|i| curve.at(curve.start() + at(i) * (curve.end() - curve.start())).point)
        .collect()
}

fn wheel(count: usize) -> Vec<[f64; 2]> {
    sampled("S1002", ProfileKind::Wheel, count)
}

fn rail(count: usize) -> Vec<[f64; 2]> {
    sampled("60E1", ProfileKind::Rail, count)
}

/// Points moved at random, about `size` [m].
fn noisy(mut points: Vec<[f64; 2]>, size: f64, seed: u64) -> Vec<[f64; 2]> {
    let mut random = Random::new(seed);
    for point in &mut points {
        // The sum of three even distributions is nearly a normal one of variance 1.
        let normal = random.about(1.0) + random.about(1.0) + random.about(1.0);
        point[1] += size * normal;
    }
    points
}

/// All but some points, so that distances differ a hundredfold.
fn unevenly(points: Vec<[f64; 2]>, seed: u64) -> Vec<[f64; 2]> {
    let mut random = Random::new(seed);
    let mut next = 0;
    let last = points.len() - 1;
    let mut kept = Vec::new();
    for (i, point) in points.into_iter().enumerate() {
        if i >= next || i == last {
            kept.push(point);
            next = i + 1 + (100.0 * random.within(0.0, 1.0).powi(4)) as usize;
        }
    }
    kept
}

fn pairs() -> Vec<Pair> {
    let mut pairs = Vec::new();
    let mut add = |name: &str, wheel: Body, rail: Body| {
        pairs.push(Pair { name: name.into(), wheel, rail });
    };
    let named = Body::Named;
    for (size, seed) in [(1e-6, 1), (5e-6, 2), (2e-5, 3)] {
        let both = [wheel(700), rail(600)];
        let [w, r] = both.map(|points| noisy(points, size, seed));
        add(&format!("noise of {:.0} um", 1e6 * size), Body::Points(w), Body::Points(r));
    }
    for count in [20, 60, 5000, 20_000] {
        add(&format!("{count} points"), Body::Points(wheel(count)), Body::Points(rail(count)));
    }
    add(
        "uneven points",
        Body::Points(unevenly(wheel(5000), 4)),
        Body::Points(unevenly(rail(5000), 5)),
    );
    let mut kinked = rail(600);
    for point in &mut kinked {
        // A gauge corner ground off at 30°.
        point[1] = point[1].max(0.8e-3 + (-0.022 - point[0]).max(-0.004) * 0.577);
    }
    add("kinks of a ground rail", named("S1002"), Body::Points(kinked));
    let mut stepped = wheel(2000);
    for point in &mut stepped {
        if point[0] > 2e-3 {
            point[1] -= 5e-5;
        }
    }
    add("step of 0.05 mm on the tread", Body::Points(stepped), named("60E1"));
    let mut hollow = wheel(700);
    for point in &mut hollow {
        // 2 mm deep from -25 to 25 mm: a false flange on the field side.
        let share = point[0] / 0.025;
        if share.abs() < 1.0 {
            point[1] -= 2e-3 * (1.0 - share * share).powi(2);
        }
    }
    add("hollow wheel", Body::Points(hollow), named("60E1"));
    let mut overhanging = wheel(1500);
    for point in &mut overhanging {
        // The flank leans over by up to 1.5 mm.
        let share = ((point[1] - 0.012) / 0.008).clamp(-1.0, 1.0);
        if point[0] < -0.030 && point[0] > -0.048 {
            point[0] += 1.5e-3 * (1.0 - share * share);
        }
    }
    add("overhanging flank", Body::Points(overhanging), named("60E1"));
    add("concave 310 mm on convex 300 mm", named("arc:0.31"), named("arc:0.3"));
    add("concave 300.1 mm on convex 300 mm", named("arc:0.3001"), named("arc:0.3"));
    add("concave 300 mm on convex 300 mm", named("arc:0.3"), named("arc:0.3"));
    add("concave 290 mm on convex 300 mm", named("arc:0.29"), named("arc:0.3"));
    let narrow: Vec<[f64; 2]> =
        wheel(700).into_iter().filter(|p| p[0] > -0.062 && p[0] < 0.012).collect();
    add("narrow wheel", Body::Points(narrow), named("60E1"));
    let slim: Vec<[f64; 2]> = rail(600).into_iter().map(|[y, z]| [0.5 * y, z]).collect();
    add("narrow rail", named("S1002"), Body::Points(slim));
    add("cylinder on a flat rail", named("cylindrical"), named("flat"));
    pairs
}

/// Parameters with the profiles of the pair, files in `folder`.
fn parameters(pair: &Pair, folder: &TempDir, smoothing: f64) -> Parameters {
    let name = |body: &Body, file: &str| match body {
        Body::Named(name) => (*name).to_owned(),
        Body::Points(points) => {
            let mut text = String::from("y_mm,z_mm\n");
            for [y, z] in points {
                writeln!(text, "{:.6},{:.6}", 1e3 * y, 1e3 * z).unwrap();
            }
            fs::write(folder.path().join(file), text).unwrap();
            file.to_owned()
        }
    };
    let mut parameters = Parameters { profile_smoothing: smoothing, ..Parameters::default() };
    parameters.wheel.profile = name(&pair.wheel, "wheel.csv");
    parameters.rails[0].profile = name(&pair.rail, "rail.csv");
    parameters
}

fn rolling(shift: f64, yaw: f64) -> Input {
    let mut input = Input::default();
    input.wheel.position[1] += shift;
    input.wheel.yaw = yaw;
    input.wheel.velocity[0] = 20.0;
    input.wheel.pitch_rate = -20.1 / 0.46;
    input
}

/// Between these depths are wheels on the rail: at less the depth is rounding, at more the load is
/// beyond a meganewton [m].
const LOADED: std::ops::RangeInclusive<f64> = 1e-7..=1e-4;

/// Asserts what holds for every evaluation; gives the normal force.
fn evaluated(element: &mut Element, input: &Input, what: &str) -> f64 {
    let mut output = Output::default();
    element.evaluate(input, &mut output).unwrap();
    let numbers = output.wheel.force.iter().chain(&output.wheel.moment);
    assert!(numbers.copied().all(f64::is_finite), "{what}: {input:?}");
    for patch in &output.patches {
        let force = patch.creep_force[0].hypot(patch.creep_force[1]);
        let most = tolerance::most_friction(false, patch.penetration);
        let limit = most * input.friction * patch.normal_force;
        assert!(force <= limit, "{what}: {patch:?}");
        assert!(patch.frictional_power >= 0.0, "{what}: {patch:?}");
    }
    output.patches.iter().map(|p| p.normal_force).sum()
}

/// Sweeps one pair with one model; a row of the report.
fn sweep(
    pair: &Pair,
    folder: &TempDir,
    smoothing: f64,
    model: NormalModel,
    every: usize,
) -> String {
    let what = format!("{}, {model:?}, smoothing {smoothing}", pair.name);
    let mut parameters = parameters(pair, folder, smoothing);
    parameters.normal_model = model;
    parameters.strips = if model == NormalModel::Strips { 11 } else { 30 };
    let folders = [folder.path().to_owned()];
    let mut element = match Element::new(&parameters, &Input::default(), &folders) {
        Ok(element) => element,
        Err(refusal) => {
            let text = refusal.to_string();
            assert!(text.contains("profile") || text.contains("gauge"), "{what}: {text}");
            let file = folder.path().display().to_string();
            return format!("{what},refused: {}\n", text.replace(&file, "").replace(',', ";"));
        }
    };
    let (mut bends, mut count, mut loaded) = (Vec::new(), 0, 0);
    for place in (-8..=8).step_by(every) {
        for yaw in [0.0, 0.02] {
            let mut input = rolling(1e-3 * f64::from(place), yaw);
            let touching = element.touching_height(&input);
            assert!(touching.is_finite(), "{what}");
            for depth in [1e-12, 1e-7, 2e-5, 1e-4, 1e-3] {
                input.wheel.position[2] = touching + depth;
                let before = element.fallbacks();
                let [left, here, right] = [-1e-7, 0.0, 1e-7].map(|step| {
                    let mut moved = input;
                    moved.wheel.position[1] += step;
                    evaluated(&mut element, &moved, &what)
                });
                count += 3;
                if LOADED.contains(&depth) {
                    loaded += element.fallbacks() - before;
                }
                if depth > 1e-6 && depth < 5e-4 {
                    bends.push((left - 2.0 * here + right).abs() / here.max(1.0));
                }
            }
        }
    }
    let most = tolerance::HARD_FALLBACKS * f64::from(count);
    assert!(loaded as f64 <= most, "{what}: {loaded} fallbacks of a loaded wheel");
    let [median, worst] = median_and_worst(bends);
    format!("{what},{count},{},{loaded},{median:.2e},{worst:.2e}\n", element.fallbacks())
}

fn report(every: usize, models: &[NormalModel], name: &str) {
    let mut report = String::from(
        "pair,model,smoothing,evaluations,fallbacks,of them loaded,median bend,worst bend\n",
    );
    for pair in pairs() {
        let folder = tempfile::tempdir().unwrap();
        for smoothing in [0.0, 0.004, AUTOMATIC_SMOOTHING] {
            let is_named = [&pair.wheel, &pair.rail].iter().all(|b| matches!(b, Body::Named(_)));
            if is_named && smoothing.abs() > 0.0 {
                continue;
            }
            for &model in models {
                report += &sweep(&pair, &folder, smoothing, model, every);
            }
        }
    }
    write_report(name, &report);
    println!("{report}");
}

#[test]
fn hard_profiles_give_finite_forces_bounded_by_friction() {
    report(4, &[NormalModel::Hertz, NormalModel::PiotrowskiKik], "hard_profiles_some.csv");
}

#[test]
#[ignore = "the whole set: minutes in release builds"]
fn hard_profiles_with_every_model() {
    use NormalModel::{Hertz, PiotrowskiKik, PiotrowskiKikCorrected, Strips};
    report(1, &[Hertz, PiotrowskiKik, PiotrowskiKikCorrected, Strips], "hard_profiles.csv");
}
