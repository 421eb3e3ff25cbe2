//! A saved state as bytes: versioned, and checked when it is read.
//!
//! ```text
//! tag, format, GUID   what it is, and of which variables
//! body                as postcard writes it
//! checksum            CRC-32 of all before
//! ```

use std::mem::discriminant;

use serde::{Deserialize, Serialize};

use super::coupling::LastStep;
use super::error::FmiError;
use super::extrapolation::{Extrapolation, ORDERS};
use super::held::Held;
use super::interface::Interface;
use super::life_cycle::{Experiment, Purpose, State};
use super::snapshot::{MAX_ELEMENTS, Memory, Outputs, Snapshot};
use super::types::ValueReference;
use crate::element::{ContactHistory, TrackState, WearState};
use crate::variables::{Causality, Described, Value, ValuesOf, Variable, WHEEL, WHEELSET};
use crate::wear::ArcState;

const TAG: &[u8] = b"wheelrail state";

/// To be counted up when the layout changes; a change of variables shows in the GUID.
const FORMAT: u32 = 7;

/// What bytes hold of a state; the dummy state is left to the host, which knows it.
#[derive(Serialize, Deserialize)]
struct Body<'a> {
    purpose: Purpose,
    state: State,
    prepared: bool,
    outputs: Outputs,
    experiment: Option<Experiment>,
    time: f64,
    /// In the order of the [`variables`].
    #[serde(borrow)]
    values: Vec<Value<'a>>,
    extrapolation: Vec<(ValueReference, [f64; ORDERS])>,
    last_step: Option<LastStep>,
    energy_residual: f64,
    held: Vec<i32>,
    memories: Vec<Remembered>,
}

/// What is held of a [`Memory`]: fallbacks, wear, rails with a mass, and the contact as numbers.
type Remembered = (u64, Option<WearState>, Option<TrackState>, Option<Vec<f64>>);

/// Variables whose values are held. Outputs follow from the inputs, but those of steps whose
/// contacts remember, which are held.
fn variables<S: Described>(outputs: Outputs) -> impl Iterator<Item = &'static Variable> {
    let holds = outputs == Outputs::Evaluated;
    let all = S::UNIT.variables.iter();
    all.filter(move |v| v.causality != Causality::Output || (holds && v.is_evaluated()))
}

/// The beginning of the host's room for a serialized state, if it is large enough.
pub fn room(interface: Interface, target: &mut [u8], size: usize) -> Result<&mut [u8], FmiError> {
    let allowed = match interface {
        Interface::V2 => "at least what fmi2SerializedFMUstateSize gives",
        Interface::V3 => "at least what fmi3SerializedFMUStateSize gives",
    };
    let value = target.len() as f64;
    target.get_mut(..size).ok_or(FmiError::BadArgument { name: "size", value, allowed })
}

/// The bytes of a state.
pub fn write<S: Described>(snapshot: &Snapshot<S>) -> Vec<u8> {
    let remembers = snapshot.memories.iter().any(|memory| memory.contact.is_some());
    let outputs = match snapshot.outputs {
        // What steps have led to does not follow from inputs.
        Outputs::Evaluated if !remembers => Outputs::LeftOut,
        as_they_are => as_they_are,
    };
    let memories = snapshot.memories.iter().take(S::PREFIXES.len()).map(|memory| {
        let contact = memory.contact.as_ref().map(ContactHistory::to_numbers);
        (memory.fallbacks, memory.wear.clone(), memory.track, contact)
    });
    let body = Body {
        purpose: snapshot.purpose,
        state: snapshot.state,
        prepared: snapshot.prepared,
        outputs,
        experiment: snapshot.experiment,
        time: snapshot.time,
        values: variables::<S>(outputs).map(|v| snapshot.values.get(v)).collect(),
        extrapolation: snapshot.extrapolation.iter().copied().collect(),
        last_step: snapshot.last_step,
        energy_residual: snapshot.values.coupling.energy_residual,
        held: snapshot.held.values().collect(),
        memories: memories.collect(),
    };
    let head = [TAG, &FORMAT.to_le_bytes()].concat();
    // A vector takes everything.
    let mut bytes = postcard::to_extend(&(S::UNIT.guid, body), head).unwrap_or_default();
    bytes.extend(crc32fast::hash(&bytes).to_le_bytes());
    bytes
}

