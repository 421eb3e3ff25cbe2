//! Rails on a foundation behind the FMI interface: steps move those with a mass on, and can be
//! taken back.
#![allow(unsafe_code)]
// The box fixes the address that the logger gets.
#![allow(clippy::unnecessary_box_returns)]

use crate::allocations;
use std::ffi::c_char;
use std::ptr::null_mut;

use crate::host::{Arguments, Host};
use wheelrail::element::parameters::{Foundation, FoundationModel};
use wheelrail::fmi::v2::types::{MODEL_EXCHANGE, Status};
use wheelrail::fmi::v2::*;
use wheelrail::variables::{Kind, WHEEL, WHEELSET, WheelsetValues};
use wheelrail::wheelset::{Parameters, Wheelset};

const MASSLESS: i32 = 2;
const MASS: i32 = 3;
/// Pressed as deep as rails on springs sink.
const DEEP: [(&str, f64); 4] = [
    ("wheelset.z", -0.4587),
    ("wheelset.y", 1e-3),
    ("wheelset.yaw", 2e-3),
    ("wheelset.pitch_rate", -43.4),
];

fn on(model: i32) -> Box<Host> {
    let host = Host::initializing_with(&Arguments::of(&WHEELSET));
    assert_eq!(host.set_integer("track.foundation.model", model), Status::Ok, "{}", host.last());
    assert_eq!(host.set_reals(&DEEP), Status::Ok, "{}", host.last());
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
    host
}

fn outputs(host: &Host) -> Vec<u64> {
    let outputs = host.unit.variables.iter();
    let names: Vec<&str> =
        outputs.filter(|v| v.kind == Kind::Real && !v.is_settable()).map(|v| v.name).collect();
    let values = host.get_reals(&names).unwrap_or_else(|_| panic!("{}", host.last()));
    values.iter().map(|v| v.to_bits()).collect()
}

/// A wheelset that goes down and up again, its velocity the derivative of its height; all outputs
/// after each step.
fn run(host: &Host, steps: std::ops::Range<u32>) -> Vec<Vec<u64>> {
    let one = |i: u32| {
        let time = 1e-3 * f64::from(i);
        let (height, rate) = (-0.4587 + 1e-4 * (0.7 * f64::from(i)).sin(), 0.05);
        let inputs = [("wheelset.z", height), ("wheelset.vz", rate)];
        assert_eq!(host.set_reals(&inputs), Status::Ok, "{}", host.last());
        assert_eq!(host.set_input_derivatives(&[("wheelset.z", 1, rate)]), Status::Ok);
        assert_eq!(host.step(time, 1e-3), Status::Ok, "{}", host.last());
        outputs(host)
    };
    steps.map(one).collect()
}

#[test]
fn steps_move_the_rails_in_parts_along_the_way_of_the_inputs() {
    let host = on(MASS);
    let foundation = Foundation { model: FoundationModel::Mass, ..Foundation::default() };
    let mut parameters = Parameters::default();
    for side in &mut parameters.sides {
        side.foundation = foundation;
    }
    let mut values = WheelsetValues::default();
    for (name, value) in DEEP {
        values.set(WHEELSET.find(name).unwrap(), wheelrail::variables::Value::Real(value)).unwrap();
    }
    let mut wheelset = Wheelset::new(&parameters, &values.input, &[]).unwrap();
    // Down with 0.1 m/s and 20 m/s²: the place is a parabola.
    let (speed, more) = (0.1, 20.0);
    let derivatives = [("wheelset.z", 1, speed), ("wheelset.z", 2, more), ("wheelset.vz", 1, more)];
    assert_eq!(host.set_reals(&[("wheelset.vz", speed)]), Status::Ok);
    assert_eq!(host.set_input_derivatives(&derivatives), Status::Ok);
    let step = 9.5e-4;
    assert_eq!(host.step(0.0, step), Status::Ok, "{}", host.last());
    let mut input = values.input;
    let mut errors = [0.0_f64; 2];
    input.wheelset.velocity[2] = speed;
    // No part is longer than 0.1 ms.
    for part in 1..=10 {
        let from = input;
        let time = step * f64::from(part) / 10.0;
        input.wheelset.position[2] = -0.4587 + time * (speed + 0.5 * time * more);
        input.wheelset.velocity[2] = speed + time * more;
        wheelset.move_rails(&from, &input, step / 10.0).unwrap();
        for (most, element) in errors.iter_mut().zip(wheelset.elements()) {
            *most = most.max(element.track_state().unwrap().step_error);
        }
    }
    for (k, side) in ["right", "left"].into_iter().enumerate() {
        let state = wheelset.elements()[k].track_state().unwrap();
        for (name, value) in [
            ("deflection.z", state.deflection[1]),
            ("velocity.z", state.velocity[1]),
            ("step_error", errors[k]),
        ] {
            let found = host.get_real(&format!("{side}.foundation.{name}"));
            assert!((found / value - 1.0).abs() < 1e-9, "{side}.{name}: {found} {value}");
        }
        assert!(state.velocity[1] > 0.05, "{state:?}");
    }
    // A step of no length moves nothing.
    let before = outputs(&host);
    assert_eq!(host.step(step, 0.0), Status::Ok);
    assert_eq!(outputs(&host), before);
}

