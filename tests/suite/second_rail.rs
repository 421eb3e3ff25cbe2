//! A second rail: check rail behind the flange, switch tongue beside the stock rail.

use crate::common::random::Random;
use crate::common::vectors::{add, assert_close, cross};
use crate::common::wheel::{
    element, evaluate, mirrored, pressed, rail_marker, random_input, rolling,
};
use crate::tolerance;
use wheelrail::element::parameters::{NormalModel, Side};
use wheelrail::element::{Element, Input, Output, Parameters, StartWarning};
use wheelrail::geometry::profile::ProfileKind;
use wheelrail::geometry::rail::placed_rail::PlacedRail;
use wheelrail::io::load_profile;

/// Half the width of a 60E1 head, and how far its side leans out below the top edge [m].
const HALF_HEAD: f64 = 0.036;

/// A check rail whose face is 42 mm from the gauge face and whose top is 30 mm above the running
/// rail.
fn with_check_rail() -> Parameters {
    let mut parameters = Parameters::default();
    parameters.rails[1].enabled = true;
    parameters.rails[1].inclination = 0.0;
    parameters.rails[1].position = [0.7175 - 0.042 - HALF_HEAD, -0.03];
    parameters
}

/// A tongue of the same profile as the stock rail, in the same place but `lower` beneath it.
fn with_tongue(lower: f64) -> Parameters {
    let mut parameters = Parameters::default();
    let [_, y, z] = rail_marker(&parameters);
    parameters.rails[1].enabled = true;
    parameters.rails[1].position = [y, z + lower];
    parameters.rails[1].mirrored = false;
    parameters
}

/// The lateral place, to the side of the field, at which the flange back presses on the check rail
/// with `force`.
fn pulled_against(element: &mut Element, input: &mut Input, force: f64) -> Output {
    let (mut pressing, mut free) = (0.73, 0.755);
    let mut output = Output::default();
    for _ in 0..60 {
        input.wheel.position[1] = 0.5 * (pressing + free);
        output = evaluate(element, input);
        let bound = if output.rails[1].force[1] < -force { &mut pressing } else { &mut free };
        *bound = input.wheel.position[1];
    }
    output
}

#[test]
fn a_check_rail_is_touched_by_the_flange_back_and_pulls_the_wheel_to_the_track_centre() {
    let mut element = element(&with_check_rail());
    for yaw in [-0.01, 0.01] {
        let mut input = rolling(0.0, 20.0);
        input.wheel.yaw = yaw;
        let output = pulled_against(&mut element, &mut input, 20e3);
        let patch = output.patches.iter().find(|p| p.rail == 2).unwrap();
        assert!(patch.contact_angle.to_degrees() > 80.0, "{patch:?}");
        assert!(patch.wheel_y < -0.068, "on the flange back: {patch:?}");
        // The end of the face that leans towards the check rail: ahead of the axle where the wheel
        // runs to the field side.
        assert!(patch.position[0] * yaw < 0.0 && patch.position[0].abs() > 0.04, "{patch:?}");
        assert!(output.wheel.force[1] > 19e3, "towards the field side");
    }
}

#[test]
fn the_force_of_a_check_rail_has_no_jump_where_the_wheel_runs_straight() {
    for normal_model in [NormalModel::Strips, NormalModel::PiotrowskiKik] {
        let mut element = element(&Parameters { normal_model, ..with_check_rail() });
        let mut input = rolling(0.0, 20.0);
        pulled_against(&mut element, &mut input, 20e3);
        let at = |element: &mut Element, yaw: f64| {
            let mut input = input;
            input.wheel.yaw = yaw;
            let wrench = evaluate(element, &input).wheel;
            [wrench.force[1], wrench.moment[2]]
        };
        let mut before = at(&mut element, -1e-3);
        let mut worst = [0f64; 2];
        for step in -999..=1000 {
            let now = at(&mut element, 1e-6 * f64::from(step));
            for k in 0..2 {
                worst[k] = worst[k].max((now[k] - before[k]).abs());
            }
            before = now;
        }
        println!("worst change over 1 microradian: {} N, {} N m", worst[0], worst[1]);
        let [force, moment] = tolerance::CHECK_RAIL_STEP;
        assert!(worst[0] < force && worst[1] < moment, "{normal_model:?}: {worst:?}");
    }
}

