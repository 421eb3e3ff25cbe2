//! What the exported functions tell the host's logger.
#![allow(unsafe_code)]

use crate::host;
use std::ffi::{CStr, CString};
use std::ptr::{null, null_mut, without_provenance_mut};
use std::sync::atomic::{AtomicBool, Ordering};

use crate::host::{Arguments, Host};
use wheelrail::fmi::v2::types::{CallbackFunctions, FALSE, Status, TRUE, Text};
use wheelrail::fmi::v2::*;
use wheelrail::variables::LOG_CATEGORIES;

#[test]
fn a_logger_that_calls_back_gets_an_error_and_no_deadlock() {
    let host = Host::stepping();
    let address = host.component.addr();
    *host.on_message.lock().unwrap() = Some(Box::new(move |_| {
        let component = without_provenance_mut(address);
        assert_eq!(fmi2DoStep(component, 0.0, 1e-3, TRUE), Status::Error);
    }));
    assert_eq!(host.step(0.0, -1.0), Status::Error);
    // One message: the busy instance did not log again.
    assert_eq!(host.messages.lock().unwrap().len(), 1);
    *host.on_message.lock().unwrap() =
        Some(Box::new(move |_| fmi2FreeInstance(without_provenance_mut(address))));
    assert_eq!(host.step(0.0, -1.0), Status::Error);
    *host.on_message.lock().unwrap() = None;
    assert_eq!(host.step(0.0, 1e-3), Status::Error);
}

#[test]
fn messages_carry_environment_name_and_a_declared_category() {
    // That the environment is the host's is what makes the messages arrive at all.
    let host = Host::instantiate(&Arguments { logging_on: true, ..Arguments::default() });
    assert_eq!(host.set_reals(&[("wheel.y", f64::NAN)]), Status::Error);
    assert_eq!(fmi2Reset(host.component), Status::Ok);
    let messages = host.messages.lock().unwrap().clone();
    assert!(messages.len() >= 3);
    for message in messages {
        assert_eq!(message.instance_name, "front left");
        assert!(LOG_CATEGORIES.iter().any(|(name, _)| *name == message.category));
        assert_eq!(message.category == "logStatusError", message.status == Status::Error);
    }
}

#[test]
fn categories_can_be_chosen() {
    let host = Host::new();
    let count = || host.messages.lock().unwrap().len();
    let set = |on, names: &[&CStr]| {
        let names: Vec<Text> = names.iter().map(|n| n.as_ptr()).collect();
        // SAFETY: FMI 2.0, 2.1.5: an array of null-terminated texts.
        unsafe { fmi2SetDebugLogging(host.component, on, names.len(), names.as_ptr()) }
    };
    let (event, error) = (
        || assert_eq!(fmi2Reset(host.component), Status::Ok),
        || assert_eq!(host.step(0.0, 1e-3), Status::Error),
    );
    assert_eq!(count(), 0, "events are off without loggingOn");
    error();
    assert_eq!(count(), 1, "errors are on without loggingOn");
    assert_eq!(set(TRUE, &[c"logEvents"]), Status::Ok);
    event();
    assert_eq!(count(), 2);
    assert_eq!(set(FALSE, &[]), Status::Ok);
    event();
    error();
    assert_eq!(count(), 3);
    assert_eq!(set(FALSE, &[c"logStatusError"]), Status::Ok);
    error();
    assert_eq!(count(), 3);
    assert_eq!(set(TRUE, &[]), Status::Ok);
    event();
    error();
    assert_eq!(count(), 5);
    assert_eq!(set(TRUE, &[c"logEverything"]), Status::Error);
    assert!(host.last().contains("no log category \"logEverything\""), "{}", host.last());
}

#[test]
fn a_null_logger_is_no_obstacle() {
    let functions = CallbackFunctions {
        logger: None,
        allocate_memory: None,
        free_memory: None,
        step_finished: None,
        component_environment: null_mut(),
    };
    let arguments = Arguments::default();
    let (name, guid) = (arguments.name.unwrap(), arguments.guid.unwrap());
    // SAFETY: FMI 2.0, 2.1.5: null-terminated texts, a struct that is filled in; null for it is
    // refused, which is tested too.
    let (component, refused) = unsafe {
        (
            fmi2Instantiate(
                name.as_ptr(),
                1,
                guid.as_ptr(),
                null(),
                &raw const functions,
                TRUE,
                TRUE,
            ),
            fmi2Instantiate(name.as_ptr(), 1, guid.as_ptr(), null(), null(), TRUE, TRUE),
        )
    };
    assert!(refused.is_null());
    assert_eq!(fmi2DoStep(component, 0.0, 1e-3, TRUE), Status::Error);
    assert_eq!(fmi2Reset(component), Status::Ok);
    fmi2FreeInstance(component);
}

