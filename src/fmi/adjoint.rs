//! Adjoint derivatives: of a weighted sum of outputs by inputs and parameters (FMI 3.0, 2.2.11).

use super::adjoint_scratch::AdjointScratch;
use super::directional::known;
use super::error::FmiError;
use super::instance::Instance;
use super::life_cycle::State;
use super::references::variable;
use super::types::ValueReference;
use crate::element::subject::{BySubject, Subject};
use crate::error::ContactError;
use crate::variables::{Causality, Described, Kind, Value, ValuesOf, Variable};

impl<S: Described + Subject> Instance<S> {
    /// Puts Σ `seed` · ∂ unknown/∂ known into `sensitivity`, at the values as they are; nothing else
    /// changes.
    ///
    /// One sweep back for all knowns where the element has one: of outputs by inputs and by the
    /// parameters of [`ParameterSlopes`](crate::element::ParameterSlopes), which are knowns after
    /// initialization too. Known by known for all else, as
    /// [`directional_derivative`](Self::directional_derivative) has it. The first call allocates, later
    /// ones where an evaluation is longer than all before. After an error `sensitivity` is
    /// as before or holds a part.
    pub fn adjoint_derivative(
        &mut self,
        unknowns: &[ValueReference],
        knowns: &[ValueReference],
        seed: &[f64],
        sensitivity: &mut [f64],
    ) -> Result<(), FmiError> {
        let asked = self.asked(unknowns)?;
        for (&reference, &seed) in unknowns.iter().zip(seed) {
            if !seed.is_finite() {
                let name = self.interface.name(variable(S::UNIT, reference)?);
                return Err(FmiError::BadSeed { name, seed });
            }
        }
        if self.state == State::Initialization {
            self.prepare_element(asked.nominal)?;
        }
        // Out of the instance while it is worked with.
        let mut scratch = self.backwards.take().unwrap_or_default();
        let found =
            self.go_back((unknowns, asked.outputs), (knowns, seed), &mut scratch, sensitivity);
        self.backwards = Some(scratch);
        found
    }

    fn go_back(
        &mut self,
        (unknowns, outputs): (&[ValueReference], bool),
        (knowns, seed): (&[ValueReference], &[f64]),
        scratch: &mut AdjointScratch<S>,
        sensitivity: &mut [f64],
    ) -> Result<(), FmiError> {
        let exact = outputs && self.exact_back(unknowns, seed, scratch)?;
        let AdjointScratch { weights, found, others, column } = scratch;
        for (&reference, out) in knowns.iter().zip(sensitivity) {
            let by = variable(S::UNIT, reference)?;
            let swept = if exact { slope::<S>(weights, found, by) } else { None };
            if swept.is_none() || by.causality != Causality::Parameter {
                // A parameter that only the sweep knows of is admitted after initialization too.
                known(self.interface, S::UNIT, reference, self.state)?;
            }
            *out = swept.unwrap_or(0.0);
            others.clear();
            others.extend(unknowns.iter().filter(|&&u| swept.is_none() || !is_plain::<S>(u)));
            let is_fixed =
                by.causality == Causality::Parameter && self.state != State::Initialization;
            if others.is_empty() || is_fixed {
                continue;
            }
            column.clear();
            column.resize(others.len(), 0.0);
            self.directional_derivative(others, &[reference], &[1.0], column)?;
            let weighted = unknowns.iter().zip(seed);
            let left = weighted.filter(|(u, _)| swept.is_none() || !is_plain::<S>(**u));
            *out += column.iter().zip(left).map(|(slope, (_, seed))| slope * seed).sum::<f64>();
        }
        Ok(())
    }

    /// Sweeps back from the outputs among the unknowns; whether there is a sweep.
    fn exact_back(
        &mut self,
        unknowns: &[ValueReference],
        seed: &[f64],
        scratch: &mut AdjointScratch<S>,
    ) -> Result<bool, FmiError> {
        let AdjointScratch { weights, found, .. } = scratch;
        weights.output = S::Output::default();
        for (&unknown, &seed) in unknowns.iter().zip(seed).filter(|(u, _)| is_plain::<S>(**u)) {
            if let Some(weight) = S::output_slot(weights, unknown as usize) {
                *weight += seed;
            }
        }
        let Some(element) = &mut self.element else { return Ok(false) };
        let at = (&self.values.input, &weights.output);
        match element.adjoint_derivative_of_all(at.0, at.1, found) {
            Ok(()) => {
                weights.input = found.input;
                Ok(true)
            }
            Err(ContactError::NoDerivative { .. }) => Ok(false),
            Err(error) => Err(error.into()),
        }
    }
}

/// Whether an unknown is an output of every evaluation.
fn is_plain<S: Described>(unknown: ValueReference) -> bool {
    S::UNIT.variables[unknown as usize].is_evaluated()
}

/// The derivative by a known that a sweep has found.
fn slope<S: Described + Subject>(
    by_input: &ValuesOf<S>,
    found: &BySubject<S>,
    known: &Variable,
) -> Option<f64> {
    if known.kind != Kind::Real {
        return None;
    }
    match known.causality {
        Causality::Input => match by_input.get(known) {
            Value::Real(slope) => Some(slope),
            _ => None,
        },
        Causality::Parameter => found.parameter(known.name),
        _ => None,
    }
}
