//! The state of an instance as `fmi2GetFMUstate` keeps it.

use serde::{Deserialize, Serialize};

use super::coupling::LastStep;
use super::extrapolation::Extrapolation;
use super::held::Held;
use super::life_cycle::{Experiment, Purpose, State};
use crate::element::{ContactHistory, TrackState, WearState};
use crate::variables::{Described, ValuesOf};

/// Everything an instance has to remember; forces follow from it bit for bit.
///
/// The element itself is not kept: it follows from the parameters.
#[derive(Clone, Debug)]
pub struct Snapshot<S: Described> {
    /// What the instance was made for.
    pub purpose: Purpose,
    /// Place in the life cycle.
    pub state: State,
    /// Whether an element stood for these parameters.
    pub prepared: bool,
    /// How the outputs among the values are.
    pub outputs: Outputs,
    /// Parameters, inputs, outputs and the nominal height.
    pub values: ValuesOf<S>,
    /// Time derivatives of the inputs over the next step.
    pub extrapolation: Extrapolation,
    /// Where the last step began, if energy is monitored.
    pub last_step: Option<LastStep>,
    /// Whole numbers of the last event.
    pub held: Held,
    /// What each element remembers; default beyond their number.
    pub memories: [Memory; MAX_ELEMENTS],
    /// Time span of the experiment.
    pub experiment: Option<Experiment>,
    /// End of the last step [s].
    pub time: f64,
    /// The dummy state; bytes leave it to the host, which knows it.
    pub dummy_state: Option<f64>,
}

/// What one element remembers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Memory {
    /// Contacts and zones that found no room, so far.
    pub fallbacks: u64,
    /// What is worn off, if anything wears.
    pub wear: Option<WearState>,
    /// Where rails with a mass are, once they have been moved on.
    pub track: Option<TrackState>,
    /// What contacts remember, if they do.
    pub contact: Option<ContactHistory>,
}

/// A wheelset has two.
pub const MAX_ELEMENTS: usize = 2;

/// How the outputs of a state are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Outputs {
    /// Not evaluated since the inputs were set.
    Stale,
    /// Those of the inputs.
    Evaluated,
    /// Had been evaluated, and are to be evaluated again: bytes hold no outputs that follow from
    /// inputs.
    LeftOut,
}
