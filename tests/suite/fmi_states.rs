//! Saving, restoring and serializing the state of the unit: rollback is exact, foreign and freed
//! states are refused.
#![allow(unsafe_code)]

use std::ffi::c_char;
use std::ptr::{null_mut, without_provenance_mut};

use crate::host::Host;
use wheelrail::fmi::v2::types::{FALSE, FmuState, Status};
use wheelrail::fmi::v2::*;
use wheelrail::variables::{Kind, VARIABLES};

/// A loaded wheel that creeps, at a lateral position.
fn place(host: &Host, y: f64) {
    let inputs = [
        ("wheel.z", -0.4597),
        ("wheel.y", y),
        ("wheel.vx", 20.0),
        ("wheel.pitch_rate", -43.4),
        ("wheel.yaw", 0.01),
    ];
    assert_eq!(host.set_reals(&inputs), Status::Ok);
}

fn outputs(host: &Host) -> Vec<u64> {
    let names: Vec<&str> = (VARIABLES.iter())
        .filter(|v| v.kind == Kind::Real && !v.is_settable())
        .map(|v| v.name)
        .collect();
    let values = host.get_reals(&names).unwrap_or_else(|_| panic!("{}", host.last()));
    values.iter().map(|v| v.to_bits()).collect()
}

/// Steps a wheel that moves sideways; the bits of all real outputs after each.
fn run(host: &Host, steps: std::ops::Range<u32>) -> Vec<Vec<u64>> {
    let one = |i: u32| {
        place(host, 0.75 + 1e-3 * f64::from(i));
        assert_eq!(host.step(1e-3 * f64::from(i), 1e-3), Status::Ok, "{}", host.last());
        outputs(host)
    };
    steps.map(one).collect()
}

fn save(host: &Host, state: &mut FmuState) -> Status {
    // SAFETY: FMI 2.0, 2.1.8: a pointer to one state pointer.
    unsafe { fmi2GetFMUstate(host.component, state) }
}

fn free(host: &Host, state: &mut FmuState) -> Status {
    // SAFETY: FMI 2.0, 2.1.8: a pointer to one state pointer.
    unsafe { fmi2FreeFMUstate(host.component, state) }
}

fn deserialize(host: &Host, bytes: &[u8], state: &mut FmuState) -> Status {
    let start = bytes.as_ptr().cast::<c_char>();
    // SAFETY: FMI 2.0, 2.1.8: an array of as many bytes as the count says, a pointer to one state
    // pointer.
    unsafe { fmi2DeSerializeFMUstate(host.component, start, bytes.len(), state) }
}

#[test]
fn a_run_taken_back_in_its_middle_goes_on_bit_for_bit() {
    let host = Host::stepping();
    run(&host, 0..5);
    let mut state = null_mut();
    assert_eq!(save(&host, &mut state), Status::Ok);
    let first = run(&host, 5..12);
    for _ in 0..3 {
        assert_eq!(fmi2SetFMUstate(host.component, state), Status::Ok);
        assert_eq!(host.get_real("wheel.y").to_bits(), (0.75 + 1e-3 * 4.0_f64).to_bits());
        assert_eq!(run(&host, 5..12), first);
    }
    assert_eq!(free(&host, &mut state), Status::Ok);
    assert!(state.is_null());
}

#[test]
fn a_state_goes_through_bytes_to_another_instance() {
    let host = Host::stepping();
    run(&host, 0..5);
    let mut state = null_mut();
    assert_eq!(save(&host, &mut state), Status::Ok);
    let now = outputs(&host);
    let bytes = host.serialize(state);
    let first = run(&host, 5..12);
    // Into an instance that has not even been initialized, of other parameters.
    let other = Host::new();
    assert_eq!(other.set_text("wheel.profile", "conical:0.05"), Status::Ok);
    let mut copy = null_mut();
    assert_eq!(deserialize(&other, &bytes, &mut copy), Status::Ok, "{}", other.last());
    assert_eq!(fmi2SetFMUstate(other.component, copy), Status::Ok, "{}", other.last());
    assert_eq!(outputs(&other), now);
    assert_eq!(run(&other, 5..12), first);
    assert_eq!(other.serialize(copy), bytes);
}

#[test]
fn a_state_brings_its_parameters_and_its_place_in_life() {
    let host = Host::new();
    let (mut before, mut after) = (null_mut(), null_mut());
    assert_eq!(save(&host, &mut before), Status::Ok);
    assert_eq!(host.set_text("wheel.profile", "conical:0.05"), Status::Ok);
    assert_eq!(fmi2SetupExperiment(host.component, FALSE, 0.0, 0.0, FALSE, 0.0), Status::Ok);
    assert_eq!(fmi2EnterInitializationMode(host.component), Status::Ok);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok);
    place(&host, 0.752);
    let conical = outputs(&host);
    assert_eq!(save(&host, &mut after), Status::Ok);

    assert_eq!(fmi2SetFMUstate(host.component, before), Status::Ok);
    assert_eq!(host.step(0.0, 1e-3), Status::Error);
    assert!(host.last().contains("before initialization"), "{}", host.last());
    assert_eq!(fmi2SetupExperiment(host.component, FALSE, 0.0, 0.0, FALSE, 0.0), Status::Ok);
    assert_eq!(fmi2EnterInitializationMode(host.component), Status::Ok);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok);
    place(&host, 0.752);
    assert_ne!(outputs(&host), conical);

    assert_eq!(fmi2Terminate(host.component), Status::Ok);
    assert_eq!(fmi2Reset(host.component), Status::Ok);
    assert_eq!(fmi2SetFMUstate(host.component, after), Status::Ok, "{}", host.last());
    assert_eq!(outputs(&host), conical);
    assert_eq!(host.step(0.0, 1e-3), Status::Ok);
}

