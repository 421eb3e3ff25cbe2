//! Two elements on one axle: motion of the centre of a wheelset in, forces on it and on both rails
//! out.
//!
//! ```
//! use wheelrail::wheelset::{Input, Output, Parameters, Wheelset};
//!
//! let mut input = Input::default();
//! let mut wheelset = Wheelset::new(&Parameters::default(), &input, &[])?;
//! input.wheelset.position[2] = wheelset.nominal_z() + 1e-4;
//! input.wheelset.velocity[0] = 20.0;
//! input.wheelset.pitch_rate = -20.0 / 0.46;
//! let mut output = Output::default();
//! wheelset.evaluate(&input, &mut output)?;
//! // Both rails push up; in the middle of the track they do not turn the wheelset.
//! assert!(output.wheelset.force[2] < -6e4);
//! assert!(output.wheelset.moment[0].abs() < 1e-6);
//! # Ok::<(), wheelrail::error::ContactError>(())
//! ```

mod adjoint;
mod both_wheels;
mod derivatives;
mod given_load;
mod guiding;
mod input;
mod irregularity;
mod output;
mod parameters;
mod rail_frame;
mod sides;
mod total;
mod track;

use std::path::PathBuf;

pub use guiding::{Guiding, SideForces};
pub use input::{Input, SideInput};
pub use output::Output;
pub use parameters::{Parameters, TAPE_CIRCLE};
pub use sides::{LEFT, RIGHT, SIDES, name_on_side};
pub use track::{MAX_SLOPE, MAX_TURN, RailLine, TrackTurn};

use crate::element::output::Wrench;
use crate::element::parameters::VerticalMode;
use crate::element::subject::{BySubject, Subject, forwarded};
use crate::element::work_pairs::{WorkPairs, work_pairs};
use crate::element::{self, Element, FreeRolling, check_duration};
use crate::error::ContactError;
use guiding::guiding;
use irregularity::Irregularities;
use sides::on_side;

/// A wheelset and the rails under it, ready to be evaluated.
///
/// A rigid body: its wheel markers follow the centre. Everything about frames, signs and models is
/// as for [`Element`].
#[derive(Clone, Debug)]
pub struct Wheelset {
    elements: [Element; 2],
    vertical_mode: VerticalMode,
    /// What turns the axle, if not its input.
    rolling: Option<[FreeRolling; 2]>,
    /// Place of each wheel marker along the axle [m].
    markers: [f64; 2],
    irregularities: Option<Irregularities>,
    nominal: NominalHeights,
}

/// Heights of first touch for a starting input.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct NominalHeights {
    /// Height of the centre at which the first of the wheels touches; the starting height where
    /// both stand beside the rails [m].
    pub wheelset_z: f64,
    /// Height of each wheel marker at which that wheel touches; its starting height where it stands
    /// beside the rails [m].
    pub wheel_z: [f64; 2],
}

impl Wheelset {
    /// Loads the profiles (a relative file name is looked for in `profile_folders`, in order),
    /// checks the parameters and sizes all scratch memory. `start` is the input from which the
    /// nominal heights follow.
    ///
    /// # Errors
    /// The parameter, profile or input at fault, by its name in `WheelSet.fmu`.
    pub fn new(
        parameters: &Parameters,
        start: &Input,
        profile_folders: &[PathBuf],
    ) -> Result<Self, ContactError> {
        start.check()?;
        let markers = parameters.markers();
        let irregularities = Irregularities::load(&parameters.irregularity_file, profile_folders)?;
        let mut start = *start;
        if let Some(irregularities) = &irregularities {
            irregularities.add(&mut start);
        }
        let [right, left] = parameters.checked()?;
        let mut nominal =
            NominalHeights { wheelset_z: f64::INFINITY, wheel_z: [start.wheelset.position[2]; 2] };
        let mut side = |k: usize, parameters: &element::Parameters| {
            let input = start.of_side(k, markers[k]);
            let mut element = Element::new(parameters, &input, profile_folders)?;
            let z = start.wheelset.along_axle(markers[k]).position[2];
            let frame = start.rail_frame(k, markers[k]);
            let height = |found: f64| match &frame {
                Some(frame) => frame.height(z, [input.wheel.position[2], found]),
                None => found,
            };
            nominal.wheel_z[k] = height(element.nominal_wheel_z());
            if let Some(touching) = element.touch(&input) {
                let lower = z - start.wheelset.position[2];
                nominal.wheelset_z = nominal.wheelset_z.min(height(touching) - lower);
            }
            Ok(element)
        };
        let elements = [
            side(RIGHT, &right).map_err(|e: ContactError| on_side(e, SIDES[RIGHT]))?,
            side(LEFT, &left).map_err(|e: ContactError| on_side(e, SIDES[LEFT]))?,
        ];
        if nominal.wheelset_z.is_infinite() {
            nominal.wheelset_z = start.wheelset.position[2];
        }
        let (vertical_mode, rolling) = (right.vertical_mode, parameters.rolling());
        Ok(Self { elements, vertical_mode, rolling, markers, irregularities, nominal })
    }

