//! A wheel or a wheelset with its variables and its place in the life cycle.

use std::ffi::{CString, c_char};
use std::path::{Path, PathBuf};

use super::error::FmiError;
use super::extrapolation::Extrapolation;
use super::logger::{Category, Logger};
use super::slots::Slots;
use super::snapshot::Snapshot;
use super::types::{Boolean, FALSE, Status, TRUE, ValueReference};
use crate::element::Element;
use crate::element::parameters::WearModel;
use crate::element::work_pairs::{WorkPairs, energy_residual};
use crate::error::ContactError;
use crate::io::save_profile;
use crate::variables::{
    Causality, Described, Kind, Unit, Value, ValuesOf, Variable, admits, check,
};
use crate::wheelset::Wheelset;

/// What an instance is made for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// The host integrates and asks for forces at any time.
    ModelExchange,
    /// The host steps.
    CoSimulation,
}

/// Where in its life an instance is (FMI 2.0, 3.2.3 and 4.2.4).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// Before initialization.
    Instantiated,
    /// Between entering and leaving initialization mode.
    Initialization,
    /// After initialization for co-simulation; steps are complete when `fmi2DoStep` returns.
    Stepping,
    /// At an event of model exchange, the first one after initialization.
    EventMode,
    /// Between the events of model exchange.
    ContinuousTime,
    /// After `fmi2Terminate`: outputs can still be read.
    Terminated,
    /// After a panic: can only be freed.
    Closed,
}

/// Time span announced by `fmi2SetupExperiment`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Experiment {
    /// Start time [s].
    pub start: f64,
    /// Stop time, if there is one [s].
    pub stop: Option<f64>,
}

/// What an `fmi2Component` stands for.
#[derive(Debug)]
pub enum AnyInstance {
    /// Of `WheelRail.fmu`.
    Wheel(Box<Instance<Element>>),
    /// Of `WheelSet.fmu`.
    Wheelset(Box<Instance<Wheelset>>),
}

/// Runs the same lines on an instance of any unit.
macro_rules! on_instance {
    ($any:expr, |$instance:ident| $body:expr) => {
        match $any {
            $crate::fmi::instance::AnyInstance::Wheel($instance) => $body,
            $crate::fmi::instance::AnyInstance::Wheelset($instance) => $body,
        }
    };
}
pub(super) use on_instance;

impl AnyInstance {
    /// An instance of `unit` with start values.
    pub fn new(unit: &Unit, purpose: Purpose, profile_folders: Vec<PathBuf>) -> Self {
        if unit.guid == Wheelset::UNIT.guid {
            Self::Wheelset(Box::new(Instance::new(purpose, profile_folders)))
        } else {
            Self::Wheel(Box::new(Instance::new(purpose, profile_folders)))
        }
    }

    /// Place in the life cycle.
    #[inline]
    pub fn state(&self) -> State {
        on_instance!(self, |instance| instance.state)
    }

    /// Moves to another place in the life cycle.
    pub fn put_into(&mut self, state: State) {
        on_instance!(self, |instance| instance.state = state);
    }
}

/// The beginning of the last step: its length [s], and the forces that a host held over it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LastStep {
    /// Length [s].
    pub duration: f64,
    /// Forces and velocities at its beginning.
    pub pairs: WorkPairs,
}

/// An instance of one unit.
#[derive(Debug)]
pub struct Instance<S: Described> {
    /// What it is made for.
    pub purpose: Purpose,
    /// Place in the life cycle.
    pub state: State,
    pub(super) values: ValuesOf<S>,
    pub(super) profile_folders: Vec<PathBuf>,
    pub(super) element: Option<S>,
    /// Parameters were set since the element was made from them.
    pub(super) parameters_changed: bool,
    /// The input for which the nominal height was found.
    pub(super) nominal_input: Option<S::Input>,
    /// Inputs were set, or the element made, since the outputs were evaluated.
    pub(super) outputs_stale: bool,
    pub(super) experiment: Option<Experiment>,
    pub(super) time: f64,
    /// Time derivatives of the inputs over the next step.
    pub(super) extrapolation: Extrapolation,
    /// The input for which stiffness and damping were found.
    pub(super) slopes_at: Option<S::Input>,
    /// Where the last step began, if energy is monitored.
    pub(super) last_step: Option<LastStep>,
    /// Seeds and sensitivities of the last directional derivative, as inputs and outputs.
    pub(super) rates: Option<Box<ValuesOf<S>>>,
    /// Texts handed out by the last `fmi2GetString`.
    handed_out: Vec<CString>,
    /// States handed out and not freed yet.
    pub snapshots: Slots<Snapshot<S>>,
}

