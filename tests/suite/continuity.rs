//! Continuity of the forces: smooth for one patch; how far the normal force jumps where the deepest
//! of several minima changes, as both normal models have one contact point for each penetrated
//! interval.

use crate::common;
use crate::tolerance;
use std::fmt::Write;

use crate::common::random::Random;
use crate::common::vectors::dot;
use crate::common::wheel::{evaluate, pressed, rolling};
use crate::common::{median_and_worst, write_report};
use wheelrail::element::parameters::{NormalModel, TangentialModel};
use wheelrail::element::{Element, Input, Output, Parameters};

/// Lateral range and step of the sweep [m].
const RANGE: [f64; 2] = [-6e-3, 6e-3];
const STEP: f64 = 1e-6;
/// Spacing of the heights of first touch, linear in between: continuous, so that it adds no jump
/// [m].
const HEIGHT_STEP: f64 = 2e-5;

/// The force jump between two neighbouring positions, over the mean of both forces.
#[derive(Clone, Copy, Debug, Default)]
struct Jump {
    size: f64,
    y: f64,
    load: [f64; 2],
    patches: [i32; 2],
}

fn normal_element(normal_model: NormalModel) -> Element {
    let parameters = Parameters {
        normal_model,
        tangential_model: TangentialModel::None,
        // The bounds of jumps are those of twenty strips.
        strips: 20,
        ..Parameters::default()
    };
    Element::new(&parameters, &at(0.0, -0.46), &[]).unwrap()
}

fn at(shift: f64, z: f64) -> Input {
    let mut input = Input::default();
    input.wheel.position = [0.0, 0.75 + shift, z];
    input
}

/// Heights of first touch over the range.
fn touching_heights() -> Vec<f64> {
    let mut element = normal_element(NormalModel::Hertz);
    let count = ((RANGE[1] - RANGE[0]) / HEIGHT_STEP).round() as usize + 1;
    (0..count)
        .map(|i| element.touching_height(&at(RANGE[0] + i as f64 * HEIGHT_STEP, -0.46)))
        .collect()
}

/// The jumps of a sweep at `depth` below first touch, largest first. What neighbouring steps change
/// as well is no jump.
fn jumps(model: NormalModel, heights: &[f64], depth: f64) -> Vec<Jump> {
    let mut element = normal_element(model);
    let mut output = Output::default();
    let count = ((RANGE[1] - RANGE[0]) / STEP).round() as usize;
    let mut loads = Vec::with_capacity(count);
    for i in 0..count {
        let shift = i as f64 * STEP;
        let cell = ((shift / HEIGHT_STEP) as usize).min(heights.len() - 2);
        let share = shift / HEIGHT_STEP - cell as f64;
        let z = heights[cell] + share * (heights[cell + 1] - heights[cell]) + depth;
        element.evaluate(&at(RANGE[0] + shift, z), &mut output).unwrap();
        let load: f64 = output.patches.iter().map(|p| p.normal_force).sum();
        loads.push((load, output.patch_count));
    }
    let change = |i: usize| loads[i + 1].0 - loads[i].0;
    let size = |i: usize| {
        let jump = change(i) - 0.5 * (change(i - 1) + change(i + 1));
        2.0 * jump.abs() / (loads[i].0 + loads[i + 1].0)
    };
    let mut jumps: Vec<Jump> = (2..count - 3)
        .filter(|&i| size(i) > size(i - 1) && size(i) > size(i + 1))
        .map(|i| Jump {
            size: size(i),
            y: RANGE[0] + (i as f64 + 0.5) * STEP,
            load: [loads[i].0, loads[i + 1].0],
            patches: [loads[i].1, loads[i + 1].1],
        })
        .collect();
    jumps.sort_by(|a, b| b.size.total_cmp(&a.size));
    jumps
}

#[test]
fn force_jumps_where_minima_swap_or_merge_are_bounded() {
    let heights = touching_heights();
    let mut report =
        String::from("model,depth_um,rank,y_mm,jump,load_before_n,load_after_n,patches\n");
    for (model, most) in [
        (NormalModel::PiotrowskiKik, tolerance::JUMP_PIOTROWSKI_KIK),
        (NormalModel::Hertz, tolerance::JUMP_HERTZ),
    ] {
        for depth in [3e-5, 8e-5, 1.5e-4] {
            let found = jumps(model, &heights, depth);
            for (rank, jump) in found.iter().take(8).enumerate() {
                writeln!(
                    report,
                    "{model:?},{:.0},{},{:.4},{:.5},{:.0},{:.0},{} to {}",
                    1e6 * depth,
                    rank + 1,
                    1e3 * jump.y,
                    jump.size,
                    jump.load[0],
                    jump.load[1],
                    jump.patches[0],
                    jump.patches[1]
                )
                .unwrap();
            }
            let worst = found[0];
            println!("{model:?} at {depth} m: {worst:?}");
            assert!(worst.size <= most, "{model:?}: {worst:?}");
        }
    }
    write_report("force_jumps.csv", &report);
}

/// Moves something by a number.
type Change = fn(&mut Input, f64);

/// Greatest departure of a second difference of the wheel's force from their mean, which is the
/// curvature of the force itself, over 100 steps of `change`, over the force.
fn roughness(element: &mut Element, input: &Input, change: Change) -> f64 {
    let forces: Vec<[f64; 3]> = (0..100)
        .map(|i| {
            let mut moved = *input;
            change(&mut moved, 1e-9 * f64::from(i));
            evaluate(element, &moved).wheel.force
        })
        .collect();
    let greatest = (0..3).map(|k| {
        let second: Vec<f64> =
            forces.windows(3).map(|f| f[0][k] - 2.0 * f[1][k] + f[2][k]).collect();
        let curvature = second.iter().sum::<f64>() / second.len() as f64;
        second.iter().map(|bend| (bend - curvature).abs()).fold(0.0, f64::max)
    });
    greatest.fold(0.0, f64::max) / dot(forces[0], forces[0]).sqrt()
}

