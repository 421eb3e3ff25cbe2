//! The wheelset behind the FMI interface: the same library, chosen by its GUID, can all that the
//! wheel unit can.
#![allow(unsafe_code)]
// The box fixes the address that the logger gets.
#![allow(clippy::unnecessary_box_returns)]

use crate::allocations;
use std::ffi::c_char;
use std::ptr::null_mut;

use crate::host::{Arguments, Host};
use wheelrail::fmi::v2::types::{FALSE, FmuState, MODEL_EXCHANGE, Status, TRUE, ValueReference};
use wheelrail::fmi::v2::*;
use wheelrail::geometry::profile::ProfileKind;
use wheelrail::io::load_profile;
use wheelrail::variables::{Causality, Kind, Unit, Value, WHEEL, WHEELSET, WheelsetValues};
use wheelrail::wheelset::{Input, Wheelset};

const PRESSED: [(&str, f64); 8] = [
    ("wheelset.z", -0.4597),
    ("wheelset.y", 1e-3),
    ("wheelset.yaw", 2e-3),
    ("wheelset.vx", 20.0),
    ("wheelset.pitch_rate", -43.4),
    ("left.rail[1].z", -1e-5),
    ("right.friction.coefficient", 0.35),
    ("track.s", 3.0),
];

fn real_outputs(unit: &Unit) -> Vec<&'static str> {
    let outputs = unit.variables.iter().filter(|v| v.kind == Kind::Real && !v.is_settable());
    outputs.map(|v| v.name).collect()
}

fn outputs(host: &Host) -> Vec<u64> {
    let values =
        host.get_reals(&real_outputs(host.unit)).unwrap_or_else(|_| panic!("{}", host.last()));
    values.iter().map(|v| v.to_bits()).collect()
}

/// Steps a wheelset that moves sideways; the bits of all real outputs after each.
fn run(host: &Host, steps: std::ops::Range<u32>, sideways: f64) -> Vec<Vec<u64>> {
    let one = |i: u32| {
        let time = 1e-3 * f64::from(i);
        assert_eq!(host.set_reals(&PRESSED), Status::Ok, "{}", host.last());
        assert_eq!(host.set_reals(&[("wheelset.y", sideways * f64::from(i))]), Status::Ok);
        assert!(host.step(time, 1e-3) <= Status::Warning, "{}", host.last());
        outputs(host)
    };
    steps.map(one).collect()
}

fn save(host: &Host) -> FmuState {
    let mut state = null_mut();
    // SAFETY: FMI 2.0, 2.1.8: a pointer to one state pointer.
    let saved = unsafe { fmi2GetFMUstate(host.component, &raw mut state) };
    assert_eq!(saved, Status::Ok, "{}", host.last());
    state
}

fn deserialize(host: &Host, bytes: &[u8]) -> Result<FmuState, String> {
    let (start, mut state) = (bytes.as_ptr().cast::<c_char>(), null_mut());
    // SAFETY: FMI 2.0, 2.1.8: an array of as many bytes as the count says, a pointer to one state
    // pointer.
    let read =
        unsafe { fmi2DeSerializeFMUstate(host.component, start, bytes.len(), &raw mut state) };
    if read == Status::Ok { Ok(state) } else { Err(host.last()) }
}

/// A unit that wears by frictional work, strongly accelerated; profiles change every third step.
fn wearing() -> Box<Host> {
    let host = Host::initializing_with(&Arguments::of(&WHEELSET));
    assert_eq!(host.set_integer("wear.model", 2), Status::Ok, "{}", host.last());
    let reals = [("wear.acceleration_factor", 1e6), ("wear.update_interval", 3e-3)];
    assert_eq!(host.set_reals(&reals), Status::Ok, "{}", host.last());
    host
}

#[test]
fn every_output_is_that_of_the_wheelset() {
    let host = Host::initializing_with(&Arguments::of(&WHEELSET));
    let mut values = WheelsetValues::default();
    for (name, value) in PRESSED.into_iter().chain([("flange_back_distance", 1.358)]) {
        assert_eq!(host.set_reals(&[(name, value)]), Status::Ok, "{}", host.last());
        values.set(WHEELSET.find(name).unwrap(), Value::Real(value)).unwrap();
    }
    assert_eq!(host.set_text("left.wheel.profile", "conical:0.05"), Status::Ok);
    let profile = WHEELSET.find("left.wheel.profile").unwrap();
    values.set(profile, Value::Text("conical:0.05")).unwrap();
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
    let mut wheelset = Wheelset::new(&values.parameters, &values.input, &[]).unwrap();
    values.nominal = wheelset.nominal_heights();
    wheelset.evaluate(&values.input, &mut values.output).unwrap();
    assert!(values.output.sides.iter().all(|side| side.patch_count > 0));
    for v in WHEELSET.variables {
        match values.get(v) {
            Value::Real(wanted) => {
                assert_eq!(host.get_real(v.name).to_bits(), wanted.to_bits(), "{}", v.name);
            }
            Value::Integer(wanted) => assert_eq!(host.get_integer(v.name), wanted, "{}", v.name),
            Value::Boolean(_) | Value::Text(_) => {}
        }
    }
}

