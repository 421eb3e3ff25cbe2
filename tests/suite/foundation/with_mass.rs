//! Rails with a mass, which run along with the wheel.

use crate::common::wheel::{element, evaluate, mirrored, rolling};
use crate::tolerance;
use wheelrail::element::parameters::{
    Foundation, FoundationModel, NormalModel, Side, TangentialModel,
};
use wheelrail::element::{Element, Input, Output, Parameters, TrackState};

/// Stiffness, damping and mass of a soft track, so that all of its motions are in the range of
/// milliseconds.
fn with_mass() -> Foundation {
    Foundation { model: FoundationModel::Mass, ..Foundation::default() }
}

/// Contacts that only push: what they take and give back is stored.
fn elastic(foundation: Foundation) -> Parameters {
    Parameters {
        foundation,
        damping: 0.0,
        normal_model: NormalModel::Hertz,
        tangential_model: TangentialModel::None,
        ..Parameters::default()
    }
}

/// A wheel whose height swings about one at which it presses, at `time`; with the velocity that
/// belongs to it.
fn swinging(element: &mut Element, time: f64) -> Input {
    let mut input = rolling(1e-3, 20.0);
    // 120 Hz.
    let (amplitude, rate) = (2e-5, 750.0);
    let middle = element.touching_height(&input) + 1.3e-3;
    input.wheel.position[2] = middle + amplitude * (rate * time).sin();
    input.wheel.velocity[2] = amplitude * rate * (rate * time).cos();
    input
}

/// Kinetic energy of the rails and what the springs of the foundation hold [J].
fn energy(element: &Element, foundation: &Foundation) -> f64 {
    let state = element.track_state().unwrap_or_default();
    let kinetic: f64 = state.velocity.iter().map(|v| 0.5 * foundation.mass * v * v).sum();
    let springs = foundation.stiffness.iter().zip(state.deflection);
    kinetic + springs.map(|(k, d)| 0.5 * k * d * d).sum::<f64>()
}

/// What the contact holds between its present approach and none, by pulling the wheel straight up
/// from rails that stay [J].
fn stored(element: &mut Element, input: &Input) -> f64 {
    let mut rigid = element.clone();
    let state = element.track_state().unwrap();
    let mut at = *input;
    for rail in &mut at.rails {
        (rail.y, rail.z) = (state.deflection[0], state.deflection[1]);
    }
    rigid.set_track_state(Some(TrackState::default()));
    let touching = rigid.touching_height(&at);
    let depth = (at.wheel.position[2] - touching).max(0.0);
    // Force ~ depth^(3/2): even in its square root.
    let parts = 200;
    let mut sum = 0.0;
    for i in 0..=parts {
        let u = f64::from(i) / f64::from(parts);
        at.wheel.position[2] = touching + depth * u * u;
        let weight = if i == 0 || i == parts {
            1.0
        } else if i % 2 == 1 {
            4.0
        } else {
            2.0
        };
        sum -= weight * evaluate(&mut rigid, &at).wheel.force[2] * 2.0 * depth * u;
    }
    sum / f64::from(3 * parts)
}

/// What is missing from the energy of rails and contact over 10 ms in steps of `h`, as a share of
/// the work of the wheel to and fro; the estimated errors of all steps together; and the deflection
/// at the end.
fn balance(foundation: Foundation, h: f64) -> (f64, f64, [f64; 2]) {
    let mut element = element(&elastic(foundation));
    let mut input = swinging(&mut element, 0.0);
    element.move_rails(&input, &input, 0.0).unwrap();
    let before = energy(&element, &foundation) + stored(&mut element, &input);
    let (mut done, mut lost, mut moved, mut errors) = (0.0, 0.0, 0.0, 0.0);
    let mut force = evaluate(&mut element, &input).wheel.force[2];
    let mut velocity = element.track_state().unwrap().velocity;
    let steps = (1e-2 / h).round() as u32;
    for step in 1..=steps {
        let next = swinging(&mut element, h * f64::from(step));
        element.move_rails(&input, &next, h).unwrap();
        let state = element.track_state().unwrap();
        errors += state.step_error;
        let next_force = evaluate(&mut element, &next).wheel.force[2];
        // Work of the wheel on the contact, and of the dampers, by Simpson's and the trapezoidal
        // rule.
        let way = next.wheel.position[2] - input.wheel.position[2];
        let work = -0.5 * (force + next_force) * way;
        (done, moved) = (done + work, moved + work.abs());
        for velocity in [velocity, state.velocity] {
            let taken = foundation.damping.iter().zip(velocity);
            lost += 0.5 * h * taken.map(|(c, v)| c * v * v).sum::<f64>();
        }
        (input, force, velocity) = (next, next_force, state.velocity);
    }
    let after = energy(&element, &foundation) + stored(&mut element, &input);
    ((before + done - lost - after) / moved, errors, element.track_state().unwrap().deflection)
}

