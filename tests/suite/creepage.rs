//! Creepage models and linear theory of the whole element: limits, equality where they must be
//! equal, balance of power.

use crate::common;
use crate::tolerance;
use std::fmt::Write;

use crate::common::random::Random;
use crate::common::vectors::{add, assert_close, dot};
use crate::common::wheel::{
    element, evaluate, plain_parameters, pressed, random_input, rolling, the_patch,
};
use crate::common::write_report;
use wheelrail::element::output::{Patch, Wrench};
use wheelrail::element::parameters::{CreepageModel, NormalModel, TangentialModel};
use wheelrail::element::{Input, Output, Parameters};

#[test]
fn linear_theory_is_fastsim_with_friction_without_end() {
    let parameters = |tangential_model, creepage_model| Parameters {
        tangential_model,
        creepage_model,
        // Middle rule: what is left is 1/(2 n²) of the spin's part.
        elements_along: 200,
        // Damping scales the linear force, but not one without bound.
        damping: 0.0,
        ..Parameters::default()
    };
    for creepage_model in [CreepageModel::Flat, CreepageModel::Curved] {
        let mut linear = element(&parameters(TangentialModel::Linear, creepage_model));
        let mut fastsim = element(&parameters(TangentialModel::Fastsim, creepage_model));
        let mut random = Random::new(21);
        for _ in 0..200 {
            let mut input = random_input(&mut linear, &mut random);
            input.friction = 1e9;
            let (one, two) = (evaluate(&mut linear, &input), evaluate(&mut fastsim, &input));
            for (one, two) in one.patches.iter().zip(&two.patches) {
                let size = one.creep_force[0].hypot(one.creep_force[1]);
                let allowed = tolerance::LINEAR_LIMIT * size;
                for k in 0..2 {
                    assert!((one.creep_force[k] - two.creep_force[k]).abs() <= allowed);
                }
                let arm = one.length.max(one.width);
                assert!(
                    (one.spin_moment - two.spin_moment).abs() <= allowed * arm,
                    "{one:?} {two:?}"
                );
                // Strips at an edge that carry next to nothing slip whatever the friction.
                assert!(two.slip_share <= tolerance::UNLOADED_SHARE && one.slip_share <= 0.0);
            }
        }
    }
}

#[test]
fn a_contact_laid_flat_creeps_as_its_patch() {
    let mut element = element(&Parameters {
        normal_model: NormalModel::Hertz,
        creepage_model: CreepageModel::Flat,
        ..plain_parameters("conical:0.05", "arc:0.3")
    });
    let mut input = rolling(2e-3, 20.0);
    input.wheel.yaw = 2e-3;
    // As deep as a wheel of a wagon presses, which in free rolling is most of the creepage.
    let input = pressed(&mut element, &input, 1e-4);
    let found = element.flat_contacts(&input).unwrap()[0].creepage;
    let patch = the_patch(&evaluate(&mut element, &input));
    for (found, expected) in found.iter().zip(patch.creepage) {
        approx::assert_relative_eq!(*found, expected, max_relative = 1e-9);
    }
}

#[test]
fn linear_forces_know_no_friction_and_vanish_with_the_load() {
    let parameters =
        Parameters { tangential_model: TangentialModel::Linear, ..Parameters::default() };
    let mut element = element(&parameters);
    let mut input = pressed(&mut element, &rolling(0.0, 20.0), 6e-5);
    input.wheel.velocity[1] = 0.4;
    let force =
        |element: &mut _, input: &Input| the_patch(&evaluate(element, input)).creep_force[1];
    let with_friction = force(&mut element, &input);
    // Half of what would slide already; forces without bound go on.
    assert!(with_friction < -0.3 * the_patch(&evaluate(&mut element, &input)).normal_force);
    input.friction = 0.0;
    assert!((force(&mut element, &input) - with_friction).abs() <= 0.0);
    let mut before = with_friction.abs();
    for speed in [-0.2, -0.3, -0.4, -0.45] {
        input.wheel.velocity[2] = speed;
        let patch = the_patch(&evaluate(&mut element, &input));
        assert!(patch.creep_force[1].abs() <= before);
        before = patch.creep_force[1].abs();
        assert!(patch.normal_force > 0.0 || before <= 0.0, "{patch:?}");
    }
}

