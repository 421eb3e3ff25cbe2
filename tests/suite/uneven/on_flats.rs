//! A wheel that stands on its flat against boundary elements on the flat surfaces of both.
//!
//! Of a cylinder on a rail of one radius the undeformed distance is a sum of a function along the
//! track and a parabola across. Turned by a right angle it is a planar problem: the section along
//! the track is its separation, and the rail's crown its radius.

use crate::common::planar::steel_case;
use crate::common::summary::Summary;
use crate::common::wheel::{element, evaluate, plain_parameters, rolling};
use crate::tolerance;
use rayon::prelude::*;
use std::f64::consts::TAU;
use wheelrail::element::parameters::{FlatShape, NormalModel, TangentialModel};
use wheelrail::planar::{PlanarCase, solve};

const RADIUS: f64 = 0.46;
const CROWN: f64 = 0.3;
const LENGTH: f64 = 0.05;
/// Places along the track on either side of the axle, and their distance [m].
const PLACES: i32 = 1200;
const STEP: f64 = 5e-5;

/// Height of the wheel beyond its circle at the distance `c` from the middle of the flat [m].
fn height(shape: FlatShape, c: f64) -> f64 {
    let away = c.abs();
    match shape {
        FlatShape::Worn if away < 0.5 * LENGTH => {
            -LENGTH * LENGTH / (32.0 * RADIUS) * (1.0 + (TAU * c / LENGTH).cos())
        }
        FlatShape::Fresh => {
            // The slope of the chord, taken to zero over its corner.
            let slope = |t: f64| {
                let share = ((t - 0.45 * LENGTH) / (0.1 * LENGTH)).clamp(0.0, 1.0);
                t / RADIUS * (1.0 - share * share * (3.0 - 2.0 * share))
            };
            let end = 0.55 * LENGTH;
            let step = (end - away).max(0.0) / 200.0;
            -(0..200).map(|k| slope(away + (f64::from(k) + 0.5) * step) * step).sum::<f64>()
        }
        _ => 0.0,
    }
}

/// The normal force by boundary elements at a `depth` below first touch, turned by `pitch` [N].
fn reference(shape: FlatShape, pitch: f64, depth: f64) -> f64 {
    let distance = |i: i32| {
        let x = STEP * f64::from(i);
        [x, 0.5 * x * x / RADIUS - height(shape, x - pitch * RADIUS)]
    };
    let mut separation: Vec<[f64; 2]> = (-PLACES..=PLACES).map(distance).collect();
    let least = separation.iter().map(|point| point[1]).fold(f64::INFINITY, f64::min);
    for point in &mut separation {
        point[1] -= least;
    }
    let case = PlanarCase {
        normal_model: NormalModel::BoundaryElement,
        tangential_model: TangentialModel::None,
        elements: [30, 60],
        ..steel_case(&separation, CROWN, depth)
    };
    solve(&case).unwrap().normal_force
}

#[test]
fn strips_on_a_flat_carry_what_boundary_elements_do() {
    let mut summary = Summary::new("on_flats");
    for shape in [FlatShape::Fresh, FlatShape::Worn] {
        let mut parameters = plain_parameters("cylindrical", &format!("arc:{CROWN}"));
        parameters.tangential_model = TangentialModel::None;
        parameters.damping = 0.0;
        (parameters.wheel.flat.length, parameters.wheel.flat.shape) = (LENGTH, shape);
        let steel = steel_case(&[], CROWN, 0.0).wheel_material;
        for young in [&mut parameters.wheel.young_modulus, &mut parameters.rail_young_modulus] {
            *young = steel.young_modulus;
        }
        let cases = |pitches: &[f64]| -> Vec<f64> {
            let depths = [2e-5, 5e-5, 1e-4];
            let cases: Vec<[f64; 2]> =
                pitches.iter().flat_map(|&pitch| depths.map(|depth| [pitch, depth])).collect();
            let misses = cases.into_par_iter().map(|[pitch, depth]| {
                let mut wheel = element(&parameters);
                let mut input = rolling(0.0, 0.0);
                input.wheel.pitch = pitch;
                input.wheel.position[2] = wheel.touching_height(&input) + depth;
                let carried = -evaluate(&mut wheel, &input).wheel.force[2];
                let expected = reference(shape, pitch, depth);
                println!("{shape:?} {pitch} {depth}: {carried:.0} {expected:.0}");
                carried / expected - 1.0
            });
            misses.collect()
        };
        let name = if shape == FlatShape::Fresh { "fresh" } else { "worn" };
        let middle = cases(&[0.0, 2e-4, -1e-3, 2e-3]);
        let beside = cases(&[0.005, -0.01, 0.02, 0.03, -0.04, 0.05, 0.054, 0.06, 0.08]);
        let percent = |misses: &[f64]| misses.iter().map(|miss| 1e2 * miss).collect::<Vec<_>>();
        summary.add(
            &format!("force in the middle of a {name} flat [%]"),
            percent(&middle),
            "- / - / 5",
        );
        summary.add(&format!("force beside it, {name} [%]"), percent(&beside), "- / - / 3");
        let most = [tolerance::ON_FLAT, tolerance::BESIDE_FLAT];
        for (misses, most) in [middle, beside].iter().zip(most) {
            assert!(misses.iter().all(|miss| miss.abs() < most), "{name}: {misses:?}");
        }
    }
    summary.write();
}
