//! The element at rest, forwards, backwards, locked and spinning; damping.

use crate::common::random::Random;
use crate::common::vectors::dot;
use crate::common::wheel::{
    element, evaluate, plain_parameters, pressed, rail_marker, random_input, rolling, the_patch,
};
use crate::tolerance;
use wheelrail::element::parameters::{Flexibilities, NormalModel};
use wheelrail::element::{Element, Input, Parameters};
use wheelrail::normal::damping::{REFERENCE_PENETRATION, REFERENCE_STIFFNESS};

#[test]
fn the_running_direction_changes_the_leading_edge_alone() {
    // A cylinder on a crown has no spin: the same slip both ways gives the same force, and the
    // opposite moment. Of one contact point: the nodes of strips are not those of a mirror image.
    let mut parameters = plain_parameters("cylindrical", "arc:0.3");
    parameters.normal_model = NormalModel::PiotrowskiKik;
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
        for (k, (force, expected)) in patch.creep_force.iter().zip(expected).enumerate() {
            let share = force / limit;
            let miss = (share - expected).abs();
            assert!(miss < tolerance::SLIDING_DIRECTION, "{name}: {share} for {k}: {patch:?}");
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
                let most = tolerance::most_friction(false, patch.penetration);
                let limit = most * input.friction * patch.normal_force;
                let [longitudinal, lateral, spin] = patch.creepage;
                let power = -(patch.creep_force[0] * longitudinal
                    + patch.creep_force[1] * lateral
                    + patch.spin_moment * spin);
                assert!(power.is_finite() && power >= 0.0, "{power}: {patch:?} {input:?}");
                let force = patch.creep_force[0].hypot(patch.creep_force[1]);
                assert!(force <= limit, "{force} of {limit}");
                let share = patch.slip_share;
                assert!((0.0..=1.0).contains(&share), "{share}");
            }
        }
    }
}

/// Greatest change of the creep force between steps while the speed runs from -1 to 1 cm/s in
/// `count` steps.
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

/// Share of the damping that is there at a penetration [m].
fn onset(penetration: f64) -> f64 {
    let ratio = penetration / REFERENCE_PENETRATION;
    ratio * ratio / (1.0 + ratio * ratio)
}

