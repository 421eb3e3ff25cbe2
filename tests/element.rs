//! Forces and moments of the whole element: balance, points of reduction, symmetry, limits, refusals.

mod common;
mod tolerance;

use std::fmt::Write;

use common::random::Random;
use common::wheel::{element, evaluate, plain_parameters, pressed, random_input, rolling};
use wheelrail::element::output::Patch;
use wheelrail::element::parameters::{Flexibilities, NormalModel, Side, TangentialModel};
use wheelrail::element::{Element, Input, Output, Parameters};
use wheelrail::geometry::placed_rail::PlacedRail;
use wheelrail::geometry::profile::ProfileKind;
use wheelrail::io::load_profile;
use wheelrail::normal::damping::REFERENCE_STIFFNESS;

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

fn add(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| a[i] + b[i])
}

/// Marker of the right rail in design position.
fn rail_marker(parameters: &Parameters) -> [f64; 3] {
    let rail = &parameters.rails[0];
    let profile = load_profile("rail", &rail.profile, ProfileKind::Rail, 0.0, &[]).unwrap();
    let placed = PlacedRail::by_gauge(
        &profile.curve,
        rail.inclination,
        parameters.gauge,
        parameters.gauge_depth,
    );
    let [y, z] = placed.unwrap().marker;
    [0.0, y, z]
}

fn assert_close(found: [f64; 3], expected: [f64; 3], allowed: f64, what: &str) {
    for i in 0..3 {
        let miss = (found[i] - expected[i]).abs();
        assert!(miss <= allowed, "{what}: {found:?}, expected {expected:?}");
    }
}

fn the_patch(output: &Output) -> Patch {
    assert_eq!(output.patch_count, 1, "{output:?}");
    output.patches[0]
}

#[test]
fn wheel_and_rail_push_each_other_with_opposite_wrenches() {
    let parameters = Parameters::default();
    let mut element = element(&parameters);
    let marker = rail_marker(&parameters);
    let mut random = Random::new(3);
    let mut most_patches = 0;
    for _ in 0..300 {
        let input = random_input(&mut element, &mut random);
        let output = evaluate(&mut element, &input);
        most_patches = most_patches.max(output.patch_count);
        let (wheel, rail) = (output.wheel, output.rails[0]);
        let size = dot(wheel.force, wheel.force).sqrt();
        assert_close(add(wheel.force, rail.force), [0.0; 3], tolerance::ROUNDING * size, "force");
        // About a point far from both markers.
        let point = [3.0, -2.0, 1.0];
        let moved = |at: [f64; 3], w: wheelrail::element::output::Wrench| {
            let arm = [0, 1, 2].map(|i| at[i] - point[i]);
            add(w.moment, cross(arm, w.force))
        };
        let rail_at = add(marker, [0.0, input.rails[0].y, input.rails[0].z]);
        let total = add(moved(input.wheel.position, wheel), moved(rail_at, rail));
        assert_close(total, [0.0; 3], 10.0 * tolerance::ROUNDING * size, "moment");
    }
    assert!(most_patches > 1);
}

#[test]
fn the_wrench_is_the_sum_of_the_patches_at_their_positions() {
    let mut element = element(&Parameters::default());
    let mut random = Random::new(4);
    for _ in 0..300 {
        let input = random_input(&mut element, &mut random);
        let output = evaluate(&mut element, &input);
        let (mut force, mut moment) = ([0.0; 3], [0.0; 3]);
        for patch in &output.patches[..output.patch_count as usize] {
            let (sine, cosine) = patch.contact_angle.sin_cos();
            let [along, across] = patch.creep_force;
            let normal = [0.0, -sine, cosine];
            let on_wheel = [
                along,
                across * cosine - patch.normal_force * normal[1],
                across * sine - patch.normal_force * normal[2],
            ];
            let arm = [0, 1, 2].map(|i| patch.position[i] - input.wheel.position[i]);
            force = add(force, on_wheel);
            moment = add(moment, cross(arm, on_wheel));
            moment = add(moment, normal.map(|n| n * patch.spin_moment));
        }
        let size = dot(force, force).sqrt();
        assert_close(output.wheel.force, force, 10.0 * tolerance::ROUNDING * size, "force");
        assert_close(output.wheel.moment, moment, 10.0 * tolerance::ROUNDING * size, "moment");
    }
}