#[test]
fn a_run_on_moving_rails_is_taken_back_bit_for_bit_here_and_in_another_instance() {
    let host = on(MASS);
    // Before the first step the rails rest, whatever the inputs.
    let mut state = null_mut();
    host.save(&mut state);
    let first = run(&host, 0..6);
    assert_eq!(fmi2SetFMUstate(host.component, state), Status::Ok);
    assert_eq!(run(&host, 0..3), first[..3]);
    host.save(&mut state);
    assert_eq!(run(&host, 3..6), first[3..]);
    assert_eq!(fmi2SetFMUstate(host.component, state), Status::Ok);
    assert_eq!(outputs(&host), first[2]);
    let bytes = host.serialize(state);
    let other = Host::initializing_with(&Arguments::of(&WHEELSET));
    let (start, mut copy) = (bytes.as_ptr().cast::<c_char>(), null_mut());
    // SAFETY: FMI 2.0, 2.1.8: an array of as many bytes as the count says, a pointer to one state
    // pointer.
    let read =
        unsafe { fmi2DeSerializeFMUstate(other.component, start, bytes.len(), &raw mut copy) };
    assert_eq!(read, Status::Ok, "{}", other.last());
    assert_eq!(fmi2SetFMUstate(other.component, copy), Status::Ok, "{}", other.last());
    assert_eq!(outputs(&other), first[2]);
    assert_eq!(run(&other, 3..6), first[3..]);
    assert_eq!(other.serialize(copy), bytes);
    assert_eq!(fmi2Reset(host.component), Status::Ok);
}

#[test]
fn a_step_that_is_refused_leaves_rails_and_inputs() {
    let host = on(MASS);
    run(&host, 0..2);
    let before = outputs(&host);
    assert_eq!(host.set_reals(&[("right.friction.coefficient", 0.3)]), Status::Ok);
    let falling = [("right.friction.coefficient", 1, -1e3)];
    assert_eq!(host.set_input_derivatives(&falling), Status::Ok);
    assert_eq!(host.step(2e-3, 1e-3), Status::Error);
    assert!(host.last().contains("right.friction.coefficient = -"), "{}", host.last());
    assert_eq!(outputs(&host), before);
}

#[test]
fn nothing_is_allocated_on_rails_that_give_way() {
    for model in [MASSLESS, MASS] {
        let host = on(model);
        let references = ["wheelset.force.z", "right.foundation.deflection.z"];
        let references = references.map(|name| host.reference(name));
        let places = ["wheelset.z", "wheelset.y"].map(|name| host.reference(name));
        let before = allocations::count();
        for i in 0..20_u32 {
            let values = [-0.4587 + 1e-5 * f64::from(i), 1e-4 * f64::from(i)];
            let mut found = [0.0; 2];
            // SAFETY: FMI 2.0, 2.1.7: arrays of two elements.
            unsafe {
                fmi2SetReal(host.component, places.as_ptr(), 2, values.as_ptr());
                fmi2DoStep(host.component, 1e-3 * f64::from(i), 1e-3, 1);
                fmi2GetReal(host.component, references.as_ptr(), 2, found.as_mut_ptr());
            }
            assert!(found[0] < -1e4 && found[1] > 1e-4, "{found:?}");
        }
        assert_eq!(allocations::count() - before, 0);
    }
}

#[test]
fn a_host_that_integrates_has_rails_with_a_mass_of_its_own() {
    for unit in [&WHEEL, &WHEELSET] {
        let arguments = Arguments { fmu_type: MODEL_EXCHANGE, ..Arguments::of(unit) };
        let host = Host::initializing_with(&arguments);
        assert_eq!(host.set_integer("track.foundation.model", MASS), Status::Ok);
        assert_eq!(fmi2ExitInitializationMode(host.component), Status::Error);
        let message = host.last();
        assert!(message.contains("track.foundation.model = \"mass\""), "{message}");
        assert_eq!(host.set_integer("track.foundation.model", MASSLESS), Status::Ok);
        assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
    }
}
