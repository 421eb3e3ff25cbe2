//! A saved state as bytes: versioned, and checked when it is read.
//!
//! ```text
//! tag, format, GUID                 what it is, and of which variables
//! purpose, life, prepared, evaluated
//!                                   one byte each
//! experiment, time
//! nominal heights
//! inputs and parameters             in the order of the variables
//! derivatives of inputs             their number, then reference, three numbers each
//! last step                         one byte whether it is kept; its length, pairs of force and velocity
//! energy residual
//! whole numbers of the last event
//! of each element:
//! fallbacks
//! rails with a mass                 one byte whether they have been moved on; deflection, velocity, error of the last step
//! wear                              one byte whether there is any; clock; wheel and rails:
//!                                   one byte whether it is there, number of cells, totals and
//!                                   sums since the last update, three numbers
//! checksum                          CRC-32 of all before
//! ```
//!
//! Numbers are little-endian; a text has its length before it. Outputs follow from the inputs.

use super::coupling::LastStep;
use super::error::FmiError;
use super::extrapolation::{Extrapolation, ORDERS};
use super::held::Held;
use super::life_cycle::{Experiment, Purpose, State};
use super::snapshot::{MOST_ELEMENTS, Memory, Outputs, Snapshot};
use crate::element::parameters::RAILS;
use crate::element::work_pairs::MOST_PAIRS;
use crate::element::{TrackState, WearState};
use crate::variables::{Causality, Described, Kind, Value, ValuesOf, Variable, WHEEL, WHEELSET};
use crate::wear::ArcState;

const TAG: &[u8] = b"wheelrail state";
/// To be counted up when the layout changes; a change of variables shows in the GUID.
const FORMAT: u32 = 5;

const STATES: [State; 6] = [
    State::Instantiated,
    State::Initialization,
    State::Stepping,
    State::EventMode,
    State::ContinuousTime,
    State::Terminated,
];

/// The bytes of a state.
pub fn write<S: Described>(snapshot: &Snapshot<S>) -> Vec<u8> {
    let mut bytes = TAG.to_vec();
    bytes.extend(FORMAT.to_le_bytes());
    text(&mut bytes, S::UNIT.guid);
    // A closed instance is not asked for its state.
    let life = STATES.iter().position(|s| *s == snapshot.state).unwrap_or_default();
    let evaluated = snapshot.outputs != Outputs::Stale;
    let stepped = snapshot.purpose == Purpose::CoSimulation;
    bytes.extend([u8::from(stepped), life as u8, u8::from(snapshot.prepared), u8::from(evaluated)]);
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
    let checksum = crc32fast::hash(&bytes);
    bytes.extend(checksum.to_le_bytes());
    bytes
}

fn write_memory(memory: &Memory, bytes: &mut Vec<u8>) {
    bytes.extend(memory.fallbacks.to_le_bytes());
    bytes.push(u8::from(memory.track.is_some()));
    if let Some(TrackState { deflection, velocity, step_error }) = &memory.track {
        let numbers = deflection.iter().chain(velocity).chain([step_error]);
        bytes.extend(numbers.flat_map(|number| number.to_le_bytes()));
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

/// Heights of first touch.
fn calculated<S: Described>() -> impl Iterator<Item = &'static Variable> {
    S::UNIT.variables.iter().filter(|v| v.causality == Causality::CalculatedParameter)
}

/// Inputs and parameters.
fn settable<S: Described>() -> impl Iterator<Item = &'static Variable> {
    S::UNIT.variables.iter().filter(|v| v.is_settable())
}

fn text(bytes: &mut Vec<u8>, text: &str) {
    bytes.extend((text.len() as u32).to_le_bytes());
    bytes.extend(text.as_bytes());
}