#[test]
fn moments_of_a_cylinder_on_a_crowned_rail_are_those_worked_out_by_hand() {
    let parameters = plain_parameters("cylindrical", "arc:0.3");
    let mut element = element(&parameters);
    let top = rail_marker(&parameters)[1];
    let (radius, depth, aside) = (0.46, 5e-5, 0.012);
    // The running circle stands 12 mm to the field side of the crown; the wheel brakes and drifts outwards.
    let mut input = rolling(top + aside - 0.75, 20.0);
    input.wheel.position[0] = 0.3;
    input.wheel.velocity[1] = 0.05;
    input.wheel.pitch_rate *= 0.998;
    let input = pressed(&mut element, &input, depth);
    assert!((input.wheel.position[2] + radius - depth).abs() < tolerance::TOUCHING_HEIGHT);
    let output = evaluate(&mut element, &input);
    let patch = the_patch(&output);
    let [fx, fy, fz] = output.wheel.force;
    assert!(fx < -1e3 && fy < -1e3 && fz < -1e4, "{:?}", output.wheel.force);
    let load = -fz;
    // Contact under the axle, on the crown, at the lowest circle of the wheel.
    let arm = [0.0, -aside, radius];
    let expected = add(cross(arm, [fx, fy, -load]), [0.0, 0.0, patch.spin_moment]);
    let allowed = tolerance::CONTACT_PLACE * load;
    assert_close(output.wheel.moment, expected, allowed, "about the wheel marker");
    // Written out: braking turns the wheel backwards, the load tips it outwards about x.
    let by_hand = [aside * load - radius * fy, radius * fx, aside * fx + patch.spin_moment];
    assert_close(output.wheel.moment, by_hand, allowed, "by hand");
    // On the rail the same forces act at the crown, within the depth from its marker, with the marker under the wheel's x.
    let on_rail = [depth * fy, -input.wheel.position[0] * load - depth * fx, 0.3 * -fy];
    let on_rail = add(on_rail, [0.0, 0.0, -patch.spin_moment]);
    assert_close(output.rails[0].moment, on_rail, allowed, "about the rail marker");
}

#[test]
fn moments_of_a_cone_on_a_crowned_rail_are_those_worked_out_by_hand() {
    let tangent = 0.05f64;
    let mut parameters = plain_parameters("conical:0.05", "arc:0.3");
    parameters.tangential_model = TangentialModel::None;
    let mut element = element(&parameters);
    let top = rail_marker(&parameters)[1];
    // A rail that stands 3 mm further out and 2 mm deeper.
    let mut input = rolling(top - 0.75, 20.0);
    (input.rails[0].y, input.rails[0].z) = (3e-3, 2e-3);
    let input = pressed(&mut element, &input, 5e-5);
    let output = evaluate(&mut element, &input);
    let patch = the_patch(&output);
    let angle = -tangent.atan();
    assert!((patch.contact_angle - angle).abs() < tolerance::CONE_ANGLE);
    let load = patch.normal_force;
    // The cone pushes its wheel towards the track centre.
    let force = [0.0, load * angle.sin(), -load * angle.cos()];
    assert_close(output.wheel.force, force, tolerance::CONE_ANGLE * load, "force");
    // The rail's crown has the slope of the cone 15 mm inside of its top.
    let from_top = [0.0, 0.3 * angle.sin(), 0.3 * (1.0 - angle.cos())];
    let allowed = tolerance::CONTACT_PLACE * load;
    let rail_moment = cross(from_top, force.map(|f| -f));
    assert_close(output.rails[0].moment, rail_moment, allowed, "rail");
    let place = add(from_top, [0.0, top + 3e-3, 2e-3]);
    let arm = [0, 1, 2].map(|i| place[i] - input.wheel.position[i]);
    assert_close(output.wheel.moment, cross(arm, force), allowed, "wheel");
    // The rolling radius is that of the cone at the contact.
    let rolling_radius = 0.46 - tangent * arm[1];
    assert!((patch.rolling_radius - rolling_radius).abs() < tolerance::CONTACT_PLACE);
}