/// A wheel whose generating line is straight: the surface under a patch is curved along its circles
/// only.
fn cones() -> Vec<Parameters> {
    let mut all = Vec::new();
    for (rail, inclination) in [("arc:0.3", 0.0), ("arc:2", 0.025), ("flat", 0.05)] {
        for normal_model in [NormalModel::PiotrowskiKik, NormalModel::PiotrowskiKikCorrected] {
            let mut parameters = plain_parameters("conical:0.05", rail);
            parameters.rails[0].inclination = inclination;
            parameters.normal_model = normal_model;
            all.push(parameters);
        }
    }
    all
}

/// The same with another description of the creepage.
fn with(parameters: &Parameters, creepage_model: CreepageModel) -> Parameters {
    Parameters { creepage_model, ..parameters.clone() }
}

#[test]
fn curved_and_flat_creepage_of_a_cone_are_the_same_whatever_wheel_and_rail_do() {
    for tangential_model in [TangentialModel::Fastsim, TangentialModel::Linear] {
        for mut parameters in cones() {
            parameters.tangential_model = tangential_model;
            let mut flat = element(&with(&parameters, CreepageModel::Flat));
            let mut curved = element(&with(&parameters, CreepageModel::Curved));
            let mut random = Random::new(22);
            for _ in 0..100 {
                let input = random_input(&mut flat, &mut random);
                let (one, two) = (evaluate(&mut flat, &input), evaluate(&mut curved, &input));
                let size = dot(one.wheel.force, one.wheel.force).sqrt();
                let allowed = tolerance::CONE_FLAT_AND_CURVED * size;
                for (one, two) in [(one.wheel, two.wheel), (one.rails[0], two.rails[0])] {
                    assert_close(two.force, one.force, allowed, "force");
                    assert_close(two.moment, one.moment, allowed, "moment");
                }
                for (one, two) in one.patches.iter().zip(&two.patches) {
                    assert_close(two.creepage, one.creepage, 1e-9, "creepage");
                }
            }
        }
    }
}

/// Takes all but `share` of the velocities away that are not those of free rolling.
fn calm(input: &mut Input, share: f64) {
    let wheel = &mut input.wheel;
    let rolling = -wheel.velocity[0] / 0.46;
    wheel.pitch_rate = rolling + share * (wheel.pitch_rate - rolling);
    for velocity in &mut wheel.velocity[1..] {
        *velocity *= share;
    }
    for rate in [&mut wheel.roll_rate, &mut wheel.yaw_rate, &mut wheel.yaw] {
        *rate *= share;
    }
    let rail = &mut input.rails[0];
    for velocity in [&mut rail.vy, &mut rail.vz, &mut rail.roll_rate] {
        *velocity *= share;
    }
}

/// Power that the tractions take from wheel and rail [W]: that of all forces less that of the same
/// contact without friction.
fn traction_power(all: &Output, frictionless: &Output, input: &Input) -> f64 {
    let difference = |a: Wrench, b: Wrench| Wrench {
        force: [0, 1, 2].map(|i| a.force[i] - b.force[i]),
        moment: [0, 1, 2].map(|i| a.moment[i] - b.moment[i]),
    };
    let wheel = difference(all.wheel, frictionless.wheel);
    let rail = difference(all.rails[0], frictionless.rails[0]);
    let motion = &input.wheel;
    let (sin_roll, cos_roll) = motion.roll.sin_cos();
    let (sin_yaw, cos_yaw) = motion.yaw.sin_cos();
    let axle = [-sin_yaw, cos_yaw * cos_roll, cos_yaw * sin_roll];
    let turning = add(
        [motion.roll_rate, -sin_roll * motion.yaw_rate, cos_roll * motion.yaw_rate],
        axle.map(|a| a * motion.pitch_rate),
    );
    let rail_motion = &input.rails[0];
    dot(wheel.force, motion.velocity)
        + dot(wheel.moment, turning)
        + dot(rail.force, [0.0, rail_motion.vy, rail_motion.vz])
        + rail.moment[0] * rail_motion.roll_rate
}

