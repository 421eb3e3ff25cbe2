//! Derivatives of the outputs of a wheelset by its inputs, from those of its wheels.

use super::rail_frame::RailFrame;
use super::track::TrackTurn;
use super::{Input, LEFT, Output, RIGHT, SIDES, Wheelset, guiding, on_side, total};
use crate::element::output::Wrench;
use crate::element::parameters::VerticalMode;
use crate::element::{self, Element};
use crate::error::ContactError;
use crate::kinematics::motion::WheelMotion;
use crate::math::dual::Dual;
use crate::math::numbers::Numbers;

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
        let wrenches = [RIGHT, LEFT]
            .map(|k| self.at.sides[k].wheel.each_with(&found.sides[k].wheel, &mut number));
        for (along, wrench) in self.markers.iter().zip(&wrenches) {
            total::add(&mut total, &motion, *along, wrench);
        }
        found.wheelset = total.each(&mut rate);
        found.guiding = guiding(&wrenches.map(|wrench| wrench.force)).each(&mut rate);
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
        let moving = self.input.each_with(direction, &mut number);
        let Input { wheelset: motion, track, .. } = &moving;
        let against_ground = track.against_ground(motion);
        for k in [RIGHT, LEFT] {
            let (along, own) = (self.markers[k], &moving.sides[k]);
            let mut marker = against_ground.along_axle(along);
            marker.pitch += own.own_pitch;
            marker.pitch_rate += own.own_pitch_rate;
            let height = marker.position[2];
            let frame = RailFrame::new(&own.line, track, motion.position[0], along);
            marker = frame.motion(&marker);
            let side = self.input.of_side(k, along);
            let within = element::Input {
                wheel: marker.each(&mut rate),
                ..direction.sides[k].with(direction.wheelset, direction.track_s)
            };
            sides(k, &side, &within, &mut rates[k]).map_err(|error| on_side(error, SIDES[k]))?;
            bring_out(&frame, [height, marker.position[2]], &self.at.sides[k], &mut rates[k]);
        }
        Ok(*motion)
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
        let inside = frame.wrench_within(&at.each(&mut Dual::from));
        let moving = inside.each_with(rates, &mut |at, rate| number(at.value, rate));
        frame.wrench(&moving).each(&mut rate)
    };
    rates.wheel = wrench(&at.wheel, &rates.wheel);
    for (rail, at) in rates.rails.iter_mut().zip(&at.rails) {
        *rail = wrench(at, rail);
    }
    let height = frame.height_within(within, [z, Dual::from(at.wheel_z)]).value;
    rates.wheel_z = frame.height(z, [within, number(height, rates.wheel_z)]).slopes[0];
    for (patch, at) in rates.patches.iter_mut().zip(&at.patches).filter(|(_, at)| at.rail > 0) {
        let inside = frame.place_within(at.position.map(Dual::from));
        let place = inside.each_with(&patch.position, &mut |at, rate| number(at.value, rate));
        patch.position = frame.place(place).map(rate);
    }
}

fn number(value: f64, rate: f64) -> Dual<1> {
    Dual { value, slopes: [rate] }
}

fn rate(number: Dual<1>) -> f64 {
    number.slopes[0]
}
