//! The unit as model exchange: its modes, the same forces as in co-simulation, and what belongs to
//! the other type.
#![allow(unsafe_code)]

use std::ptr::{null, null_mut};

use crate::host::{Arguments, Host};
use wheelrail::fmi::v2::types::{EventInfo, FALSE, Status, TRUE};
use wheelrail::fmi::v2::*;

const PRESSED: [(&str, f64); 5] = [
    ("wheel.z", -0.4597),
    ("wheel.y", 0.751),
    ("wheel.vx", 20.0),
    ("wheel.pitch_rate", -43.4),
    ("wheel.yaw", 0.01),
];
const FORCES: [&str; 4] = ["wheel.force.x", "wheel.force.y", "wheel.force.z", "wheel.moment.y"];

#[test]
fn forces_are_those_of_co_simulation_in_every_mode() {
    let (host, stepped) = (Host::in_event_mode(), Host::stepping());
    let c = host.component;
    assert_eq!(stepped.set_reals(&PRESSED), Status::Ok);
    let wanted = stepped.get_reals(&FORCES).unwrap();
    assert_eq!(host.set_reals(&PRESSED), Status::Ok);
    assert_eq!(host.get_reals(&FORCES), Ok(wanted.clone()));
    assert_eq!(fmi2EnterContinuousTimeMode(c), Status::Ok);
    assert_eq!(fmi2SetTime(c, 0.75), Status::Ok);
    assert_eq!(host.set_reals(&[("wheel.y", 0.752)]), Status::Ok);
    assert_ne!(host.get_reals(&FORCES), Ok(wanted.clone()));
    assert_eq!(host.set_reals(&PRESSED), Status::Ok);
    assert_eq!(host.get_reals(&FORCES), Ok(wanted.clone()));
    assert_eq!(fmi2Terminate(c), Status::Ok);
    assert_eq!(host.get_reals(&FORCES), Ok(wanted));
}

#[test]
fn there_are_no_states_and_no_time_events() {
    let host = Host::in_event_mode();
    let c = host.component;
    let dirty = EventInfo { new_discrete_states_needed: TRUE, ..EventInfo::default() };
    let (mut info, mut number) = (dirty, 0.0);
    // SAFETY: FMI 2.0, 3.2.2: a pointer to one event info, arrays of as many elements as their
    // counts say.
    unsafe {
        assert_eq!(fmi2NewDiscreteStates(c, &raw mut info), Status::Ok);
        assert_eq!(info, EventInfo::default());
        assert_eq!(fmi2EnterContinuousTimeMode(c), Status::Ok);
        let (mut enter, mut end) = (TRUE, TRUE);
        let completed = fmi2CompletedIntegratorStep(c, TRUE, &raw mut enter, &raw mut end);
        assert_eq!((completed, enter, end), (Status::Ok, FALSE, FALSE));
        assert_eq!(fmi2GetContinuousStates(c, null_mut(), 0), Status::Ok);
        assert_eq!(fmi2GetNominalsOfContinuousStates(c, null_mut(), 0), Status::Ok);
        assert_eq!(fmi2GetDerivatives(c, null_mut(), 0), Status::Ok);
        assert_eq!(fmi2GetEventIndicators(c, &raw mut number, 1), Status::Ok);
        assert_eq!(number.to_bits(), 1f64.to_bits());
        assert_eq!(fmi2GetEventIndicators(c, null_mut(), 0), Status::Error);
        assert!(host.last().contains("ni = 0"), "{}", host.last());
        assert_eq!(fmi2SetContinuousStates(c, null(), 0), Status::Ok);
        assert_eq!(fmi2GetDerivatives(c, &raw mut number, 1), Status::Error);
        assert!(host.last().contains("nx = 1"), "{}", host.last());
        assert_eq!(fmi2NewDiscreteStates(c, &raw mut info), Status::Error);
        assert!(host.last().contains("call fmi2EnterEventMode first"), "{}", host.last());
        assert_eq!(fmi2EnterEventMode(c), Status::Ok);
        assert_eq!(fmi2NewDiscreteStates(c, null_mut()), Status::Error);
    }
    assert_eq!(fmi2SetTime(c, f64::NAN), Status::Error);
    assert!(host.last().contains("time = NaN"), "{}", host.last());
}

#[test]
fn each_type_refuses_the_calls_of_the_other() {
    let host = Host::in_event_mode();
    assert_eq!(host.step(0.0, 1e-3), Status::Error);
    assert!(host.last().contains("the instance is for model exchange"), "{}", host.last());
    assert_eq!(host.set_reals(&[("track.gauge", 1.5)]), Status::Error);
    assert!(host.last().contains("track.gauge is fixed"), "{}", host.last());
    let stepped = Host::stepping();
    assert_eq!(fmi2EnterEventMode(stepped.component), Status::Error);
    assert!(stepped.last().contains("the instance is for co-simulation"), "{}", stepped.last());
    assert_eq!(fmi2SetTime(stepped.component, 0.0), Status::Error);
    let unknown = Host::instantiate(&Arguments { fmu_type: 2, ..Arguments::default() });
    assert!(unknown.component.is_null());
    assert!(unknown.last().contains("fmuType 2"), "{}", unknown.last());
}

