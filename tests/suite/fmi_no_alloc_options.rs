//! Memory is fixed after initialization: with every option on, from the first call of each kind,
//! warnings and updates of worn profiles included, nothing is allocated.
#![allow(unsafe_code)]

use crate::allocations;
use std::ffi::{CString, c_void};
use std::ptr::{null, null_mut};
use std::sync::atomic::{AtomicUsize, Ordering};

use wheelrail::fmi::v2::types::{
    CO_SIMULATION, CallbackFunctions, CallbackLogger, Component, FALSE, MODEL_EXCHANGE, Status,
    TRUE, Text, ValueReference,
};
use wheelrail::fmi::v2::*;
use wheelrail::variables::{Causality, Kind, Unit, Value, WHEEL, WHEELSET};

/// Messages that came.
static MESSAGES: AtomicUsize = AtomicUsize::new(0);

/// A logger that allocates nothing itself.
unsafe extern "C" fn count(_: *mut c_void, _: Text, _: Status, _: Text, _: Text) {
    MESSAGES.fetch_add(1, Ordering::Relaxed);
}

/// A parameter and its value.
type Setting = (&'static str, Value<'static>);

/// An instance whose host counts messages; the host of the tests keeps them.
struct Silent {
    component: Component,
    unit: &'static Unit,
}

impl Silent {
    fn new(unit: &'static Unit, fmu_type: i32, settings: &[Setting]) -> Self {
        type Plain = unsafe extern "C" fn(*mut c_void, Text, Status, Text, Text);
        // SAFETY: a variadic call without variable arguments is that of a plain function on the
        // platforms of the tests.
        let logger = unsafe { std::mem::transmute::<Plain, CallbackLogger>(count) };
        let functions = CallbackFunctions {
            logger: Some(logger),
            allocate_memory: None,
            free_memory: None,
            step_finished: None,
            component_environment: null_mut(),
        };
        let guid = CString::new(unit.guid).unwrap();
        // SAFETY: FMI 2.0, 2.1.5: null-terminated texts, null for the location, a struct that is
        // filled in.
        let component = unsafe {
            let functions = &raw const functions;
            fmi2Instantiate(c"w".as_ptr(), fmu_type, guid.as_ptr(), null(), functions, FALSE, FALSE)
        };
        assert!(!component.is_null());
        let host = Self { component, unit };
        for (name, value) in settings {
            let r = host.reference(name);
            // SAFETY: FMI 2.0, 2.1.7: arrays of one element.
            let status = unsafe {
                match *value {
                    Value::Real(v) => fmi2SetReal(component, &raw const r, 1, &raw const v),
                    Value::Integer(v) => fmi2SetInteger(component, &raw const r, 1, &raw const v),
                    Value::Boolean(v) => {
                        let v = if v { TRUE } else { FALSE };
                        fmi2SetBoolean(component, &raw const r, 1, &raw const v)
                    }
                    Value::Text(_) => panic!("{name}: no texts here"),
                }
            };
            assert_eq!(status, Status::Ok, "{name}");
        }
        assert_eq!(fmi2SetupExperiment(component, FALSE, 0.0, 0.0, FALSE, 0.0), Status::Ok);
        assert_eq!(fmi2EnterInitializationMode(component), Status::Ok);
        assert!(fmi2ExitInitializationMode(component) <= Status::Warning);
        host
    }

    fn reference(&self, name: &str) -> ValueReference {
        ValueReference::try_from(self.unit.find(name).unwrap().reference).unwrap()
    }

    fn places(&self, wanted: impl Fn(Causality, Kind) -> bool) -> Vec<ValueReference> {
        let all = self.unit.variables.iter().filter(|v| wanted(v.causality, v.kind));
        all.map(|v| v.reference as ValueReference).collect()
    }
}

impl Drop for Silent {
    fn drop(&mut self) {
        fmi2FreeInstance(self.component);
    }
}

/// Height of the body over the rounds: rolling, hopping, then sunk too deep for a force.
fn height(i: usize) -> f64 {
    match i {
        150..160 => -0.42,
        _ => -0.46 + 2.8e-4 * (1.0 + (0.2 * i as f64).sin()),
    }
}

const ROUNDS: usize = 200;

