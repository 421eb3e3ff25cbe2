//! Creepage at a point of the contact plane, and the speed it refers to.
//!
//! The velocity w of the wheel relative to the rail at the point P, both rigid, and the rotations ω
//! give in the axes e_x, t (across) and n (into the rail) of the contact
//!
//! ```text
//! w = v_M + ω × (P - M) - (v_rail + ω_rail × (P - M_rail))
//! ξ = w · e_x / V,   η = w · t / V,   φ = (ω - ω_rail) · n / V
//! V = max((|v_x| + |ω_pitch| r)/2, floor)
//! ```
//!
//! with M the marker of the wheel, M_rail that of the rail, or a point of the axle of a roller, and
//! r the rolling radius. Source: kinematics of rigid bodies; ξ, η and φ as Piotrowski and Kik
//! (2008), section 4, and Kalker (1990) define them, with the sign of wheel minus rail.
//! docs/theory.md, section 8.

use nalgebra::Vector3;

use crate::kinematics::motion::{RailMotion, WheelMotion};
use crate::leaves::MINIMUM_SPEED;
use crate::math::real::Real;

/// Creepage of the wheel against the rail at one point of the contact plane.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Creepage<T = f64> {
    /// Longitudinal, ξ = relative velocity along x over V [-].
    pub longitudinal: T,
    /// Lateral, η, along the lateral axis of the contact frame [-].
    pub lateral: T,
    /// Spin, φ = normal component of the relative angular velocity over V [1/m].
    pub spin: T,
}

impl<T: Real> Creepage<T> {
    /// Whether all three vanish, so that there is nothing to compute; never where they have
    /// derivatives.
    pub fn is_zero(&self) -> bool {
        !T::HAS_SLOPES
            && [self.longitudinal, self.lateral, self.spin].iter().all(|c| c.value().abs() == 0.0)
    }
}

/// Creepages, and spins in 1/m, beyond this are taken as this: the wheel slides far below it
/// already, and squares of larger ones would overflow.
const MAX_CREEPAGE: f64 = 1e6;

/// The longitudinal creepage of a wheel with forward velocity `velocity` [m/s] and `pitch_rate`
/// [rad/s] from its rolling radius [m] alone: (v_x + ω r)/V. Yaw, the turning of the wheel about
/// other axes and the motion of the rail do not enter; there is no lateral creepage and no spin.
pub fn kinematic_creepage<T: Real>(
    velocity: T,
    pitch_rate: T,
    rolling_radius: T,
    reference_speed: T,
) -> Creepage<T> {
    let slip = velocity + pitch_rate * rolling_radius;
    Creepage { longitudinal: bounded(slip / reference_speed), ..Creepage::default() }
}

/// A creepage [-] or spin [1/m] that is no greater than counts.
pub fn bounded<T: Real>(creepage: T) -> T {
    creepage.within(-MAX_CREEPAGE, MAX_CREEPAGE)
}

/// The speed to which creepages refer, and the direction of rolling.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RollingSpeed<T = f64> {
    /// V = max((|v_x| + |ω| r)/2, floor) > 0 [m/s].
    pub reference: T,
    /// 1 when the contact moves forward over both bodies, 0 when backward, in between where they
    /// disagree [-].
    pub forward_share: T,
}

/// The reference speed of a wheel with forward velocity `velocity` [m/s], `pitch_rate` (negative
/// when rolling forward) [rad/s] and rolling radius [m]; `floor` > 0 keeps it finite at standstill.
pub fn rolling_speed<T: Real>(
    velocity: T,
    pitch_rate: T,
    rolling_radius: T,
    floor: f64,
) -> RollingSpeed<T> {
    let circumferential = -pitch_rate * rolling_radius;
    let mut reference = ((velocity.abs() + circumferential.abs()) * 0.5).at_least(floor);
    if T::IS_BACKWARD && reference <= floor {
        reference = T::known(floor, MINIMUM_SPEED);
    }
    // Mean velocity of the contact over the material of wheel and rail.
    let contact = (velocity + circumferential) * 0.5;
    RollingSpeed { reference, forward_share: ((contact / reference + 1.0) * 0.5).within(0.0, 1.0) }
}

/// Unit vectors of a contact in the track frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactAxes<T = f64> {
    /// Along the rail, or along its surface where a corrugated rail leans.
    pub longitudinal: Vector3<T>,
    /// Across, in the contact plane, towards the field side.
    pub lateral: Vector3<T>,
    /// Into the rail.
    pub normal: Vector3<T>,
}

impl<T: Real> ContactAxes<T> {
    /// The axes of a contact plane with unit vectors along the rail, `lateral` and `normal`.
    pub fn along(longitudinal: Vector3<T>, lateral: Vector3<T>, normal: Vector3<T>) -> Self {
        Self { longitudinal, lateral, normal }
    }

    /// The same axes turned about the normal, so that the first goes along the track as far as the
    /// plane lets it.
    #[must_use]
    pub fn beside_track(self) -> Self {
        let along = Vector3::x() - self.normal * self.normal.x;
        let longitudinal = along / along.dot(&along).sqrt();
        Self { longitudinal, lateral: self.normal.cross(&longitudinal), ..self }
    }

