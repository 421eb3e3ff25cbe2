//! Steps of one wheel beside steady rolling, planar problems and given loads.

use super::*;
use crate::common::wheel::{evaluate, plain_parameters, rail_marker};
use wheelrail::element::parameters::{CreepageModel, Side, VerticalMode};
use wheelrail::planar::{Indentation, StepMotion, TransientContact};
use wheelrail::wheelset::{self, Wheelset};

/// Poses: rail, lateral shift [m], yaw [rad], share by which the pitch rate is too fast, share of the
/// yaw that a lateral velocity takes up; on the tread, near the gauge corner, in two zones.
const POSES: [(&str, f64, f64, f64, f64); 3] = [
    ("60E1", 0.0, 2e-3, 1e-3, 0.0),
    ("60E1", 6.3e-3, -5e-3, -5e-4, 0.0),
    ("54E1", 5e-3, 0.02, 0.0, 0.95),
];

#[test]
fn what_many_steps_lead_to_and_one_of_a_metre_is_steady_rolling() {
    for (rail, shift, yaw, faster, taken) in POSES {
        let mut parameters = boundary(14);
        parameters.rails[0].profile = rail.into();
        let mut input = rolling(&parameters, shift, yaw, 1e-4, faster);
        input.wheel.velocity[1] = 20.0 * taken * yaw;
        let steady = evaluate(&mut element(&parameters), &input);
        let mut wheel = fresh(&transient(&parameters));
        let long = advance(&mut wheel, &input, 0.05);
        let at_once = difference(&long, &steady);
        wheel = fresh(&transient(&parameters));
        // 3 mm each.
        let start = difference(&advance(&mut wheel, &input, 1.5e-4), &steady);
        let mut last = Output::default();
        for _ in 0..60 {
            last = advance(&mut wheel, &input, 1.5e-4);
        }
        let [end, power] =
            [difference(&last, &steady), last.frictional_power / steady.frictional_power - 1.0];
        println!(
            "{rail} {shift}: {start:.3} {end:.1e} {at_once:.1e}, power {power:.1e}, {} zones",
            last.patch_count
        );
        assert_eq!((last.patch_count, last.fallback_count), (steady.patch_count, 0));
        assert!(start > 0.05, "{start}");
        assert!(end <= 1e-4 && at_once <= 1e-4, "{rail} {shift}: {end:e}, {at_once:e}");
        assert!(power.abs() <= 0.04, "{power:e}");
    }
}

#[test]
fn a_new_element_rolls_steadily_to_the_bit_until_inputs_change() {
    let parameters = boundary(12);
    let input = rolling(&parameters, 2e-3, 3e-3, 1e-4, 1e-3);
    let steady = evaluate(&mut element(&parameters), &input);
    let mut wheel = element(&transient(&parameters));
    assert_eq!(bits(&evaluate(&mut wheel, &input)), bits(&steady));
    assert!(!wheel.contact_history().unwrap().has_begun());
    assert_eq!(bits(&advance(&mut wheel, &input, 1e-4)), bits(&steady));
    assert!(wheel.contact_history().unwrap().has_begun());
    for _ in 0..5 {
        let off = difference(&advance(&mut wheel, &input, 1e-4), &steady);
        assert!(off <= 1e-4, "{off:e}");
    }
    // Bodies that are put on each other begin without tractions.
    let mut standing = input;
    (standing.wheel.velocity[0], standing.wheel.pitch_rate) = (0.0, 0.0);
    let mut wheel = element(&transient(&parameters));
    let output = advance(&mut wheel, &standing, 1e-3);
    let [x, y] = output.patches[0].creep_force;
    assert!(x.hypot(y) <= 0.0 && output.patches[0].normal_force > 1e4, "{x} {y}");
    let off = difference(&advance(&mut wheel, &input, 1e-5), &steady);
    assert!(off > 0.1, "{off}");
}

