//! Adjoint derivatives: what directional ones are, the other way round.

use wheelrail::fmi::v2::types::{Status, ValueReference};
use wheelrail::fmi::v3::*;
use wheelrail::variables::{WHEEL, WHEELSET};

use super::derivatives::derivatives;
use crate::allocations;
use crate::host3::Host3;
use crate::tolerance;

type Asked<'a> = (&'a Host3, &'a [&'a str], &'a [&'a str]);

/// Products of the seeds of unknowns with the derivatives by knowns of `count` elements in all.
fn backwards(
    (host, unknowns, knowns): Asked,
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
        fmi3GetAdjointDerivative(
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

/// Derivatives of unknowns with `count` elements in all by one known.
fn forwards((host, unknowns, _): Asked, known: &str, count: usize) -> Vec<f64> {
    derivatives(host, unknowns, &[known], &[1.0], count)
        .unwrap_or_else(|_| panic!("{}", host.last()))
}

fn compare(asked: Asked, seed: &[f64], most_apart: f64) {
    let found =
        backwards(asked, seed, asked.2.len()).unwrap_or_else(|_| panic!("{}", asked.0.last()));
    assert!(found.iter().any(|by| *by != 0.0));
    for (known, by) in asked.2.iter().zip(found) {
        let parts = forwards(asked, known, seed.len());
        let sum: f64 = parts.iter().zip(seed).map(|(part, seed)| part * seed).sum();
        let size: f64 = parts.iter().zip(seed).map(|(part, seed)| (part * seed).abs()).sum();
        assert!((by - sum).abs() <= most_apart * size, "{known}: {by} {sum}");
    }
}

const UNKNOWNS: [&str; 4] =
    ["wheel.force.x", "event_indicator", "patch.normal_force", "wheel.moment.y"];
const SEED: [f64; 11] = [1.0, 3.0, 0.5, -0.5, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, -2.0];

#[test]
fn they_are_the_directional_ones_the_other_way_round() {
    let knowns = ["wheel.z", "wheel.yaw", "wheel.vy", "friction.coefficient", "rail[1].y"];
    compare((&Host3::stepping(&WHEEL), &UNKNOWNS, &knowns), &SEED, tolerance::BACKWARDS);
    compare((&Host3::initializing(&WHEEL), &UNKNOWNS, &knowns), &SEED, tolerance::BACKWARDS);
}

#[test]
fn a_wheelset_has_them_too() {
    let unknowns = ["wheelset.force.y", "wheelset.moment.z", "right.patch.normal_force"];
    let knowns = ["wheelset.z", "wheelset.yaw", "wheelset.vy", "left.friction.coefficient"];
    let seed = [1.0, -0.5, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8];
    compare((&Host3::stepping(&WHEELSET), &unknowns, &knowns), &seed, tolerance::BACKWARDS);
}

/// What one sweep has grown the next ones use.
#[test]
fn later_calls_allocate_nothing() {
    let references = |host: &Host3, names: &[&str]| -> Vec<ValueReference> {
        names.iter().map(|n| host.reference(n)).collect()
    };
    for (unit, body, unknown) in
        [(&WHEEL, "wheel", "wheel.force.y"), (&WHEELSET, "wheelset", "wheelset.force.y")]
    {
        let host = Host3::stepping(unit);
        let inputs = ["y", "z", "yaw", "vy"].map(|name| format!("{body}.{name}"));
        let young = "wheel.young_modulus";
        let knowns: Vec<&str> = inputs.iter().map(String::as_str).chain([young]).collect();
        let (unknowns, knowns) = (references(&host, &[unknown]), references(&host, &knowns));
        let y = host.get_real(&inputs[0]);
        let (seed, mut found) = ([1.0], [0.0; 5]);
        let mut sweep = |way: f64| {
            assert_eq!(host.set_reals(&[(&inputs[0], y + way)]), Status::Ok);
            let before = allocations::count();
            // SAFETY: FMI 3.0, 2.2.11: all arrays hold as many elements as their counts say.
            let status = unsafe {
                fmi3GetAdjointDerivative(
                    host.component,
                    unknowns.as_ptr(),
                    1,
                    knowns.as_ptr(),
                    5,
                    seed.as_ptr(),
                    1,
                    found.as_mut_ptr(),
                    5,
                )
            };
            assert_eq!(status, Status::Ok, "{}", host.last());
            allocations::count() - before
        };
        let places = [0.0, 1e-4, -1e-4, 2e-4];
        let [first, again] = [places, places].map(|places| places.map(&mut sweep));
        println!("{body}: {first:?}, {again:?}");
        assert!(first[0] > 0 && again == [0; 4], "{body}: {first:?}, {again:?}");
        assert!(found.iter().all(|slope| *slope != 0.0), "{found:?}");
    }
}

#[test]
fn parameters_are_knowns_in_all_modes() {
    let knowns =
        ["track.gauge", "wheel.young_modulus", "rail[1].inclination", "normal.damping", "wheel.z"];
    let initial = Host3::initializing(&WHEEL);
    // Forwards they are differences, within 1e-5 as documented.
    compare((&initial, &UNKNOWNS, &knowns), &SEED, 1e-4);
    // One that is found by differences alone, and a height of first touch.
    compare(
        (
            &initial,
            &["nominal.wheel_z", "wheel.force.z"],
            &["profile.smoothing", "wheel.nominal_radius"],
        ),
        &[1.0, 0.0],
        1e-4,
    );
    let stepping = Host3::stepping(&WHEEL);
    let after = backwards((&stepping, &UNKNOWNS, &knowns), &SEED, 5).unwrap();
    let before = backwards((&initial, &UNKNOWNS, &knowns), &SEED, 5).unwrap();
    for (after, before) in after.iter().zip(before) {
        approx::assert_relative_eq!(*after, before, max_relative = 1e-9);
    }
}

#[test]
fn what_has_no_derivative_is_refused_by_name() {
    let host = Host3::stepping(&WHEEL);
    for (unknown, known, seed, count, words) in [
        ("wheel.y", "wheel.z", 1.0, 1, "wheel.y is not admitted as unknown"),
        ("time", "wheel.z", 1.0, 1, "time is not admitted as unknown"),
        ("wheel.force.z", "time", 1.0, 1, "time is not admitted as known"),
        (
            "wheel.force.z",
            "profile.smoothing",
            1.0,
            1,
            "profile.smoothing is not admitted as known",
        ),
        ("wheel.force.z", "wheel.z", f64::NAN, 1, "seed NaN of wheel.force.z"),
        ("wheel.force.z", "wheel.z", 1.0, 2, "nSensitivity = 2, but the variables have 1"),
        ("patch.area", "wheel.z", 1.0, 1, "nSeed = 1, but the variables have 8"),
    ] {
        let found = backwards((&host, &[unknown], &[known]), &[seed], count);
        assert_eq!(found, Err(Status::Error), "{words}");
        assert!(host.last().contains(words), "{} for {words}", host.last());
    }
    // Nothing is asked of null.
    // SAFETY: FMI 3.0, 2.2.6: arrays of no element.
    let status = unsafe {
        use std::ptr::{null, null_mut};
        fmi3GetAdjointDerivative(host.component, null(), 0, null(), 0, null(), 0, null_mut(), 0)
    };
    assert_eq!(status, Status::Ok);
}
