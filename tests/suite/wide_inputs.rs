//! Forces stay finite for every finite input, however far from a wheel on a rail.

use crate::tolerance;
use proptest::prelude::*;
use wheelrail::element::parameters::{CreepageModel, NormalModel, TangentialModel, VerticalMode};
use wheelrail::element::{Element, Input, Output, Parameters};
use wheelrail::variables::{Causality, Described, Kind, VARIABLES, Values, Variable};

/// A number of any size and sign, small ones as likely as large ones.
fn any_size() -> impl Strategy<Value = f64> {
    (-15.0..308.2f64, any::<bool>())
        .prop_map(|(power, minus)| if minus { -(10f64.powf(power)) } else { 10f64.powf(power) })
}

/// A value around `middle` within `reach`.
fn around(middle: f64, reach: f64) -> impl Strategy<Value = f64> {
    (-1.0..1.0f64).prop_map(move |t| middle + reach * t)
}

prop_compose! {
    /// A wheel somewhere at, above, beside, below or inside the rail, moving anyhow.
    fn near_the_rail()(
        y in around(0.75, 0.2),
        z in around(-0.46, 0.06),
        angles in [around(0.0, 0.2), around(0.0, 0.2), around(0.0, 4.0)],
        velocity in [around(0.0, 150.0), around(0.0, 5.0), around(0.0, 5.0)],
        rates in [around(0.0, 5.0), around(0.0, 5.0), around(0.0, 350.0)],
        rail in [around(0.0, 0.02), around(0.0, 0.02), around(0.0, 0.1)],
        friction in 0.0..2.0f64,
        load in -1e4..3e5f64,
    ) -> Input {
        let mut input = Input::default();
        input.wheel.position = [0.0, y, z];
        [input.wheel.roll, input.wheel.yaw, input.wheel.pitch] = angles;
        input.wheel.velocity = velocity;
        [input.wheel.roll_rate, input.wheel.yaw_rate, input.wheel.pitch_rate] = rates;
        [input.rails[0].y, input.rails[0].z, input.rails[0].roll] = rail;
        input.friction = friction;
        input.wheel_load = load;
        input
    }
}

prop_compose! {
    /// Inputs of any size.
    fn anywhere()(
        position in [any_size(), any_size(), any_size()],
        angles in [any_size(), any_size(), any_size()],
        velocity in [any_size(), any_size(), any_size()],
        rail in [any_size(), any_size(), any_size()],
        rail_velocity in [any_size(), any_size(), any_size()],
        friction in any_size(),
        load in any_size(),
    ) -> Input {
        let mut input = Input::default();
        input.wheel.position = position;
        [input.wheel.roll, input.wheel.yaw, input.wheel.pitch_rate] = angles;
        input.wheel.velocity = velocity;
        let own = &mut input.rails[0];
        [own.y, own.z, own.roll] = rail;
        [own.vy, own.vz, own.roll_rate] = rail_velocity;
        input.friction = friction.abs();
        input.wheel_load = load;
        input
    }
}

prop_compose! {
    /// A wheel on the rail, one of its inputs of any size.
    fn one_of_any_size()(input in near_the_rail(), which in 0..20usize, size in any_size()) -> Input {
        let mut input = input;
        let (wheel, rail) = (&mut input.wheel, &mut input.rails[0]);
        // On the rail, unless its place is what is changed.
        (wheel.position[1], wheel.position[2]) = (0.75 + 0.02 * wheel.roll, -0.4598);
        (wheel.roll, wheel.yaw) = (0.01 * wheel.roll, 0.1 * wheel.yaw);
        (rail.y, rail.z, rail.roll) = (0.1 * rail.y, 0.0, 0.01 * rail.roll);
        let [x, y, z] = &mut wheel.position;
        let [vx, vy, vz] = &mut wheel.velocity;
        let rates = [&mut wheel.roll_rate, &mut wheel.yaw_rate, &mut wheel.pitch_rate];
        let angles = [&mut wheel.roll, &mut wheel.yaw, &mut wheel.pitch];
        let rail =
            [&mut rail.y, &mut rail.z, &mut rail.roll, &mut rail.vy, &mut rail.vz, &mut rail.roll_rate];
        let all = [x, y, z, vx, vy, vz].into_iter().chain(rates).chain(angles).chain(rail);
        let all = all.chain([&mut input.track_s, &mut input.wheel_load]);
        if let Some(one) = all.into_iter().nth(which) {
            *one = size;
        }
        input
    }
}

