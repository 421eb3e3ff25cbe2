//! The state of bytes, checked.

use super::layout::{FORMAT, HELD, STATES, TAG, calculated, outputs, settable};
use crate::element::parameters::RAILS;
use crate::element::work_pairs::MAX_PAIRS;
use crate::element::{ContactHistory, TrackState, WearState};
use crate::fmi::coupling::LastStep;
use crate::fmi::error::FmiError;
use crate::fmi::extrapolation::{Extrapolation, ORDERS};
use crate::fmi::held::Held;
use crate::fmi::life_cycle::{Experiment, Purpose, State};
use crate::fmi::snapshot::{MAX_ELEMENTS, Memory, Outputs, Snapshot};
use crate::variables::{Described, Kind, Value, ValuesOf, WHEEL, WHEELSET};
use crate::wear::ArcState;

/// The state of bytes.
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
        let mut pairs = [[0.0; 2]; MAX_PAIRS];
        for number in pairs.as_flattened_mut() {
            *number = self.finite()?;
        }
        Some(LastStep { duration, pairs })
    }

    fn memory(&mut self) -> Option<Memory> {
        let fallbacks = u64::from_le_bytes(self.array()?);
        let track = if self.boolean()? { Some(self.track()?) } else { None };
        let contact = if self.boolean()? { Some(self.contact()?) } else { None };
        let wear = if self.boolean()? { Some(self.wear()?) } else { None };
        Some(Memory { fallbacks, wear, track, contact })
    }

    /// What contacts remember.
    fn contact(&mut self) -> Option<ContactHistory> {
        let count = u32::from_le_bytes(self.array()?) as usize;
        // No more room than there are bytes for.
        if count > self.0.len() / 8 {
            return None;
        }
        let numbers = (0..count).map(|_| self.real()).collect::<Option<Vec<f64>>>()?;
        ContactHistory::from_numbers(&numbers).ok()
    }

    /// Where rails with a mass are.
    fn track(&mut self) -> Option<TrackState> {
        let deflection = [self.finite()?, self.finite()?];
        let velocity = [self.finite()?, self.finite()?];
        Some(TrackState { deflection, velocity, step_error: self.amount()? })
    }

    /// Outputs that are held.
    fn outputs<S: Described>(&mut self, values: &mut ValuesOf<S>) -> Option<()> {
        for variable in outputs::<S>() {
            match variable.kind {
                Kind::Real => {
                    let value = self.finite()?;
                    *S::output_slot(values, variable.reference)? = value;
                }
                Kind::Integer | Kind::Enumeration(_) => {
                    let value = i32::from_le_bytes(self.array()?);
                    S::set_integer(values, variable.reference, value);
                }
                Kind::Boolean | Kind::Text => {}
            }
        }
        Some(())
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
        let prepared = self.boolean()?;
        let [evaluated] = self.array()?;
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
        let mut memories: [Memory; MAX_ELEMENTS] = Default::default();
        for memory in memories.iter_mut().take(S::PREFIXES.len()) {
            *memory = self.memory()?;
        }
        let outputs = match evaluated {
            0 => Outputs::Stale,
            1 => Outputs::LeftOut,
            HELD => {
                self.outputs(&mut values)?;
                Outputs::Evaluated
            }
            _ => return None,
        };
        Some(Snapshot {
            purpose,
            state,
            prepared,
            last_step,
            held,
            memories,
            outputs,
            values,
            extrapolation,
            experiment: planned.then_some(Experiment { start, stop: stops.then_some(stop) }),
            time,
            dummy_state: None,
        })
    }
}
