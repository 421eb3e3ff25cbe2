//! Creepage at a point of the contact plane, and the speed it refers to.

use nalgebra::Vector3;

use crate::kinematics::motion::{RailMotion, WheelMotion};

/// Creepage of the wheel against the rail at one point of the contact plane.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Creepage {
    /// Longitudinal, ξ = relative velocity along x over V [-].
    pub longitudinal: f64,
    /// Lateral, η, along the lateral axis of the contact frame [-].
    pub lateral: f64,
    /// Spin, φ = normal component of the relative angular velocity over V [1/m].
    pub spin: f64,
}

impl Creepage {
    /// Whether all three vanish, so that there is nothing to compute.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        [self.longitudinal, self.lateral, self.spin].iter().all(|c| c.abs() == 0.0)
    }
}

/// Creepages, and spins in 1/m, beyond this are taken as this: the wheel slides far below it already, and squares of
/// larger ones would overflow.
const MOST_CREEPAGE: f64 = 1e6;

/// The longitudinal creepage of a wheel with forward velocity `velocity` [m/s] and `pitch_rate` [rad/s] from its rolling radius [m]
/// alone: (v_x + ω r)/V. Yaw, the turning of the wheel about other axes and the motion of the rail do not enter; there is no
/// lateral creepage and no spin.
#[must_use]
pub fn kinematic_creepage(
    velocity: f64,
    pitch_rate: f64,
    rolling_radius: f64,
    reference_speed: f64,
) -> Creepage {
    let slip = velocity + pitch_rate * rolling_radius;
    Creepage { longitudinal: bounded(slip / reference_speed), ..Creepage::default() }
}

fn bounded(creepage: f64) -> f64 {
    creepage.clamp(-MOST_CREEPAGE, MOST_CREEPAGE)
}

/// The speed to which creepages refer, and the direction of rolling.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RollingSpeed {
    /// V = max((|v_x| + |ω| r)/2, floor) > 0 [m/s].
    pub reference: f64,
    /// 1 when the contact moves forward over both bodies, 0 when backward, in between where they disagree [-].
    pub forward_share: f64,
}

/// The reference speed of a wheel with forward velocity `velocity` [m/s], `pitch_rate` (negative when rolling forward)
/// [rad/s] and rolling radius [m]; `floor` > 0 keeps it finite at standstill.
#[must_use]
pub fn rolling_speed(
    velocity: f64,
    pitch_rate: f64,
    rolling_radius: f64,
    floor: f64,
) -> RollingSpeed {
    let circumferential = -pitch_rate * rolling_radius;
    let reference = (0.5 * (velocity.abs() + circumferential.abs())).max(floor);
    // Mean velocity of the contact over the material of wheel and rail.
    let contact = 0.5 * (velocity + circumferential);
    RollingSpeed { reference, forward_share: (0.5 * (1.0 + contact / reference)).clamp(0.0, 1.0) }
}

/// Unit vectors of a contact in the track frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactAxes {
    /// Along the track, or along its surface where a corrugated rail leans.
    pub longitudinal: Vector3<f64>,
    /// Across, in the contact plane, towards the field side.
    pub lateral: Vector3<f64>,
    /// Into the rail.
    pub normal: Vector3<f64>,
}

impl ContactAxes {
    /// The axes of a contact plane along the track with unit vectors `lateral` and `normal`.
    #[must_use]
    pub fn along_track(lateral: Vector3<f64>, normal: Vector3<f64>) -> Self {
        Self { longitudinal: Vector3::x(), lateral, normal }
    }

    /// The same axes turned about the lateral one, so that the normal leans forward by an angle with that tangent.
    #[must_use]
    pub fn leaning(self, tangent: f64) -> Self {
        if tangent == 0.0 {
            return self;
        }
        let size = 1.0 / tangent.hypot(1.0);
        Self {
            longitudinal: (self.longitudinal - self.normal * tangent) * size,
            normal: (self.normal + self.longitudinal * tangent) * size,
            ..self
        }
    }
}

/// Velocities of wheel and rail at any point, in the track frame.
#[derive(Clone, Copy, Debug)]
pub struct RelativeMotion {
    wheel_marker: Vector3<f64>,
    wheel_velocity: Vector3<f64>,
    wheel_rotation: Vector3<f64>,
    /// The part of the wheel's rotation that is not about its axle.
    attitude_rotation: Vector3<f64>,
    rail_marker: Vector3<f64>,
    rail_velocity: Vector3<f64>,
    rail_rotation: Vector3<f64>,
}

impl RelativeMotion {
    /// The motion of a wheel against a rail whose marker is at `rail_marker` [m].
    #[must_use]
    pub fn new(wheel: &WheelMotion, rail: &RailMotion, rail_marker: Vector3<f64>) -> Self {
        let (sin_roll, cos_roll) = wheel.roll.sin_cos();
        let (sin_yaw, cos_yaw) = wheel.yaw.sin_cos();
        let rolled_z = Vector3::new(0.0, -sin_roll, cos_roll);
        let axle = Vector3::new(-sin_yaw, cos_yaw * cos_roll, cos_yaw * sin_roll);
        let attitude_rotation = Vector3::x() * wheel.roll_rate + rolled_z * wheel.yaw_rate;
        Self {
            wheel_marker: wheel.position.into(),
            wheel_velocity: wheel.velocity.into(),
            wheel_rotation: attitude_rotation + axle * wheel.pitch_rate,
            attitude_rotation,
            rail_marker,
            rail_velocity: Vector3::new(0.0, rail.vy, rail.vz),
            rail_rotation: Vector3::x() * rail.roll_rate,
        }
    }

    /// Creepage at `point` [m] of a contact with the given axes, for the reference speed [m/s].
    #[must_use]
    pub fn creepage(
        &self,
        point: Vector3<f64>,
        axes: &ContactAxes,
        reference_speed: f64,
    ) -> Creepage {
        let wheel = self.wheel_velocity + self.wheel_rotation.cross(&(point - self.wheel_marker));
        let slip = wheel - self.rail_velocity_at(point);
        let spin = (self.wheel_rotation - self.rail_rotation).dot(&axes.normal);
        Creepage {
            longitudinal: bounded(slip.dot(&axes.longitudinal) / reference_speed),
            lateral: bounded(slip.dot(&axes.lateral) / reference_speed),
            spin: bounded(spin / reference_speed),
        }
    }

    /// Velocity at which the undeformed bodies close at `point`: without the turning about the axle, which moves no wheel
    /// surface, as the wheel is round [m/s].
    #[must_use]
    pub fn closing_velocity(&self, point: Vector3<f64>) -> Vector3<f64> {
        self.wheel_velocity + self.attitude_rotation.cross(&(point - self.wheel_marker))
            - self.rail_velocity_at(point)
    }

    fn rail_velocity_at(&self, point: Vector3<f64>) -> Vector3<f64> {
        self.rail_velocity + self.rail_rotation.cross(&(point - self.rail_marker))
    }
}
