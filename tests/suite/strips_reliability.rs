//! The strip model on many random poses: how many steps a solution takes, and what it costs.

use crate::tolerance;
use std::fmt::Write;
use std::time::Instant;

use crate::common::random::Random;
use crate::common::wheel::{mirrored, pressed, rolling};
use crate::common::write_report;
use wheelrail::element::parameters::{NormalModel, Side, TangentialModel};
use wheelrail::element::{Element, Input, Output, Parameters};

/// Poses of each pair of profiles.
const POSES: usize = 5000;

fn wheel(rail: &str, side: Side) -> Element {
    let mut parameters = Parameters {
        normal_model: NormalModel::Strips,
        tangential_model: TangentialModel::None,
        side,
        ..Parameters::default()
    };
    parameters.rails[0].profile = rail.into();
    let mut start = Input::default();
    if side == Side::Left {
        start = mirrored(&start);
    }
    Element::new(&parameters, &start, &[]).unwrap()
}

#[test]
#[ignore = "20 000 poses; for a release build"]
fn steps_and_cost_of_random_poses() {
    let mut all = String::from("set,number,force_n,time_us\n");
    for (seed, (rail, side)) in
        [("60E1", Side::Right), ("60E1", Side::Left), ("54E1", Side::Right), ("60E2", Side::Left)]
            .into_iter()
            .enumerate()
    {
        let mut element = wheel(rail, side);
        let mut random = Random::new(100 + seed as u64);
        let (mut fallbacks, mut times) = (0, Vec::new());
        for number in 0..POSES {
            let mut input = rolling(random.within(-8e-3, 10e-3), 20.0);
            (input.wheel.roll, input.wheel.yaw) = (random.about(5e-3), random.about(0.02));
            let depth = random.within(2e-6, 1.2e-4);
            if side == Side::Left {
                input = mirrored(&input);
            }
            let at = pressed(&mut element, &input, depth);
            let mut output = Output::default();
            let start = Instant::now();
            element.evaluate(&at, &mut output).unwrap();
            let time = start.elapsed().as_secs_f64();
            writeln!(
                all,
                "{rail} {side:?},{number},{:.9e},{:.2}",
                output.wheel.force[2],
                1e6 * time
            )
            .unwrap();
            times.push(1e6 * time);
            fallbacks = output.fallback_count;
        }
        assert_eq!(fallbacks, 0);
        let steps = element.work().most_strip_steps;
        assert!(steps <= tolerance::STRIP_STEPS, "{rail} {side:?}: {steps}");
        times.sort_by(f64::total_cmp);
        let at = |share: f64| times[((times.len() - 1) as f64 * share) as usize];
        let steps = element.work().strip_steps as f64 / POSES as f64;
        println!(
            "{rail} {side:?}: {steps:.1} steps; time [us] median {:.0} 95% {:.0} 99% {:.0} 99.9% {:.0} worst {:.0}",
            at(0.5),
            at(0.95),
            at(0.99),
            at(0.999),
            at(1.0),
        );
    }
    write_report("strips_poses.csv", &all);
}

#[test]
fn answers_tell_how_well_their_equations_are_solved() {
    let mut element = Element::new(&Parameters::default(), &Input::default(), &[]).unwrap();
    let mut output = Output::default();
    for shift in (-60..=80).step_by(5) {
        let mut input = rolling(1e-4 * f64::from(shift), 20.0);
        input.wheel.yaw = 4e-3;
        let input = pressed(&mut element, &input, 8e-5);
        element.evaluate(&input, &mut output).unwrap();
        let gap = output.normal_residual;
        assert!(gap > 0.0 && gap <= tolerance::STRIPS_GAP, "y {shift}: {gap:e}");
    }
    // Nothing is left of nothing.
    element.evaluate(&Input::default(), &mut output).unwrap();
    assert!(output.normal_residual <= 0.0, "{output:?}");
}