#[test]
fn a_driving_torque_balances_the_longitudinal_force_times_the_rolling_radius() {
    let mut element = element(&Parameters::default());
    let mut input = rolling(0.0, 20.0);
    input.wheel.pitch_rate *= 1.003;
    let input = pressed(&mut element, &input, 6e-5);
    let output = evaluate(&mut element, &input);
    let patch = the_patch(&output);
    // A wheel driven forward is pushed forward; the rail brakes its turning, which is negative.
    assert!(output.wheel.force[0] > 0.0 && output.wheel.moment[1] > 0.0);
    let torque = patch.rolling_radius * output.wheel.force[0];
    let rest = output.wheel.moment[1] - torque;
    // What is left: overlap, and the share of the spin moment in a contact inclined by a few degrees.
    assert!(rest.abs() < tolerance::AXLE_MOMENT * torque, "{rest} of {torque}");
}

/// The inputs of a left wheel that is the mirror image of a right one.
fn mirrored(input: &Input) -> Input {
    let mut left = *input;
    let wheel = &mut left.wheel;
    for value in [
        &mut wheel.position[1],
        &mut wheel.velocity[1],
        &mut wheel.roll,
        &mut wheel.yaw,
        &mut wheel.roll_rate,
        &mut wheel.yaw_rate,
    ] {
        *value = -*value;
    }
    for rail in &mut left.rails {
        for value in [&mut rail.y, &mut rail.roll, &mut rail.vy, &mut rail.roll_rate] {
            *value = -*value;
        }
    }
    left
}

#[test]
fn the_left_side_is_the_mirror_image_of_the_right_bit_for_bit() {
    let left_parameters = Parameters { side: Side::Left, ..Parameters::default() };
    let mut right = element(&Parameters::default());
    let mut left = Element::new(&left_parameters, &mirrored(&Input::default()), &[]).unwrap();
    assert_eq!(left.nominal_wheel_z().to_bits(), right.nominal_wheel_z().to_bits());
    let mut random = Random::new(5);
    let same = |a: f64, b: f64| assert!((a - b).abs() <= 0.0, "{a} and {b}");
    for _ in 0..200 {
        let input = random_input(&mut right, &mut random);
        let (r, l) = (evaluate(&mut right, &input), evaluate(&mut left, &mirrored(&input)));
        for (r, l) in [(r.wheel, l.wheel), (r.rails[0], l.rails[0])] {
            for (i, sign) in [1.0, -1.0, 1.0].into_iter().enumerate() {
                same(l.force[i], sign * r.force[i]);
                same(l.moment[i], -sign * r.moment[i]);
            }
        }
        assert_eq!(l.patch_count, r.patch_count);
        same(l.wear_number, r.wear_number);
        for (r, l) in r.patches.iter().zip(&l.patches) {
            same(l.normal_force, r.normal_force);
            same(l.creep_force[0], r.creep_force[0]);
            same(l.creep_force[1], -r.creep_force[1]);
            same(l.spin_moment, -r.spin_moment);
            same(l.contact_angle, -r.contact_angle);
            same(l.position[0], r.position[0]);
            same(l.position[1], -r.position[1]);
            same(l.creepage[0], r.creepage[0]);
            same(l.creepage[1], -r.creepage[1]);
            same(l.creepage[2], -r.creepage[2]);
            same(l.rail_y, r.rail_y);
            same(l.max_pressure, r.max_pressure);
        }
    }
}

/// The same motion seen in a mirror across the track.
fn reversed(input: &Input) -> Input {
    let mut back = *input;
    let wheel = &mut back.wheel;
    for value in [
        &mut wheel.position[0],
        &mut wheel.velocity[0],
        &mut wheel.yaw,
        &mut wheel.yaw_rate,
        &mut wheel.pitch_rate,
    ] {
        *value = -*value;
    }
    back
}

#[test]
fn running_backwards_is_the_mirror_image_across_the_track() {
    let mut element = element(&Parameters::default());
    let mut random = Random::new(6);
    for _ in 0..200 {
        let input = random_input(&mut element, &mut random);
        let (forth, back) =
            (evaluate(&mut element, &input), evaluate(&mut element, &reversed(&input)));
        let [fx, fy, fz] = forth.wheel.force;
        let [mx, my, mz] = forth.wheel.moment;
        let allowed = tolerance::MIRRORED * dot([fx, fy, fz], [fx, fy, fz]).sqrt();
        assert_close(back.wheel.force, [-fx, fy, fz], allowed, "force");
        assert_close(back.wheel.moment, [mx, -my, -mz], allowed, "moment");
    }
}

