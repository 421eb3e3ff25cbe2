//! The exported functions under right and wrong use: order of calls, handles, arguments, messages.
#![allow(unsafe_code)]

use std::ffi::CStr;
use std::ptr::{null, null_mut, without_provenance_mut};

use crate::host::{Host, reference};
use wheelrail::fmi::v2::types::{
    Component, FALSE, Status, TRUE, Text, ValueReference, status_kind,
};
use wheelrail::fmi::v2::*;
use wheelrail::variables::{Kind, VARIABLES};

const PRESSED: [(&str, f64); 4] =
    [("wheel.z", -0.4597), ("wheel.y", 0.751), ("wheel.vx", 20.0), ("wheel.pitch_rate", -43.4)];

fn real_outputs() -> Vec<&'static str> {
    let outputs = VARIABLES.iter().filter(|v| v.kind == Kind::Real && !v.is_settable());
    outputs.map(|v| v.name).collect()
}

fn bits(values: &[f64]) -> Vec<u64> {
    values.iter().map(|v| v.to_bits()).collect()
}

/// Ten steps of a wheel that moves sideways; the bits of every real output after each.
fn ten_steps(host: &Host, sideways: f64) -> Vec<u64> {
    let mut all = Vec::new();
    assert_eq!(host.set_reals(&PRESSED), Status::Ok);
    for i in 0..10 {
        let y = 0.75 + sideways * f64::from(i);
        assert_eq!(host.set_reals(&[("wheel.y", y)]), Status::Ok);
        assert_eq!(host.step(1e-3 * f64::from(i), 1e-3), Status::Ok);
        all.extend(bits(&host.get_reals(&real_outputs()).unwrap()));
        assert_eq!(host.get_real("wheel.y").to_bits(), y.to_bits());
    }
    all
}

#[test]
fn version_and_platform_are_those_of_the_standard() {
    // SAFETY: FMI 2.0, 2.1.4: both functions return static null-terminated texts.
    let (version, platform) =
        unsafe { (CStr::from_ptr(fmi2GetVersion()), CStr::from_ptr(fmi2GetTypesPlatform())) };
    assert_eq!((version, platform), (c"2.0", c"default"));
}

#[test]
fn before_initialization_nothing_can_be_read_or_stepped() {
    let host = Host::new();
    assert_eq!(host.get_reals(&["wheel.y"]), Err(Status::Error));
    assert!(host.last().contains("fmi2GetReal: not allowed before initialization"));
    assert_eq!(host.step(0.0, 1e-3), Status::Error);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Error);
    assert_eq!(fmi2Terminate(host.component), Status::Error);
    assert_eq!(fmi2EnterInitializationMode(host.component), Status::Error);
    assert!(host.last().contains("call fmi2SetupExperiment first"), "{}", host.last());
    // None of it did harm.
    assert_eq!(fmi2SetupExperiment(host.component, FALSE, 0.0, 0.0, FALSE, 0.0), Status::Ok);
    assert_eq!(fmi2EnterInitializationMode(host.component), Status::Ok);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok);
    assert_eq!(host.step(0.0, 1e-3), Status::Ok);
}

#[test]
fn in_initialization_mode_there_is_no_step() {
    let host = Host::initializing();
    assert_eq!(host.step(0.0, 1e-3), Status::Error);
    assert!(host.last().contains("call fmi2ExitInitializationMode first"), "{}", host.last());
    assert_eq!(fmi2SetupExperiment(host.component, FALSE, 0.0, 0.0, FALSE, 0.0), Status::Error);
    assert_eq!(fmi2EnterInitializationMode(host.component), Status::Error);
    assert!(host.get_reals(&real_outputs()).is_ok(), "{}", host.last());
}

#[test]
fn after_initialization_parameters_are_fixed_until_reset() {
    let host = Host::stepping();
    assert_eq!(host.set_integer("normal.strips", 20), Status::Error);
    assert!(host.last().contains("normal.strips is fixed after initialization"));
    assert_eq!(host.set_reals(&[("wheel.y", 0.76), ("track.gauge", 1.44)]), Status::Error);
    assert_eq!(host.get_reals(&["wheel.y", "track.gauge"]), Ok(vec![0.75, 1.435]));
    assert_eq!(fmi2Reset(host.component), Status::Ok);
    assert_eq!(host.set_integer("normal.strips", 20), Status::Ok);
}

