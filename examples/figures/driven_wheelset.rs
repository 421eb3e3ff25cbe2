//! A wheelset that is driven along a straight track at constant speed, its wheels loaded evenly,
//! and wears.
//!
//! Its spin follows from the driving moment and the creep forces, its lateral place from the
//! lateral forces or from a prescribed sway. Semi-implicit Euler: mass and creep coefficients allow
//! steps of half a millisecond.

use std::error::Error;

use wheelrail::element::parameters::{Side, VerticalMode};
use wheelrail::element::{Element, Input, Output, Parameters};

const SPEED: f64 = 20.0;
const MASS: f64 = 1200.0;
const AXLE_INERTIA: f64 = 100.0;
const WHEEL_LOAD: f64 = 98.1e3;
const DRIVING_MOMENT: f64 = 6e3;
const HALF_DISTANCE: f64 = 0.75;
/// Time in which the lateral motion of the start dies out [s].
const START: f64 = 0.5;

/// How a wheelset is guided.
#[derive(Clone, Copy)]
pub enum Guidance {
    /// By the rails alone, with this yaw [rad].
    Free { yaw: f64 },
    /// On a sine of this amplitude and wavelength [m], heading along it.
    Sway { amplitude: f64, wavelength: f64 },
}

pub struct DrivenWheelset {
    /// Left and right wheel.
    pub wheels: Vec<Element>,
    pub outputs: [Output; 2],
    guidance: Guidance,
    y: f64,
    lateral_speed: f64,
    pitch_rate: f64,
    time: f64,
    /// Distance run [m].
    pub distance: f64,
}

impl DrivenWheelset {
    /// A wheelset on its way; nothing is worn off yet.
    pub fn new(parameters: &Parameters, guidance: Guidance) -> Result<Self, Box<dyn Error>> {
        let wheel = |side| {
            let vertical_mode = VerticalMode::Load;
            let parameters = Parameters { side, vertical_mode, ..parameters.clone() };
            Element::new(&parameters, &input(side), &[])
        };
        Ok(Self {
            wheels: vec![wheel(Side::Left)?, wheel(Side::Right)?],
            outputs: [Output::default(); 2],
            guidance,
            y: 0.0,
            lateral_speed: 0.0,
            pitch_rate: -SPEED / 0.46,
            time: -START,
            distance: 0.0,
        })
    }

    /// Runs until the motion of the start has died out, without wear.
    pub fn settle(&mut self, h: f64) -> Result<(), Box<dyn Error>> {
        (self.time, self.distance) = (-START, 0.0);
        while self.time < -0.5 * h {
            self.step(h, 0.0)?;
        }
        (self.time, self.distance) = (0.0, 0.0);
        Ok(())
    }

    /// One step of `h` seconds in which what wears stands for `worn` seconds.
    pub fn step(&mut self, h: f64, worn: f64) -> Result<(), Box<dyn Error>> {
        let yaw = match self.guidance {
            Guidance::Free { yaw } => yaw,
            Guidance::Sway { amplitude, wavelength } => {
                let rate = std::f64::consts::TAU * SPEED / wavelength;
                let (sine, cosine) = (rate * self.time).sin_cos();
                (self.y, self.lateral_speed) = (amplitude * sine, amplitude * rate * cosine);
                self.lateral_speed / SPEED
            }
        };
        let (sine, cosine) = yaw.sin_cos();
        let (mut force, mut moment) = (0.0, -DRIVING_MOMENT);
        for ((element, output), side) in
            self.wheels.iter_mut().zip(&mut self.outputs).zip([Side::Left, Side::Right])
        {
            let mut input = input(side);
            let arm = input.wheel.position[1];
            (input.wheel.position[0], input.wheel.position[1]) =
                (-arm * sine, self.y + arm * cosine);
            input.wheel.yaw = yaw;
            input.wheel.velocity = [SPEED, self.lateral_speed, 0.0];
            input.wheel.pitch_rate = self.pitch_rate;
            element.accumulate(&input, output, worn)?;
            force += output.wheel.force[1];
            // About the axle.
            moment += output.wheel.moment[1] * cosine - output.wheel.moment[0] * sine;
        }
        self.pitch_rate += h * moment / AXLE_INERTIA;
        if let Guidance::Free { .. } = self.guidance {
            self.lateral_speed += h * force / MASS;
            self.y += h * self.lateral_speed;
        }
        (self.time, self.distance) = (self.time + h, self.distance + SPEED * h);
        Ok(())
    }
}

fn input(side: Side) -> Input {
    let mut input = Input { wheel_load: WHEEL_LOAD, ..Input::default() };
    input.wheel.position[1] = if side == Side::Left { -HALF_DISTANCE } else { HALF_DISTANCE };
    input
}
