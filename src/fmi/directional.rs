//! Directional derivatives of outputs by inputs (FMI 2.0, 2.1.9).

use super::access::{is_real, variable, wrong_type};
use super::error::FmiError;
use super::instance::{Instance, State};
use super::types::ValueReference;
use crate::element::subject::Subject;
use crate::variables::{Causality, Described, Kind, Unit, Value, ValuesOf, Variable};

impl<S: Described + Subject> Instance<S> {
    /// Puts Σ ∂ unknown/∂ known · `seed` into `sensitivity`, at the inputs as they are; nothing else changes. The first call allocates.
    ///
    /// # Errors
    /// The variable at fault by name, or why there are no derivatives; `sensitivity` is then as before.
    pub fn directional_derivative(
        &mut self,
        unknowns: &[ValueReference],
        knowns: &[ValueReference],
        seed: &[f64],
        sensitivity: &mut [f64],
    ) -> Result<(), FmiError> {
        for &reference in unknowns {
            real_with(reference, S::UNIT, Causality::Output, "unknown", "it is no output")?;
        }
        for (&reference, &seed) in knowns.iter().zip(seed) {
            let name = real_with(reference, S::UNIT, Causality::Input, "known", "it is no input")?;
            if !seed.is_finite() {
                return Err(FmiError::BadSeed { name: name.name, seed });
            }
        }
        if self.state == State::Initialization {
            self.prepare_element(false)?;
        }
        let rates = self.rates.get_or_insert_with(|| Box::new(ValuesOf::default()));
        let inputs = S::UNIT.variables.iter().filter(|v| v.causality == Causality::Input);
        for input in inputs.filter(|v| v.kind == Kind::Real) {
            rates.write(input, Value::Real(0.0));
        }
        for (&reference, &seed) in knowns.iter().zip(seed) {
            rates.write(&S::UNIT.variables[reference as usize], Value::Real(seed));
        }
        let Some(element) = &mut self.element else { return Ok(()) };
        element.directional_derivative_of_all(
            &self.values.input,
            &rates.input,
            &mut rates.output,
        )?;
        for (out, &reference) in sensitivity.iter_mut().zip(unknowns) {
            if let Value::Real(rate) = rates.get(&S::UNIT.variables[reference as usize]) {
                *out = rate;
            }
        }
        Ok(())
    }
}

/// The variable behind a reference, if it is real and of that causality.
fn real_with(
    reference: ValueReference,
    unit: &'static Unit,
    causality: Causality,
    role: &'static str,
    reason: &'static str,
) -> Result<&'static Variable, FmiError> {
    let variable = variable(unit, reference)?;
    if variable.on_request {
        let reason = "it is a derivative itself";
        return Err(FmiError::NoDerivative { name: variable.name, role, reason });
    }
    if variable.causality != causality {
        return Err(FmiError::NoDerivative { name: variable.name, role, reason });
    }
    if is_real(variable.kind) { Ok(variable) } else { Err(wrong_type(variable)) }
}
