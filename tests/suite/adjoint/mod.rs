//! Derivatives backwards: those by inputs against those forwards, those by parameters and by points
//! of the profiles against differences.

mod parameters;
mod points;
mod varying_rails;
mod wheelset;

use crate::common::random::Random;
use crate::common::wheel::{element, evaluate, mirrored, random_input};
use crate::tolerance;
use wheelrail::element::input::{INPUT_NAMES, INPUTS};
use wheelrail::element::parameters::{
    CreepageModel, Foundation, FoundationModel, FrictionDistribution, FrictionLaw, Motion,
    NormalModel, Side, TangentialModel, VerticalMode,
};
use wheelrail::element::{Element, Gradient, Input, Output, Parameters};
use wheelrail::error::ContactError;

/// Poses of each model, of a right wheel and of a left one.
const POSES: usize = 2;

/// Weights of all outputs, each a random share of what the output is about as large as; none of
/// residuals, which are what iterations have left.
fn weights(random: &mut Random, about: &Output) -> Output {
    let mut weights = about.each(|number: f64| random.about(1.0) / number.abs().max(1e-3));
    (weights.normal_residual, weights.tangential_residual) = (0.0, 0.0);
    weights
}

/// Σ weight · number, and the same of magnitudes.
fn weighted(weights: &Output, numbers: &Output) -> [f64; 2] {
    let mut all = Vec::new();
    let _ = weights.each(|weight: f64| {
        all.push(weight);
        weight
    });
    let (mut sums, mut n) = ([0.0; 2], 0);
    let _ = numbers.each(|number: f64| {
        let own = number * all[n];
        sums = [sums[0] + own, sums[1] + own.abs()];
        n += 1;
        number
    });
    sums
}

/// About how far an input goes in service, so that effects of all inputs can be compared.
fn usual(name: &str) -> f64 {
    match name {
        "wheel.load" => 1e4,
        _ if name.contains("friction") => 0.1,
        _ if name.ends_with("_rate") || name.contains(".v") => 0.1,
        _ if name.ends_with("roll") || name.ends_with("yaw") || name.ends_with("pitch") => 1e-3,
        _ => 1e-4,
    }
}

/// A pressed pose of a wheel with these parameters.
fn pose(parameters: &Parameters, random: &mut Random) -> Input {
    let mut right = element(&parameters.on_side(Side::Right));
    let mut input = random_input(&mut right, random);
    input.wheel_load = random.within(3e4, 1.2e5);
    if parameters.side == Side::Left { mirrored(&input) } else { input }
}

/// Compares derivatives by the inputs at random poses of right and left wheels.
fn judge(name: &str, parameters: &Parameters) {
    let mut worst = 0.0_f64;
    for side in [Side::Right, Side::Left] {
        let parameters = parameters.on_side(side);
        let mut own = element(&parameters);
        let mut random = Random::new(29);
        for _ in 0..POSES {
            let input = pose(&parameters, &mut random);
            let before = evaluate(&mut own, &input);
            let weights = weights(&mut random, &before);
            let mut columns = Vec::new();
            own.jacobian(&input, &mut columns).unwrap();
            let mut gradient = Gradient::default();
            own.adjoint_derivative(&input, &weights, &mut gradient).unwrap();
            let sums: Vec<[f64; 2]> = columns.iter().map(|c| weighted(&weights, c)).collect();
            let unit = |i: usize| usual(INPUT_NAMES[i]);
            let most = (0..INPUTS).map(|i| sums[i][1] * unit(i)).fold(0.0, f64::max);
            assert!(most > 0.0, "{name}: nothing depends on anything");
            for (i, found) in gradient.input.to_array().into_iter().enumerate() {
                worst = worst.max((found - sums[i][0]).abs() * unit(i) / most);
            }
            assert_eq!(evaluate(&mut own, &input), before, "{name}: it is left as it was");
        }
    }
    println!("{name}: {worst:e}");
    assert!(worst < tolerance::BACKWARDS, "{name}: {worst:e}");
}

#[test]
fn of_normal_models() {
    for normal_model in [
        NormalModel::Hertz,
        NormalModel::PiotrowskiKik,
        NormalModel::PiotrowskiKikCorrected,
        NormalModel::Strips,
    ] {
        let parameters = Parameters { normal_model, ..Parameters::default() };
        judge(&format!("{normal_model:?}"), &parameters);
    }
}

#[test]
fn of_tangential_models() {
    for tangential_model in [
        TangentialModel::None,
        TangentialModel::Linear,
        TangentialModel::Fastsim,
        TangentialModel::Fastrip,
        TangentialModel::Tables,
        TangentialModel::Marches,
    ] {
        for creepage_model in [CreepageModel::Flat, CreepageModel::Curved] {
            let normal_model = NormalModel::PiotrowskiKik;
            let parameters = Parameters {
                tangential_model,
                creepage_model,
                normal_model,
                strips: 12,
                ..Parameters::default()
            };
            judge(&format!("{tangential_model:?} {creepage_model:?}"), &parameters);
        }
    }
}

