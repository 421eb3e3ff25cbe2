//! The strip model on many random poses: how often no solution is found, and what a solution costs.

mod common;
mod tolerance;

use std::fmt::Write;
use std::time::Instant;

use common::random::Random;
use common::wheel::{mirrored, pressed, rolling};
use common::write_report;
use wheelrail::element::parameters::{NormalModel, Side, TangentialModel};
use wheelrail::element::{Element, Input, Output, Parameters};

/// Poses of each pair of profiles.
const POSES: usize = 5000;
/// Share of the worst pair of profiles (54E1) over that of all.
const WORST_SET: f64 = 3.0;

fn wheel(rail: &str, side: Side) -> Element {
    let mut parameters = Parameters {
        normal_model: NormalModel::Strips,
        strips: 15,
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
fn fallbacks_and_cost_of_random_poses() {
    let mut fixed_poses = String::from("set,number,shift_mm,roll_mrad,yaw_mrad,depth_um,force_n\n");
    let mut all_held = 0;
    let mut all = String::from("set,number,force_n,time_us\n");
    for (seed, (rail, side)) in
        [("60E1", Side::Right), ("60E1", Side::Left), ("54E1", Side::Right), ("60E2", Side::Left)]
            .into_iter()
            .enumerate()
    {
        let mut element = wheel(rail, side);
        let mut random = Random::new(100 + seed as u64);
        let (mut before, mut held, mut times, mut failed_times) = (0, 0, Vec::new(), Vec::new());
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
            let fixed = element.work().fixed_strips;
            if output.fallback_count > before || fixed > held {
                failed_times.push(1e6 * time);
                let w = &at.wheel;
                writeln!(
                    fixed_poses,
                    "{rail} {side:?},{number},{:.6},{:.6},{:.6},{:.4},{:.1}",
                    1e3 * w.position[1],
                    1e3 * w.roll,
                    1e3 * w.yaw,
                    1e6 * depth,
                    output.wheel.force[2]
                )
                .unwrap();
            } else {
                times.push(1e6 * time);
            }
            (before, held) = (output.fallback_count, fixed);
        }
        assert_eq!(before, 0, "fallbacks to Piotrowski-Kik");
        assert!(held as f64 <= WORST_SET * tolerance::STRIPS_FIXED * POSES as f64, "{fixed_poses}");
        all_held += held;
        times.sort_by(f64::total_cmp);
        let at = |share: f64| times[((times.len() - 1) as f64 * share) as usize];
        println!(
            "{rail} {side:?}: {before} fallbacks, {held} with fixed strips of {POSES}; time [us] median {:.0} 95% {:.0} 99% {:.0} 99.9% {:.0} worst {:.0}; of those {:.0}",
            at(0.5),
            at(0.95),
            at(0.99),
            at(0.999),
            at(1.0),
            failed_times.iter().sum::<f64>() / failed_times.len().max(1) as f64,
        );
    }
    write_report("strips_poses.csv", &all);
    write_report("strips_fixed_many.csv", &fixed_poses);
    assert!(all_held as f64 <= tolerance::STRIPS_FIXED * (4 * POSES) as f64);
}
