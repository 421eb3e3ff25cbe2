//! Life cycle, handles, arguments, messages, and what the unit has none of.

use std::ffi::{CStr, CString};
use std::ptr::{null, null_mut};

use wheelrail::fmi::v2::{fmi2DoStep, fmi2Reset};
use wheelrail::fmi::v3::types::{Component, FALSE, Status, TRUE};
use wheelrail::fmi::v3::*;
use wheelrail::variables::{WHEEL, WHEELSET};

use crate::host::Host;
use crate::host3::{Arguments3, Host3};

#[test]
fn the_version_is_that_of_the_standard() {
    // SAFETY: FMI 3.0, 2.2.5: a static null-terminated text.
    assert_eq!(unsafe { CStr::from_ptr(fmi3GetVersion()) }, c"3.0");
}

fn refused(change: impl FnOnce(&mut Arguments3)) -> String {
    let mut arguments = Arguments3::of(&WHEEL);
    // Why there is no instance is told even so.
    arguments.logging_on = FALSE;
    change(&mut arguments);
    let host = Host3::instantiate(&WHEEL, &arguments);
    assert!(host.component.is_null());
    host.last()
}

#[test]
fn an_instance_that_cannot_be_made_is_null_with_the_reason() {
    assert_eq!(
        refused(|a| a.name = None),
        "fmi3InstantiateCoSimulation: argument instanceName is empty"
    );
    assert_eq!(
        refused(|a| a.token = None),
        "fmi3InstantiateCoSimulation: argument instantiationToken is null"
    );
    let message = refused(|a| {
        a.token = Some(c"{1-2-3}".into());
        a.exchange = true;
    });
    assert!(
        message.starts_with("fmi3InstantiateModelExchange: the instantiation token is \"{1-2-3}\""),
        "{message}"
    );
    assert_eq!(
        refused(|a| a.event_mode_used = TRUE),
        "fmi3InstantiateCoSimulation: not supported: modelDescription.xml does not set hasEventMode"
    );
    // SAFETY: FMI 3.0, 2.3.1: null-terminated texts or null.
    let scheduled = unsafe {
        let (name, token) = (c"wheel".as_ptr(), c"{}".as_ptr());
        let none = null_mut();
        fmi3InstantiateScheduledExecution(
            name,
            token,
            null(),
            FALSE,
            TRUE,
            none,
            None,
            None,
            None,
            None,
        )
    };
    assert!(scheduled.is_null());
}

