//! The history behind the C interfaces: part of the state, to the bit.
#![allow(unsafe_code)]
// The box fixes the address that the logger gets.
#![allow(clippy::unnecessary_box_returns)]

use std::ffi::c_char;
use std::ptr::null_mut;

use crate::host::{Arguments, Host};
use crate::host3::Host3;
use wheelrail::fmi::v2::types::{FALSE, FmuState, MODEL_EXCHANGE, Status};
use wheelrail::fmi::v2::*;
use wheelrail::fmi::v3;
use wheelrail::variables::{Kind, Unit, WHEEL, WHEELSET};

/// Sets boundary elements that remember.
fn set_parameters(host: &Host) {
    let choices = [
        ("normal.model", 5),
        ("tangential.model", 7),
        ("tangential.history", 2),
        ("normal.elements_along", 8),
        ("normal.elements_across", 8),
    ];
    for (name, value) in choices {
        assert_eq!(host.set_integer(name, value), Status::Ok, "{}", host.last());
    }
}

fn remembering(unit: &Unit, loaded: bool) -> Box<Host> {
    let host = Host::initializing_with(&Arguments::of(unit));
    set_parameters(&host);
    if loaded {
        assert_eq!(host.set_integer("vertical.mode", 2), Status::Ok, "{}", host.last());
    }
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
    host
}

/// The bits of all outputs.
fn outputs(host: &Host) -> Vec<u64> {
    let all = || host.unit.variables.iter().filter(|v| !v.is_settable());
    let names: Vec<&str> = all().filter(|v| v.kind == Kind::Real).map(|v| v.name).collect();
    let values = host.get_reals(&names).unwrap_or_else(|_| panic!("{}", host.last()));
    let whole = all().filter(|v| v.kind == Kind::Integer);
    let whole: Vec<u64> =
        whole.map(|v| u64::from(host.get_integer(v.name).cast_unsigned())).collect();
    values.iter().map(|v| v.to_bits()).chain(whole).collect()
}

/// Steps of a wheel or wheelset that sways, of lengths up to a metre; outputs after each.
fn run(host: &Host, steps: std::ops::Range<u32>) -> Vec<Vec<u64>> {
    let is_wheel = host.unit.identifier == WHEEL.identifier;
    let body = if is_wheel { "wheel" } else { "wheelset" };
    let mut time = 0.0;
    let one = |i: u32| {
        let phase = 0.7 * f64::from(i);
        let y = if is_wheel { 0.747 } else { 0.0 };
        let inputs = [
            (format!("{body}.z"), -0.45975 + 2e-5 * phase.cos()),
            (format!("{body}.y"), y + 1e-3 * phase.sin()),
            (format!("{body}.yaw"), 2e-3 * phase.cos()),
            (format!("{body}.vx"), 20.0),
            (format!("{body}.pitch_rate"), -43.48 - 0.02 * phase.sin()),
        ];
        let inputs: Vec<(&str, f64)> = inputs.iter().map(|(n, v)| (n.as_str(), *v)).collect();
        assert_eq!(host.set_reals(&inputs), Status::Ok, "{}", host.last());
        let step = [1e-4, 0.0, 5e-6, 5e-4][i as usize % 4];
        let stepped = host.step(time, step);
        assert!(stepped <= Status::Warning, "{}", host.last());
        time += step;
        outputs(host)
    };
    steps.map(one).collect()
}

fn read(host: &Host, bytes: &[u8]) -> FmuState {
    let mut copy = null_mut();
    let start = bytes.as_ptr().cast::<c_char>();
    // SAFETY: FMI 2.0, 2.1.8: an array of as many bytes as the count says, a pointer to one state
    // pointer.
    let read =
        unsafe { fmi2DeSerializeFMUstate(host.component, start, bytes.len(), &raw mut copy) };
    assert_eq!(read, Status::Ok, "{}", host.last());
    copy
}

