//! Central differences of outputs over one input or parameter.

use std::path::PathBuf;

use super::coupling::slopes;
use super::types::ValueReference;
use crate::error::ContactError;
use crate::variables::{Described, Value, ValuesOf, Variable, admits};

/// Half of the distance over which a difference is taken, over the nominal size of what is varied:
/// 100 nm of a height of 0.1 mm leave 1e-6 of the curvature of a force, and a thousandfold of its
/// rounding.
const SHARE: f64 = 1e-3;
/// The least that half is of the value itself, so that it is not lost in rounding.
const MIN_SHARE: f64 = 1e-10;

/// What a difference is wanted of.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wanted {
    /// Of outputs.
    pub outputs: bool,
    /// Of stiffness, damping and longest steps.
    pub slopes: bool,
    /// Of what follows from parameters: an element of its own on each side.
    pub prepared: bool,
}

/// The values on both sides of those that are set.
#[derive(Clone, Debug)]
pub(super) struct Beside<S: Described> {
    low: ValuesOf<S>,
    high: ValuesOf<S>,
}

impl<S: Described> Default for Beside<S> {
    fn default() -> Self {
        Self { low: ValuesOf::default(), high: ValuesOf::default() }
    }
}

/// Memory for derivatives.
#[derive(Clone, Debug)]
pub struct DerivativeScratch<S: Described> {
    /// Seeds and sensitivities of exact derivatives, as inputs and outputs.
    pub(super) rates: ValuesOf<S>,
    /// Values beside those that are set.
    pub(super) beside: Beside<S>,
}

impl<S: Described> Default for DerivativeScratch<S> {
    fn default() -> Self {
        Self { rates: ValuesOf::default(), beside: Beside::default() }
    }
}

impl<S: Described> Beside<S> {
    /// Takes over parameters and all the rest; allocates where texts are longer than before.
    pub fn take_over(&mut self, values: &ValuesOf<S>) {
        for side in [&mut self.low, &mut self.high] {
            if side.parameters != values.parameters {
                side.parameters.clone_from(&values.parameters);
            }
            (side.input, side.output) = (values.input, values.output);
            (side.nominal, side.coupling) = (values.nominal, values.coupling);
        }
    }

    /// Evaluates both sides of `known`, whose place they were taken over from; what is between
    /// them. At the end of its range, or where one side cannot be evaluated, the value itself is in
    /// its place. The counts of `element` stay.
    pub fn sample(
        &mut self,
        known: &Variable,
        values: &ValuesOf<S>,
        element: &mut S,
        folders: &[PathBuf],
        wanted: Wanted,
    ) -> Result<f64, ContactError> {
        let Value::Real(at) = values.get(known) else { return Ok(0.0) };
        let step = (SHARE * known.nominal).max(MIN_SHARE * at.abs());
        let mut places = [at; 2];
        for ((side, way), place) in
            [(&mut self.low, -step), (&mut self.high, step)].into_iter().zip(&mut places)
        {
            if admits(known, Value::Real(at + way)) {
                side.write(known, Value::Real(at + way));
                if side.evaluate(element, folders, wanted).is_ok() {
                    *place = at + way;
                    side.write(known, Value::Real(at));
                    continue;
                }
                side.write(known, Value::Real(at));
            }
            side.evaluate(element, folders, wanted)?;
        }
        Ok(places[1] - places[0])
    }

    /// How much greater an unknown is on the high side.
    pub fn difference(&self, unknown: ValueReference) -> f64 {
        let place = unknown as usize;
        let [low, high] = [&self.low, &self.high].map(|side| S::real(side, place).unwrap_or(0.0));
        high - low
    }
}

impl<S: Described> ValuesOf<S> {
    /// Brings what is wanted up to date, with `element` or one of these parameters.
    fn evaluate(
        &mut self,
        element: &mut S,
        folders: &[PathBuf],
        wanted: Wanted,
    ) -> Result<(), ContactError> {
        if wanted.prepared {
            let mut own = S::prepare(&self.parameters, &self.input, folders)?;
            self.nominal = own.nominal();
            return self.evaluate_with(&mut own, wanted);
        }
        let mut counts = [0; 2];
        for (count, one) in counts.iter_mut().zip(element.elements()) {
            *count = one.fallbacks();
        }
        let evaluated = self.evaluate_with(element, wanted);
        for (count, one) in counts.into_iter().zip(element.elements_mut()) {
            one.set_fallbacks(count);
        }
        evaluated
    }

    fn evaluate_with(&mut self, element: &mut S, wanted: Wanted) -> Result<(), ContactError> {
        if wanted.outputs {
            element.evaluate_all(&self.input, &mut self.output)?;
        }
        if wanted.slopes {
            slopes(element, &self.input, &self.output, &mut self.coupling)?;
        }
        Ok(())
    }
}