#[test]
fn resources_are_an_absolute_path() {
    let host = Host3::initializing(&WHEEL);
    assert_eq!(host.set_text("wheel.profile", "S1002_worn.txt"), Status::Ok);
    assert_eq!(fmi3ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
    let mut arguments = Arguments3::of(&WHEEL);
    arguments.resources = Some(c"fmu/resources".into());
    let host = Host3::instantiate(&WHEEL, &arguments);
    let messages = host.messages.lock().unwrap().clone();
    let (status, _, text) = &messages[0];
    assert_eq!(*status, Status::Warning);
    assert!(text.contains("resourcePath \"fmu/resources\" is not an absolute path"), "{text}");
}

#[test]
fn a_uri_as_of_fmi_2_is_taken_for_its_path_and_told() {
    for (folder, told) in
        [("fmu/resources", "taken for"), ("nowhere", "names no folder that exists")]
    {
        let uri = format!("file://{}/{folder}", env!("CARGO_MANIFEST_DIR"));
        let mut arguments = Arguments3::of(&WHEEL);
        arguments.resources = Some(CString::new(uri.clone()).unwrap());
        let host = Host3::instantiate(&WHEEL, &arguments);
        let (status, _, text) = host.messages.lock().unwrap()[0].clone();
        assert_eq!(status, Status::Warning);
        assert!(text.contains(&format!("resourcePath \"{uri}\"")) && text.contains(told), "{text}");
        host.initialize();
        assert_eq!(host.set_text("wheel.profile", "S1002_worn.txt"), Status::Ok);
        let found = fmi3ExitInitializationMode(host.component) == Status::Ok;
        assert_eq!(found, folder == "fmu/resources", "{}", host.last());
    }
}

#[test]
fn a_run_goes_through_its_states_and_back() {
    let host = Host3::new(&WHEEL);
    let c = host.component;
    assert_eq!(host.step(0.0, 1e-3), Status::Error);
    assert!(host.last().contains("call fmi3EnterInitializationMode first"), "{}", host.last());
    assert_eq!(fmi3Terminate(c), Status::Error);
    // What has a start value can be read, what is computed not yet.
    assert_eq!(host.get_reals(&["track.gauge", "wheel.y"], 2), Ok(vec![1.435, 0.75]));
    assert_eq!(host.get_reals(&["wheel.force.z"], 1), Err(Status::Error));
    assert!(host.last().contains("fmi3GetFloat64: not allowed before init"), "{}", host.last());
    let stops_first = fmi3EnterInitializationMode(c, FALSE, 0.0, 1.0, TRUE, 0.5);
    assert_eq!(stops_first, Status::Error);
    assert!(host.last().contains("stopTime = 0.5"), "{}", host.last());
    assert_eq!(fmi3EnterInitializationMode(c, TRUE, 1e-4, 0.25, TRUE, 1.0), Status::Ok);
    assert_eq!(host.step(0.25, 1e-3), Status::Error);
    assert!(host.last().contains("call fmi3ExitInitializationMode first"), "{}", host.last());
    assert!(host.get_real("nominal.wheel_z") < -0.4597);
    assert!(host.reads("time", 0.25));
    assert_eq!(fmi3ExitInitializationMode(c), Status::Ok);
    assert_eq!(host.step_to(0.25, 0.5), (Status::Ok, [FALSE; 3], 0.75));
    assert!(host.reads("time", 0.75));
    assert_eq!(host.step(0.75, 0.5), Status::Error);
    assert!(host.last().contains("1.25 s, after the stop time of 1 s"), "{}", host.last());
    assert_eq!(host.step(0.75, -1.0), Status::Error);
    assert!(host.last().contains("communicationStepSize = -1"), "{}", host.last());
    assert_eq!(host.set_reals(&[("track.gauge", 1.5)]), Status::Error);
    assert_eq!(
        host.last(),
        "fmi3SetFloat64: track.gauge is fixed after initialization: call fmi3Reset to change it"
    );
    assert_eq!(fmi3EnterEventMode(c), Status::Error);
    assert!(host.last().contains("the instance is for co-simulation"), "{}", host.last());
    assert_eq!(fmi3Terminate(c), Status::Ok);
    assert!(host.get_real("wheel.force.z") < 0.0);
    assert_eq!(host.step(0.75, 1e-3), Status::Error);
    assert!(host.last().contains("not allowed after fmi3Terminate"), "{}", host.last());
    assert_eq!(fmi3Reset(c), Status::Ok);
    assert_eq!(host.set_reals(&[("track.gauge", 1.5)]), Status::Ok);
    host.initialize();
    assert_eq!(fmi3ExitInitializationMode(c), Status::Ok);
    assert_eq!(host.step(0.0, 1e-3), Status::Ok);
}

#[test]
fn a_step_without_room_for_its_answers_is_not_made() {
    let host = Host3::stepping(&WHEEL);
    let (mut flags, mut time) = ([FALSE; 3], 0.0);
    let [event, end, _] = flags.each_mut().map(|flag| &raw mut *flag);
    // SAFETY: FMI 3.0, 4.2.1: pointers to one value each, or null, which is refused.
    let status = unsafe {
        fmi3DoStep(host.component, 0.0, 1e-3, TRUE, event, end, null_mut(), &raw mut time)
    };
    assert!(status == Status::Error && host.reads("time", 0.0));
    assert!(host.last().contains("argument earlyReturn is null"), "{}", host.last());
}

#[test]
fn logging_that_is_off_is_silence_until_it_is_turned_on() {
    let arguments = Arguments3 { logging_on: FALSE, ..Arguments3::of(&WHEEL) };
    let host = Host3::instantiate(&WHEEL, &arguments);
    assert_eq!(host.set_reals(&[("wheel.y", f64::NAN)]), Status::Error);
    assert_eq!(host.messages.lock().unwrap().len(), 0);
    let category = c"logStatusError".as_ptr();
    // SAFETY: FMI 3.0, 2.3.1: an array of one null-terminated text.
    let on = unsafe { fmi3SetDebugLogging(host.component, TRUE, 1, &raw const category) };
    assert_eq!((on, fmi3Reset(host.component)), (Status::Ok, Status::Ok));
    assert_eq!(host.set_reals(&[("wheel.y", f64::NAN)]), Status::Error);
    // Not a format: percent signs stand as they are.
    assert_eq!(host.set_text("wheel.profile", "100%"), Status::Ok);
    host.initialize();
    assert_eq!(fmi3ExitInitializationMode(host.component), Status::Error);
    let messages = host.messages.lock().unwrap().clone();
    assert_eq!(messages.len(), 2, "{messages:?}");
    assert_eq!(messages[0].1, "logStatusError");
    assert!(messages[0].2.contains("wheel.y = NaN"), "{messages:?}");
    assert!(messages[1].2.contains("\"100%\""), "{messages:?}");
}

#[test]
fn handles_of_others_do_no_harm() {
    let freed = Host3::stepping(&WHEEL).component;
    let forged: Component = std::ptr::without_provenance_mut(77);
    for handle in [null_mut(), freed, forged] {
        assert_eq!(fmi3Reset(handle), Status::Error);
        fmi3FreeInstance(handle);
    }
    // Instances of one interface are not for functions of the other.
    let (old, new) = (Host::stepping(), Host3::stepping(&WHEELSET));
    assert_eq!(fmi2Reset(new.component), Status::Error);
    assert_eq!(
        new.last(),
        "fmi2Reset: the instance was made through FMI 3.0: call the functions that begin with fmi3"
    );
    assert_eq!(fmi2DoStep(new.component, 0.0, 1e-3, 1), Status::Error);
    assert_eq!(fmi3Terminate(old.component), Status::Error);
    assert!(
        old.last().contains("fmi3Terminate: the instance was made through FMI 2.0"),
        "{}",
        old.last()
    );
    assert_eq!((new.step(0.0, 1e-3), old.step(0.0, 1e-3)), (Status::Ok, Status::Ok));
}

#[test]
fn what_the_unit_has_none_of_is_refused_with_the_reason() {
    let host = Host3::stepping(&WHEEL);
    let (c, y) = (host.component, host.reference("wheel.y"));
    let says = |status: Status, words: &str| {
        assert_eq!(status, Status::Error, "{words}");
        assert!(host.last().contains(words), "{} for {words}", host.last());
    };
    let (mut flag, mut number, mut counter, mut qualifier) = (FALSE, 0.0, 0, 0);
    says(fmi3GetClock(c, &raw const y, 1, &raw mut flag), "fmi3GetClock: the unit has no clocks");
    says(fmi3SetClock(c, &raw const y, 1, &raw const flag), "no clocks");
    let q = &raw mut qualifier;
    says(fmi3GetIntervalDecimal(c, &raw const y, 1, &raw mut number, q), "no clocks");
    let (counters, resolutions) = (&raw mut counter, &raw mut counter);
    says(fmi3GetIntervalFraction(c, &raw const y, 1, counters, resolutions, q), "no clocks");
    says(fmi3GetShiftDecimal(c, &raw const y, 1, &raw mut number), "no clocks");
    says(fmi3GetShiftFraction(c, &raw const y, 1, counters, resolutions), "no clocks");
    says(fmi3SetIntervalDecimal(c, &raw const y, 1, &raw const number), "no clocks");
    says(fmi3SetIntervalFraction(c, &raw const y, 1, counters, resolutions), "no clocks");
    says(fmi3SetShiftDecimal(c, &raw const y, 1, &raw const number), "no clocks");
    says(fmi3SetShiftFraction(c, &raw const y, 1, counters, resolutions), "no clocks");
    says(fmi3EnterConfigurationMode(c), "no structural parameters");
    says(fmi3ExitConfigurationMode(c), "no structural parameters");
    says(fmi3ActivateModelPartition(c, 0, 0.0), "no scheduled execution");
    says(fmi3EnterStepMode(c), "does not set hasEventMode");
    says(fmi3EvaluateDiscreteStates(c), "providesEvaluateDiscreteStates");
    let mut count = 0;
    let per_element = "providesPerElementDependencies";
    says(fmi3GetNumberOfVariableDependencies(c, y, &raw mut count), per_element);
    let (none, kinds) = (null_mut(), null_mut());
    says(fmi3GetVariableDependencies(c, y, none, null_mut(), none, kinds, 0), per_element);
    let order = 1;
    says(
        fmi3GetOutputDerivatives(c, &raw const y, 1, &raw const order, &raw mut number, 1),
        "maxOutputDerivativeOrder",
    );
    // SAFETY: FMI 3.0, 2.2.6: arrays of one element or none.
    unsafe {
        let (mut short, mut byte, mut size, mut binary) = (0f32, 0i8, 0, null());
        let y = &raw const y;
        says(fmi3GetFloat32(c, y, 1, &raw mut short, 1), "wheel.y is of type Float64: it has its");
        says(fmi3SetFloat32(c, y, 1, &raw const short, 1), "fmi3SetFloat32: wheel.y");
        says(fmi3GetInt8(c, y, 1, &raw mut byte, 1), "wheel.y is of type Float64");
        says(fmi3GetBinary(c, y, 1, &raw mut size, &raw mut binary, 1), "wheel.y is of type");
        says(fmi3SetBinary(c, y, 1, &raw const size, &raw const binary, 1), "wheel.y is of");
        assert_eq!(fmi3GetUInt64(c, null(), 0, null_mut(), 0), Status::Ok);
    }
    assert_eq!(host.step(0.0, 1e-3), Status::Ok);
}