    /// Height of the centre at which the wheelset at its starting y, roll and yaw just touches; its
    /// starting height where it stands beside the rails [m].
    pub fn nominal_z(&self) -> f64 {
        self.nominal.wheelset_z
    }

    /// Heights of first touch of the wheelset and of each wheel.
    pub fn nominal_heights(&self) -> NominalHeights {
        self.nominal
    }

    /// The right wheel and the left one.
    pub fn elements(&self) -> &[Element; 2] {
        &self.elements
    }

    /// Evaluates the forces; allocates nothing.
    ///
    /// # Errors
    /// The input at fault, by its name; `output` is then as before.
    pub fn evaluate(&mut self, input: &Input, output: &mut Output) -> Result<(), ContactError> {
        self.both(input, output, Element::evaluate)
    }

    /// Evaluates the forces and wears off what a time of `duration` ≥ 0 [s] wears off, or makes a
    /// step of contacts that remember, as [`Element::advance`].
    ///
    /// # Errors
    /// The input at fault, by its name, or a duration that is negative or not finite; nothing is
    /// worn off then.
    pub fn advance(
        &mut self,
        input: &Input,
        output: &mut Output,
        duration: f64,
    ) -> Result<(), ContactError> {
        if !self.elements.iter().any(Element::remembers) {
            return self.both(input, output, |element, input, output| {
                element.advance(input, output, duration)
            });
        }
        check_duration(duration)?;
        // Trials of given loads are steps too.
        self.elements.iter_mut().for_each(|element| element.begin_step(duration));
        let done = self.both(input, output, Element::evaluate);
        self.elements.iter_mut().for_each(|element| element.end_step(done.is_ok()));
        done
    }

    /// Moves rails with a mass on over a step of `duration` ≥ 0 [s], during which the inputs go
    /// from `from` straight to `to`, as [`Element::move_rails`]; other rails stay.
    ///
    /// # Errors
    /// The input at fault, by its name, or a duration that is negative or not finite; the rails are
    /// then where they were.
    pub fn move_rails(
        &mut self,
        from: &Input,
        to: &Input,
        duration: f64,
    ) -> Result<(), ContactError> {
        from.check()?;
        to.check()?;
        let [from, to] = [from, to].map(|input| self.on_its_rails(input));
        let before = self.elements.each_ref().map(Element::track_state);
        for k in [RIGHT, LEFT] {
            let [from, to] = [&from, &to].map(|input| input.of_side(k, self.markers[k]));
            if let Err(error) = self.elements[k].move_rails(&from, &to, duration) {
                for (element, state) in self.elements.iter_mut().zip(before) {
                    element.set_track_state(state);
                }
                return Err(on_side(error, SIDES[k]));
            }
        }
        Ok(())
    }

    /// Both sides by `evaluate`, at the height and roll that carry the loads where these are given,
    /// and the sums.
    fn both(
        &mut self,
        input: &Input,
        output: &mut Output,
        evaluate: impl FnMut(
            &mut Element,
            &element::Input,
            &mut element::Output,
        ) -> Result<(), ContactError>,
    ) -> Result<(), ContactError> {
        input.check()?;
        let mut input = self.on_its_rails(input);
        let (mut is_missed, mut found) = (false, *output);
        if self.vertical_mode == VerticalMode::Load {
            (input, is_missed) = self.carry_loads(&input, &mut found)?;
        }
        self.sides(&input, &mut found, evaluate)?;
        *output = found;
        if is_missed {
            let right = &mut self.elements[RIGHT];
            right.set_fallbacks(right.fallbacks() + 1);
            self.report_fallbacks(output);
        }
        let mut total = Wrench::default();
        for (along, side) in self.markers.iter().zip(&output.sides) {
            total::add(&mut total, &input.wheelset, *along, &side.wheel);
        }
        output.guiding = guiding(&output.sides.map(|side| side.wheel.force));
        let [right, left] = &output.sides;
        output.patch_count = right.patch_count + left.patch_count;
        output.fallback_count = right.fallback_count.saturating_add(left.fallback_count);
        output.wear_number = right.wear_number + left.wear_number;
        output.frictional_power = right.frictional_power + left.frictional_power;
        (output.wheelset, output.wheelset_z) = (total, input.wheelset.position[2]);
        output.roll = input.wheelset.roll;
        Ok(())
    }

