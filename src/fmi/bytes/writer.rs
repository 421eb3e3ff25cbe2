//! The bytes of a state.

use super::layout::{FORMAT, HELD, STATES, TAG, calculated, outputs, settable};
use crate::element::TrackState;
use crate::fmi::coupling::LastStep;
use crate::fmi::life_cycle::Purpose;
use crate::fmi::snapshot::{Memory, Outputs, Snapshot};
use crate::variables::{Described, Value};

/// The bytes of a state.
pub fn write<S: Described>(snapshot: &Snapshot<S>) -> Vec<u8> {
    let mut bytes = TAG.to_vec();
    bytes.extend(FORMAT.to_le_bytes());
    text(&mut bytes, S::UNIT.guid);
    // A closed instance is not asked for its state.
    let life = STATES.iter().position(|s| *s == snapshot.state).unwrap_or_default();
    let evaluated = match snapshot.outputs {
        Outputs::Stale => 0,
        // What steps have led to does not follow from inputs.
        Outputs::Evaluated if remembers(snapshot) => HELD,
        Outputs::Evaluated | Outputs::LeftOut => 1,
    };
    let stepped = snapshot.purpose == Purpose::CoSimulation;
    bytes.extend([u8::from(stepped), life as u8, u8::from(snapshot.prepared), evaluated]);
    let stop = snapshot.experiment.and_then(|e| e.stop);
    bytes.extend([u8::from(snapshot.experiment.is_some()), u8::from(stop.is_some())]);
    for number in
        [snapshot.experiment.map_or(0.0, |e| e.start), stop.unwrap_or_default(), snapshot.time]
    {
        bytes.extend(number.to_le_bytes());
    }
    for variable in calculated::<S>().chain(settable::<S>()) {
        match snapshot.values.get(variable) {
            Value::Real(value) => bytes.extend(value.to_le_bytes()),
            Value::Integer(value) => bytes.extend(value.to_le_bytes()),
            Value::Boolean(value) => bytes.push(u8::from(value)),
            Value::Text(value) => text(&mut bytes, value),
        }
    }
    bytes.extend((snapshot.extrapolation.iter().len() as u32).to_le_bytes());
    for (reference, derivatives) in snapshot.extrapolation.iter() {
        bytes.extend(reference.to_le_bytes());
        bytes.extend(derivatives.iter().flat_map(|d| d.to_le_bytes()));
    }
    bytes.push(u8::from(snapshot.last_step.is_some()));
    if let Some(LastStep { duration, pairs }) = &snapshot.last_step {
        let numbers = std::iter::once(duration).chain(pairs.as_flattened());
        bytes.extend(numbers.flat_map(|number| number.to_le_bytes()));
    }
    bytes.extend(snapshot.values.coupling.energy_residual.to_le_bytes());
    bytes.extend(snapshot.held.values().flat_map(i32::to_le_bytes));
    for memory in snapshot.memories.iter().take(S::PREFIXES.len()) {
        write_memory(memory, &mut bytes);
    }
    if evaluated == HELD {
        for variable in outputs::<S>() {
            match snapshot.values.get(variable) {
                Value::Real(value) => bytes.extend(value.to_le_bytes()),
                Value::Integer(value) => bytes.extend(value.to_le_bytes()),
                // No output is one.
                Value::Boolean(_) | Value::Text(_) => {}
            }
        }
    }
    let checksum = crc32fast::hash(&bytes);
    bytes.extend(checksum.to_le_bytes());
    bytes
}

fn remembers<S: Described>(snapshot: &Snapshot<S>) -> bool {
    snapshot.memories.iter().any(|memory| memory.contact.is_some())
}

fn write_memory(memory: &Memory, bytes: &mut Vec<u8>) {
    bytes.extend(memory.fallbacks.to_le_bytes());
    bytes.push(u8::from(memory.track.is_some()));
    if let Some(TrackState { deflection, velocity, step_error }) = &memory.track {
        let numbers = deflection.iter().chain(velocity).chain([step_error]);
        bytes.extend(numbers.flat_map(|number| number.to_le_bytes()));
    }
    bytes.push(u8::from(memory.contact.is_some()));
    if let Some(history) = &memory.contact {
        let numbers = history.to_numbers();
        bytes.extend((numbers.len() as u32).to_le_bytes());
        bytes.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
    }
    bytes.push(u8::from(memory.wear.is_some()));
    let Some(wear) = &memory.wear else { return };
    bytes.extend(wear.clock.to_le_bytes());
    for arc in [Some(&wear.wheel)].into_iter().chain(wear.rails.iter().map(Option::as_ref)) {
        bytes.push(u8::from(arc.is_some()));
        let Some(arc) = arc else { continue };
        bytes.extend((arc.total.len() as u32).to_le_bytes());
        let sums = [arc.volume, arc.pending_area, arc.most_pending];
        for number in arc.total.iter().chain(&arc.pending).chain(&sums) {
            bytes.extend(number.to_le_bytes());
        }
    }
}

fn text(bytes: &mut Vec<u8>, text: &str) {
    bytes.extend((text.len() as u32).to_le_bytes());
    bytes.extend(text.as_bytes());
}