#[test]
fn the_running_direction_changes_the_leading_edge_alone() {
    // A cylinder on a crown has no spin: the same slip both ways gives the same force, and the opposite moment.
    let parameters = plain_parameters("cylindrical", "arc:0.3");
    let mut element = element(&parameters);
    let top = rail_marker(&parameters)[1];
    let (speed, slip) = (20.0, [0.02, -0.015]);
    let mut run = |speed: f64| {
        let mut input = rolling(top - 0.75, speed);
        input.wheel.velocity[0] += slip[0];
        input.wheel.velocity[1] = slip[1];
        let input = pressed(&mut element, &input, 5e-5);
        let output = evaluate(&mut element, &input);
        the_patch(&output)
    };
    let (forth, back) = (run(speed), run(-speed));
    let limit = 0.3 * forth.normal_force;
    for k in 0..2 {
        assert!(forth.creep_force[k].abs() > 0.1 * limit, "{forth:?}");
        let change = (forth.creep_force[k] - back.creep_force[k]).abs();
        // The reference speeds differ by the slip over the speed.
        assert!(change < tolerance::REFERENCE_SPEED * limit, "{forth:?} and {back:?}");
    }
    assert!(forth.spin_moment.abs() > 0.0);
    let sum = (forth.spin_moment + back.spin_moment).abs();
    assert!(sum < tolerance::REFERENCE_SPEED * forth.spin_moment.abs(), "{forth:?} and {back:?}");
}

#[test]
fn a_wheel_at_rest_has_no_creep_force_and_a_sliding_one_all_of_it() {
    let mut element = element(&Parameters::default());
    let at = pressed(&mut element, &Input::default(), 6e-5);
    let rest = the_patch(&evaluate(&mut element, &at));
    assert!(rest.creep_force.iter().all(|f| f.abs() <= 0.0), "{rest:?}");
    let limit = 0.3 * rest.normal_force;
    for (name, velocity, pitch_rate, expected) in [
        ("locked", [20.0, 0.0], 0.0, [-1.0, 0.0]),
        ("locked, backwards", [-20.0, 0.0], 0.0, [1.0, 0.0]),
        ("spinning on the spot", [0.0, 0.0], -40.0, [1.0, 0.0]),
        ("spinning backwards", [0.0, 0.0], 40.0, [-1.0, 0.0]),
        ("spinning against its motion", [-5.0, 0.0], -40.0, [1.0, 0.0]),
        ("pushed outwards at rest", [0.0, 0.05], 0.0, [0.0, -1.0]),
        ("pushed inwards at rest", [0.0, -0.05], 0.0, [0.0, 1.0]),
    ] {
        let mut input = at;
        input.wheel.velocity = [velocity[0], velocity[1], 0.0];
        input.wheel.pitch_rate = pitch_rate;
        let patch = the_patch(&evaluate(&mut element, &input));
        let limit = 0.3 * patch.normal_force;
        for (force, expected) in patch.creep_force.into_iter().zip(expected) {
            let share = force / limit;
            let miss = (share - expected).abs();
            assert!(
                miss < tolerance::SLIDING_DIRECTION,
                "{name}: {share}, not {expected}: {patch:?}"
            );
        }
        assert!(patch.slip_share > 0.95, "{name}: {patch:?}");
    }
    assert!(limit > 1e3);
}

#[test]
fn creep_power_is_never_negative_whatever_the_wheel_does() {
    for flexibilities in [Flexibilities::Three, Flexibilities::Blended] {
        let mut element = element(&Parameters { flexibilities, ..Parameters::default() });
        let mut random = Random::new(7);
        for index in 0..600 {
            let mut input = random_input(&mut element, &mut random);
            if index % 3 == 0 {
                // Locked, spinning, hardly moving.
                input.wheel.pitch_rate = random.about(60.0) * random.within(0.0, 1.0).powi(8);
                input.wheel.velocity[0] = random.about(30.0) * random.within(0.0, 1.0).powi(8);
            }
            let output = evaluate(&mut element, &input);
            for patch in &output.patches[..output.patch_count as usize] {
                let limit = input.friction * patch.normal_force;
                let [longitudinal, lateral, spin] = patch.creepage;
                let power = -(patch.creep_force[0] * longitudinal
                    + patch.creep_force[1] * lateral
                    + patch.spin_moment * spin);
                assert!(power.is_finite() && power >= 0.0, "{power}: {patch:?} {input:?}");
                let force = patch.creep_force[0].hypot(patch.creep_force[1]);
                assert!(force <= limit * (1.0 + tolerance::ROUNDING), "{force} of {limit}");
                let share = patch.slip_share;
                assert!((0.0..=1.0).contains(&share), "{share}");
            }
        }
    }
}