#[test]
fn damping_follows_its_law_and_never_pulls() {
    // Of one plane: the parts of a curved patch press on more than their resultant.
    let mut parameters = plain_parameters("cylindrical", "arc:0.3");
    parameters.normal_model = NormalModel::PiotrowskiKik;
    let coefficient = parameters.damping;
    let mut element = element(&parameters);
    let top = rail_marker(&parameters)[1];
    let at = pressed(&mut element, &rolling(top - 0.75, 20.0), 8e-5);
    let still = the_patch(&evaluate(&mut element, &at));
    let stiffness = 1.5 * still.normal_force / still.penetration;
    let c = coefficient * (stiffness / REFERENCE_STIFFNESS).sqrt() * onset(still.penetration);
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

/// Where everything is after `time` seconds at the velocities of `input`.
fn after(input: &Input, time: f64) -> Input {
    let mut later = *input;
    let wheel = &mut later.wheel;
    for (place, speed) in wheel.position.iter_mut().zip(wheel.velocity) {
        *place += time * speed;
    }
    wheel.roll += time * wheel.roll_rate;
    wheel.yaw += time * wheel.yaw_rate;
    let rail = &mut later.rails[0];
    rail.y += time * rail.vy;
    rail.z += time * rail.vz;
    rail.roll += time * rail.roll_rate;
    later
}

#[test]
fn damping_knows_how_fast_the_penetration_grows() {
    let parameters = Parameters { normal_model: NormalModel::Hertz, ..Parameters::default() };
    let still = Parameters { damping: 0.0, ..parameters.clone() };
    let (mut damped, mut elastic) = (element(&parameters), element(&still));
    let mut random = Random::new(12);
    let (mut judged, mut flanges) = (0, 0);
    for _ in 0..300 {
        let input = random_input(&mut damped, &mut random);
        let time = 1e-7;
        let all = [-time, 0.0, time].map(|t| evaluate(&mut elastic, &after(&input, t)));
        let output = evaluate(&mut damped, &input);
        if output.patch_count != 1 || all.iter().any(|o| o.patch_count != 1) {
            continue;
        }
        let [before, now, next] = all.map(|o| o.patches[0]);
        let growth = (next.penetration - before.penetration) / (2.0 * time);
        let stiffness = 1.5 * now.normal_force / now.penetration;
        let c =
            parameters.damping * (stiffness / REFERENCE_STIFFNESS).sqrt() * onset(now.penetration);
        let load = output.patches[0].normal_force;
        if load <= 0.0 || now.normal_force < 100.0 {
            continue;
        }
        let closing = (load - now.normal_force) / c;
        judged += 1;
        flanges += i32::from(now.contact_angle < -0.7);
        let miss = (closing - growth).abs();
        assert!(miss < tolerance::CLOSING_SPEED, "{closing} against {growth}: {now:?} {input:?}");
    }
    assert!(judged > 150 && flanges > 20, "{judged}, {flanges}");
}

/// Wheels that yaw and roll on the flange and on the tread, by every normal model, pressed until
/// they carry tens of kilonewtons.
fn for_each_frictionless(mut each: impl FnMut(&mut Element, &Parameters, &Input, NormalModel)) {
    use NormalModel::{BoundaryElement, Hertz, PiotrowskiKik, PiotrowskiKikCorrected, Strips};
    for normal_model in [Hertz, PiotrowskiKik, PiotrowskiKikCorrected, Strips, BoundaryElement] {
        let parameters = Parameters {
            normal_model,
            normal_elements: [16, 16],
            damping: 0.0,
            ..Parameters::default()
        };
        let mut element = element(&parameters);
        for yaw in [5e-3, -5e-3, 0.025, -0.025] {
            for shift in [0.0, 5e-3, 7.5e-3] {
                for roll in [0.0, 4e-3, -0.02] {
                    let mut input = rolling(shift, 20.0);
                    (input.wheel.yaw, input.wheel.roll, input.friction) = (yaw, roll, 0.0);
                    let input = pressed(&mut element, &input, 1.5e-4);
                    each(&mut element, &parameters, &input, normal_model);
                }
            }
        }
    }
}

#[test]
fn the_normal_force_has_no_moment_about_the_axle() {
    let mut greatest_angle = 0f64;
    for_each_frictionless(|element, parameters, input, model| {
        let output = evaluate(element, input);
        let force: f64 = output.patches.iter().map(|patch| patch.normal_force).sum();
        assert!(force > 1e3, "{input:?}");
        greatest_angle =
            output.patches.iter().fold(greatest_angle, |a, p| a.max(p.contact_angle.abs()));
        let (sin_roll, cos_roll) = input.wheel.roll.sin_cos();
        let (sin_yaw, cos_yaw) = input.wheel.yaw.sin_cos();
        let moment = dot(output.wheel.moment, [-sin_yaw, cos_yaw * cos_roll, cos_yaw * sin_roll]);
        let bound = 1e-9 * force * parameters.wheel.nominal_radius;
        assert!(moment.abs() <= bound, "{model:?}: {moment} N m of {force} N at {input:?}");
    });
    assert!(greatest_angle.to_degrees() > 65.0, "{greatest_angle}");
}

#[test]
fn a_frictionless_wheel_takes_as_much_power_as_its_contact_gives_back() {
    // Steady rolling feeds nothing; a motion that presses the bodies together stores what the
    // normal forces take by the way along them.
    for_each_frictionless(|element, _, input, model| {
        let mut input = *input;
        for (sideways, down) in [(0.0, 0.0), (0.03, -0.02)] {
            (input.wheel.velocity[1], input.wheel.velocity[2]) = (sideways, down);
            let output = evaluate(element, &input);
            let wheel = &input.wheel;
            let (sin_roll, cos_roll) = wheel.roll.sin_cos();
            let (sin_yaw, cos_yaw) = wheel.yaw.sin_cos();
            let axle = [-sin_yaw, cos_yaw * cos_roll, cos_yaw * sin_roll];
            let turning = axle.map(|part| part * wheel.pitch_rate);
            let power = dot(output.wheel.force, wheel.velocity) + dot(output.wheel.moment, turning);
            let patches = output.patches.iter().filter(|patch| patch.rail > 0);
            let (mut closing, mut scale) = (0.0, 0.0);
            for patch in patches {
                let (sine, cosine) = patch.contact_angle.sin_cos();
                closing += patch.normal_force * (cosine * down - sine * sideways);
                scale += patch.normal_force * 20.0;
            }
            let error = (power + closing).abs();
            assert!(error <= 1e-9 * scale, "{model:?}: {power} W, {closing} W at {input:?}");
            assert!(output.frictional_power.abs() <= 0.0);
        }
    });
}
