//! Directional derivatives, of arrays element by element.

use wheelrail::fmi::v2::fmi2GetDirectionalDerivative;
use wheelrail::fmi::v2::types::{Status, ValueReference};
use wheelrail::fmi::v3::*;
use wheelrail::variables::WHEEL;

use crate::host::{Host, reference};
use crate::host3::Host3;

/// Derivatives of unknowns with `count` elements in all by knowns along a seed.
pub fn derivatives(
    host: &Host3,
    unknowns: &[&str],
    knowns: &[&str],
    seed: &[f64],
    count: usize,
) -> Result<Vec<f64>, Status> {
    let references = |names: &[&str]| -> Vec<ValueReference> {
        names.iter().map(|n| host.reference(n)).collect()
    };
    let (unknowns, knowns) = (references(unknowns), references(knowns));
    let mut found = vec![f64::NAN; count];
    // SAFETY: FMI 3.0, 2.2.11: all arrays hold as many elements as their counts say.
    let status = unsafe {
        fmi3GetDirectionalDerivative(
            host.component,
            unknowns.as_ptr(),
            unknowns.len(),
            knowns.as_ptr(),
            knowns.len(),
            seed.as_ptr(),
            seed.len(),
            found.as_mut_ptr(),
            count,
        )
    };
    if status == Status::Ok { Ok(found) } else { Err(status) }
}

#[test]
fn derivatives_of_arrays_are_those_of_their_elements() {
    let (old, new) = (Host::stepping(), Host3::stepping(&WHEEL));
    let knowns = ["wheel.z", "wheel.yaw"].map(reference);
    let names: Vec<String> = (1..=8).map(|k| format!("patch[{k}].normal_force")).collect();
    let unknowns: Vec<ValueReference> =
        names.iter().map(|name| reference(name)).chain([reference("wheel.force.x")]).collect();
    let (seed, mut wanted) = ([1.0, -0.5], [0.0; 9]);
    // SAFETY: FMI 2.0, 2.1.9: all arrays hold as many elements as their counts say.
    let status = unsafe {
        let (u, k) = (unknowns.as_ptr(), knowns.as_ptr());
        let (seed, wanted) = (seed.as_ptr(), wanted.as_mut_ptr());
        fmi2GetDirectionalDerivative(old.component, u, 9, k, 2, seed, wanted)
    };
    assert_eq!(status, Status::Ok, "{}", old.last());
    assert!(wanted[0] > 1e8);
    // The event indicator, which moves in steps, between and behind the others.
    let unknowns = ["event_indicator", "patch.normal_force", "event_indicator", "wheel.force.x"];
    let found = derivatives(&new, &unknowns, &["wheel.z", "wheel.yaw"], &seed, 11).unwrap();
    let expected = [&[0.0], &wanted[..8], &[0.0], &wanted[8..]].concat();
    let bits = |values: &[f64]| values.iter().map(|v| v.to_bits()).collect::<Vec<_>>();
    assert_eq!(bits(&found), bits(&expected));
}

#[test]
fn in_initialization_mode_parameters_are_knowns_too() {
    let (old, new) = (Host::initializing(), Host3::initializing(&WHEEL));
    let unknowns = ["nominal.wheel_z", "patch.rolling_radius"];
    let found = derivatives(&new, &unknowns, &["wheel.nominal_radius"], &[1.0], 9).unwrap();
    // A wheel stands as much higher as its radius is greater.
    assert!((found[0] + 1.0).abs() < 1e-3, "{found:?}");
    let (unknown, known) =
        (reference("patch[1].rolling_radius"), reference("wheel.nominal_radius"));
    let (seed, mut wanted) = (1.0, 0.0);
    // SAFETY: FMI 2.0, 2.1.9: arrays of one element.
    let status = unsafe {
        let (u, k) = (&raw const unknown, &raw const known);
        fmi2GetDirectionalDerivative(old.component, u, 1, k, 1, &raw const seed, &raw mut wanted)
    };
    assert_eq!((status, wanted.to_bits()), (Status::Ok, found[1].to_bits()), "{}", old.last());
}

#[test]
fn what_has_no_derivative_is_refused_by_name() {
    let host = Host3::stepping(&WHEEL);
    for (unknowns, knowns, seed, count, words) in [
        ("wheel.y", "wheel.z", 1.0, 1, "wheel.y is not admitted as unknown"),
        ("time", "wheel.z", 1.0, 1, "time is not admitted as unknown"),
        ("wheel.force.z", "time", 1.0, 1, "time is not admitted as known"),
        ("wheel.force.z", "event_indicator", 1.0, 1, "event_indicator is not admitted as known"),
        ("wheel.force.z", "track.gauge", 1.0, 1, "track.gauge is not admitted as known"),
        ("patch.rail", "wheel.z", 1.0, 8, "patch.rail is of type Int32"),
        ("wheel.force.z", "wheel.z", f64::NAN, 1, "seed NaN of wheel.z"),
        ("patch.area", "wheel.z", 1.0, 1, "nSensitivity = 1, but the variables have 8 elements"),
    ] {
        let found = derivatives(&host, &[unknowns], &[knowns], &[seed], count);
        assert_eq!(found, Err(Status::Error), "{words}");
        assert!(host.last().contains(words), "{} for {words}", host.last());
    }
    assert_eq!(derivatives(&host, &["wheel.force.z"], &["wheel.z"], &[], 1), Err(Status::Error));
    assert!(host.last().contains("nSeed = 0, but the variables have 1"), "{}", host.last());
}
