//! A wheelset on elastically supported rails.

use super::*;
use wheelrail::element::parameters::{Foundation, FoundationModel};

fn on(model: FoundationModel, mode: VerticalMode) -> Wheelset {
    let foundation = Foundation { model, ..Foundation::default() };
    let one = element::Parameters { foundation, vertical_mode: mode, ..Default::default() };
    wheelset(&Parameters::of_both(&one))
}

/// Deep enough for rails that sink.
fn deep(random: &mut Random) -> Input {
    let mut input = random_on_track(random);
    input.wheelset.position[2] += 8e-4;
    for side in &mut input.sides {
        side.wheel_load = random.within(3e4, 9e4);
        side.rails[1] = RailMotion::default();
    }
    input
}

/// The same on rails that are moved in their frame as `output` says.
fn moved(input: &Input, output: &Output) -> Input {
    let mut moved = *input;
    for (side, found) in moved.sides.iter_mut().zip(&output.sides) {
        let ([y, z], [vy, vz]) = (found.foundation.deflection, found.foundation.velocity);
        let rail = &mut side.rails[0];
        (rail.y, rail.z) = (rail.y + y, rail.z + z);
        (rail.vy, rail.vz) = (rail.vy + vy, rail.vz + vz);
    }
    moved
}

fn same_forces(found: &Output, expected: &Output) {
    let size = largest(components(&expected.wheelset));
    for (a, b) in components(&found.wheelset).zip(components(&expected.wheelset)) {
        assert!((a - b).abs() <= tolerance::FOUND_AGAIN * size, "{a} {b}");
    }
}

#[test]
fn each_side_gives_way_by_itself_and_feels_its_rails_where_they_are() {
    for mode in [VerticalMode::Penetration, VerticalMode::Load] {
        let mut springs = on(FoundationModel::Massless, mode);
        let mut rigid = on(FoundationModel::Rigid, mode);
        let mut random = Random::new(71);
        for _ in 0..4 {
            let input = deep(&mut random);
            let output = evaluate(&mut springs, &input);
            assert_eq!(output.fallback_count, 0);
            let sunk = output.sides.each_ref().map(|side| side.foundation.deflection[1]);
            assert!(
                sunk[0] > 1e-4 && sunk[1] > 1e-4 && (sunk[0] - sunk[1]).abs() > 1e-6,
                "{sunk:?}"
            );
            same_forces(&evaluate(&mut rigid, &moved(&input, &output)), &output);
        }
    }
}

#[test]
fn rails_with_a_mass_run_along_on_a_track_that_turns() {
    let mut moving = on(FoundationModel::Mass, VerticalMode::Penetration);
    let mut rigid = on(FoundationModel::Rigid, VerticalMode::Penetration);
    let mut random = Random::new(72);
    let start = deep(&mut random);
    let mut end = start;
    end.wheelset.position[2] += 2e-5;
    end.wheelset.velocity[2] = 0.02;
    moving.move_rails(&start, &end, 1e-3).unwrap();
    let output = evaluate(&mut moving, &end);
    for side in &output.sides {
        assert!(largest(side.foundation.velocity) > 1e-3, "{:?}", side.foundation);
        assert!(side.foundation.step_error > 0.0);
    }
    same_forces(&evaluate(&mut rigid, &moved(&end, &output)), &output);
    // What is refused on one side moves neither.
    let before = moving.elements().each_ref().map(element::Element::track_state);
    let mut bad = end;
    bad.sides[LEFT].rails[0].vz = f64::NAN;
    let error = moving.move_rails(&end, &bad, 1e-3).unwrap_err().to_string();
    assert!(error.contains("left.rail[1].vz = NaN"), "{error}");
    let error = moving.move_rails(&start, &end, -1.0).unwrap_err().to_string();
    assert!(error.contains("duration = -1"), "{error}");
    assert_eq!(moving.elements().each_ref().map(element::Element::track_state), before);
}
