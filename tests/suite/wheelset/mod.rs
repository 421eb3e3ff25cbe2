//! A wheelset: two wheels on one rigid axle, their mirror image, loads, wear, and refusals by name.

mod curving;
mod derivatives;
mod foundation;
mod gravity;
mod rigid_body;
mod track;

use crate::common::random::Random;
use crate::tolerance;
use wheelrail::element;
use wheelrail::element::input::{RailMotion, WheelMotion};
use wheelrail::element::output::Wrench;
use wheelrail::element::parameters::{NormalModel, Side, VerticalMode, WearModel};
use wheelrail::wheelset::{
    Input, LEFT, Output, Parameters, RIGHT, RailLine, SideInput, TrackTurn, Wheelset,
};

const HALF: f64 = 0.75;

fn wheelset(parameters: &Parameters) -> Wheelset {
    Wheelset::new(parameters, &Input::default(), &[]).unwrap()
}

fn evaluate(wheelset: &mut Wheelset, input: &Input) -> Output {
    let mut output = Output::default();
    wheelset.evaluate(input, &mut output).unwrap();
    output
}

/// Anything a rolling wheelset may do, pressed on rails that move.
fn random_input(random: &mut Random) -> Input {
    let mut rail = || RailMotion {
        y: random.about(1e-3),
        z: random.about(2e-5),
        roll: random.about(0.01),
        vy: random.about(0.05),
        vz: random.about(0.01),
        roll_rate: random.about(0.05),
        // Without effect on straight rails.
        pitch_rate: 3.0,
    };
    let rails = [[rail(), rail()], [rail(), rail()]];
    let friction = [random.within(0.1, 0.5), random.within(0.1, 0.5)];
    let speed = random.within(5.0, 60.0);
    Input {
        wheelset: WheelMotion {
            position: [random.about(3.0), random.about(4e-3), -0.46 + random.within(2.5e-4, 4e-4)],
            roll: random.about(1e-4),
            yaw: random.about(0.01),
            pitch: random.about(3.0),
            velocity: [speed, random.about(0.2), random.about(0.01)],
            roll_rate: random.about(0.02),
            yaw_rate: random.about(0.1),
            pitch_rate: -speed / 0.46 * (1.0 + random.about(2e-3)),
        },
        sides: [0, 1].map(|k| SideInput {
            rails: rails[k],
            wheel_load: 0.0,
            friction: friction[k],
            ..Input::default().sides[k]
        }),
        track_s: random.about(100.0),
        track: TrackTurn::default(),
    }
}

/// The same on a track that turns, on rails that run at an angle, with wheels that turn by
/// themselves.
fn random_on_track(random: &mut Random) -> Input {
    let mut input = random_input(random);
    for side in &mut input.sides {
        side.line = RailLine {
            y: random.about(1e-3),
            z: random.about(2e-5),
            y_slope: random.about(5e-3),
            z_slope: random.about(5e-4),
        };
        side.own_pitch_rate = random.about(0.1);
    }
    input.track = TrackTurn {
        twist: random.about(2e-3),
        vertical_curvature: random.about(1e-3),
        curvature: random.about(5e-3),
    };
    input
}

fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, |most, value| most.max(value.abs()))
}

fn components(wrench: &Wrench) -> impl Iterator<Item = f64> {
    wrench.force.into_iter().chain(wrench.moment)
}

