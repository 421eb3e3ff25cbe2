//! Saved states: rollback is exact, bytes go from one interface to the other.

use std::ptr::null_mut;

use wheelrail::fmi::v2::fmi2DeSerializeFMUstate;
use wheelrail::fmi::v2::fmi2SetFMUstate;
use wheelrail::fmi::v3::types::{FmuState, Status};
use wheelrail::fmi::v3::*;
use wheelrail::variables::WHEEL;

use crate::host::Host;
use crate::host3::Host3;

fn run(host: &Host3, steps: std::ops::Range<u32>) -> Vec<u64> {
    let mut bits = Vec::new();
    for i in steps {
        let y = 0.75 + 1e-3 * f64::from(i);
        assert_eq!(host.set_reals(&[("wheel.y", y), ("wheel.yaw", 0.01)]), Status::Ok);
        assert_eq!(host.step(1e-3 * f64::from(i), 1e-3), Status::Ok, "{}", host.last());
        let outputs = host.get_reals(&["wheel.force.y", "patch.max_pressure", "time"], 10);
        bits.extend(outputs.unwrap().iter().map(|v| v.to_bits()));
    }
    bits
}

fn save(host: &Host3, state: &mut FmuState) -> Status {
    // SAFETY: FMI 3.0, 2.2.10: a pointer to one state pointer.
    unsafe { fmi3GetFMUState(host.component, state) }
}

fn bytes(host: &Host3, state: FmuState) -> Vec<u8> {
    let mut size = 0;
    // SAFETY: FMI 3.0, 2.2.10: a pointer to one size, as many bytes as were asked for.
    unsafe {
        assert_eq!(fmi3SerializedFMUStateSize(host.component, state, &raw mut size), Status::Ok);
        let mut bytes = vec![0; size];
        let start = bytes.as_mut_ptr();
        assert_eq!(fmi3SerializeFMUState(host.component, state, start, size), Status::Ok);
        assert_eq!(fmi3SerializeFMUState(host.component, state, start, size - 1), Status::Error);
        assert!(host.last().contains(&format!("size = {}", size - 1)), "{}", host.last());
        bytes
    }
}

#[test]
fn a_run_taken_back_is_repeated_bit_for_bit() {
    let host = Host3::stepping(&WHEEL);
    let c = host.component;
    run(&host, 0..4);
    let mut state = null_mut();
    assert_eq!(save(&host, &mut state), Status::Ok);
    let first = run(&host, 4..8);
    assert_eq!(fmi3SetFMUState(c, state), Status::Ok);
    assert!(host.reads("time", 4e-3));
    assert_eq!(run(&host, 4..8), first);
    let kept = bytes(&host, state);
    // SAFETY: FMI 3.0, 2.2.10: a pointer to one state pointer.
    assert_eq!(unsafe { fmi3FreeFMUState(c, &raw mut state) }, Status::Ok);
    assert!(state.is_null());
    assert_eq!(fmi3SetFMUState(c, state), Status::Error);
    assert!(host.last().contains("is no state of this instance"), "{}", host.last());

    let other = Host3::stepping(&WHEEL);
    let read = |bytes: &[u8], state: &mut FmuState| {
        // SAFETY: FMI 3.0, 2.2.10: as many bytes as the count says, a pointer to one state pointer.
        unsafe { fmi3DeserializeFMUState(other.component, bytes.as_ptr(), bytes.len(), state) }
    };
    assert_eq!(read(&kept, &mut state), Status::Ok, "{}", other.last());
    assert_eq!(fmi3SetFMUState(other.component, state), Status::Ok);
    assert_eq!(run(&other, 4..8), first);
    assert_eq!(read(&kept[1..], &mut state), Status::Error);
    assert!(other.last().contains("serializedState is no state of this unit"), "{}", other.last());
}

#[test]
fn bytes_go_from_one_interface_to_the_other() {
    let (old, new) = (Host::stepping(), Host3::stepping(&WHEEL));
    assert_eq!(new.set_reals(&[("wheel.y", 0.7525)]), Status::Ok);
    assert_eq!(new.step(0.0, 0.5), Status::Ok);
    let (mut state, mut taken) = (null_mut(), null_mut());
    assert_eq!(save(&new, &mut state), Status::Ok);
    let kept = bytes(&new, state);
    let (start, size) = (kept.as_ptr().cast(), kept.len());
    // SAFETY: FMI 2.0, 2.1.8: as many bytes as the count says, a pointer to one state pointer.
    unsafe {
        let read = fmi2DeSerializeFMUstate(old.component, start, size, &raw mut taken);
        assert_eq!(read, Status::Ok, "{}", old.last());
    }
    assert_eq!(fmi2SetFMUstate(old.component, taken), Status::Ok);
    let (here, there) = (new.get_real("wheel.force.y"), old.get_real("wheel.force.y"));
    assert_eq!(here.to_bits(), there.to_bits());
}