#[test]
fn after_terminate_outputs_can_be_read_and_nothing_else_done() {
    let host = Host::stepping();
    let before = host.get_reals(&real_outputs()).unwrap();
    assert_eq!(fmi2Terminate(host.component), Status::Ok);
    assert_eq!(bits(&host.get_reals(&real_outputs()).unwrap()), bits(&before));
    assert_eq!(host.step(0.0, 1e-3), Status::Error);
    assert_eq!(host.set_reals(&PRESSED), Status::Error);
    assert_eq!(fmi2Terminate(host.component), Status::Error);
    assert_eq!(fmi2Reset(host.component), Status::Ok);
}

#[test]
fn null_freed_and_forged_handles_give_errors_and_no_harm() {
    let host = Host::stepping();
    let freed = {
        let other = Host::stepping();
        other.component
    };
    let next = without_provenance_mut(host.component.addr() + 1);
    let other_generation = without_provenance_mut(host.component.addr() ^ (1 << 40));
    let small = (1..100).map(without_provenance_mut);
    let all_ones: Component = without_provenance_mut(usize::MAX);
    for forged in [null_mut(), freed, next, other_generation, all_ones].into_iter().chain(small) {
        assert_eq!(fmi2DoStep(forged, 0.0, 1e-3, TRUE), Status::Error);
        assert_eq!(fmi2Reset(forged), Status::Error);
        fmi2FreeInstance(forged);
        fmi2FreeInstance(forged);
    }
    assert_eq!(host.step(0.0, 1e-3), Status::Ok);
}

#[test]
fn a_place_that_is_used_again_does_not_revive_old_handles() {
    let mut old = Vec::new();
    for _ in 0..50 {
        let host = Host::stepping();
        assert!(!old.contains(&host.component));
        old.push(host.component);
    }
    for component in old {
        assert_eq!(fmi2DoStep(component, 0.0, 1e-3, TRUE), Status::Error);
    }
}

#[test]
fn arrays_are_checked_for_null_and_count() {
    let host = Host::stepping();
    let (one, mut value) = ([reference("wheel.y")], [0.0]);
    let (r, v, c) = (one.as_ptr(), value.as_mut_ptr(), host.component);
    // SAFETY: FMI 2.0, 2.1.7: arrays of one element; nulls and counts beyond all memory are refused
    // before anything is read, which is what is tested.
    unsafe {
        assert_eq!(fmi2GetReal(c, null(), 0, null_mut()), Status::Ok);
        assert_eq!(fmi2SetReal(c, null(), 0, null()), Status::Ok);
        assert_eq!(fmi2GetString(c, null(), 0, null_mut()), Status::Ok);
        assert_eq!(fmi2GetReal(c, null(), 1, v), Status::Error);
        assert!(host.last().contains("fmi2GetReal: argument vr is null"), "{}", host.last());
        assert_eq!(fmi2GetReal(c, r, 1, null_mut()), Status::Error);
        assert!(host.last().contains("argument value is null"), "{}", host.last());
        assert_eq!(fmi2SetReal(c, r, 1, null()), Status::Error);
        assert_eq!(fmi2GetReal(c, r, usize::MAX, v), Status::Error);
        assert_eq!(fmi2SetString(c, r, 1, [null()].as_ptr()), Status::Error);
        assert_eq!(
            fmi2GetRealStatus(c, status_kind::LAST_SUCCESSFUL_TIME, null_mut()),
            Status::Error
        );
        assert_eq!(fmi2SetDebugLogging(c, TRUE, 2, null()), Status::Error);
        assert_eq!(fmi2GetReal(c, r, 1, v), Status::Ok);
    }
    assert_eq!(bits(&value), bits(&[0.75]));
}

#[test]
fn references_are_checked_for_existence_and_type() {
    let host = Host::stepping();
    let mut value = 0.0;
    for (number, words) in [
        (ValueReference::MAX, "value reference 4294967295 does not exist"),
        (reference("patch_count"), "patch_count is of type Integer"),
        (reference("wheel.profile"), "wheel.profile is of type String"),
        (reference("normal.model"), "normal.model is of type Enumeration"),
    ] {
        // SAFETY: FMI 2.0, 2.1.7: arrays of one element.
        let status = unsafe { fmi2GetReal(host.component, &raw const number, 1, &raw mut value) };
        assert_eq!(status, Status::Error);
        assert!(host.last().contains(words), "{}", host.last());
    }
}