#[test]
fn the_mirror_image_of_a_motion_gives_the_mirror_image_of_the_forces_bit_for_bit() {
    let mut wheelset = wheelset(&Parameters::default());
    let mut random = Random::new(23);
    for _ in 0..100 {
        let input = random_on_track(&mut random);
        let mut image = input;
        let centre = &mut image.wheelset;
        for value in [
            &mut centre.position[1],
            &mut centre.velocity[1],
            &mut centre.roll,
            &mut centre.yaw,
            &mut centre.roll_rate,
            &mut centre.yaw_rate,
        ] {
            *value = -*value;
        }
        image.sides.swap(0, 1);
        for value in [&mut image.track.twist, &mut image.track.curvature] {
            *value = -*value;
        }
        for line in image.sides.iter_mut().map(|side| &mut side.line) {
            (line.y, line.y_slope) = (-line.y, -line.y_slope);
        }
        for rail in image.sides.iter_mut().flat_map(|side| &mut side.rails) {
            for value in [&mut rail.y, &mut rail.roll, &mut rail.vy, &mut rail.roll_rate] {
                *value = -*value;
            }
        }
        let (ours, theirs) = (evaluate(&mut wheelset, &input), evaluate(&mut wheelset, &image));
        let same = |a: f64, b: f64| assert!((a - b).abs() <= 0.0, "{a} and {b}");
        let mirrored = |a: &Wrench, b: &Wrench| {
            for (i, sign) in [1.0, -1.0, 1.0].into_iter().enumerate() {
                same(a.force[i], sign * b.force[i]);
                same(a.moment[i], -sign * b.moment[i]);
            }
        };
        for (a, b) in ours.sides.iter().zip(theirs.sides.iter().rev()) {
            mirrored(&a.wheel, &b.wheel);
            mirrored(&a.rails[0], &b.rails[0]);
            assert_eq!(a.patch_count, b.patch_count);
        }
        // Sums are taken in another order.
        let size = largest(components(&ours.wheelset));
        for (i, sign) in [1.0, -1.0, 1.0].into_iter().enumerate() {
            let force = ours.wheelset.force[i] - sign * theirs.wheelset.force[i];
            let moment = ours.wheelset.moment[i] + sign * theirs.wheelset.moment[i];
            assert!(largest([force, moment]) <= tolerance::ROUNDING * size);
        }
    }
}

#[test]
fn both_wheels_touch_at_the_nominal_height_in_the_middle_and_the_lower_one_first_when_rolled() {
    let middle = wheelset(&Parameters::default());
    let heights = middle.nominal_heights();
    assert_eq!(heights.wheel_z[0].to_bits(), heights.wheel_z[1].to_bits());
    assert_eq!(heights.wheelset_z.to_bits(), heights.wheel_z[0].to_bits());
    let mut start = Input::default();
    start.wheelset.roll = 2e-3;
    let mut rolled = Wheelset::new(&Parameters::default(), &start, &[]).unwrap();
    for (depth, touching) in [(-1e-9, 0), (1e-9, 1)] {
        let mut input = start;
        input.wheelset.position[2] = rolled.nominal_z() + depth;
        let output = evaluate(&mut rolled, &input);
        // Positive roll lowers the right wheel.
        assert_eq!(output.sides.map(|side| side.patch_count), [touching, 0]);
    }
    // Beside both rails there is no such height.
    start.wheelset.position = [0.0, 3.0, -0.3];
    let beside = Wheelset::new(&Parameters::default(), &start, &[]).unwrap();
    assert_eq!(beside.nominal_z().to_bits(), (-0.3_f64).to_bits());
}

#[test]
fn the_wheels_stand_as_far_apart_as_the_flange_backs_say() {
    let lateral = |distance: f64| {
        let parameters = Parameters { flange_back_distance: distance, ..Parameters::default() };
        let mut wheelset = wheelset(&parameters);
        let mut input = Input::default();
        input.wheelset.position[2] = wheelset.nominal_z() + 5e-5;
        let output = evaluate(&mut wheelset, &input);
        // The nominal rolling circle on the profile is half of the distance and 70 mm from the
        // centre.
        output.sides.map(|side| side.patches[0].position[1].abs() - side.patches[0].wheel_y)
    };
    for distance in [1.357, 1.36, 1.363] {
        for place in lateral(distance) {
            let marker = 0.5 * distance + 0.07;
            assert!((place - marker).abs() < 1e-4, "{place} for {marker}");
        }
    }
}

#[test]
fn sides_may_differ_and_keep_their_place() {
    let mut parameters = Parameters::default();
    parameters.sides[RIGHT].side = Side::Left;
    parameters.sides[LEFT].wheel.profile = "conical:0.05".into();
    parameters.sides[LEFT].wheel.nominal_radius = 0.45;
    parameters.sides[LEFT].normal_model = NormalModel::Hertz;
    let mut wheelset = wheelset(&parameters);
    let heights = wheelset.nominal_heights().wheel_z;
    assert!(heights[LEFT] - heights[RIGHT] > 0.009);
    let mut input = Input::default();
    input.wheelset.position[2] = heights[RIGHT] + 1e-4;
    let output = evaluate(&mut wheelset, &input);
    assert!(output.sides[RIGHT].patches[0].position[1] > 0.7);
    assert_eq!(output.sides[LEFT].patch_count, 0);
}

