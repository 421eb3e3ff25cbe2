//! By parameters, against elements with other ones.

use super::*;
use wheelrail::element::parameters::{Changeover, Placement};

/// The parameter of this FMI name, and about how far it goes.
fn slot<'a>(parameters: &'a mut Parameters, name: &str) -> (&'a mut f64, f64) {
    if let Some(name) = name.strip_prefix("friction.") {
        let face = name.strip_prefix("gauge_face.");
        let law = match face {
            Some(_) => &mut parameters.gauge_face_law,
            None => &mut parameters.friction_law,
        };
        let number = match face.unwrap_or(name) {
            "falling.share" => &mut law.falling_share,
            "falling.decay" => &mut law.falling_decay,
            "reduction.initial" => &mut law.reduction,
            "reduction.share" => &mut law.reduction_share,
            "reduction.decay" => &mut law.reduction_decay,
            _ => panic!("{name}"),
        };
        return (number, 0.1);
    }
    let [first, second] = &mut parameters.rails;
    match name {
        "wheel.nominal_radius" => (&mut parameters.wheel.nominal_radius, 1e-4),
        "wheel.young_modulus" => (&mut parameters.wheel.young_modulus, 1e10),
        "rail.young_modulus" => (&mut parameters.rail_young_modulus, 1e10),
        "wheel.poisson_ratio" => (&mut parameters.wheel.poisson_ratio, 0.02),
        "rail.poisson_ratio" => (&mut parameters.rail_poisson_ratio, 0.02),
        "track.gauge" => (&mut parameters.gauge, 1e-4),
        "track.gauge_depth" => (&mut parameters.gauge_depth, 1e-3),
        "rail[1].inclination" => (&mut first.inclination, 1e-3),
        "rail[2].inclination" => (&mut second.inclination, 1e-3),
        "rail[1].position.y" => (&mut first.position[0], 1e-4),
        "rail[1].position.z" => (&mut first.position[1], 1e-4),
        "rail[2].position.y" => (&mut second.position[0], 1e-4),
        "rail[2].position.z" => (&mut second.position[1], 1e-4),
        "track.foundation.stiffness.y" => (&mut parameters.foundation.stiffness[0], 1e6),
        "track.foundation.stiffness.z" => (&mut parameters.foundation.stiffness[1], 1e6),
        "normal.virtual_penetration" => (&mut parameters.virtual_penetration, 0.05),
        "normal.damping" => (&mut parameters.damping, 1e4),
        "creepage.minimum_speed" => (&mut parameters.minimum_speed, 1e-4),
        _ => panic!("{name}"),
    }
}

/// Compares all of them at a pose; returns the names of those that have an effect.
fn compare(name: &str, parameters: &Parameters, input: &Input) -> Vec<&'static str> {
    compare_to(tolerance::BACKWARDS_DIFFERENCES, name, parameters, input)
}

/// The same to a `tolerance`.
pub fn compare_to(
    tolerance: f64,
    name: &str,
    parameters: &Parameters,
    input: &Input,
) -> Vec<&'static str> {
    let mut own = element(parameters);
    let about = evaluate(&mut own, input);
    assert!(about.patch_count > 0, "{name}");
    let weights = weights(&mut Random::new(5), &about);
    let mut gradient = Gradient::default();
    own.adjoint_derivative(input, &weights, &mut gradient).unwrap();
    let named = gradient.parameters.named();
    // Of those that there are: `max` leaves out what is not a number.
    let effect = |(other, slope): (&str, f64)| slope.abs() * slot(&mut parameters.clone(), other).1;
    let most = named.iter().map(|one| effect(*one)).fold(0.0, f64::max);
    let (mut effective, mut worst) = (Vec::new(), 0.0_f64);
    for (other, slope) in named {
        // A law that is off has none backwards, and only one side.
        let is_off = |law: &FrictionLaw| !law.is_on();
        let laws = [&parameters.friction_law, &parameters.gauge_face_law];
        if other.starts_with("friction.") && laws.into_iter().any(is_off) || slope.is_nan() {
            continue;
        }
        let unit = slot(&mut parameters.clone(), other).1;
        let both = difference(1e-4 * unit, |way| {
            let mut moved = parameters.clone();
            *slot(&mut moved, other).0 += way;
            sum_of(&mut element(&moved), input, &weights)
        });
        let errors = both.map(|difference| (difference - slope).abs() * unit / most);
        println!("{name} {other}: {slope:e}, off by {errors:?}");
        worst = worst.max(errors[0].min(errors[1]));
        if slope.abs() > 0.0 {
            effective.push(other);
        }
    }
    assert!(worst < tolerance, "{name}: {worst:e}");
    effective
}

