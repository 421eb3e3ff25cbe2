//! How long a round of `fmi2SetReal`, `fmi2DoStep` and `fmi2GetReal` takes at most: over a million
//! poses of random walks, as a real-time host meets them. `cargo bench --bench real_time`; with a
//! number behind `--` so many walks of 1000 poses.
//!
//! Times are of the processor, of this thread alone: what the system does in between is not the
//! unit's. What is left of it (interrupts, cold caches) is told from what a pose costs by doing the
//! slowest rounds again, five times each, and taking the least of their times. The contact has no
//! memory, so that a round again is the same work.
#![allow(unsafe_code)]

#[path = "../tests/suite/common/mod.rs"]
mod common;
// Clippy lets tests import by wildcard, benches not.
#[allow(clippy::wildcard_imports)]
#[path = "../tests/suite/host/mod.rs"]
mod host;

use common::random::Random;
use common::wheel::{pressed, rolling};
use host::{Arguments, Host};
use wheelrail::element::{Element, Input, Parameters};
use wheelrail::fmi::v2::types::{Status, TRUE, ValueReference};
use wheelrail::fmi::v2::{fmi2DoStep, fmi2ExitInitializationMode, fmi2GetReal, fmi2SetReal};
use wheelrail::variables::{Causality, Kind, Unit, WHEEL, WHEELSET};

/// Poses of one walk.
const POSES: usize = 1000;
/// Way of the wheel's surface between two poses [m].
const STEP: f64 = 1e-6;
/// Rounds that are done again.
const SLOWEST: usize = 1000;
const AGAIN: usize = 5;
/// Medians within which 99.99 % of the rounds are to be, and the greatest.
const AIMS: [f64; 2] = [5.0, 12.0];
/// Loads of a wheel [N], of which one goes with each walk where loads are given.
const LOADS: [f64; 2] = [1e4, 1.2e5];
/// What a host sets, of the body.
const INPUTS: [&str; 8] = ["y", "z", "roll", "yaw", "vx", "vy", "vz", "pitch_rate"];

/// What is measured: its name, the unit, and its choices and counts.
type Case = (&'static str, &'static Unit, &'static [(&'static str, i32)]);

/// Loads given in the place of heights.
const LOADED: (&str, i32) = ("vertical.mode", 2);
/// The fast pair.
const FAST: [(&str, i32); 3] =
    [("normal.model", 2), ("tangential.model", 3), ("creepage.model", 2)];
const LOADED_FAST: [(&str, i32); 4] = [LOADED, FAST[0], FAST[1], FAST[2]];

/// Processor time of this thread [s].
fn now() -> f64 {
    let mut time = libc::timespec { tv_sec: 0, tv_nsec: 0 };
    // SAFETY: POSIX: a clock that every thread has, and a place for its time.
    let status = unsafe { libc::clock_gettime(libc::CLOCK_THREAD_CPUTIME_ID, &raw mut time) };
    assert_eq!(status, 0);
    time.tv_sec as f64 + 1e-9 * time.tv_nsec as f64
}

/// A unit that a host steps, with the references that it uses.
struct Stepped {
    host: Box<Host>,
    inputs: Vec<ValueReference>,
    outputs: Vec<ValueReference>,
    values: Vec<f64>,
    is_wheelset: bool,
}

impl Stepped {
    fn new(unit: &'static Unit, settings: &[(&str, i32)]) -> Self {
        let host = Host::initializing_with(&Arguments::of(unit));
        for (name, value) in settings {
            assert_eq!(host.set_integer(name, *value), Status::Ok, "{}", host.last());
        }
        assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
        let is_wheelset = unit.identifier == "WheelSet";
        let body = if is_wheelset { "wheelset" } else { "wheel" };
        let inputs = INPUTS.iter().map(|name| host.reference(&format!("{body}.{name}"))).collect();
        let outputs: Vec<_> = (unit.variables.iter())
            .filter(|v| v.causality == Causality::Output && v.kind == Kind::Real && !v.on_request)
            .map(|v| host.reference(v.name))
            .collect();
        let values = vec![0.0; outputs.len()];
        Self { host, inputs, outputs, values, is_wheelset }
    }

    /// Takes `load` for that of each wheel [N].
    fn load(&self, load: f64) {
        let loads: &[&str] = if self.is_wheelset {
            &["right.wheel.load", "left.wheel.load"]
        } else {
            &["wheel.load"]
        };
        let values: Vec<(&str, f64)> = loads.iter().map(|&name| (name, load)).collect();
        assert_eq!(self.host.set_reals(&values), Status::Ok, "{}", self.host.last());
    }

    /// Time of a round [s].
    fn round(&mut self, inputs: &[f64; INPUTS.len()]) -> f64 {
        let c = self.host.component;
        let begin = now();
        // SAFETY: FMI 2.0, 2.1.7: all arrays hold as many elements as their counts say.
        let worst = unsafe {
            fmi2SetReal(c, self.inputs.as_ptr(), self.inputs.len(), inputs.as_ptr())
                .max(fmi2DoStep(c, 0.0, 1e-3, TRUE))
                .max(fmi2GetReal(
                    c,
                    self.outputs.as_ptr(),
                    self.outputs.len(),
                    self.values.as_mut_ptr(),
                ))
        };
        let time = now() - begin;
        assert!(worst <= Status::Warning, "{}", self.host.last());
        time
    }
}

