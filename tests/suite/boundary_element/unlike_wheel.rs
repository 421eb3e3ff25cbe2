//! Wheels and rails of unlike materials: pressure and tractions of all zones act on each other on the
//! arc of the rail.

use wheelrail::element::parameters::{CreepageModel, VerticalMode};
use wheelrail::element::{Parameters, Remark};
use wheelrail::math::root::bracketed;

use super::unlike::ALUMINIUM;
use super::*;
use crate::common::wheel::{element, evaluate, pressed, rail_marker, reversed, rolling};

const SPEED: f64 = 20.0;

/// Boundary elements for both models, with a wheel and rails of these materials.
fn parameters([wheel, rail]: [Material; 2], elements: usize) -> Parameters {
    let mut parameters = Parameters {
        normal_model: NormalModel::BoundaryElement,
        tangential_model: TangentialModel::BoundaryElement,
        creepage_model: CreepageModel::Flat,
        normal_elements: [elements; 2],
        damping: 0.0,
        rail_young_modulus: rail.young_modulus,
        rail_poisson_ratio: rail.poisson_ratio,
        ..Parameters::default()
    };
    parameters.wheel.young_modulus = wheel.young_modulus;
    parameters.wheel.poisson_ratio = wheel.poisson_ratio;
    parameters
}

/// The same for a cone on a head of one radius, where a contact lies in one plane.
fn on_a_plane(materials: [Material; 2]) -> Parameters {
    let mut parameters = parameters(materials, 24);
    parameters.wheel.profile = "conical:0.025".into();
    parameters.rails[0].profile = "arc:0.3".into();
    parameters
}

/// A wheel that rolls with a longitudinal creepage by its pitch and a lateral speed [m/s], 0.12 mm
/// deep.
fn state(element: &mut Element, shift: f64, creepage: f64, lateral: f64) -> Input {
    let mut input = rolling(shift, SPEED);
    input.wheel.pitch_rate *= 1.0 + creepage;
    input.wheel.velocity[1] = lateral;
    pressed(element, &input, 1.2e-4)
}

/// Power that wheel and rail lose in the contact [W].
fn lost(input: &Input, output: &Output) -> f64 {
    let (wheel, forces) = (&input.wheel, &output.wheel);
    let [vx, vy, _] = wheel.velocity;
    -(forces.force[0] * vx + forces.force[1] * vy + forces.moment[1] * wheel.pitch_rate)
}

fn solved(element: &mut Element, input: &Input) -> Output {
    let output = evaluate(element, input);
    assert_eq!(output.fallback_count, 0, "{output:?}");
    assert!(output.normal_residual <= tolerance::BOUNDARY_UNLIKE_GAP, "{output:?}");
    output
}

#[test]
fn an_element_and_the_planar_problem_of_its_contact_agree_as_with_like_materials() {
    let missed = |materials: [Material; 2]| {
        let states = [(0.0, 0.0, 0.0), (0.0, -1e-3, 0.02), (3e-3, 4e-3, -0.02)];
        states.map(|(shift, creepage, lateral)| {
            let parameters = on_a_plane(materials);
            let mut element = element(&parameters);
            let input = state(&mut element, shift, creepage, lateral);
            let output = solved(&mut element, &input);
            let patch = output.patches[0];
            let flat = element.flat_contacts(&input).unwrap();
            // The element has creepage on the wheel's surface, deeper than where bodies first touch.
            let creepage = patch.creepage;
            let case = PlanarCase { creepage, ..parameters.flat_case(&flat[0], SPEED).unwrap() };
            let planar = solve(&case).unwrap();
            assert!(!planar.fallback && flat.len() == 1 && output.patch_count == 1);
            let [x, y] = patch.creep_force;
            let limit = 0.3 * patch.normal_force;
            (x - planar.fx).hypot(y - planar.fy) / limit
        })
    };
    let like = missed([STEEL, STEEL]);
    for materials in [[ALUMINIUM, STEEL], [STEEL, ALUMINIUM]] {
        for (unlike, like) in missed(materials).into_iter().zip(like) {
            assert!(unlike <= like + tolerance::UNLIKE_FRAMES, "{unlike} {like}");
        }
    }
}

