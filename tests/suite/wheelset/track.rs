//! A wheelset on a track that turns, on rails that run at an angle, with wheels that turn by
//! themselves.

use super::*;
use wheelrail::element::parameters::TangentialModel;
use wheelrail::wheelset::{MAX_SLOPE, MAX_TURN};

const SPEED: f64 = 20.0;

/// A wheelset that rolls evenly in the middle of the track, 0.1 mm in the rails.
fn rolling(wheelset: &Wheelset) -> Input {
    let mut input = Input::default();
    input.wheelset.position[2] = wheelset.nominal_z() + 1e-4;
    input.wheelset.velocity[0] = SPEED;
    input.wheelset.pitch_rate = -SPEED / 0.46;
    input
}

fn damped(damping: f64) -> Wheelset {
    let mut parameters = Parameters::default();
    for side in &mut parameters.sides {
        side.damping = damping;
    }
    wheelset(&parameters)
}

fn on_lines(input: &Input, line: RailLine) -> Input {
    let mut input = *input;
    for side in &mut input.sides {
        side.line = line;
    }
    input
}

#[test]
fn rails_that_run_at_an_angle_do_not_drag_a_wheelset_along() {
    let mut wheelset = damped(1e5);
    let straight = rolling(&wheelset);
    let slope = 2e-3;
    let crossing = evaluate(
        &mut wheelset,
        &on_lines(&straight, RailLine { y_slope: slope, ..RailLine::default() }),
    );
    let mut pulled = straight;
    for side in &mut pulled.sides {
        side.rails[0].vy = SPEED * slope;
    }
    let pulled = evaluate(&mut wheelset, &pulled);
    for (crossing, pulled) in crossing.sides.iter().zip(&pulled.sides) {
        // What lies still slips on what rolls by as much as it is seen from another direction.
        assert!(crossing.patches[0].creepage[1].abs() < 0.01 * slope);
        assert!((pulled.patches[0].creepage[1] + slope).abs() < 0.05 * slope);
        // Wheels come nearer to both alike, across the contact angle.
        let angle = crossing.patches[0].contact_angle.abs();
        assert!(angle > 0.01);
        let [one, other] = [crossing, pulled].map(|side| side.patches[0].normal_force);
        assert!((one / other - 1.0).abs() < 0.02, "{one} {other}");
    }
}

#[test]
fn a_wheelset_that_follows_its_rails_does_not_see_their_direction() {
    let mut wheelset = damped(1e5);
    let straight = rolling(&wheelset);
    let expected = evaluate(&mut wheelset, &straight);
    let (angle, dip) = (1e-3_f64, 2e-3_f64);
    let place = RailLine { y: 0.02, z: 0.003, ..RailLine::default() };
    let mut moved = on_lines(&straight, place);
    moved.wheelset.position[1] += place.y;
    moved.wheelset.position[2] += place.z;
    let mut aside = on_lines(&moved, RailLine { y_slope: angle.tan(), ..place });
    aside.wheelset.yaw = angle;
    aside.wheelset.velocity = [SPEED * angle.cos(), SPEED * angle.sin(), 0.0];
    let mut down = on_lines(&moved, RailLine { z_slope: dip.tan(), ..place });
    down.wheelset.velocity = [SPEED * dip.cos(), 0.0, SPEED * dip.sin()];
    // As far above the rail as before, square to it.
    down.wheelset.position[2] = place.z + straight.wheelset.position[2] / dip.cos();
    for (input, ahead) in [
        (moved, [1.0, 0.0, 0.0]),
        (aside, [angle.cos(), angle.sin(), 0.0]),
        (down, [dip.cos(), 0.0, dip.sin()]),
    ] {
        let found = evaluate(&mut wheelset, &input);
        for (found, expected) in found.sides.iter().zip(&expected.sides) {
            let [own, other] = [found, expected].map(|side| &side.patches[0]);
            // The gauge narrows with the square of the angle, by less than 1 um.
            let share = own.normal_force / other.normal_force - 1.0;
            assert!(share.abs() < 1e-3, "{share} {ahead:?}");
            // Spin counts over the millimetres of the patch.
            for (i, bound) in [1e-5, 1e-5, 1e-3].into_iter().enumerate() {
                let change = own.creepage[i] - other.creepage[i];
                assert!(change.abs() < bound, "creepage {i}: {change} {ahead:?}");
            }
            let along = |force: [f64; 3], ahead: [f64; 3]| -> f64 {
                force.iter().zip(ahead).map(|(force, ahead)| force * ahead).sum()
            };
            let [own, other] =
                [along(found.wheel.force, ahead), along(expected.wheel.force, [1.0, 0.0, 0.0])];
            assert!((own - other).abs() < 1e-3 * expected.load_carried, "{own} {other} {ahead:?}");
            // What the rails get is what the wheel gets, the other way.
            for i in 0..3 {
                let left = found.wheel.force[i] + found.rails[0].force[i];
                assert!(left.abs() <= tolerance::ROUNDING * expected.load_carried);
            }
            let aside = found.patches[0].position[1] - expected.patches[0].position[1];
            assert!((aside - place.y).abs() < 1e-4, "{aside}");
        }
    }
}

