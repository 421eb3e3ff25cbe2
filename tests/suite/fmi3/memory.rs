//! Memory is fixed after initialization.

use std::ptr::null_mut;

use wheelrail::fmi::v3::types::{FALSE, Status, TRUE, ValueReference};
use wheelrail::fmi::v3::*;
use wheelrail::variables::{Causality, Kind, Unit, WHEEL, WHEELSET};

use crate::allocations;
use crate::host3::Host3;

fn runs_in_fixed_memory(unit: &'static Unit, body: &str, centre: f64) {
    let host = Host3::stepping(unit);
    let c = host.component;
    let inputs = ["y", "z", "vz"].map(|name| host.reference(&format!("{body}.{name}")));
    let outputs = |kind| -> (Vec<ValueReference>, usize) {
        let of_kind = |v: &&_| {
            let v: &wheelrail::variables::Variable = v;
            v.causality == Causality::Output && v.kind == kind
        };
        let all = || unit.variables.iter().filter(of_kind);
        let first = all().filter(|v| !v.elements.is_empty());
        (first.map(|v| v.reference as ValueReference).collect(), all().count())
    };
    let ((mut reals, mut real_count), (integers, integer_count)) =
        (outputs(Kind::Real), outputs(Kind::Integer));
    reals.extend([host.reference("time"), host.reference("event_indicator")]);
    real_count += 2;
    let (mut real, mut integer) = (vec![0.0; real_count], vec![0; integer_count]);
    // All but time have derivatives.
    let unknowns: Vec<ValueReference> =
        reals.iter().copied().filter(|r| *r != host.reference("time")).collect();
    let mut sensitivity = vec![0.0; real_count - 1];
    let (mut state, mut flags, mut reached) = (null_mut(), [FALSE; 3], 0.0);
    // The only thing that is handed out at run time.
    // SAFETY: FMI 3.0, 2.2.10: a pointer to one state pointer.
    assert_eq!(unsafe { fmi3GetFMUState(c, &raw mut state) }, Status::Ok);
    let before = allocations::count();
    let mut worst = Status::Ok;
    for i in 0..100 {
        let t = 1e-3 * f64::from(i);
        let values = [centre + 5e-3 * (20.0 * t).sin(), -0.4598 + 2e-4 * (50.0 * t).sin(), 0.01];
        let [event, end, early] = flags.each_mut().map(|flag| &raw mut *flag);
        // SAFETY: FMI 3.0, 2.2.6, 2.2.10, 2.2.11 and 4.2.1: all arrays hold as many elements as
        // their counts say.
        unsafe {
            worst = worst
                .max(fmi3SetFloat64(c, inputs.as_ptr(), 3, values.as_ptr(), 3))
                .max(fmi3DoStep(c, t, 1e-3, TRUE, event, end, early, &raw mut reached))
                .max(fmi3GetFloat64(c, reals.as_ptr(), reals.len(), real.as_mut_ptr(), real_count))
                .max(fmi3GetInt32(
                    c,
                    integers.as_ptr(),
                    integers.len(),
                    integer.as_mut_ptr(),
                    integer_count,
                ))
                .max(fmi3GetFMUState(c, &raw mut state))
                .max(fmi3SetFMUState(c, state))
                .max(fmi3GetDirectionalDerivative(
                    c,
                    unknowns.as_ptr(),
                    unknowns.len(),
                    inputs.as_ptr(),
                    3,
                    [1.0, 0.5, 0.1].as_ptr(),
                    3,
                    sensitivity.as_mut_ptr(),
                    sensitivity.len(),
                ));
        }
    }
    assert_eq!(worst, Status::Ok, "{}", host.last());
    assert_eq!(allocations::count(), before);
}

#[test]
fn a_wheel_runs_in_fixed_memory() {
    runs_in_fixed_memory(&WHEEL, "wheel", 0.75);
}

#[test]
fn a_wheelset_runs_in_fixed_memory() {
    runs_in_fixed_memory(&WHEELSET, "wheelset", 0.0);
}