/// Smooth models: without kinks where an element begins to slip.
fn smooth() -> Parameters {
    let tangential_model = TangentialModel::Tables;
    Parameters { tangential_model, ..Parameters::default() }
}

fn input_of(parameters: &Parameters) -> Input {
    pose(parameters, &mut Random::new(41))
}

#[test]
fn of_the_default_and_of_other_normal_models() {
    let all = [
        "wheel.nominal_radius",
        "wheel.young_modulus",
        "rail.young_modulus",
        "wheel.poisson_ratio",
        "rail.poisson_ratio",
        "track.gauge",
        "track.gauge_depth",
        "rail[1].inclination",
        "normal.damping",
    ];
    for normal_model in [NormalModel::Strips, NormalModel::Hertz, NormalModel::PiotrowskiKik] {
        for side in [Side::Right, Side::Left] {
            let parameters = Parameters { normal_model, ..smooth() }.on_side(side);
            let effective =
                compare(&format!("{normal_model:?}"), &parameters, &input_of(&parameters));
            assert!(all.iter().all(|name| effective.contains(name)), "{effective:?}");
            let is_virtual = effective.contains(&"normal.virtual_penetration");
            assert_eq!(is_virtual, normal_model == NormalModel::PiotrowskiKik);
        }
    }
}

#[test]
fn of_bodies_with_different_ratios_of_poisson() {
    for tangential_model in [
        TangentialModel::Linear,
        TangentialModel::Fastrip,
        TangentialModel::Tables,
        TangentialModel::Marches,
    ] {
        let parameters = Parameters { tangential_model, rail_poisson_ratio: 0.33, ..smooth() };
        let effective =
            compare(&format!("{tangential_model:?}"), &parameters, &input_of(&parameters));
        assert!(effective.contains(&"rail.poisson_ratio"), "{effective:?}");
    }
}

#[test]
fn of_rails_that_are_placed_otherwise() {
    for placement in [Placement::Position, Placement::Origin] {
        for mirrored in [false, true] {
            for side in [Side::Right, Side::Left] {
                let normal_model = NormalModel::PiotrowskiKik;
                let mut parameters = Parameters { normal_model, ..smooth() };
                parameters.rails[0].placement = placement;
                parameters.rails[0].mirrored = mirrored;
                let parameters = parameters.on_side(side);
                let name = format!("{placement:?} {mirrored} {side:?}");
                let effective = compare(&name, &parameters, &input_of(&parameters));
                assert!(effective.contains(&"rail[1].position.y"), "{effective:?}");
                assert!(!effective.contains(&"track.gauge"), "{effective:?}");
            }
        }
    }
}

#[test]
fn of_laws_of_friction_and_slow_wheels() {
    let law = FrictionLaw {
        falling_share: 0.4,
        falling_decay: 0.6,
        reduction: 0.5,
        reduction_share: 0.3,
        reduction_decay: 0.6,
        ..FrictionLaw::default()
    };
    let mut parameters = Parameters {
        friction_distribution: FrictionDistribution::Regions,
        friction_changeover: Changeover { inclination: -0.15, width: 0.6 },
        friction_law: law,
        gauge_face_law: FrictionLaw { falling_share: 0.6, ..law },
        ..smooth()
    };
    let input = input_of(&parameters);
    let effective = compare("laws", &parameters, &input);
    assert!(effective.contains(&"friction.gauge_face.reduction.decay"), "{effective:?}");
    parameters.minimum_speed = 5.0;
    let mut input = input;
    (input.wheel.velocity[0], input.wheel.pitch_rate) = (2.0, -2.02 / 0.46);
    let effective = compare("slow", &parameters, &input);
    assert!(effective.contains(&"creepage.minimum_speed"), "{effective:?}");
}

#[test]
fn of_given_loads_and_foundations() {
    let foundation = Foundation { model: FoundationModel::Massless, ..Foundation::default() };
    let normal_model = NormalModel::PiotrowskiKik;
    let parameters = Parameters { foundation, normal_model, ..smooth() };
    let input = input_of(&parameters);
    let effective = compare("foundation", &parameters, &input);
    assert!(effective.contains(&"track.foundation.stiffness.z"), "{effective:?}");
    let vertical_mode = VerticalMode::Load;
    compare("foundation, load", &Parameters { vertical_mode, ..parameters.clone() }, &input);
    let parameters = Parameters { vertical_mode, normal_model, ..smooth() };
    compare("load", &parameters, &input);
    let parameters = Parameters { motion: Motion::Rolling, normal_model, ..smooth() };
    compare("rolling", &parameters, &input);
}