#[test]
fn saving_over_an_old_state_keeps_its_pointer() {
    let host = Host::stepping();
    let mut state = null_mut();
    run(&host, 0..2);
    assert_eq!(save(&host, &mut state), Status::Ok);
    let pointer = state;
    let second = run(&host, 2..4);
    assert_eq!(save(&host, &mut state), Status::Ok);
    assert_eq!(state, pointer);
    run(&host, 4..6);
    assert_eq!(fmi2SetFMUstate(host.component, state), Status::Ok);
    assert_eq!(outputs(&host), second[1]);
}

#[test]
fn freed_foreign_and_forged_states_are_refused_and_do_no_harm() {
    let (host, other) = (Host::stepping(), Host::stepping());
    run(&host, 0..2);
    let now = outputs(&host);
    let (mut freed, mut foreign) = (null_mut(), null_mut());
    assert_eq!(save(&host, &mut freed), Status::Ok);
    let old = freed;
    assert_eq!(free(&host, &mut freed), Status::Ok);
    assert_eq!(save(&other, &mut foreign), Status::Ok);
    for mut bad in [old, foreign, null_mut(), without_provenance_mut(1)] {
        assert_eq!(fmi2SetFMUstate(host.component, bad), Status::Error);
        assert!(host.last().contains("no state of this instance"), "{}", host.last());
        let mut size = 0;
        // SAFETY: FMI 2.0, 2.1.8: pointers to one size; the bytes are not touched.
        unsafe {
            let asked = fmi2SerializedFMUstateSize(host.component, bad, &raw mut size);
            assert_eq!(asked, Status::Error);
            let written = fmi2SerializeFMUstate(host.component, bad, null_mut(), 0);
            assert_eq!(written, Status::Error);
        }
        if !bad.is_null() {
            assert_eq!(save(&host, &mut bad), Status::Error);
            assert_eq!(free(&host, &mut bad), Status::Error);
        }
    }
    assert_eq!(outputs(&host), now);
    // SAFETY: FMI 2.0, 2.1.8: null where a pointer to a state pointer should be.
    unsafe {
        assert_eq!(fmi2GetFMUstate(host.component, null_mut()), Status::Error);
        assert_eq!(fmi2FreeFMUstate(host.component, null_mut()), Status::Ok);
    }
}

#[test]
fn damaged_bytes_are_refused_and_leave_the_state_as_it_was() {
    let host = Host::stepping();
    run(&host, 0..2);
    let mut state = null_mut();
    assert_eq!(save(&host, &mut state), Status::Ok);
    let bytes = host.serialize(state);
    let now = outputs(&host);
    let mut damaged = bytes.clone();
    damaged[bytes.len() / 2] ^= 0x10;
    for bad in [&bytes[..bytes.len() - 1], &damaged, b"another unit's state", &[]] {
        let mut read = null_mut();
        assert_eq!(deserialize(&host, bad, &mut read), Status::Error);
        assert!(host.last().contains("serializedState"), "{}", host.last());
        assert!(read.is_null());
    }
    let mut small = vec![0u8; bytes.len() - 1];
    let start = small.as_mut_ptr().cast::<c_char>();
    // SAFETY: FMI 2.0, 2.1.8: an array of as many bytes as the count says.
    let status = unsafe { fmi2SerializeFMUstate(host.component, state, start, small.len()) };
    assert_eq!(status, Status::Error);
    assert!(host.last().contains("fmi2SerializedFMUstateSize"), "{}", host.last());
    assert_eq!(outputs(&host), now);
}

#[test]
fn a_state_whose_profile_is_gone_is_refused_where_it_is_needed() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("wheel.txt");
    let points = (-60..=60).map(|i| format!("{i} {}", -0.05 * f64::from(i)));
    std::fs::write(&file, points.collect::<Vec<_>>().join("\n")).unwrap();
    let host = Host::new();
    assert_eq!(host.set_text("wheel.profile", file.to_str().unwrap()), Status::Ok);
    assert_eq!(fmi2SetupExperiment(host.component, FALSE, 0.0, 0.0, FALSE, 0.0), Status::Ok);
    assert_eq!(fmi2EnterInitializationMode(host.component), Status::Ok);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
    let mut state = null_mut();
    assert_eq!(save(&host, &mut state), Status::Ok);
    drop(folder);
    // The element is still there.
    assert_eq!(fmi2SetFMUstate(host.component, state), Status::Ok);
    let bytes = host.serialize(state);
    let other = Host::stepping();
    run(&other, 0..2);
    let now = outputs(&other);
    let mut copy = null_mut();
    assert_eq!(deserialize(&other, &bytes, &mut copy), Status::Ok);
    assert_eq!(fmi2SetFMUstate(other.component, copy), Status::Error);
    assert!(other.last().contains("wheel.profile"), "{}", other.last());
    assert_eq!(outputs(&other), now);
}