#[test]
fn an_instance_that_is_refused_is_explained() {
    let default = Arguments::default;
    for (arguments, words) in [
        (Arguments { guid: Some(c"{1-2-3}".into()), ..default() }, "the GUID is \"{1-2-3}\""),
        (Arguments { guid: None, ..default() }, "argument fmuGUID is null"),
        (Arguments { fmu_type: 2, ..default() }, "fmuType 2 is neither"),
        (Arguments { name: None, ..default() }, "instanceName is empty"),
        (Arguments { name: Some(c"".into()), ..default() }, "instanceName is empty"),
        (Arguments { location: Some(c"file:///\xff".into()), ..default() }, "not UTF-8"),
    ] {
        let host = Host::instantiate(&arguments);
        assert!(host.component.is_null());
        assert!(host.last().contains(words), "{}", host.last());
        assert_eq!(host.messages.lock().unwrap()[0].status, Status::Error);
    }
}

#[test]
fn a_location_that_is_no_file_is_a_warning() {
    for (location, warned) in [(Some(c"https://host/x"), true), (None, false), (Some(c""), false)] {
        let location: Option<CString> = location.map(Into::into);
        let host = Host::instantiate(&Arguments { location, ..Arguments::default() });
        assert!(!host.component.is_null());
        assert_eq!(host.last().contains("is not a file: URI"), warned, "{}", host.last());
    }
}

#[test]
fn a_load_that_the_rails_do_not_carry_is_told_with_its_numbers_once() {
    let host = Host::initializing();
    assert_eq!(host.set_integer("vertical.mode", 2), Status::Ok);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok);
    let evaluate = |y: f64| {
        assert_eq!(host.set_reals(&[("wheel.y", y), ("wheel.load", 5e4)]), Status::Ok);
        host.get_real("vertical.load_carried")
    };
    let said = || host.messages.lock().unwrap().len();
    assert!((evaluate(0.75) - 5e4).abs() < 1.0);
    assert_eq!(said(), 0);
    for _ in 0..3 {
        assert_eq!(evaluate(0.3).to_bits(), 0f64.to_bits());
        assert_eq!(evaluate(0.31).to_bits(), 0f64.to_bits());
    }
    assert_eq!(said(), 1, "{}", host.last());
    for words in ["wheel.load = 50000 N", "carry 0 N", "vertical.load_carried"] {
        assert!(host.last().contains(words), "{}", host.last());
    }
    assert!(evaluate(0.751) > 4.9e4);
    evaluate(0.3);
    assert_eq!(said(), 2);
}

#[test]
fn inputs_without_effect_and_a_wheel_that_slides_are_told_once() {
    let host = Host::initializing();
    assert_eq!(host.set_reals(&[("wheel.load", 5e4)]), Status::Ok);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Warning);
    assert!(
        host.last().contains("wheel.load has no effect with vertical.mode = penetration"),
        "{}",
        host.last()
    );
    let said = || host.messages.lock().unwrap().len();
    assert_eq!(said(), 1);
    let force = |rate: f64| {
        assert_eq!(host.set_reals(&[("wheel.load", 6e4), ("wheel.pitch_rate", rate)]), Status::Ok);
        host.get_real("wheel.force.x")
    };
    force(-43.478);
    assert_eq!(said(), 1, "{}", host.last());
    for _ in 0..3 {
        force(0.0);
    }
    assert_eq!(said(), 2, "{}", host.last());
    for words in ["slip of 100 %", "wheel.pitch_rate = -43.47", "said once until it is over"] {
        assert!(host.last().contains(words), "{}", host.last());
    }
    force(-43.478);
    force(0.0);
    assert_eq!(said(), 3);
}

/// Status and message with which a unit starts that has these starting values.
fn started(reals: &[(&str, f64)], left: bool) -> (Status, String) {
    let host = Host::initializing();
    if left {
        assert_eq!(host.set_integer("side", 2), Status::Ok);
    }
    assert_eq!(host.set_reals(reals), Status::Ok);
    let status = fmi2ExitInitializationMode(host.component);
    let said = host.messages.lock().unwrap().len();
    assert_eq!(said, usize::from(status == Status::Warning), "{}", host.last());
    (status, if said > 0 { host.last() } else { String::new() })
}

#[test]
fn a_wheel_that_starts_inside_far_above_or_beside_its_rails_is_told_how_far() {
    assert_eq!(started(&[], false).0, Status::Ok);
    for (reals, left, words) in [
        (&[("wheel.nominal_radius", 0.42)][..], false, "39.9 mm above nominal.wheel_z"),
        (&[("wheel.nominal_radius", 0.5)], false, "40.1 mm below nominal.wheel_z"),
        (&[("wheel.z", -0.44)], false, "it is inside the rail; set wheel.z"),
        (
            &[],
            true,
            "the wheel on the left side starts beside its rails, with its marker at y = 0.75 m",
        ),
        (&[("wheel.y", 0.2)], false, "set wheel.y"),
    ] {
        let (status, message) = started(reals, left);
        assert_eq!(status, Status::Warning, "{words}");
        assert!(message.contains(words), "{message}");
    }
}