#[test]
fn states_hold_the_history_to_the_bit() {
    for (unit, loaded) in [(&WHEEL, false), (&WHEEL, true), (&WHEELSET, false)] {
        let host = remembering(unit, loaded);
        run(&host, 0..5);
        let mut state = null_mut();
        host.save(&mut state);
        let now = outputs(&host);
        let first = run(&host, 5..12);
        for _ in 0..2 {
            assert_eq!(fmi2SetFMUstate(host.component, state), Status::Ok, "{}", host.last());
            assert_eq!(outputs(&host), now);
            assert_eq!(run(&host, 5..12), first);
        }
        // Through bytes into an instance of other parameters, its outputs at once too.
        let bytes = host.serialize(state);
        let other = Host::initializing_with(&Arguments::of(unit));
        let copy = read(&other, &bytes);
        assert_eq!(fmi2SetFMUstate(other.component, copy), Status::Ok, "{}", other.last());
        assert_eq!(outputs(&other), now);
        assert_eq!(other.serialize(copy), bytes);
        let mut again = null_mut();
        other.save(&mut again);
        assert_eq!(other.serialize(again), bytes);
        assert_eq!(run(&other, 5..12), first);
        // Over an old state.
        host.save(&mut state);
        let second = run(&host, 12..15);
        assert_eq!(fmi2SetFMUstate(host.component, state), Status::Ok, "{}", host.last());
        assert_eq!(run(&host, 12..15), second);
    }
}

#[test]
fn steps_move_the_contact_on_and_reading_does_not() {
    let host = remembering(&WHEEL, false);
    run(&host, 0..2);
    let before = host.get_reals(&["wheel.force.x", "wheel.force.y"]).unwrap();
    // No step: nothing has slipped, whatever the velocities say.
    assert_eq!(host.set_reals(&[("wheel.pitch_rate", -43.9)]), Status::Ok);
    for _ in 0..3 {
        let read = host.get_reals(&["wheel.force.x", "wheel.force.y"]).unwrap();
        for (read, before) in read.iter().zip(&before) {
            assert!((read - before).abs() <= 1e-9 * before.abs().max(1e4), "{read} {before}");
        }
        assert_eq!(host.get_real("frictional_power").to_bits(), 0);
    }
    assert_eq!(host.step(0.0, 1e-4), Status::Ok, "{}", host.last());
    let after = host.get_real("wheel.force.x");
    assert!((after - before[0]).abs() > 1e3, "{after} {}", before[0]);
    assert!(host.get_real("frictional_power") > 0.0);
}

#[test]
fn broken_bytes_are_refused() {
    let host = remembering(&WHEEL, false);
    run(&host, 0..2);
    let mut state = null_mut();
    host.save(&mut state);
    let bytes = host.serialize(state);
    for cut in (0..bytes.len()).step_by(37) {
        let mut copy = null_mut();
        let start = bytes.as_ptr().cast::<c_char>();
        // SAFETY: as above, of fewer bytes.
        let read = unsafe { fmi2DeSerializeFMUstate(host.component, start, cut, &raw mut copy) };
        assert_eq!(read, Status::Error, "cut after {cut}");
    }
    // Good checksums over numbers that are none of a history.
    let (mut refused, mut tried) = (0, 0);
    for at in (bytes.len() / 3..bytes.len() - 12).step_by(61) {
        let mut damaged = bytes.clone();
        damaged[at..at + 8].fill(0xff);
        let end = damaged.len() - 4;
        let checksum = crc32fast::hash(&damaged[..end]);
        damaged[end..].copy_from_slice(&checksum.to_le_bytes());
        let mut copy = null_mut();
        let start = damaged.as_ptr().cast::<c_char>();
        // SAFETY: as above.
        let read =
            unsafe { fmi2DeSerializeFMUstate(host.component, start, damaged.len(), &raw mut copy) };
        // Whole numbers may be any.
        assert!([Status::Ok, Status::Error].contains(&read), "damaged at {at}: {read:?}");
        (refused, tried) = (refused + i32::from(read == Status::Error), tried + 1);
    }
    assert!(10 * refused > 8 * tried, "{refused} of {tried}");
}

