//! A wheel or a wheelset with its variables and its place in the life cycle.

use std::ffi::CString;
use std::path::PathBuf;

use super::coupling::LastStep;
use super::directional::DerivativeScratch;
use super::error::FmiError;
use super::events::Held;
use super::extrapolation::Extrapolation;
use super::interface::Interface;
use super::logger::{Category, Logger};
use super::slots::Slots;
use super::snapshot::Snapshot;
use super::types::{Status, ValueReference};
use crate::element::parameters::{VerticalMode, WearModel};
use crate::element::subject::Subject;
use crate::element::sunk_message;
use crate::element::vertical_load::is_carried;
use crate::error::ContactError;
use crate::variables::{Described, ValuesOf};

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

/// What is said once, until all is well again.
#[derive(Clone, Copy, Debug, Default)]
struct Told {
    /// The rails do not carry a given load.
    load_is_missed: bool,
    /// A wheel is too deep in a rail.
    wheel_is_sunk: bool,
}

/// An instance of one unit.
#[derive(Debug)]
pub struct Instance<S: Described> {
    /// Through which it was made.
    pub interface: Interface,
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
    /// Memory for directional derivatives.
    pub(super) derivatives: Option<Box<DerivativeScratch<S>>>,
    /// Whole numbers of the last event of model exchange.
    pub(super) held: Held,
    /// What the host was told of the outputs evaluated last.
    told: Told,
    /// Places of the elements of unknowns and knowns of a derivative through FMI 3.0.
    pub(super) flattened: [Vec<ValueReference>; 2],
    /// Texts handed out by the last call that read texts.
    pub(super) handed_out: Vec<CString>,
    /// States handed out and not freed yet.
    pub snapshots: Slots<Snapshot<S>>,
}

impl<S: Described> Instance<S> {
    /// An instance with start values; profiles are looked for in the folders, in order.
    pub fn new(interface: Interface, purpose: Purpose, profile_folders: Vec<PathBuf>) -> Self {
        let most_flattened = match interface {
            Interface::V2 => 0,
            Interface::V3 => S::UNIT.variables.len(),
        };
        Self {
            interface,
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
            derivatives: None,
            held: Held::new::<S>(),
            told: Told::default(),
            flattened: [(); 2].map(|()| Vec::with_capacity(most_flattened)),
            handed_out: Vec::new(),
            snapshots: Slots::new(),
        }
    }

    /// Back to what it was after instantiation; states handed out stay good.
    pub fn reset(&mut self) {
        let snapshots = std::mem::replace(&mut self.snapshots, Slots::new());
        *self = Self {
            snapshots,
            ..Self::new(self.interface, self.purpose, std::mem::take(&mut self.profile_folders))
        };
    }

    /// Whether there is an element of the parameters as they are.
    pub(super) fn is_prepared(&self) -> bool {
        self.element.is_some() && !self.parameters_changed
    }

    /// Takes over the time span; `tolerance` and `stop` if they are defined.
    pub fn setup_experiment(
        &mut self,
        tolerance: Option<f64>,
        start: f64,
        stop: Option<f64>,
    ) -> Result<(), FmiError> {
        if let Some(tolerance) = tolerance.filter(|t| !(t.is_finite() && *t >= 0.0)) {
            return Err(bad_argument("tolerance", tolerance, "a finite number, not negative"));
        }
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
        let experiment = self.experiment.ok_or_else(|| FmiError::WrongState {
            state: "while the start time is undefined".into(),
            remedy: "call fmi2SetupExperiment first".into(),
        })?;
        self.time = experiment.start;
        self.state = State::Initialization;
        Ok(())
    }

    /// Makes the element from the parameters; if one of them is at fault, the mode is not left. What is odd about the place in which
    /// a wheel starts is a warning.
    pub fn exit_initialization(&mut self, logger: &Logger) -> Result<Status, FmiError> {
        self.check_worn_files()?;
        self.prepare_element(true)?;
        self.reserve_derivatives();
        self.tell_profiles(logger);
        self.state = match self.purpose {
            Purpose::ModelExchange => State::EventMode,
            Purpose::CoSimulation => State::Stepping,
        };
        let mut status = Status::Ok;
        let elements = self.element.iter().flat_map(Subject::elements);
        for (prefix, element) in S::PREFIXES.iter().zip(elements) {
            if let Some(warning) = element.start_warning() {
                status = Status::Warning;
                logger.log(status, Category::Warning, format_args!("{}", warning.message(prefix)));
            }
        }
        Ok(status)
    }