impl<S: Described> Instance<S> {
    /// An instance with start values; profiles are looked for in the folders, in order.
    pub fn new(purpose: Purpose, profile_folders: Vec<PathBuf>) -> Self {
        Self {
            purpose,
            state: State::Instantiated,
            values: ValuesOf::default(),
            profile_folders,
            element: None,
            parameters_changed: true,
            nominal_input: None,
            outputs_stale: true,
            experiment: None,
            time: 0.0,
            extrapolation: Extrapolation::new(S::UNIT),
            slopes_at: None,
            last_step: None,
            rates: None,
            handed_out: Vec::new(),
            snapshots: Slots::new(),
        }
    }

    /// Back to what it was after instantiation; states handed out stay good.
    pub fn reset(&mut self) {
        let snapshots = std::mem::replace(&mut self.snapshots, Slots::new());
        *self = Self {
            snapshots,
            ..Self::new(self.purpose, std::mem::take(&mut self.profile_folders))
        };
    }

    /// Whether there is an element of the parameters as they are.
    pub(super) fn is_prepared(&self) -> bool {
        self.element.is_some() && !self.parameters_changed
    }

    /// Takes over the time span; `stop` if it is defined.
    pub fn setup_experiment(&mut self, start: f64, stop: Option<f64>) -> Result<(), FmiError> {
        if !start.is_finite() {
            return Err(bad_argument("startTime", start, "a finite number"));
        }
        if let Some(stop) = stop.filter(|stop| !(stop.is_finite() && *stop >= start)) {
            return Err(bad_argument("stopTime", stop, "a finite number not below startTime"));
        }
        self.experiment = Some(Experiment { start, stop });
        Ok(())
    }

    /// Enters initialization mode.
    pub fn enter_initialization(&mut self) -> Result<(), FmiError> {
        let experiment = self.experiment.ok_or(FmiError::WrongState {
            state: "while the start time is undefined",
            remedy: "call fmi2SetupExperiment first",
        })?;
        self.time = experiment.start;
        self.state = State::Initialization;
        Ok(())
    }

    /// Makes the element from the parameters; if one of them is at fault, the mode is not left.
    pub fn exit_initialization(&mut self) -> Result<(), FmiError> {
        self.prepare_element(true)?;
        self.state = match self.purpose {
            Purpose::ModelExchange => State::EventMode,
            Purpose::CoSimulation => State::Stepping,
        };
        Ok(())
    }

    /// Moves the time, and inputs with time derivatives; forces depend on the inputs alone.
    ///
    /// A host that counts in floating point may start its last step just before the stop time and end
    /// after it; a step that starts beyond it by more than a thousandth of the step is refused.
    pub fn step(&mut self, time: f64, step: f64, logger: &Logger) -> Result<Status, FmiError> {
        if !time.is_finite() {
            return Err(bad_argument("currentCommunicationPoint", time, "a finite number"));
        }
        if !(step.is_finite() && step >= 0.0) {
            return Err(bad_argument(
                "communicationStepSize",
                step,
                "a finite number, not negative",
            ));
        }
        if let Some(stop) = self.experiment.and_then(|e| e.stop)
            && time - stop > 1e-3 * step + 1e-9 * stop.abs().max(1.0)
        {
            return Err(FmiError::AfterStop { time, stop });
        }
        // Of the inputs as they were set, before derivatives carry them on.
        let start =
            if self.values.coupling.monitor { Some(self.work_pairs(logger)?) } else { None };
        self.outputs_stale |= self.extrapolation.apply(step, &mut self.values)?;
        self.extrapolation.clear();
        let status = match self.wear_model() {
            WearModel::Off => Status::Ok,
            _ => self.wear_off(step, logger)?,
        };
        self.time = time + step;
        Ok(start.map_or(status, |(watched, pairs)| {
            self.watch(step, &pairs);
            status.max(watched)
        }))
    }

