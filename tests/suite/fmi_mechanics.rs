//! What the FMI interface says about the mechanics behind it: profiles that cannot be had, and the
//! dependencies declared in the model description.

use std::path::PathBuf;

use crate::host::Host;
use wheelrail::element::Element;
use wheelrail::fmi::v2::fmi2ExitInitializationMode;
use wheelrail::fmi::v2::types::Status;
use wheelrail::variables::{Causality, VARIABLES, Value, Values, WHEELSET, find};

#[test]
fn a_wrong_profile_path_is_refused_by_name_and_can_be_corrected() {
    let host = Host::initializing();
    assert_eq!(host.set_text("wheel.profile", "no_such_wheel.txt"), Status::Ok);
    assert_eq!(host.get_reals(&["nominal.wheel_z"]), Err(Status::Error));
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Error);
    let message = host.last();
    for words in ["fmi2ExitInitializationMode", "wheel.profile", "no_such_wheel.txt"] {
        assert!(message.contains(words), "{message}");
    }
    assert_eq!(host.set_text("wheel.profile", "S1002_worn.txt"), Status::Ok);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
    assert_eq!(host.step(0.0, 1e-3), Status::Ok);
}

#[test]
fn a_pressed_wheel_is_pushed_up() {
    let host = Host::initializing();
    let nominal = host.get_real("nominal.wheel_z");
    assert_eq!(host.set_reals(&[("wheel.z", nominal + 1e-4)]), Status::Ok);
    assert!(host.get_real("wheel.force.z") < -1e4);
    assert_eq!(host.get_integer("patch_count"), 1);
    assert_eq!(host.get_integer("patch[1].rail"), 1);
    assert_eq!(host.set_reals(&[("wheel.z", nominal - 1e-6)]), Status::Ok);
    assert!(host.get_real("wheel.force.z").abs() < f64::MIN_POSITIVE);
    assert_eq!(host.get_integer("patch_count"), 0);
}

#[test]
fn outputs_change_with_no_input_that_is_not_declared() {
    let mut values = Values::default();
    let folders: Vec<PathBuf> = Vec::new();
    let mut element = Element::new(&values.parameters, &values.input, &folders).unwrap();
    for (name, value) in [
        ("wheel.z", element.nominal_wheel_z() + 8e-5),
        ("wheel.y", 0.752),
        ("wheel.yaw", 4e-3),
        ("wheel.vx", 20.0),
        ("wheel.vy", 0.02),
        ("wheel.vz", 0.01),
        ("wheel.pitch_rate", -43.0),
    ] {
        values.set(find(name).unwrap(), Value::Real(value)).unwrap();
    }
    element.evaluate(&values.input, &mut values.output).unwrap();
    let base = values.clone();
    let mut changes = 0;
    for input in VARIABLES.iter().filter(|v| v.causality == Causality::Input) {
        let Value::Real(start) = base.get(input) else { continue };
        values.set(input, Value::Real(start + 2e-5)).unwrap();
        element.evaluate(&values.input, &mut values.output).unwrap();
        for output in VARIABLES.iter().filter(|v| v.causality == Causality::Output) {
            let changed = values.get(output) != base.get(output);
            let declared = output.dependencies.contains(&input.reference);
            assert!(declared || !changed, "{} depends on {}", output.name, input.name);
            changes += usize::from(changed);
        }
        values.input = base.input;
    }
    assert!(changes > 100, "the case is too dull: {changes} changes");
}

#[test]
fn start_values_show_a_loaded_rolling_wheel() {
    let (wheel, wheelset) = (Host::stepping(), Host::stepping_of(&WHEELSET));
    for (host, prefix, body, wheels) in
        [(&wheel, "", "wheel", 1.0), (&wheelset, "left.", "wheelset", 2.0)]
    {
        let force = -host.get_real(&format!("{body}.force.z")) / wheels;
        assert!(force > 6e4 && force < 1e5, "{body}: {force}");
        // It rolls: creepages of the order of the spin and the conicity.
        let creepage = host.get_real(&format!("{prefix}patch[1].creepage.longitudinal"));
        assert!(creepage.abs() < 1e-3, "{body}: {creepage}");
        assert!(host.get_real(&format!("{body}.force.x")).abs() < 0.1 * force);
    }
    let host = Host::initializing();
    assert_eq!(host.set_integer("vertical.mode", 2), Status::Ok);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok);
    assert!((host.get_real("vertical.load_carried") - 8e4).abs() < 1.0);
}
