//! What writer and reader of a state have to agree on.

use crate::fmi::life_cycle::State;
use crate::variables::{Causality, Described, Variable};

pub(super) const TAG: &[u8] = b"wheelrail state";

/// To be counted up when the layout changes; a change of variables shows in the GUID.
pub(super) const FORMAT: u32 = 6;

pub(super) const STATES: [State; 6] = [
    State::Instantiated,
    State::Initialization,
    State::Stepping,
    State::EventMode,
    State::ContinuousTime,
    State::Terminated,
];

/// Heights of first touch.
pub(super) fn calculated<S: Described>() -> impl Iterator<Item = &'static Variable> {
    S::UNIT.variables.iter().filter(|v| v.causality == Causality::CalculatedParameter)
}

/// Of outputs that are evaluated and held.
pub(super) const HELD: u8 = 2;

/// Outputs of an evaluation.
pub(super) fn outputs<S: Described>() -> impl Iterator<Item = &'static Variable> {
    S::UNIT.variables.iter().filter(|v| v.causality == Causality::Output && !v.on_request)
}

/// Inputs and parameters.
pub(super) fn settable<S: Described>() -> impl Iterator<Item = &'static Variable> {
    S::UNIT.variables.iter().filter(|v| v.is_settable())
}