#[test]
fn a_refused_array_changes_nothing_and_the_run_goes_on() {
    let host = Host::stepping();
    let undisturbed = Host::stepping();
    assert_eq!(host.set_reals(&PRESSED), Status::Ok);
    assert_eq!(undisturbed.set_reals(&PRESSED), Status::Ok);
    for (name, value, words) in [
        ("wheel.vy", f64::NAN, "wheel.vy = NaN is not admitted: a finite number, in m/s"),
        ("wheel.vy", f64::NEG_INFINITY, "wheel.vy = -inf"),
        ("friction.coefficient", -0.1, "friction.coefficient = -0.1"),
        ("wheel.force.z", 1.0, "wheel.force.z = 1 is not admitted: it is computed"),
    ] {
        assert_eq!(host.set_reals(&[("wheel.z", -0.4), (name, value)]), Status::Error);
        assert!(host.last().contains(words), "{}", host.last());
    }
    let outputs = real_outputs();
    let (a, b) = (host.get_reals(&outputs).unwrap(), undisturbed.get_reals(&outputs).unwrap());
    assert_eq!(bits(&a), bits(&b));
    assert_eq!(host.get_real("wheel.z").to_bits(), (-0.4597_f64).to_bits());
    assert_eq!(host.step(0.0, 1e-3), Status::Ok);
}

#[test]
fn times_and_steps_are_checked() {
    let host = Host::new();
    let c = host.component;
    assert_eq!(fmi2SetupExperiment(c, FALSE, 0.0, f64::NAN, FALSE, 0.0), Status::Error);
    assert_eq!(fmi2SetupExperiment(c, FALSE, 0.0, 1.0, TRUE, 0.5), Status::Error);
    assert_eq!(fmi2SetupExperiment(c, TRUE, 1e-6, 0.0, TRUE, 0.03), Status::Ok);
    assert_eq!(fmi2EnterInitializationMode(c), Status::Ok);
    assert_eq!(fmi2ExitInitializationMode(c), Status::Ok);
    for (time, step) in [(0.0, -1e-3), (0.0, f64::NAN), (f64::NAN, 1e-3), (0.0, f64::INFINITY)] {
        assert_eq!(host.step(time, step), Status::Error);
        assert!(host.last().starts_with("fmi2DoStep: argument c"), "{}", host.last());
    }
    assert_eq!(host.step(0.0, 0.0), Status::Ok);
    // Time that is summed up ends just before the stop time; the host may step over it.
    assert_eq!(host.step(0.029_999_999_999_8, 0.01), Status::Ok);
    assert_eq!(host.step(0.02, 0.010_000_000_000_2), Status::Ok);
    for (time, step) in [(0.04, 0.01), (0.03, 0.01), (0.029, 0.002), (0.0, 2.0)] {
        assert_eq!(host.step(time, step), Status::Error);
        let said =
            format!("communicationStepSize = {step} is not admitted: the step from {time} s");
        assert!(host.last().contains(&said), "{}", host.last());
        assert!(host.last().contains("after the stop time of 0.03 s"), "{}", host.last());
    }
}

#[test]
fn reset_and_repeat_gives_the_same_bits() {
    let host = Host::stepping();
    let first = ten_steps(&host, 1e-3);
    assert_eq!(fmi2Reset(host.component), Status::Ok);
    assert_eq!(fmi2SetupExperiment(host.component, FALSE, 0.0, 0.0, FALSE, 0.0), Status::Ok);
    assert_eq!(fmi2EnterInitializationMode(host.component), Status::Ok);
    assert_eq!(host.get_real("wheel.z").to_bits(), (-0.45975_f64).to_bits());
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok);
    assert_eq!(ten_steps(&host, 1e-3), first);
}

#[test]
fn instances_do_not_mix_and_threads_change_nothing() {
    let sideways = |i: i32| 2e-4 * f64::from(i - 4);
    let alone: Vec<_> = (0..8).map(|i| ten_steps(&Host::stepping(), sideways(i))).collect();
    let together = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..8)
            .map(|i| {
                scope.spawn(move || {
                    (0..20).map(|_| ten_steps(&Host::stepping(), sideways(i))).next_back().unwrap()
                })
            })
            .collect();
        threads.into_iter().map(|t| t.join().unwrap()).collect::<Vec<_>>()
    });
    assert_eq!(together, alone);
}