    /// Forces and velocities of the inputs.
    fn work_pairs(&mut self, logger: &Logger) -> Result<(Status, WorkPairs), FmiError> {
        let status = if self.outputs_stale { self.evaluate(logger)? } else { Status::Ok };
        Ok((status, S::work_pairs(&self.values.input, &self.values.output)))
    }

    /// Takes over the energy residual of the step that ends where one of `duration` [s] begins with these `pairs`.
    fn watch(&mut self, duration: f64, pairs: &WorkPairs) {
        let residual = |last: &LastStep| energy_residual(&last.pairs, pairs, last.duration);
        self.values.coupling.energy_residual = self.last_step.as_ref().map_or(0.0, residual);
        self.last_step = Some(LastStep { duration, pairs: *pairs });
    }

    /// The wear law, which is the same for all elements.
    fn wear_model(&self) -> WearModel {
        let all = S::parameters_of_elements(&self.values.parameters);
        all.first().map_or(WearModel::Off, |parameters| parameters.wear.model)
    }

    /// Wears off what the contacts of the inputs wear off in a step, and evaluates the outputs with it.
    fn wear_off(&mut self, step: f64, logger: &Logger) -> Result<Status, FmiError> {
        let Some(element) = &mut self.element else { return Ok(Status::Ok) };
        let fallbacks = S::fallback_count(&self.values.output);
        element.advance_all(&self.values.input, &mut self.values.output, step)?;
        // On other profiles.
        self.slopes_at = None;
        self.outputs_stale = false;
        Ok(self.fallback_status(fallbacks, logger))
    }

    /// Ends the run: writes the worn profiles that the parameters ask for.
    pub fn terminate(&mut self) -> Result<(), FmiError> {
        if let (State::Stepping, Some(element)) = (self.state, &self.element) {
            let all = S::parameters_of_elements(&self.values.parameters);
            let sides = S::PREFIXES.iter().zip(all).zip(element.elements());
            for ((prefix, parameters), element) in sides {
                let worn_wheel =
                    ("wear.wheel.file", &parameters.wheel.worn_file, element.worn_wheel());
                let worn_rails = ["wear.rail[1].file", "wear.rail[2].file"]
                    .into_iter()
                    .enumerate()
                    .map(|(k, name)| (name, &parameters.rails[k].worn_file, element.worn_rail(k)));
                for (name, file, profile) in std::iter::once(worn_wheel).chain(worn_rails) {
                    if let (false, Some(profile)) = (file.is_empty(), profile) {
                        save_profile(&format!("{prefix}{name}"), Path::new(file), &profile)?;
                    }
                }
            }
        }
        self.state = State::Terminated;
        Ok(())
    }

    /// Sets time derivatives of inputs for the next step; all or, if one is refused, none.
    pub fn set_input_derivatives(
        &mut self,
        references: &[ValueReference],
        orders: &[i32],
        values: &[f64],
    ) -> Result<(), FmiError> {
        self.extrapolation.set(S::UNIT, references, orders, values)
    }

    /// Sets the time of model exchange.
    pub fn set_time(&mut self, time: f64) -> Result<(), FmiError> {
        if !time.is_finite() {
            return Err(bad_argument("time", time, "a finite number"));
        }
        self.time = time;
        Ok(())
    }

    /// End of the last step, or start time [s].
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Reads real variables.
    pub fn get_real(
        &mut self,
        references: &[ValueReference],
        out: &mut [f64],
        logger: &Logger,
    ) -> Result<Status, FmiError> {
        let status = self.prepare_to_read(references, is_real, logger)?;
        for (out, &reference) in out.iter_mut().zip(references) {
            if let Value::Real(value) = self.values.get(&S::UNIT.variables[reference as usize]) {
                *out = value;
            }
        }
        Ok(status)
    }