#[test]
fn the_wheels_of_a_solid_axle_slip_in_a_curve_by_what_their_rails_differ_in_length() {
    let mut wheelset = wheelset(&Parameters::default());
    let mut input = rolling(&wheelset);
    let straight = evaluate(&mut wheelset, &input);
    input.track.curvature = 1.0 / 300.0;
    let curve = evaluate(&mut wheelset, &input);
    for (k, outward) in [(RIGHT, -1.0), (LEFT, 1.0)] {
        let [curve, straight] = [&curve, &straight].map(|output| &output.sides[k].patches[0]);
        let change = curve.creepage[0] - straight.creepage[0];
        let wanted = outward * curve.position[1].abs() / 300.0;
        // Creepage refers to the mean of the speeds of both bodies.
        assert!((change / wanted - 1.0).abs() < HALF / 300.0, "{change} {wanted}");
    }
    // The same as a yaw rate of its own.
    let mut yawing = rolling(&wheelset);
    yawing.wheelset.yaw_rate = SPEED / 300.0;
    let yawing = evaluate(&mut wheelset, &yawing);
    for (a, b) in components(&yawing.wheelset).zip(components(&curve.wheelset)) {
        assert!((a - b).abs() <= 1e-7 * 1e5, "{a} {b}");
    }
    // Wheels that turn by themselves follow without slip.
    for (k, outward) in [(RIGHT, -1.0), (LEFT, 1.0)] {
        let lever = curve.sides[k].patches[0].position[1].abs();
        input.sides[k].own_pitch_rate = -SPEED / 0.46 * outward * lever / 300.0;
    }
    let free = evaluate(&mut wheelset, &input);
    for (free, straight) in free.sides.iter().zip(&straight.sides) {
        let change = free.patches[0].creepage[0] - straight.patches[0].creepage[0];
        assert!(change.abs() < 0.02 * HALF / 300.0, "{change}");
    }
}

#[test]
fn wheels_do_not_come_nearer_to_rails_that_turn_with_the_track() {
    let [mut damped, mut undamped] = [1e5, 0.0].map(damped);
    let mut input = rolling(&damped);
    input.track = TrackTurn { twist: 3e-3, vertical_curvature: 2e-3, curvature: 5e-3 };
    let [damped, undamped] =
        [&mut damped, &mut undamped].map(|wheelset| evaluate(wheelset, &input));
    for (a, b) in damped.sides.iter().zip(&undamped.sides) {
        let share = a.patches[0].normal_force / b.patches[0].normal_force - 1.0;
        // As velocities of their own these would be 45 mm/s or 4.5 kN of 90.
        assert!(share.abs() < 1e-4, "{share}");
    }
}

#[test]
fn guiding_forces_are_those_on_the_rails() {
    let mut parameters = Parameters::default();
    for side in &mut parameters.sides {
        side.tangential_model = TangentialModel::None;
    }
    let mut wheelset = wheelset(&parameters);
    let mut input = rolling(&wheelset);
    input.wheelset.position[1] = 6.5e-3;
    let output = evaluate(&mut wheelset, &input);
    let [right, left] = output.guiding.sides;
    assert!(right.guiding_force > 1e3, "the right flange pushes outwards");
    assert!(left.guiding_force > 0.0, "a cone pushes outwards");
    let same = |a: f64, b: f64| assert!((a - b).abs() <= 0.0, "{a} {b}");
    for (side, wrench, outward) in
        [(right, output.sides[RIGHT].rails[0], 1.0), (left, output.sides[LEFT].rails[0], -1.0)]
    {
        same(side.guiding_force, outward * wrench.force[1]);
        same(side.vertical_force, wrench.force[2]);
        same(side.quotient, side.guiding_force / side.vertical_force);
    }
    same(output.guiding.track_shifting_force, -output.wheelset.force[1]);
    input.wheelset.position[2] = -0.6;
    same(evaluate(&mut wheelset, &input).guiding.sides[LEFT].quotient, 0.0);
}