#[test]
fn a_check_rail_stands_in_mirror_image_on_the_left() {
    let mut one = element::Parameters::default();
    one.rails[1].enabled = true;
    let parameters = Parameters::of_both(&one);
    let places = [0, 1].map(|k| parameters.sides[k].rails[1].position[0]);
    assert!((places[0] + places[1]).abs() <= 0.0 && places[0] > 0.0);
    // Pushed to the right, the flange back of the left wheel meets its check rail and pushes it
    // along.
    let mut wheelset = wheelset(&parameters);
    let mut input = Input::default();
    input.wheelset.position[2] = wheelset.nominal_z();
    let mut pushed = |y: f64| {
        input.wheelset.position[1] = y;
        evaluate(&mut wheelset, &input).sides.map(|side| side.rails[1].force[1])
    };
    let (right, left) = (pushed(5e-3), pushed(-5e-3));
    assert!(right[LEFT] > 1e3 && right[RIGHT].abs() <= 0.0, "{right:?}");
    assert!((left[RIGHT] + right[LEFT]).abs() <= 0.0 && left[LEFT].abs() <= 0.0, "{left:?}");
}

#[test]
fn given_loads_are_carried_at_the_height_and_roll_of_a_rigid_axle() {
    let mut parameters = Parameters::default();
    for side in &mut parameters.sides {
        side.vertical_mode = VerticalMode::Load;
    }
    // Normal damping has no part in it.
    let mut undamped = Parameters::default();
    for side in &mut undamped.sides {
        side.damping = 0.0;
    }
    let (mut loaded, mut rigid) = (wheelset(&parameters), wheelset(&undamped));
    let mut random = Random::new(26);
    for shift in [0.0, 1e-3, -3e-3, 5e-3, 7e-3] {
        let mut input = random_input(&mut random);
        input.wheelset.position[1] = shift;
        for side in &mut input.sides {
            side.wheel_load = random.within(2e4, 9e4);
            side.rails = Default::default();
        }
        let before = loaded.elements()[LEFT].work().evaluations;
        let output = evaluate(&mut loaded, &input);
        // The search for the roll, and once more at the roll found.
        let evaluations = loaded.elements()[LEFT].work().evaluations - before;
        println!("{evaluations} evaluations of each side");
        assert!(evaluations < 20);
        assert_eq!(output.fallback_count, 0);
        for k in [RIGHT, LEFT] {
            let (carried, load) = (-output.sides[k].wheel.force[2], input.sides[k].wheel_load);
            assert!((carried / load - 1.0).abs() < tolerance::PRESCRIBED_LOAD, "{carried} {load}");
        }
        let [right, left] = output.sides.each_ref().map(|side| side.wheel_z);
        let between = 2.0 * HALF * output.roll.sin() * input.wheelset.yaw.cos();
        assert!((right - left - between).abs() < 1e-14, "{right} {left} {between}");
        // Put there, the wheelset feels the same.
        let mut found = input;
        (found.wheelset.position[2], found.wheelset.roll) = (output.wheelset_z, output.roll);
        let again = evaluate(&mut rigid, &found);
        for k in [RIGHT, LEFT] {
            let pairs = components(&again.sides[k].wheel).zip(components(&output.sides[k].wheel));
            let difference = largest(pairs.map(|(a, b)| a - b));
            assert!(difference < 1e-9 * input.sides[k].wheel_load, "{difference}");
        }
        // Whatever height and roll were given.
        (input.wheelset.position[2], input.wheelset.roll) = (-0.3, 0.05);
        assert_eq!(format!("{:?}", evaluate(&mut loaded, &input)), format!("{output:?}"));
    }
    // A side without load is lifted from its rail; beside the rails nothing carries.
    let mut input = Input::default();
    input.sides[RIGHT].wheel_load = 5e4;
    let output = evaluate(&mut loaded, &input);
    assert!(output.sides[LEFT].wheel.force[2].abs() <= 0.0 && output.sides[RIGHT].patch_count > 0);
    input.wheelset.position[1] = 3.0;
    let before = output.fallback_count;
    assert!(evaluate(&mut loaded, &input).fallback_count > before);
    parameters.sides[LEFT].vertical_mode = VerticalMode::Penetration;
    let error = Wheelset::new(&parameters, &Input::default(), &[]).unwrap_err().to_string();
    assert!(error.starts_with("vertical.mode"), "{error}");
}