#[test]
fn forces_of_one_patch_are_smooth_down_to_steps_of_a_nanometre_and_a_nanoradian() {
    let directions: [(&str, Change); 4] = [
        ("y", |i, h| i.wheel.position[1] += h),
        ("z", |i, h| i.wheel.position[2] += h),
        ("roll", |i, h| i.wheel.roll += h),
        ("yaw", |i, h| i.wheel.yaw += h),
    ];
    let mut report =
        String::from("model,direction,shift_mm,yaw_mrad,depth_um,angle_deg,roughness\n");
    for (normal_model, tangential_model) in [
        (NormalModel::PiotrowskiKik, TangentialModel::Fastsim),
        (NormalModel::Hertz, TangentialModel::Fastsim),
        (NormalModel::Strips, TangentialModel::Fastsim),
        (NormalModel::PiotrowskiKik, TangentialModel::Tables),
        (NormalModel::PiotrowskiKik, TangentialModel::FastsimCorrected),
        (NormalModel::Strips, TangentialModel::Tables),
    ] {
        // The strip model takes longer: fewer poses and strips.
        let (strips, poses, least_flanges) =
            if normal_model == NormalModel::Strips { (20, 14, 0) } else { (30, 70, 5) };
        let parameters =
            Parameters { normal_model, tangential_model, strips, ..Parameters::default() };
        let mut element = common::wheel::element(&parameters);
        let mut random = Random::new(9);
        let mut all = Vec::new();
        let mut flanges = 0;
        for _ in 0..poses {
            let mut input = rolling(random.within(-6e-3, 9e-3), 20.0);
            (input.wheel.roll, input.wheel.yaw) = (random.about(3e-3), random.about(0.02));
            let depth = random.within(2e-5, 1e-4);
            let at = pressed(&mut element, &input, depth);
            let output = evaluate(&mut element, &at);
            if output.patch_count != 1 {
                continue;
            }
            let angle = output.patches[0].contact_angle;
            flanges += u32::from(angle < -0.7);
            for (direction, change) in directions {
                let found = roughness(&mut element, &at, change);
                let (shift, yaw) = (1e3 * (at.wheel.position[1] - 0.75), 1e3 * at.wheel.yaw);
                let (depth, angle) = (1e6 * depth, angle.to_degrees());
                writeln!(
                    report,
                    "{normal_model:?}+{tangential_model:?},{direction},{shift:.3},{yaw:.2},{depth:.1},{angle:.2},{found:e}"
                )
                .unwrap();
                all.push(found);
            }
        }
        let [median, worst] = median_and_worst(all);
        println!(
            "{normal_model:?}+{tangential_model:?}: roughness {median:e} in the median, {worst:e} at worst"
        );
        assert!(flanges > least_flanges, "{flanges} flange contacts are too few");
        let most = if normal_model == NormalModel::Strips {
            tolerance::ROUGHNESS_STRIPS
        } else {
            tolerance::ROUGHNESS
        };
        assert!(worst < most, "{normal_model:?}: {worst:e}\n{report}");
    }
    write_report("roughness.csv", &report);
}

#[test]
fn creep_forces_do_not_jump_where_the_strips_of_two_zones_join() {
    use wheelrail::planar::{Indentation, solve};
    // Two lobes 6 mm apart that meet as they are pressed down.
    let separation: Vec<[f64; 2]> = (-300..=300)
        .map(|i| 4e-5 * f64::from(i))
        .map(|y| [y, 2e-5 * (1.0 - (y / 3e-3).powi(2)).powi(2)])
        .collect();
    for (tangential_model, most) in [
        (TangentialModel::Fastsim, tolerance::JOINING_ZONES_MARCHED),
        (TangentialModel::Fastrip, tolerance::JOINING_ZONES_MARCHED),
        (TangentialModel::Tables, tolerance::JOINING_ZONES),
        (TangentialModel::FastsimCorrected, tolerance::JOINING_ZONES_MARCHED),
        (TangentialModel::Marches, tolerance::JOINING_ZONES_MARCHED),
    ] {
        let at = |approach: f64| {
            let case = Parameters {
                normal_model: NormalModel::Strips,
                tangential_model,
                strips: 20,
                elements_along: 15,
                ..Parameters::default()
            };
            let creepage = [3e-4, 3e-4, 0.3];
            let indentation = Indentation::Approach(approach);
            let found =
                solve(&case.planar_case(&separation, 0.46, indentation, creepage, 0.3)).unwrap();
            let limit = 0.3 * found.normal_force;
            (found.patches, [found.fx / limit, found.fy / limit])
        };
        let (mut low, mut high) = (5e-6, 1.2e-4);
        assert_eq!((at(low).0, at(high).0), (2, 1));
        // The length of the strip that joins them grows as the root of the approach: nearer than
        // that is seen.
        while high - low > 1e-12 {
            let middle = 0.5 * (low + high);
            if at(middle).0 == 2 { low = middle } else { high = middle }
        }
        let (before, after) = (at(low).1, at(high).1);
        let jump = (after[0] - before[0]).hypot(after[1] - before[1]);
        println!("{tangential_model:?}: zones join at {low:.3e} m, jump {jump:.2e} of the limit");
        assert!(jump <= most, "{before:?} to {after:?}");
    }
}
