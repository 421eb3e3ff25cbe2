//! The rigid body: coordinates, axes, motion of the wheel markers and equations of motion.

use nalgebra::Vector3;
use wheelrail::element::input::WheelMotion;

/// Inertia and size of the wheelset, a body of revolution about its axle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    /// Mass [kg].
    pub mass: f64,
    /// Moment of inertia about any axis through the centre normal to the axle [kg m²].
    pub inertia: f64,
    /// Moment of inertia about the axle [kg m²].
    pub axle_inertia: f64,
    /// Half the distance of the two wheel markers [m].
    pub half_marker_distance: f64,
}

/// Coordinates and velocities of the centre in the track frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct State {
    /// Distance run along the track [m].
    pub distance: f64,
    /// Lateral position, to the right [m].
    pub y: f64,
    /// Vertical position, down [m].
    pub z: f64,
    /// Roll angle [rad].
    pub roll: f64,
    /// Yaw angle, positive when the nose turns right [rad].
    pub yaw: f64,
    /// Pitch angle, falling when rolling forward [rad].
    pub pitch: f64,
    /// Lateral velocity [m/s].
    pub vy: f64,
    /// Vertical velocity [m/s].
    pub vz: f64,
    /// Rate of the roll angle [rad/s].
    pub roll_rate: f64,
    /// Rate of the yaw angle [rad/s].
    pub yaw_rate: f64,
    /// Rate of the pitch angle [rad/s].
    pub pitch_rate: f64,
}

/// Force on each degree of freedom: forces [N], and moments about the axes of the angles [N m].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GeneralizedForce {
    /// Lateral [N].
    pub y: f64,
    /// Vertical [N].
    pub z: f64,
    /// About x [N m].
    pub roll: f64,
    /// About the rolled z axis [N m].
    pub yaw: f64,
    /// About the axle [N m].
    pub pitch: f64,
}

/// Unit vectors, in the track frame, about which the three angles turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axes {
    /// Axis of roll.
    pub roll: Vector3<f64>,
    /// Axis of yaw.
    pub yaw: Vector3<f64>,
    /// The axle, axis of pitch, to the right.
    pub axle: Vector3<f64>,
}

impl Body {
    /// Axes of the three angles.
    #[allow(clippy::unused_self)] // The axes are those of this body.
    pub fn axes(&self, state: &State) -> Axes {
        let (sin_roll, cos_roll) = state.roll.sin_cos();
        let (sin_yaw, cos_yaw) = state.yaw.sin_cos();
        Axes {
            roll: Vector3::x(),
            yaw: Vector3::new(0.0, -sin_roll, cos_roll),
            axle: Vector3::new(-sin_yaw, cos_roll * cos_yaw, sin_roll * cos_yaw),
        }
    }

    /// Motion of the wheel marker on the side of `sign` (right +1, left -1) at `speed` [m/s] along
    /// the track.
    pub fn wheel_motion(&self, state: &State, speed: f64, sign: f64) -> WheelMotion {
        let axes = self.axes(state);
        let arm = axes.axle * (sign * self.half_marker_distance);
        // The pitch rate turns about the axle itself and does not move the marker.
        let turning = axes.roll * state.roll_rate + axes.yaw * state.yaw_rate;
        let position = Vector3::new(0.0, state.y, state.z) + arm;
        let velocity = Vector3::new(speed, state.vy, state.vz) + turning.cross(&arm);
        WheelMotion {
            position: position.into(),
            roll: state.roll,
            yaw: state.yaw,
            pitch: state.pitch,
            velocity: velocity.into(),
            roll_rate: state.roll_rate,
            yaw_rate: state.yaw_rate,
            pitch_rate: state.pitch_rate,
        }
    }

    /// New velocities from `force`, and new positions from the new velocities.
    ///
    /// Lagrange's equations of the body of revolution, with h its momentum about the axle:
    ///
    /// ```text
    /// h = I_a (pitch' - roll' sin yaw),   h' = M_pitch
    /// (I roll' cos² yaw)' = M_roll + M_pitch sin yaw + h yaw' cos yaw
    /// I yaw'' = M_yaw - I roll'² sin yaw cos yaw - h roll' cos yaw
    /// ```
    pub fn advance(&self, state: &mut State, force: &GeneralizedForce, speed: f64, step: f64) {
        let (sin, cos) = state.yaw.sin_cos();
        let (roll_rate, yaw_rate) = (state.roll_rate, state.yaw_rate);
        let momentum = self.axle_inertia * (state.pitch_rate - roll_rate * sin);
        let roll_acceleration = (force.roll + force.pitch * sin + momentum * yaw_rate * cos)
            / (self.inertia * cos * cos)
            + 2.0 * roll_rate * yaw_rate * sin / cos;
        let yaw_acceleration = (force.yaw - momentum * roll_rate * cos) / self.inertia
            - roll_rate * roll_rate * sin * cos;
        let pitch_acceleration =
            force.pitch / self.axle_inertia + roll_acceleration * sin + roll_rate * yaw_rate * cos;

        state.vy += step * force.y / self.mass;
        state.vz += step * force.z / self.mass;
        state.roll_rate += step * roll_acceleration;
        state.yaw_rate += step * yaw_acceleration;
        state.pitch_rate += step * pitch_acceleration;

        state.distance += step * speed;
        state.y += step * state.vy;
        state.z += step * state.vz;
        state.roll += step * state.roll_rate;
        state.yaw += step * state.yaw_rate;
        state.pitch += step * state.pitch_rate;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BODY: Body =
        Body { mass: 1500.0, inertia: 900.0, axle_inertia: 100.0, half_marker_distance: 0.75 };

    #[test]
    fn marker_velocities_are_the_derivatives_of_marker_positions() {
        let rates = State { vy: 0.3, vz: -0.2, roll_rate: 0.4, yaw_rate: -0.7, ..State::default() };
        let at = |t: f64| State {
            y: 0.01 + t * rates.vy,
            z: -0.46 + t * rates.vz,
            roll: 0.02 + t * rates.roll_rate,
            yaw: 0.03 + t * rates.yaw_rate,
            ..rates
        };
        for sign in [1.0, -1.0] {
            let [before, now, after] =
                [-1e-5, 0.0, 1e-5].map(|t| BODY.wheel_motion(&at(t), 0.0, sign));
            for i in 0..3 {
                let slope = (after.position[i] - before.position[i]) / 2e-5;
                approx::assert_abs_diff_eq!(now.velocity[i], slope, epsilon = 1e-9);
            }
        }
    }

    #[test]
    fn a_free_wheelset_keeps_its_energy_and_momentum() {
        let mut state = State {
            roll: 0.01,
            yaw: 0.02,
            roll_rate: 0.5,
            yaw_rate: -0.3,
            pitch_rate: -30.0,
            ..State::default()
        };
        // Angular momentum in the track frame.
        let momentum = |s: &State| {
            let axes = BODY.axes(s);
            let turning =
                axes.roll * s.roll_rate + axes.yaw * s.yaw_rate + axes.axle * s.pitch_rate;
            let along = axes.axle * turning.dot(&axes.axle);
            along * BODY.axle_inertia + (turning - along) * BODY.inertia
        };
        let start = momentum(&state);
        for _ in 0..200_000 {
            BODY.advance(&mut state, &GeneralizedForce::default(), 0.0, 1e-6);
        }
        let change = (momentum(&state) - start).norm() / start.norm();
        assert!(change < 1e-6, "relative change of the momentum {change:e}");
    }
}
