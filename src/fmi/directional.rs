//! Directional derivatives of outputs by inputs, and at initialization by parameters (FMI 2.0,
//! 2.1.9; FMI 3.0, 2.2.11).

use super::differences::{DerivativeScratch, Wanted};
use super::error::FmiError;
use super::instance::Instance;
use super::interface::Interface;
use super::life_cycle::State;
use super::references::{is_real, variable, wrong_type};
use super::types::ValueReference;
use crate::element::subject::Subject;
use crate::error::ContactError;
use crate::variables::{Causality, Described, Kind, Unit, Value, ValuesOf, Variable};

/// Which unknowns a call asks for.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Asked {
    /// Outputs of an evaluation.
    pub outputs: bool,
    /// Stiffness, damping and longest steps.
    slopes: bool,
    /// Heights of first touch.
    pub nominal: bool,
}

impl<S: Described + Subject> Instance<S> {
    /// Puts Σ ∂ unknown/∂ known · `seed` into `sensitivity`, at the values as they are; nothing
    /// else changes.
    ///
    /// Exact where the element has exact derivatives, of outputs by inputs with real-time models
    /// and bodies without deviations along the track; central differences for all else. Nothing is
    /// allocated after initialization. After an error `sensitivity` is as before.
    pub fn directional_derivative(
        &mut self,
        unknowns: &[ValueReference],
        knowns: &[ValueReference],
        seed: &[f64],
        sensitivity: &mut [f64],
    ) -> Result<(), FmiError> {
        let asked = self.asked(unknowns)?;
        if self.remembers() && (asked.outputs || asked.slopes) {
            return Err(FmiError::from(ContactError::NoDerivative {
                name: Some("tangential.history = transient"),
                reason: "forces follow from steps, not from inputs alone; take differences of steps from a saved state",
            }));
        }
        let mut by_parameters = false;
        for (&reference, &seed) in knowns.iter().zip(seed) {
            let known = known(self.interface, S::UNIT, reference, self.state)?;
            if !seed.is_finite() {
                return Err(FmiError::BadSeed { name: known.name, seed });
            }
            by_parameters |= known.causality == Causality::Parameter;
        }
        if self.state == State::Initialization {
            self.prepare_element(asked.nominal)?;
        }
        // Out of the instance while it is worked with.
        let mut scratch = self.derivatives.take().unwrap_or_default();
        let found = self.put_together(
            (unknowns, asked),
            (knowns, seed, by_parameters),
            &mut scratch,
            sensitivity,
        );
        self.derivatives = Some(scratch);
        found
    }

    /// Sizes the memory for derivatives, so that the first of them allocates nothing.
    pub(super) fn reserve_derivatives(&mut self) {
        let mut scratch = self.derivatives.take().unwrap_or_default();
        scratch.beside.take_over(&self.values);
        self.derivatives = Some(scratch);
        for element in self.element.iter_mut().flat_map(Subject::elements_mut) {
            element.reserve_derivatives();
        }
    }

