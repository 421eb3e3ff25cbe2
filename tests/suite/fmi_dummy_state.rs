//! The variant of a unit with a dummy state: its GUID ends in `+state`.
#![allow(unsafe_code)]
// The logger has the address of the host; a state that is set is read back to the bit.
#![allow(clippy::unnecessary_box_returns, clippy::float_cmp)]

use std::ffi::CString;

use wheelrail::fmi::v2::types::{FALSE, MODEL_EXCHANGE, Status};
use wheelrail::fmi::v2::*;
use wheelrail::variables::{STATE_NAME, WHEEL, WITH_STATE, state_references};

use crate::host::{Arguments, Host};

/// A host with an instance of the variant for model exchange, before initialization mode is left.
fn with_state() -> Box<Host> {
    let guid = CString::new(format!("{}{WITH_STATE}", WHEEL.guid)).unwrap();
    let given = Arguments { guid: Some(guid), fmu_type: MODEL_EXCHANGE, ..Arguments::default() };
    let host = Host::instantiate(&given);
    assert!(!host.component.is_null(), "{}", host.last());
    assert_eq!(fmi2SetupExperiment(host.component, FALSE, 0.0, 0.0, FALSE, 0.0), Status::Ok);
    assert_eq!(fmi2EnterInitializationMode(host.component), Status::Ok);
    host
}

#[test]
fn there_is_one_state_whose_derivative_is_0_and_that_changes_no_force() {
    let (host, plain) = (with_state(), Host::in_event_mode());
    let c = host.component;
    let references = state_references(&WHEEL).map(|place| u32::try_from(place).unwrap());
    let mut read = [f64::NAN; 2];
    // SAFETY: FMI 2.0, 2.1.7 and 3.2.2: arrays of as many elements as their counts say, or null
    // with a count that is refused first.
    unsafe {
        assert_eq!(fmi2GetReal(c, references.as_ptr(), 2, read.as_mut_ptr()), Status::Ok);
        assert_eq!(read, [0.0, 0.0]);
        assert_eq!(fmi2SetReal(c, references.as_ptr(), 1, [0.25].as_ptr()), Status::Ok);
        assert_eq!(fmi2SetReal(c, [references[1]].as_ptr(), 1, [1.0].as_ptr()), Status::Error);
        assert_eq!(fmi2ExitInitializationMode(c), Status::Ok);
        assert_eq!(fmi2GetContinuousStates(c, read.as_mut_ptr(), 1), Status::Ok);
        assert_eq!(read[0].to_bits(), 0.25_f64.to_bits());
        assert_eq!(fmi2GetNominalsOfContinuousStates(c, read.as_mut_ptr(), 1), Status::Ok);
        assert_eq!(read[0].to_bits(), 1.0_f64.to_bits());
        assert_eq!(fmi2EnterContinuousTimeMode(c), Status::Ok);
        assert_eq!(fmi2SetContinuousStates(c, [0.5].as_ptr(), 1), Status::Ok);
        assert_eq!(fmi2GetDerivatives(c, read.as_mut_ptr(), 1), Status::Ok);
        assert_eq!(read[0].to_bits(), 0.0_f64.to_bits());
        for count in [0, 2] {
            assert_eq!(fmi2GetDerivatives(c, read.as_mut_ptr(), count), Status::Error);
            let said = format!("argument nx = {count} is not admitted: 1: the dummy state");
            assert!(host.last().contains(&said), "{}", host.last());
        }
        assert_eq!(fmi2SetContinuousStates(c, [f64::NAN].as_ptr(), 1), Status::Error);
        assert!(host.last().contains(STATE_NAME), "{}", host.last());
        assert_eq!(fmi2GetContinuousStates(c, read.as_mut_ptr(), 1), Status::Ok);
        assert_eq!(read[0].to_bits(), 0.5_f64.to_bits());
        // Without it there is none.
        assert_eq!(
            fmi2GetReal(plain.component, references.as_ptr(), 2, read.as_mut_ptr()),
            Status::Error
        );
        assert_eq!(fmi2GetContinuousStates(plain.component, read.as_mut_ptr(), 1), Status::Error);
    }
    let force = host.get_real("wheel.force.z");
    assert_eq!(force.to_bits(), plain.get_real("wheel.force.z").to_bits());
    assert_eq!(fmi2Reset(c), Status::Ok);
    assert_eq!(fmi2SetupExperiment(c, FALSE, 0.0, 0.0, FALSE, 0.0), Status::Ok);
    assert_eq!(fmi2EnterInitializationMode(c), Status::Ok);
    // SAFETY: as above.
    let again = unsafe { fmi2GetReal(c, references.as_ptr(), 2, read.as_mut_ptr()) };
    assert_eq!((again, read), (Status::Ok, [0.0, 0.0]));
}
