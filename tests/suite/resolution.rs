//! The default numbers of strips and elements against many: what they cost in accuracy.

use crate::common::quantiles;
use crate::common::random::Random;
use crate::common::wheel::{element, evaluate, pressed, rolling};
use crate::tolerance;
use wheelrail::element::parameters::{CreepageModel, NormalModel, TangentialModel};
use wheelrail::element::{Input, Output, Parameters};

/// Strips, and elements along each, that stand for any number.
const MANY: usize = 120;
const POSES: usize = 500;

/// The sum of the patches' normal forces and of their areas, the largest of their pressures, and
/// the force on the wheel.
fn summary(output: &Output) -> ([f64; 3], [f64; 3]) {
    let mut sums = [0.0_f64; 3];
    for patch in &output.patches {
        sums[0] += patch.normal_force;
        sums[1] += patch.area;
        sums[2] = sums[2].max(patch.max_pressure);
    }
    (sums, output.wheel.force)
}

#[test]
fn default_strips_and_elements_are_enough_for_piotrowski_kik_and_fastsim() {
    let default = Parameters {
        normal_model: NormalModel::PiotrowskiKik,
        tangential_model: TangentialModel::Fastsim,
        creepage_model: CreepageModel::Flat,
        ..Parameters::default()
    };
    let fine = Parameters { strips: MANY, elements_along: MANY, ..default.clone() };
    let (mut default, mut fine) = (element(&default), element(&fine));
    let mut random = Random::new(17);
    let mut errors: [Vec<f64>; 4] = Default::default();
    for _ in 0..POSES {
        let mut input: Input = rolling(random.within(-8e-3, 1e-2), 20.0);
        (input.wheel.roll, input.wheel.yaw) = (random.about(5e-3), random.about(0.015));
        input.wheel.velocity[0] *= 1.0 + random.about(5e-3);
        input.wheel.velocity[1] = random.about(0.05);
        let depth = 10_f64.powf(random.within(-5.0, -3.9));
        let at = pressed(&mut fine, &input, depth);
        let (sums, force) = summary(&evaluate(&mut default, &at));
        let (exact, exact_force) = summary(&evaluate(&mut fine, &at));
        for k in 0..3 {
            errors[k].push((sums[k] / exact[k] - 1.0).abs());
        }
        let off: f64 = (0..3).map(|k| (force[k] - exact_force[k]).powi(2)).sum();
        errors[3].push(off.sqrt() / exact_force.iter().map(|f| f * f).sum::<f64>().sqrt());
    }
    let names = ["normal force", "area", "greatest pressure", "force on the wheel"];
    for ((name, errors), most) in names.iter().zip(errors).zip(tolerance::DEFAULT_COUNTS) {
        let [mean, most_of_them, worst] = quantiles(errors);
        println!("{name}: mean {mean:.1e}, 95 % {most_of_them:.1e}, worst {worst:.1e}");
        assert!(most_of_them <= most[0] && worst <= most[1], "{name}: {most_of_them:e} {worst:e}");
    }
}
