//! Derivatives of the outputs of a wheelset by its inputs.
//!
//! The markers move as dual numbers tell, each element has its own derivatives, and the sums about the centre are taken in dual numbers
//! again. Where loads are given, the roll of the rigid axle moves as the equation tells that has found it, the two heights as they follow.

use super::{Input, LEFT, Output, RIGHT, Wheelset, on_side, total};
use crate::element::input::WheelMotion;
use crate::element::output::Wrench;
use crate::element::parameters::VerticalMode;
use crate::element::{self, Element};
use crate::error::ContactError;
use crate::math::dual::Dual;

/// Changes of the equation for the roll below this share of the distance of the wheels have no root to follow [-].
const LEAST_SLOPE: f64 = 1e-6;

impl Wheelset {
    /// The derivative of the outputs in the direction `direction`, all of whose numbers are rates of the inputs, as the rates of the
    /// outputs in `rates`; as [`Element::directional_derivative`]. The first call allocates. The wheelset is left as it was.
    ///
    /// # Errors
    /// The input at fault, by its name, or [`ContactError::NoDerivative`]; `rates` is then as before or holds a part.
    pub fn directional_derivative(
        &mut self,
        input: &Input,
        direction: &Input,
        rates: &mut Output,
    ) -> Result<(), ContactError> {
        input.check()?;
        let (mut at, mut along) = (*input, *direction);
        if self.vertical_mode == VerticalMode::Load {
            let (carried, is_missed) = self.carry_loads(input)?;
            if is_missed {
                let reason = "the loads are not carried at this input";
                return Err(ContactError::NoDerivative { name: None, reason });
            }
            at = carried;
            self.follow_loads(&at, &mut along, rates)?;
        }
        self.rates_of_sides(&at, &along, &mut rates.sides)?;
        self.sum_rates(&at, &along, rates)
    }

    /// The rates of each side.
    fn rates_of_sides(
        &mut self,
        input: &Input,
        direction: &Input,
        rates: &mut [element::Output; 2],
    ) -> Result<(), ContactError> {
        for (k, side) in rates.iter_mut().enumerate() {
            let [at, along] = self.side_with_rates(k, input, direction);
            let name = |error| on_side(error, super::SIDES[k]);
            self.elements[k].directional_derivative(&at, &along, side).map_err(name)?;
        }
        Ok(())
    }

    /// Input of one side, and its rates.
    fn side_with_rates(&self, k: usize, input: &Input, direction: &Input) -> [element::Input; 2] {
        let marker = moving(&input.wheelset, &direction.wheelset).along_axle(self.markers[k]);
        let rate = |number: Dual<1>| number.slopes[0];
        let wheel = WheelMotion {
            position: marker.position.map(rate),
            roll: rate(marker.roll),
            yaw: rate(marker.yaw),
            pitch: rate(marker.pitch),
            velocity: marker.velocity.map(rate),
            roll_rate: rate(marker.roll_rate),
            yaw_rate: rate(marker.yaw_rate),
            pitch_rate: rate(marker.pitch_rate),
        };
        let rates = element::Input { wheel, ..direction.of_side(k, 0.0) };
        [input.of_side(k, self.markers[k]), rates]
    }

    /// Sums of the sides, whose rates are there.
    fn sum_rates(
        &mut self,
        input: &Input,
        direction: &Input,
        rates: &mut Output,
    ) -> Result<(), ContactError> {
        let motion = moving(&input.wheelset, &direction.wheelset);
        let counts = self.elements.each_ref().map(Element::fallbacks);
        let mut values = Output::default();
        let evaluated = self.sides(input, &mut values, Element::evaluate);
        for (element, count) in self.elements.iter_mut().zip(counts) {
            element.set_fallbacks(count);
        }
        evaluated?;
        let mut sum = Wrench::<Dual<1>>::default();
        for k in [RIGHT, LEFT] {
            let (value, rate) = (&values.sides[k].wheel, &rates.sides[k].wheel);
            let pair = |value: [f64; 3], rate: [f64; 3]| {
                [0, 1, 2].map(|i| Dual { value: value[i], slopes: [rate[i]] })
            };
            let wrench = Wrench {
                force: pair(value.force, rate.force),
                moment: pair(value.moment, rate.moment),
            };
            total::add(&mut sum, &motion, self.markers[k], &wrench);
        }
        rates.wheelset = Wrench {
            force: sum.force.map(|number| number.slopes[0]),
            moment: sum.moment.map(|number| number.slopes[0]),
        };
        let [right, left] = &rates.sides;
        rates.wear_number = right.wear_number + left.wear_number;
        rates.frictional_power = right.frictional_power + left.frictional_power;
        rates.wheelset_z = direction.wheelset.position[2];
        rates.roll = direction.wheelset.roll;
        Ok(())
    }

    /// Puts into `direction` how height and roll move so that the loads stay carried on a rigid axle.
    fn follow_loads(
        &mut self,
        input: &Input,
        direction: &mut Input,
        rates: &mut Output,
    ) -> Result<(), ContactError> {
        let motion = &mut direction.wheelset;
        (motion.roll, motion.position[2]) = (0.0, 0.0);
        let missing = self.missing_rate(input, direction, rates)?;
        let mut rolling = Input::at_rest();
        rolling.wheelset.roll = 1.0;
        let slope = self.missing_rate(input, &rolling, rates)?;
        if slope.abs() < LEAST_SLOPE * (self.markers[RIGHT] - self.markers[LEFT]) {
            let reason = "the roll does not follow the loads at this input";
            return Err(ContactError::NoDerivative { name: None, reason });
        }
        direction.wheelset.roll = -missing / slope;
        // The height of the centre is that of a marker less what the axle lies lower there.
        self.rates_of_sides(input, direction, &mut rates.sides)?;
        let lower = moving(&input.wheelset, &direction.wheelset).axle().z.slopes[0];
        let heights = [RIGHT, LEFT].map(|k| rates.sides[k].wheel_z - self.markers[k] * lower);
        direction.wheelset.position[2] = 0.5 * (heights[RIGHT] + heights[LEFT]);
        Ok(())
    }

    /// The rate of z_right - z_left - 2 b sin roll cos yaw.
    fn missing_rate(
        &mut self,
        input: &Input,
        direction: &Input,
        rates: &mut Output,
    ) -> Result<f64, ContactError> {
        self.rates_of_sides(input, direction, &mut rates.sides)?;
        let lower = moving(&input.wheelset, &direction.wheelset).axle().z.slopes[0];
        let between = self.markers[RIGHT] - self.markers[LEFT];
        Ok(rates.sides[RIGHT].wheel_z - rates.sides[LEFT].wheel_z - between * lower)
    }
}

/// A motion with its rates.
fn moving(at: &WheelMotion, rates: &WheelMotion) -> WheelMotion<Dual<1>> {
    let pair = |value: f64, rate: f64| Dual { value, slopes: [rate] };
    let triple = |value: [f64; 3], rate: [f64; 3]| [0, 1, 2].map(|i| pair(value[i], rate[i]));
    WheelMotion {
        position: triple(at.position, rates.position),
        roll: pair(at.roll, rates.roll),
        yaw: pair(at.yaw, rates.yaw),
        pitch: pair(at.pitch, rates.pitch),
        velocity: triple(at.velocity, rates.velocity),
        roll_rate: pair(at.roll_rate, rates.roll_rate),
        yaw_rate: pair(at.yaw_rate, rates.yaw_rate),
        pitch_rate: pair(at.pitch_rate, rates.pitch_rate),
    }
}