/// Greatest change of the creep force between steps while the speed runs from -1 to 1 cm/s in `count` steps.
fn greatest_change(element: &mut Element, at: &Input, count: u32) -> f64 {
    let mut before: Option<[f64; 3]> = None;
    let mut greatest: f64 = 0.0;
    for i in 0..=count {
        let speed = 0.02 * (f64::from(i) / f64::from(count) - 0.5);
        let mut input = *at;
        input.wheel.velocity = [speed, 1e-6, 0.0];
        input.wheel.pitch_rate = -1.002 * speed / 0.46;
        let force = evaluate(element, &input).wheel.force;
        if let Some(before) = before {
            let change = [0, 1, 2].map(|k| force[k] - before[k]);
            greatest = greatest.max(dot(change, change).sqrt());
        }
        before = Some(force);
    }
    greatest
}

#[test]
fn forces_are_continuous_where_the_running_direction_changes() {
    let mut element = element(&Parameters::default());
    let at = pressed(&mut element, &Input::default(), 6e-5);
    let (coarse, fine) =
        (greatest_change(&mut element, &at, 1000), greatest_change(&mut element, &at, 4000));
    assert!(coarse > 0.0);
    // A jump would stay as large; a steep slope shrinks with the step.
    assert!(
        fine < tolerance::SHRINKING * coarse,
        "{coarse} N, with a quarter of the step {fine} N"
    );
}

#[test]
fn damping_follows_its_law_and_never_pulls() {
    let parameters = plain_parameters("cylindrical", "arc:0.3");
    let coefficient = parameters.damping;
    let mut element = element(&parameters);
    let top = rail_marker(&parameters)[1];
    let at = pressed(&mut element, &rolling(top - 0.75, 20.0), 8e-5);
    let still = the_patch(&evaluate(&mut element, &at));
    let stiffness = 1.5 * still.normal_force / still.penetration;
    let c = coefficient * (stiffness / REFERENCE_STIFFNESS).sqrt();
    for closing in [-0.3, -0.02, 0.02, 0.3] {
        let mut input = at;
        input.wheel.velocity[2] = closing;
        let patch = the_patch(&evaluate(&mut element, &input));
        let expected = (still.normal_force + c * closing).max(0.0);
        let miss = (patch.normal_force - expected).abs();
        assert!(miss < tolerance::ROUNDING * expected.max(1.0), "{patch:?}, expected {expected}");
        // A rail that moves the same way closes nothing.
        input.rails[0].vz = closing;
        let patch = the_patch(&evaluate(&mut element, &input));
        let miss = (patch.normal_force - still.normal_force).abs();
        assert!(miss < tolerance::ROUNDING * still.normal_force);
    }
    let mut input = at;
    input.wheel.velocity[2] = -50.0;
    let parting = evaluate(&mut element, &input);
    assert!(parting.wheel.force.iter().all(|f| f.abs() <= 0.0), "{:?}", parting.wheel);
}

#[test]
fn work_that_is_not_asked_for_is_not_done() {
    let cases = [
        ("no friction", Parameters::default(), 0.0),
        (
            "no tangential model",
            Parameters { tangential_model: TangentialModel::None, ..Parameters::default() },
            0.3,
        ),
    ];
    for (name, parameters, friction) in cases {
        let mut element = element(&parameters);
        let mut input = pressed(&mut element, &rolling(0.0, 20.0), 6e-5);
        input.wheel.velocity[1] = 0.1;
        input.friction = friction;
        let patch = the_patch(&evaluate(&mut element, &input));
        let work = element.work();
        assert_eq!((work.marches, work.zones, work.searches), (0, 1, 1), "{name}");
        assert!(patch.creep_force.iter().all(|f| f.abs() <= 0.0));
    }
    let mut element = element(&Parameters::default());
    let lifted = pressed(&mut element, &rolling(0.0, 20.0), -1e-3);
    let output = evaluate(&mut element, &lifted);
    let work = element.work();
    assert_eq!((work.lifted, work.searches, work.distances), (1, 0, 0));
    assert_eq!(output, Output::default());
}

