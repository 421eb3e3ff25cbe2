//! Friction never creates energy, whatever the steps.

use super::*;
use crate::allocations;
use crate::common::random::Random;
use crate::common::wheel::evaluate;

#[test]
fn walks_of_inputs_keep_friction_within_its_bound_and_its_work_positive() {
    let parameters = transient(&boundary(10));
    let mut random = Random::new(54);
    let mut wheel = element(&parameters);
    let mut slid = 0;
    for i in 0..60 {
        let shift = random.within(-4e-3, 7e-3);
        let input = rolling(
            &parameters,
            shift,
            random.about(0.01),
            random.within(-1e-5, 1.5e-4),
            random.about(1.0).powi(3) * 0.02,
        );
        let mut input = input;
        input.wheel.velocity[1] = random.about(0.1);
        // Standing and backward too.
        let way = [1.0, 1.0, -1.0, 0.0][i % 4];
        input.wheel.velocity[0] *= way;
        input.wheel.pitch_rate *= way;
        let duration = if i % 7 == 0 { 0.0 } else { 0.05 * 10_f64.powf(random.within(-6.0, 0.0)) };
        let before = wheel.contact_history().unwrap().clone();
        let output = advance(&mut wheel, &input, duration);
        for patch in output.patches() {
            let [x, y] = patch.creep_force;
            let most = patch.friction_coefficient * patch.normal_force;
            // A patch that wraps around the rail holds a little more.
            assert!(x.hypot(y) <= 1.01 * most, "step {i}: {patch:?}");
            assert!(patch.frictional_power >= 0.0);
            slid += i32::from(patch.slip_share > 0.999);
        }
        assert!(output.frictional_power.is_finite() && output.frictional_power >= 0.0);
        assert_eq!(output.fallback_count, 0, "step {i}");
        // Taken back and made again, also by another element from numbers.
        let after = wheel.contact_history().unwrap().clone();
        for mut other in [wheel.clone(), element(&parameters)] {
            let numbers = before.to_numbers();
            assert!(other.set_contact_history(&ContactHistory::from_numbers(&numbers).unwrap()));
            assert_eq!(bits(&advance(&mut other, &input, duration)), bits(&output), "step {i}");
            assert_eq!(*other.contact_history().unwrap(), after);
        }
        // An evaluation in between leaves no trace.
        let _ = evaluate(&mut wheel, &rolling(&parameters, 0.0, 0.0, 1e-4, 0.0));
        assert_eq!(*wheel.contact_history().unwrap(), after);
    }
    assert!(slid > 5, "{slid}");
}

/// A standing wheel that is moved to and fro across the rail: what a motion puts in over a whole
/// loop is what friction takes.
#[test]
fn the_work_of_a_loop_is_what_friction_takes() {
    let parameters = transient(&Parameters { damping: 0.0, ..boundary(12) });
    let mut input = rolling(&parameters, -2e-3, 0.0, 1e-4, 0.0);
    (input.wheel.velocity[0], input.wheel.pitch_rate) = (0.0, 0.0);
    // Displacements of some µm: the pose stays, as it were a load on a spring.
    for amplitude in [2e-6, 6e-6, 20e-6] {
        let mut wheel = fresh(&parameters);
        advance(&mut wheel, &input, 0.0);
        let (steps, duration) = (200_u32, 1e-3);
        let place =
            |i: u32| amplitude * (std::f64::consts::TAU * f64::from(i) / f64::from(steps)).sin();
        let (mut put_in, mut taken, mut last) = (0.0, 0.0, 0.0);
        for i in 1..=2 * steps {
            let way = place(i) - place(i - 1);
            let mut moved = input;
            moved.wheel.velocity[1] = way / duration;
            let output = advance(&mut wheel, &moved, duration);
            let force = output.patches[0].creep_force[1];
            // The second loop begins where it ends.
            if i > steps {
                put_in -= 0.5 * (force + last) * way;
                taken += output.frictional_power * duration;
            }
            last = force;
        }
        let limit = 0.3 * evaluate(&mut wheel, &input).patches[0].normal_force;
        println!("{amplitude}: {put_in:e} J put in, {taken:e} J taken, {}", last / limit);
        assert!((put_in / taken - 1.0).abs() <= 1e-3, "{amplitude}: {put_in:e} {taken:e}");
    }
}

/// Boundary elements allocate while they solve. What is kept after a step is the history, which is as
/// large as the contact and what it has left behind.
#[test]
fn memory_after_a_step_is_that_of_the_contact_however_long_the_walk() {
    let parameters = transient(&boundary(8));
    let mut random = Random::new(7);
    let mut wheel = element(&parameters);
    let home = rolling(&parameters, 0.0, 2e-3, 1e-4, 5e-4);
    let (mut live, mut most) = (Vec::new(), 0);
    for _ in 0..6 {
        for _ in 0..12 {
            let depth = random.within(-1e-5, 1.5e-4);
            let input =
                rolling(&parameters, random.within(-4e-3, 7e-3), random.about(0.01), depth, 0.0);
            advance(&mut wheel, &input, 0.05 * 10_f64.powf(random.within(-6.0, 0.0)));
            most = most.max(wheel.contact_history().unwrap().to_numbers().len());
        }
        // The same contact, of which nothing but itself is left after a metre.
        advance(&mut wheel, &home, 0.05);
        advance(&mut wheel, &home, 0.05);
        live.push(allocations::live_bytes());
    }
    println!("{live:?} bytes, {most} numbers");
    assert!(most < 2 * 4 * 16 * 16, "{most}");
    // Room once made stays, up to that of the largest contact.
    let grown = live[5] - live[1];
    assert!(grown.unsigned_abs() < 16 * most, "{live:?}");
}