#[test]
fn an_evaluation_after_a_step_gives_its_forces_to_the_bit_and_changes_nothing() {
    let parameters = transient(&boundary(12));
    let mut wheel = element(&parameters);
    let mut input = rolling(&parameters, 0.0, 2e-3, 1e-4, 0.0);
    advance(&mut wheel, &input, 1e-4);
    for (yaw, deeper, duration) in [(4e-3, 1e-5, 1e-4), (-3e-3, -2e-5, 3e-5), (1e-3, 0.0, 1e-3)] {
        input.wheel.yaw = yaw;
        input.wheel.position[2] += deeper;
        let stepped = advance(&mut wheel, &input, duration);
        assert!(stepped.frictional_power > 0.0);
        let history = wheel.contact_history().unwrap().clone();
        let again = evaluate(&mut wheel, &input);
        assert_eq!(again.wheel.force.map(f64::to_bits), stepped.wheel.force.map(f64::to_bits));
        assert_eq!(again.wheel.moment.map(f64::to_bits), stepped.wheel.moment.map(f64::to_bits));
        assert_eq!(again.patches[0].slip_share.to_bits(), stepped.patches[0].slip_share.to_bits());
        // Nothing slips in no time.
        assert_eq!(again.frictional_power.to_bits(), 0);
        // Where nothing is displaced a smaller load is what tractions make room for.
        let mut lifted = input;
        lifted.wheel.position[2] -= 4e-5;
        let light = evaluate(&mut wheel, &lifted);
        assert!(light.patches[0].normal_force < 0.7 * stepped.patches[0].normal_force);
        assert_eq!(*wheel.contact_history().unwrap(), history);
    }
}

/// One contact of a wheel without damping beside the planar problem of its pressure.
#[test]
fn a_wheel_from_rest_follows_the_planar_contact() {
    let parameters = Parameters {
        creepage_model: CreepageModel::Flat,
        damping: 0.0,
        normal_model: boundary(20).normal_model,
        tangential_model: boundary(20).tangential_model,
        normal_elements: [20; 2],
        ..plain_parameters("conical:0.05", "arc:0.3")
    };
    for (yaw, faster, step) in [(1.5e-3, 0.0, 5e-5), (5e-4, 1.5e-3, 2e-5), (0.0, 0.0, 1e-4)] {
        let input = rolling(&parameters, -2e-3, yaw, 1e-4, faster);
        let mut wheel = fresh(&transient(&parameters));
        let flat = wheel.flat_contacts(&input).unwrap();
        let [contact] = &flat[..] else { panic!("{} contacts", flat.len()) };
        let mut planar = TransientContact::new();
        let mut worst = 0.0_f64;
        for _ in 0..20 {
            let patch = advance(&mut wheel, &input, step).patches[0];
            let case = parameters.flat_case(contact, 20.0).unwrap();
            let case = wheelrail::planar::PlanarCase {
                indentation: Indentation::Load(patch.normal_force),
                // At the depth of the wheel's surface, which is the penetration below first touch.
                creepage: patch.creepage,
                ..case
            };
            let motion = StepMotion { rolled: 20.0 * step, ..StepMotion::default() };
            let found = planar.step(&case, &motion).unwrap().contact;
            let limit = patch.friction_coefficient * patch.normal_force;
            let [fx, fy] = patch.creep_force;
            worst = worst.max((fx - found.fx).hypot(fy - found.fy) / limit);
        }
        println!("{yaw} {faster}: {worst:.4}");
        assert!(worst <= 0.003, "{yaw} {faster}: {worst}");
    }
}

/// Loads and speeds that change from step to step.
fn changing(input: &Input, i: u32) -> Input {
    let mut moved = *input;
    let phase = 0.5 * f64::from(i);
    moved.wheel_load = 8e4 * (1.0 + 0.4 * phase.sin());
    moved.wheel.yaw = 4e-3 * (0.7 * phase).cos();
    moved.wheel.position[1] += 2e-3 * phase.sin();
    moved
}