#[test]
fn the_power_of_the_tractions_on_both_bodies_is_the_frictional_power_and_never_feeds_them() {
    let mut report = String::from("creepage,normal,tangential,power_w,balance,least_share\n");
    for creepage_model in [CreepageModel::Flat, CreepageModel::Curved] {
        for (normal_model, tangential_model) in [
            (NormalModel::PiotrowskiKik, TangentialModel::Fastsim),
            (NormalModel::PiotrowskiKikCorrected, TangentialModel::Fastsim),
            (NormalModel::Hertz, TangentialModel::Fastsim),
            (NormalModel::PiotrowskiKik, TangentialModel::Linear),
        ] {
            let parameters = Parameters {
                creepage_model,
                normal_model,
                tangential_model,
                ..Parameters::default()
            };
            let mut element = element(&parameters);
            let mut bare = common::wheel::element(&Parameters {
                tangential_model: TangentialModel::None,
                ..parameters.clone()
            });
            let mut random = Random::new(23);
            let (mut greatest, mut least, mut balance) = (0.0f64, f64::INFINITY, 0.0f64);
            for index in 0..400 {
                let mut input = random_input(&mut element, &mut random);
                if index % 2 == 0 {
                    // Close to free rolling, where elastic energy is large against what is
                    // dissipated.
                    calm(&mut input, random.within(0.0, 1.0).powi(6));
                }
                let output = evaluate(&mut element, &input);
                let frictionless = evaluate(&mut bare, &input);
                let taken = -traction_power(&output, &frictionless, &input);
                // What friction could turn into heat at all.
                let speed = input.wheel.velocity[0].abs();
                let heat = |p: &Patch| {
                    let [longitudinal, lateral, spin] = p.creepage;
                    let slip = longitudinal.hypot(lateral).hypot(spin * p.width);
                    input.friction * p.normal_force * slip * speed
                };
                let scale: f64 = output.patches.iter().map(heat).sum();
                greatest = greatest.max(taken);
                if scale > 0.0 {
                    least = least.min(taken / scale);
                }
                let size = dot(output.wheel.force, output.wheel.force).sqrt() * speed;
                balance = balance.max((taken.max(0.0) - output.frictional_power).abs() / size);
            }
            assert!(balance < tolerance::POWER_BALANCE, "{report}");
            assert!(least >= -tolerance::POWER_FED, "{least}");
            writeln!(
                report,
                "{creepage_model:?},{normal_model:?},{tangential_model:?},{greatest:.0},{balance:e},{least:e}"
            )
            .unwrap();
        }
    }
    print!("{report}");
    write_report("power_balance.csv", &report);
}

#[test]
fn kinematic_creepage_follows_from_the_rolling_radius_alone() {
    // Strips that feel each other turn the force a little where a patch is not symmetric.
    let alone = Parameters { tangential_model: TangentialModel::Fastsim, ..Parameters::default() };
    let mut element = element(&with(&alone, CreepageModel::Kinematic));
    let mut random = Random::new(24);
    for _ in 0..100 {
        let input = random_input(&mut element, &mut random);
        let output = evaluate(&mut element, &input);
        for patch in &output.patches[..output.patch_count as usize] {
            let [speed, ..] = input.wheel.velocity;
            let around = input.wheel.pitch_rate * patch.rolling_radius;
            let reference = 0.5 * (speed.abs() + around.abs());
            let expected = [(speed + around) / reference, 0.0, 0.0];
            assert_close(patch.creepage, expected, tolerance::ROUNDING, "creepage");
            assert!(patch.creep_force[1].abs() <= 0.0);
        }
    }
}