#[test]
fn texts_live_until_the_next_call_and_are_copied_in() {
    let host = Host::new();
    let name = format!("{}/tests/data/nowhere 100%s%n.txt", env!("CARGO_MANIFEST_DIR"));
    assert_eq!(host.set_text("wheel.profile", &name), Status::Ok);
    assert_eq!(host.set_text("wheel.profile", "S1002"), Status::Ok);
    assert_eq!(fmi2SetupExperiment(host.component, FALSE, 0.0, 0.0, FALSE, 0.0), Status::Ok);
    assert_eq!(fmi2EnterInitializationMode(host.component), Status::Ok);
    let references = [reference("wheel.profile"), reference("rail[1].profile")];
    let mut texts: [Text; 2] = [null(); 2];
    // SAFETY: FMI 2.0, 2.1.2 and 2.1.7: arrays of two elements; the texts live until the next call.
    let (wheel, rail) = unsafe {
        let status = fmi2GetString(host.component, references.as_ptr(), 2, texts.as_mut_ptr());
        assert_eq!(status, Status::Ok);
        (CStr::from_ptr(texts[0]), CStr::from_ptr(texts[1]))
    };
    assert_eq!((wheel, rail), (c"S1002", c"60E1"));
}

#[test]
fn enumerations_and_booleans_are_set_and_read() {
    let host = Host::initializing();
    assert_eq!(host.set_integer("normal.model", 1), Status::Ok);
    assert_eq!(host.get_integer("normal.model"), 1);
    assert_eq!(host.set_integer("normal.model", 77), Status::Error);
    assert!(host.last().contains("normal.model = 77 is not admitted: one of hertz (1)"));
    let (enabled, mut value) = (reference("rail[1].enabled"), FALSE);
    // SAFETY: FMI 2.0, 2.1.7: arrays of one element.
    let status = unsafe { fmi2GetBoolean(host.component, &raw const enabled, 1, &raw mut value) };
    assert_eq!((status, value), (Status::Ok, TRUE));
    let off = FALSE;
    // SAFETY: FMI 2.0, 2.1.7: arrays of one element.
    let status = unsafe { fmi2SetBoolean(host.component, &raw const enabled, 1, &raw const off) };
    assert_eq!(status, Status::Ok);
}

#[test]
fn statuses_are_those_of_a_step_that_is_made() {
    let host = Host::stepping();
    assert_eq!(host.step(0.5, 0.25), Status::Ok);
    let c = host.component;
    let (mut status, mut time, mut terminated) = (Status::Fatal, 0.0, TRUE);
    let (mut integer, mut text) = (0, null());
    // SAFETY: FMI 2.0, 4.2.3: each target is one variable of its type.
    unsafe {
        assert_eq!(fmi2GetStatus(c, status_kind::DO_STEP, &raw mut status), Status::Ok);
        assert_eq!(
            fmi2GetRealStatus(c, status_kind::LAST_SUCCESSFUL_TIME, &raw mut time),
            Status::Ok
        );
        assert_eq!(
            fmi2GetBooleanStatus(c, status_kind::TERMINATED, &raw mut terminated),
            Status::Ok
        );
        assert_eq!(fmi2GetStatus(c, 99, &raw mut status), Status::Discard);
    }
    assert_eq!(fmi2GetIntegerStatus(c, 0, &raw mut integer), Status::Discard);
    assert_eq!(fmi2GetStringStatus(c, status_kind::PENDING, &raw mut text), Status::Discard);
    assert_eq!((status, terminated), (Status::Ok, FALSE));
    assert_eq!(bits(&[time]), bits(&[0.75]));
    assert_eq!(fmi2CancelStep(c), Status::Error);
    assert!(host.last().contains("no step is ever pending"), "{}", host.last());
}

#[test]
fn what_is_not_supported_says_so() {
    let host = Host::stepping();
    let c = host.component;
    let status = fmi2GetRealOutputDerivatives(c, null(), 0, null(), null_mut());
    assert_eq!(status, Status::Error);
    assert!(host.last().contains("maxOutputDerivativeOrder"), "{}", host.last());
}

#[test]
fn nominal_height_follows_parameters_set_in_initialization_mode() {
    let host = Host::initializing();
    let first = host.get_real("nominal.wheel_z");
    assert!((first + 0.46).abs() < 2e-3, "{first}");
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok);
    assert_eq!(host.set_reals(&[("wheel.y", 0.755)]), Status::Ok);
    assert_eq!(bits(&[host.get_real("nominal.wheel_z")]), bits(&[first]));
}