/// Evaluates and asserts what holds for every input.
fn check(element: &mut Element, input: &Input) -> Result<(), TestCaseError> {
    let mut output = Output::default();
    element.evaluate(input, &mut output).expect("finite inputs are admitted");
    let wrenches = [output.wheel, output.rails[0]];
    let all_finite =
        wrenches.iter().flat_map(|w| w.force.iter().chain(&w.moment)).all(|v| v.is_finite());
    prop_assert!(all_finite, "{input:?} gives {wrenches:?}");
    prop_assert!(output.wear_number.is_finite() && output.wear_number >= 0.0);
    prop_assert!(output.frictional_power.is_finite() && output.frictional_power >= 0.0);
    let friction = input.friction.min(1e100);
    for patch in output.patches.iter().take(output.patch_count as usize) {
        let limit =
            tolerance::most_friction(false, patch.penetration) * friction * patch.normal_force;
        let force = patch.creep_force[0].hypot(patch.creep_force[1]);
        prop_assert!(patch.normal_force >= 0.0 && patch.max_pressure >= 0.0, "{patch:?}");
        prop_assert!(force <= limit, "{patch:?}");
        prop_assert!((0.0..=1.0).contains(&patch.slip_share), "{patch:?}");
    }
    Ok(())
}

#[test]
fn an_element_can_be_made_wherever_the_wheel_starts() {
    proptest!(ProptestConfig::with_cases(200), |(start in anywhere())| {
        let element = Element::new(&Parameters::default(), &start, &[]);
        prop_assert!(element.expect("finite starts are admitted").nominal_wheel_z().is_finite());
    });
}

#[test]
fn without_a_rail_there_is_no_force_and_no_height_to_find() {
    let mut parameters = Parameters::default();
    parameters.rails[0].enabled = false;
    let start = Input::default();
    let mut element = Element::new(&parameters, &start, &[]).expect("a wheel without a rail");
    assert!((element.nominal_wheel_z() - start.wheel.position[2]).abs() <= 0.0);
    let mut output = Output::default();
    element.evaluate(&start, &mut output).expect("finite input");
    let mut expected = Output::default();
    expected.wheel_z = start.wheel.position[2];
    assert_eq!(output, expected);
}

#[test]
fn a_radius_that_does_not_go_with_the_profile_is_refused_by_name() {
    let mut parameters = Parameters::default();
    for radius in [1e-3, 0.02] {
        parameters.wheel.nominal_radius = radius;
        let error = Element::new(&parameters, &Input::default(), &[]).unwrap_err();
        assert!(error.to_string().starts_with("wheel.nominal_radius"), "{error}");
    }
}

fn element(
    normal_model: NormalModel,
    creepage_model: CreepageModel,
    tangential_model: TangentialModel,
    vertical_mode: VerticalMode,
) -> Element {
    let parameters = Parameters {
        normal_model,
        creepage_model,
        tangential_model,
        vertical_mode,
        strips: if normal_model == NormalModel::Strips { 9 } else { 30 },
        ..Parameters::default()
    };
    Element::new(&parameters, &Input::default(), &[]).expect("built-in profiles")
}