#[test]
fn a_state_keeps_the_mode_and_does_not_go_over_to_the_other_type() {
    let host = Host::in_event_mode();
    let c = host.component;
    assert_eq!(fmi2EnterContinuousTimeMode(c), Status::Ok);
    assert_eq!(host.set_reals(&PRESSED), Status::Ok);
    let (mut state, mut size) = (null_mut(), 0);
    // SAFETY: FMI 2.0, 2.1.8: pointers to one state pointer and one size, arrays of `size` bytes.
    unsafe {
        assert_eq!(fmi2GetFMUstate(c, &raw mut state), Status::Ok);
        assert_eq!(fmi2EnterEventMode(c), Status::Ok);
        assert_eq!(fmi2SetFMUstate(c, state), Status::Ok);
        assert_eq!(fmi2EnterContinuousTimeMode(c), Status::Error);
        assert_eq!(fmi2SerializedFMUstateSize(c, state, &raw mut size), Status::Ok);
        let mut bytes = vec![0; size];
        assert_eq!(fmi2SerializeFMUstate(c, state, bytes.as_mut_ptr(), size), Status::Ok);
        let stepped = Host::stepping();
        let mut copy = null_mut();
        let read = fmi2DeSerializeFMUstate(stepped.component, bytes.as_ptr(), size, &raw mut copy);
        assert_eq!(read, Status::Error);
        assert!(stepped.last().contains("for model exchange"), "{}", stepped.last());
    }
}

/// The event indicator.
fn indicator(host: &Host) -> f64 {
    let mut value = f64::NAN;
    // SAFETY: FMI 2.0, 3.2.2: an array of one element.
    let status = unsafe { fmi2GetEventIndicators(host.component, &raw mut value, 1) };
    assert!(status <= Status::Warning, "{}", host.last());
    value
}

/// Goes through an event as a host does.
fn event(host: &Host) {
    let mut info = EventInfo::default();
    assert_eq!(fmi2EnterEventMode(host.component), Status::Ok);
    // SAFETY: FMI 2.0, 3.2.2: a pointer to one event info.
    unsafe { assert_eq!(fmi2NewDiscreteStates(host.component, &raw mut info), Status::Ok) };
    assert_eq!(info, EventInfo::default());
    assert!(fmi2EnterContinuousTimeMode(host.component) <= Status::Warning);
}

#[test]
fn a_contact_that_begins_is_an_event_at_first_touch() {
    let host = Host::in_event_mode();
    assert_eq!(host.set_reals(&[("wheel.z", -0.462)]), Status::Ok);
    assert_eq!(fmi2EnterContinuousTimeMode(host.component), Status::Ok);
    let at = |z: f64| {
        assert_eq!(host.set_reals(&[("wheel.z", z)]), Status::Ok);
        indicator(&host)
    };
    // As a host finds it between two steps of its integrator.
    let (mut low, mut high) = (-0.462, -0.4597);
    assert!(at(low) > 0.0 && at(high) < 0.0);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if at(middle) > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
        // What is a whole number stays until the event; forces are those of the inputs.
        assert_eq!(host.get_integer("patch_count"), 0);
    }
    assert!(at(-0.4597) < 0.0 && host.get_real("wheel.force.z") < -1e4);
    assert!((high - host.get_real("nominal.wheel_z")).abs() < 1e-9, "{high}");
    assert!(at(high) < 0.0);
    // Within a nanometre of first touch the lines may meet at several places.
    event(&host);
    assert!(host.get_integer("patch_count") > 0 && at(high) > 0.0);
    at(-0.4597);
    event(&host);
    assert_eq!((host.get_integer("patch_count"), host.get_integer("patch[1].rail")), (1, 1));
    assert!(at(-0.45975) > 0.0 && at(-0.4597) > 0.0 && at(low) < 0.0);
    assert_eq!(host.get_integer("patch_count"), 1);
    // A state takes the numbers of its last event with it.
    let mut state = null_mut();
    // SAFETY: FMI 2.0, 2.1.8: a pointer to one state pointer.
    unsafe { assert_eq!(fmi2GetFMUstate(host.component, &raw mut state), Status::Ok) };
    event(&host);
    assert_eq!((host.get_integer("patch_count"), indicator(&host) > 0.0), (0, true));
    assert_eq!(fmi2SetFMUstate(host.component, state), Status::Ok);
    assert_eq!((host.get_integer("patch_count"), indicator(&host) < 0.0), (1, true));
}

#[test]
fn whole_numbers_change_at_events_alone_and_every_change_is_one() {
    let names: Vec<String> = std::iter::once("patch_count".to_owned())
        .chain((1..=8).map(|k| format!("patch[{k}].rail")))
        .collect();
    let numbers = |host: &Host| names.iter().map(|n| host.get_integer(n)).collect::<Vec<_>>();
    let (host, stepped) = (Host::in_event_mode(), Host::stepping());
    assert_eq!(fmi2EnterContinuousTimeMode(host.component), Status::Ok);
    let mut events = 0;
    let mut held = numbers(&host);
    // From the tread to the flange, through two patches, down and up again.
    for i in 0..600 {
        let t = f64::from(i) / 600.0;
        let inputs = [("wheel.y", 0.75 + 8e-3 * t), ("wheel.z", -0.4599 + 2e-4 * (40.0 * t).sin())];
        assert_eq!(host.set_reals(&inputs), Status::Ok);
        assert_eq!(stepped.set_reals(&inputs), Status::Ok);
        let now = numbers(&stepped);
        assert_eq!(indicator(&host) < 0.0, now != held, "{t}: {now:?}, {held:?}");
        assert_eq!(numbers(&host), held);
        if now != held {
            event(&host);
            assert_eq!(numbers(&host), now);
            held = now;
            events += 1;
        }
    }
    assert!(events > 6, "{events}");
}
