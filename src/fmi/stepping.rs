//! From the time span of a run over initialization and steps to its end.

use super::error::FmiError;
use super::instance::Instance;
use super::life_cycle::{Experiment, Purpose, State};
use super::logger::{Category, Logger};
use super::types::{Status, ValueReference};
use crate::element::parameters::WearModel;
use crate::element::subject::Subject;
use crate::variables::Described;

impl<S: Described> Instance<S> {
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

    /// Makes the element from the parameters; if one of them is at fault, the mode is not left.
    /// What is odd about the place in which a wheel starts is a warning.
    pub fn exit_initialization(&mut self, logger: &Logger) -> Result<Status, FmiError> {
        self.check_worn_files()?;
        self.prepare_element(true)?;
        self.reserve_derivatives();
        self.tell_profiles(logger);
        self.state = match self.purpose {
            Purpose::ModelExchange => State::EventMode,
            Purpose::CoSimulation => State::Stepping,
        };
        self.look_for_idle();
        let mut status = self.tell_idle(logger);
        let elements = self.element.iter().flat_map(Subject::elements);
        for (prefix, element) in S::PREFIXES.iter().zip(elements) {
            if let Some(warning) = element.start_warning() {
                status = Status::Warning;
                logger.log(status, Category::Warning, format_args!("{}", warning.message(prefix)));
            }
        }
        Ok(status)
    }

    /// Tells the host what was found in the files of the profiles: what was mended as warnings, the
    /// rest as events.
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

    /// Moves the time, and inputs with time derivatives; forces depend on the inputs alone, unless
    /// profiles wear or contacts remember.
    ///
    /// A step that ends after the stop time by more than rounding is refused (FMI 2.0, 2.1.6; FMI
    /// 3.0, 2.3.2). A host that sums up its time may find the stop time not quite reached and step
    /// once more: a step that starts before it by no more than rounding is admitted.
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
        if let Some(stop) = self.experiment.and_then(|e| e.stop) {
            let rounding = 1e-6 * step + 1e-9 * stop.abs().max(1.0);
            let left = stop - time;
            if step - left > rounding && !(left > 0.0 && left <= rounding) {
                return Err(FmiError::AfterStop { time, step, stop });
            }
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
        let goes_on = self.wear_model() != WearModel::Off || self.remembers();
        let status = if goes_on { self.go_on(step, logger)? } else { Status::Ok };
        self.time = time + step;
        Ok(start.map_or(status, |(watched, pairs)| {
            self.watch(step, &pairs);
            status.max(watched)
        }))
    }

    /// Wears off what the contacts of the inputs wear off in a step, or lets them remember it, and
    /// evaluates the outputs with it.
    fn go_on(&mut self, step: f64, logger: &Logger) -> Result<Status, FmiError> {
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
}

fn bad_argument(name: &'static str, value: f64, allowed: &'static str) -> FmiError {
    FmiError::BadArgument { name, value, allowed }
}