/// The state of bytes.
///
/// # Errors
/// Bytes that are damaged, no state at all, or of another version of the unit.
pub fn read<S: Described>(bytes: &[u8]) -> Result<Snapshot<S>, FmiError> {
    let bad = |problem: &str| FmiError::BadBytes(problem.into());
    let damaged = || bad("is damaged: fewer or other bytes than were serialized");
    let Some(rest) = bytes.strip_prefix(TAG) else {
        return Err(bad("is no state of this unit: it does not begin as a serialized one does"));
    };
    // Before the checksum: what is not known cannot be told from damage.
    let mut head = Reader(rest);
    let format = u32::from_le_bytes(head.array().ok_or_else(damaged)?);
    if format != FORMAT {
        return Err(FmiError::BadBytes(format!("is of format {format}, this unit reads {FORMAT}")));
    }
    let (body, checksum) = bytes.split_last_chunk().ok_or_else(damaged)?;
    if crc32fast::hash(body) != u32::from_le_bytes(*checksum) {
        return Err(damaged());
    }
    let body = body.get(bytes.len() - head.0.len()..).ok_or_else(damaged)?;
    let mut reader = Reader(body);
    let guid = reader.text().ok_or_else(damaged)?;
    let own = S::UNIT;
    if guid != own.guid {
        let problem = match [&WHEEL, &WHEELSET].into_iter().find(|unit| unit.guid == guid) {
            Some(other) => format!("is of {}, this unit is {}", other.identifier, own.identifier),
            None => format!("is of a unit with GUID \"{guid}\", this one has \"{}\"", own.guid),
        };
        return Err(FmiError::BadBytes(problem));
    }
    reader.snapshot().filter(|_| reader.0.is_empty()).ok_or_else(damaged)
}

/// What is left to be read.
struct Reader<'a>(&'a [u8]);

