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
use super::{Input, LEFT, Output, RIGHT, SIDES, Wheelset, on_side};
use crate::element;
use crate::element::output::Wrench;
use crate::element::subject::{BySubject, Sweep};
use crate::error::ContactError;
use crate::math::dual::Dual;
use crate::math::numbers::Numbers;

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
        let still = Input::at_rest();
        let mut count = 0;
        still.each(&mut |_| count += 1);
        for n in 0..count {
            let direction = self.turned_direction(input, &with_nth(&still, n, 1.0));
            let slope = place.slope_along(&direction, weights, sweeps, [0.0; 2])?;
            *by_input = with_nth(by_input, n, slope);
        }
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
        let mut sum = OfForces::from(0.0);
        found.each_with(weights, &mut |force, weight| sum += force * weight);
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
        Ok(within_elements.iter().sum::<f64>() + product(&rates, weights))
    }
}

/// Σ of products of the numbers of both.
fn product<A: Numbers<f64, Of<f64> = A>>(a: &A, b: &A) -> f64 {
    let mut sum = 0.0;
    a.each_with(b, &mut |a, b: f64| sum += a * b);
    sum
}

/// The `input` with a `value` for its number at place `n`.
fn with_nth(input: &Input, n: usize, value: f64) -> Input {
    let mut places = 0..;
    input.each(&mut |old| if places.next() == Some(n) { value } else { old })
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