/// A pose and the way to the next ones.
struct Walk {
    start: [f64; INPUTS.len()],
    way: [f64; INPUTS.len()],
}

impl Walk {
    /// With a roll angle of at most `most_roll` [rad]: of an axle it lifts one of the wheels by as
    /// many times 0.75 m.
    fn random(element: &mut Element, random: &mut Random, most_roll: f64) -> Self {
        let mut input = rolling(random.within(-8e-3, 9e-3), 20.0);
        let wheel = &mut input.wheel;
        (wheel.roll, wheel.yaw) = (random.about(most_roll), random.about(0.012));
        wheel.velocity[0] *= 1.0 + random.about(3e-3);
        wheel.velocity[1] = random.about(0.05);
        let depth = 10_f64.powf(random.within(-5.0, -3.85));
        let wheel = pressed(element, &input, depth).wheel;
        let [_, y, z] = wheel.position;
        let [vx, vy, vz] = wheel.velocity;
        // One part of y, a tenth of it down, turning a little.
        let way = [
            random.about(1.0),
            random.about(0.1),
            random.about(250.0 * most_roll),
            random.about(3.0),
        ];
        let way = way.map(|share| STEP * share);
        Self {
            start: [y, z, wheel.roll, wheel.yaw, vx, vy, vz, wheel.pitch_rate],
            way: [way[0], way[1], way[2], way[3], 0.0, 0.0, 0.0, 0.0],
        }
    }

    fn at(&self, pose: usize, lateral: f64) -> [f64; INPUTS.len()] {
        let mut inputs = self.start;
        for (input, way) in inputs.iter_mut().zip(self.way) {
            *input += way * pose as f64;
        }
        inputs[0] -= lateral;
        inputs
    }
}

fn main() {
    let walks = std::env::args().find_map(|a| a.parse().ok()).unwrap_or(1000);
    let cases: [Case; 7] = [
        ("wheel by default", &WHEEL, &[]),
        ("the same, load given", &WHEEL, &[LOADED]),
        ("wheel, piotrowski_kik with fastsim, flat", &WHEEL, &FAST),
        ("the same, load given", &WHEEL, &LOADED_FAST),
        ("wheelset by default", &WHEELSET, &[]),
        ("the same, loads given", &WHEELSET, &[LOADED]),
        ("wheelset, piotrowski_kik with fastsim, flat", &WHEELSET, &FAST),
    ];
    let [of_most, of_all] = AIMS;
    println!("microseconds of {walks} walks of {POSES} poses\n");
    println!(
        "| unit | median | 99.9 % | 99.99 % | greatest | greatest again | medians: 99.99 %, greatest again | within {of_most} and {of_all} |\n\
         |---|---|---|---|---|---|---|---|"
    );
    for (name, unit, settings) in cases {
        let mut stepped = Stepped::new(unit, settings);
        // The centre of a wheelset is the marker of its right wheel less this.
        let (lateral, most_roll) =
            if unit.identifier == "WheelSet" { (0.75, 0.0) } else { (0.0, 4e-3) };
        let mut element =
            Element::new(&Parameters::default(), &Input::default(), &[]).expect("built in");
        let mut random = Random::new(1);
        let mut times: Vec<(f64, [f64; INPUTS.len()], f64)> = Vec::with_capacity(walks * POSES);
        for _ in 0..walks {
            let walk = Walk::random(&mut element, &mut random, most_roll);
            let load = random.within(LOADS[0], LOADS[1]);
            stepped.load(load);
            for pose in 0..POSES {
                let inputs = walk.at(pose, lateral);
                times.push((stepped.round(&inputs), inputs, load));
            }
        }
        times.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        let at = |share: f64| 1e6 * times[((times.len() - 1) as f64 * share) as usize].0;
        let slowest = &times[times.len().saturating_sub(SLOWEST)..];
        let mut again = 0.0_f64;
        for (_, inputs, load) in slowest {
            stepped.load(*load);
            // Other inputs before, or nothing would be evaluated.
            let mut beside = *inputs;
            beside[0] += STEP;
            let mut least = f64::INFINITY;
            for _ in 0..AGAIN {
                stepped.round(&beside);
                least = least.min(stepped.round(inputs));
            }
            again = again.max(1e6 * least);
        }
        let medians = [at(0.9999).min(again) / at(0.5), again / at(0.5)];
        let is_within = medians[0] <= of_most && medians[1] <= of_all;
        println!(
            "| {name} | {:.1} | {:.1} | {:.1} | {:.1} | {again:.1} | {:.1}, {:.1} | {} |",
            at(0.5),
            at(0.999),
            at(0.9999),
            at(1.0),
            medians[0],
            medians[1],
            if is_within { "yes" } else { "no" },
        );
    }
}
