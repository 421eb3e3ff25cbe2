//! `fmi2GetDirectionalDerivative` called as an importer calls it: values, modes, refusals, and that nothing else changes.
#![allow(unsafe_code)]

mod host;

use host::{Host, reference};
use wheelrail::element::{Element, Input, Output, Parameters};
use wheelrail::fmi::abi::{
    fmi2EnterContinuousTimeMode, fmi2GetDirectionalDerivative, fmi2Terminate,
};
use wheelrail::fmi::types::{Status, ValueReference};
use wheelrail::variables::{Causality, Kind, VARIABLES};

const PRESSED: [(&str, f64); 5] = [
    ("wheel.z", -0.4597),
    ("wheel.y", 0.751),
    ("wheel.vx", 20.0),
    ("wheel.pitch_rate", -43.4),
    ("wheel.yaw", 0.01),
];
const SEEDS: [(&str, f64); 4] =
    [("wheel.z", 0.3), ("wheel.yaw", -2.0), ("wheel.vy", 1.5), ("friction.coefficient", -0.7)];
const FORCES: [&str; 5] = [
    "wheel.force.x",
    "wheel.force.z",
    "wheel.moment.y",
    "rail[1].force.y",
    "patch[1].normal_force",
];

/// The derivative of `unknowns` in the direction of the seeds.
fn derivative(host: &Host, unknowns: &[&str], seeds: &[(&str, f64)]) -> Result<Vec<f64>, Status> {
    let unknowns: Vec<ValueReference> = unknowns.iter().map(|n| reference(n)).collect();
    let knowns: Vec<ValueReference> = seeds.iter().map(|(n, _)| reference(n)).collect();
    let seeds: Vec<f64> = seeds.iter().map(|(_, seed)| *seed).collect();
    let mut found = vec![f64::NAN; unknowns.len()];
    // SAFETY: FMI 2.0, 2.1.9: the arrays hold as many elements as the counts say.
    let status = unsafe {
        fmi2GetDirectionalDerivative(
            host.component,
            unknowns.as_ptr(),
            unknowns.len(),
            knowns.as_ptr(),
            knowns.len(),
            seeds.as_ptr(),
            found.as_mut_ptr(),
        )
    };
    if status == Status::Ok { Ok(found) } else { Err(status) }
}

/// What the element says.
fn expected() -> Vec<f64> {
    let mut input = Input::default();
    (input.wheel.position[2], input.wheel.position[1], input.wheel.yaw) = (-0.4597, 0.751, 0.01);
    (input.wheel.velocity[0], input.wheel.pitch_rate) = (20.0, -43.4);
    let mut direction = Input::from_array([0.0; 27]);
    (direction.wheel.position[2], direction.wheel.yaw) = (0.3, -2.0);
    (direction.wheel.velocity[1], direction.friction) = (1.5, -0.7);
    let mut element = Element::new(&Parameters::default(), &Input::default(), &[]).unwrap();
    let mut rates = Output::default();
    element.directional_derivative(&input, &direction, &mut rates).unwrap();
    let Output { wheel, rails, patches, .. } = rates;
    vec![
        wheel.force[0],
        wheel.force[2],
        wheel.moment[1],
        rails[0].force[1],
        patches[0].normal_force,
    ]
}

#[test]
fn both_types_give_the_derivatives_of_the_element_in_every_mode() {
    let wanted = expected();
    assert!(wanted.iter().all(|rate| rate.abs() > 1.0), "{wanted:?}");
    let stepping = Host::stepping();
    assert_eq!(stepping.set_reals(&PRESSED), Status::Ok);
    assert_eq!(derivative(&stepping, &FORCES, &SEEDS), Ok(wanted.clone()));
    assert_eq!(stepping.step(0.0, 1e-3), Status::Ok);
    assert_eq!(derivative(&stepping, &FORCES, &SEEDS), Ok(wanted.clone()));
    assert_eq!(fmi2Terminate(stepping.component), Status::Ok);
    assert_eq!(derivative(&stepping, &FORCES, &SEEDS), Ok(wanted.clone()));
    let exchange = Host::in_event_mode();
    assert_eq!(exchange.set_reals(&PRESSED), Status::Ok);
    assert_eq!(derivative(&exchange, &FORCES, &SEEDS), Ok(wanted.clone()));
    assert_eq!(fmi2EnterContinuousTimeMode(exchange.component), Status::Ok);
    assert_eq!(derivative(&exchange, &FORCES, &SEEDS), Ok(wanted.clone()));
    let initializing = Host::initializing();
    assert_eq!(initializing.set_reals(&PRESSED), Status::Ok);
    assert_eq!(derivative(&initializing, &FORCES, &SEEDS), Ok(wanted));
    assert_eq!(derivative(&Host::new(), &FORCES, &SEEDS), Err(Status::Error));
}