/// What `ModelStructure` leaves out has no influence.
#[test]
fn outputs_change_with_no_input_that_is_not_declared() {
    only_declared_inputs_matter(&Host::stepping_of(&WHEELSET));
    let host = Host::initializing_with(&Arguments::of(&WHEELSET));
    assert_eq!(host.set_integer("vertical.mode", 2), Status::Ok, "{}", host.last());
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
    let loads = [("right.wheel.load", 5e4), ("left.wheel.load", 6e4)];
    assert_eq!(host.set_reals(&loads), Status::Ok, "{}", host.last());
    only_declared_inputs_matter(&host);
}

fn only_declared_inputs_matter(host: &Host) {
    let moved = [("right.rail[1].roll", 1e-3), ("wheelset.roll", 1e-5)];
    let inputs: Vec<_> =
        WHEELSET.variables.iter().filter(|v| v.causality == Causality::Input).collect();
    let all: Vec<_> =
        WHEELSET.variables.iter().filter(|v| v.causality == Causality::Output).collect();
    let read = || -> Vec<f64> {
        let value = |name: &str, kind| match kind {
            Kind::Integer => f64::from(host.get_integer(name)),
            _ => host.get_real(name),
        };
        all.iter().map(|v| value(v.name, v.kind)).collect()
    };
    assert_eq!(host.set_reals(&PRESSED), Status::Ok);
    assert_eq!(host.set_reals(&moved), Status::Ok);
    let before = read();
    let mut influences = 0;
    for input in inputs {
        let value = host.get_real(input.name);
        assert_eq!(host.set_reals(&[(input.name, value + 1e-5)]), Status::Ok);
        for (output, (a, b)) in all.iter().zip(before.iter().zip(read())) {
            let changed = a.to_bits() != b.to_bits();
            influences += usize::from(changed);
            let declared = output.dependencies.contains(&input.reference);
            assert!(declared || !changed, "{} changes {}", input.name, output.name);
        }
        assert_eq!(host.set_reals(&[(input.name, value)]), Status::Ok);
    }
    assert!(influences > 500, "{influences}");
}

#[test]
fn a_run_taken_back_goes_on_bit_for_bit_here_and_in_another_instance() {
    let host = wearing();
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
    run(&host, 0..5, 1e-4);
    let state = save(&host);
    let first = run(&host, 5..12, 2e-4);
    assert_eq!(fmi2SetFMUstate(host.component, state), Status::Ok);
    assert_eq!(run(&host, 5..12, 2e-4), first);
    let bytes = host.serialize(state);
    let other = Host::initializing_with(&Arguments::of(&WHEELSET));
    assert_eq!(other.set_text("right.wheel.profile", "conical:0.05"), Status::Ok);
    let copy = deserialize(&other, &bytes).unwrap();
    assert_eq!(fmi2SetFMUstate(other.component, copy), Status::Ok, "{}", other.last());
    assert_eq!(run(&other, 5..12, 2e-4), first);
    assert_eq!(other.serialize(copy), bytes);
}

#[test]
fn bytes_of_the_other_unit_are_refused_by_its_name() {
    let (wheel, wheelset) = (Host::stepping_of(&WHEEL), Host::stepping_of(&WHEELSET));
    for (from, to, words) in [
        (&wheel, &wheelset, "is of WheelRail, this unit is WheelSet"),
        (&wheelset, &wheel, "is of WheelSet, this unit is WheelRail"),
    ] {
        let bytes = from.serialize(save(from));
        let message = deserialize(to, &bytes).unwrap_err();
        assert!(message.contains(words), "{message}");
        // Damage is found here too.
        let mut damaged = to.serialize(save(to));
        let middle = damaged.len() / 2;
        damaged[middle] ^= 4;
        assert!(deserialize(to, &damaged).unwrap_err().contains("damaged"));
    }
}

