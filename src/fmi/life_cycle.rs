//! What an instance is made for, where in its life it is, and the time span of its run.

use serde::{Deserialize, Serialize};

/// What an instance is made for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Purpose {
    /// The host integrates and asks for forces at any time.
    ModelExchange,
    /// The host steps.
    CoSimulation,
}

/// Where in its life an instance is (FMI 2.0, 3.2.3 and 4.2.4).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
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
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Experiment {
    /// Start time [s].
    pub start: f64,
    /// Stop time, if there is one [s].
    pub stop: Option<f64>,
}