    fn put_together(
        &mut self,
        (unknowns, asked): (&[ValueReference], Asked),
        (knowns, seed, by_parameters): (&[ValueReference], &[f64], bool),
        scratch: &mut DerivativeScratch<S>,
        sensitivity: &mut [f64],
    ) -> Result<(), FmiError> {
        let DerivativeScratch { rates, beside } = scratch;
        let exact = asked.outputs && self.exact_rates(knowns, seed, rates)?;
        sensitivity.fill(0.0);
        if exact {
            for (out, &unknown) in sensitivity.iter_mut().zip(unknowns) {
                if S::UNIT.variables[unknown as usize].is_evaluated() {
                    *out = S::real(rates, unknown as usize).unwrap_or(0.0);
                }
            }
        }
        let by_differences = by_parameters || (asked.outputs && !exact);
        if !(by_differences || asked.slopes || asked.nominal) {
            return Ok(());
        }
        beside.take_over(&self.values);
        let Some(element) = &mut self.element else { return Ok(()) };
        for (&known, &seed) in knowns.iter().zip(seed).filter(|(_, seed)| **seed != 0.0) {
            let known = &S::UNIT.variables[known as usize];
            let is_parameter = known.causality == Causality::Parameter;
            let wanted = Wanted {
                slopes: asked.slopes,
                prepared: is_parameter || asked.nominal,
                outputs: (asked.outputs && (is_parameter || !exact)) || asked.slopes,
            };
            if !(wanted.outputs || wanted.prepared) {
                continue;
            }
            let width =
                beside.sample(known, &self.values, element, &self.profile_folders, wanted)?;
            for (out, &unknown) in sensitivity.iter_mut().zip(unknowns) {
                let is_plain = S::UNIT.variables[unknown as usize].is_evaluated();
                if width > 0.0 && !(is_plain && exact && !is_parameter) {
                    *out += seed * beside.difference(unknown) / width;
                }
            }
        }
        Ok(())
    }

    /// Puts the exact derivatives by the inputs among the knowns into `rates`; whether there are
    /// any.
    fn exact_rates(
        &mut self,
        knowns: &[ValueReference],
        seed: &[f64],
        rates: &mut ValuesOf<S>,
    ) -> Result<bool, FmiError> {
        let inputs = S::UNIT.variables.iter().filter(|v| v.causality == Causality::Input);
        for input in inputs.filter(|v| v.kind == Kind::Real) {
            rates.write(input, Value::Real(0.0));
        }
        for (&known, &seed) in knowns.iter().zip(seed) {
            let known = &S::UNIT.variables[known as usize];
            if known.causality == Causality::Input {
                rates.write(known, Value::Real(seed));
            }
        }
        let Some(element) = &mut self.element else { return Ok(false) };
        let (at, direction, out) = (&self.values.input, &rates.input, &mut rates.output);
        match element.directional_derivative_of_all(at, direction, out) {
            Ok(()) => Ok(true),
            Err(ContactError::NoDerivative { .. }) => Ok(false),
            Err(error) => Err(error.into()),
        }
    }

    /// Checks the unknowns and says of which kinds they are.
    pub(super) fn asked(&self, unknowns: &[ValueReference]) -> Result<Asked, FmiError> {
        let mut asked = Asked::default();
        for &reference in unknowns {
            let variable = variable(S::UNIT, reference)?;
            let refuse = |reason| {
                Err(FmiError::NoDerivative {
                    name: self.interface.name(variable),
                    role: "unknown",
                    reason,
                })
            };
            match variable.causality {
                _ if !is_real(variable.kind) => return Err(wrong_type(self.interface, variable)),
                Causality::Output if variable.on_request => {
                    asked.slopes |= self.values.coupling.monitor;
                }
                Causality::Output => asked.outputs = true,
                Causality::CalculatedParameter if self.state == State::Initialization => {
                    asked.nominal = true;
                }
                Causality::CalculatedParameter => {
                    return refuse("it is fixed after initialization");
                }
                Causality::Input | Causality::Parameter => return refuse("it is no output"),
            }
        }
        Ok(asked)
    }
}

/// The variable behind a reference, if derivatives are taken by it.
pub(super) fn known(
    interface: Interface,
    unit: &'static Unit,
    reference: ValueReference,
    state: State,
) -> Result<&'static Variable, FmiError> {
    let variable = variable(unit, reference)?;
    let refuse = |reason| {
        Err(FmiError::NoDerivative { name: interface.name(variable), role: "known", reason })
    };
    match variable.causality {
        Causality::Parameter if state != State::Initialization => {
            refuse("it is fixed after initialization")
        }
        Causality::Input | Causality::Parameter if is_real(variable.kind) => Ok(variable),
        Causality::Input | Causality::Parameter => Err(wrong_type(interface, variable)),
        _ => refuse("it is no input and no parameter"),
    }
}