#[test]
fn energy_is_kept_but_for_what_dampers_take_and_motion_is_of_second_order() {
    for damping in [[5e4, 1e5], [0.0, 0.0]] {
        let foundation = Foundation { damping, ..with_mass() };
        // The longest step of the units and shorter ones.
        let found = [1e-4, 5e-5, 2.5e-5].map(|h| balance(foundation, h));
        let [far, near] = [0, 1].map(|k| {
            let [a, b] = [found[k].2, found[k + 1].2];
            (a[0] - b[0]).hypot(a[1] - b[1])
        });
        println!("{damping:?}: {found:?}, {}", far / near);
        assert!((far / near - 4.0).abs() < 0.5, "{}", far / near);
        for (missing, ..) in found {
            assert!(missing.abs() < tolerance::TRACK_ENERGY, "{missing:e}");
        }
        // What the errors of all steps come to is estimated as more than it is.
        assert!(found[0].1 > far, "{:e} {far:e}", found[0].1);
    }
}

#[test]
fn rails_at_rest_stay_where_rails_without_mass_are() {
    for damping in [0.0, 1e5] {
        let foundation = with_mass();
        let massless = Foundation { model: FoundationModel::Massless, ..foundation };
        let [mut moving, mut resting] = [foundation, massless].map(|foundation| {
            element(&Parameters { foundation, damping, ..Parameters::default() })
        });
        let mut input = rolling(-2e-3, 20.0);
        input.wheel.yaw = 2e-3;
        input.wheel.position[2] = moving.touching_height(&input) + 1.2e-3;
        let expected = evaluate(&mut resting, &input);
        assert!(expected.foundation.deflection[0].abs() > 1e-5);
        // Before the first step they rest; then they do not move.
        assert_eq!(evaluate(&mut moving, &input), expected);
        for duration in [1e-5, 1e-3, 0.1] {
            moving.move_rails(&input, &input, duration).unwrap();
            let found = evaluate(&mut moving, &input);
            for i in 0..2 {
                let way = found.foundation.deflection[i] - expected.foundation.deflection[i];
                assert!(way.abs() < tolerance::RAIL_PLACE, "{way:e}");
            }
            assert!(found.foundation.step_error < tolerance::RAIL_PLACE);
        }
    }
}

#[test]
fn a_wheel_that_moves_evenly_is_followed_in_steps_of_any_length() {
    // Stiff pads without damping under a stiff contact.
    let stiff = Foundation { stiffness: [1e9, 3e9], damping: [0.0; 2], mass: 30.0, ..with_mass() };
    for foundation in [with_mass(), stiff] {
        let normal_model = NormalModel::Hertz;
        let parameters = Parameters { foundation, normal_model, ..Parameters::default() };
        let massless = Foundation { model: FoundationModel::Massless, ..foundation };
        for h in [1e-4_f64, 1e-3, 1e-2] {
            let mut moving = element(&parameters);
            let start = rolling(0.0, 20.0);
            let touching = moving.touching_height(&start);
            let at = |time: f64| {
                let mut input = start;
                // The load goes up and down once in 0.2 s.
                input.wheel.position[2] = touching + 6e-4 - 2e-4 * (31.4 * time).cos();
                input.wheel.velocity[2] = 2e-4 * 31.4 * (31.4 * time).sin();
                input
            };
            let steps = (0.2 / h).round() as u32;
            for step in 0..steps {
                let [from, to] = [step, step + 1].map(|step| at(h * f64::from(step)));
                moving.move_rails(&from, &to, h).unwrap();
            }
            // Slow as this is, they are where they would rest, damping apart.
            let mut end = at(0.2);
            end.wheel.velocity[2] = 0.0;
            let found = moving.track_state().unwrap().deflection;
            let mut resting = element(&Parameters { foundation: massless, ..parameters.clone() });
            let expected = evaluate(&mut resting, &end).foundation.deflection;
            let off = (found[0] - expected[0]).hypot(found[1] - expected[1]);
            println!("{h}: {off:e} of {expected:?}");
            assert!(off < 0.02 * expected[0].hypot(expected[1]), "{off:e} {expected:?}");
        }
    }
}

