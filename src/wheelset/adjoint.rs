//! Derivatives backwards of the outputs of a wheelset, from those of its wheels.
//!
//! What a weighted sum of the outputs is by the outputs of a wheel are the weights of a sweep back
//! through that wheel. All the rest, from the inputs to the motion of the wheels and from their
//! forces to those of the wheelset, is a rigid body, whose rates forwards cost next to nothing: each
//! input has its own. Where the loads are given, a second sweep of each wheel says how its height
//! follows.

use super::derivatives::Place;
use super::guiding::{Guiding, guiding};
use super::rail_frame::RailFrame;
use super::{Input, LEFT, Output, RIGHT, SIDES, SideInput, Wheelset, on_side};
use crate::element;
use crate::element::output::Wrench;
use crate::element::subject::{BySubject, Sweep};
use crate::error::ContactError;
use crate::kinematics::motion::WheelMotion;
use crate::math::dual::Dual;

/// Forces on both wheels as directions.
type OfForces = Dual<6>;

impl Wheelset {
    /// The derivatives of Σ weight · output by inputs, and by the parameters of its wheels; see
    /// [`Element::adjoint_derivative`](element::Element::adjoint_derivative).
    ///
    /// # Errors
    /// The input at fault, by its name, or [`ContactError::NoDerivative`]; what was `found` holds a
    /// part then.
    pub(super) fn go_back(
        &mut self,
        input: &Input,
        weights: &Output,
        found: &mut BySubject<Self>,
    ) -> Result<(), ContactError> {
        let place = self.place(input)?;
        found.sweeps.resize_with(SIDES.len(), Default::default);
        for (k, sweep) in found.sweeps.iter_mut().enumerate() {
            let at = place.input.of_side(k, place.markers[k]);
            let own = place.weights_of_side(k, weights);
            let element = &mut self.elements[k];
            element
                .adjoint_derivative(&at, &own, &mut sweep.gradient)
                .map_err(|error| on_side(error, SIDES[k]))?;
            if place.is_loaded {
                let height = element::Output { wheel_z: 1.0, ..element::Output::default() };
                element
                    .adjoint_derivative(&at, &height, &mut sweep.height)
                    .map_err(|error| on_side(error, SIDES[k]))?;
            }
        }
        let BySubject { input: by_input, sweeps } = found;
        for n in 0.. {
            let mut direction = Input::at_rest();
            let Some(number) = nth(&mut direction, n) else { break };
            *number = 1.0;
            let direction = self.turned_direction(input, &direction);
            let slope = place.slope_along(&direction, weights, sweeps, [0.0; 2])?;
            if let Some(number) = nth(by_input, n) {
                *number = slope;
            }
        }
        let still = Input::at_rest();
        for k in [RIGHT, LEFT] {
            let mut lifted = [0.0; 2];
            if place.is_loaded {
                lifted[k] = 1.0;
                sweeps[k].share = place.slope_along(&still, weights, sweeps, lifted)?;
            } else {
                sweeps[k].share = 0.0;
            }
        }
        if let Some(rolling) = &self.rolling {
            let mut faster = Input::at_rest();
            faster.wheelset.pitch_rate = 1.0;
            let by_rate = place.slope_along(&faster, weights, sweeps, [0.0; 2])?;
            for (k, (sweep, rolling)) in sweeps.iter_mut().zip(rolling).enumerate() {
                let (speed, of_rail) =
                    (place.input.wheelset.velocity[0], place.input.sides[k].rails[0].pitch_rate);
                let by_radius = 0.5 * rolling.by_radius(speed, of_rail);
                sweep.gradient.parameters.nominal_radius += by_rate * by_radius;
            }
        }
        Ok(())
    }
}

impl Place {
    /// Weights of the outputs of a side in the frame of its rails; the height, which other numbers
    /// go with, has none.
    fn weights_of_side(&self, k: usize, weights: &Output) -> element::Output {
        let mut own = weights.sides[k];
        let arm = self.input.wheelset.axle() * self.markers[k];
        let [force, moment] = [weights.wheelset.force, weights.wheelset.moment];
        let by_moment = nalgebra::Vector3::from(moment).cross(&arm);
        let by_guiding = self.by_forces(&weights.guiding);
        for i in 0..3 {
            own.wheel.force[i] += force[i] + by_moment[i] + by_guiding[3 * k + i];
            own.wheel.moment[i] += moment[i];
        }
        own.wear_number += weights.wear_number;
        own.frictional_power += weights.frictional_power;
        own.wheel_z = 0.0;
        if let Some(frame) = self.input.rail_frame(k, self.markers[k]) {
            bring_in(&frame, &mut own);
        }
        own
    }