    /// The input, or rates of it, with the pitch rate of an axle that rolls where it does: the mean
    /// of both sides.
    fn turning(&self, mut input: Input) -> Input {
        if let Some(rolling) = &self.rolling {
            let speed = input.wheelset.velocity[0];
            let [right, left] = [RIGHT, LEFT]
                .map(|k| rolling[k].pitch_rate(speed, input.sides[k].rails[0].pitch_rate));
            input.wheelset.pitch_rate = 0.5 * (right + left);
        }
        input
    }

    /// The input with the irregularities of the rails at its station.
    fn on_its_rails(&self, input: &Input) -> Input {
        let mut input = self.turning(*input);
        if let Some(irregularities) = &self.irregularities {
            irregularities.add(&mut input);
        }
        input
    }

    /// Each side by itself.
    fn sides(
        &mut self,
        input: &Input,
        output: &mut Output,
        mut evaluate: impl FnMut(
            &mut Element,
            &element::Input,
            &mut element::Output,
        ) -> Result<(), ContactError>,
    ) -> Result<(), ContactError> {
        let sides = [RIGHT, LEFT].map(|k| input.of_side(k, self.markers[k]));
        // Numbers near the greatest one may leave their range on the way to the markers.
        for (k, side) in sides.iter().enumerate() {
            side.check().map_err(|e| on_side(e, SIDES[k]))?;
        }
        for (k, side) in sides.iter().enumerate() {
            evaluate(&mut self.elements[k], side, &mut output.sides[k])?;
            if let Some(frame) = input.rail_frame(k, self.markers[k]) {
                let z = input.wheelset.along_axle(self.markers[k]).position[2];
                total::bring_out(&frame, [z, side.wheel.position[2]], &mut output.sides[k]);
            }
        }
        Ok(())
    }
}

impl Subject for Wheelset {
    type Parameters = Parameters;
    type Input = Input;
    type Output = Output;
    type Nominal = NominalHeights;

    const PREFIXES: &'static [&'static str] = &["right.", "left."];

    forwarded!();

    fn nominal(&self) -> NominalHeights {
        self.nominal
    }

    fn adjoint_derivative_of_all(
        &mut self,
        input: &Input,
        weights: &Output,
        found: &mut BySubject<Self>,
    ) -> Result<(), ContactError> {
        self.go_back(input, weights, found)
    }

    fn elements(&self) -> &[Element] {
        &self.elements
    }

    fn elements_mut(&mut self) -> &mut [Element] {
        &mut self.elements
    }

    fn parameters_of_elements(parameters: &Parameters) -> &[element::Parameters] {
        &parameters.sides
    }

    fn fallback_count(output: &Output) -> i32 {
        output.fallback_count
    }

    fn load_and_carried(k: usize, input: &Input, output: &Output) -> [f64; 2] {
        [input.sides[k].wheel_load, output.sides[k].load_carried]
    }

    fn output_of_element(k: usize, output: &Output) -> &element::Output {
        &output.sides[k]
    }

    fn work_pairs(input: &Input, output: &Output) -> WorkPairs {
        let sides = input.sides.iter().zip(&output.sides);
        let rails = sides.flat_map(|(input, output)| input.rails.iter().zip(&output.rails));
        work_pairs((&input.track.against_ground(&input.wheelset), &output.wheelset), rails)
    }

    fn input_of_element(&self, k: usize, input: &Input, output: &Output) -> element::Input {
        let mut found = self.on_its_rails(input);
        found.wheelset.position[2] = output.wheelset_z;
        found.wheelset.roll = output.roll;
        found.of_side(k, self.markers[k])
    }

    fn lever(&self, k: usize, _: f64) -> f64 {
        self.markers[k].abs()
    }

    fn report_fallbacks(&self, output: &mut Output) {
        for (element, side) in self.elements.iter().zip(&mut output.sides) {
            side.fallback_count = element.fallback_count();
        }
        let [right, left] = output.sides.map(|side| side.fallback_count);
        output.fallback_count = right.saturating_add(left);
    }
}