impl<'a> Reader<'a> {
    fn array<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (first, rest) = self.0.split_first_chunk()?;
        self.0 = rest;
        Some(*first)
    }

    fn real(&mut self) -> Option<f64> {
        self.array().map(f64::from_le_bytes)
    }

    fn boolean(&mut self) -> Option<bool> {
        match self.array()? {
            [0] => Some(false),
            [1] => Some(true),
            _ => None,
        }
    }

    fn text(&mut self) -> Option<&'a str> {
        let length = u32::from_le_bytes(self.array()?) as usize;
        let (text, rest) = self.0.split_at_checked(length)?;
        self.0 = rest;
        std::str::from_utf8(text).ok()
    }

    fn wear(&mut self) -> Option<WearState> {
        let clock = self.amount()?;
        if !self.boolean()? {
            return None;
        }
        let wheel = self.arc()?;
        let mut rails = [const { None }; RAILS];
        for rail in &mut rails {
            if self.boolean()? {
                *rail = Some(self.arc()?);
            }
        }
        Some(WearState { clock, wheel, rails })
    }

    /// What a profile has lost.
    fn arc(&mut self) -> Option<ArcState> {
        let count = u32::from_le_bytes(self.array()?) as usize;
        // No more room than there are bytes for.
        if count > self.0.len() / 16 {
            return None;
        }
        let mut column = || (0..count).map(|_| self.amount()).collect::<Option<Vec<f64>>>();
        let (total, pending) = (column()?, column()?);
        let [volume, pending_area, most_pending] = [self.amount()?, self.amount()?, self.amount()?];
        Some(ArcState { total, pending, volume, pending_area, most_pending })
    }

    /// A finite number that is not negative.
    fn amount(&mut self) -> Option<f64> {
        self.real().filter(|number| number.is_finite() && *number >= 0.0)
    }

    fn finite(&mut self) -> Option<f64> {
        self.real().filter(|number| number.is_finite())
    }

    fn last_step(&mut self) -> Option<LastStep> {
        let duration = self.amount()?;
        let mut pairs = [[0.0; 2]; MOST_PAIRS];
        for number in pairs.as_flattened_mut() {
            *number = self.finite()?;
        }
        Some(LastStep { duration, pairs })
    }

    fn memory(&mut self) -> Option<Memory> {
        let fallbacks = u64::from_le_bytes(self.array()?);
        let track = if self.boolean()? { Some(self.track()?) } else { None };
        let wear = if self.boolean()? { Some(self.wear()?) } else { None };
        Some(Memory { fallbacks, wear, track })
    }

    /// Where rails with a mass are.
    fn track(&mut self) -> Option<TrackState> {
        let deflection = [self.finite()?, self.finite()?];
        let velocity = [self.finite()?, self.finite()?];
        Some(TrackState { deflection, velocity, step_error: self.amount()? })
    }

    /// Everything after the head; every value is one that could have been set.
    fn snapshot<S: Described>(&mut self) -> Option<Snapshot<S>> {
        let purpose = if self.boolean()? { Purpose::CoSimulation } else { Purpose::ModelExchange };
        let [life] = self.array()?;
        let state = *STATES.get(usize::from(life))?;
        let of_the_other = match purpose {
            Purpose::ModelExchange => state == State::Stepping,
            Purpose::CoSimulation => matches!(state, State::EventMode | State::ContinuousTime),
        };
        let (prepared, evaluated) = (self.boolean()?, self.boolean()?);
        let (planned, stops) = (self.boolean()?, self.boolean()?);
        let [start, stop, time] = [self.real()?, self.real()?, self.real()?];
        if ![start, stop, time].iter().all(|number| number.is_finite()) {
            return None;
        }
        // An element is there from the end of initialization on.
        let early = matches!(state, State::Instantiated | State::Initialization);
        if of_the_other || !(early || prepared) {
            return None;
        }
        let mut values = ValuesOf::<S>::default();
        for variable in calculated::<S>() {
            let height = self.finite()?;
            values.write(variable, Value::Real(height));
        }
        for variable in settable::<S>() {
            let value = match variable.kind {
                Kind::Real => Value::Real(self.real()?),
                Kind::Integer | Kind::Enumeration(_) => {
                    Value::Integer(i32::from_le_bytes(self.array()?))
                }
                Kind::Boolean => Value::Boolean(self.boolean()?),
                Kind::Text => Value::Text(self.text()?),
            };
            values.set(variable, value).ok()?;
        }
        let mut extrapolation = Extrapolation::new(S::UNIT);
        for _ in 0..u32::from_le_bytes(self.array()?) {
            let reference = u32::from_le_bytes(self.array()?);
            for order in 1..=ORDERS {
                extrapolation.set(S::UNIT, &[reference], &[order as i32], &[self.real()?]).ok()?;
            }
        }
        let last_step = if self.boolean()? { Some(self.last_step()?) } else { None };
        values.coupling.energy_residual = self.finite()?;
        let mut held = Held::new::<S>();
        let numbers = held.values().map(|_| self.array().map(i32::from_le_bytes));
        let numbers: Vec<i32> = numbers.collect::<Option<_>>()?;
        held.set(numbers.into_iter());
        let mut memories: [Memory; MOST_ELEMENTS] = Default::default();
        for memory in memories.iter_mut().take(S::PREFIXES.len()) {
            *memory = self.memory()?;
        }
        Some(Snapshot {
            purpose,
            state,
            prepared,
            last_step,
            held,
            memories,
            outputs: if evaluated { Outputs::LeftOut } else { Outputs::Stale },
            values,
            extrapolation,
            experiment: planned.then_some(Experiment { start, stop: stops.then_some(stop) }),
            time,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::Element;
    use crate::fmi::instance::Instance;
    use crate::fmi::interface::Interface;
    use crate::fmi::logger::Logger;
    use crate::wheelset::Wheelset;

    fn saved<S: Described>() -> Snapshot<S> {
        let mut instance = Instance::<S>::new(Interface::V2, Purpose::CoSimulation, Vec::new());
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
        assert!(
            message(&write(&saved::<Wheelset>()))
                .contains("is of WheelSet, this unit is WheelRail")
        );
        let error = read::<Wheelset>(&bytes).unwrap_err().to_string();
        assert!(error.contains("is of WheelRail, this unit is WheelSet"), "{error}");
    }
}
