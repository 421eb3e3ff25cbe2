//! Calls of FMI 3.0 that are refused in a way of their own.

use std::ptr::null_mut;

use super::{Host, Path, as_cell, compare, rows};
use crate::host3::{Arguments3, Host3};
use wheelrail::fmi::v3::types::{FALSE, Status, TRUE};
use wheelrail::fmi::v3::*;
use wheelrail::variables::WHEEL;

/// The message of an instance that is not made.
fn not_made(change: impl FnOnce(&mut Arguments3)) -> String {
    let mut arguments = Arguments3::of(&WHEEL);
    change(&mut arguments);
    let host = Host3::instantiate(&WHEEL, &arguments);
    assert!(host.component.is_null());
    host.last()
}

/// The message of a call on an instance, which goes on as before.
fn refused(host: &Host3, call: impl FnOnce(&Host3) -> Status) -> String {
    assert_eq!(call(host), Status::Error);
    let message = host.last();
    let c = host.component;
    assert_eq!(fmi3Reset(c), Status::Ok);
    host.initialize();
    assert_eq!(fmi3ExitInitializationMode(c), Status::Ok);
    assert_eq!(host.step(0.0, 1e-3), Status::Ok, "{message}");
    message
}

fn stepping(call: impl FnOnce(&Host3) -> Status) -> String {
    refused(&Host3::stepping(&WHEEL), call)
}

fn status(read: Result<Vec<f64>, Status>) -> Status {
    read.map_or_else(|status| status, |_| Status::Ok)
}

fn called(words: &str) -> String {
    match words {
        "`fmi3InstantiateCoSimulation` with another token" => {
            not_made(|a| a.token = Some(c"{1-2-3}".into()))
        }
        "`fmi3InstantiateCoSimulation` with event mode" => not_made(|a| a.event_mode_used = TRUE),
        "`fmi3GetFloat64` of an output before initialization" => {
            refused(&Host3::new(&WHEEL), |h| status(h.get_reals(&["wheel.force.z"], 1)))
        }
        "`fmi3GetFloat64` of an array, with room for one value" => {
            stepping(|h| status(h.get_reals(&["patch.area"], 1)))
        }
        "`fmi3GetFloat64` of an element of an array" => stepping(|h| {
            let place = WHEEL.find("patch[2].area").unwrap().reference;
            let (element, mut value) = (u32::try_from(place).unwrap(), 0.0);
            // SAFETY: FMI 3.0, 2.2.6: arrays of one element.
            unsafe { fmi3GetFloat64(h.component, &raw const element, 1, &raw mut value, 1) }
        }),
        "`fmi3SetFloat64` of an array" => stepping(|h| h.set_reals(&[("patch.area", 1.0)])),
        "`fmi3SetInt32` of a choice" => stepping(|h| h.set_integer("normal.model", 1)),
        "`fmi3SetFloat64` of a parameter after initialization" => {
            stepping(|h| h.set_reals(&[("track.gauge", 1.5)]))
        }
        "`fmi3GetDirectionalDerivative` without seeds" => stepping(|h| {
            let (force, z) = (h.reference("wheel.force.z"), h.reference("wheel.z"));
            let (c, mut found) = (h.component, 0.0);
            let (u, k) = (&raw const force, &raw const z);
            // SAFETY: FMI 3.0, 2.2.11: arrays of as many elements as their counts say.
            unsafe { fmi3GetDirectionalDerivative(c, u, 1, k, 1, null_mut(), 0, &raw mut found, 1) }
        }),
        "`fmi3GetClock`" => stepping(|h| {
            let (y, mut active) = (h.reference("wheel.y"), FALSE);
            fmi3GetClock(h.component, &raw const y, 1, &raw mut active)
        }),
        "`fmi3EnterStepMode`" => stepping(|h| fmi3EnterStepMode(h.component)),
        "`fmi3Terminate` of an instance of FMI 2.0" => {
            let host = Host::stepping();
            assert_eq!(fmi3Terminate(host.component), Status::Error);
            host.last()
        }
        _ => panic!("{words}: unknown"),
    }
}

#[test]
fn calls_of_fmi_3() {
    let said = rows("Calls of FMI 3.0").into_iter().map(|row| {
        let message = called(&row[0]);
        (row, as_cell(&message, Path::new("/nowhere")))
    });
    compare("Calls of FMI 3.0", &said.collect::<Vec<_>>());
}
