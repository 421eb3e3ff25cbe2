//! Pressures and tractions that contacts remember, and the stresses below them.

use super::*;
use crate::common::wheel::{evaluate, mirrored};
use wheelrail::element::parameters::{Side, VerticalMode};
use wheelrail::planar::ContactField;
use wheelrail::subsurface::{Body, Measure, SurfaceLoad};

/// Normal and creep force of a field [N].
fn forces(field: &ContactField) -> [f64; 3] {
    let area = field.grid.element_area();
    let sum = |c: usize| area * field.traction.iter().map(|p| p[c]).sum::<f64>();
    [area * field.pressure.iter().sum::<f64>(), sum(0), sum(1)]
}

#[test]
fn fields_have_the_forces_that_steps_leave_behind_and_stresses_follow() {
    let parameters = transient(&boundary(16));
    let mut wheel = fresh(&parameters);
    let input = rolling(&parameters, -2e-3, 5e-4, 1e-4, 3e-3);
    let greatest = |field: &ContactField, body| {
        let material = parameters.materials()[usize::from(body == Body::Rail)];
        let load = SurfaceLoad::of_fields(std::slice::from_ref(field), body, material);
        load.greatest(Measure::OrthogonalShear).unwrap().value
    };
    let mut stresses = Vec::new();
    // A millimetre and two more, of the contact's eleven, and a metre.
    for duration in [5e-5, 1e-4, 0.05] {
        let output = advance(&mut wheel, &input, duration);
        let history = wheel.contact_history().unwrap().clone();
        let fields = wheel.remembered_fields(&input).unwrap();
        assert_eq!(*wheel.contact_history().unwrap(), history);
        let ([field], patch) = (&fields[..], &output.patches[0]) else { panic!("one rail") };
        let [load, x, y] = forces(field);
        let limit = patch.friction_coefficient * patch.normal_force;
        assert!((load / patch.normal_force - 1.0).abs() <= 1e-3, "{load} {}", patch.normal_force);
        assert!((x - patch.creep_force[0]).abs() <= 1e-6 * limit, "{x} {}", patch.creep_force[0]);
        assert!((y - patch.creep_force[1]).abs() <= 1e-2 * limit, "{y} {}", patch.creep_force[1]);
        stresses.push([Body::Rail, Body::Wheel].map(|body| greatest(field, body)));
        // An evaluation in between, of other inputs, shows what it has.
        let mut lifted = input;
        lifted.wheel.position[2] -= 3e-5;
        let light = evaluate(&mut wheel, &lifted).patches[0];
        let [load, x, _] = forces(&wheel.remembered_fields(&lifted).unwrap()[0]);
        assert!((load / light.normal_force - 1.0).abs() <= 1e-3);
        assert!((x - light.creep_force[0]).abs() <= 1e-6 * limit);
    }
    // The force builds up, and the stress with it, to that of steady rolling.
    let mut rolled = element(&parameters);
    let steady = rolled.remembered_fields(&input).unwrap();
    let steady = greatest(&steady[0], Body::Rail);
    let rail: Vec<f64> = stresses.iter().map(|[rail, _]| rail / steady).collect();
    println!("{rail:?}");
    assert!(rail[0] < rail[1] && rail[1] < 0.97 * rail[2], "{rail:?}");
    assert!((rail[2] - 1.0).abs() < 1e-3, "{rail:?}");
}

#[test]
fn a_wheel_that_stands_is_shown_without_tractions_and_one_in_the_air_without_fields() {
    let parameters = Parameters { vertical_mode: VerticalMode::Load, ..transient(&boundary(10)) };
    let mut input = rolling(&parameters, 0.0, 2e-3, 1e-4, 1e-3);
    input.wheel_load = 6e4;
    (input.wheel.velocity[0], input.wheel.pitch_rate) = (0.0, 0.0);
    let mut wheel = element(&parameters);
    let fields = wheel.remembered_fields(&input).unwrap();
    let [load, x, y] = forces(&fields[0]);
    assert!((load / 6e4 - 1.0).abs() < 0.01, "{load}");
    assert!(x.hypot(y) <= 0.0, "{x} {y}");
    let mut wheel = element(&transient(&boundary(10)));
    input.wheel.position[2] -= 1e-3;
    assert_eq!(wheel.remembered_fields(&input), Ok(Vec::new()));
}

#[test]
fn each_rail_has_a_field_and_left_wheels_are_seen_as_right_ones() {
    let parameters = transient(&boundary(10));
    let input = rolling(&parameters, 6.3e-3, -5e-3, 1e-4, 5e-4);
    let left = Parameters { side: Side::Left, ..parameters.clone() };
    let (mut right, mut left) = (element(&parameters), element(&left));
    let seen = mirrored(&input);
    for _ in 0..2 {
        advance(&mut right, &input, 1e-4);
        advance(&mut left, &seen, 1e-4);
    }
    let shown = right.remembered_fields(&input).unwrap();
    assert_eq!(left.remembered_fields(&seen).unwrap(), shown);
    // All contacts of a rail are in its field.
    let output = evaluate(&mut right, &input);
    let sum: f64 = output.patches().map(|patch| patch.creep_force[0]).sum();
    let [_, x, _] = forces(&shown[0]);
    assert!((x - sum).abs() <= 1e-6 * limit(&output), "{x} {sum}");
}

#[test]
fn what_shows_steady_rolling_refuses_contacts_that_remember() {
    let parameters = transient(&boundary(10));
    let input = rolling(&parameters, 0.0, 2e-3, 1e-4, 0.0);
    let mut wheel = element(&parameters);
    let flat = wheel.flat_contacts(&input).unwrap();
    let error = parameters.flat_case(&flat[0], 20.0).unwrap_err().to_string();
    assert!(error.starts_with("tangential.history = \"transient\" is not admitted"), "{error}");
    let error = element(&boundary(10)).remembered_fields(&input).unwrap_err().to_string();
    assert!(error.starts_with("tangential.history = \"steady\" is not admitted"), "{error}");
}