#[test]
fn every_action_on_wheel_and_rails_has_its_reaction() {
    let parameters = with_tongue(0.0);
    let mut element = element(&parameters);
    let mut random = Random::new(31);
    let mut both = 0;
    for _ in 0..200 {
        let mut input = random_input(&mut element, &mut random);
        let stock = input.rails[0];
        let tongue = &mut input.rails[1];
        *tongue = stock;
        tongue.y += random.about(2e-4);
        tongue.z += random.about(3e-5);
        tongue.roll += random.about(1e-3);
        tongue.vz = random.about(0.01);
        let input = pressed(&mut element, &input, 1e-4);
        let output = evaluate(&mut element, &input);
        let mut force = output.wheel.force;
        let mut moment = add(output.wheel.moment, cross(input.wheel.position, output.wheel.force));
        for (k, on_rail) in output.rails.iter().enumerate() {
            let [_, y, z] = rail_marker(&parameters);
            let marker = [0.0, y + input.rails[k].y, z + input.rails[k].z];
            force = add(force, on_rail.force);
            moment = add(moment, add(on_rail.moment, cross(marker, on_rail.force)));
        }
        let size = output.patches.iter().map(|p| p.normal_force).fold(1.0, f64::max);
        assert_close(force, [0.0; 3], 10.0 * tolerance::ROUNDING * size, "sum of forces");
        assert_close(moment, [0.0; 3], 10.0 * tolerance::ROUNDING * size, "sum of moments");
        for k in [0, 1] {
            let of_rail = |p: &&wheelrail::element::output::Patch| p.rail == k + 1;
            let loaded = output.patches.iter().filter(of_rail).any(|p| p.normal_force > 0.0);
            let pushed = output.rails[k as usize].force[1].abs() > 0.0;
            assert_eq!(loaded, pushed, "patches name the rail they push");
        }
        both += usize::from(output.rails.iter().all(|r| r.force[1].abs() > 0.0));
    }
    assert!(both > 40, "{both} inputs press on both rails");
}

#[test]
fn two_rails_in_one_place_carry_the_same_each() {
    let mut two = element(&with_tongue(0.0));
    let mut one = element(&Parameters::default());
    let input = pressed(&mut one, &rolling(-2e-3, 20.0), 6e-5);
    let (shared, alone) = (evaluate(&mut two, &input), evaluate(&mut one, &input));
    let size = alone.rails[0].force[2];
    for rail in shared.rails {
        // The tongue is placed by its marker, which is known to rounding.
        assert_close(
            rail.force,
            alone.rails[0].force,
            tolerance::SAME_PLACE * size,
            "each as if alone",
        );
    }
    assert_close(
        shared.wheel.force,
        alone.wheel.force.map(|f| 2.0 * f),
        2.0 * tolerance::SAME_PLACE * size,
        "twice",
    );
}

#[test]
fn a_rising_tongue_takes_the_load_over_from_the_stock_rail() {
    let mut element = element(&with_tongue(2e-4));
    let mut before = 0.0;
    for step in 0..=40 {
        let mut input = rolling(-2e-3, 20.0);
        input.rails[1].z = -1e-5 * f64::from(step);
        // Until 80 kN are carried.
        let (mut low, mut high) = (element.touching_height(&input), -0.4595);
        let mut output = Output::default();
        for _ in 0..50 {
            input.wheel.position[2] = 0.5 * (low + high);
            output = evaluate(&mut element, &input);
            let bound = if -output.wheel.force[2] < 80e3 { &mut low } else { &mut high };
            *bound = input.wheel.position[2];
        }
        let share = -output.rails[1].force[2] / output.wheel.force[2];
        assert!((-1e-9..=1.0 + 1e-9).contains(&share), "{share}");
        assert!(share >= before && share - before < 0.12, "step {step}: {before} to {share}");
        before = share;
    }
    assert!(before > 0.999, "the tongue carries all: {before}");
}