#[test]
fn what_does_not_go_with_a_history_is_refused_by_name() {
    let arguments = Arguments { fmu_type: MODEL_EXCHANGE, ..Arguments::default() };
    let host = Host::instantiate(&arguments);
    assert_eq!(fmi2SetupExperiment(host.component, FALSE, 0.0, 0.5, FALSE, 0.0), Status::Ok);
    assert_eq!(fmi2EnterInitializationMode(host.component), Status::Ok);
    set_parameters(&host);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Error);
    assert!(host.last().contains("tangential.history = \"transient\""), "{}", host.last());
    assert!(host.last().contains("co-simulation"), "{}", host.last());
    let host = Host::initializing();
    set_parameters(&host);
    assert_eq!(host.set_boolean("coupling.monitor", true), Status::Ok);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Error);
    assert!(host.last().contains("with coupling.monitor"), "{}", host.last());
    assert_eq!(host.set_boolean("coupling.monitor", false), Status::Ok);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
    let (force, z, seed, mut found) =
        (host.reference("wheel.force.z"), host.reference("wheel.z"), 1.0, 0.0);
    let c = host.component;
    // SAFETY: FMI 2.0, 2.1.9: arrays of one element.
    let status = unsafe {
        fmi2GetDirectionalDerivative(
            c,
            &raw const force,
            1,
            &raw const z,
            1,
            &raw const seed,
            &raw mut found,
        )
    };
    assert_eq!(status, Status::Error);
    assert!(host.last().contains("tangential.history = transient"), "{}", host.last());
}

#[test]
fn fmi_3_steps_to_the_same_forces_and_goes_back() {
    let old = remembering(&WHEEL, false);
    let host = Host3::initializing(&WHEEL);
    for (name, choice) in [("normal.model", 5), ("tangential.model", 7), ("tangential.history", 2)]
    {
        assert_eq!(host.set_choice(name, choice), v3::types::Status::Ok, "{}", host.last());
    }
    for name in ["normal.elements_along", "normal.elements_across"] {
        assert_eq!(host.set_integer(name, 8), v3::types::Status::Ok, "{}", host.last());
    }
    let c = host.component;
    assert_eq!(v3::fmi3ExitInitializationMode(c), v3::types::Status::Ok, "{}", host.last());
    let one = |i: u32| {
        let phase = 0.9 * f64::from(i);
        let inputs = [("wheel.yaw", 2e-3 * phase.cos()), ("wheel.y", 0.747 + 1e-3 * phase.sin())];
        assert_eq!(host.set_reals(&inputs), v3::types::Status::Ok, "{}", host.last());
        assert!(host.step(1e-4 * f64::from(i), 1e-4) <= v3::types::Status::Warning);
        assert_eq!(old.set_reals(&inputs), Status::Ok, "{}", old.last());
        assert!(old.step(1e-4 * f64::from(i), 1e-4) <= Status::Warning, "{}", old.last());
        let force = host.get_real("wheel.force.x");
        assert_eq!(force.to_bits(), old.get_real("wheel.force.x").to_bits(), "step {i}");
        force.to_bits()
    };
    (0..3).for_each(|i| {
        one(i);
    });
    let (mut state, mut state_of_old) = (null_mut(), null_mut());
    // SAFETY: FMI 3.0, 2.2.12: a pointer to one state pointer.
    assert_eq!(unsafe { v3::fmi3GetFMUState(c, &raw mut state) }, v3::types::Status::Ok);
    old.save(&mut state_of_old);
    let first: Vec<u64> = (3..6).map(one).collect();
    assert_eq!(v3::fmi3SetFMUState(c, state), v3::types::Status::Ok, "{}", host.last());
    assert_eq!(fmi2SetFMUstate(old.component, state_of_old), Status::Ok);
    assert_eq!((3..6).map(one).collect::<Vec<u64>>(), first);
}
