//! Derivatives of a wheelset.

use super::*;
use wheelrail::element::parameters::{FoundationModel, TangentialModel};

/// The coordinates, rates and loads of an input, to be changed one by one.
fn numbers(input: &mut Input) -> Vec<&mut f64> {
    let Input { wheelset: w, sides, track_s: _, track } = input;
    let mut all: Vec<&mut f64> = w.position.iter_mut().chain(&mut w.velocity).collect();
    all.extend([&mut w.roll, &mut w.yaw, &mut w.pitch]);
    all.extend([&mut w.roll_rate, &mut w.yaw_rate, &mut w.pitch_rate]);
    let mut others = vec![&mut track.twist, &mut track.vertical_curvature, &mut track.curvature];
    for SideInput { rails: [rail, _], wheel_load, friction, line, own_pitch_rate, .. } in sides {
        all.extend([&mut rail.y, &mut rail.z, &mut rail.roll]);
        all.extend([&mut rail.vy, &mut rail.vz, &mut rail.roll_rate, friction, wheel_load]);
        others.extend([&mut line.y, &mut line.z, &mut line.y_slope, &mut line.z_slope]);
        others.push(own_pitch_rate);
    }
    all.extend(others);
    all
}

/// Total, each side and what is found.
fn results(output: &Output) -> [Vec<f64>; 4] {
    let mut forces = output.wheelset.force.to_vec();
    let mut moments = output.wheelset.moment.to_vec();
    for side in &output.sides {
        forces.extend(side.wheel.force);
        forces.extend(side.rails[0].force);
        moments.extend(side.wheel.moment);
        moments.extend(side.rails[0].moment);
    }
    forces.extend(
        output.guiding.sides.iter().flat_map(|side| [side.guiding_force, side.vertical_force]),
    );
    forces.push(output.guiding.track_shifting_force);
    [forces, moments, vec![output.wheelset_z, output.roll], vec![output.frictional_power]]
}

/// In random directions, of a model of creep forces without kinks.
fn judge_derivatives(
    model: TangentialModel,
    mode: VerticalMode,
    foundation: FoundationModel,
    (step, poses): (f64, usize),
) -> f64 {
    let mut parameters = Parameters::default();
    for side in &mut parameters.sides {
        side.foundation.model = foundation;
        (side.vertical_mode, side.tangential_model) = (mode, model);
        // Without the kinks of strips, which differences of one step do not see:
        // tests/suite/derivatives looks for them.
        side.normal_model = NormalModel::PiotrowskiKik;
    }
    let mut wheelset = wheelset(&parameters);
    let mut random = Random::new(27);
    let (mut worst, mut count) = (0.0_f64, 0);
    for _ in 0..poses {
        let mut input = random_on_track(&mut random);
        for side in &mut input.sides {
            side.wheel_load = random.within(3e4, 9e4);
        }
        let before = wheelset.elements().iter().map(element::Element::fallback_count).sum::<i32>();
        let at = evaluate(&mut wheelset, &input);
        // Where the model jumps past what is sought there is no derivative.
        if at.sides.iter().any(|side| side.patch_count != 1) || at.fallback_count > before {
            continue;
        }
        let mut direction = Input::at_rest();
        for (i, number) in numbers(&mut direction).into_iter().enumerate() {
            // A load moves by newtons where a height moves by fractions of a micrometre.
            *number = random.about(if i == 19 || i == 27 { 1e7 } else { 1.0 });
        }
        let mut rates = Output::default();
        wheelset.directional_derivative(&input, &direction, &mut rates).unwrap();
        let mut moved = |h: f64| {
            let (mut input, mut direction) = (input, direction);
            let ways = numbers(&mut direction);
            for (number, way) in numbers(&mut input).into_iter().zip(ways) {
                *number += h * *way;
            }
            let output = evaluate(&mut wheelset, &input);
            (output.patch_count == at.patch_count).then(|| results(&output))
        };
        let places = [moved(-step), moved(-0.5 * step), moved(0.5 * step), moved(step)];
        let [Some(a), Some(b), Some(c), Some(d)] = places else { continue };
        for (g, group) in results(&rates).iter().enumerate() {
            let size = largest(group.iter().copied());
            for (i, rate) in group.iter().enumerate() {
                let slope = |low: &[Vec<f64>; 4], high: &[Vec<f64>; 4], h: f64| {
                    (high[g][i] - low[g][i]) / h
                };
                let both = (4.0 * slope(&b, &c, step) - slope(&a, &d, 2.0 * step)) / 3.0;
                worst = worst.max((rate - both).abs() / size);
                count += 1;
            }
        }
    }
    println!("{model:?}, {mode:?}: worst of {count} rates {worst:e}");
    assert!(count > 10 * poses, "{count}");
    worst
}

#[test]
fn derivatives_are_those_of_differences() {
    for model in [TangentialModel::Linear, TangentialModel::Tables] {
        // Given loads are met to 1e-10 of them, which longer steps feel less.
        for (mode, step) in [(VerticalMode::Penetration, 2e-7), (VerticalMode::Load, 1e-6)] {
            let worst = judge_derivatives(model, mode, FoundationModel::Rigid, (step, 30));
            assert!(worst < tolerance::DERIVATIVES, "{model:?}, {mode:?}: {worst:e}");
        }
    }
}

#[test]
fn derivatives_go_through_rails_that_give_way() {
    let (model, foundation) = (TangentialModel::Tables, FoundationModel::Massless);
    for (mode, step) in [(VerticalMode::Penetration, 2e-7), (VerticalMode::Load, 1e-6)] {
        let worst = judge_derivatives(model, mode, foundation, (step, 10));
        assert!(worst < tolerance::DERIVATIVES, "{mode:?}: {worst:e}");
    }
}

#[test]
fn derivatives_leave_the_wheelset_as_it_was() {
    let mut wheelset = wheelset(&Parameters::default());
    let input = random_input(&mut Random::new(28));
    let before = format!("{:?}", evaluate(&mut wheelset, &input));
    let mut direction = Input::at_rest();
    direction.wheelset.yaw = 1.0;
    let mut rates = Output::default();
    wheelset.directional_derivative(&input, &direction, &mut rates).unwrap();
    assert_eq!(format!("{:?}", evaluate(&mut wheelset, &input)), before);
}
