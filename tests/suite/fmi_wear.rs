//! Wear in the unit: off until asked for, part of the state, written to files that can be read as
//! profiles.
#![allow(unsafe_code)]
// The box fixes the address that the logger gets.
#![allow(clippy::unnecessary_box_returns)]

use std::ffi::c_char;
use std::ptr::null_mut;

use crate::host::{Arguments, Host};
use tempfile::TempDir;
use wheelrail::fmi::v2::types::{FALSE, MODEL_EXCHANGE, Status};
use wheelrail::fmi::v2::*;
use wheelrail::geometry::profile::ProfileKind;
use wheelrail::io::{load_profile, save_profile};
use wheelrail::variables::{Kind, VARIABLES, WHEELSET};

/// A unit that wears by frictional work, strongly accelerated; profiles change every third step.
fn worn_parameters(host: &Host) {
    assert_eq!(host.set_integer("wear.model", 2), Status::Ok, "{}", host.last());
    let reals = [("wear.acceleration_factor", 1e6), ("wear.update_interval", 3e-3)];
    assert_eq!(host.set_reals(&reals), Status::Ok, "{}", host.last());
}

fn wearing() -> Box<Host> {
    let host = Host::initializing();
    worn_parameters(&host);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
    host
}

/// Steps a creeping wheel that sways; the bits of all real outputs after each.
fn run(host: &Host, steps: std::ops::Range<u32>) -> Vec<Vec<u64>> {
    let names: Vec<&str> = (VARIABLES.iter())
        .filter(|v| v.kind == Kind::Real && !v.is_settable())
        .map(|v| v.name)
        .collect();
    steps
        .map(|i| {
            let inputs = [
                ("wheel.z", -0.45975),
                ("wheel.y", 0.747 + 1e-3 * (0.7 * f64::from(i)).sin()),
                ("wheel.vx", 20.0),
                ("wheel.pitch_rate", -43.6),
                ("wheel.yaw", 0.004),
            ];
            assert_eq!(host.set_reals(&inputs), Status::Ok);
            let stepped = host.step(1e-3 * f64::from(i), 1e-3);
            assert!(stepped <= Status::Warning, "{}", host.last());
            let values = host.get_reals(&names).unwrap_or_else(|_| panic!("{}", host.last()));
            values.iter().map(|v| v.to_bits()).collect()
        })
        .collect()
}

#[test]
fn rollback_takes_wear_back_bit_for_bit() {
    let host = wearing();
    run(&host, 0..7);
    let mut state = null_mut();
    host.save(&mut state);
    let volume = host.get_real("wear.wheel.volume");
    assert!(volume > 0.0 && host.get_real("wear.wheel.depth") > 0.0);
    let first = run(&host, 7..16);
    assert!(host.get_real("wear.wheel.volume") > volume);
    for _ in 0..2 {
        assert_eq!(fmi2SetFMUstate(host.component, state), Status::Ok, "{}", host.last());
        assert_eq!(host.get_real("wear.wheel.volume").to_bits(), volume.to_bits());
        assert_eq!(run(&host, 7..16), first);
    }
    // Over an old state too.
    host.save(&mut state);
    let second = run(&host, 16..20);
    assert_eq!(fmi2SetFMUstate(host.component, state), Status::Ok, "{}", host.last());
    assert_eq!(run(&host, 16..20), second);
}

#[test]
fn wear_goes_through_bytes_to_another_instance() {
    let host = wearing();
    run(&host, 0..7);
    let mut state = null_mut();
    host.save(&mut state);
    let bytes = host.serialize(state);
    let first = run(&host, 7..12);
    let other = Host::new();
    let mut copy = null_mut();
    let start = bytes.as_ptr().cast::<c_char>();
    // SAFETY: FMI 2.0, 2.1.8: an array of as many bytes as the count says, a pointer to one state
    // pointer.
    let read =
        unsafe { fmi2DeSerializeFMUstate(other.component, start, bytes.len(), &raw mut copy) };
    assert_eq!(read, Status::Ok, "{}", other.last());
    assert_eq!(fmi2SetFMUstate(other.component, copy), Status::Ok, "{}", other.last());
    assert_eq!(run(&other, 7..12), first);
    assert_eq!(other.serialize(copy), bytes);
}

#[test]
fn outputs_read_again_and_steps_of_no_length_wear_nothing_off() {
    let host = wearing();
    run(&host, 0..4);
    let volume = host.get_real("wear.wheel.volume");
    for _ in 0..3 {
        assert_eq!(host.step(4e-3, 0.0), Status::Ok);
        assert_eq!(host.set_reals(&[("wheel.y", 0.7475)]), Status::Ok);
        assert!(host.get_real("frictional_power") > 0.0);
        assert_eq!(host.get_real("wear.wheel.volume").to_bits(), volume.to_bits());
    }
}

#[test]
fn without_a_law_nothing_wears() {
    let host = Host::stepping();
    run(&host, 0..10);
    for name in ["wear.wheel.volume", "wear.rail[1].area", "wear.wheel.depth"] {
        assert_eq!(host.get_real(name).to_bits(), 0);
    }
}

#[test]
fn model_exchange_refuses_wear_by_name() {
    let arguments = Arguments { fmu_type: MODEL_EXCHANGE, ..Arguments::default() };
    let host = Host::instantiate(&arguments);
    assert_eq!(fmi2SetupExperiment(host.component, FALSE, 0.0, 0.5, FALSE, 0.0), Status::Ok);
    assert_eq!(fmi2EnterInitializationMode(host.component), Status::Ok);
    worn_parameters(&host);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Error);
    assert!(host.last().contains("wear.model = \"frictional_work\""), "{}", host.last());
    assert!(host.last().contains("co-simulation"));
}