    /// Reads integer variables and enumerations.
    pub fn get_integer(
        &mut self,
        references: &[ValueReference],
        out: &mut [i32],
        logger: &Logger,
    ) -> Result<Status, FmiError> {
        let status = self.prepare_to_read(references, is_integer, logger)?;
        for (out, &reference) in out.iter_mut().zip(references) {
            if let Value::Integer(value) = self.values.get(&S::UNIT.variables[reference as usize]) {
                *out = value;
            }
        }
        Ok(status)
    }

    /// Reads boolean variables.
    pub fn get_boolean(
        &mut self,
        references: &[ValueReference],
        out: &mut [Boolean],
        logger: &Logger,
    ) -> Result<Status, FmiError> {
        let status = self.prepare_to_read(references, is_boolean, logger)?;
        for (out, &reference) in out.iter_mut().zip(references) {
            if let Value::Boolean(value) = self.values.get(&S::UNIT.variables[reference as usize]) {
                *out = if value { TRUE } else { FALSE };
            }
        }
        Ok(status)
    }

    /// Reads text variables; the pointers are good until the next call on this instance.
    pub fn get_text(
        &mut self,
        references: &[ValueReference],
        out: &mut [*const c_char],
        logger: &Logger,
    ) -> Result<Status, FmiError> {
        let status = self.prepare_to_read(references, is_text, logger)?;
        let texts =
            references.iter().map(|&r| match self.values.get(&S::UNIT.variables[r as usize]) {
                // A text that was set holds no null character.
                Value::Text(text) => CString::new(text).unwrap_or_default(),
                _ => CString::default(),
            });
        self.handed_out = texts.collect();
        for (out, text) in out.iter_mut().zip(&self.handed_out) {
            *out = text.as_ptr();
        }
        Ok(status)
    }

    /// Sets variables; all or, if one of the values is refused, none.
    pub fn set<'a>(
        &mut self,
        references: &[ValueReference],
        value: impl Fn(usize) -> Value<'a>,
    ) -> Result<Status, FmiError> {
        let fixed = !matches!(self.state, State::Instantiated | State::Initialization);
        for (i, &reference) in references.iter().enumerate() {
            let variable = S::UNIT.variables.get(reference as usize);
            let accepted = variable.is_some_and(|v| {
                admits(v, value(i)) && !(fixed && v.causality == Causality::Parameter)
            });
            if !accepted {
                return Err(refusal(S::UNIT, reference, value(i)));
            }
        }
        for (i, &reference) in references.iter().enumerate() {
            let variable = &S::UNIT.variables[reference as usize];
            // Setting the same value again costs no evaluation.
            if self.values.write(variable, value(i)) {
                self.outputs_stale = true;
                self.parameters_changed |= variable.causality == Causality::Parameter;
            }
        }
        Ok(Status::Ok)
    }

    /// Checks references and types, and brings up to date what they depend on.
    fn prepare_to_read(
        &mut self,
        references: &[ValueReference],
        belongs: fn(Kind) -> bool,
        logger: &Logger,
    ) -> Result<Status, FmiError> {
        let (mut outputs, mut nominal, mut requested) = (false, false, false);
        for &reference in references {
            let variable = variable(S::UNIT, reference)?;
            if !belongs(variable.kind) {
                return Err(wrong_type(variable));
            }
            outputs |= variable.causality == Causality::Output;
            requested |= variable.on_request;
            nominal |= variable.causality == Causality::CalculatedParameter;
        }
        if self.state == State::Initialization && (outputs || nominal) {
            self.prepare_element(nominal)?;
        }
        let status =
            if outputs && self.outputs_stale { self.evaluate(logger)? } else { Status::Ok };
        if requested && self.values.coupling.monitor {
            self.find_slopes()?;
        }
        Ok(status)
    }

    /// Brings stiffness and damping up to date, after the outputs.
    #[cold]
    fn find_slopes(&mut self) -> Result<(), FmiError> {
        let Some(subject) = &mut self.element else { return Ok(()) };
        let ValuesOf { input, output, coupling, .. } = &mut self.values;
        if self.slopes_at == Some(*input) {
            return Ok(());
        }
        for k in 0..S::PREFIXES.len() {
            let at = subject.input_of_element(k, input, output);
            let slopes = subject.elements_mut()[k].vertical_slopes(&at)?;
            (coupling.stiffness[k], coupling.damping[k]) = (slopes.stiffness, slopes.damping);
        }
        self.slopes_at = Some(*input);
        Ok(())
    }

    /// Makes the element if there is none of these parameters, or none of this input if the nominal
    /// height is wanted.
    pub(super) fn prepare_element(&mut self, nominal: bool) -> Result<(), FmiError> {
        let moved = nominal && self.nominal_input != Some(self.values.input);
        if !self.is_prepared() || moved {
            let wear_model = self.wear_model();
            if wear_model != WearModel::Off && self.purpose == Purpose::ModelExchange {
                return Err(FmiError::from(ContactError::BadText {
                    name: "wear.model".into(),
                    value: wear_model.name().into(),
                    allowed: "in model exchange off: a host that integrates by itself asks for forces at times that it \
                              may not go to; profiles wear in the steps of co-simulation"
                        .into(),
                }));
            }
            let (parameters, input) = (&self.values.parameters, &self.values.input);
            let element = S::prepare(parameters, input, &self.profile_folders)?;
            self.values.nominal = element.nominal();
            self.nominal_input = Some(self.values.input);
            self.element = Some(element);
            self.parameters_changed = false;
            self.outputs_stale = true;
            self.slopes_at = None;
        }
        Ok(())
    }

    fn evaluate(&mut self, logger: &Logger) -> Result<Status, FmiError> {
        let Some(element) = &mut self.element else { return Ok(Status::Ok) };
        let fallbacks = S::fallback_count(&self.values.output);
        element.evaluate_all(&self.values.input, &mut self.values.output)?;
        self.outputs_stale = false;
        Ok(self.fallback_status(fallbacks, logger))
    }

    /// A warning if there are more fallbacks than `before`.
    fn fallback_status(&self, before: i32, logger: &Logger) -> Status {
        let count = S::fallback_count(&self.values.output);
        if count == before {
            return Status::Ok;
        }
        if logger.takes(Category::Warning) {
            let message =
                format!("a solver fell back to a simpler model: fallback_count = {count}");
            logger.log(Status::Warning, Category::Warning, &message);
        }
        Status::Warning
    }
}

