//! `fmi2GetDirectionalDerivative` called as an importer calls it: values, modes, refusals, and that
//! nothing else changes.
#![allow(unsafe_code)]

use crate::host::{Arguments, Host, reference};
use wheelrail::element::{Element, Input, Output, Parameters};
use wheelrail::fmi::v2::types::{Status, ValueReference};
use wheelrail::fmi::v2::{
    fmi2EnterContinuousTimeMode, fmi2ExitInitializationMode, fmi2GetDirectionalDerivative,
    fmi2Terminate,
};
use wheelrail::variables::{Causality, Kind, Unit, VARIABLES, Variable, WHEEL, WHEELSET};

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
    asked(host, &unknowns, &knowns, &seeds)
}

/// The same by references.
fn asked(
    host: &Host,
    unknowns: &[ValueReference],
    knowns: &[ValueReference],
    seeds: &[f64],
) -> Result<Vec<f64>, Status> {
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

/// The input of `PRESSED`.
fn pressed() -> Input {
    let mut input = Input::default();
    (input.wheel.position[2], input.wheel.position[1], input.wheel.yaw) = (-0.4597, 0.751, 0.01);
    (input.wheel.velocity[0], input.wheel.pitch_rate) = (20.0, -43.4);
    input
}

/// What the element says.
fn expected() -> Vec<f64> {
    let input = pressed();
    let mut direction = Input::at_rest();
    (direction.wheel.position[2], direction.wheel.yaw) = (0.3, -2.0);
    (direction.wheel.velocity[1], direction.friction) = (1.5, -0.7);
    let mut element = Element::new(&Parameters::default(), &Input::default(), &[]).unwrap();
    let mut rates = Output::default();
    element.directional_derivative(&input, &direction, &mut rates).unwrap();
    forces_of(&rates)
}

/// What is named in `FORCES`.
fn forces_of(output: &Output) -> Vec<f64> {
    let Output { wheel, rails, patches, .. } = output;
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
fn the_station_on_a_rail_that_varies_has_the_derivatives_of_the_element() {
    let folder = tempfile::TempDir::new().unwrap();
    let table = folder.path().join("rail.csv");
    std::fs::write(&table, "station_m,profile\n-1,60E1\n0,54E1\n1,60E1\n").unwrap();
    let table = table.to_str().unwrap();
    let mut parameters = Parameters::default();
    parameters.rails[0].profile = table.into();
    let input = Input { track_s: 0.4, ..pressed() };
    let mut direction = Input::at_rest();
    direction.track_s = 2.0;
    let mut element = Element::new(&parameters, &input, &[]).unwrap();
    let mut rates = Output::default();
    element.directional_derivative(&input, &direction, &mut rates).unwrap();
    let wanted = forces_of(&rates);
    assert!(wanted.iter().all(|rate| rate.abs() > 1.0), "{wanted:?}");
    let host = Host::initializing();
    assert_eq!(host.set_text("rail[1].profile", table), Status::Ok);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
    assert_eq!(host.set_reals(&PRESSED), Status::Ok);
    assert_eq!(host.set_reals(&[("track.s", 0.4)]), Status::Ok);
    assert_eq!(derivative(&host, &FORCES, &[("track.s", 2.0)]), Ok(wanted));
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
        (
            "wheel.force.x",
            "track.gauge",
            "track.gauge is not admitted as known of a directional derivative: it is fixed",
        ),
        ("wheel.force.x", "wheel.nominal_radius", "wheel.nominal_radius is not admitted as known"),
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

/// Central difference of an output over an input.
fn difference(host: &Host, output: &str, input: &str, step: f64) -> f64 {
    let at = host.get_real(input);
    let [low, high] = [at - step, at + step].map(|beside| {
        assert_eq!(host.set_reals(&[(input, beside)]), Status::Ok);
        host.get_real(output)
    });
    assert_eq!(host.set_reals(&[(input, at)]), Status::Ok);
    (high - low) / (2.0 * step)
}

#[test]
fn models_and_places_without_exact_derivatives_answer_by_differences() {
    let uneven = |host: &Host| {
        host.set_integer("normal.model", 2)
            .max(host.set_reals(&[("rail[1].corrugation.amplitude", 1e-5)]))
    };
    let boundary_elements = |host: &Host| {
        host.set_integer("normal.elements_along", 8).max(host.set_integer("normal.model", 5))
    };
    let tangential = |host: &Host| {
        host.set_integer("tangential.elements_along", 6)
            .max(host.set_integer("tangential.model", 7))
    };
    let models: [&dyn Fn(&Host) -> Status; 3] = [&uneven, &boundary_elements, &tangential];
    for (place, set) in models.into_iter().enumerate() {
        let host = Host::initializing();
        assert_eq!(set(&host), Status::Ok, "{}", host.last());
        assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
        assert_eq!(host.set_reals(&PRESSED), Status::Ok);
        let before = host.get_reals(&FORCES).unwrap();
        let fallbacks = host.get_integer("fallback_count");
        for (input, step) in [("wheel.z", 3e-7), ("wheel.vx", 1e-3)] {
            for output in ["wheel.force.z", "wheel.force.x"] {
                let found = derivative(&host, &[output], &[(input, 2.0)]).unwrap()[0];
                let wanted = 2.0 * difference(&host, output, input, step);
                let scale = if output == "wheel.force.x" { before[0] } else { before[1] }.abs();
                let error = (found - wanted).abs() / (wanted.abs() + scale);
                // Boundary elements enter the patch as a whole: over a greater step the force is a
                // little rough.
                assert!(error < 3e-2, "{place}: {output} by {input}: {found}, not {wanted}");
            }
        }
        assert_eq!(host.get_reals(&FORCES), Ok(before));
        assert_eq!(host.get_integer("fallback_count"), fallbacks);
    }
}

#[test]
fn stiffness_and_damping_have_derivatives() {
    let host = Host::initializing();
    let slopes = ["contact.stiffness", "contact.damping", "wheel.force.z"];
    assert_eq!(host.set_reals(&PRESSED), Status::Ok);
    assert_eq!(derivative(&host, &slopes[..2], &[("wheel.z", 1.0)]), Ok(vec![0.0; 2]));
    assert_eq!(host.set_boolean("coupling.monitor", true), Status::Ok);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
    // A slope bends a little wherever a strip becomes loaded: near by, and over half a micrometre.
    let steps = [(1.1e-7, 0.03), (4e-7, 0.1)];
    let mut errors = [const { Vec::new() }; 4];
    for way in 0..5 {
        assert_eq!(host.set_reals(&[("wheel.z", -0.4597 + 1e-5 * f64::from(way))]), Status::Ok);
        let before = host.get_reals(&slopes).unwrap();
        let found = derivative(&host, &slopes, &[("wheel.z", 1.0)]).unwrap();
        assert!((found[2] + before[0]).abs() < 1e-9 * before[0]);
        for (place, name) in slopes[..2].iter().enumerate() {
            for (k, (step, _)) in steps.into_iter().enumerate() {
                let wanted = difference(&host, name, "wheel.z", step);
                errors[2 * place + k].push((found[place] - wanted).abs() / wanted.abs());
            }
        }
        // A contact that stiffens by half a power or so of its depth of 0.1 mm.
        assert!(found[0] > 1e12 && found[0] < 1e14, "{found:?}");
        assert_eq!(host.get_reals(&slopes), Ok(before));
    }
    for (k, errors) in errors.iter_mut().enumerate() {
        errors.sort_by(f64::total_cmp);
        assert!(errors[2] < steps[k % 2].1, "{}: {errors:?}", slopes[k / 2]);
    }
}

#[test]
fn parameters_and_nominal_heights_answer_in_initialization_mode() {
    let host = Host::initializing();
    let at_rest = [("wheel.z", -0.4597), ("wheel.vx", 0.0), ("wheel.pitch_rate", 0.0)];
    assert_eq!(host.set_reals(&at_rest), Status::Ok);
    let of = |unknown: &str, known: &str| {
        derivative(&host, &[unknown], &[(known, 1.0)]).unwrap_or_else(|_| panic!("{}", host.last()))
            [0]
    };
    // A greater wheel stands higher; a lower rail lets it down.
    let by_radius = of("nominal.wheel_z", "wheel.nominal_radius");
    assert!((by_radius + 1.0).abs() < 1e-6, "{by_radius}");
    let by_rail = of("nominal.wheel_z", "rail[1].z");
    assert!((by_rail - 1.0).abs() < 1e-6, "{by_rail}");
    // Of two bodies of one material each gives half of what elasticity there is.
    let force = host.get_real("wheel.force.z");
    let by_modulus = of("wheel.force.z", "rail.young_modulus");
    let wanted = 0.5 * force / 2.1e11;
    assert!((by_modulus / wanted - 1.0).abs() < 1e-5, "{by_modulus}, not {wanted}");
    // At the end of its range from one side; at rest there is nothing to damp.
    assert_eq!(host.set_reals(&[("normal.damping", 0.0), ("wheel.vz", 0.1)]), Status::Ok);
    let by_damping = of("wheel.force.z", "normal.damping");
    assert!(by_damping < 0.0, "{by_damping}");
    // All at once is the sum.
    let seeds = [("wheel.nominal_radius", 2.0), ("rail.young_modulus", 1e9), ("wheel.z", -0.5)];
    let sum: f64 = seeds.iter().map(|(name, seed)| seed * of("wheel.force.z", name)).sum();
    let together = derivative(&host, &["wheel.force.z"], &seeds).unwrap()[0];
    assert!((together - sum).abs() < 1e-9 * sum.abs(), "{together}, not {sum}");
    assert_eq!(host.get_real("wheel.force.z").to_bits(), {
        assert_eq!(host.set_reals(&[("wheel.vz", 0.1)]), Status::Ok);
        host.get_real("wheel.force.z").to_bits()
    });
}

/// What `ModelStructure` says of a unit: every unknown by everything that it depends on.
fn every_advertised_pair_answers(unit: &'static Unit, stride: usize) {
    let host = Host::initializing_with(&Arguments::of(unit));
    assert_eq!(host.set_boolean("coupling.monitor", true), Status::Ok);
    let start: &[(&str, f64)] = if unit.identifier == "WheelSet" {
        &[("wheelset.z", -0.4597), ("wheelset.vx", 20.0), ("wheelset.pitch_rate", -43.4)]
    } else {
        &PRESSED
    };
    assert_eq!(host.set_reals(start), Status::Ok, "{}", host.last());
    let unknowns: Vec<_> = (unit.variables.iter())
        .filter(|v| !v.is_settable() && v.kind == Kind::Real)
        .map(|v| v.reference as ValueReference)
        .collect();
    let ask = |mode: &str, known: &Variable, unknowns: &[ValueReference]| {
        let found = asked(&host, unknowns, &[known.reference as ValueReference], &[1.0])
            .unwrap_or_else(|_| panic!("{mode}: {}: {}", known.name, host.last()));
        assert!(found.iter().all(|rate| rate.is_finite()), "{mode}: {}: {found:?}", known.name);
    };
    let knowns = |causality: Causality| {
        let all = unit.variables.iter().filter(move |v| v.causality == causality);
        all.filter(|v| v.kind == Kind::Real)
    };
    for known in knowns(Causality::Input).chain(knowns(Causality::Parameter)).step_by(stride) {
        ask("initialization", known, &unknowns);
    }
    assert!(fmi2ExitInitializationMode(host.component) <= Status::Warning, "{}", host.last());
    let outputs: Vec<_> = (unknowns.iter().copied())
        .filter(|&r| unit.variables[r as usize].causality == Causality::Output)
        .collect();
    for known in knowns(Causality::Input) {
        ask("stepping", known, &outputs);
    }
}

#[test]
fn every_advertised_pair_of_a_wheel_answers() {
    every_advertised_pair_answers(&WHEEL, 1);
}

#[test]
fn every_advertised_pair_of_a_wheelset_answers() {
    // Each parameter makes four wheels: every third of them.
    every_advertised_pair_answers(&WHEELSET, 3);
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