#[test]
fn uneven_bodies_and_bad_coefficients_are_refused_by_name() {
    let host = Host::initializing();
    worn_parameters(&host);
    assert_eq!(host.set_reals(&[("rail[1].corrugation.amplitude", 1e-5)]), Status::Ok);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Error);
    assert!(host.last().contains("wear.model"), "{}", host.last());
    assert_eq!(host.set_reals(&[("wear.wheel.density", -1.0)]), Status::Error);
    assert!(host.last().contains("wear.wheel.density"), "{}", host.last());
}

#[test]
fn the_end_of_a_run_writes_profiles_that_can_be_read_back() {
    let folder = TempDir::new().unwrap();
    let file = |name: &str| folder.path().join(name).display().to_string();
    let host = Host::initializing();
    worn_parameters(&host);
    assert_eq!(host.set_text("wear.wheel.file", &file("wheel.csv")), Status::Ok);
    assert_eq!(host.set_text("wear.rail[1].file", &file("rail.csv")), Status::Ok);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
    run(&host, 0..10);
    let depth = host.get_real("wear.wheel.depth");
    assert_eq!(fmi2Terminate(host.component), Status::Ok, "{}", host.last());
    let folders = [folder.path().to_path_buf()];
    for (name, kind, new) in
        [("wheel.csv", ProfileKind::Wheel, "S1002"), ("rail.csv", ProfileKind::Rail, "60E1")]
    {
        // The file says that it is not to be smoothed.
        let worn = load_profile("p", name, kind, 0.004, &folders).unwrap();
        let new = load_profile("p", new, kind, 0.0, &[]).unwrap();
        let height = |curve: &wheelrail::geometry::curve::Curve, y: f64| {
            let (mut low, mut high) = (curve.start(), curve.end());
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if curve.at(middle).point[0] < y { low = middle } else { high = middle }
            }
            curve.at(low).point[1]
        };
        let deepest = (-200..=200)
            .map(|i| 1e-4 * f64::from(i))
            .map(|y| (height(&worn.curve, y) - height(&new.curve, y)).abs())
            .fold(0.0, f64::max);
        println!("{name}: {deepest:e}, {depth:e}");
        if kind == ProfileKind::Wheel {
            assert!(deepest > 0.99 * depth && deepest < 1.5 * depth);
        }
        assert!(deepest > 0.0);
    }
    // As a profile of the next run.
    let next = Host::initializing();
    assert_eq!(next.set_text("wheel.profile", &file("wheel.csv")), Status::Ok);
    assert_eq!(fmi2ExitInitializationMode(next.component), Status::Ok, "{}", next.last());
}

#[test]
fn a_file_that_cannot_be_written_is_named_before_the_run() {
    let host = Host::initializing();
    worn_parameters(&host);
    let folder = TempDir::new().unwrap();
    let taken = folder.path().display().to_string();
    for file in ["/nowhere/at/all/wheel.csv", &taken] {
        assert_eq!(host.set_text("wear.wheel.file", file), Status::Ok);
        assert_eq!(fmi2ExitInitializationMode(host.component), Status::Error);
        assert!(host.last().contains("wear.wheel.file") && host.last().contains(file));
        assert!(host.last().contains("cannot be written"), "{}", host.last());
    }
    // Its folder may go away during the run.
    let file = folder.path().join("wheel.csv").display().to_string();
    assert_eq!(host.set_text("wear.wheel.file", &file), Status::Ok);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
    drop(folder);
    run(&host, 0..1);
    assert_eq!(fmi2Terminate(host.component), Status::Error);
    assert!(host.last().contains("wear.wheel.file") && host.last().contains(&file));
}

#[test]
fn files_of_worn_profiles_overwrite_neither_each_other_nor_what_is_read() {
    let folder = TempDir::new().unwrap();
    let inside = |name: &str| folder.path().join(name).display().to_string();
    let new = load_profile("p", "S1002", ProfileKind::Wheel, 0.0, &[]).unwrap();
    let input = folder.path().join("new.csv");
    save_profile("p", &input, &new).unwrap();
    let host = Host::initializing();
    worn_parameters(&host);
    let set = |name: &str, file: &str| assert_eq!(host.set_text(name, file), Status::Ok);
    let refused = |words: &str| {
        assert_eq!(fmi2ExitInitializationMode(host.component), Status::Error);
        assert!(host.last().contains(words), "{}", host.last());
    };
    set("wheel.profile", &inside("new.csv"));
    set("wear.wheel.file", &inside("./new.csv"));
    refused("a file of its own: wheel.profile names this one too");
    set("wear.wheel.file", &inside("worn.csv"));
    set("wear.rail[1].file", &format!("{}/./worn.csv", folder.path().display()));
    refused("wear.rail[1].file = ");
    assert!(host.last().contains("wear.wheel.file names this one too"), "{}", host.last());
    set("wear.rail[1].file", &inside("rail.csv"));
    // Rail 2 is off.
    set("wear.rail[2].file", &inside("rail.csv"));
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn both_sides_of_a_wheelset_do_not_write_to_one_file() {
    let folder = TempDir::new().unwrap();
    let file = folder.path().join("worn.csv").display().to_string();
    let host = Host::initializing_with(&Arguments::of(&WHEELSET));
    worn_parameters(&host);
    for side in ["right", "left"] {
        assert_eq!(host.set_text(&format!("{side}.wear.wheel.file"), &file), Status::Ok);
    }
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Error);
    for words in ["left.wear.wheel.file = ", "right.wear.wheel.file names this one too"] {
        assert!(host.last().contains(words), "{}", host.last());
    }
}
