//! Setting, stepping, reading and taking back through the FMI interface allocates nothing.
#![allow(unsafe_code)]

use crate::allocations;
use crate::host::{Host, reference};
use wheelrail::fmi::v2::types::{Status, TRUE, ValueReference};
use wheelrail::fmi::v2::{
    fmi2DoStep, fmi2GetFMUstate, fmi2GetInteger, fmi2GetReal, fmi2SetFMUstate, fmi2SetReal,
};
use wheelrail::variables::{Causality, Kind, VARIABLES};

#[test]
fn a_thousand_rounds_of_set_step_get_allocate_nothing() {
    let host = Host::stepping();
    let places = |wanted: Causality, integer: bool| -> Vec<ValueReference> {
        let all = VARIABLES.iter().filter(|v| v.causality == wanted);
        all.filter(|v| (v.kind == Kind::Integer) == integer).map(|v| reference(v.name)).collect()
    };
    let inputs = [reference("wheel.y"), reference("wheel.z"), reference("wheel.vx")];
    let (reals, integers) = (places(Causality::Output, false), places(Causality::Output, true));
    let (mut real, mut integer) = (vec![0.0; reals.len()], vec![0; integers.len()]);
    let patch_count = integers.iter().position(|&r| r == reference("patch_count")).unwrap();
    let before = allocations::count();
    for i in 0..1000 {
        let t = 1e-4 * f64::from(i);
        let values = [0.75 + 5e-3 * (20.0 * t).sin(), -0.4597, 20.0];
        // SAFETY: FMI 2.0, 2.1.7: all arrays hold as many elements as their counts say.
        let worst = unsafe {
            let c = host.component;
            fmi2SetReal(c, inputs.as_ptr(), inputs.len(), values.as_ptr())
                .max(fmi2DoStep(c, t, 1e-4, TRUE))
                .max(fmi2GetReal(c, reals.as_ptr(), reals.len(), real.as_mut_ptr()))
                .max(fmi2GetInteger(c, integers.as_ptr(), integers.len(), integer.as_mut_ptr()))
        };
        assert_eq!(worst, Status::Ok);
        assert!(integer[patch_count] > 0, "lifted at {} m", values[0]);
    }
    assert_eq!(allocations::count(), before);
}

#[test]
fn a_thousand_steps_taken_back_allocate_nothing() {
    let host = Host::stepping();
    let (c, force) = (host.component, reference("wheel.force.z"));
    let inputs = [reference("wheel.y"), reference("wheel.z")];
    let mut state = std::ptr::null_mut();
    // SAFETY: FMI 2.0, 2.1.8: a pointer to one state pointer.
    assert_eq!(unsafe { fmi2GetFMUstate(c, &raw mut state) }, Status::Ok);
    let before = allocations::count();
    for i in 0..1000 {
        let t = 1e-4 * f64::from(i);
        let mut forces = [0.0; 2];
        for force_z in &mut forces {
            let values = [0.75 + 5e-3 * (20.0 * t).sin(), -0.4597];
            // SAFETY: FMI 2.0, 2.1.7 and 2.1.8: all arrays hold as many elements as their counts
            // say.
            let worst = unsafe {
                fmi2GetFMUstate(c, &raw mut state)
                    .max(fmi2SetReal(c, inputs.as_ptr(), inputs.len(), values.as_ptr()))
                    .max(fmi2DoStep(c, t, 1e-4, TRUE))
                    .max(fmi2GetReal(c, &raw const force, 1, force_z))
                    .max(fmi2SetFMUstate(c, state))
            };
            assert_eq!(worst, Status::Ok, "{}", host.last());
        }
        assert_eq!(forces[0].to_bits(), forces[1].to_bits());
    }
    assert_eq!(allocations::count(), before);
}
