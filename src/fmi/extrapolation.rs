//! Inputs that go on with their time derivatives over the next step.

use super::error::FmiError;
use super::references::variable;
use super::types::ValueReference;
use crate::variables::{Causality, Described, Kind, Unit, Value, ValuesOf, check};

/// Highest derivative that is taken.
pub const ORDERS: usize = 3;

/// Time derivatives of inputs at the beginning of the next step, in the order in which they were
/// first set.
///
/// ```text
/// u(t + h) = u + h d1 + h²/2 d2 + h³/6 d3
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Extrapolation(Vec<(ValueReference, [f64; ORDERS])>);

impl Extrapolation {
    /// None, with room for all inputs of a unit.
    pub fn new(unit: &Unit) -> Self {
        let inputs = unit.variables.iter().filter(|v| v.causality == Causality::Input);
        Self(Vec::with_capacity(inputs.count()))
    }

    /// The derivatives that are set.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &(ValueReference, [f64; ORDERS])> {
        self.0.iter()
    }

    /// Forgets all.
    pub fn clear(&mut self) {
        self.0.clear();
    }

    /// Takes over those of another one; nothing is allocated.
    pub fn copy_from(&mut self, other: &Self) {
        self.0.clear();
        self.0.extend_from_slice(&other.0);
    }

    /// Sets derivatives of orders 1 to [`ORDERS`]; all or, if one is refused, none.
    pub fn set(
        &mut self,
        unit: &'static Unit,
        references: &[ValueReference],
        orders: &[i32],
        values: &[f64],
    ) -> Result<(), FmiError> {
        for ((&reference, &order), &value) in references.iter().zip(orders).zip(values) {
            let variable = variable(unit, reference)?;
            if variable.causality != Causality::Input || variable.kind != Kind::Real {
                return Err(FmiError::NoInput(variable.name));
            }
            if !(1..=ORDERS as i32).contains(&order) {
                let allowed = "an order from 1 to 3";
                return Err(FmiError::BadArgument { name: "order", value: order.into(), allowed });
            }
            if !value.is_finite() {
                return Err(FmiError::BadDerivative { name: variable.name, order, value });
            }
        }
        for ((&reference, &order), &value) in references.iter().zip(orders).zip(values) {
            let known = self.0.iter().position(|(r, _)| *r == reference);
            let place = known.unwrap_or_else(|| {
                self.0.push((reference, [0.0; ORDERS]));
                self.0.len() - 1
            });
            self.0[place].1[order as usize - 1] = value;
        }
        Ok(())
    }

    /// Moves the inputs on by a step [s]; refused, with nothing changed, where one leaves its
    /// range. Whether any moved.
    pub fn apply<S: Described>(
        &self,
        step: f64,
        values: &mut ValuesOf<S>,
    ) -> Result<bool, FmiError> {
        if self.0.is_empty() {
            return Ok(false);
        }
        let before = values.input;
        for &(reference, [first, second, third]) in &self.0 {
            let variable = &S::UNIT.variables[reference as usize];
            let Value::Real(value) = values.get(variable) else { continue };
            let value = value + step * (first + 0.5 * step * (second + step * third / 3.0));
            if let Err(refusal) = check(variable, Value::Real(value)) {
                values.input = before;
                return Err(refusal.into());
            }
            values.write(variable, Value::Real(value));
        }
        Ok(values.input != before)
    }
}