/// The state of bytes.
pub fn read<S: Described>(bytes: &[u8]) -> Result<Snapshot<S>, FmiError> {
    let bad = |problem: String| FmiError::BadBytes(problem);
    let damaged = || bad("is damaged: fewer or other bytes than were serialized".into());
    let Some(rest) = bytes.strip_prefix(TAG) else {
        let problem = "is no state of this unit: it does not begin as a serialized one does";
        return Err(bad(problem.into()));
    };
    // Before the checksum: what is not known cannot be told from damage.
    let (format, rest) = rest.split_first_chunk().ok_or_else(damaged)?;
    let format = u32::from_le_bytes(*format);
    if format != FORMAT {
        return Err(bad(format!("is of format {format}, this unit reads {FORMAT}")));
    }
    let (rest, checksum) = rest.split_last_chunk().ok_or_else(damaged)?;
    if crc32fast::hash(&bytes[..bytes.len() - checksum.len()]) != u32::from_le_bytes(*checksum) {
        return Err(damaged());
    }
    let (guid, rest) = postcard::take_from_bytes::<&str>(rest).map_err(|_| damaged())?;
    let own = S::UNIT;
    if guid != own.guid {
        return Err(bad(match [&WHEEL, &WHEELSET].into_iter().find(|unit| unit.guid == guid) {
            Some(other) => format!("is of {}, this unit is {}", other.identifier, own.identifier),
            None => format!("is of a unit with GUID \"{guid}\", this one has \"{}\"", own.guid),
        }));
    }
    match postcard::take_from_bytes(rest) {
        Ok((body, [])) => snapshot(body).ok_or_else(damaged),
        _ => Err(damaged()),
    }
}

/// The state of a body, every value of which is one that could have been set or computed.
fn snapshot<S: Described>(body: Body) -> Option<Snapshot<S>> {
    let Body { purpose, state, prepared, outputs, experiment, time, last_step, .. } = body;
    let is_possible = match state {
        // An element is there from the end of initialization on.
        State::Instantiated | State::Initialization => true,
        State::Stepping => prepared && purpose == Purpose::CoSimulation,
        State::EventMode | State::ContinuousTime => prepared && purpose == Purpose::ModelExchange,
        State::Terminated => prepared,
        State::Closed => false,
    };
    let [start, stop] = experiment.map_or([0.0; 2], |e| [e.start, e.stop.unwrap_or_default()]);
    let step_is_good = last_step.is_none_or(|LastStep { duration, pairs }| {
        is_amount(duration) && pairs.as_flattened().iter().all(|number| number.is_finite())
    });
    let numbers = [start, stop, time, body.energy_residual];
    if !(is_possible && step_is_good && numbers.iter().all(|number| number.is_finite())) {
        return None;
    }
    let mut values = ValuesOf::<S>::default();
    if body.values.len() != variables::<S>(outputs).count() {
        return None;
    }
    for (variable, value) in variables::<S>(outputs).zip(body.values) {
        if discriminant(&value) != discriminant(&values.get(variable)) {
            return None;
        }
        match (variable.causality, value) {
            (Causality::Input | Causality::Parameter, value) => values.set(variable, value).ok()?,
            (_, Value::Real(number)) if !number.is_finite() => return None,
            (Causality::Output, Value::Real(number)) => {
                *S::output_slot(&mut values, variable.reference)? = number;
            }
            (_, value) => _ = values.write(variable, value),
        }
    }
    values.coupling.energy_residual = body.energy_residual;
    let mut extrapolation = Extrapolation::new(S::UNIT);
    for (reference, derivatives) in body.extrapolation {
        extrapolation.set(S::UNIT, &[reference; ORDERS], &[1, 2, 3], &derivatives).ok()?;
    }
    let mut held = Held::new::<S>();
    if (body.held.len(), body.memories.len()) != (held.values().count(), S::PREFIXES.len()) {
        return None;
    }
    held.set(body.held.into_iter());
    let mut memories: [Memory; MAX_ELEMENTS] = Default::default();
    for (memory, (fallbacks, wear, track, contact)) in memories.iter_mut().zip(body.memories) {
        if !(wear.as_ref().is_none_or(wear_is_good) && track.as_ref().is_none_or(track_is_good)) {
            return None;
        }
        let contact = contact.map(|numbers| ContactHistory::from_numbers(&numbers));
        *memory = Memory { fallbacks, wear, track, contact: contact.transpose().ok()? };
    }
    let dummy_state = None;
    Some(Snapshot {
        purpose,
        state,
        prepared,
        outputs,
        values,
        extrapolation,
        last_step,
        held,
        memories,
        experiment,
        time,
        dummy_state,
    })
}

fn is_amount(number: f64) -> bool {
    number.is_finite() && number >= 0.0
}

