//! The rate at which a wheel rolls freely, in the place of one that is given.

use super::input::Input;
use super::parameters::{Motion, Parameters};

/// A wheel that turns as its nominal rolling circle rolls on the first rail.
///
/// ```text
/// pitch_rate = -(v_x + ω_roller R_roller) / R_0
/// ```
///
/// On a straight rail R_roller is 0. The law is linear, so it holds for inputs and for their rates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FreeRolling {
    nominal_radius: f64,
    roller_radius: f64,
}

impl FreeRolling {
    /// The law where `parameters` ask for it.
    pub(crate) fn of(parameters: &Parameters) -> Option<Self> {
        (parameters.motion == Motion::Rolling).then_some(Self {
            nominal_radius: parameters.wheel.nominal_radius,
            roller_radius: parameters.rails[0].roller_radius,
        })
    }

    /// Pitch rate of the wheel [rad/s] from its velocity along the track [m/s] and the pitch rate
    /// of the first rail [rad/s].
    pub(crate) fn pitch_rate(&self, velocity: f64, of_rail: f64) -> f64 {
        -(velocity + of_rail * self.roller_radius) / self.nominal_radius
    }

    /// The `input`, or rates of it, with that pitch rate.
    pub(super) fn turning(&self, mut input: Input) -> Input {
        input.wheel.pitch_rate =
            self.pitch_rate(input.wheel.velocity[0], input.rails[0].pitch_rate);
        input
    }

    /// Derivatives by an input from those by what [`turning`](Self::turning) makes of it.
    pub(super) fn back_to_turning(&self, mut by_input: Input) -> Input {
        let by_velocity = -by_input.wheel.pitch_rate / self.nominal_radius;
        by_input.wheel.velocity[0] += by_velocity;
        by_input.rails[0].pitch_rate += by_velocity * self.roller_radius;
        by_input.wheel.pitch_rate = 0.0;
        by_input
    }

    /// Derivative of the pitch rate by the nominal radius.
    pub(crate) fn by_radius(&self, velocity: f64, of_rail: f64) -> f64 {
        -self.pitch_rate(velocity, of_rail) / self.nominal_radius
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::{Element, Output};
    use crate::error::ContactError;

    #[test]
    fn a_rolling_wheel_is_one_with_the_rate_of_its_nominal_circle() -> Result<(), ContactError> {
        let mut input = Input::default();
        let mut rolling = Element::new(
            &Parameters { motion: Motion::Rolling, ..Parameters::default() },
            &input,
            &[],
        )?;
        let mut given = Element::new(&Parameters::default(), &input, &[])?;
        input.wheel.position[2] = given.nominal_wheel_z() + 1e-4;
        input.wheel.velocity[0] = 20.0;
        let [mut by_rolling, mut by_rate] = [Output::default(); 2];
        rolling.evaluate(&input, &mut by_rolling)?;
        let mut turning = input;
        turning.wheel.pitch_rate = -20.0 / 0.46;
        given.evaluate(&turning, &mut by_rate)?;
        assert_eq!(by_rolling, by_rate);
        assert!(by_rolling.patches[0].slip_share < 0.5, "it slides");
        // The rate of the speed turns the wheel too.
        let mut faster = Input::at_rest();
        faster.wheel.velocity[0] = 1.0;
        let mut rates = [Output::default(); 2];
        rolling.directional_derivative(&input, &faster, &mut rates[0])?;
        faster.wheel.pitch_rate = -1.0 / 0.46;
        given.directional_derivative(&turning, &faster, &mut rates[1])?;
        assert_eq!(rates[0], rates[1]);
        Ok(())
    }
}
