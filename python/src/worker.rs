//! What a thread evaluates rows with, and what it has to tell of them.

use std::collections::HashMap;
use std::collections::hash_map::Entry;

use wheelrail::element::{Remark, place_remark, remarks};
use wheelrail::error::ContactError;
use wheelrail::variables::{Kind, ValuesOf};

use crate::subjects::InBulk;

/// States of a row.
pub const FINE: u8 = 0;
pub const REFUSED: u8 = 1;
pub const SUNK: u8 = 2;

/// What a thread has for its own.
pub struct Worker<S: InBulk> {
    pub subject: S,
    pub values: ValuesOf<S>,
    pub rates: Vec<S::Output>,
    pub told: Told,
}

impl<S: InBulk> Worker<S> {
    /// Evaluates the inputs as they are, fills `numbers` with the outputs and keeps what is to be
    /// told of the row; its state.
    pub fn evaluate(
        &mut self,
        row: usize,
        readers: &[Reader],
        numbers: &mut [f64],
    ) -> Result<u8, ContactError> {
        let Self { subject, values, told, .. } = self;
        for element in subject.elements_mut() {
            // What a row gives must not depend on those before it.
            element.set_fallbacks(0);
        }
        subject.evaluate_all(&values.input, &mut values.output)?;
        for (number, read) in numbers.iter_mut().zip(readers) {
            *number = read.of(values);
        }
        let mut tell = |k: usize, remark: Remark| {
            let (_, _, rows) = told.entry((remark.kind(), k)).or_insert_with(|| {
                let message = remark.message(S::PREFIXES[k]).to_string();
                (remark.title(), message, Vec::new())
            });
            rows.push(row);
        };
        let ValuesOf { parameters, input, output, .. } = &*values;
        remarks(subject, parameters, input, output, &mut tell);
        place_remark(subject, parameters, input, output, &mut tell);
        let sunk = subject.elements().iter().any(|element| element.sunk().is_some());
        Ok(if sunk { SUNK } else { FINE })
    }
}

/// A remark: title, side, message of the first row, and all rows that have it.
pub type Message = (&'static str, &'static str, String, Vec<usize>);

/// Remarks by kind and element.
pub type Told = HashMap<(usize, usize), (&'static str, String, Vec<usize>)>;

/// Remarks in the order of their kinds.
pub fn sorted<S: InBulk>(told: Told) -> Vec<Message> {
    let mut told: Vec<_> = told.into_iter().collect();
    told.sort_unstable_by_key(|(kind, _)| *kind);
    let message = |((_, k), (title, message, mut rows)): ((usize, usize), (_, _, Vec<usize>))| {
        rows.sort_unstable();
        (title, S::PREFIXES[k], message, rows)
    };
    told.into_iter().map(message).collect()
}

/// Adds what another thread has found; the message is that of the first row.
pub fn join(told: &mut Told, other: Told) {
    for (kind, (title, message, rows)) in other {
        match told.entry(kind) {
            Entry::Vacant(free) => _ = free.insert((title, message, rows)),
            Entry::Occupied(mut own) => {
                let own = own.get_mut();
                if rows.iter().min() < own.2.iter().min() {
                    own.1 = message;
                }
                own.2.extend(rows);
            }
        }
    }
}

/// How the number of an output is read; its type is looked up once.
pub enum Reader {
    Real(usize),
    Integer(usize),
}

impl Reader {
    pub fn of<S: InBulk>(&self, values: &ValuesOf<S>) -> f64 {
        let found = match *self {
            Self::Real(reference) => S::real(values, reference),
            Self::Integer(reference) => S::integer(values, reference).map(f64::from),
        };
        found.unwrap_or(f64::NAN)
    }
}

pub fn readers<S: InBulk>(outputs: &[usize]) -> Vec<Reader> {
    let reader = |&reference: &usize| match S::UNIT.variables[reference].kind {
        Kind::Real => Reader::Real(reference),
        _ => Reader::Integer(reference),
    };
    outputs.iter().map(reader).collect()
}
