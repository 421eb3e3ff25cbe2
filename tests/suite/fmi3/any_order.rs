//! Calls in any order, with any references, values and counts: refused or answered, never an
//! internal fault.

use std::ptr::null_mut;

use wheelrail::fmi::v3::types::{FALSE, FmuState, Status, TRUE, ValueReference};
use wheelrail::fmi::v3::*;
use wheelrail::variables::{Causality, Unit, WHEEL, WHEELSET};

use crate::common::random::Random;
use crate::host3::{Arguments3, Host3};

/// A number from 0 to `below`, that one left out.
fn number(random: &mut Random, below: usize) -> usize {
    (random.within(0.0, below as f64) as usize).min(below - 1)
}

/// References that are mostly of something, and how many elements they have.
fn references(unit: &Unit, random: &mut Random) -> (Vec<ValueReference>, usize) {
    let all = unit.variables;
    let mut count = 0;
    let references = (0..number(random, 5))
        .map(|_| {
            let place = number(random, all.len() + 3);
            count += all.get(place).map_or(1, |v| v.elements.len());
            place as ValueReference
        })
        .collect();
    // Now and then one too many.
    (references, count + usize::from(number(random, 20) == 0))
}

/// A value near that of an input, or anything.
fn value(unit: &Unit, reference: ValueReference, random: &mut Random) -> f64 {
    let variable = unit.variables.get(reference as usize);
    let start = variable.filter(|v| v.causality == Causality::Input).and_then(|v| v.start);
    match (start, number(random, 12)) {
        (_, 0) => f64::NAN,
        (_, 1) => random.about(1e9),
        (Some(wheelrail::variables::Value::Real(start)), _) => start + random.about(0.01),
        _ => random.about(1.0),
    }
}

fn call(host: &Host3, states: &mut Vec<FmuState>, random: &mut Random) -> Status {
    let (c, unit) = (host.component, host.unit);
    let (r, count) = references(unit, random);
    let (k, known_count) = references(unit, random);
    let mut reals: Vec<f64> = (0..count).map(|_| random.about(1.0)).collect();
    for (real, reference) in reals.iter_mut().zip(&r) {
        *real = value(unit, *reference, random);
    }
    let (start, n) = (r.as_ptr(), r.len());
    let (mut wide, mut whole) = (vec![0i64; count], vec![0i32; count]);
    let state = states.get(number(random, states.len() + 1)).copied().unwrap_or(null_mut());
    // SAFETY: FMI 3.0, 2.2: all arrays hold as many elements as their counts say.
    unsafe {
        match number(random, 26) {
            0 => fmi3EnterInitializationMode(c, FALSE, 0.0, random.about(2.0), FALSE, 0.0),
            1 | 2 => fmi3ExitInitializationMode(c),
            3 if number(random, 8) == 0 => fmi3Terminate(c),
            4 if number(random, 8) == 0 => fmi3Reset(c),
            5 | 6 => host.step(random.within(0.0, 1.0), random.within(-1e-4, 1e-3)),
            7 => fmi3EnterEventMode(c),
            8 => fmi3EnterContinuousTimeMode(c),
            9 => fmi3SetTime(c, random.about(1.0)),
            10 => fmi3GetInt32(c, start, n, whole.as_mut_ptr(), count),
            11 => fmi3GetInt64(c, start, n, wide.as_mut_ptr(), count),
            12 => {
                let model = host.reference("creepage.model");
                fmi3SetInt64(c, &raw const model, 1, &((number(random, 5)) as i64), 1)
            }
            13 => {
                let mut new = state;
                let status = fmi3GetFMUState(c, &raw mut new);
                if status == Status::Ok && new != state {
                    states.push(new);
                }
                status
            }
            14 => fmi3SetFMUState(c, state),
            15 => {
                let seed: Vec<f64> = (0..known_count).map(|_| random.about(1.0)).collect();
                let (k, kn, seed) = (k.as_ptr(), k.len(), seed.as_ptr());
                let out = reals.as_mut_ptr();
                fmi3GetDirectionalDerivative(c, start, n, k, kn, seed, known_count, out, count)
            }
            16 => fmi3GetEventIndicators(c, reals.as_mut_ptr(), count),
            17 => fmi3GetString(c, start, n, vec![std::ptr::null(); count].as_mut_ptr(), count),
            18 => fmi3GetBoolean(c, start, n, vec![TRUE; count].as_mut_ptr(), count),
            19..=22 => fmi3SetFloat64(c, start, n, reals.as_ptr(), count),
            _ => {
                let status = fmi3GetFloat64(c, start, n, reals.as_mut_ptr(), count);
                assert!(status > Status::Warning || reals.iter().all(|v| v.is_finite()), "{r:?}");
                status
            }
        }
    }
}

fn in_any_order(unit: &'static Unit, calls: usize) {
    let mut random = Random::new(26);
    let mut answered = 0;
    for exchange in [false, true] {
        let arguments = Arguments3 { exchange, ..Arguments3::of(unit) };
        let host = Host3::instantiate(unit, &arguments);
        let mut states = Vec::new();
        for _ in 0..calls {
            let status = call(&host, &mut states, &mut random);
            assert!(status <= Status::Error && status != Status::Discard);
            answered += usize::from(status <= Status::Warning);
            let mut messages = host.messages.lock().unwrap();
            assert!(!messages.iter().any(|m| m.2.contains("internal fault")), "{messages:?}");
            messages.clear();
        }
    }
    assert!(answered > calls / 4, "{answered} of {} calls were answered", 2 * calls);
}

#[test]
fn calls_on_a_wheel_in_any_order_do_no_harm() {
    in_any_order(&WHEEL, 6000);
}

#[test]
fn calls_on_a_wheelset_in_any_order_do_no_harm() {
    in_any_order(&WHEELSET, 2000);
}
