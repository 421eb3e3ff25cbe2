//! Of a wheelset, by its inputs and by parameters of its wheels, known as its unit names them.

use super::difference;
use crate::common::random::Random;
use crate::tolerance;
use wheelrail::element::subject::{BySubject, Subject};
use wheelrail::variables::{Causality, Described, Kind, Value, Variable, WHEELSET, WheelsetValues};
use wheelrail::wheelset::Wheelset;

/// Real variables of a kind; of outputs those that have derivatives.
fn reals(causality: Causality) -> impl Iterator<Item = &'static Variable> {
    WHEELSET.variables.iter().filter(move |v| v.causality == causality && v.kind == Kind::Real)
}

fn outputs() -> impl Iterator<Item = &'static Variable> {
    let left_out = |name: &str| {
        name.contains("residual") || name.starts_with("coupling.") || name.contains(".wear.")
    };
    reals(Causality::Output).filter(move |v| !v.on_request && !left_out(v.name))
}

fn set(values: &mut WheelsetValues, named: &[(&str, f64)]) {
    for (name, number) in named {
        let variable = WHEELSET.find(name).unwrap();
        let value = match variable.kind {
            Kind::Real => Value::Real(*number),
            _ => Value::Integer(*number as i32),
        };
        values.set(variable, value).unwrap();
    }
}

/// A pose beside the middle of the track, with `more` set.
fn placed(more: &[(&str, f64)]) -> WheelsetValues {
    let mut values = WheelsetValues::default();
    let pose = [
        ("wheelset.y", 1.3e-3),
        ("wheelset.z", -0.45973),
        ("wheelset.roll", 2e-5),
        ("wheelset.yaw", 2e-3),
        ("wheelset.vy", 3e-3),
        ("wheelset.yaw_rate", -2e-3),
        ("wheelset.pitch_rate", -43.5),
        ("left.wheel.load", 7e4),
    ];
    set(&mut values, &pose);
    set(&mut values, more);
    values
}

fn made(values: &WheelsetValues) -> Wheelset {
    Wheelset::prepare(&values.parameters, &values.input, &[]).unwrap()
}

fn number(values: &WheelsetValues, variable: &Variable) -> f64 {
    Wheelset::real(values, variable.reference).unwrap()
}

/// Random weights of all outputs as an output: each a share of what the output is about.
fn weighted(values: &WheelsetValues) -> WheelsetValues {
    let (mut random, mut weights) = (Random::new(17), WheelsetValues::default());
    weights.output = <Wheelset as Subject>::Output::default();
    for variable in outputs() {
        let about = number(values, variable).abs().max(1e-3);
        *Wheelset::output_slot(&mut weights, variable.reference).unwrap() +=
            random.about(1.0) / about;
    }
    weights
}

fn sum_of(values: &WheelsetValues, weights: &WheelsetValues) -> [f64; 2] {
    outputs().fold([0.0; 2], |[sum, size], variable| {
        let product = number(values, variable) * number(weights, variable);
        [sum + product, size + product.abs()]
    })
}

/// About how far an input goes in service.
fn usual(name: &str) -> f64 {
    match name {
        _ if name.ends_with("load") => 1e4,
        _ if name.contains("friction") => 0.1,
        _ if name.ends_with("_rate") || name.contains(".v") => 0.1,
        _ if name.ends_with("roll") || name.ends_with("yaw") || name.ends_with("pitch") => 1e-3,
        _ if name.contains("slope") => 1e-3,
        _ => 1e-4,
    }
}

/// Ways to move and to carry a wheelset.
const WAYS: [(&str, &[(&str, f64)]); 5] = [
    ("plain", &[]),
    (
        "on a real track",
        &[
            ("track.curvature", 2e-3),
            ("track.twist", 1e-3),
            ("right.irregularity.z_slope", 2e-3),
            ("left.irregularity.y_slope", -1e-3),
            ("left.irregularity.y", 5e-4),
        ],
    ),
    ("loads", &[("vertical.mode", 2.0)]),
    (
        "loads on a real track",
        &[("vertical.mode", 2.0), ("track.curvature", 2e-3), ("right.irregularity.z_slope", 2e-3)],
    ),
    ("rolling on springs", &[("motion", 2.0), ("track.foundation.model", 2.0)]),
];