#[test]
fn an_evaluation_depends_on_its_input_alone() {
    for normal_model in [NormalModel::PiotrowskiKik, NormalModel::Hertz] {
        let mut element = element(&Parameters { normal_model, ..Parameters::default() });
        let mut random = Random::new(8);
        let inputs: Vec<Input> = (0..60).map(|_| random_input(&mut element, &mut random)).collect();
        // The text of a number tells its bits, and the sign of a zero too.
        let first: Vec<String> =
            inputs.iter().map(|i| format!("{:?}", evaluate(&mut element, i))).collect();
        for (input, expected) in inputs.iter().zip(&first).rev() {
            assert_eq!(&format!("{:?}", evaluate(&mut element, input)), expected);
        }
        let mut copy = element.clone();
        for (input, expected) in inputs.iter().zip(&first) {
            assert_eq!(&format!("{:?}", evaluate(&mut copy, input)), expected);
        }
    }
}

#[test]
fn an_input_that_is_no_number_is_refused_by_name_and_leaves_the_output() {
    type Place = fn(&mut Input) -> &mut f64;
    let places: [(&str, Place); 20] = [
        ("wheel.x", |i| &mut i.wheel.position[0]),
        ("wheel.y", |i| &mut i.wheel.position[1]),
        ("wheel.z", |i| &mut i.wheel.position[2]),
        ("wheel.roll", |i| &mut i.wheel.roll),
        ("wheel.yaw", |i| &mut i.wheel.yaw),
        ("wheel.pitch", |i| &mut i.wheel.pitch),
        ("wheel.vx", |i| &mut i.wheel.velocity[0]),
        ("wheel.vy", |i| &mut i.wheel.velocity[1]),
        ("wheel.vz", |i| &mut i.wheel.velocity[2]),
        ("wheel.roll_rate", |i| &mut i.wheel.roll_rate),
        ("wheel.yaw_rate", |i| &mut i.wheel.yaw_rate),
        ("wheel.pitch_rate", |i| &mut i.wheel.pitch_rate),
        ("rail[1].y", |i| &mut i.rails[0].y),
        ("rail[1].z", |i| &mut i.rails[0].z),
        ("rail[1].roll", |i| &mut i.rails[0].roll),
        ("rail[1].vy", |i| &mut i.rails[0].vy),
        ("rail[1].vz", |i| &mut i.rails[0].vz),
        ("rail[1].roll_rate", |i| &mut i.rails[0].roll_rate),
        ("track.s", |i| &mut i.track_s),
        ("friction.coefficient", |i| &mut i.friction),
    ];
    let mut element = element(&Parameters::default());
    let input = pressed(&mut element, &rolling(0.0, 20.0), 6e-5);
    let before = evaluate(&mut element, &input);
    for (name, place) in places {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut wrong = input;
            *place(&mut wrong) = bad;
            let mut output = before;
            let message = element.evaluate(&wrong, &mut output).unwrap_err().to_string();
            assert!(message.contains(name), "{message}");
            assert_eq!(output, before);
        }
    }
    let mut wrong = input;
    wrong.friction = -0.1;
    let message = element.evaluate(&wrong, &mut Output::default()).unwrap_err().to_string();
    assert!(message.contains("friction.coefficient") && message.contains("-0.1"), "{message}");
    assert_eq!(evaluate(&mut element, &input), before);
}

