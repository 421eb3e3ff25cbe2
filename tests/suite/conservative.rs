//! Without friction the force of the element does no work around a closed loop, and a wheel without
//! damping bounces as high as it fell.

use crate::tolerance;
use std::f64::consts::PI;

use crate::common::median_and_worst;
use crate::common::random::Random;
use crate::common::summary::Summary;
use wheelrail::element::parameters::TangentialModel;
use wheelrail::element::{Element, Input, Output, Parameters};

/// Pairs of wheel and rail.
const PAIRS: [[&str; 2]; 4] =
    [["S1002", "60E1"], ["S1002", "54E1"], ["S1002_worn.txt", "60E1"], ["S1002", "60E2"]];

/// Mass of a bouncing wheel [kg]: an unsprung wheel of a coach.
const MASS: f64 = 1000.0;

/// A frictionless element of a pair and a wheel across and above its rail.
struct Bodies {
    element: Element,
    input: Input,
    output: Output,
}

impl Bodies {
    fn new([wheel, rail]: [&str; 2]) -> Self {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/fmu/resources/profiles");
        let tangential_model = TangentialModel::None;
        let mut parameters = Parameters { tangential_model, ..Parameters::default() };
        parameters.wheel.profile = wheel.into();
        parameters.rails[0].profile = rail.into();
        let input = Input::default();
        let element = Element::new(&parameters, &input, &[folder.into()]).unwrap();
        Self { element, input, output: Output::default() }
    }

    /// Turns the wheel; returns a place across.
    fn turn(&mut self, random: &mut Random) -> f64 {
        let start = Input::default();
        (self.input.wheel.roll, self.input.wheel.yaw) = (random.about(2e-3), random.about(0.01));
        start.wheel.position[1] + random.within(-8e-3, 8e-3)
    }

    fn touching(&mut self, y: f64) -> f64 {
        self.input.wheel.position[1] = y;
        self.element.touching_height(&self.input)
    }

    /// Lateral and vertical force on the wheel at (y, z).
    fn force(&mut self, [y, z]: [f64; 2]) -> [f64; 2] {
        [self.input.wheel.position[1], self.input.wheel.position[2]] = [y, z];
        self.element.evaluate(&self.input, &mut self.output).unwrap();
        [self.output.wheel.force[1], self.output.wheel.force[2]]
    }

    /// Work around an ellipse in (y, z) of random place, `width` and depth, over the energy stored
    /// in the contact: the sum over equal steps of its angle is exact for smooth forces.
    fn loop_work(&mut self, random: &mut Random, width: f64) -> f64 {
        const STEPS: usize = 200;
        let centre = self.turn(random);
        let depth = 10_f64.powf(random.within(-5.0, -4.1));
        let phase = random.about(PI);
        let [left, middle, right] =
            [-1.0, 0.0, 1.0].map(|side| self.touching(centre + side * width));
        // Along the height of first touch, which bends on a flange root.
        let (slope, bend) = (0.5 * (right - left), 0.5 * (left + right) - middle);
        let (mut work, mut load) = (0.0, 0.0_f64);
        for k in 0..STEPS {
            let angle = 2.0 * PI * k as f64 / STEPS as f64;
            let (sine, cosine) = angle.sin_cos();
            let height = middle + cosine * (slope + bend * cosine);
            let z = height + depth * (1.2 + 0.7 * (angle + phase).sin());
            let [fy, fz] = self.force([centre + width * cosine, z]);
            let dz = -sine * (slope + 2.0 * bend * cosine) + 0.7 * depth * (angle + phase).cos();
            work += (-fy * width * sine + fz * dz) * 2.0 * PI / STEPS as f64;
            load = load.max(fy.hypot(fz));
        }
        // The force goes with the power 3/2 of the depth.
        work.abs() / (0.4 * load * 1.9 * depth)
    }

    /// Energy lost or won in one bounce that is some 0.1 mm deep, over the energy of the fall.
    fn bounce(&mut self, random: &mut Random) -> f64 {
        // A bounce lasts some 5 ms.
        const STEP: f64 = 1e-5;
        const MAX_STEPS: usize = 5000;
        let y = self.turn(random);
        let z = self.touching(y);
        let fall = random.within(0.02, 0.1);
        let rate = |bodies: &mut Self, state: [f64; 4]| {
            let [fy, fz] = bodies.force([state[0], state[1]]);
            [state[2], state[3], fy / MASS, fz / MASS]
        };
        let along = |state: [f64; 4], rate: [f64; 4], time: f64| -> [f64; 4] {
            std::array::from_fn(|i| state[i] + rate[i] * time)
        };
        let mut state = [y, z - 1e-9, 0.0, fall];
        let mut has_touched = false;
        for _ in 0..MAX_STEPS {
            // Runge and Kutta's rule of fourth order.
            let first = rate(self, state);
            let second = rate(self, along(state, first, 0.5 * STEP));
            let third = rate(self, along(state, second, 0.5 * STEP));
            let fourth = rate(self, along(state, third, STEP));
            for i in 0..4 {
                state[i] += STEP / 6.0 * (first[i] + 2.0 * (second[i] + third[i]) + fourth[i]);
            }
            let [fy, fz] = self.force([state[0], state[1]]);
            let is_touching = fy.hypot(fz) > 0.0;
            if has_touched && !is_touching {
                let energy = (state[2] * state[2] + state[3] * state[3]) / (fall * fall);
                return (energy - 1.0).abs();
            }
            has_touched |= is_touching;
        }
        panic!("the wheel does not come back from y {y}, z {z}, {fall} m/s");
    }
}

/// Measures `count` loops of each width and bounces for each pair.
fn measure(count: usize, seed: u64) {
    let mut summary = Summary::new("conservative");
    let mut beyond = Vec::new();
    let mut judge = |kind: &str, limits: [f64; 2], test: fn(&mut Bodies, &mut Random) -> f64| {
        let aim = ["1e-4", "1e-3"][usize::from(kind == "bounces")];
        let mut all = Vec::new();
        for (k, pair) in PAIRS.into_iter().enumerate() {
            let (mut bodies, mut random) = (Bodies::new(pair), Random::new(seed + k as u64));
            let misses: Vec<f64> = (0..count).map(|_| test(&mut bodies, &mut random)).collect();
            let [wheel, rail] = pair;
            summary.add(
                &format!("{kind} [of the energy]; {wheel} on {rail}"),
                misses.iter().copied(),
                aim,
            );
            all.extend(misses);
        }
        let [median, worst] = median_and_worst(all);
        if median >= limits[0] || worst >= limits[1] {
            beyond.push(format!("{kind}: {median} {worst}"));
        }
    };
    judge("loops of 0.05 mm", tolerance::LOOP_WORK, |bodies, random| {
        let width = random.within(1e-5, 5e-5);
        bodies.loop_work(random, width)
    });
    judge("loops of 0.5 mm", tolerance::WIDE_LOOP_WORK, |bodies, random| {
        let width = random.within(1e-4, 5e-4);
        bodies.loop_work(random, width)
    });
    judge("bounces", tolerance::BOUNCE, Bodies::bounce);
    summary.write();
    assert!(beyond.is_empty(), "{beyond:?}");
}

#[test]
fn loops_and_bounces_without_friction_keep_their_energy() {
    measure(3, 7);
}

#[test]
#[ignore = "some million evaluations: for a release build"]
fn many_loops_and_bounces_without_friction_keep_their_energy() {
    measure(500, 1000);
}
