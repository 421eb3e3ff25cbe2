//! A wheelset that runs freely, without suspension, on two contact elements with given wheel load.
//!
//! Its degrees of freedom are lateral, yaw and pitch; height and roll follow at each instant from
//! the heights at which the rails carry the load of each wheel (their velocities are left out of
//! the creepages). It is light on stiff creep forces: a Rosenbrock method of second order (Verwer,
//! ROS2) with the derivatives by the velocities takes steps of any length.

use std::error::Error;

use nalgebra::{SMatrix, SVector};
use wheelrail::element::parameters::{CreepageModel, Side, VerticalMode};
use wheelrail::element::{Element, Input, Output, Parameters};

pub const MASS: f64 = 10.0;
pub const YAW_INERTIA: f64 = 5.0;
pub const AXLE_INERTIA: f64 = 1.0;
pub const WHEEL_LOAD: f64 = 15e3;
pub const SPEED: f64 = 15.0;
const HALF_DISTANCE: f64 = 0.75;

/// y, yaw, lateral velocity, yaw rate, pitch rate.
pub type State = SVector<f64, 5>;
type Jacobian = SMatrix<f64, 5, 5>;

pub struct FreeWheelset {
    wheels: [Element; 2],
    /// Pure rolling sideways, v_y = V tan(yaw), in place of lateral creep forces.
    guided: bool,
    roll: f64,
    /// Roll that the heights found last would give [rad].
    next_roll: f64,
    /// Lateral position of both rails [m].
    pub rail_y: f64,
    /// Power turned into heat [W].
    pub power: f64,
    /// Rolling radius of the right wheel's heaviest patch [m].
    rolling_radius: f64,
}

impl FreeWheelset {
    pub fn new(pair: &Parameters, creepage_model: CreepageModel) -> Result<Self, Box<dyn Error>> {
        let wheel = |side| {
            let vertical_mode = VerticalMode::Load;
            let parameters = Parameters { side, creepage_model, vertical_mode, ..pair.clone() };
            Element::new(&parameters, &input(side), &[])
        };
        Ok(Self {
            wheels: [wheel(Side::Right)?, wheel(Side::Left)?],
            guided: creepage_model == CreepageModel::Kinematic,
            roll: 0.0,
            next_roll: 0.0,
            rail_y: 0.0,
            power: 0.0,
            rolling_radius: 0.0,
        })
    }

    /// Free rolling in the middle of the track.
    pub fn start(&mut self) -> Result<State, Box<dyn Error>> {
        let mut state = State::new(0.0, 0.0, 0.0, 0.0, -SPEED / 0.46);
        self.rate(&state)?;
        // Nearly without slip: from full sliding, where forces have no slope, steps would go to and
        // fro over the rolling speed.
        state[4] = -SPEED / self.rolling_radius;
        for _ in 0..200 {
            self.advance(&mut state, 1e-3)?;
            state.fixed_rows_mut::<4>(0).fill(0.0);
        }
        Ok(state)
    }

    /// One step of `h` seconds.
    pub fn advance(&mut self, state: &mut State, h: f64) -> Result<(), Box<dyn Error>> {
        let gamma = 1.0 - 0.5f64.sqrt();
        let rate = self.rate(state)?;
        let (roll, power) = (self.next_roll, self.power);
        let mut jacobian = Jacobian::zeros();
        for (k, difference) in [(2, 1e-6), (3, 1e-6), (4, 1e-5)] {
            let mut moved = *state;
            moved[k] += difference;
            jacobian.set_column(k, &((self.rate(&moved)? - rate) / difference));
        }
        let matrix = (Jacobian::identity() - jacobian * (gamma * h)).lu();
        let solve = |right: State| matrix.solve(&right).ok_or("a singular step");
        let first = solve(rate)?;
        let second = solve(self.rate(&(*state + first * h))? - first * 2.0)?;
        *state += first * (1.5 * h) + second * (0.5 * h);
        (self.roll, self.power) = (roll, power);
        Ok(())
    }

    fn rate(&mut self, state: &State) -> Result<State, Box<dyn Error>> {
        let [y, yaw, vy, yaw_rate, pitch_rate] = (*state).into();
        let vy = if self.guided { SPEED * yaw.tan() } else { vy };
        let (sine, cosine) = yaw.sin_cos();
        let mut rate = State::new(vy, yaw_rate, 0.0, 0.0, 0.0);
        (self.power, self.next_roll) = (0.0, 0.0);
        for (element, side) in self.wheels.iter_mut().zip([Side::Right, Side::Left]) {
            let mut input = input(side);
            let arm = input.wheel.position[1];
            (input.wheel.position[0], input.wheel.position[1]) = (-arm * sine, y + arm * cosine);
            (input.wheel.roll, input.wheel.yaw) = (self.roll, yaw);
            input.wheel.velocity =
                [SPEED - yaw_rate * arm * cosine, vy - yaw_rate * arm * sine, 0.0];
            (input.wheel.yaw_rate, input.wheel.pitch_rate) = (yaw_rate, pitch_rate);
            input.rails[0].y = self.rail_y;
            let mut output = Output::default();
            element.evaluate(&input, &mut output)?;
            if side == Side::Right {
                self.rolling_radius = output.patches[0].rolling_radius;
            }
            let [fx, fy, _] = output.wheel.force;
            let [_, my, mz] = output.wheel.moment;
            rate[2] += if self.guided { 0.0 } else { fy / MASS };
            rate[3] += (mz - arm * (cosine * fx + sine * fy)) / YAW_INERTIA;
            rate[4] += my / AXLE_INERTIA;
            self.power += output.frictional_power;
            self.next_roll += output.wheel_z * arm.signum() / (2.0 * HALF_DISTANCE);
        }
        Ok(rate)
    }
}

fn input(side: Side) -> Input {
    let mut input = Input { wheel_load: WHEEL_LOAD, ..Input::default() };
    input.wheel.position[1] = if side == Side::Left { -HALF_DISTANCE } else { HALF_DISTANCE };
    input
}
