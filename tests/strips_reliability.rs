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

/// A sweep of one coordinate of the wheel: what is moved, from where, in which steps and fine steps.
#[derive(Clone, Copy)]
struct Sweep {
    name: &'static str,
    from: f64,
    coarse: f64,
    fine: f64,
    /// Lateral shift [m] and yaw angle [rad] where they are not moved.
    shift: f64,
    yaw: f64,
}

/// Positions of a sweep, and places looked at again in fine steps.
const POSITIONS: usize = 7500;
const PLACES: usize = 60;

/// Lengths in steps of 2 and 0.1 µm, angles of up to 15 mm on the running circle in steps of 1 and 0.1 µrad; all but the height 80 µm
/// below first touch of the coarse place.
const SWEEPS: [Sweep; 5] = [
    Sweep { name: "shift", from: -6e-3, coarse: 2e-6, fine: 1e-7, shift: 0.0, yaw: 1e-3 },
    Sweep { name: "height", from: 0.0, coarse: 2e-8, fine: 1e-9, shift: 5.2e-3, yaw: 1e-3 },
    Sweep { name: "roll", from: -4e-3, coarse: 1e-6, fine: 1e-7, shift: 0.0, yaw: 1e-3 },
    Sweep { name: "yaw", from: -1e-2, coarse: 3e-6, fine: 1e-7, shift: 0.0, yaw: 0.0 },
    Sweep { name: "yaw", from: -1e-2, coarse: 3e-6, fine: 1e-7, shift: 6.2e-3, yaw: 0.0 },
];

impl Sweep {
    fn input(&self, t: f64) -> Input {
        let moved = |name| if self.name == name { t } else { 0.0 };
        let mut input = rolling(self.shift + moved("shift"), 20.0);
        input.wheel.yaw = self.yaw + moved("yaw");
        input.wheel.roll = moved("roll");
        input
    }

    /// Vertical force, up, and lateral force on the wheel at `count` positions from `from`, at the depth of each (`level` none) or all at a height.
    fn forces(
        &self,
        element: &mut Element,
        from: f64,
        step: f64,
        count: usize,
        level: Option<f64>,
    ) -> Vec<[f64; 2]> {
        let at = |i: usize| from + step * i as f64;
        (0..count)
            .map(|i| {
                let t = at(i);
                let depth = if self.name == "height" { t } else { 8e-5 };
                let mut input = self.input(t);
                let height = element.touching_height(&self.input(level.unwrap_or(t)));
                input.wheel.position[2] = height + depth;
                let mut output = Output::default();
                element.evaluate(&input, &mut output).unwrap();
                // The sum of the patches' normal forces is no force: where two frames become one it falls to that of their resultant.
                [-output.wheel.force[2], output.wheel.force[1]]
            })
            .collect()
    }

    /// Second differences of both forces over the load in fine steps, with their places, greatest first.
    fn jumps(&self, model: NormalModel) -> Vec<[f64; 3]> {
        let parameters = Parameters {
            normal_model: model,
            strips: 15,
            tangential_model: TangentialModel::None,
            ..Parameters::default()
        };
        let mut element = Element::new(&parameters, &Input::default(), &[]).unwrap();
        let bend = |f: &[[f64; 2]], i: usize| -> [f64; 2] {
            let load = f[i][0].max(1e3);
            [0, 1].map(|k| (f[i + 1][k] - 2.0 * f[i][k] + f[i - 1][k]).abs() / load)
        };
        let coarse = self.forces(&mut element, self.from, self.coarse, POSITIONS, None);
        let mut places: Vec<(f64, usize)> =
            (1..POSITIONS - 1).map(|i| (bend(&coarse, i)[0], i)).collect();
        places.sort_by(|a, b| b.0.total_cmp(&a.0));
        let count = (2.0 * self.coarse / self.fine).round() as usize + 1;
        let mut found: Vec<[f64; 3]> = Vec::new();
        for &(_, i) in places.iter().take(PLACES) {
            let from = self.from + self.coarse * (i as f64 - 1.0);
            // One height for all, so that the search for it adds nothing.
            let fine = self.forces(&mut element, from, self.fine, count, Some(from));
            for j in 1..count - 1 {
                let [n, y] = bend(&fine, j);
                found.push([1e3 * (from + self.fine * j as f64), n, y]);
            }
        }
        found.sort_by(|a, b| b[1].total_cmp(&a[1]));
        found
    }
}

#[test]
#[ignore = "some 100 000 evaluations; for a release build"]
fn largest_jumps_of_sweeps() {
    let mut report =
        String::from("moved,shift_mm,model,at_mm_or_mrad,vertical_force,lateral_force\n");
    let mut worst: f64 = 0.0;
    for sweep in SWEEPS {
        for model in [NormalModel::PiotrowskiKik, NormalModel::Strips] {
            let found = sweep.jumps(model);
            for [at, n, lateral] in found.iter().take(5) {
                let (name, shift) = (sweep.name, 1e3 * sweep.shift);
                writeln!(report, "{name},{shift},{model:?},{at:.5},{n:.2e},{lateral:.2e}").unwrap();
            }
            if model == NormalModel::Strips {
                worst = worst.max(found[0][1]);
            }
        }
    }
    write_report("strips_sweeps.csv", &report);
    assert!(worst <= tolerance::STRIPS_SWEEP_JUMP, "{report}");
}