#[test]
fn a_wheel_that_sinks_into_its_rail_is_told_from_a_lifted_one_once() {
    let host = Host::stepping();
    let said = || host.messages.lock().unwrap().len();
    let force = |z: f64| {
        assert_eq!(host.set_reals(&[("wheel.z", z)]), Status::Ok);
        host.get_real("wheel.force.z")
    };
    assert!(force(-0.4598) < 0.0 && force(-0.444) < -1e8);
    assert_eq!(said(), 0);
    for z in [-0.42, -0.41, -0.3] {
        assert!(force(z).abs() <= 0.0);
        assert_eq!(host.get_integer("patch_count"), 0);
    }
    assert_eq!(said(), 1, "{}", host.last());
    for words in ["39.8 mm below the top of its rail", "not lifted", "nominal.wheel_z"] {
        assert!(host.last().contains(words), "{}", host.last());
    }
}

#[test]
fn a_message_needs_no_variable_arguments() {
    // The host's logger has none, and asserts that what it gets is a format without them.
    let host = Host::initializing();
    assert_eq!(host.set_text("wheel.profile", "worn by 5 %s.prw"), Status::Ok);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Error);
    assert!(host.last().contains("\"worn by 5 %s.prw\""), "{}", host.last());
}

#[test]
fn an_instance_that_is_busy_in_another_thread_says_so() {
    let host = Host::initializing();
    assert_eq!(host.set_integer("normal.model", 5), Status::Ok);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
    let address = host.component.addr();
    let ended = AtomicBool::new(false);
    let was_busy = std::thread::scope(|scope| {
        let other = scope.spawn(|| {
            let (reference, mut value) = (host::reference("wheel.y"), 0.0);
            while !ended.load(Ordering::Relaxed) {
                let component = without_provenance_mut(address);
                // SAFETY: FMI 2.0, 2.1.7: arrays of one element.
                let status =
                    unsafe { fmi2GetReal(component, &raw const reference, 1, &raw mut value) };
                if status == Status::Error {
                    return true;
                }
            }
            false
        });
        // When the two threads run is up to the system: evaluations go on until they have met.
        for step in 0..100_000 {
            if other.is_finished() {
                break;
            }
            // Refused itself if the other call is under way just then.
            host.set_reals(&[("wheel.z", -0.4597 - 1e-9 * f64::from(step))]);
            let _ = host.get_reals(&["wheel.force.z"]);
        }
        ended.store(true, Ordering::Relaxed);
        other.join().unwrap()
    });
    assert!(was_busy);
    assert!(host.last().contains(": the instance is busy with another call"), "{}", host.last());
}

#[test]
fn long_texts_are_refused_and_quoted_in_part() {
    let long = "x".repeat(10_000_000);
    let host = Host::initializing();
    assert_eq!(host.set_text("wheel.profile", &long), Status::Error);
    let said = host.last();
    assert!(said.contains("wheel.profile = \"xxx") && said.contains("(10000000 bytes)"), "{said}");
    assert!(said.contains("up to 4096 bytes") && said.len() < 1000, "{said}");
    let text = || Some(CString::new(long.clone()).unwrap());
    for arguments in [
        Arguments { guid: text(), ..Arguments::default() },
        Arguments { location: text(), ..Arguments::default() },
    ] {
        let host = Host::instantiate(&arguments);
        assert!(host.last().contains("(10000000 bytes)") && host.last().len() < 1000);
    }
}

#[test]
fn a_tolerance_that_is_no_number_is_refused() {
    let host = Host::new();
    let setup = |tolerance| fmi2SetupExperiment(host.component, TRUE, tolerance, 0.0, FALSE, 0.0);
    for tolerance in [f64::NAN, f64::INFINITY, -1e-6] {
        assert_eq!(setup(tolerance), Status::Error);
        let words = format!("argument tolerance = {tolerance} is not admitted");
        assert!(host.last().contains(&words), "{}", host.last());
    }
    assert_eq!(setup(1e-6), Status::Ok);
}

#[test]
fn a_corrugation_file_that_is_a_folder_is_said_to_be_one() {
    let host = Host::initializing();
    let folder = env!("CARGO_MANIFEST_DIR");
    assert_eq!(host.set_text("rail[1].corrugation.file", folder), Status::Ok);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Error);
    assert!(host.last().contains(&format!("{folder} is a folder")), "{}", host.last());
}
