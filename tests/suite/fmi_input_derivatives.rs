//! Inputs that go on with their time derivatives over a step.
#![allow(unsafe_code)]

use std::ptr::null_mut;

use crate::host::Host;
use wheelrail::fmi::v2::types::Status;
use wheelrail::fmi::v2::*;

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-15
}

#[test]
fn outputs_after_a_step_belong_to_inputs_at_its_end() {
    let (host, other) = (Host::stepping(), Host::stepping());
    for h in [&host, &other] {
        assert_eq!(h.set_reals(&[("wheel.z", -0.4597), ("wheel.vx", 20.0)]), Status::Ok);
    }
    let set =
        [("wheel.y", 1, 2.0), ("wheel.y", 2, 30.0), ("wheel.y", 3, 600.0), ("wheel.z", 1, 0.01)];
    assert_eq!(host.set_input_derivatives(&set), Status::Ok, "{}", host.last());
    assert_eq!(host.step(0.0, 1e-3), Status::Ok);
    let y = host.get_real("wheel.y");
    assert!(close(y, 0.75 + 2e-3 + 15e-6 + 100e-9), "{y}");
    let z = host.get_real("wheel.z");
    assert!(close(z, -0.4597 + 1e-5), "{z}");
    assert_eq!(other.set_reals(&[("wheel.y", y), ("wheel.z", z)]), Status::Ok);
    let force = |h: &Host| h.get_real("wheel.force.y").to_bits();
    assert_eq!(force(&host), force(&other));
    // Good for one step.
    assert_eq!(host.step(1e-3, 1e-3), Status::Ok);
    assert_eq!(host.get_real("wheel.y").to_bits(), y.to_bits());
}

#[test]
fn derivatives_are_part_of_the_state() {
    let host = Host::stepping();
    assert_eq!(host.set_input_derivatives(&[("wheel.y", 1, 1.0)]), Status::Ok);
    let mut state = null_mut();
    // SAFETY: FMI 2.0, 2.1.8: a pointer to one state pointer.
    assert_eq!(unsafe { fmi2GetFMUstate(host.component, &raw mut state) }, Status::Ok);
    for _ in 0..2 {
        assert_eq!(host.step(0.0, 1e-3), Status::Ok);
        assert!(close(host.get_real("wheel.y"), 0.751));
        assert_eq!(fmi2SetFMUstate(host.component, state), Status::Ok);
        assert!(close(host.get_real("wheel.y"), 0.75));
    }
}

#[test]
fn what_is_refused_names_itself_and_changes_nothing() {
    let host = Host::stepping();
    let good = ("wheel.y", 1, 1.0);
    for (bad, words) in [
        (("track.gauge", 1, 1.0), "track.gauge is no input"),
        (("wheel.force.z", 1, 1.0), "wheel.force.z is no input"),
        (("wheel.z", 0, 1.0), "order = 0"),
        (("wheel.z", 4, 1.0), "order = 4"),
        (("wheel.z", 2, f64::NAN), "derivative 2 of wheel.z = NaN"),
    ] {
        assert_eq!(host.set_input_derivatives(&[good, bad]), Status::Error);
        assert!(host.last().contains(words), "{}", host.last());
    }
    assert_eq!(host.step(0.0, 1e-3), Status::Ok);
    assert_eq!(host.get_real("wheel.y").to_bits(), 0.75_f64.to_bits());
    // An input that leaves its range on the way.
    assert_eq!(host.set_input_derivatives(&[good, ("friction.coefficient", 1, -1e3)]), Status::Ok);
    assert_eq!(host.step(1e-3, 1e-3), Status::Error);
    assert!(host.last().contains("friction.coefficient = -0.7"), "{}", host.last());
    assert_eq!(host.get_real("wheel.y").to_bits(), 0.75_f64.to_bits());
}