#[test]
fn a_soft_wheel_rolls_freely_with_creepage_and_a_soft_rail_with_the_opposite() {
    for materials in [[ALUMINIUM, STEEL], [STEEL, ALUMINIUM]] {
        let pair = MaterialPair::new(materials[0], materials[1]);
        let mut element = element(&on_a_plane(materials));
        let mut at = |creepage: f64| {
            let input = state(&mut element, 0.0, creepage, 0.0);
            solved(&mut element, &input).patches[0].creep_force[0]
        };
        let free = bracketed((-4e-3, at(-4e-3)), (4e-3, at(4e-3)), 1e-6, &mut at);
        let input = state(&mut element, 0.0, free, 0.0);
        let patch = solved(&mut element, &input).patches[0];
        let shift = -patch.creepage[0] / (pair.coupling * 0.5 * patch.length / 0.46);
        assert!((0.5..1.4).contains(&shift), "{free} {shift}");
    }
}

#[test]
fn the_wheel_gives_the_power_that_friction_loses() {
    for materials in [[STEEL, STEEL], [ALUMINIUM, STEEL], [STEEL, ALUMINIUM]] {
        for creepage in [-1e-3, 0.0, 1e-3, 4e-3] {
            let mut element = element(&Parameters {
                creepage_model: CreepageModel::Curved,
                ..parameters(materials, 24)
            });
            let input = state(&mut element, 0.0, creepage, 0.0);
            let output = solved(&mut element, &input);
            let limit = 0.3 * output.patches[0].normal_force * SPEED;
            let found = [lost(&input, &output), output.frictional_power].map(|p| p / limit);
            assert!((found[0] - found[1]).abs() <= tolerance::UNLIKE_POWER, "{found:?}");
        }
    }
}

#[test]
fn what_unlike_materials_do_vanishes_with_their_difference() {
    // The same pair of constants but for the sign of K.
    let force = |k: f64, sign: f64| {
        let softer = |share: f64| Material { young_modulus: STEEL.young_modulus * share, ..STEEL };
        let mut materials = [softer(1.0 - k), softer(1.0 + k)];
        if sign < 0.0 {
            materials.reverse();
        }
        let coupling = MaterialPair::new(materials[0], materials[1]).coupling;
        let mut element = element(&parameters(materials, 24));
        let input = state(&mut element, 0.0, -1e-3, 0.01);
        let patch = solved(&mut element, &input).patches[0];
        (
            coupling,
            [patch.creep_force[0], patch.creep_force[1]].map(|f| f / (0.3 * patch.normal_force)),
        )
    };
    let step = |k: f64| {
        let [(coupling, more), (_, less)] = [1.0, -1.0].map(|sign| force(k, sign));
        (coupling, [0, 1].map(|c| (more[c] - less[c]) / (2.0 * coupling)))
    };
    let all = [0.0095, 0.02, 0.08].map(step);
    assert!(all[0].0 > MaterialPair::<f64>::UNLIKE && all[0].0 < 1.1 * MaterialPair::<f64>::UNLIKE);
    let slope = all[2].1;
    for (coupling, found) in &all[..2] {
        for (found, slope) in found.iter().zip(slope) {
            assert!((found - slope).abs() * coupling <= tolerance::UNLIKE_NEARLY, "{all:?}");
        }
    }
}

#[test]
fn without_friction_unlike_bodies_press_as_like_ones_do() {
    let parameters = parameters([ALUMINIUM, STEEL], 20);
    let alone = Parameters { tangential_model: TangentialModel::None, ..parameters.clone() };
    let mut apart = element(&alone);
    let mut input = state(&mut apart, 0.0, 1e-3, 0.0);
    input.friction = 0.0;
    let expected = evaluate(&mut apart, &input);
    let found = evaluate(&mut element(&parameters), &input);
    for c in 0..3 {
        let missed = (found.wheel.force[c] - expected.wheel.force[c]).abs();
        assert!(missed <= 1e-7 * expected.patches[0].normal_force, "{missed}");
    }
}

#[test]
fn running_backwards_is_the_mirror_image() {
    let parameters = parameters([ALUMINIUM, STEEL], 20);
    let mut element = element(&parameters);
    let input = state(&mut element, 0.0, -5e-4, 0.01);
    let forward = solved(&mut element, &input);
    let backward = solved(&mut element, &reversed(&input));
    let limit = 0.3 * forward.patches[0].normal_force;
    for (c, sign) in [-1.0, 1.0, 1.0].into_iter().enumerate() {
        let missed = (backward.wheel.force[c] - sign * forward.wheel.force[c]).abs();
        assert!(missed <= tolerance::BOUNDARY_BACKWARDS * limit, "{c}: {missed}");
    }
}