    /// Tells the host what was found in the files of the profiles: what was mended as warnings, the rest as events.
    fn tell_profiles(&self, logger: &Logger) {
        let Some(element) = &self.element else { return };
        for (prefix, element) in S::PREFIXES.iter().zip(element.elements()) {
            for (parameter, remark) in element.profile_remarks() {
                let (status, category) = if remark.is_warning() {
                    (Status::Warning, Category::Warning)
                } else {
                    (Status::Ok, Category::Events)
                };
                logger.log(status, category, format_args!("{prefix}{parameter}: {remark}"));
            }
        }
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
        if self.has_moving_rails() {
            self.move_rails(step)?;
        } else {
            self.outputs_stale |= self.extrapolation.apply(step, &mut self.values)?;
        }
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
        Ok(self.warnings(fallbacks, logger))
    }

    /// Ends the run: writes the worn profiles that the parameters ask for.
    pub fn terminate(&mut self) -> Result<(), FmiError> {
        if self.state == State::Stepping {
            self.write_worn_profiles()?;
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

    /// Makes the element if there is none of these parameters, or none of this input if the nominal
    /// height is wanted.
    pub(super) fn prepare_element(&mut self, nominal: bool) -> Result<(), FmiError> {
        let moved = nominal && self.nominal_input != Some(self.values.input);
        if !self.is_prepared() || moved {
            self.check_foundation()?;
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

    /// Evaluates the outputs.
    pub(super) fn evaluate(&mut self, logger: &Logger) -> Result<Status, FmiError> {
        let Some(element) = &mut self.element else { return Ok(Status::Ok) };
        let fallbacks = S::fallback_count(&self.values.output);
        element.evaluate_all(&self.values.input, &mut self.values.output)?;
        self.outputs_stale = false;
        Ok(self.warnings(fallbacks, logger))
    }

    /// A warning if there are more fallbacks than `before`: a load that is not carried, or a simpler model.
    fn warnings(&mut self, before: i32, logger: &Logger) -> Status {
        let count = S::fallback_count(&self.values.output);
        let missed = self.report_loads(logger) + self.report_sunk(logger);
        if count == before {
            return Status::Ok;
        }
        if count.saturating_sub(before) > missed && logger.takes(Category::Warning) {
            let message = format_args!(
                "a contact found no room, or a solver fell back to a simpler model: fallback_count = {count}"
            );
            logger.log(Status::Warning, Category::Warning, message);
        }
        Status::Warning
    }

    /// The number of wheels that are too deep in their rails for a force; the first time they are told.
    fn report_sunk(&mut self, logger: &Logger) -> i32 {
        let elements = self.element.iter().flat_map(Subject::elements);
        let mut sunk = 0;
        for (prefix, depth) in
            S::PREFIXES.iter().zip(elements).filter_map(|(p, e)| Some((p, e.sunk()?)))
        {
            sunk += 1;
            if !self.told.wheel_is_sunk && logger.takes(Category::Warning) {
                let place = sunk_message(depth, prefix);
                let message = format_args!("{place}; this is said once until it is out again");
                logger.log(Status::Warning, Category::Warning, message);
            }
        }
        self.told.wheel_is_sunk = sunk > 0;
        sunk
    }

    /// The number of given loads that the rails do not carry; the first time they are told.
    fn report_loads(&mut self, logger: &Logger) -> i32 {
        let ValuesOf { parameters, input, output, .. } = &self.values;
        let all = S::parameters_of_elements(parameters).iter().zip(S::PREFIXES).enumerate();
        let given = all.filter(|(_, (own, _))| own.vertical_mode == VerticalMode::Load);
        let mut missed = 0;
        for (k, (_, prefix)) in given {
            let [load, carried] = S::load_and_carried(k, input, output);
            if is_carried(load, carried) {
                continue;
            }
            missed += 1;
            if !self.told.load_is_missed && logger.takes(Category::Warning) {
                let message = format_args!(
                    "{prefix}wheel.load = {load} N, but the rails carry {carried:.0} N where the wheel is: {prefix}vertical.load_carried says how \
                     much; this is said once until they carry it again"
                );
                logger.log(Status::Warning, Category::Warning, message);
            }
        }
        self.told.load_is_missed = missed > 0;
        missed
    }
}

fn bad_argument(name: &'static str, value: f64, allowed: &'static str) -> FmiError {
    FmiError::BadArgument { name, value, allowed }
}