/// What a call allocates goes to its name.
fn counted(
    counts: &mut Vec<(&'static str, usize)>,
    name: &'static str,
    call: impl FnOnce() -> Status,
) {
    let before = allocations::count();
    let status = call();
    let made = allocations::count() - before;
    assert!(status <= Status::Warning, "{name}");
    if made > 0 {
        counts.push((name, made));
    }
}

/// Rounds of everything that a host may call while it runs: the calls that allocate after
/// initialization, and the number of messages.
fn rounds(
    unit: &'static Unit,
    settings: &[Setting],
    count: usize,
) -> (Vec<(&'static str, usize)>, usize) {
    let host = Silent::new(unit, CO_SIMULATION, settings);
    let c = host.component;
    let body = if unit.identifier == "WheelSet" { "wheelset" } else { "wheel" };
    let inputs = ["y", "z", "vz"].map(|name| host.reference(&format!("{body}.{name}")));
    let [_, z, vz] = inputs;
    let knowns = [z, vz];
    let centre = if body == "wheel" { 0.75 } else { 0.0 };
    let is_output = |c, k, wanted| c == Causality::Output && k == wanted;
    let reals = host.places(|c, k| is_output(c, k, Kind::Real));
    let integers = host.places(|c, k| is_output(c, k, Kind::Integer));
    let (mut real, mut integer) = (vec![0.0; reals.len()], vec![0; integers.len()]);
    let mut sensitivity = vec![0.0; reals.len()];
    let mut state = null_mut();
    // The only thing that is handed out, and freed, at run time.
    // SAFETY: FMI 2.0, 2.1.8: a pointer to one state pointer.
    assert_eq!(unsafe { fmi2GetFMUstate(c, &raw mut state) }, Status::Ok);
    let said = MESSAGES.load(Ordering::Relaxed);
    let mut found = Vec::new();
    for i in 0..count {
        let phase = i * ROUNDS / count;
        let values = [centre + 5e-3 * (0.1 * phase as f64).sin(), height(phase), 0.01];
        // SAFETY: FMI 2.0, 2.1.7 to 2.1.9 and 4.2.1: all arrays hold as many elements as their
        // counts say.
        unsafe {
            counted(&mut found, "fmi2SetReal", || {
                fmi2SetReal(c, inputs.as_ptr(), inputs.len(), values.as_ptr())
            });
            counted(&mut found, "fmi2SetRealInputDerivatives", || {
                fmi2SetRealInputDerivatives(c, &raw const z, 1, &1, &0.01)
            });
            counted(&mut found, "fmi2DoStep", || fmi2DoStep(c, 1e-3 * i as f64, 1e-3, TRUE));
            counted(&mut found, "fmi2GetReal", || {
                fmi2GetReal(c, reals.as_ptr(), reals.len(), real.as_mut_ptr())
            });
            counted(&mut found, "fmi2GetInteger", || {
                fmi2GetInteger(c, integers.as_ptr(), integers.len(), integer.as_mut_ptr())
            });
            counted(&mut found, "fmi2GetFMUstate", || fmi2GetFMUstate(c, &raw mut state));
            counted(&mut found, "fmi2SetFMUstate", || fmi2SetFMUstate(c, state));
        }
        if i % 20 != 0 {
            continue;
        }
        counted(&mut found, "fmi2GetDirectionalDerivative", || {
            // SAFETY: as above.
            unsafe {
                fmi2GetDirectionalDerivative(
                    c,
                    reals.as_ptr(),
                    reals.len(),
                    knowns.as_ptr(),
                    2,
                    [1.0, 0.5].as_ptr(),
                    sensitivity.as_mut_ptr(),
                )
            }
        });
    }
    found.truncate(5);
    (found, MESSAGES.load(Ordering::Relaxed) - said)
}

fn real(name: &'static str, value: f64) -> Setting {
    (name, Value::Real(value))
}

fn integer(name: &'static str, value: i32) -> Setting {
    (name, Value::Integer(value))
}

/// All real-time models with what costs memory.
#[test]
fn every_option_of_a_wheel_runs_in_fixed_memory() {
    let monitor = ("coupling.monitor", Value::Boolean(true));
    let second_rail = ("rail[2].enabled", Value::Boolean(true));
    let corrugation = real("rail[1].corrugation.amplitude", 1e-5);
    let falling = [real("friction.falling.share", 0.5), real("friction.falling.decay", 0.3)];
    let wear = |model, distribution| {
        vec![
            integer("wear.model", model),
            integer("wear.distribution", distribution),
            real("wear.acceleration_factor", 1e5),
            // A fifth of the steps ends with new profiles.
            real("wear.update_interval", 5e-3),
            monitor,
        ]
    };
    let mut options: Vec<Vec<Setting>> = vec![
        vec![],
        vec![monitor],
        vec![integer("friction.distribution", 2), falling[0], falling[1]],
        vec![monitor, second_rail],
        vec![monitor, corrugation, falling[0], falling[1]],
        vec![monitor, real("wheel.flat.length", 0.04), real("wheel.out_of_round.amplitude", 1e-4)],
        vec![monitor, integer("vertical.mode", 2)],
        vec![monitor, ("side", Value::Integer(2))],
        vec![monitor, real("rail[1].roller_radius", 0.5)],
        vec![monitor, integer("track.foundation.model", 2)],
        vec![monitor, integer("track.foundation.model", 2), integer("vertical.mode", 2)],
        vec![monitor, integer("track.foundation.model", 3), second_rail],
        vec![integer("track.foundation.model", 3), real("wheel.out_of_round.amplitude", 1e-4)],
        [wear(2, 1), vec![second_rail]].concat(),
        wear(6, 2),
    ];
    options.extend([1, 2, 3].map(|normal| vec![monitor, integer("normal.model", normal)]));
    options.extend((1..=5).map(|model| vec![monitor, integer("tangential.model", model)]));
    options.extend([1, 2].map(|model| vec![monitor, integer("creepage.model", model)]));
    let mut faults = Vec::new();
    for settings in options {
        let is_soft = settings.iter().any(|(name, _)| *name == "track.foundation.model");
        let count = if is_soft { ROUNDS / 10 } else { ROUNDS / 2 };
        let (allocations, messages) = rounds(&WHEEL, &settings, count);
        if !allocations.is_empty() {
            faults.push(format!("{settings:?}: {allocations:?}"));
        }
        let is_left = settings.iter().any(|(name, _)| *name == "side");
        let is_loaded = settings.iter().any(|(name, _)| *name == "vertical.mode");
        // The wheel that sinks is told; one that stands beside its rail, has no height of its own
        // or takes its rail along does not sink.
        assert!(messages > 0 || is_left || is_loaded || is_soft, "{settings:?}");
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn a_wheelset_runs_in_fixed_memory() {
    let monitor = ("coupling.monitor", Value::Boolean(true));
    for settings in [
        vec![monitor],
        vec![monitor, integer("vertical.mode", 2)],
        vec![monitor, integer("track.foundation.model", 3)],
        vec![
            integer("wear.model", 2),
            real("wear.acceleration_factor", 1e5),
            real("wear.update_interval", 5e-3),
        ],
    ] {
        assert_eq!(rounds(&WHEELSET, &settings, 20).0, [], "{settings:?}");
    }
}

#[test]
fn worn_profiles_are_made_and_taken_back_in_fixed_memory() {
    let settings = [
        integer("wear.model", 2),
        real("wear.acceleration_factor", 1e6),
        real("wear.update_interval", 3e-3),
    ];
    let host = Silent::new(&WHEEL, CO_SIMULATION, &settings);
    let c = host.component;
    let depth = [host.reference("wear.wheel.depth"), host.reference("wear.rail[1].depth")];
    let depths = || {
        let mut values = [0.0; 2];
        // SAFETY: FMI 2.0, 2.1.7: arrays of two elements.
        let status = unsafe { fmi2GetReal(c, depth.as_ptr(), 2, values.as_mut_ptr()) };
        assert!(status <= Status::Warning);
        values
    };
    let mut state = null_mut();
    // SAFETY: FMI 2.0, 2.1.8: a pointer to one state pointer.
    assert_eq!(unsafe { fmi2GetFMUstate(c, &raw mut state) }, Status::Ok);
    let before = allocations::count();
    let mut deepest = [0.0; 2];
    for round in 0..3 {
        for i in 0..30 {
            assert!(fmi2DoStep(c, 1e-3 * f64::from(i), 1e-3, FALSE) <= Status::Warning);
        }
        let worn = depths();
        assert!(worn.iter().all(|depth| *depth > 0.0), "{worn:?}");
        // Back to the unworn profiles, and worn again to the same depth.
        assert!(round == 0 || worn.map(f64::to_bits) == deepest.map(f64::to_bits));
        deepest = worn;
        assert_eq!(fmi2SetFMUstate(c, state), Status::Ok);
        assert!(depths().iter().all(|depth| *depth <= 0.0));
    }
    assert_eq!(allocations::count(), before);
}

#[test]
fn a_load_that_is_not_carried_is_told_in_fixed_memory() {
    let host = Silent::new(&WHEEL, CO_SIMULATION, &[integer("vertical.mode", 2)]);
    let (y, force) = (host.reference("wheel.y"), host.reference("wheel.force.z"));
    let (said, before) = (MESSAGES.load(Ordering::Relaxed), allocations::count());
    for i in 0..20 {
        let (beside, mut value) = (if i % 2 == 0 { 0.3 } else { 0.75 }, 0.0);
        // SAFETY: FMI 2.0, 2.1.7: arrays of one element.
        let worst = unsafe {
            fmi2SetReal(host.component, &raw const y, 1, &raw const beside).max(fmi2GetReal(
                host.component,
                &raw const force,
                1,
                &raw mut value,
            ))
        };
        assert!(worst <= Status::Warning);
    }
    assert_eq!(allocations::count(), before);
    assert!(MESSAGES.load(Ordering::Relaxed) >= said + 10);
}

#[test]
fn model_exchange_runs_in_fixed_memory() {
    let host = Silent::new(&WHEEL, MODEL_EXCHANGE, &[]);
    let c = host.component;
    let (z, count) = (host.reference("wheel.z"), host.reference("patch_count"));
    let before = allocations::count();
    for i in 0..ROUNDS {
        let (value, mut indicator, mut patches) = (height(i), 0.0, 0);
        // SAFETY: FMI 2.0, 2.1.7 and 3.2.2: arrays of one element.
        let worst = unsafe {
            fmi2EnterContinuousTimeMode(c)
                .max(fmi2SetReal(c, &raw const z, 1, &raw const value))
                .max(fmi2GetEventIndicators(c, &raw mut indicator, 1))
                .max(fmi2GetInteger(c, &raw const count, 1, &raw mut patches))
                .max(fmi2EnterEventMode(c))
        };
        assert!(worst <= Status::Warning, "round {i}");
    }
    assert_eq!(allocations::count(), before);
}
