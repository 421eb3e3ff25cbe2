//! Straight lines through the poses of a wheel on its rail, along which jumps of the force are
//! looked for.
//!
//! Where the force bends between neighbouring steps the step is halved towards the larger part of
//! the change, until a slope has become small or a jump is left.

use std::time::Instant;

use wheelrail::element::{Element, Input, Output};

use super::random::Random;
use super::wheel::{pressed, rolling};

/// Step of the wheel's surface [m].
pub const STEP: f64 = 1e-7;
/// Steps of one line.
pub const STEPS: usize = 1000;
/// Halvings of a step, after which 0.1 µm are rounding of a coordinate.
const HALVINGS: usize = 24;
/// Share of what is admitted as a jump from which on the bend between two steps is looked into.
const SUSPICIOUS: f64 = 0.3;
/// Least load that a jump refers to [N]: less is no force of a wheel on its rail.
const MIN_LOAD: f64 = 1e3;
/// Distance of the surface of a wheel from its marker, and of the ends of the patch from each
/// other, that turn angles into lengths [m].
const ARMS: [f64; 2] = [0.46, 0.05];
pub const FRICTION: f64 = 0.3;

/// Load over normal stiffness of a contact [m], as kinks are over that stiffness: two thirds of an
/// overlap of a tenth of a millimetre.
const STIFFNESS_LENGTH: f64 = 7e-5;

/// What is moved along a line, by how much for each unit of it.
#[derive(Clone, Copy)]
pub struct Line {
    pub start: Input,
    pub y: f64,
    pub z: f64,
    pub roll: f64,
    pub yaw: f64,
    /// The station, and the pitch.
    pub along: f64,
    pub pitch: f64,
}

impl Line {
    pub fn random(element: &mut Element, random: &mut Random) -> Self {
        let mut input = rolling(random.within(-8e-3, 9e-3), 20.0);
        let wheel = &mut input.wheel;
        (wheel.roll, wheel.yaw) = (random.about(4e-3), random.about(0.012));
        wheel.velocity[0] *= 1.0 + random.about(3e-3);
        wheel.velocity[1] = random.about(0.05);
        input.friction = FRICTION;
        let depth = 10_f64.powf(random.within(-5.0, -3.85));
        let start = pressed(element, &input, depth);
        let [y, z, roll, yaw] = [1.0, 0.3, 0.5, 0.5].map(|most| random.about(most));
        let sum = y.abs() + z.abs() + roll.abs() + yaw.abs();
        let [y, z, roll, yaw] = [y, z, roll, yaw].map(|share| share / sum);
        let (roll, yaw) = (roll / ARMS[0], yaw / ARMS[1]);
        Self { start, y, z, roll, yaw, along: 0.0, pitch: 0.0 }
    }

    /// The same of bodies that vary: within `reach` of station 0 [m], turned by up to `turn` [rad],
    /// rolling on besides.
    pub fn over_uneven(
        element: &mut Element,
        random: &mut Random,
        aside: [f64; 2],
        [reach, turn]: [f64; 2],
    ) -> Self {
        let mut input = rolling(random.within(aside[0], aside[1]), 20.0);
        let wheel = &mut input.wheel;
        (wheel.roll, wheel.yaw) = (random.about(4e-3), random.about(0.012));
        wheel.velocity[0] *= 1.0 + random.about(3e-3);
        wheel.velocity[1] = random.about(0.05);
        wheel.pitch = random.about(turn);
        input.track_s = random.about(reach);
        input.friction = FRICTION;
        let depth = 10_f64.powf(random.within(-5.0, -3.85));
        let start = pressed(element, &input, depth);
        let ways = [1.0, 0.3, 0.5, 0.5, 1.0, 1.0].map(|most| random.about(most));
        let sum: f64 = ways.iter().map(|way| way.abs()).sum();
        let [y, z, roll, yaw, along, pitch] = ways.map(|share| share / sum);
        let (roll, yaw, pitch) = (roll / ARMS[0], yaw / ARMS[1], pitch / ARMS[0]);
        Self { start, y, z, roll, yaw, along, pitch }
    }

    pub fn at(&self, way: f64) -> Input {
        let mut input = self.start;
        let wheel = &mut input.wheel;
        wheel.position[1] += self.y * way;
        wheel.position[2] += self.z * way;
        wheel.roll += self.roll * way;
        wheel.yaw += self.yaw * way;
        wheel.pitch += self.pitch * way;
        input.track_s += self.along * way;
        input
    }
}

/// What one line has shown.
#[derive(Clone, Copy, Default)]
pub struct Found {
    /// Largest jump over its scale, and where it is.
    pub jump: f64,
    pub at: f64,
    /// Largest change of the stiffness along the line from step to step, over the stiffness of the
    /// contact.
    pub kink: f64,
}

/// Largest difference of two forces over `scale`.
fn difference(a: [f64; 3], b: [f64; 3], scale: f64) -> f64 {
    (0..3).map(|i| (a[i] - b[i]).abs()).fold(0.0, f64::max) / scale
}

/// Follows a line; jumps are over `share` of the load, and `most` is what is admitted.
pub fn follow(
    element: &mut Element,
    line: &Line,
    share: f64,
    most: f64,
    times: &mut Vec<f64>,
) -> Found {
    let mut output = Output::default();
    let mut force = |way: f64, times: Option<&mut Vec<f64>>| {
        let input = line.at(way);
        let begin = Instant::now();
        element.evaluate(&input, &mut output).unwrap();
        if let Some(times) = times {
            times.push(begin.elapsed().as_secs_f64());
        }
        output.wheel.force
    };
    let mut last = [[0.0; 3]; 3];
    let mut found = Found::default();
    for k in 0..STEPS {
        let way = STEP * k as f64;
        last.rotate_left(1);
        last[2] = force(way, Some(times));
        if k < 2 {
            continue;
        }
        let load = last[1][2].abs().max(MIN_LOAD);
        let scale = share * load;
        let [a, b, c] = last;
        let bend = (0..3).map(|i| (a[i] - 2.0 * b[i] + c[i]).abs()).fold(0.0, f64::max);
        // A contact that opens or closes has a stiffness that bends without end, as Hertz's has.
        if last.iter().all(|force| force[2].abs() > MIN_LOAD) {
            found.kink = found.kink.max(bend / (load * STEP / STIFFNESS_LENGTH));
        }
        if bend < SUSPICIOUS * most * scale {
            continue;
        }
        let (mut from, mut to) = (way - 2.0 * STEP, way);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (from + to);
            let [a, b, c] = [from, middle, to].map(|way| force(way, None));
            if difference(a, b, 1.0) > difference(b, c, 1.0) {
                to = middle;
            } else {
                from = middle;
            }
        }
        let jump = difference(force(from, None), force(to, None), scale);
        if jump > found.jump {
            (found.jump, found.at) = (jump, from);
        }
    }
    found
}
