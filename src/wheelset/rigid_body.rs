//! The wheelset as a rigid body: motion of its wheel markers, and forces on them brought to its centre.

use nalgebra::Vector3;

use crate::element::input::WheelMotion;
use crate::element::output::Wrench;

/// The axle of a wheelset, from its centre to the right, a unit vector in the track frame.
///
/// ```text
/// u = R_x(roll) R_z(yaw) e_y = (-sin yaw, cos roll cos yaw, sin roll cos yaw)
/// ```
#[must_use]
pub fn axle(motion: &WheelMotion) -> Vector3<f64> {
    let (sin_roll, cos_roll) = motion.roll.sin_cos();
    let (sin_yaw, cos_yaw) = motion.yaw.sin_cos();
    Vector3::new(-sin_yaw, cos_roll * cos_yaw, sin_roll * cos_yaw)
}

/// Motion of the point of the axle `along` [m] to the right of the one whose `motion` is given; attitude and rates are those of all
/// the body.
///
/// ```text
/// X = X_c + along u,   V = V_c + (roll_rate e_x + yaw_rate e_z') × along u
/// ```
///
/// The pitch rate turns about the axle itself and moves none of its points.
#[must_use]
pub fn point_of_axle(motion: &WheelMotion, along: f64) -> WheelMotion {
    let (sin_roll, cos_roll) = motion.roll.sin_cos();
    let arm = axle(motion) * along;
    let yaw_axis = Vector3::new(0.0, -sin_roll, cos_roll);
    let turning = Vector3::x() * motion.roll_rate + yaw_axis * motion.yaw_rate;
    let position = Vector3::from(motion.position) + arm;
    let velocity = Vector3::from(motion.velocity) + turning.cross(&arm);
    WheelMotion { position: position.into(), velocity: velocity.into(), ..*motion }
}

/// Adds to `total`, which is about the centre, a force on the body and its moment about the point of the axle `along` [m] to the
/// right of there.
pub fn add(total: &mut Wrench, motion: &WheelMotion, along: f64, wrench: &Wrench) {
    let force = Vector3::from(wrench.force);
    let moment = Vector3::from(wrench.moment) + (axle(motion) * along).cross(&force);
    for i in 0..3 {
        total.force[i] += force[i];
        total.moment[i] += moment[i];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MOTION: WheelMotion = WheelMotion {
        position: [0.1, 0.004, -0.459],
        roll: 0.02,
        yaw: -0.03,
        pitch: 0.7,
        velocity: [20.0, 0.3, -0.2],
        roll_rate: 0.4,
        yaw_rate: -0.7,
        pitch_rate: -43.0,
    };

    #[test]
    fn velocities_are_the_derivatives_of_positions() {
        let at = |t: f64| {
            let moved = |x: f64, v: f64| x + t * v;
            let position = [0, 1, 2].map(|i| moved(MOTION.position[i], MOTION.velocity[i]));
            let roll = moved(MOTION.roll, MOTION.roll_rate);
            let yaw = moved(MOTION.yaw, MOTION.yaw_rate);
            point_of_axle(&WheelMotion { position, roll, yaw, ..MOTION }, -0.75)
        };
        let (before, now, after) = (at(-1e-5), at(0.0), at(1e-5));
        for i in 0..3 {
            let slope = (after.position[i] - before.position[i]) / 2e-5;
            approx::assert_abs_diff_eq!(now.velocity[i], slope, epsilon = 1e-8);
        }
    }

    #[test]
    fn positive_roll_lowers_and_positive_yaw_sets_back_the_right_end() {
        let still = WheelMotion { roll: 0.0, yaw: 0.0, ..MOTION };
        let rolled = point_of_axle(&WheelMotion { roll: 0.01, ..still }, 0.75);
        assert!(rolled.position[2] > MOTION.position[2] + 0.007);
        let yawed = point_of_axle(&WheelMotion { yaw: 0.01, ..still }, 0.75);
        assert!(yawed.position[0] < MOTION.position[0] - 0.007);
    }

    #[test]
    fn power_of_the_total_is_that_of_the_parts() {
        // F · V + M · ω at a marker and at the centre, ω with the pitch.
        let wrench = Wrench { force: [1.0, -2.0, -50.0], moment: [0.3, 0.5, -0.2] };
        let omega = Vector3::x() * MOTION.roll_rate
            + Vector3::new(0.0, -MOTION.roll.sin(), MOTION.roll.cos()) * MOTION.yaw_rate
            + axle(&MOTION) * MOTION.pitch_rate;
        let power = |wrench: &Wrench, velocity: [f64; 3]| {
            Vector3::from(wrench.force).dot(&Vector3::from(velocity))
                + Vector3::from(wrench.moment).dot(&omega)
        };
        let mut total = Wrench::default();
        add(&mut total, &MOTION, 0.75, &wrench);
        let marker = point_of_axle(&MOTION, 0.75);
        let (at_marker, at_centre) =
            (power(&wrench, marker.velocity), power(&total, MOTION.velocity));
        approx::assert_relative_eq!(at_marker, at_centre, max_relative = 1e-13);
    }
}
