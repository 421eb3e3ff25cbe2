//! Derivatives of the outputs of a wheelset by its inputs, from those of its wheels.

use super::guiding::Guiding;
use super::rail_frame::RailFrame;
use super::track::{RailLine, TrackTurn};
use super::{Input, LEFT, Output, RIGHT, SIDES, SideForces, Wheelset, guiding, on_side, total};
use crate::element::output::Wrench;
use crate::element::parameters::VerticalMode;
use crate::element::{self, Element};
use crate::error::ContactError;
use crate::kinematics::motion::WheelMotion;
use crate::math::dual::Dual;

/// Motion of a wheelset with its rates.
type Moving = WheelMotion<Dual<1>>;

/// Rates of the outputs of the element of a side, at its input in a direction.
pub(super) trait SideRates:
    FnMut(usize, &element::Input, &element::Input, &mut element::Output) -> Result<(), ContactError>
{
}

impl<F> SideRates for F where
    F: FnMut(
        usize,
        &element::Input,
        &element::Input,
        &mut element::Output,
    ) -> Result<(), ContactError>
{
}

impl Wheelset {
    /// The derivative of the outputs in the direction `direction`, all of whose numbers are rates
    /// of the inputs, as the rates of the outputs in `rates`; see
    /// [`Element::directional_derivative`]. Where the loads are given, height and roll follow them.
    ///
    /// # Errors
    /// The input at fault, by its name, or [`ContactError::NoDerivative`]; `rates` is then as
    /// before.
    pub fn directional_derivative(
        &mut self,
        input: &Input,
        direction: &Input,
        rates: &mut Output,
    ) -> Result<(), ContactError> {
        let place = self.place(input)?;
        let direction = self.turned_direction(input, direction);
        let elements = &mut self.elements;
        *rates = place.rates(&direction, &mut |k, at, within, found| {
            elements[k].directional_derivative(at, within, found)
        })?;
        Ok(())
    }

    /// Where the wheelset is at an `input`.
    ///
    /// # Errors
    /// The input at fault, by its name.
    pub(super) fn place(&mut self, input: &Input) -> Result<Place, ContactError> {
        let mut at = Output::default();
        let fallbacks = self.elements.each_ref().map(Element::fallbacks);
        let evaluated = self.evaluate(input, &mut at);
        for (element, count) in self.elements.iter_mut().zip(fallbacks) {
            element.set_fallbacks(count);
        }
        evaluated?;
        let mut input = self.on_its_rails(input);
        let is_loaded = self.vertical_mode == VerticalMode::Load;
        if is_loaded {
            (input.wheelset.position[2], input.wheelset.roll) = (at.wheelset_z, at.roll);
        }
        Ok(Place { markers: self.markers, is_loaded, input, at })
    }

    /// A `direction` of the inputs with the rates of what follows from them.
    pub(super) fn turned_direction(&self, input: &Input, direction: &Input) -> Input {
        let mut direction = self.turning(*direction);
        if let Some(irregularities) = &self.irregularities {
            irregularities.add_rates(input, &mut direction);
        }
        direction
    }
}

/// Where derivatives are taken.
#[derive(Clone, Debug)]
pub(super) struct Place {
    /// Place of each wheel marker along the axle [m].
    pub markers: [f64; 2],
    /// Whether height and roll follow the loads.
    pub is_loaded: bool,
    /// The input, on its rails and where it carries its loads.
    pub input: Input,
    /// Its outputs.
    pub at: Output,
}

impl Place {
    /// The rates of the outputs along `direction` from the rates of the elements, which `sides`
    /// gives; with given loads it is asked several times, last of all for those that count.
    ///
    /// # Errors
    /// Why `sides` has none, or why the roll has none.
    pub fn rates(
        &self,
        direction: &Input,
        sides: &mut impl SideRates,
    ) -> Result<Output, ContactError> {
        let (input, mut direction) = (&self.input, *direction);
        let mut found = Output::default();
        let mut motion = self.follow_loads(&mut direction, &mut found, sides)?;
        if self.is_loaded && input.track != TrackTurn::default() {
            // Velocities go with the height, as in the search for it.
            direction.wheelset.position[2] = found.wheelset_z;
            motion = self.follow_loads(&mut direction, &mut found, sides)?;
        }
        let mut total = Wrench::<Dual<1>>::default();
        let wrenches =
            [RIGHT, LEFT].map(|k| moving(&self.at.sides[k].wheel, &found.sides[k].wheel));
        for (along, wrench) in self.markers.iter().zip(&wrenches) {
            total::add(&mut total, &motion, *along, wrench);
        }
        found.wheelset = rates_of_wrench(&total);
        found.guiding = rates_of_guiding(&guiding(&wrenches.map(|wrench| wrench.force)));
        let [right, left] = &found.sides;
        found.wear_number = right.wear_number + left.wear_number;
        found.frictional_power = right.frictional_power + left.frictional_power;
        found.roll = direction.wheelset.roll;
        Ok(found)
    }