#[test]
fn a_wrong_parameter_is_refused_by_name_and_value() {
    type Change = fn(&mut Parameters);
    let wrong: [(&str, &str, Change); 16] = [
        ("wheel.nominal_radius", "-0.46", |p| p.wheel.nominal_radius = -0.46),
        ("wheel.nominal_radius", "NaN", |p| p.wheel.nominal_radius = f64::NAN),
        ("wheel.young_modulus", "0", |p| p.wheel.young_modulus = 0.0),
        ("wheel.poisson_ratio", "0.6", |p| p.wheel.poisson_ratio = 0.6),
        ("rail.young_modulus", "inf", |p| p.rail_young_modulus = f64::INFINITY),
        ("rail.poisson_ratio", "-0.1", |p| p.rail_poisson_ratio = -0.1),
        ("rail[1].inclination", "40", |p| p.rails[0].inclination = 40.0),
        ("track.gauge", "0", |p| p.gauge = 0.0),
        ("track.gauge_depth", "-0.014", |p| p.gauge_depth = -0.014),
        ("profile.smoothing", "-1", |p| p.profile_smoothing = -1.0),
        ("normal.virtual_penetration", "1", |p| p.virtual_penetration = 1.0),
        ("normal.strips", "3", |p| p.strips = 3),
        ("normal.damping", "-1", |p| p.damping = -1.0),
        ("creepage.minimum_speed", "0", |p| p.minimum_speed = 0.0),
        ("tangential.elements_along", "201", |p| p.elements_along = 201),
        ("wheel.profile", "no_such_wheel", |p| p.wheel.profile = "no_such_wheel".into()),
    ];
    for (name, value, change) in wrong {
        let mut parameters = Parameters::default();
        change(&mut parameters);
        let message = Element::new(&parameters, &Input::default(), &[]).unwrap_err().to_string();
        assert!(message.contains(name) && message.contains(value), "{name}: {message}");
    }
}

/// Greatest second difference of the wheel's force over 100 steps of `change`, over the force.
fn roughness(element: &mut Element, input: &Input, change: fn(&mut Input, f64)) -> f64 {
    let forces: Vec<[f64; 3]> = (0..100)
        .map(|i| {
            let mut moved = *input;
            change(&mut moved, 1e-9 * f64::from(i));
            evaluate(element, &moved).wheel.force
        })
        .collect();
    let second = |f: &[[f64; 3]], k: usize| (f[0][k] - 2.0 * f[1][k] + f[2][k]).abs();
    let greatest = forces.windows(3).flat_map(|f| [0, 1, 2].map(|k| second(f, k)));
    greatest.fold(0.0, f64::max) / dot(forces[0], forces[0]).sqrt()
}

#[test]
fn forces_of_one_patch_are_smooth_down_to_steps_of_a_nanometre_and_a_nanoradian() {
    let directions: [(&str, fn(&mut Input, f64)); 4] = [
        ("y", |i, h| i.wheel.position[1] += h),
        ("z", |i, h| i.wheel.position[2] += h),
        ("roll", |i, h| i.wheel.roll += h),
        ("yaw", |i, h| i.wheel.yaw += h),
    ];
    let mut report =
        String::from("model,direction,shift_mm,yaw_mrad,depth_um,angle_deg,roughness\n");
    for normal_model in [NormalModel::PiotrowskiKik, NormalModel::Hertz] {
        let mut element = element(&Parameters { normal_model, ..Parameters::default() });
        let mut random = Random::new(9);
        let mut all = Vec::new();
        let mut flanges = 0;
        for _ in 0..150 {
            let mut input = rolling(random.within(-6e-3, 9e-3), 20.0);
            (input.wheel.roll, input.wheel.yaw) = (random.about(3e-3), random.about(0.02));
            let depth = random.within(2e-5, 1e-4);
            let at = pressed(&mut element, &input, depth);
            let output = evaluate(&mut element, &at);
            if output.patch_count != 1 {
                continue;
            }
            let angle = output.patches[0].contact_angle;
            flanges += u32::from(angle < -0.7);
            for (direction, change) in directions {
                let found = roughness(&mut element, &at, change);
                let (shift, yaw) = (1e3 * (at.wheel.position[1] - 0.75), 1e3 * at.wheel.yaw);
                let (depth, angle) = (1e6 * depth, angle.to_degrees());
                writeln!(
                    report,
                    "{normal_model:?},{direction},{shift:.3},{yaw:.2},{depth:.1},{angle:.2},{found:e}"
                )
                .unwrap();
                all.push(found);
            }
        }
        let [median, worst] = common::median_and_worst(all);
        println!("{normal_model:?}: roughness {median:e} in the median, {worst:e} at worst");
        assert!(flanges > 10, "{flanges} flange contacts are too few");
        assert!(worst < tolerance::ROUGHNESS, "{normal_model:?}: {worst:e}\n{report}");
    }
    common::write_report("roughness.csv", &report);
}
