//! The state of an instance as `fmi2GetFMUstate` keeps it.

use super::error::FmiError;
use super::extrapolation::Extrapolation;
use super::instance::{Experiment, Instance, Purpose, State};
use super::slots::{Key, Slots};
use crate::element::{Element, WearState};
use crate::variables::Values;

/// Everything an instance has to remember; forces follow from it bit for bit.
///
/// The element itself is not kept: it follows from the parameters.
#[derive(Clone, Debug)]
pub struct Snapshot {
    /// What the instance was made for.
    pub purpose: Purpose,
    /// Place in the life cycle.
    pub state: State,
    /// Whether an element stood for these parameters.
    pub prepared: bool,
    /// How the outputs among the values are.
    pub outputs: Outputs,
    /// Parameters, inputs, outputs and the nominal height.
    pub values: Values,
    /// Time derivatives of the inputs over the next step.
    pub extrapolation: Extrapolation,
    /// Contacts and zones that found no room, so far.
    pub fallbacks: u64,
    /// What is worn off, if anything wears.
    pub wear: Option<WearState>,
    /// Time span of the experiment.
    pub experiment: Option<Experiment>,
    /// End of the last step [s].
    pub time: f64,
}

/// How the outputs of a state are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outputs {
    /// Not evaluated since the inputs were set.
    Stale,
    /// Those of the inputs.
    Evaluated,
    /// Had been evaluated, and are to be evaluated again: bytes hold no outputs.
    LeftOut,
}

impl Instance {
    /// Saves the state as it is now, over that of `key` unless it is null; gives its key.
    ///
    /// Over an old state of the same parameters nothing is allocated.
    pub fn save(&mut self, key: Key) -> Result<Key, FmiError> {
        // Out of the instance while it is read.
        let mut snapshots = std::mem::replace(&mut self.snapshots, Slots::new());
        let saved = if key.is_null() {
            hand_out(&mut snapshots, self.snapshot())
        } else {
            let old = snapshots.get_mut(key).ok_or(UNKNOWN);
            old.map(|old| {
                self.overwrite(old);
                key
            })
        };
        self.snapshots = snapshots;
        saved
    }

    /// Keeps a state that was read from bytes, in place of that of `key` unless it is null; gives its key.
    pub fn put(&mut self, key: Key, snapshot: Snapshot) -> Result<Key, FmiError> {
        if snapshot.purpose != self.purpose {
            let (from, own) = match self.purpose {
                Purpose::ModelExchange => ("co-simulation", "model exchange"),
                Purpose::CoSimulation => ("model exchange", "co-simulation"),
            };
            let problem = format!("is of an instance for {from}, this one is for {own}");
            return Err(FmiError::BadBytes(problem));
        }
        if key.is_null() {
            return hand_out(&mut self.snapshots, snapshot);
        }
        *self.snapshots.get_mut(key).ok_or(UNKNOWN)? = snapshot;
        Ok(key)
    }

    /// The state of a key.
    pub fn saved(&self, key: Key) -> Result<&Snapshot, FmiError> {
        self.snapshots.get(key).ok_or(UNKNOWN)
    }

    /// Goes back to the state of a key; refused, with nothing changed, if the profiles of its parameters cannot be had any more.
    pub fn load(&mut self, key: Key) -> Result<(), FmiError> {
        let snapshots = std::mem::replace(&mut self.snapshots, Slots::new());
        let loaded = snapshots.get(key).ok_or(UNKNOWN).and_then(|saved| self.restore(saved));
        self.snapshots = snapshots;
        loaded
    }

    fn snapshot(&self) -> Snapshot {
        Snapshot {
            purpose: self.purpose,
            state: self.state,
            prepared: self.is_prepared(),
            outputs: if self.outputs_stale { Outputs::Stale } else { Outputs::Evaluated },
            values: self.values.clone(),
            extrapolation: self.extrapolation.clone(),
            fallbacks: self.element.as_ref().map_or(0, Element::fallbacks),
            wear: self.element.as_ref().and_then(Element::wear_state),
            experiment: self.experiment,
            time: self.time,
        }
    }

    fn overwrite(&self, old: &mut Snapshot) {
        if old.values.parameters != self.values.parameters {
            *old = self.snapshot();
            return;
        }
        copy_what_moves(&self.values, &mut old.values);
        old.extrapolation.copy_from(&self.extrapolation);
        old.state = self.state;
        old.prepared = self.is_prepared();
        old.outputs = if self.outputs_stale { Outputs::Stale } else { Outputs::Evaluated };
        old.fallbacks = self.element.as_ref().map_or(0, Element::fallbacks);
        match &self.element {
            Some(element) => element.copy_wear_state(&mut old.wear),
            None => old.wear = None,
        }
        old.experiment = self.experiment;
        old.time = self.time;
    }

    fn restore(&mut self, saved: &Snapshot) -> Result<(), FmiError> {
        let same = self.values.parameters == saved.values.parameters;
        if saved.prepared && !(same && self.is_prepared()) {
            let Values { parameters, input, .. } = &saved.values;
            let mut element = Element::new(parameters, input, &self.profile_folders)?;
            wear_as_saved(&mut element, saved)?;
            self.element = Some(element);
        } else if let Some(element) = self.element.as_mut().filter(|_| saved.prepared) {
            wear_as_saved(element, saved)?;
        }
        if same {
            copy_what_moves(&saved.values, &mut self.values);
        } else {
            self.values.clone_from(&saved.values);
        }
        self.extrapolation.copy_from(&saved.extrapolation);
        self.state = saved.state;
        self.parameters_changed = !saved.prepared;
        self.nominal_input = None;
        self.outputs_stale = saved.outputs == Outputs::Stale;
        self.experiment = saved.experiment;
        self.time = saved.time;
        if let Some(element) = &mut self.element {
            if saved.outputs == Outputs::LeftOut {
                element.evaluate(&self.values.input, &mut self.values.output)?;
            }
            element.set_fallbacks(saved.fallbacks);
            self.values.output.fallback_count = element.fallback_count();
        }
        Ok(())
    }
}

/// Takes the element's wear back to that of a saved state; refused where its profiles are not those of the state.
fn wear_as_saved(element: &mut Element, saved: &Snapshot) -> Result<(), FmiError> {
    match &saved.wear {
        Some(wear) if !element.set_wear_state(wear) => Err(FmiError::BadBytes(
            "holds the wear of other profiles than the parameters name".into(),
        )),
        _ => Ok(()),
    }
}

const UNKNOWN: FmiError = FmiError::UnknownState("FMUstate");

fn hand_out(snapshots: &mut Slots<Snapshot>, snapshot: Snapshot) -> Result<Key, FmiError> {
    let allowed = "one of fewer than 2^32 states";
    let full = FmiError::BadArgument { name: "FMUstate", value: f64::INFINITY, allowed };
    snapshots.insert(snapshot).ok_or(full)
}

/// All values but the parameters.
fn copy_what_moves(from: &Values, to: &mut Values) {
    (to.input, to.output) = (from.input, from.output);
    to.nominal_wheel_z = from.nominal_wheel_z;
}
