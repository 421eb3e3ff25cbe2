//! Outputs that are whole numbers, as they were at the last event of model exchange.

use super::types::ValueReference;
use crate::variables::{Causality, Described, Kind, Variable};

/// Outputs that are whole numbers, as they were at the last event, in the order of the variables.
#[derive(Clone, Debug, PartialEq)]
pub struct Held(Vec<(ValueReference, i32)>);

impl Held {
    /// Those of a unit, all zero.
    pub fn new<S: Described>() -> Self {
        Self(discrete::<S>().map(|v| (v.reference as ValueReference, 0)).collect())
    }

    /// The number that a variable had at the last event.
    pub fn value(&self, reference: ValueReference) -> Option<i32> {
        let found = self.0.binary_search_by_key(&reference, |(reference, _)| *reference);
        found.ok().map(|place| self.0[place].1)
    }

    /// The numbers, in the order of the variables.
    pub fn values(&self) -> impl Iterator<Item = i32> {
        self.0.iter().map(|(_, value)| *value)
    }

    /// Takes over numbers in the order of the variables; nothing is allocated.
    pub fn set(&mut self, values: impl Iterator<Item = i32>) {
        for ((_, held), value) in self.0.iter_mut().zip(values) {
            *held = value;
        }
    }
}

/// Outputs that are whole numbers.
pub(super) fn discrete<S: Described>() -> impl Iterator<Item = &'static Variable> {
    let outputs = S::UNIT.variables.iter().filter(|v| v.causality == Causality::Output);
    outputs.filter(|v| v.kind == Kind::Integer)
}