#[test]
fn a_step_can_be_taken_back_and_its_mirror_image_is_that_of_a_left_wheel() {
    let parameters = Parameters { foundation: with_mass(), ..Parameters::default() };
    let mut right = element(&parameters);
    let mut left = element(&Parameters { side: Side::Left, ..parameters });
    let [a, b] = [0.0, 2e-3].map(|time| swinging(&mut right, time));
    right.move_rails(&a, &b, 1e-3).unwrap();
    left.move_rails(&mirrored(&a), &mirrored(&b), 1e-3).unwrap();
    let state = right.track_state();
    right.move_rails(&b, &a, 1e-3).unwrap();
    let once = evaluate(&mut right, &a);
    right.set_track_state(state);
    right.move_rails(&b, &a, 1e-3).unwrap();
    assert_eq!(evaluate(&mut right, &a), once);
    left.move_rails(&mirrored(&b), &mirrored(&a), 1e-3).unwrap();
    let image = evaluate(&mut left, &mirrored(&a));
    let [y, z] = once.foundation.deflection;
    assert_eq!(image.foundation.deflection.map(f64::to_bits), [-y, z].map(f64::to_bits));
    assert_eq!(image.wheel.force[2].to_bits(), once.wheel.force[2].to_bits());
}

#[test]
fn derivatives_are_those_on_rails_that_stay() {
    let foundation = with_mass();
    let parameters = Parameters {
        normal_model: NormalModel::Hertz,
        tangential_model: TangentialModel::Tables,
        foundation,
        ..Parameters::default()
    };
    let mut moving = element(&parameters);
    let [a, b] = [0.0, 1e-3].map(|time| swinging(&mut moving, time));
    moving.move_rails(&a, &b, 1e-3).unwrap();
    let mut direction = Input::at_rest();
    (direction.wheel.position[2], direction.rails[0].vy) = (1.0, 0.3);
    let mut rates = Output::default();
    moving.directional_derivative(&b, &direction, &mut rates).unwrap();
    let step = 1e-7;
    let [low, high] = [-step, step].map(|h| {
        let mut input = b;
        input.wheel.position[2] += h;
        input.rails[0].vy += 0.3 * h;
        evaluate(&mut moving, &input).wheel.force
    });
    for i in 0..3 {
        let slope = (high[i] - low[i]) / (2.0 * step);
        let off = (slope - rates.wheel.force[i]).abs() / rates.wheel.force[2].abs();
        assert!(off < tolerance::DERIVATIVES, "{slope} {}", rates.wheel.force[i]);
    }
    assert!(rates.wheel.force[2] < -5e8, "the contact alone");
    assert_eq!(rates.foundation.deflection.map(f64::to_bits), [0.0_f64.to_bits(); 2]);
}

#[test]
fn rails_under_uneven_wheels_move_with_the_order_of_the_others() {
    let mut parameters = elastic(with_mass());
    parameters.wheel.out_of_round.amplitude = 2e-5;
    parameters.wheel.out_of_round.order = 30;
    let path = |h: f64, stride: u32| {
        let mut element = element(&parameters);
        let mut input = swinging(&mut element, 0.0);
        let mut path = Vec::new();
        for step in 1..=60 * stride {
            let time = h * f64::from(step);
            let mut next = swinging(&mut element, time);
            next.wheel.pitch = next.wheel.pitch_rate * time;
            element.move_rails(&input, &next, h).unwrap();
            input = next;
            if step % stride == 0 {
                path.push(element.track_state().unwrap().deflection[1]);
            }
        }
        path
    };
    let [a, b, c] = [(1e-4, 1), (5e-5, 2), (2.5e-5, 4)].map(|(h, stride)| path(h, stride));
    let apart = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(a, b)| (a - b).abs()).sum() };
    let ratio = apart(&a, &b) / apart(&b, &c);
    println!("{ratio}");
    assert!((ratio - 4.0).abs() < 1.0, "{ratio}");
}

#[test]
fn what_is_refused_leaves_the_rails_where_they_are() {
    let mut moving = element(&Parameters { foundation: with_mass(), ..Parameters::default() });
    let [a, b] = [0.0, 1e-3].map(|time| swinging(&mut moving, time));
    moving.move_rails(&a, &b, 1e-3).unwrap();
    let state = moving.track_state();
    let mut bad = b;
    bad.wheel.velocity[1] = f64::NAN;
    let message = moving.move_rails(&a, &bad, 1e-3).unwrap_err().to_string();
    assert!(message.contains("wheel.vy = NaN"), "{message}");
    for duration in [-1e-3, f64::NAN, f64::INFINITY] {
        let message = moving.move_rails(&a, &b, duration).unwrap_err().to_string();
        assert!(message.contains("duration"), "{message}");
    }
    assert_eq!(moving.track_state(), state);
    let mut rigid = element(&Parameters::default());
    rigid.move_rails(&a, &b, 1e-3).unwrap();
    assert_eq!(rigid.track_state(), None);
}