    /// Rates of both sides and of the height, at the roll rate that goes with the loads where these
    /// are given; returns the motion of the centre with its rates.
    fn follow_loads(
        &self,
        direction: &mut Input,
        found: &mut Output,
        sides: &mut impl SideRates,
    ) -> Result<Moving, ContactError> {
        if self.is_loaded {
            direction.wheelset.roll = self.rate_of_roll(direction, sides)?;
        }
        let motion = self.sides_along(direction, &mut found.sides, sides)?;
        found.wheelset_z = direction.wheelset.position[2];
        if self.is_loaded {
            let up = motion.axle().z.slopes[0];
            let height = |k: usize| found.sides[k].wheel_z - self.markers[k] * up;
            found.wheelset_z = 0.5 * (height(RIGHT) + height(LEFT));
        }
        Ok(motion)
    }

    /// Rates of both sides; returns the motion of the centre with its rates.
    fn sides_along(
        &self,
        direction: &Input,
        rates: &mut [element::Output; 2],
        sides: &mut impl SideRates,
    ) -> Result<Moving, ContactError> {
        let input = &self.input;
        let motion = with_rates(&input.wheelset, &direction.wheelset);
        let turn = turn_with_rates(&input.track, &direction.track);
        let against_ground = turn.against_ground(&motion);
        for k in [RIGHT, LEFT] {
            let along = self.markers[k];
            let (own, rate) = (&input.sides[k], &direction.sides[k]);
            let mut marker = against_ground.along_axle(along);
            marker.pitch += number(own.own_pitch, rate.own_pitch);
            marker.pitch_rate += number(own.own_pitch_rate, rate.own_pitch_rate);
            let height = marker.position[2];
            let line = line_with_rates(&own.line, &rate.line);
            let frame = RailFrame::new(&line, &turn, motion.position[0], along);
            marker = frame.motion(&marker);
            let side = input.of_side(k, along);
            let within = element::Input {
                wheel: rates_of(&marker),
                ..rate.with(direction.wheelset, direction.track_s)
            };
            sides(k, &side, &within, &mut rates[k]).map_err(|error| on_side(error, SIDES[k]))?;
            bring_out(&frame, [height, marker.position[2]], &self.at.sides[k], &mut rates[k]);
        }
        Ok(motion)
    }

    /// Rate of the roll at which the heights of both wheels go on to fit the axle.
    fn rate_of_roll(
        &self,
        direction: &Input,
        sides: &mut impl SideRates,
    ) -> Result<f64, ContactError> {
        let between = self.markers[RIGHT] - self.markers[LEFT];
        let mut misfit = |direction: &Input| {
            let mut rates = [element::Output::default(); 2];
            let motion = self.sides_along(direction, &mut rates, sides)?;
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

/// Brings the `rates` of the outputs of a side, which are `at` these in the frame of the track,
/// there from the frame of the rails.
fn bring_out(
    frame: &RailFrame<Dual<1>>,
    [z, within]: [Dual<1>; 2],
    at: &element::Output,
    rates: &mut element::Output,
) {
    let wrench = |at: &Wrench, rates: &Wrench| {
        let constant = moving(at, &Wrench::default());
        let inside = frame.wrench_within(&constant);
        let value = |x: Dual<1>| x.value;
        let inside = Wrench { force: inside.force.map(value), moment: inside.moment.map(value) };
        rates_of_wrench(&frame.wrench(&moving(&inside, rates)))
    };
    rates.wheel = wrench(&at.wheel, &rates.wheel);
    for (rail, at) in rates.rails.iter_mut().zip(&at.rails) {
        *rail = wrench(at, rail);
    }
    let height = frame.height_within(within, [z, Dual::from(at.wheel_z)]).value;
    rates.wheel_z = frame.height(z, [within, number(height, rates.wheel_z)]).slopes[0];
    for (patch, at) in rates.patches.iter_mut().zip(&at.patches).filter(|(_, at)| at.rail > 0) {
        let inside = frame.place_within(at.position.map(Dual::from)).map(|x| x.value);
        let place = [0, 1, 2].map(|i| number(inside[i], patch.position[i]));
        patch.position = frame.place(place).map(|x| x.slopes[0]);
    }
}

fn rates_of_wrench(wrench: &Wrench<Dual<1>>) -> Wrench {
    let rate = |x: Dual<1>| x.slopes[0];
    Wrench { force: wrench.force.map(rate), moment: wrench.moment.map(rate) }
}

fn number(value: f64, rate: f64) -> Dual<1> {
    Dual { value, slopes: [rate] }
}

fn turn_with_rates(at: &TrackTurn, rates: &TrackTurn) -> TrackTurn<Dual<1>> {
    TrackTurn {
        twist: number(at.twist, rates.twist),
        vertical_curvature: number(at.vertical_curvature, rates.vertical_curvature),
        curvature: number(at.curvature, rates.curvature),
    }
}

fn line_with_rates(at: &RailLine, rates: &RailLine) -> RailLine<Dual<1>> {
    RailLine {
        y: number(at.y, rates.y),
        z: number(at.z, rates.z),
        y_slope: number(at.y_slope, rates.y_slope),
        z_slope: number(at.z_slope, rates.z_slope),
    }
}

fn rates_of_guiding(guiding: &Guiding<Dual<1>>) -> Guiding {
    let rate = |x: Dual<1>| x.slopes[0];
    Guiding {
        sides: guiding.sides.map(|side| SideForces {
            guiding_force: rate(side.guiding_force),
            vertical_force: rate(side.vertical_force),
            quotient: rate(side.quotient),
        }),
        track_shifting_force: rate(guiding.track_shifting_force),
    }
}

/// A motion with rates.
fn with_rates(at: &WheelMotion, rates: &WheelMotion) -> Moving {
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
