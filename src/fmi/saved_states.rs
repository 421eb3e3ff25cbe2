//! States of an instance saved, restored and handed out.

use super::error::FmiError;
use super::instance::Instance;
use super::life_cycle::Purpose;
use super::slots::{Key, Slots};
use super::snapshot::{MAX_ELEMENTS, Memory, Outputs, Snapshot};
use crate::element::Element;
use crate::variables::{Described, ValuesOf};

impl<S: Described> Instance<S> {
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

    /// Keeps a state that was read from bytes, in place of that of `key` unless it is null; gives
    /// its key.
    pub fn put(&mut self, key: Key, snapshot: Snapshot<S>) -> Result<Key, FmiError> {
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
    pub fn saved(&self, key: Key) -> Result<&Snapshot<S>, FmiError> {
        self.snapshots.get(key).ok_or(UNKNOWN)
    }

    /// Goes back to the state of a key; refused, with nothing changed, if the profiles of its
    /// parameters cannot be had any more.
    pub fn load(&mut self, key: Key) -> Result<(), FmiError> {
        let snapshots = std::mem::replace(&mut self.snapshots, Slots::new());
        let loaded = snapshots.get(key).ok_or(UNKNOWN).and_then(|saved| self.restore(saved));
        self.snapshots = snapshots;
        loaded
    }

    fn snapshot(&self) -> Snapshot<S> {
        Snapshot {
            purpose: self.purpose,
            state: self.state,
            prepared: self.is_prepared(),
            outputs: if self.outputs_stale { Outputs::Stale } else { Outputs::Evaluated },
            values: self.values.clone(),
            extrapolation: self.extrapolation.clone(),
            last_step: self.last_step,
            held: self.held.clone(),
            memories: self.memories(),
            experiment: self.experiment,
            time: self.time,
            dummy_state: self.dummy_state,
        }
    }

    fn memories(&self) -> [Memory; MAX_ELEMENTS] {
        let mut memories: [Memory; MAX_ELEMENTS] = Default::default();
        for (memory, element) in memories.iter_mut().zip(self.elements()) {
            *memory = Memory {
                fallbacks: element.fallbacks(),
                wear: element.wear_state(),
                track: element.track_state(),
                contact: element.contact_history().cloned(),
            };
        }
        memories
    }

    fn elements(&self) -> &[Element] {
        self.element.as_ref().map_or(&[], S::elements)
    }

    fn overwrite(&self, old: &mut Snapshot<S>) {
        if old.values.parameters != self.values.parameters {
            *old = self.snapshot();
            return;
        }
        copy_what_moves(&self.values, &mut old.values);
        old.extrapolation.copy_from(&self.extrapolation);
        old.last_step = self.last_step;
        old.held.set(self.held.values());
        old.state = self.state;
        old.prepared = self.is_prepared();
        old.outputs = if self.outputs_stale { Outputs::Stale } else { Outputs::Evaluated };
        if self.element.is_none() {
            old.memories = Default::default();
        }
        for (memory, element) in old.memories.iter_mut().zip(self.elements()) {
            (memory.fallbacks, memory.track) = (element.fallbacks(), element.track_state());
            element.copy_wear_state(&mut memory.wear);
            match (&mut memory.contact, element.contact_history()) {
                (Some(old), Some(now)) => old.copy_from(now),
                (old, now) => *old = now.cloned(),
            }
        }
        old.experiment = self.experiment;
        old.time = self.time;
        old.dummy_state = self.dummy_state;
    }

    fn restore(&mut self, saved: &Snapshot<S>) -> Result<(), FmiError> {
        let same = self.values.parameters == saved.values.parameters;
        let mut made_anew = false;
        if saved.prepared && !(same && self.is_prepared()) {
            let ValuesOf { parameters, input, .. } = &saved.values;
            let mut element = S::prepare(parameters, input, &self.profile_folders)?;
            wear_as_saved(element.elements_mut(), &saved.memories)?;
            self.element = Some(element);
            made_anew = true;
        } else if let Some(element) = self.element.as_mut().filter(|_| saved.prepared) {
            wear_as_saved(element.elements_mut(), &saved.memories)?;
        }
        if same {
            copy_what_moves(&saved.values, &mut self.values);
        } else {
            self.values.clone_from(&saved.values);
        }
        self.extrapolation.copy_from(&saved.extrapolation);
        self.last_step = saved.last_step;
        self.held.set(saved.held.values());
        self.slopes_at = None;
        self.state = saved.state;
        self.parameters_changed = !saved.prepared;
        self.nominal_input = None;
        self.outputs_stale = saved.outputs == Outputs::Stale;
        self.experiment = saved.experiment;
        self.time = saved.time;
        self.dummy_state = self.dummy_state.and(saved.dummy_state.or(self.dummy_state));
        if let Some(element) = &mut self.element {
            for (element, memory) in element.elements_mut().iter_mut().zip(&saved.memories) {
                element.set_track_state(memory.track);
                // One that was made anew remembers nothing.
                if let Some(history) = &memory.contact {
                    element.set_contact_history(history);
                }
            }
            if saved.outputs == Outputs::LeftOut {
                element.evaluate_all(&self.values.input, &mut self.values.output)?;
            }
            for (element, memory) in element.elements_mut().iter_mut().zip(&saved.memories) {
                element.set_fallbacks(memory.fallbacks);
            }
            element.report_fallbacks(&mut self.values.output);
        }
        if made_anew {
            self.reserve_derivatives();
        }
        Ok(())
    }
}

/// Takes the wear of elements back to that of a saved state; refused where their profiles are not
/// those of the state.
fn wear_as_saved(elements: &mut [Element], saved: &[Memory]) -> Result<(), FmiError> {
    for (element, memory) in elements.iter_mut().zip(saved) {
        if memory.wear.as_ref().is_some_and(|wear| !element.set_wear_state(wear)) {
            let problem = "holds the wear of other profiles than the parameters name";
            return Err(FmiError::BadBytes(problem.into()));
        }
    }
    Ok(())
}

const UNKNOWN: FmiError = FmiError::UnknownState("FMUstate");

fn hand_out<S: Described>(
    snapshots: &mut Slots<Snapshot<S>>,
    snapshot: Snapshot<S>,
) -> Result<Key, FmiError> {
    let allowed = "one of fewer than 2^32 states";
    let full = FmiError::BadArgument { name: "FMUstate", value: f64::INFINITY, allowed };
    snapshots.insert(snapshot).ok_or(full)
}

/// All values but the parameters.
fn copy_what_moves<S: Described>(from: &ValuesOf<S>, to: &mut ValuesOf<S>) {
    (to.input, to.output, to.nominal) = (from.input, from.output, from.nominal);
    to.coupling = from.coupling;
}