#[test]
fn forces_are_finite_and_bounded_by_friction_wherever_the_wheel_is() {
    let (fastsim, given) = (TangentialModel::Fastsim, VerticalMode::Penetration);
    for (normal, creepage, tangential, vertical) in [
        (NormalModel::PiotrowskiKik, CreepageModel::Flat, fastsim, given),
        (NormalModel::PiotrowskiKik, CreepageModel::Curved, TangentialModel::Fastrip, given),
        (NormalModel::PiotrowskiKikCorrected, CreepageModel::Curved, fastsim, given),
        (NormalModel::Hertz, CreepageModel::Curved, fastsim, given),
        (NormalModel::PiotrowskiKik, CreepageModel::Flat, fastsim, VerticalMode::Load),
        (NormalModel::Strips, CreepageModel::Flat, fastsim, given),
        (NormalModel::PiotrowskiKik, CreepageModel::Flat, TangentialModel::Tables, given),
        (NormalModel::Hertz, CreepageModel::Curved, TangentialModel::Tables, VerticalMode::Load),
        (NormalModel::PiotrowskiKik, CreepageModel::Flat, TangentialModel::FastsimCorrected, given),
        (NormalModel::PiotrowskiKik, CreepageModel::Curved, TangentialModel::Marches, given),
        (NormalModel::Strips, CreepageModel::Curved, TangentialModel::Marches, given),
    ] {
        // A wheel centimetres inside a rail is beyond the strip model, which takes long to give up.
        let cases = if normal == NormalModel::Strips { 200 } else { 4000 };
        let shared = std::cell::RefCell::new(element(normal, creepage, tangential, vertical));
        proptest!(ProptestConfig::with_cases(cases), |(input in near_the_rail())| {
            check(&mut shared.borrow_mut(), &input)?;
        });
        proptest!(ProptestConfig::with_cases(1000), |(input in anywhere())| {
            check(&mut shared.borrow_mut(), &input)?;
        });
        let cases = if normal == NormalModel::Strips { 100 } else { 1000 };
        proptest!(ProptestConfig::with_cases(cases), |(input in one_of_any_size())| {
            check(&mut shared.borrow_mut(), &input)?;
        });
    }
}

/// The parameters that are numbers, each with the least and greatest value that it admits; those of the
/// host's wheelset are the unit's alone.
fn parameter_ranges() -> impl Iterator<Item = (&'static Variable, [f64; 2])> {
    let parameters = VARIABLES.iter().filter(|v| v.causality == Causality::Parameter);
    let numbers = parameters.filter(|v| v.kind == Kind::Real && !v.name.starts_with("coupling."));
    numbers.map(|v| (v, [v.min.unwrap_or(f64::MIN), v.max.unwrap_or(f64::MAX)]))
}

/// The default parameters with one number set, whatever it is.
fn with_parameter(variable: &Variable, value: f64) -> Parameters {
    let mut values = Values::default();
    *Element::real_slot(&mut values, variable.reference).unwrap() = value;
    values.parameters
}

#[test]
fn parameters_beyond_their_ranges_are_refused_by_name_in_the_crate_too() {
    for (variable, [least, most]) in parameter_ranges() {
        let mut beyond = vec![f64::NAN, f64::INFINITY];
        beyond.extend(variable.max.map(|_| most + 1e-3 * most.abs().max(1e-3)));
        beyond.extend(variable.max.map(|_| f64::MAX));
        beyond.extend(variable.min.map(|_| least - 1e-3 * least.abs().max(1e-3)));
        for value in beyond {
            let refusal = with_parameter(variable, value).check().unwrap_err().to_string();
            let words = format!("{} = {value}", variable.name);
            assert!(refusal.starts_with(&words) && refusal.contains(variable.allowed), "{refusal}");
        }
    }
}

#[test]
fn at_the_ends_of_the_ranges_of_parameters_forces_are_numbers() {
    use wheelrail::element::parameters::NormalModel;
    let mut refused = Vec::new();
    for (variable, ends) in parameter_ranges() {
        for end in ends {
            for normal_model in [NormalModel::PiotrowskiKik, NormalModel::Strips] {
                let parameters = Parameters { normal_model, ..with_parameter(variable, end) };
                let mut input = Input::default();
                // Together with others it may be refused.
                let Ok(mut element) = Element::new(&parameters, &input, &[]) else {
                    refused.push(variable.name);
                    continue;
                };
                input.wheel.position[2] = element.nominal_wheel_z() + 1e-4;
                input.wheel.velocity = [20.0, 0.1, 0.01];
                input.wheel.pitch_rate = -20.2 / 0.46;
                let mut output = Output::default();
                element.evaluate(&input, &mut output).unwrap();
                let wrenches = [output.wheel, output.rails[0]];
                let numbers = wrenches.iter().flat_map(|w| w.force.iter().chain(&w.moment));
                let numbers = numbers.chain([&output.frictional_power, &output.wear_number]);
                assert!(numbers.copied().all(f64::is_finite), "{} = {end}", variable.name);
            }
        }
    }
    refused.dedup();
    println!("refused at an end of the range, with the other parameters by default: {refused:?}");
    assert!(refused.len() < 20, "{refused:?}");
}