#[test]
fn irregularities_over_the_station_are_those_of_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("track.csv");
    // Parabolas, which splines through their points meet away from the ends.
    let line = |s: f64| [3e-4 * s * s, 2e-5 * s * s, -2e-4 * s * s, 1e-5 * s * s];
    let mut text = String::from("station_m,right_y_mm,right_z_mm,left_y_mm,left_z_mm\n");
    for i in -80..=80 {
        let s = 0.05 * f64::from(i);
        let [a, b, c, d] = line(s).map(|value| 1e3 * value);
        text += &format!("{s},{a},{b},{c},{d}\n");
    }
    std::fs::write(&file, text).unwrap();
    let irregularity_file = file.display().to_string();
    let parameters = Parameters { irregularity_file, ..Parameters::default() };
    let mut on_file = wheelset(&parameters);
    let mut given = wheelset(&Parameters::default());
    let mut input = rolling(&given);
    input.track_s = 0.7;
    input.wheelset.position[0] = 0.2;
    let mut expected = input;
    let (s, [a, b, c, d]) = (0.9, line(1.0));
    for (side, [y, z]) in expected.sides.iter_mut().zip([[a, b], [c, d]]) {
        side.line =
            RailLine { y: y * s * s, z: z * s * s, y_slope: 2.0 * y * s, z_slope: 2.0 * z * s };
    }
    let (found, expected) = (evaluate(&mut on_file, &input), evaluate(&mut given, &expected));
    for (a, b) in components(&found.wheelset).zip(components(&expected.wheelset)) {
        assert!((a - b).abs() < 1e-6 * 1e5, "{a} {b}");
    }
    // By the station.
    let mut along = Input::at_rest();
    along.track_s = 1.0;
    let mut rates = Output::default();
    on_file.directional_derivative(&input, &along, &mut rates).unwrap();
    let step = 1e-4;
    let [before, after] = [-step, step].map(|step| {
        let input = Input { track_s: input.track_s + step, ..input };
        evaluate(&mut on_file, &input).wheelset
    });
    let size = largest(components(&rates.wheelset));
    for ((a, b), rate) in
        components(&before).zip(components(&after)).zip(components(&rates.wheelset))
    {
        assert!(((b - a) / (2.0 * step) - rate).abs() < 1e-3 * size, "{a} {b} {rate}");
    }
    let wrong = Parameters { irregularity_file: "none.csv".into(), ..Parameters::default() };
    let error = Wheelset::new(&wrong, &Input::default(), &[]).unwrap_err().to_string();
    assert!(error.contains("track.irregularity.file") && error.contains("none.csv"), "{error}");
}

#[test]
fn what_no_track_can_do_is_refused_by_name() {
    let mut wheelset = wheelset(&Parameters::default());
    let fine = rolling(&wheelset);
    let mut refuse = |change: &dyn Fn(&mut Input), message: &str| {
        let mut input = fine;
        change(&mut input);
        let mut output = Output::default();
        let error = wheelset.evaluate(&input, &mut output).unwrap_err().to_string();
        assert!(error.contains(message), "{error}");
        assert_eq!(output, Output::default());
    };
    refuse(&|input| input.track.twist = 1.01 * MAX_TURN, "track.twist = 0.101");
    refuse(&|input| input.track.curvature = f64::NAN, "track.curvature = NaN");
    refuse(&|input| input.track.vertical_curvature = -1.0, "track.vertical_curvature = -1");
    refuse(
        &|input| input.sides[LEFT].line.y_slope = -2.0 * MAX_SLOPE,
        "left.irregularity.y_slope = -0.2",
    );
    refuse(&|input| input.sides[RIGHT].line.z = f64::INFINITY, "right.irregularity.z = inf");
    refuse(
        &|input| input.sides[RIGHT].own_pitch_rate = f64::NAN,
        "right.wheel.own_pitch_rate = NaN",
    );
}