#[test]
fn given_loads_are_carried_and_the_history_goes_on_once() {
    let parameters = transient(&boundary(12));
    let loaded = Parameters { vertical_mode: VerticalMode::Load, ..parameters.clone() };
    let input = rolling(&parameters, 0.0, 2e-3, 1e-4, 5e-4);
    let (mut wheel, mut at_height) = (element(&loaded), element(&parameters));
    for i in 0..12 {
        let mut input = changing(&input, i);
        let duration = [1e-4, 0.0, 1e-3][i as usize % 3];
        let output = advance(&mut wheel, &input, duration);
        let missed = output.load_carried / input.wheel_load - 1.0;
        assert!(missed.abs() <= 1e-6, "{missed:e}");
        assert_eq!(output.fallback_count, 0);
        // The same steps at the heights found.
        input.wheel.position[2] = output.wheel_z;
        let beside = advance(&mut at_height, &input, duration);
        let off = difference(&beside, &output);
        // Elements of the first contact are those of a search or of one evaluation.
        assert!(off <= 1e-6, "step {i}: {off:e}");
        // An evaluation carries the same load, with next to the same forces.
        let again = difference(&evaluate(&mut wheel, &input), &output);
        assert!(again <= 1e-6, "step {i}: {again:e}");
    }
}

#[test]
fn a_contact_that_grows_a_hundredfold_has_elements_that_grow_with_it() {
    let steady = Parameters { vertical_mode: VerticalMode::Load, ..boundary(12) };
    let mut wheel = element(&transient(&steady));
    let mut input = rolling(&steady, 0.0, 2e-3, 1e-4, 5e-4);
    for load in [1.0, 1e2, 1e4, 1e5, 1e3, 10.0, 1e5] {
        input.wheel_load = load;
        advance(&mut wheel, &input, 1e-5);
        let output = advance(&mut wheel, &input, 0.1);
        let steady = evaluate(&mut element(&steady), &input);
        // On elements of other sizes.
        let off = difference(&output, &steady);
        println!("{load}: {off:.1e}");
        assert!(off <= 0.01, "{load}: {off}");
        let numbers = wheel.contact_history().unwrap().to_numbers();
        assert!(numbers.len() < 2 * 4 * 24 * 24, "{load}: {}", numbers.len());
    }
}

/// A contact that shrinks to a tenth of its length in a short step feels what acted on all of it.
#[test]
fn a_contact_that_shrinks_at_once_takes_along_what_there_was() {
    let found = [10, 20, 36].map(|elements| {
        let parameters = transient(&Parameters { damping: 0.0, ..boundary(elements) });
        let mut wheel = fresh(&parameters);
        let deep = rolling(&parameters, 0.0, 2e-3, 1e-4, 5e-4);
        // Some of it sticks.
        advance(&mut wheel, &deep, 1e-4);
        let light = rolling(&parameters, 0.0, 2e-3, 1e-6, 5e-4);
        let output = advance(&mut wheel, &light, 1e-6);
        let patch = output.patches[0];
        assert!(patch.length < 2.5e-3, "{}", patch.length);
        let limit = patch.friction_coefficient * patch.normal_force;
        let again = evaluate(&mut wheel, &light);
        assert_eq!(again.wheel.force.map(f64::to_bits), output.wheel.force.map(f64::to_bits));
        let [x, y] = patch.creep_force;
        [x / limit, y / limit, patch.slip_share]
    });
    println!("{found:?}");
    let [coarse, _, fine] = found;
    assert!((coarse[0] - fine[0]).hypot(coarse[1] - fine[1]) <= 2e-3, "{found:?}");
}

