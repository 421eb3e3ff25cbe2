//! Variables and arrays: read, set, and refused by name.

use std::ptr::{null, null_mut};

use wheelrail::fmi::v3::types::{Status, ValueReference};
use wheelrail::fmi::v3::*;
use wheelrail::variables::{WHEEL, WHEELSET};

use crate::host3::Host3;

#[test]
fn an_array_holds_all_patches_the_heaviest_first() {
    let host = Host3::stepping(&WHEELSET);
    let names = ["left.patch.normal_force", "wheelset.force.z", "right.patch.position.y"];
    let values = host.get_reals(&names, 17).unwrap();
    let (left, right) = (&values[..8], &values[9..]);
    assert!(left[0] > 5e4 && left[1..].iter().all(|force| *force <= left[0]));
    assert!((right[0] - 0.75).abs() < 0.02, "{right:?}");
    assert!(values[8] < -1e5);
    let names = ["left.patch.rail", "patch_count"];
    let numbers = host.get_integers(&names, 9).unwrap();
    assert_eq!(numbers[0], 1);
    assert_eq!(numbers[..8].iter().filter(|rail| **rail > 0).count() * 2, numbers[8] as usize);
}

#[test]
fn choices_texts_and_flags_have_functions_of_their_own() {
    let host = Host3::initializing(&WHEEL);
    assert_eq!(host.get_choice("normal.model"), Ok(4));
    assert_eq!(host.set_choice("normal.model", 1), Status::Ok);
    assert_eq!(host.get_choice("normal.model"), Ok(1));
    assert_eq!(host.set_integer("normal.strips", 30), Status::Ok);
    assert_eq!(host.get_integers(&["normal.strips"], 1), Ok(vec![30]));
    assert_eq!(host.set_text("wheel.profile", "conical:0.05"), Status::Ok);
    assert_eq!(host.get_text("wheel.profile"), "conical:0.05");
    let (enabled, on, mut read) = (host.reference("rail[2].enabled"), 2, 7);
    // SAFETY: FMI 3.0, 2.2.6: arrays of one element.
    unsafe {
        let c = host.component;
        assert_eq!(fmi3SetBoolean(c, &raw const enabled, 1, &raw const on, 1), Status::Ok);
        assert_eq!(fmi3GetBoolean(c, &raw const enabled, 1, &raw mut read, 1), Status::Ok);
    }
    // Whatever byte a host takes for true.
    assert_eq!(read, 1);
}

#[test]
fn what_is_refused_names_variable_and_value_and_changes_nothing() {
    let host = Host3::initializing(&WHEEL);
    let says = |refused: bool, words: &str| {
        assert!(refused && host.last().contains(words), "{} for {words}", host.last());
    };
    says(
        host.set_reals(&[("wheel.y", 0.76), ("friction.coefficient", -0.1)]) == Status::Error,
        "fmi3SetFloat64: friction.coefficient = -0.1 is not admitted",
    );
    assert!(host.reads("wheel.y", 0.75));
    says(host.set_choice("normal.model", 9) == Status::Error, "normal.model = 9 is not admitted");
    let beyond = i64::from(u32::MAX) + 2;
    says(host.set_choice("normal.model", beyond) == Status::Error, "normal.model = ");
    says(
        host.set_integer("normal.model", 1) == Status::Error,
        "fmi3SetInt32: normal.model is of type Enumeration (set and read as Int64)",
    );
    says(
        host.get_choice("normal.strips") == Err(Status::Error),
        "fmi3GetInt64: normal.strips is of type Int32",
    );
    says(
        host.get_integers(&["patch.normal_force"], 8) == Err(Status::Error),
        "fmi3GetInt32: patch.normal_force is of type Float64",
    );
    says(host.get_integers(&["time"], 1) == Err(Status::Error), "time is of type Float64");
    for computed in ["wheel.force.z", "patch.normal_force", "time", "event_indicator"] {
        let words = format!("{computed}{}", if computed == "wheel.force.z" { " = 1" } else { "" });
        says(host.set_reals(&[(computed, 1.0)]) == Status::Error, &words);
        assert!(host.last().contains("computed by the element and cannot be set"));
    }
    says(
        host.get_reals(&["patch.normal_force"], 1) == Err(Status::Error),
        "argument nValues = 1, but the variables have 8 elements",
    );
    let element = host.reference("patch.normal_force")
        + WHEEL
            .variables
            .iter()
            .filter(|v| {
                v.array.is_some() && v.name.starts_with("patch[1]") && v.array != Some("patch.rail")
            })
            .count() as ValueReference;
    let beyond = host.reference("event_indicator") + 1;
    let mut value = 0.0;
    // SAFETY: FMI 3.0, 2.2.6: arrays of one element, or null, which is refused.
    unsafe {
        let c = host.component;
        let first = host.reference("patch.normal_force");
        let read = fmi3GetFloat64(c, &raw const element, 1, &raw mut value, 1);
        let words = format!(
            "value reference {element} does not exist: that of patch.normal_force is {first}"
        );
        says(read == Status::Error, &words);
        let read = fmi3GetFloat64(c, &raw const beyond, 1, &raw mut value, 1);
        says(read == Status::Error, &format!("value reference {beyond} does not exist"));
        let read = fmi3GetFloat64(c, null(), 1, &raw mut value, 1);
        says(read == Status::Error, "argument valueReferences is null");
        let read = fmi3GetFloat64(c, &raw const first, 1, null_mut(), 8);
        says(read == Status::Error, "argument values is null");
        assert_eq!(fmi3GetFloat64(c, null(), 0, null_mut(), 0), Status::Ok);
    }
}
