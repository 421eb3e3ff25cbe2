//! Points of an axle, and how fast they move.

use nalgebra::{Matrix3, Vector3};

use super::motion::WheelMotion;
use crate::math::real::Real;

impl<T: Real> WheelMotion<T> {
    /// The axle, to the right, a unit vector in the track frame.
    ///
    /// ```text
    /// u = R_x(roll) R_z(yaw) e_y = (-sin yaw, cos roll cos yaw, sin roll cos yaw)
    /// ```
    pub fn axle(&self) -> Vector3<T> {
        let (sin_roll, cos_roll) = self.roll.sin_cos();
        let (sin_yaw, cos_yaw) = self.yaw.sin_cos();
        Vector3::new(-sin_yaw, cos_roll * cos_yaw, sin_roll * cos_yaw)
    }

    /// Angular velocity in the track frame but for the pitch rate, which moves no point of the axle
    /// [rad/s].
    ///
    /// ```text
    /// ω - pitch_rate u = roll_rate e_x + yaw_rate e_z'
    /// ```
    pub fn turning(&self) -> Vector3<T> {
        let (sin_roll, cos_roll) = self.roll.sin_cos();
        let yaw_axis = Vector3::new(T::from(0.0), -sin_roll, cos_roll);
        Vector3::x() * self.roll_rate + yaw_axis * self.yaw_rate
    }

    /// Angular velocity in the track frame [rad/s].
    pub fn angular_velocity(&self) -> Vector3<T> {
        self.turning() + self.axle() * self.pitch_rate
    }

    /// Motion of the point of the axle `along` [m] to the right of this one; attitude and rates are
    /// those of all the body.
    ///
    /// ```text
    /// X' = X + along u,   V' = V + ω × along u
    /// ```
    pub fn along_axle(&self, along: f64) -> Self {
        let arm = self.axle() * T::from(along);
        let position = Vector3::from(self.position) + arm;
        let velocity = Vector3::from(self.velocity) + self.turning().cross(&arm);
        Self { position: position.into(), velocity: velocity.into(), ..*self }
    }

    /// The same with an angular velocity `more` [rad/s] added, in the frame of this motion: its
    /// rates take it up.
    ///
    /// ```text
    /// R_x(roll)^T more = (Δroll_rate - Δpitch_rate sin yaw, Δpitch_rate cos yaw, Δyaw_rate)
    /// ```
    pub fn turned_by(&self, more: &Vector3<T>) -> Self {
        let (sin_roll, cos_roll) = self.roll.sin_cos();
        let (sin_yaw, cos_yaw) = self.yaw.sin_cos();
        let pitch_rate = (more.y * cos_roll + more.z * sin_roll) / cos_yaw;
        Self {
            roll_rate: self.roll_rate + more.x + pitch_rate * sin_yaw,
            yaw_rate: self.yaw_rate + more.z * cos_roll - more.y * sin_roll,
            pitch_rate: self.pitch_rate + pitch_rate,
            ..*self
        }
    }

    /// Attitude and rates in a frame with the `axes` (columns, in this frame); position and
    /// velocity stay as they are.
    ///
    /// ```text
    /// axes^T R_x(roll) R_z(yaw) R_y(pitch) = R_x(roll') R_z(yaw') R_y(pitch')
    /// ```
    pub fn seen_from(&self, axes: &Matrix3<T>) -> Self {
        let back = axes.transpose();
        let axle = back * self.axle();
        let level = |roll: T, yaw: T| {
            let (sin_roll, cos_roll) = roll.sin_cos();
            let (sin_yaw, cos_yaw) = yaw.sin_cos();
            // R_x R_z e_x and R_x R_z e_z
            let along = Vector3::new(cos_yaw, cos_roll * sin_yaw, sin_roll * sin_yaw);
            (along, Vector3::new(T::from(0.0), -sin_roll, cos_roll))
        };
        let (roll, yaw) = (axle.z.atan2(axle.y), -axle.x.asin());
        // Where an axle without pitch points ahead, in the new axes without pitch.
        let ahead = back * level(self.roll, self.yaw).0;
        let (along, down) = level(roll, yaw);
        let more_pitch = (-ahead.dot(&down)).atan2(ahead.dot(&along));
        let zero = T::from(0.0);
        let turned = Self {
            roll,
            yaw,
            pitch: self.pitch + more_pitch,
            roll_rate: zero,
            yaw_rate: zero,
            pitch_rate: zero,
            ..*self
        };
        turned.turned_by(&(back * self.angular_velocity()))
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
            WheelMotion { position, roll, yaw, ..MOTION }.along_axle(-0.75)
        };
        let (before, now, after) = (at(-1e-5), at(0.0), at(1e-5));
        for i in 0..3 {
            let slope = (after.position[i] - before.position[i]) / 2e-5;
            approx::assert_abs_diff_eq!(now.velocity[i], slope, epsilon = 1e-8);
        }
    }

    /// R_x(roll) R_z(yaw) R_y(pitch)
    fn attitude(motion: &WheelMotion) -> Matrix3<f64> {
        use nalgebra::Rotation3;
        let about = |axis, angle: f64| Rotation3::from_axis_angle(&axis, angle);
        let turned = about(Vector3::x_axis(), motion.roll) * about(Vector3::z_axis(), motion.yaw);
        (turned * about(Vector3::y_axis(), motion.pitch)).into_inner()
    }

    #[test]
    fn a_body_seen_from_other_axes_is_turned_and_turns_by_them() {
        let turn = nalgebra::Rotation3::from_scaled_axis(Vector3::new(0.05, -0.08, 0.1));
        let axes = turn.into_inner();
        let seen = MOTION.seen_from(&axes);
        approx::assert_abs_diff_eq!(
            attitude(&seen),
            axes.transpose() * attitude(&MOTION),
            epsilon = 1e-14
        );
        let turning = axes * seen.angular_velocity();
        approx::assert_abs_diff_eq!(turning, MOTION.angular_velocity(), epsilon = 1e-13);
        let more = Vector3::new(0.3, -0.2, 0.5);
        let faster = MOTION.turned_by(&more).angular_velocity();
        approx::assert_abs_diff_eq!(faster, MOTION.angular_velocity() + more, epsilon = 1e-13);
    }

    #[test]
    fn positive_roll_lowers_and_positive_yaw_sets_back_the_right_end() {
        let still = WheelMotion { roll: 0.0, yaw: 0.0, ..MOTION };
        let rolled = WheelMotion { roll: 0.01, ..still }.along_axle(0.75);
        assert!(rolled.position[2] > MOTION.position[2] + 0.007);
        let yawed = WheelMotion { yaw: 0.01, ..still }.along_axle(0.75);
        assert!(yawed.position[0] < MOTION.position[0] - 0.007);
    }
}
