//! A rail ground in facets, with kinks of 5 to 12 degrees: a wheel stands on five narrow ridges of its
//! gauge corner at once.

use std::fmt::Write;
use std::fs;

use crate::tolerance;
use tempfile::TempDir;
use wheelrail::element::parameters::{NormalModel, TangentialModel};
use wheelrail::element::{Element, Input, Output, Parameters};

/// Where a facet ends, across from the middle of the head [mm], and how far it leans [degrees].
const FACETS: [[f64; 2]; 10] = [
    [15.98, 4.0],
    [20.92, 9.0],
    [24.77, 16.0],
    [27.49, 25.0],
    [29.59, 36.0],
    [31.2, 48.0],
    [32.4, 60.0],
    [33.14, 72.0],
    [33.44, 82.0],
    [34.15, 87.1],
];
/// Radius of the crown, and how far it goes to either side [mm].
const CROWN: [f64; 2] = [300.0, 10.0];
/// From one point to the next [mm].
const SPACING: f64 = 0.25;
/// Heights of the axle, one below the other [m].
const HIGHEST: f64 = -0.460_868;
const STEP: f64 = 0.25e-6;
const HEIGHTS: usize = 33;

/// The outline, z down [mm].
fn points() -> String {
    let [radius, reach] = CROWN;
    let on_crown = |y: f64| [y, radius - (radius * radius - y * y).sqrt()];
    let count = (reach / SPACING) as usize;
    let mut half: Vec<_> = (0..=count).map(|k| on_crown(k as f64 * SPACING)).collect();
    let mut from = on_crown(reach);
    for [end, lean] in FACETS {
        let to = [end, from[1] + (end - from[0]) * lean.to_radians().tan()];
        let count = ((to[0] - from[0]).hypot(to[1] - from[1]) / SPACING).ceil() as usize;
        half.extend((1..=count).map(|k| {
            let share = k as f64 / count as f64;
            [0, 1].map(|axis| from[axis] + share * (to[axis] - from[axis]))
        }));
        from = to;
    }
    let left = half.iter().skip(1).rev().map(|[y, z]| [-y, *z]);
    let mut text = String::new();
    for [y, z] in left.chain(half.iter().copied()) {
        writeln!(text, "{y:.5} {z:.5}").unwrap();
    }
    text
}

/// Vertical forces of a wheel on the rail at the `heights` of it, frictionless [N].
fn forces(folder: &TempDir, change: impl Fn(&mut Parameters), heights: &[usize]) -> Vec<f64> {
    let file = folder.path().join("ground_rail.txt");
    fs::write(&file, points()).unwrap();
    let mut parameters = Parameters {
        tangential_model: TangentialModel::None,
        damping: 0.0,
        ..Parameters::default()
    };
    parameters.rails[0].profile = file.to_str().unwrap().into();
    change(&mut parameters);
    let mut input = Input::default();
    input.wheel.position[1] = 0.756_349_212;
    input.wheel.yaw = 3e-3;
    (input.wheel.velocity[0], input.wheel.pitch_rate) = (20.0, -43.5);
    let mut element = Element::new(&parameters, &input, &[]).unwrap();
    let mut force = |&k: &usize| {
        input.wheel.position[2] = HIGHEST + k as f64 * STEP;
        let mut output = Output::default();
        element.evaluate(&input, &mut output).unwrap();
        assert_eq!(output.patch_count, 5);
        assert_eq!(output.fallback_count, 0);
        -output.wheel.force[2]
    };
    heights.iter().map(&mut force).collect()
}

#[test]
fn strips_on_narrow_ridges_carry_what_boundary_elements_do_and_more_the_deeper() {
    let folder = tempfile::tempdir().unwrap();
    let all: Vec<usize> = (0..HEIGHTS).collect();
    let few = [0, HEIGHTS / 2, HEIGHTS - 1];
    let solved = forces(&folder, |own| own.normal_model = NormalModel::BoundaryElement, &few);
    let stiffness = (solved[2] - solved[0]) / (STEP * (HEIGHTS - 1) as f64);
    for strips in [Parameters::default().strips, 20, 40] {
        let found = forces(&folder, |own| own.strips = strips, &all);
        for (wanted, k) in solved.iter().zip(few) {
            let error = (found[k] / wanted - 1.0).abs();
            assert!(error <= tolerance::KINKED_FORCE, "{strips} strips: {error}");
        }
        let falls = found.windows(2).map(|pair| 1.0 - pair[1] / pair[0]);
        let most_fall = falls.fold(0.0, f64::max);
        println!("{strips} strips: falls by {most_fall:.1e}");
        assert!(most_fall <= tolerance::KINKED_FALL, "{strips} strips: {most_fall}");
        for pair in found.windows(2) {
            let off = ((pair[1] - pair[0]) / STEP / stiffness - 1.0).abs();
            assert!(strips < 40 || off <= tolerance::KINKED_SLOPE, "{strips} strips: {off}");
        }
    }
}
