//! What wheel and wheelset do each in its own way.

use wheelrail::element::input::{INPUT_NAMES, Input};
use wheelrail::element::subject::Subject;
use wheelrail::element::{Element, Output};
use wheelrail::error::ContactError;
use wheelrail::variables::{Described, ValuesOf};
use wheelrail::wheelset::{self, Wheelset};

/// A subject that arrays are evaluated for.
pub trait InBulk:
    Described<
        Input: Send + Sync,
        Output: Send + Sync,
        Parameters: Send + Sync,
        Nominal: Send + Sync,
    > + Send
    + Sync
{
    /// All inputs zero: no rates.
    fn no_rates() -> Self::Input;

    /// Derivatives by the inputs `by`, FMI references, as rates of the outputs in that order.
    ///
    /// # Errors
    /// The input at fault, or why there is none.
    fn derivatives(
        &mut self,
        input: &Self::Input,
        by: &[usize],
        rates: &mut Vec<Self::Output>,
    ) -> Result<(), ContactError>;

    /// Whether an input is one that is evaluated.
    ///
    /// # Errors
    /// The input at fault.
    fn check(input: &Self::Input) -> Result<(), ContactError>;

    /// Height of the marker or the centre at which the first wheel touches; NaN beside the rails
    /// [m].
    ///
    /// # Errors
    /// The input at fault.
    fn touching_height(&mut self, input: &Self::Input) -> Result<f64, ContactError>;

    /// Starting height of first touch [m].
    fn nominal_z(&self) -> f64;
}

/// The rates in the directions of the inputs `by`, one after the other.
fn one_by_one<S: InBulk>(
    subject: &mut S,
    input: &S::Input,
    by: &[usize],
    rates: &mut Vec<S::Output>,
) -> Result<(), ContactError> {
    rates.resize(by.len(), S::Output::default());
    for (reference, rates) in by.iter().zip(rates) {
        let mut direction = ValuesOf::<S> { input: S::no_rates(), ..ValuesOf::default() };
        put(&mut direction, *reference, 1.0);
        subject.directional_derivative_of_all(input, &direction.input, rates)?;
    }
    Ok(())
}

/// Sets a real input that is checked where it is used.
pub fn put<S: Described>(values: &mut ValuesOf<S>, reference: usize, value: f64) {
    match S::real_slot(values, reference) {
        Some(slot) => *slot = value,
        None => S::set_real(values, reference, value),
    }
}

/// Directions that cost as much one by one as all together.
const FEW: usize = 2;

impl InBulk for Element {
    fn no_rates() -> Input {
        Input::at_rest()
    }

    fn derivatives(
        &mut self,
        input: &Input,
        by: &[usize],
        rates: &mut Vec<Output>,
    ) -> Result<(), ContactError> {
        if by.len() <= FEW {
            return one_by_one(self, input, by, rates);
        }
        let mut columns = Vec::with_capacity(INPUT_NAMES.len());
        self.jacobian(input, &mut columns)?;
        let name = |reference: usize| Self::UNIT.variables[reference].name;
        let place = |reference| INPUT_NAMES.iter().position(|n| *n == name(reference));
        rates.clear();
        rates.extend(by.iter().map(|r| place(*r).map_or_else(Output::default, |k| columns[k])));
        Ok(())
    }

    fn check(input: &Input) -> Result<(), ContactError> {
        input.check()
    }

    fn touching_height(&mut self, input: &Input) -> Result<f64, ContactError> {
        Self::check(input)?;
        Ok(self.touch(input).unwrap_or(f64::NAN))
    }

    fn nominal_z(&self) -> f64 {
        self.nominal_wheel_z()
    }
}

impl InBulk for Wheelset {
    fn no_rates() -> wheelset::Input {
        wheelset::Input::at_rest()
    }

    fn derivatives(
        &mut self,
        input: &wheelset::Input,
        by: &[usize],
        rates: &mut Vec<wheelset::Output>,
    ) -> Result<(), ContactError> {
        one_by_one(self, input, by, rates)
    }

    fn check(input: &wheelset::Input) -> Result<(), ContactError> {
        input.check()
    }

    fn touching_height(&mut self, input: &wheelset::Input) -> Result<f64, ContactError> {
        Self::check(input)?;
        let z = input.wheelset.position[2];
        let mut at = wheelset::Output::default();
        (at.wheelset_z, at.roll) = (z, input.wheelset.roll);
        let sides = [0, 1].map(|k| self.input_of_element(k, input, &at));
        let heights = sides.iter().zip(self.elements_mut()).filter_map(|(side, element)| {
            Some(element.touch(side)? - (side.wheel.position[2] - z))
        });
        Ok(heights.reduce(f64::min).unwrap_or(f64::NAN))
    }

    fn nominal_z(&self) -> f64 {
        Wheelset::nominal_z(self)
    }
}