#[test]
fn by_all_inputs_at_once() {
    for (name, more) in WAYS {
        let mut values = placed(more);
        let mut own = made(&values);
        own.evaluate_all(&values.input, &mut values.output).unwrap();
        assert!(values.output.patch_count > 1, "{name}");
        let weights = weighted(&values);
        let mut found = BySubject::default();
        own.adjoint_derivative_of_all(&values.input, &weights.output, &mut found).unwrap();
        let mut back = WheelsetValues { input: found.input, ..WheelsetValues::default() };
        let (mut errors, mut most) = (Vec::new(), 0.0_f64);
        for variable in reals(Causality::Input) {
            let mut direction = WheelsetValues::default();
            for other in reals(Causality::Input) {
                direction.set(other, Value::Real(0.0)).unwrap();
            }
            direction.set(variable, Value::Real(1.0)).unwrap_or_else(|_| {
                // Slopes and turns are admitted up to 0.1: their rates are as well.
                direction.set(variable, Value::Real(0.1)).unwrap();
            });
            let share = number(&direction, variable);
            let (at, along) = (&values.input, &direction.input);
            let mut rates = <Wheelset as Subject>::Output::default();
            own.directional_derivative_of_all(at, along, &mut rates).unwrap();
            back.output = rates;
            let [sum, size] = sum_of(&back, &weights).map(|sum| sum / share);
            let unit = usual(variable.name);
            most = most.max(size * unit);
            errors.push((variable.name, (number(&back, variable) - sum).abs() * unit, sum));
        }
        let (worst, error, sum) = *errors.iter().max_by(|a, b| a.1.total_cmp(&b.1)).unwrap();
        println!("{name}: {:e} of the greatest effect, {worst} {sum:e}", error / most);
        assert!(most > 0.0 && error < tolerance::BACKWARDS * most, "{name} {worst}");
        let mut again = values.clone();
        own.evaluate_all(&values.input, &mut again.output).unwrap();
        assert_eq!(again.output, values.output, "{name}: it is left as it was");
    }
}

/// Parameters, and about how far they go.
const PARAMETERS: [(&str, f64); 7] = [
    ("right.wheel.nominal_radius", 1e-4),
    ("left.wheel.nominal_radius", 1e-4),
    ("wheel.young_modulus", 1e10),
    ("rail.young_modulus", 1e10),
    ("track.gauge", 1e-4),
    ("left.rail[1].inclination", 1e-3),
    ("track.foundation.stiffness.z", 1e6),
];

#[test]
fn by_parameters_of_one_wheel_and_of_both() {
    for (name, more) in WAYS {
        // Without kinks where an element begins to slip.
        let smooth = [("tangential.model", 5.0)];
        let mut values = placed(&[&smooth[..], more].concat());
        let mut own = made(&values);
        own.evaluate_all(&values.input, &mut values.output).unwrap();
        let weights = weighted(&values);
        let mut found = BySubject::default();
        own.adjoint_derivative_of_all(&values.input, &weights.output, &mut found).unwrap();
        let slopes = PARAMETERS.map(|(name, _)| found.parameter(name).unwrap());
        let effects = slopes.iter().zip(PARAMETERS).map(|(slope, (_, unit))| (slope * unit).abs());
        let most = effects.fold(0.0, f64::max);
        for ((parameter, unit), slope) in PARAMETERS.into_iter().zip(slopes) {
            let variable = WHEELSET.find(parameter).unwrap();
            let start = number(&values, variable);
            let at = |way: f64| {
                let mut moved = values.clone();
                moved.set(variable, Value::Real(start + way)).unwrap();
                made(&moved).evaluate_all(&values.input, &mut moved.output).unwrap();
                sum_of(&moved, &weights)[0]
            };
            // Zones that have just begun bend within some tens of nanometres.
            let both = [1e-2, 1e-4].map(|share| difference(share * unit, at));
            let errors = both.map(|both| both.map(|by| (by - slope).abs() * unit / most));
            println!("{name} {parameter}: {slope:e}, off by {errors:?}");
            let error = errors.as_flattened().iter().copied().fold(f64::INFINITY, f64::min);
            assert!(error < tolerance::BACKWARDS_DIFFERENCES, "{name} {parameter}");
        }
        assert_eq!(found.parameter("flange_back_distance"), None);
    }
}