#[test]
fn input_derivatives_move_the_wheelset_over_the_step() {
    let (host, other) = (Host::stepping_of(&WHEELSET), Host::stepping_of(&WHEELSET));
    for h in [&host, &other] {
        assert_eq!(h.set_reals(&PRESSED), Status::Ok);
    }
    let rates = [("wheelset.y", 1, 2.0), ("left.rail[1].z", 1, -0.01)];
    assert_eq!(host.set_input_derivatives(&rates), Status::Ok, "{}", host.last());
    assert_eq!(host.step(0.0, 1e-3), Status::Ok);
    assert!((host.get_real("wheelset.y") - 3e-3).abs() < 1e-15);
    for name in ["wheelset.y", "left.rail[1].z"] {
        assert_eq!(other.set_reals(&[(name, host.get_real(name))]), Status::Ok);
    }
    assert_eq!(outputs(&host), outputs(&other));
    assert_eq!(host.set_input_derivatives(&[("wheelset.force.y", 1, 1.0)]), Status::Error);
    assert!(host.last().contains("wheelset.force.y is no input"), "{}", host.last());
}

#[test]
fn directional_derivatives_are_those_of_the_wheelset() {
    let host = Host::stepping_of(&WHEELSET);
    assert_eq!(host.set_reals(&PRESSED), Status::Ok);
    let (mut values, mut seeds) = (WheelsetValues::default(), WheelsetValues::default());
    for (name, value) in PRESSED {
        values.set(WHEELSET.find(name).unwrap(), Value::Real(value)).unwrap();
    }
    seeds.input = Input::at_rest();
    let chosen = [("wheelset.z", 0.3), ("wheelset.yaw_rate", -2.0), ("left.rail[1].vy", 1.5)];
    for (name, seed) in chosen {
        seeds.set(WHEELSET.find(name).unwrap(), Value::Real(seed)).unwrap();
    }
    let mut wheelset = Wheelset::new(&values.parameters, &values.input, &[]).unwrap();
    wheelset.directional_derivative(&values.input, &seeds.input, &mut seeds.output).unwrap();
    let unknowns = ["wheelset.force.y", "wheelset.moment.z", "left.rail[1].force.y", "wear_number"];
    let [u, k] = [unknowns.to_vec(), chosen.map(|(name, _)| name).to_vec()]
        .map(|names| names.into_iter().map(|name| host.reference(name)).collect::<Vec<_>>());
    let seed = chosen.map(|(_, seed)| seed);
    let mut found = [0.0; 4];
    // SAFETY: FMI 2.0, 2.1.9: the arrays hold as many elements as the counts say.
    let status = unsafe {
        let (u, k) = (u.as_ptr(), k.as_ptr());
        fmi2GetDirectionalDerivative(host.component, u, 4, k, 3, seed.as_ptr(), found.as_mut_ptr())
    };
    assert_eq!(status, Status::Ok, "{}", host.last());
    for (name, rate) in unknowns.into_iter().zip(found) {
        assert_eq!(Value::Real(rate), seeds.get(WHEELSET.find(name).unwrap()), "{name}");
        assert!(rate.abs() > 1.0, "{name}: {rate}");
    }
}

#[test]
fn model_exchange_gives_the_forces_of_co_simulation() {
    let stepped = Host::stepping_of(&WHEELSET);
    let arguments = Arguments { fmu_type: MODEL_EXCHANGE, ..Arguments::of(&WHEELSET) };
    let host = Host::initializing_with(&arguments);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
    assert_eq!(fmi2EnterContinuousTimeMode(host.component), Status::Ok);
    for h in [&host, &stepped] {
        assert_eq!(h.set_reals(&PRESSED), Status::Ok);
    }
    assert_eq!(outputs(&host), outputs(&stepped));
    let wearing = Host::initializing_with(&arguments);
    assert_eq!(wearing.set_integer("wear.model", 2), Status::Ok);
    assert_eq!(fmi2ExitInitializationMode(wearing.component), Status::Error);
    assert!(wearing.last().contains("wear.model = \"frictional_work\""), "{}", wearing.last());
}

#[test]
fn each_side_writes_its_worn_profiles() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name).display().to_string();
    let host = wearing();
    assert_eq!(host.set_text("left.wear.wheel.file", &file("left.csv")), Status::Ok);
    assert_eq!(host.set_text("right.wear.rail[1].file", &file("right.csv")), Status::Ok);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
    run(&host, 0..10, 1e-4);
    for name in ["left.wear.wheel.depth", "right.wear.rail[1].volume"] {
        assert!(host.get_real(name) > 0.0, "{name}");
    }
    assert_eq!(fmi2Terminate(host.component), Status::Ok, "{}", host.last());
    let folders = [folder.path().to_path_buf()];
    for (name, kind) in [("left.csv", ProfileKind::Wheel), ("right.csv", ProfileKind::Rail)] {
        load_profile("p", name, kind, 0.004, &folders).unwrap();
    }
    let host = wearing();
    let file = "/nowhere/at/all/wheel.csv";
    assert_eq!(host.set_text("left.wear.wheel.file", file), Status::Ok);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Error);
    assert!(host.last().contains("left.wear.wheel.file") && host.last().contains(file));
}