#[test]
fn a_second_rail_out_of_reach_changes_nothing_and_costs_a_bound() {
    let mut parameters = with_check_rail();
    let mut random = Random::new(5);
    let mut alone = element(&Parameters::default());
    parameters.rails[1].position[1] = 0.2;
    let mut beside = element(&parameters);
    for _ in 0..40 {
        let input = random_input(&mut alone, &mut random);
        assert_eq!(evaluate(&mut alone, &input), evaluate(&mut beside, &input));
    }
    let (alone, beside) = (alone.work(), beside.work());
    assert_eq!((alone.searches, alone.zones), (beside.searches, beside.zones));
    assert_eq!(alone.distances, beside.distances);
}

#[test]
fn a_left_wheel_at_its_check_rail_is_the_mirror_image() {
    let right = with_check_rail();
    let mut left = Parameters { side: Side::Left, ..right.clone() };
    left.rails[1].position[0] *= -1.0;
    let (mut right, mut left) = (element(&right), element(&left));
    let mut input = rolling(0.0, 20.0);
    input.wheel.yaw = 4e-3;
    let one = pulled_against(&mut right, &mut input, 10e3);
    let other = evaluate(&mut left, &mirrored(&input));
    for (r, l) in [(one.wheel, other.wheel), (one.rails[1], other.rails[1])] {
        let [fx, fy, fz] = r.force;
        let [mx, my, mz] = r.moment;
        assert_close(l.force, [fx, -fy, fz], 0.0, "force");
        assert_close(l.moment, [-mx, my, -mz], 0.0, "moment");
    }
}

#[test]
fn the_default_check_rail_leaves_a_flangeway_of_41_mm_and_a_centred_wheel_alone() {
    for side in [Side::Right, Side::Left] {
        let mut parameters = Parameters { side, ..Parameters::default() };
        parameters.rails[1].enabled = true;
        let mut start = rolling(0.0, 0.0);
        if side == Side::Left {
            start = mirrored(&start);
            parameters.rails[1].position[0] *= -1.0;
        }
        let mut element = Element::new(&parameters, &start, &[]).unwrap();
        assert_eq!(element.start_warning(), None);
        let standing = pressed(&mut element, &start, 1e-4);
        let output = evaluate(&mut element, &standing);
        assert_eq!((output.patch_count, output.patches[0].rail), (1, 1));
    }
    // From the gauge face to the widest place of the check rail.
    let parameters = Parameters::default();
    let profile = load_profile("rail", "60E1", ProfileKind::Rail, 0.0, &[]).unwrap();
    let rail =
        PlacedRail::at_marker(&profile.curve, parameters.rails[1].inclination, [0.0; 2], true);
    let (curve, count) = (rail.curve(), 10_000);
    let along = |i: i32| f64::from(i) / f64::from(count) * (curve.end() - curve.start());
    let widest = (0..=count).map(|i| curve.at(curve.start() + along(i)).point[0]);
    let face = parameters.rails[1].position[0] + widest.fold(f64::MIN, f64::max);
    let flangeway = 0.5 * parameters.gauge - face;
    assert!((flangeway - 0.041).abs() < 5e-4, "{flangeway}");
}

#[test]
fn a_check_rail_in_the_way_of_a_wheel_that_starts_is_told() {
    let mut parameters = Parameters::default();
    parameters.rails[1].enabled = true;
    parameters.rails[1].position[0] = 0.64;
    let hindered = element(&parameters);
    let warning = hindered.start_warning().unwrap();
    assert!(matches!(warning, StartWarning::InRail2 { overlap } if overlap > 2e-3), "{warning:?}");
    let words = warning.message("right.");
    assert!(words.contains("overlaps right.rail[2] by"), "{words}");
    assert!(words.contains("move it by right.rail[2].position.y"), "{words}");
    // A tongue that carries the wheel from above is no hindrance.
    assert_eq!(element(&with_tongue(-1e-3)).start_warning(), None);
}