    /// Derivatives of a weighted sum of guiding forces by the forces on both wheels.
    fn by_forces(&self, weights: &Guiding) -> [f64; 6] {
        let forces = [RIGHT, LEFT].map(|k| {
            let force = self.at.sides[k].wheel.force;
            [0, 1, 2].map(|i| OfForces::variable(force[i], 3 * k + i))
        });
        let found = guiding(&forces);
        let mut sum = found.track_shifting_force * weights.track_shifting_force;
        for (side, weights) in found.sides.iter().zip(&weights.sides) {
            sum += side.guiding_force * weights.guiding_force;
            sum += side.vertical_force * weights.vertical_force;
            sum += side.quotient * weights.quotient;
        }
        sum.slopes
    }

    /// The derivative of the weighted sum along `direction`, with rates of the heights of the wheels
    /// on top.
    fn slope_along(
        &self,
        direction: &Input,
        weights: &Output,
        sweeps: &[Sweep],
        lifted: [f64; 2],
    ) -> Result<f64, ContactError> {
        let mut within_elements = [0.0; 2];
        let rates = self.rates(direction, &mut |k, _, within: &element::Input, found| {
            within_elements[k] = product(&sweeps[k].gradient.input, within);
            let height = if self.is_loaded {
                product(&sweeps[k].height.input, within) + lifted[k]
            } else {
                within.wheel.position[2]
            };
            *found = element::Output { wheel_z: height, ..element::Output::default() };
            Ok(())
        })?;
        Ok(within_elements.iter().sum::<f64>() + sum_of(&rates, weights))
    }
}

/// Σ of products of the numbers of both.
fn product(a: &element::Input, b: &element::Input) -> f64 {
    a.to_array().iter().zip(b.to_array()).map(|(a, b)| a * b).sum()
}

/// Σ weight · rate.
fn sum_of(rates: &Output, weights: &Output) -> f64 {
    let wrench = |a: &Wrench, b: &Wrench| -> f64 {
        let all = a.force.iter().zip(&b.force).chain(a.moment.iter().zip(&b.moment));
        all.map(|(a, b)| a * b).sum()
    };
    let sides = rates.sides.iter().zip(&weights.sides);
    let guiding = rates.guiding.sides.iter().zip(&weights.guiding.sides).map(|(a, b)| {
        a.guiding_force * b.guiding_force
            + a.vertical_force * b.vertical_force
            + a.quotient * b.quotient
    });
    wrench(&rates.wheelset, &weights.wheelset)
        + sides.map(|(rates, weights)| rates.sum_of(weights)).sum::<f64>()
        + guiding.sum::<f64>()
        + rates.guiding.track_shifting_force * weights.guiding.track_shifting_force
        + rates.wheelset_z * weights.wheelset_z
        + rates.roll * weights.roll
        + rates.wear_number * weights.wear_number
        + rates.frictional_power * weights.frictional_power
}

/// Brings weights from the frame of the track to that of the rails of a side.
fn bring_in(frame: &RailFrame<f64>, weights: &mut element::Output) {
    weights.wheel = frame.wrench_within(&weights.wheel);
    for rail in &mut weights.rails {
        *rail = frame.wrench_within(rail);
    }
    for patch in &mut weights.patches {
        let place = Wrench { force: patch.position, ..Wrench::default() };
        patch.position = frame.wrench_within(&place).force;
    }
}

/// The real number at place `n` of an input.
fn nth(input: &mut Input, n: usize) -> Option<&mut f64> {
    let Input { wheelset, sides, track_s, track } = input;
    let WheelMotion { position, roll, yaw, pitch, velocity, roll_rate, yaw_rate, pitch_rate } =
        wheelset;
    let centre = position.iter_mut().chain(velocity);
    let turns = [roll, yaw, pitch, roll_rate, yaw_rate, pitch_rate, track_s];
    let track = [&mut track.twist, &mut track.vertical_curvature, &mut track.curvature];
    centre.chain(turns).chain(track).chain(sides.iter_mut().flat_map(of_side)).nth(n)
}

/// The real numbers of a side.
fn of_side(side: &mut SideInput) -> impl Iterator<Item = &mut f64> {
    let SideInput {
        rails,
        wheel_load,
        friction,
        tread_friction,
        gauge_face_friction,
        line,
        own_pitch,
        own_pitch_rate,
    } = side;
    let rails = rails.iter_mut().flat_map(|rail| {
        let element::input::RailMotion { y, z, roll, vy, vz, roll_rate, pitch_rate } = rail;
        [y, z, roll, vy, vz, roll_rate, pitch_rate]
    });
    let friction = [wheel_load, friction, tread_friction, gauge_face_friction];
    let line = [&mut line.y, &mut line.z, &mut line.y_slope, &mut line.z_slope];
    rails.chain(friction).chain(line).chain([own_pitch, own_pitch_rate])
}
