//! Model exchange: modes, event indicator, no states.

use std::ptr::{null, null_mut};

use wheelrail::fmi::v3::types::{FALSE, Status, TRUE};
use wheelrail::fmi::v3::*;

use crate::host3::Host3;

#[test]
fn whole_numbers_change_at_events_alone() {
    let host = Host3::in_event_mode();
    let c = host.component;
    assert_eq!(host.step(0.0, 1e-3), Status::Error);
    assert!(host.last().contains("the instance is for model exchange"), "{}", host.last());
    let (mut flags, mut next) = ([TRUE; 5], 1.0);
    let [need, end, nominals, values, defined] = flags.each_mut().map(|flag| &raw mut *flag);
    // SAFETY: FMI 3.0, 2.3.5: pointers to one value each.
    let updated =
        unsafe { fmi3UpdateDiscreteStates(c, need, end, nominals, values, defined, &raw mut next) };
    assert_eq!((updated, flags), (Status::Ok, [FALSE; 5]));
    assert_eq!(fmi3EnterContinuousTimeMode(c), Status::Ok);
    assert_eq!(fmi3SetTime(c, 0.5), Status::Ok);
    let indicator = || {
        let mut value = 0.0;
        // SAFETY: FMI 3.0, 3.2.1: an array of one element.
        assert_eq!(unsafe { fmi3GetEventIndicators(c, &raw mut value, 1) }, Status::Ok);
        assert!(host.reads("event_indicator", value));
        value as i32
    };
    assert!(host.reads("time", 0.5));
    assert_eq!(indicator(), 1);
    // Lifted off the rail.
    assert_eq!(host.set_reals(&[("wheel.z", -0.465)]), Status::Ok);
    assert_eq!(indicator(), -1);
    assert_eq!(host.get_reals(&["wheel.force.z", "patch.normal_force"], 9), Ok(vec![0.0; 9]));
    let held = host.get_integers(&["patch_count", "patch.rail"], 9).unwrap();
    assert_eq!(held[..2], [1, 1]);
    assert_eq!(fmi3EnterEventMode(c), Status::Ok);
    assert_eq!(host.get_integers(&["patch_count", "patch.rail"], 9), Ok(vec![0; 9]));
    assert_eq!(fmi3EnterContinuousTimeMode(c), Status::Ok);
    assert_eq!(indicator(), 1);
    let (mut enter, mut end) = (TRUE, TRUE);
    // SAFETY: FMI 3.0, 3.2.1: pointers to one boolean each.
    let done = unsafe { fmi3CompletedIntegratorStep(c, TRUE, &raw mut enter, &raw mut end) };
    assert_eq!((done, enter, end), (Status::Ok, FALSE, FALSE));
    assert_eq!(fmi3Terminate(c), Status::Ok);
}

#[test]
fn there_are_no_continuous_states() {
    let host = Host3::in_event_mode();
    let c = host.component;
    let (mut states, mut indicators, mut value) = (7, 7, 0.0);
    // SAFETY: FMI 3.0, 2.3.2 and 3.2.1: pointers to one size each, arrays of as many elements as
    // their counts say.
    unsafe {
        assert_eq!(fmi3GetNumberOfContinuousStates(c, &raw mut states), Status::Ok);
        assert_eq!(fmi3GetNumberOfEventIndicators(c, &raw mut indicators), Status::Ok);
        assert_eq!((states, indicators), (0, 1));
        assert_eq!(fmi3EnterContinuousTimeMode(c), Status::Ok);
        assert_eq!(fmi3SetContinuousStates(c, null(), 0), Status::Ok);
        assert_eq!(fmi3GetContinuousStates(c, null_mut(), 0), Status::Ok);
        assert_eq!(fmi3GetContinuousStateDerivatives(c, null_mut(), 0), Status::Ok);
        assert_eq!(fmi3GetNominalsOfContinuousStates(c, null_mut(), 0), Status::Ok);
        assert_eq!(fmi3GetContinuousStates(c, &raw mut value, 1), Status::Error);
        assert!(host.last().contains("nContinuousStates = 1"), "{}", host.last());
        assert_eq!(fmi3GetEventIndicators(c, null_mut(), 0), Status::Error);
        assert!(host.last().contains("nEventIndicators = 0"), "{}", host.last());
    }
}