#[test]
fn of_a_given_load_and_of_rails_that_give_way() {
    let normal_model = NormalModel::PiotrowskiKik;
    let plain = Parameters { normal_model, ..Parameters::default() };
    let foundation = Foundation { model: FoundationModel::Massless, ..Foundation::default() };
    let vertical_mode = VerticalMode::Load;
    judge("load", &Parameters { vertical_mode, ..plain.clone() });
    judge("foundation", &Parameters { foundation, ..plain.clone() });
    judge("both", &Parameters { foundation, vertical_mode, ..plain.clone() });
    judge("rolling", &Parameters { motion: Motion::Rolling, ..plain });
    judge("strips, load", &Parameters { vertical_mode, ..Parameters::default() });
}

#[test]
fn of_rollers_two_rails_and_laws_of_friction() {
    let law = FrictionLaw {
        falling_share: 0.4,
        falling_decay: 0.6,
        reduction: 0.5,
        ..FrictionLaw::default()
    };
    let mut parameters = Parameters {
        friction_distribution: FrictionDistribution::Regions,
        friction_law: law,
        ..Parameters::default()
    };
    judge("regions", &parameters);
    parameters.rails[1].enabled = true;
    parameters.rails[1].mirrored = false;
    parameters.rails[1].position = [0.7525, 1e-4];
    judge("two rails", &parameters);
    let mut parameters = Parameters::default();
    parameters.rails[0].roller_radius = 0.5;
    judge("roller", &parameters);
}

#[test]
fn a_lifted_wheel_and_one_without_load_have_them_too() {
    let vertical_mode = VerticalMode::Load;
    let mut loaded = element(&Parameters { vertical_mode, ..Parameters::default() });
    let mut input = Input::default();
    (input.wheel.yaw, input.wheel.roll) = (0.01, 2e-3);
    let weights = Output::default().each(|_: f64| 1.0);
    let (mut columns, mut gradient) = (Vec::new(), Gradient::default());
    loaded.jacobian(&input, &mut columns).unwrap();
    loaded.adjoint_derivative(&input, &weights, &mut gradient).unwrap();
    for (found, column) in gradient.input.to_array().into_iter().zip(&columns) {
        approx::assert_abs_diff_eq!(found, weighted(&weights, column)[0], epsilon = 1e-12);
    }
    let mut lifted = element(&Parameters::default());
    lifted.adjoint_derivative(&input, &weights, &mut gradient).unwrap();
    for (found, wanted) in gradient.input.wheel.position.into_iter().zip([0.0, 0.0, 1.0]) {
        approx::assert_abs_diff_eq!(found, wanted, epsilon = 0.0);
    }
    assert!(gradient.wheel_points.iter().all(|by| by.abs() <= 0.0));
}

#[test]
fn where_there_are_none_forwards_there_are_none_backwards() {
    let normal_model = NormalModel::PiotrowskiKik;
    let mut flat = Parameters { normal_model, ..Parameters::default() };
    flat.wheel.flat.length = 0.03;
    let input = Input::default();
    for parameters in
        [flat, Parameters { normal_model: NormalModel::BoundaryElement, ..Parameters::default() }]
    {
        let mut element = element(&parameters);
        let before = Gradient::default();
        let mut gradient = before.clone();
        let backwards = element.adjoint_derivative(&input, &Output::default(), &mut gradient);
        let forwards = element.directional_derivative(&input, &input, &mut Output::default());
        assert!(matches!(backwards, Err(ContactError::NoDerivative { .. })));
        assert_eq!((backwards, gradient), (forwards, before));
    }
    // Over waves those of strips go forwards alone.
    let mut flat = Parameters::default();
    flat.wheel.flat.length = 0.03;
    let found =
        element(&flat).adjoint_derivative(&input, &Output::default(), &mut Gradient::default());
    assert!(matches!(found, Err(ContactError::NoDerivative { .. })));
    let mut bad = input;
    bad.wheel.yaw = f64::NAN;
    let mut element = element(&Parameters::default());
    let found = element.adjoint_derivative(&bad, &Output::default(), &mut Gradient::default());
    assert!(found.unwrap_err().to_string().contains("wheel.yaw"));
}

/// The derivative of `value` at 0, from central differences over a longer and a shorter distance:
/// where these differ there is a kink within the longer one.
fn difference(step: f64, mut value: impl FnMut(f64) -> f64) -> [f64; 2] {
    [1.0, 0.1].map(|share| {
        let mut over = |h: f64| (value(h) - value(-h)) / (2.0 * h);
        let h = share * step;
        // Extrapolated: what is left is of fourth order.
        (4.0 * over(0.5 * h) - over(h)) / 3.0
    })
}

/// The sum of outputs of an element.
fn sum_of(element: &mut Element, input: &Input, weights: &Output) -> f64 {
    weighted(weights, &evaluate(element, input))[0]
}