fn wear_is_good(WearState { clock, wheel, rails }: &WearState) -> bool {
    let arc_is_good =
        |ArcState { total, pending, volume, pending_area, most_pending }: &ArcState| {
            let sums = [volume, pending_area, most_pending];
            total.len() == pending.len()
                && total.iter().chain(pending).chain(sums).copied().all(is_amount)
        };
    is_amount(*clock) && [wheel].into_iter().chain(rails.iter().flatten()).all(arc_is_good)
}

fn track_is_good(TrackState { deflection, velocity, step_error }: &TrackState) -> bool {
    is_amount(*step_error) && deflection.iter().chain(velocity).all(|number| number.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::Element;
    use crate::fmi::instance::Instance;
    use crate::fmi::interface::Interface;
    use crate::fmi::life_cycle::Purpose;
    use crate::fmi::logger::Logger;
    use crate::fmi::snapshot::Snapshot;
    use crate::variables::Described;
    use crate::wheelset::Wheelset;

    fn saved<S: Described>() -> Snapshot<S> {
        let (purpose, starts) = (Purpose::CoSimulation, Box::default());
        let mut instance = Instance::<S>::new(Interface::V2, purpose, Vec::new(), starts, false);
        instance.setup_experiment(None, 0.5, Some(2.0)).unwrap();
        instance.enter_initialization().unwrap();
        instance.exit_initialization(&Logger::silent()).unwrap();
        instance.step(0.5, 0.25, &Logger::silent()).unwrap();
        let key = instance.save(std::ptr::null_mut()).unwrap();
        instance.saved(key).unwrap().clone()
    }

    fn comes_back<S: Described>() {
        let state = saved::<S>();
        let read = read::<S>(&write(&state)).unwrap();
        assert_eq!(read.values, state.values);
        assert_eq!((read.state, read.experiment), (state.state, state.experiment));
        assert_eq!(read.time.to_bits(), 0.75_f64.to_bits());
        assert_eq!(read.memories, state.memories);
    }

    #[test]
    fn what_is_written_is_read() {
        comes_back::<Element>();
        comes_back::<Wheelset>();
    }

    #[test]
    fn every_damaged_byte_and_every_cut_is_found() {
        let bytes = write(&saved::<Element>());
        for i in 0..bytes.len() {
            assert!(read::<Element>(&bytes[..i]).is_err(), "cut after {i}");
            for bit in 0..8 {
                let mut damaged = bytes.clone();
                damaged[i] ^= 1 << bit;
                assert!(read::<Element>(&damaged).is_err(), "bit {bit} of byte {i}");
            }
        }
        let longer = [&*bytes, &[0]].concat();
        assert!(read::<Element>(&longer).is_err());
    }

    #[test]
    fn bytes_with_a_good_checksum_and_bad_values_are_refused() {
        let mut state = saved::<Element>();
        state.values.input.friction = -1.0;
        assert!(read::<Element>(&write(&state)).unwrap_err().to_string().contains("damaged"));
        state = saved();
        state.time = f64::NAN;
        assert!(read::<Element>(&write(&state)).is_err());
        state = saved();
        state.values.nominal = f64::INFINITY;
        assert!(read::<Element>(&write(&state)).is_err());
    }

    #[test]
    fn wrong_lengths_under_a_good_checksum_do_no_harm() {
        let bytes = write(&saved::<Element>());
        let end = bytes.len() - 4;
        let damaged = |at: usize| {
            let mut damaged = bytes.clone();
            // The longest length that there is.
            damaged[at..end.min(at + 10)].fill(0xff);
            if let Some(last) = damaged[..end].get_mut(at + 9) {
                *last = 1;
            }
            let checksum = crc32fast::hash(&damaged[..end]);
            damaged[end..].copy_from_slice(&checksum.to_le_bytes());
            damaged
        };
        let places = TAG.len()..end;
        let refused = places.clone().filter(|at| read::<Element>(&damaged(*at)).is_err()).count();
        assert!(2 * refused > places.len(), "{refused} of {}", places.len());
    }

    #[test]
    fn the_message_tells_foreign_from_old_bytes() {
        let bytes = write(&saved::<Element>());
        let message = |bytes: &[u8]| read::<Element>(bytes).unwrap_err().to_string();
        assert!(message(b"something else").contains("no state"));
        let mut other = bytes.clone();
        other[TAG.len()] = 9;
        assert!(message(&other).contains("format 9"));
        let mut other = bytes.clone();
        other[TAG.len() + 8] ^= 1;
        let end = other.len() - 4;
        let checksum = crc32fast::hash(&other[..end]);
        other[end..].copy_from_slice(&checksum.to_le_bytes());
        assert!(message(&other).contains("GUID"));
    }
}
