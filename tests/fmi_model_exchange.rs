//! The unit as model exchange: its modes, the same forces as in co-simulation, and what belongs to the other type.
#![allow(unsafe_code)]

mod host;

use std::ptr::{null, null_mut};

use host::{Arguments, Host};
use wheelrail::fmi::abi::*;
use wheelrail::fmi::types::{EventInfo, FALSE, Status, TRUE};

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
fn there_are_no_states_and_no_events() {
    let host = Host::in_event_mode();
    let c = host.component;
    let dirty = EventInfo { new_discrete_states_needed: TRUE, ..EventInfo::default() };
    let (mut info, mut number) = (dirty, 0.0);
    // SAFETY: FMI 2.0, 3.2.2: a pointer to one event info, arrays of as many elements as their counts say.
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
        assert_eq!(fmi2GetEventIndicators(c, null_mut(), 0), Status::Ok);
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
