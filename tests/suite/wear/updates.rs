//! Profiles that wear: how often they are brought up to date, and what they are like then.

use super::*;
use crate::common;
use crate::common::write_report;
use std::fmt::Write;
use tempfile::TempDir;
use wheelrail::element::WornBody;
use wheelrail::geometry::profile::ProfileKind;
use wheelrail::io::{load_profile, save_profile};
use wheelrail::wear::depth::wear_depth;

/// Wear depth of the wheel over its cells after a second of sway at given load, with an update
/// every `interval`.
fn swayed(interval: f64, h: f64, distribution: WearDistribution) -> Vec<[f64; 2]> {
    let mut p = parameters(WearModel::FrictionalWork);
    p.vertical_mode = VerticalMode::Load;
    // The order of the integration shows on pressures without noise of nodes.
    p.normal_model = NormalModel::PiotrowskiKik;
    p.tangential_model = TangentialModel::Fastsim;
    p.creepage_model = CreepageModel::Flat;
    (p.strips, p.elements_along) = (15, 10);
    p.wear.acceleration_factor = 4e5;
    (p.wear.update_interval, p.wear.distribution) = (interval, distribution);
    let mut element = element(&p);
    let mut output = Output::default();
    for step in 0..(0.6 / h).round() as usize {
        // In the middle of the step, so that all of them sample the same motion.
        let sway = -3e-3 + 1.5e-3 * (TAU * 1.7 * (step as f64 + 0.5) * h).sin();
        let at = input(&element, Side::Right, sway, 0.0);
        element.advance(&at, &mut output, h).unwrap();
    }
    element.wear_depth(WornBody::Wheel)
}

/// Root mean square difference of two depths over the greatest of the second.
fn difference(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    let square: f64 = a.iter().zip(b).map(|(a, b)| (a[1] - b[1]).powi(2)).sum();
    let worn = b.iter().filter(|p| p[1] > 0.0).count();
    let most = b.iter().map(|p| p[1]).fold(0.0, f64::max);
    (square / worn as f64).sqrt() / most
}

#[test]
fn smaller_intervals_and_steps_change_the_worn_profile_less_and_less() {
    let mut report = String::from("what,of_s,difference_to_the_next_finer\n");
    let spread = WearDistribution::Interpenetration;
    let mut changes = [[0.0; 2]; 2];
    let intervals = [0.12, 0.06, 0.03];
    let by_interval = intervals.map(|interval| swayed(interval, 3.75e-3, spread));
    let steps = [0.03, 0.015, 7.5e-3];
    let by_step = steps.map(|h| swayed(0.03, h, spread));
    for (k, (what, profiles, of)) in
        [("update", &by_interval, intervals), ("integration", &by_step, steps)]
            .into_iter()
            .enumerate()
    {
        for i in 0..2 {
            changes[k][i] = difference(&profiles[i], &profiles[i + 1]);
            writeln!(report, "{what},{},{:.5}", of[i], changes[k][i]).unwrap();
        }
    }
    // Plain summing is as far off with the longest interval as it is meant to be.
    let plain = swayed(0.12, 3.75e-3, WearDistribution::Strips);
    let [spread, plain] = [&by_interval[0], &plain].map(|depth| difference(depth, &by_interval[2]));
    writeln!(report, "plain summing against the finest interval,0.12,{plain:.5}").unwrap();
    writeln!(report, "spread against the finest interval,0.12,{spread:.5}").unwrap();
    write_report("wear_convergence.csv", &report);
    println!("{report}");
    for [coarse, fine] in changes {
        assert!(fine < 0.6 * coarse, "{changes:?}");
    }
    assert!(changes[0][1] < tolerance::WEAR_UPDATE_INTERVAL);
    assert!(changes[1][1] < tolerance::WEAR_STEP);
    assert!(plain > 3.0 * spread, "{plain} {spread}");
}