#[test]
fn both_sides_wear_as_they_would_alone() {
    let mut parameters = Parameters::default();
    for side in &mut parameters.sides {
        side.wear.model = WearModel::FrictionalWork;
        side.wear.acceleration_factor = 1e5;
        side.wear.update_interval = 3e-3;
    }
    let mut set = wheelset(&parameters);
    let mut alone = set.elements().clone();
    let mut random = Random::new(24);
    for _ in 0..8 {
        let input = random_input(&mut random);
        let mut output = Output::default();
        set.advance(&input, &mut output, 1e-3).unwrap();
        for (k, along) in [(RIGHT, HALF), (LEFT, -HALF)] {
            let mut single = element::Output::default();
            alone[k].advance(&input.of_side(k, along), &mut single, 1e-3).unwrap();
            assert_eq!(format!("{single:?}"), format!("{:?}", output.sides[k]));
            assert!(single.wheel_wear.volume > 0.0);
        }
    }
    let error = set.advance(&Input::default(), &mut Output::default(), -1.0).unwrap_err();
    assert!(error.to_string().contains("duration = -1"), "{error}");
}

type Place = fn(&mut Input) -> &mut f64;

#[test]
fn what_is_refused_has_its_name_in_the_wheelset_and_changes_nothing() {
    let refused = |change: &dyn Fn(&mut Parameters)| {
        let mut parameters = Parameters::default();
        change(&mut parameters);
        Wheelset::new(&parameters, &Input::default(), &[]).unwrap_err().to_string()
    };
    for (message, words) in [
        (refused(&|p| p.sides[LEFT].wheel.profile = "nothing".into()), "left.wheel.profile"),
        (refused(&|p| p.sides[RIGHT].rails[0].profile = "no.prr".into()), "right.rail[1].profile"),
        (refused(&|p| p.sides[LEFT].wheel.nominal_radius = 0.02), "left.wheel.nominal_radius"),
        (refused(&|p| p.sides[LEFT].wheel.young_modulus = -1.0), "wheel.young_modulus"),
        (refused(&|p| p.sides[RIGHT].gauge = f64::NAN), "track.gauge = NaN"),
        (refused(&|p| p.flange_back_distance = 0.0), "flange_back_distance = 0"),
    ] {
        assert!(message.starts_with(words), "{message}");
    }
    let mut wheelset = wheelset(&Parameters::default());
    let mut output = evaluate(&mut wheelset, &random_input(&mut Random::new(25)));
    let before = format!("{output:?}");
    let places: [(&str, Place); 6] = [
        ("wheelset.x", |i| &mut i.wheelset.position[0]),
        ("wheelset.yaw_rate", |i| &mut i.wheelset.yaw_rate),
        ("left.rail[1].vz", |i| &mut i.sides[LEFT].rails[0].vz),
        ("right.rail[2].roll", |i| &mut i.sides[RIGHT].rails[1].roll),
        ("left.friction.coefficient", |i| &mut i.sides[LEFT].friction),
        ("track.s", |i| &mut i.track_s),
    ];
    for (name, place) in places {
        for value in [f64::NAN, f64::NEG_INFINITY] {
            let mut input = Input::default();
            *place(&mut input) = value;
            let error = wheelset.evaluate(&input, &mut output).unwrap_err().to_string();
            assert!(error.starts_with(name), "{error}");
        }
    }
    // Finite, but not at the markers any more.
    let mut input = Input::default();
    input.wheelset.velocity[0] = f64::MAX;
    input.wheelset.yaw_rate = -f64::MAX;
    let error = wheelset.evaluate(&input, &mut output).unwrap_err().to_string();
    assert!(error.contains("wheel.vx = inf"), "{error}");
    assert_eq!(format!("{output:?}"), before);
}
