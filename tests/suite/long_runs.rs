//! Random walks of all inputs, with everything counted that must not happen.
//!
//! A short walk in every run of the tests; long ones, in release builds, by
//! `WHEELRAIL_EVALUATIONS=100000000 cargo test --release --test suite
//! long_runs:: -- --ignored --nocapture`; the table goes to target/reports/long_runs.csv;
//! `WHEELRAIL_MODELS=cheapest` walks with the four cheapest models alone. Models slower than
//! Piotrowski-Kik get a share that takes them about as long.

use crate::allocations;
use crate::tolerance;
use std::fmt::Write;
use std::time::Instant;

use crate::common::random::Random;
use crate::common::write_report;
use wheelrail::element::parameters::{CreepageModel, NormalModel, TangentialModel};
use wheelrail::element::{Element, Input, Output, Parameters};

/// Greatest step of a length [m], of an angle [rad]; speeds move a thousand times as far.
const STEP: f64 = 1e-7;
/// How far the inputs go from the middle.
const REACH: [(f64, f64); 9] = [
    (9e-3, 1.0),  // lateral position
    (2e-4, 0.1),  // depth below first touch
    (1e-2, 1.0),  // roll
    (3e-2, 1.0),  // yaw
    (60.0, 1e3),  // speed
    (0.3, 1e3),   // lateral velocity
    (150.0, 1e3), // pitch rate
    (2e-3, 1.0),  // rail, lateral
    (1e-2, 1.0),  // rail, roll
];
/// Share of leaps in short walks and in those of a hundred thousand steps and more. After each the
/// height of first touch is searched, which takes as long as some fifty evaluations.
const LEAPS: [f64; 2] = [0.05, 0.005];
/// A normal force that moves by more than this share of itself and this much [N] in one step has
/// jumped: all inputs together move the penetration by a few tenths of a micrometre.
const JUMP: f64 = 0.05;
const JUMPING_LOAD: f64 = 1e3;

/// What a walk met.
#[derive(Debug, Default)]
struct Counters {
    not_finite: u64,
    beyond_friction: u64,
    feeding: u64,
    jumps: u64,
    fallbacks: u64,
    allocations: usize,
    touching: u64,
}

/// Inputs that wander.
struct Walk {
    random: Random,
    leaps: f64,
    at: [f64; 9],
}

impl Walk {
    fn new(seed: u64, steps: u64) -> Self {
        let mut random = Random::new(seed);
        let at = REACH.map(|(reach, _)| random.about(reach));
        Self { random, leaps: LEAPS[usize::from(steps >= 100_000)], at }
    }

    /// A step of each, back towards the middle at the ends; now and then somewhere else, which is
    /// no step.
    fn step(&mut self) -> bool {
        let leap = self.random.within(0.0, 1.0) < self.leaps;
        for (value, (reach, size)) in self.at.iter_mut().zip(REACH) {
            *value = if leap {
                self.random.about(reach)
            } else {
                let next = *value + self.random.about(STEP * size);
                next.clamp(-reach, reach)
            };
        }
        !leap
    }

    /// The inputs where the walk is now, at the height `z`.
    fn input(&self, z: f64) -> Input {
        let [y, _, roll, yaw, speed, lateral, pitch, rail_y, rail_roll] = self.at;
        let mut input = Input::default();
        input.wheel.position = [0.0, 0.75 + y, z];
        (input.wheel.roll, input.wheel.yaw) = (roll, yaw);
        input.wheel.velocity = [speed, lateral, 0.0];
        input.wheel.pitch_rate = pitch;
        (input.rails[0].y, input.rails[0].roll) = (rail_y, rail_roll);
        input
    }

    /// A height at which the wheel is as deep as the walk wants it.
    fn height(&self, element: &mut Element) -> f64 {
        element.touching_height(&self.input(-0.46)) + self.at[1]
    }
}

fn walk(parameters: &Parameters, evaluations: u64, seed: u64) -> Counters {
    let mut element = Element::new(parameters, &Input::default(), &[]).unwrap();
    let mut walk = Walk::new(seed, evaluations);
    let mut counters = Counters::default();
    let mut output = Output::default();
    let mut z = walk.height(&mut element);
    let mut before = None;
    for _ in 0..evaluations {
        let near = walk.step();
        if near {
            z += walk.random.about(STEP);
        } else {
            z = walk.height(&mut element);
        }
        let input = walk.input(z);
        let allocated = allocations::count();
        element.evaluate(&input, &mut output).unwrap();
        counters.allocations += allocations::count() - allocated;
        counters.look_at(&output, input.friction);
        let load: f64 = output.patches.iter().map(|p| p.normal_force).sum();
        if let Some(before) = before.filter(|_| near) {
            let moved: f64 = load - before;
            counters.jumps += u64::from(moved.abs() > JUMP * load + JUMPING_LOAD);
        }
        before = Some(load);
    }
    counters.fallbacks = element.fallbacks();
    counters
}