#[test]
fn a_given_load_is_carried_by_two_zones_of_another_material() {
    // Two stretches of overlap, 11 mm apart.
    let parameters =
        Parameters { creepage_model: CreepageModel::Curved, ..parameters([ALUMINIUM, STEEL], 16) };
    let mut input = rolling(0.0, SPEED);
    let wheel = &mut input.wheel;
    (wheel.position[1], wheel.position[2]) = (0.755_970_750_4, -0.460_166_125_9);
    (wheel.roll, wheel.yaw) = (1.784_547e-3, -2.800_297e-3);
    let there = solved(&mut element(&parameters), &input);
    assert_eq!(there.patch_count, 2, "{there:?}");
    let given = Parameters { vertical_mode: VerticalMode::Load, ..parameters };
    input.wheel_load = there.load_carried;
    let output = solved(&mut element(&given), &input);
    assert_eq!(output.patch_count, 2, "{output:?}");
    assert!((output.load_carried / input.wheel_load - 1.0).abs() < 1e-6, "{output:?}");
    let limit = 0.3 * there.load_carried;
    for c in 0..3 {
        let missed = (output.wheel.force[c] - there.wheel.force[c]).abs();
        assert!(missed <= 1e-4 * limit, "{missed} {output:?}");
    }
}

#[test]
fn two_rails_in_one_place_carry_half_of_the_load_each() {
    let mut parameters =
        Parameters { vertical_mode: VerticalMode::Load, ..parameters([STEEL, ALUMINIUM], 16) };
    let [_, y, z] = rail_marker(&parameters);
    parameters.rails[1].enabled = true;
    parameters.rails[1].position = [y, z];
    parameters.rails[1].mirrored = false;
    let mut input = rolling(0.0, SPEED);
    input.wheel_load = 6e4;
    let output = solved(&mut element(&parameters), &input);
    assert_eq!(output.patch_count, 2, "{output:?}");
    for c in 0..3 {
        let [first, second] = [0, 1].map(|k| output.rails[k].force[c]);
        assert!((first - second).abs() <= 1e-3 * 0.3 * 3e4, "{output:?}");
    }
    assert!((output.load_carried / 6e4 - 1.0).abs() < 1e-6, "{output:?}");
}

/// What is told of unlike materials after an evaluation at a slip, friction and load, and whether it
/// says that the solver did not settle.
fn told(
    parameters: &Parameters,
    [slip, friction, load]: [f64; 3],
) -> (Vec<(bool, String)>, Output) {
    let parameters = Parameters { vertical_mode: VerticalMode::Load, ..parameters.clone() };
    let mut element = element(&parameters);
    let mut input = rolling(0.0, SPEED);
    input.wheel.pitch_rate *= 1.0 + slip;
    (input.friction, input.wheel_load) = (friction, load);
    let output = evaluate(&mut element, &input);
    let mut told = Vec::new();
    wheelrail::element::remarks(&element, &parameters, &input, &output, |_, remark| {
        if let Remark::UnlikeMaterials { did_not_settle, .. } = remark {
            told.push((did_not_settle, remark.message("").to_string()));
        }
    });
    (told, output)
}

#[test]
fn it_is_told_where_unlike_materials_are_left_out_and_only_there() {
    let both = parameters([ALUMINIUM, STEEL], 16);
    let (found, output) = told(&both, [1e-3, 0.3, 6e4]);
    assert!(found.is_empty() && output.fallback_count == 0, "{found:?}");
    let one = Parameters { tangential_model: TangentialModel::Fastsim, ..both.clone() };
    let (found, _) = told(&one, [1e-3, 0.3, 6e4]);
    assert!(matches!(&found[..], [(false, _)]), "{found:?}");
}

#[test]
fn turns_that_do_not_settle_leave_the_result_of_bodies_apart() {
    // Friction of 2 on a wheel of rubber: K = 0.5.
    let rubber = Material { young_modulus: 1e9, poisson_ratio: 0.0 };
    let [wheel, rail] = [[rubber, STEEL], [STEEL, rubber]].map(|materials| {
        let (found, output) = told(&parameters(materials, 16), [-1e-2, 2.0, 2e4]);
        let [(true, message)] = &found[..] else { panic!("{found:?} {output:?}") };
        assert!(message.contains("did not settle"), "{message}");
        assert_eq!(output.fallback_count, 1, "{output:?}");
        output.wheel.force
    });
    // Apart, it does not matter which of them is soft.
    for c in 0..3 {
        assert!((wheel[c] - rail[c]).abs() <= 1e-6 * 2e4, "{wheel:?} {rail:?}");
    }
    assert!(wheel[0].abs() > 1e3, "{wheel:?}");
}