#[test]
fn a_second_rail_and_the_left_side_have_histories_of_their_own() {
    let mut parameters = boundary(12);
    // A tongue in the place of the rail, a little lower.
    let [_, y, z] = rail_marker(&parameters);
    parameters.rails[1].enabled = true;
    parameters.rails[1].mirrored = false;
    parameters.rails[1].position = [y, z + 1e-4];
    let steady = parameters.clone();
    let parameters = transient(&parameters);
    let mut wheel = element(&parameters);
    let mut input = rolling(&parameters, 0.0, 3e-3, 1e-4, 5e-4);
    let mut left_input = crate::common::wheel::mirrored(&input);
    let mut left = element(&parameters.on_side(Side::Left));
    let mut rails = [false; 2];
    for i in 0..12 {
        input.wheel.yaw = 4e-3 * (0.9 * f64::from(i)).sin();
        input.wheel.position[2] += if i == 4 { 1e-4 } else { 0.0 };
        left_input.wheel.yaw = -input.wheel.yaw;
        left_input.wheel.position[2] = input.wheel.position[2];
        let output = advance(&mut wheel, &input, 1e-4);
        output.patches().for_each(|patch| rails[patch.rail as usize - 1] = true);
        let mirrored = advance(&mut left, &left_input, 1e-4);
        for (axis, sign) in [1.0, -1.0, 1.0].into_iter().enumerate() {
            let [a, b] = [output.wheel.force[axis], sign * mirrored.wheel.force[axis]];
            assert!((a - b).abs() <= 1e-9 * limit(&output), "{i} {axis}: {a} {b}");
        }
    }
    println!("{rails:?}");
    let found = advance(&mut wheel, &input, 0.1);
    let off = difference(&found, &evaluate(&mut element(&steady), &input));
    assert!(off <= 0.01, "{off}");
    assert_eq!(rails, [true; 2]);
}

#[test]
fn wheels_of_a_wheelset_under_load_remember_each_its_own() {
    let mut parameters = wheelset::Parameters::default();
    for side in &mut parameters.sides {
        *side = Parameters {
            vertical_mode: VerticalMode::Load,
            side: side.side,
            ..transient(&boundary(10)).on_side(side.side)
        };
    }
    let mut input = wheelset::Input::default();
    input.wheelset.velocity[0] = 20.0;
    input.wheelset.pitch_rate = -20.0 / 0.46;
    for side in &mut input.sides {
        side.wheel_load = 6e4;
    }
    let mut set = Wheelset::new(&parameters, &input, &[]).unwrap();
    let mut output = wheelset::Output::default();
    for i in 0..6 {
        input.wheelset.position[1] = 2e-3 * (0.8 * f64::from(i)).sin();
        input.wheelset.yaw = 2e-3 * (0.8 * f64::from(i)).cos();
        set.advance(&input, &mut output, 2e-4).unwrap();
        for side in &output.sides {
            assert!((side.load_carried / 6e4 - 1.0).abs() <= 1e-6, "{}", side.load_carried);
        }
    }
    let histories = set.elements().each_ref().map(|e| e.contact_history().unwrap().clone());
    let refused = set.advance(&input, &mut output, -1.0).unwrap_err().to_string();
    assert!(refused.contains("duration = -1"), "{refused}");
    assert!(set.elements().iter().zip(&histories).all(|(e, h)| e.contact_history() == Some(h)));
}

#[test]
fn derivatives_and_slopes_are_refused_by_name() {
    let parameters = transient(&boundary(8));
    let mut wheel = element(&parameters);
    let input = rolling(&parameters, 0.0, 0.0, 1e-4, 0.0);
    let refused = wheel.contact_slopes(&input, 0.75).unwrap_err().to_string();
    assert!(refused.contains("tangential.history = transient"), "{refused}");
    let mut rates = Output::default();
    assert!(wheel.directional_derivative(&input, &Input::at_rest(), &mut rates).is_err());
    assert!(element(&boundary(8)).contact_slopes(&input, 0.75).is_ok());
    assert!(!element(&boundary(8)).set_contact_history(&ContactHistory::default()));
}