#[test]
fn an_update_changes_forces_by_no_more_than_the_depth_times_the_stiffness() {
    let p = parameters(WearModel::FrictionalWork);
    let mut worst: f64 = 0.0;
    for shift in [-4e-3, -2e-3, 1.5e-3, 6.5e-3] {
        for factor in [1e4, 1e5] {
            let mut p = p.clone();
            p.wear.acceleration_factor = factor;
            p.wear.update_interval = 1e9;
            let mut element = element(&p);
            let mut start = input(&element, Side::Right, shift, 0.0);
            start.wheel.position[2] = element.touching_height(&start) + 8e-5;
            let mut output = Output::default();
            for _ in 0..4 {
                element.accumulate(&start, &mut output, 1e-3).unwrap();
                let state = element.wear_state().unwrap();
                let increment =
                    state.wheel.most_pending + state.rails[0].as_ref().unwrap().most_pending;
                let before = output.patches[0].normal_force;
                // The stiffness of Hertz: 3/2 F/δ.
                let stiffness = 1.5 * before / output.patches[0].penetration;
                element.update_profiles();
                element.evaluate(&start, &mut output).unwrap();
                let change = (output.patches[0].normal_force - before).abs();
                worst = worst.max(change / (stiffness * increment));
                assert!(output.patches[0].normal_force > 0.3 * before, "{shift} {factor}");
            }
        }
    }
    println!("greatest change of the normal force over stiffness times depth: {worst:.2}");
    assert!(worst < tolerance::WEAR_FORCE_CHANGE);
}

#[test]
fn heavily_worn_profiles_leave_finite_forces_everywhere() {
    let mut p = parameters(WearModel::FrictionalWork);
    p.wear.acceleration_factor = 3e8;
    p.wear.update_interval = 1e-3;
    let mut element = element(&p);
    let mut output = Output::default();
    for step in 0..40 {
        let mut at = input(&element, Side::Right, 6e-3 * (1.3 * f64::from(step)).sin(), 0.0);
        at.wheel.position[2] = element.touching_height(&at) + 8e-5;
        element.advance(&at, &mut output, 1e-3).unwrap();
    }
    assert!(output.wheel_wear.depth > 3e-3, "{:?}", output.wheel_wear);
    let mut random = common::random::Random::new(5);
    for _ in 0..200 {
        let at = common::wheel::random_input(&mut element, &mut random);
        element.evaluate(&at, &mut output).unwrap();
        let all = output.wheel.force.iter().chain(&output.wheel.moment);
        assert!(all.chain(&output.rails[0].force).all(|f| f.is_finite()), "{at:?}");
        assert!(output.wheel.force.iter().all(|f| f.abs() < 1e9));
    }
}

#[test]
fn a_worn_profile_is_written_and_read_back() {
    let p = parameters(WearModel::FrictionalWork);
    let mut element = element(&p);
    let mut output = Output::default();
    for step in 0..20 {
        let mut at = input(&element, Side::Right, -4e-3 + 5.5e-4 * f64::from(step), 0.0);
        at.wheel.position[2] = element.touching_height(&at) + 8e-5;
        element.advance(&at, &mut output, 1e-3).unwrap();
    }
    let folder = TempDir::new().unwrap();
    let mut worst: f64 = 0.0;
    for (profile, file) in
        [(element.worn_wheel().unwrap(), "wheel.csv"), (element.worn_rail(0).unwrap(), "rail.csv")]
    {
        let path = folder.path().join(file);
        save_profile("wear.wheel.file", &path, &profile).unwrap();
        let folders = [folder.path().to_path_buf()];
        let read = load_profile("wheel.profile", file, profile.kind, 4e-3, &folders).unwrap();
        let off = wear_depth(&profile, &read);
        assert!(off.len() > 1000);
        worst = worst.max(off.iter().map(|p| p.depth.abs()).fold(0.0, f64::max));
        let name = if profile.kind == ProfileKind::Wheel { "S1002" } else { "60E1" };
        let unworn = load_profile("p", name, profile.kind, 0.0, &[]).unwrap();
        let deepest = wear_depth(&unworn, &read).iter().map(|p| p.depth).fold(0.0, f64::max);
        let wear = if profile.kind == ProfileKind::Wheel {
            output.wheel_wear.depth
        } else {
            output.rail_wear[0].depth
        };
        assert_relative_eq!(deepest, wear, max_relative = 0.02, epsilon = 1e-7);
    }
    println!("read back {worst:e} m off");
    assert!(worst < tolerance::PROFILE_READ_BACK);
}
