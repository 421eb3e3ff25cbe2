//! How the track goes on under a wheelset: turns of its frame, and the line of the rails of each
//! side in it.

use nalgebra::Vector3;

use crate::error::ContactError;
use crate::kinematics::motion::WheelMotion;
use crate::math::numbers::{Numbers, numbers};
use crate::math::real::Real;

/// Greatest turn of the track frame over a length [rad/m]: no wheelset passes a radius of 10 m.
pub const MAX_TURN: f64 = 0.1;
/// Greatest slope of a rail along the track [-]: five times that of the steepest ramp of a
/// crossing.
pub const MAX_SLOPE: f64 = 0.1;

/// How the track frame turns as it goes along the track, about its own axes.
///
/// The motion of the wheelset is that in the track frame: a wheelset that runs evenly through a
/// curve has no yaw rate of its own.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TrackTurn<T = f64> {
    /// Change of the cant angle over the length: positive lowers the right rail on the way [rad/m].
    pub twist: T,
    /// Change of the gradient over the length: positive in a sag, from where on the track rises
    /// [rad/m].
    pub vertical_curvature: T,
    /// Curvature in plan: positive to the right [rad/m].
    pub curvature: T,
}

/// Where the rails of a side lie beside their design line at the wheelset, and where they lead to
/// from there.
///
/// These are irregularities over the station: rails lie still in them, other than rails that are
/// given a velocity. A wheel meets them as rails that run at an angle to the track.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RailLine<T = f64> {
    /// Lateral deviation of both rails of the side, to the right [m].
    pub y: T,
    /// Vertical deviation, down [m].
    pub z: T,
    /// Derivative of the lateral deviation by the station [-].
    pub y_slope: T,
    /// Derivative of the vertical deviation by the station [-].
    pub z_slope: T,
}

numbers!(TrackTurn: twist, vertical_curvature, curvature);
numbers!(RailLine: y, z, y_slope, z_slope);

impl<T: Real> TrackTurn<T> {
    /// The motion of a body against the ground, in the axes of the track frame, from that
    /// `in_track`, whose velocity along x is that of the track frame along the track.
    ///
    /// ```text
    /// ω = v_x (twist, vertical_curvature, curvature),   V = V' + ω × (0, y, z),   Ω = Ω' + ω
    /// ```
    ///
    /// The frame turns at the station of the body, whatever its x.
    pub fn against_ground(&self, in_track: &WheelMotion<T>) -> WheelMotion<T> {
        let turning = self.vector() * in_track.velocity[0];
        let [_, y, z] = in_track.position;
        let arm = Vector3::new(T::from(0.0), y, z);
        let velocity = Vector3::from(in_track.velocity) + turning.cross(&arm);
        WheelMotion { velocity: velocity.into(), ..*in_track }.turned_by(&turning)
    }

    fn vector(&self) -> Vector3<T> {
        Vector3::new(self.twist, self.vertical_curvature, self.curvature)
    }

    /// Direction of a line that keeps its distance `y` from the middle of the track, not of unit
    /// length.
    pub(super) fn direction(&self, y: T) -> Vector3<T> {
        Vector3::x() + self.vector().cross(&Vector3::new(T::from(0.0), y, T::from(0.0)))
    }
}

impl std::ops::AddAssign for RailLine {
    fn add_assign(&mut self, other: Self) {
        *self = self.each_with(&other, &mut |own, other: f64| own + other);
    }
}

impl TrackTurn {
    /// # Errors
    /// A number that is not in its range, by its FMU name.
    pub(super) fn check(&self) -> Result<(), ContactError> {
        let Self { twist, vertical_curvature, curvature } = *self;
        for (name, value) in
            [("twist", twist), ("vertical_curvature", vertical_curvature), ("curvature", curvature)]
        {
            if !is_within(value, MAX_TURN) {
                let name = format!("track.{name}");
                return Err(ContactError::bad_value(name, value, "-0.1 to 0.1 rad/m"));
            }
        }
        Ok(())
    }
}

impl RailLine {
    /// # Errors
    /// A number that is not in its range, by its FMU name on a `side`.
    pub(super) fn check(&self, side: &str) -> Result<(), ContactError> {
        let Self { y, z, y_slope, z_slope } = *self;
        for (name, value, most, allowed) in [
            ("y", y, f64::MAX, "a finite number"),
            ("z", z, f64::MAX, "a finite number"),
            ("y_slope", y_slope, MAX_SLOPE, "-0.1 to 0.1"),
            ("z_slope", z_slope, MAX_SLOPE, "-0.1 to 0.1"),
        ] {
            if !is_within(value, most) {
                let name = format!("{side}.irregularity.{name}");
                return Err(ContactError::bad_value(name, value, allowed));
            }
        }
        Ok(())
    }
}

/// Whether a number is one and no farther from zero than `most`.
fn is_within(value: f64, most: f64) -> bool {
    value.abs() <= most
}
