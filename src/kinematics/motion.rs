//! Position and velocity of wheel and rail in the track frame.

use crate::math::numbers::numbers;

/// Position and velocity of the wheel marker, and attitude of the wheel, in the track frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WheelMotion<T = f64> {
    /// Position (x, y, z) of the wheel marker [m].
    pub position: [T; 3],
    /// Roll angle, about x [rad].
    pub roll: T,
    /// Yaw angle, about the rolled z axis [rad].
    pub yaw: T,
    /// Pitch angle, about the axle [rad].
    pub pitch: T,
    /// Velocity of the wheel marker [m/s].
    pub velocity: [T; 3],
    /// Rate of the roll angle [rad/s].
    pub roll_rate: T,
    /// Rate of the yaw angle [rad/s].
    pub yaw_rate: T,
    /// Rate of the pitch angle, negative when rolling forward [rad/s].
    pub pitch_rate: T,
}

/// Deviation of a rail from its design position and its velocity, of the rail marker.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RailMotion<T = f64> {
    /// Lateral deviation [m].
    pub y: T,
    /// Vertical deviation, down [m].
    pub z: T,
    /// Roll angle, about x through the rail marker [rad].
    pub roll: T,
    /// Lateral velocity [m/s].
    pub vy: T,
    /// Vertical velocity, down [m/s].
    pub vz: T,
    /// Rate of the roll angle [rad/s].
    pub roll_rate: T,
    /// Rate at which a roller turns about its axle, negative when its top goes forward; of a roller
    /// alone [rad/s].
    pub pitch_rate: T,
}

numbers!(WheelMotion: position, roll, yaw, pitch, velocity, roll_rate, yaw_rate, pitch_rate);
numbers!(RailMotion: y, z, roll, vy, vz, roll_rate, pitch_rate);