#[inline]
pub(super) fn variable(
    unit: &'static Unit,
    reference: ValueReference,
) -> Result<&'static Variable, FmiError> {
    let last = unit.variables.len() - 1;
    unit.variables.get(reference as usize).ok_or(FmiError::UnknownReference { reference, last })
}

/// Why a value is not accepted; after initialization, if there is nothing else against it.
#[cold]
fn refusal(unit: &'static Unit, reference: ValueReference, value: Value) -> FmiError {
    let variable = match variable(unit, reference) {
        Ok(variable) => variable,
        Err(error) => return error,
    };
    let belongs = match value {
        Value::Real(_) => is_real(variable.kind),
        Value::Integer(_) => is_integer(variable.kind),
        Value::Boolean(_) => is_boolean(variable.kind),
        Value::Text(_) => is_text(variable.kind),
    };
    if !belongs {
        return wrong_type(variable);
    }
    check(variable, value).map_or_else(FmiError::from, |()| FmiError::Fixed(variable.name))
}

pub(super) fn is_real(kind: Kind) -> bool {
    matches!(kind, Kind::Real)
}

fn is_integer(kind: Kind) -> bool {
    matches!(kind, Kind::Integer | Kind::Enumeration(_))
}

fn is_boolean(kind: Kind) -> bool {
    matches!(kind, Kind::Boolean)
}

fn is_text(kind: Kind) -> bool {
    matches!(kind, Kind::Text)
}

#[cold]
pub(super) fn wrong_type(variable: &Variable) -> FmiError {
    let kind = match variable.kind {
        Kind::Real => "Real",
        Kind::Integer => "Integer",
        Kind::Boolean => "Boolean",
        Kind::Text => "String",
        Kind::Enumeration(_) => "Enumeration (set and read as Integer)",
    };
    FmiError::WrongType { name: variable.name, kind }
}

fn bad_argument(name: &'static str, value: f64, allowed: &'static str) -> FmiError {
    FmiError::BadArgument { name, value, allowed }
}
