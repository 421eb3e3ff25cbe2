//! Derivatives of the outputs of a wheelset by its inputs, from those of its wheels.

use super::{Input, LEFT, Output, RIGHT, SIDES, Wheelset, on_side, total};
use crate::element::output::Wrench;
use crate::element::parameters::VerticalMode;
use crate::element::{self, Element};
use crate::error::ContactError;
use crate::kinematics::motion::WheelMotion;
use crate::math::dual::Dual;

/// Motion of a wheelset with its rates.
type Moving = WheelMotion<Dual<1>>;

impl Wheelset {
    /// The derivative of the outputs in the direction `direction`, all of whose numbers are rates of the inputs, as the rates of the outputs
    /// in `rates`; see [`Element::directional_derivative`]. Where the loads are given, height and roll follow them.
    ///
    /// # Errors
    /// The input at fault, by its name, or [`ContactError::NoDerivative`]; `rates` is then as before.
    pub fn directional_derivative(
        &mut self,
        input: &Input,
        direction: &Input,
        rates: &mut Output,
    ) -> Result<(), ContactError> {
        let mut at = Output::default();
        let fallbacks = self.elements.each_ref().map(Element::fallbacks);
        let evaluated = self.evaluate(input, &mut at);
        for (element, count) in self.elements.iter_mut().zip(fallbacks) {
            element.set_fallbacks(count);
        }
        evaluated?;
        let (mut input, mut direction) = (*input, *direction);
        let loaded = self.vertical_mode == VerticalMode::Load;
        if loaded {
            (input.wheelset.position[2], input.wheelset.roll) = (at.wheelset_z, at.roll);
            direction.wheelset.roll = self.rate_of_roll(&input, &direction)?;
        }
        let mut found = Output::default();
        let motion = self.sides_along(&input, &direction, &mut found.sides)?;
        let mut total = Wrench::<Dual<1>>::default();
        for k in [RIGHT, LEFT] {
            let wrench = moving(&at.sides[k].wheel, &found.sides[k].wheel);
            total::add(&mut total, &motion, self.markers[k], &wrench);
        }
        let rate = |x: Dual<1>| x.slopes[0];
        found.wheelset = Wrench { force: total.force.map(rate), moment: total.moment.map(rate) };
        let [right, left] = &found.sides;
        found.wear_number = right.wear_number + left.wear_number;
        found.frictional_power = right.frictional_power + left.frictional_power;
        found.wheelset_z = direction.wheelset.position[2];
        if loaded {
            let up = motion.axle().z.slopes[0];
            let height = |k: usize| found.sides[k].wheel_z - self.markers[k] * up;
            found.wheelset_z = 0.5 * (height(RIGHT) + height(LEFT));
        }
        found.roll = direction.wheelset.roll;
        *rates = found;
        Ok(())
    }

    /// Rates of both sides; returns the motion of the centre with its rates.
    fn sides_along(
        &mut self,
        input: &Input,
        direction: &Input,
        rates: &mut [element::Output; 2],
    ) -> Result<Moving, ContactError> {
        let motion = with_rates(&input.wheelset, &direction.wheelset);
        for k in [RIGHT, LEFT] {
            let marker = motion.along_axle(self.markers[k]);
            let side = input.of_side(k, self.markers[k]);
            let own = element::Input { wheel: rates_of(&marker), ..direction.of_side(k, 0.0) };
            let found = self.elements[k].directional_derivative(&side, &own, &mut rates[k]);
            found.map_err(|error| on_side(error, SIDES[k]))?;
        }
        Ok(motion)
    }

    /// Rate of the roll at which the heights of both wheels go on to fit the axle.
    fn rate_of_roll(&mut self, input: &Input, direction: &Input) -> Result<f64, ContactError> {
        let between = self.markers[RIGHT] - self.markers[LEFT];
        let mut misfit = |direction: &Input| {
            let mut rates = [element::Output::default(); 2];
            let motion = self.sides_along(input, direction, &mut rates)?;
            let apart = rates[RIGHT].wheel_z - rates[LEFT].wheel_z;
            Ok::<f64, ContactError>(apart - between * motion.axle().z.slopes[0])
        };
        let mut own = *direction;
        own.wheelset.roll = 0.0;
        let along = misfit(&own)?;
        own.wheelset.roll = 1.0;
        let by_roll = misfit(&own)? - along;
        let rate = -along / by_roll;
        if rate.is_finite() {
            return Ok(rate);
        }
        Err(ContactError::NoDerivative { name: None, reason: "the roll of the axle has a kink" })
    }
}

/// A motion with rates.
fn with_rates(at: &WheelMotion, rates: &WheelMotion) -> Moving {
    let number = |value: f64, rate: f64| Dual { value, slopes: [rate] };
    let vector = |value: [f64; 3], rate: [f64; 3]| [0, 1, 2].map(|i| number(value[i], rate[i]));
    Moving {
        position: vector(at.position, rates.position),
        roll: number(at.roll, rates.roll),
        yaw: number(at.yaw, rates.yaw),
        pitch: number(at.pitch, rates.pitch),
        velocity: vector(at.velocity, rates.velocity),
        roll_rate: number(at.roll_rate, rates.roll_rate),
        yaw_rate: number(at.yaw_rate, rates.yaw_rate),
        pitch_rate: number(at.pitch_rate, rates.pitch_rate),
    }
}

/// The rates of a motion.
fn rates_of(motion: &Moving) -> WheelMotion {
    let rate = |x: Dual<1>| x.slopes[0];
    WheelMotion {
        position: motion.position.map(rate),
        roll: rate(motion.roll),
        yaw: rate(motion.yaw),
        pitch: rate(motion.pitch),
        velocity: motion.velocity.map(rate),
        roll_rate: rate(motion.roll_rate),
        yaw_rate: rate(motion.yaw_rate),
        pitch_rate: rate(motion.pitch_rate),
    }
}

/// A force and moment with rates.
fn moving(at: &Wrench, rates: &Wrench) -> Wrench<Dual<1>> {
    let with = |value: &[f64; 3], rate: &[f64; 3]| {
        [0, 1, 2].map(|i| Dual { value: value[i], slopes: [rate[i]] })
    };
    Wrench { force: with(&at.force, &rates.force), moment: with(&at.moment, &rates.moment) }
}