#[test]
fn forces_are_read_as_before_and_other_seeds_leave_nothing_behind() {
    let host = Host::stepping();
    assert_eq!(host.set_reals(&PRESSED), Status::Ok);
    let before = host.get_reals(&FORCES).unwrap();
    let first = derivative(&host, &FORCES, &SEEDS).unwrap();
    derivative(&host, &FORCES, &[("wheel.y", 1.0)]).unwrap();
    assert_eq!(derivative(&host, &FORCES, &SEEDS), Ok(first));
    assert_eq!(host.get_reals(&FORCES), Ok(before));
    assert_eq!(derivative(&host, &FORCES, &[]), Ok(vec![0.0; FORCES.len()]));
    assert_eq!(derivative(&host, &[], &SEEDS), Ok(vec![]));
}

#[test]
fn a_lifted_wheel_has_no_forces_to_change() {
    let host = Host::stepping();
    assert_eq!(host.set_reals(&[("wheel.z", -0.5)]), Status::Ok);
    assert_eq!(derivative(&host, &FORCES, &SEEDS), Ok(vec![0.0; FORCES.len()]));
    assert_eq!(derivative(&host, &["vertical.wheel_z"], &SEEDS), Ok(vec![0.3]));
}

#[test]
fn what_has_no_derivative_is_refused_by_name() {
    let host = Host::stepping();
    assert_eq!(host.set_reals(&PRESSED), Status::Ok);
    for (unknown, known, words) in [
        ("wheel.y", "wheel.z", "wheel.y is not admitted as unknown"),
        ("patch_count", "wheel.z", "patch_count is of type Integer"),
        ("nominal.wheel_z", "wheel.y", "nominal.wheel_z is not admitted as unknown"),
        ("wheel.force.x", "track.gauge", "track.gauge is not admitted as known"),
        ("wheel.force.x", "wheel.force.y", "wheel.force.y is not admitted as known"),
    ] {
        assert_eq!(derivative(&host, &[unknown], &[(known, 1.0)]), Err(Status::Error));
        assert!(host.last().contains(words), "{}", host.last());
    }
    assert!(derivative(&host, &["wheel.force.x"], &[("wheel.y", f64::NAN)]).is_err());
    assert!(host.last().contains("seed NaN of wheel.y"), "{}", host.last());
    let mut found = 0.0;
    let (force, beyond) = (reference("wheel.force.x"), VARIABLES.len() as ValueReference);
    // SAFETY: FMI 2.0, 2.1.9: arrays of one element.
    let status = unsafe {
        let (known, seed) = (&raw const beyond, &1.0);
        fmi2GetDirectionalDerivative(
            host.component,
            &raw const force,
            1,
            known,
            1,
            seed,
            &raw mut found,
        )
    };
    assert_eq!(status, Status::Error);
    assert!(host.last().contains("does not exist"), "{}", host.last());
    // The instance goes on.
    assert!(derivative(&host, &FORCES, &SEEDS).is_ok());
}

#[test]
fn models_without_derivatives_are_refused_by_name() {
    for (parameter, value) in [("normal.model", 5), ("tangential.model", 7)] {
        let host = Host::initializing();
        assert_eq!(host.set_integer(parameter, value), Status::Ok, "{}", host.last());
        assert!(derivative(&host, &FORCES, &SEEDS).is_err());
        assert!(host.last().contains(parameter), "{}", host.last());
    }
    let host = Host::initializing();
    assert_eq!(host.set_reals(&[("rail[1].corrugation.amplitude", 1e-5)]), Status::Ok);
    assert!(derivative(&host, &FORCES, &SEEDS).is_err());
    assert!(host.last().contains("corrugation"), "{}", host.last());
}

#[test]
fn outputs_depend_on_no_input_that_is_not_declared() {
    let host = Host::stepping();
    assert_eq!(host.set_reals(&PRESSED), Status::Ok);
    let outputs: Vec<_> = VARIABLES
        .iter()
        // What is computed on request is a derivative itself.
        .filter(|v| v.causality == Causality::Output && v.kind == Kind::Real && !v.on_request)
        .collect();
    let names: Vec<&str> = outputs.iter().map(|v| v.name).collect();
    for input in VARIABLES.iter().filter(|v| v.causality == Causality::Input) {
        let rates = derivative(&host, &names, &[(input.name, 1.0)]).unwrap();
        for (output, rate) in outputs.iter().zip(rates) {
            let is_declared = output.dependencies.contains(&input.reference);
            assert!(is_declared || rate == 0.0, "{} by {}: {rate}", output.name, input.name);
        }
    }
}