#[test]
fn what_is_refused_is_named_as_the_wheelset_has_it() {
    let host = Host::initializing_with(&Arguments::of(&WHEELSET));
    assert_eq!(host.set_text("left.wheel.profile", "no_such_wheel.prw"), Status::Ok);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Error);
    assert!(
        host.last().contains("ExitInitializationMode: left.wheel.profile: "),
        "{}",
        host.last()
    );
    assert_eq!(host.set_text("left.wheel.profile", "S1002"), Status::Ok);
    assert_eq!(host.set_reals(&[("flange_back_distance", 0.0)]), Status::Error);
    assert!(host.last().contains("flange_back_distance = 0 is not admitted"), "{}", host.last());
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
    for (name, value, words) in [
        ("wheelset.roll", f64::NAN, "wheelset.roll = NaN is not admitted: a finite number, in rad"),
        ("left.friction.coefficient", -1.0, "left.friction.coefficient = -1"),
        ("right.wheel.nominal_radius", 0.4, "right.wheel.nominal_radius is fixed"),
        ("wheelset.force.z", 0.4, "it is computed"),
    ] {
        assert_eq!(host.set_reals(&[(name, value)]), Status::Error);
        assert!(host.last().contains(words), "{}", host.last());
    }
    let mut value = 0.0;
    // SAFETY: FMI 2.0, 2.1.7: arrays of one element.
    let status = unsafe { fmi2GetReal(host.component, &99_999, 1, &raw mut value) };
    assert_eq!(status, Status::Error);
    let last = WHEELSET.variables.len() - 1;
    assert!(host.last().contains(&format!("from 0 to {last}")), "{}", host.last());
}

#[test]
fn eight_wheelsets_in_threads_give_the_bits_of_one_after_another() {
    let sideways = |i: i32| 2e-4 * f64::from(i - 4);
    let life = |i: i32| run(&Host::stepping_of(&WHEELSET), 0..10, sideways(i));
    let alone: Vec<_> = (0..8).map(life).collect();
    let together = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..8)
            .map(|i| scope.spawn(move || (0..5).map(|_| life(i)).next_back().unwrap()))
            .collect();
        threads.into_iter().map(|t| t.join().unwrap()).collect::<Vec<_>>()
    });
    assert_eq!(together, alone);
}

#[test]
fn a_thousand_rounds_of_set_step_get_and_take_back_allocate_nothing() {
    let host = Host::stepping_of(&WHEELSET);
    let c = host.component;
    let inputs = ["wheelset.y", "wheelset.z", "wheelset.vx"].map(|name| host.reference(name));
    let reals: Vec<ValueReference> =
        real_outputs(&WHEELSET).into_iter().map(|name| host.reference(name)).collect();
    let mut values = vec![0.0; reals.len()];
    let mut state = save(&host);
    let before = allocations::count();
    for i in 0..1000 {
        let t = 1e-4 * f64::from(i);
        let moved = [5e-3 * (20.0 * t).sin(), -0.4597, 20.0];
        // SAFETY: FMI 2.0, 2.1.7 and 2.1.8: all arrays hold as many elements as their counts say.
        let worst = unsafe {
            fmi2GetFMUstate(c, &raw mut state)
                .max(fmi2SetReal(c, inputs.as_ptr(), inputs.len(), moved.as_ptr()))
                .max(fmi2DoStep(c, t, 1e-4, TRUE))
                .max(fmi2GetReal(c, reals.as_ptr(), reals.len(), values.as_mut_ptr()))
                .max(fmi2SetFMUstate(c, state))
        };
        assert_eq!(worst, Status::Ok, "{}", host.last());
    }
    assert_eq!(allocations::count(), before);
}

#[test]
fn reset_goes_back_to_the_start() {
    let host = Host::stepping_of(&WHEELSET);
    let first = run(&host, 0..5, 1e-4);
    assert_eq!(fmi2Reset(host.component), Status::Ok);
    assert_eq!(fmi2SetupExperiment(host.component, FALSE, 0.0, 0.0, FALSE, 0.0), Status::Ok);
    assert_eq!(fmi2EnterInitializationMode(host.component), Status::Ok);
    assert_eq!(host.get_real("wheelset.z").to_bits(), (-0.45975_f64).to_bits());
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok);
    assert_eq!(run(&host, 0..5, 1e-4), first);
}
