//! Vectors of three components.

use wheelrail::element::{Element, Input, Output};

use super::wheel::{evaluate, mirrored};

/// a × b.
pub fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// a · b.
pub fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

/// a + b.
pub fn add(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| a[i] + b[i])
}

/// Fails where a component is further off than `allowed`.
pub fn assert_close(found: [f64; 3], expected: [f64; 3], allowed: f64, what: &str) {
    for i in 0..3 {
        let miss = (found[i] - expected[i]).abs();
        assert!(miss <= allowed, "{what}: {found:?}, expected {expected:?}");
    }
}

/// Fails where forces and moments on the `right` wheel of an `input` and on rail 1 with its marker
/// at `marker` are not each other's reactions, or those of the `left` one not their mirror image;
/// within a `share` of the greatest force, and of that at an arm of a metre. Returns what the right
/// wheel has.
pub fn assert_balanced(
    [right, left]: [&mut Element; 2],
    input: &Input,
    marker: [f64; 3],
    share: f64,
) -> Output {
    let (output, image) = (evaluate(right, input), evaluate(left, &mirrored(input)));
    let (wheel, rail) = (output.wheel, output.rails[0]);
    let allowed = share * wheel.force.iter().fold(1.0_f64, |most, f| most.max(f.abs()));
    assert_close(wheel.force, rail.force.map(|f| -f), allowed, "reaction");
    let [fx, fy, fz] = image.wheel.force;
    assert_close(wheel.force, [fx, -fy, fz], allowed, "mirror");
    // About the origin of the track: every force acts on both bodies at the same point.
    let on_wheel = add(wheel.moment, cross(input.wheel.position, wheel.force));
    let on_rail = add(rail.moment, cross(marker, rail.force));
    assert_close(on_wheel, on_rail.map(|m| -m), allowed, "moment");
    output
}