    /// The same axes turned about the lateral one, so that the normal leans forward by an angle
    /// with that tangent.
    #[must_use]
    pub fn leaning(self, tangent: T) -> Self {
        if tangent == 0.0 {
            return self;
        }
        let size = T::from(1.0) / tangent.hypotenuse(1.0.into());
        Self {
            longitudinal: (self.longitudinal - self.normal * tangent) * size,
            normal: (self.normal + self.longitudinal * tangent) * size,
            ..self
        }
    }
}

/// Velocities of wheel and rail at any point, in the track frame.
#[derive(Clone, Copy, Debug)]
pub struct RelativeMotion<T = f64> {
    wheel_marker: Vector3<T>,
    wheel_velocity: Vector3<T>,
    wheel_rotation: Vector3<T>,
    /// The part of the wheel's rotation that is not about its axle.
    attitude_rotation: Vector3<T>,
    rail_marker: Vector3<T>,
    rail_velocity: Vector3<T>,
    rail_rotation: Vector3<T>,
    /// A point of the axle of a roller, and how it turns about that.
    roller_axle: Vector3<T>,
    roller_rotation: Vector3<T>,
}

impl<T: Real> RelativeMotion<T> {
    /// The motion of a wheel against a rail whose marker is at `rail_marker` [m].
    pub fn new(wheel: &WheelMotion<T>, rail: &RailMotion<T>, rail_marker: Vector3<T>) -> Self {
        let (sin_roll, cos_roll) = wheel.roll.sin_cos();
        let (sin_yaw, cos_yaw) = wheel.yaw.sin_cos();
        let rolled_z = Vector3::new(T::from(0.0), -sin_roll, cos_roll);
        let axle = Vector3::new(-sin_yaw, cos_yaw * cos_roll, cos_yaw * sin_roll);
        let attitude_rotation = Vector3::x() * wheel.roll_rate + rolled_z * wheel.yaw_rate;
        Self {
            wheel_marker: wheel.position.into(),
            wheel_velocity: wheel.velocity.into(),
            wheel_rotation: attitude_rotation + axle * wheel.pitch_rate,
            attitude_rotation,
            rail_marker,
            rail_velocity: Vector3::new(T::from(0.0), rail.vy, rail.vz),
            rail_rotation: Vector3::x() * rail.roll_rate,
            roller_axle: rail_marker,
            roller_rotation: Vector3::zeros(),
        }
    }

    /// The same on a roller that turns by `rotation` [rad/s] about an axle through the point `axle`
    /// [m].
    #[must_use]
    pub fn on_roller(self, axle: Vector3<T>, rotation: Vector3<T>) -> Self {
        Self { roller_axle: axle, roller_rotation: rotation, ..self }
    }

    /// Forward velocity of the surface of a roller at `point` by its turning; 0 on a straight rail
    /// [m/s].
    pub fn roller_speed(&self, point: Vector3<T>) -> T {
        self.roller_rotation.cross(&(point - self.roller_axle)).x
    }

    /// Creepage at `point` [m] of a contact with the given axes, for the reference speed [m/s].
    pub fn creepage(
        &self,
        point: Vector3<T>,
        axes: &ContactAxes<T>,
        reference_speed: T,
    ) -> Creepage<T> {
        let wheel = self.wheel_velocity + self.wheel_rotation.cross(&(point - self.wheel_marker));
        let roller = self.roller_rotation.cross(&(point - self.roller_axle));
        let slip = wheel - self.rail_velocity_at(point) - roller;
        let rail_rotation = self.rail_rotation + self.roller_rotation;
        let spin = (self.wheel_rotation - rail_rotation).dot(&axes.normal);
        Creepage {
            longitudinal: bounded(slip.dot(&axes.longitudinal) / reference_speed),
            lateral: bounded(slip.dot(&axes.lateral) / reference_speed),
            spin: bounded(spin / reference_speed),
        }
    }

    /// Velocity at which the undeformed bodies close at `point`: without the turning about their
    /// axles, which moves no surface, as wheel and roller are round [m/s].
    pub fn approach_velocity(&self, point: Vector3<T>) -> Vector3<T> {
        self.wheel_velocity + self.attitude_rotation.cross(&(point - self.wheel_marker))
            - self.rail_velocity_at(point)
    }

    /// Velocity at which a wheel that is not round closes by its turning about its axle where it is
    /// met by `ahead` [m] from a round one with the same normal, whose turning closes nothing [m/s].
    pub fn turning_velocity(&self, ahead: Vector3<T>) -> Vector3<T> {
        (self.wheel_rotation - self.attitude_rotation).cross(&ahead)
    }

    /// Velocity of the rail, without the turning of a roller [m/s].
    fn rail_velocity_at(&self, point: Vector3<T>) -> Vector3<T> {
        self.rail_velocity + self.rail_rotation.cross(&(point - self.rail_marker))
    }
}