impl Counters {
    fn look_at(&mut self, output: &Output, friction: f64) {
        let numbers = output.wheel.force.iter().chain(&output.wheel.moment);
        self.not_finite += u64::from(!numbers.copied().all(f64::is_finite));
        self.touching += u64::from(output.patch_count > 0);
        self.feeding += u64::from(output.frictional_power < 0.0);
        let beyond = output.patches.iter().any(|p| {
            let force = p.creep_force[0].hypot(p.creep_force[1]);
            force > tolerance::most_friction(false, p.penetration) * friction * p.normal_force
        });
        self.beyond_friction += u64::from(beyond);
    }
}

/// The cheapest models, which `WHEELRAIL_MODELS=cheapest` leaves alone.
const CHEAPEST: usize = 4;

/// Models with the share of the evaluations that each gets, and whether they jump by nature where
/// the deepest of two minima changes.
fn models() -> [(&'static str, Parameters, f64, bool); 12] {
    use NormalModel::{Hertz, PiotrowskiKik, PiotrowskiKikCorrected, Strips};
    use TangentialModel::{Fastrip, Fastsim, FastsimCorrected, Linear, None, Tables};
    let with = |normal_model, strips, tangential_model| Parameters {
        normal_model,
        strips,
        elements_along: 12,
        tangential_model,
        ..Parameters::default()
    };
    [
        ("hertz + none", with(Hertz, 8, None), 1.0, true),
        ("hertz + fastsim", with(Hertz, 8, Fastsim), 1.0, true),
        ("piotrowski_kik + fastsim", with(PiotrowskiKik, 12, Fastsim), 0.5, true),
        ("piotrowski_kik + linear", with(PiotrowskiKik, 12, Linear), 0.5, true),
        (
            "piotrowski_kik_corrected + fastrip",
            with(PiotrowskiKikCorrected, 12, Fastrip),
            0.5,
            true,
        ),
        ("strips + fastsim", with(Strips, 11, Fastsim), 0.05, false),
        ("strips + fastrip", with(Strips, 11, Fastrip), 0.05, false),
        ("piotrowski_kik + tables", with(PiotrowskiKik, 12, Tables), 0.5, true),
        (
            "piotrowski_kik + fastsim_corrected",
            with(PiotrowskiKik, 12, FastsimCorrected),
            0.25,
            true,
        ),
        ("strips + tables", with(Strips, 11, Tables), 0.02, false),
        ("strips + fastsim_corrected", with(Strips, 11, FastsimCorrected), 0.02, false),
        (
            "strips + fastsim, curved",
            Parameters { creepage_model: CreepageModel::Curved, ..with(Strips, 11, Fastsim) },
            0.02,
            false,
        ),
    ]
}

/// Walks with all models; a row for each.
fn report(evaluations: u64, name: &str) {
    let mut report = String::from(
        "models,evaluations,touching,not finite,beyond friction,fed energy,allocations,fallbacks,jumps\n",
    );
    let cheapest = std::env::var("WHEELRAIL_MODELS").is_ok_and(|models| models == "cheapest");
    let count = if cheapest { CHEAPEST } else { usize::MAX };
    for (seed, (models, parameters, share, jumps_by_nature)) in
        models().into_iter().enumerate().take(count)
    {
        let share = if cheapest { 1.0 } else { share };
        let count = (share * evaluations as f64) as u64;
        let begin = Instant::now();
        let c = walk(&parameters, count, seed as u64 + 1);
        println!("{models}: {:.1} us", 1e6 * begin.elapsed().as_secs_f64() / count as f64);
        writeln!(
            report,
            "{models},{count},{},{},{},{},{},{},{}",
            c.touching,
            c.not_finite,
            c.beyond_friction,
            c.feeding,
            c.allocations,
            c.fallbacks,
            c.jumps
        )
        .unwrap();
        write_report(name, &report);
        let is_linear = parameters.tangential_model == TangentialModel::Linear;
        assert!(is_linear || c.beyond_friction == 0, "{models}: {c:?}");
        assert!(c.not_finite == 0 && c.feeding == 0 && c.allocations == 0, "{models}: {c:?}");
        assert!(c.touching > count / 8, "{models}: {c:?}");
        // One wheel in a million poses may find no room or no solution; where it does, the force
        // may jump.
        assert!(c.fallbacks <= 1 + count / 1000, "{models}: {c:?}");
        assert!(jumps_by_nature || c.jumps <= 2 * c.fallbacks, "{models}: {c:?}");
    }
    println!("{report}");
}

#[test]
fn a_short_walk_meets_nothing_that_must_not_happen() {
    report(4000, "long_runs_some.csv");
}

#[test]
#[ignore = "long: WHEELRAIL_EVALUATIONS of the cheapest models, a million without it"]
fn a_long_walk_meets_nothing_that_must_not_happen() {
    let evaluations = std::env::var("WHEELRAIL_EVALUATIONS")
        .ok()
        .map_or(1_000_000, |n| n.parse().expect("WHEELRAIL_EVALUATIONS is a whole number"));
    report(evaluations, "long_runs.csv");
}
