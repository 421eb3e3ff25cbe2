//! Position and velocity of wheel and rail in the track frame.

/// Position and velocity of the wheel marker, and attitude of the wheel, in the track frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WheelMotion {
    /// Position (x, y, z) of the wheel marker [m].
    pub position: [f64; 3],
    /// Roll angle, about x [rad].
    pub roll: f64,
    /// Yaw angle, about the rolled z axis [rad].
    pub yaw: f64,
    /// Pitch angle, about the axle [rad].
    pub pitch: f64,
    /// Velocity of the wheel marker [m/s].
    pub velocity: [f64; 3],
    /// Rate of the roll angle [rad/s].
    pub roll_rate: f64,
    /// Rate of the yaw angle [rad/s].
    pub yaw_rate: f64,
    /// Rate of the pitch angle, negative when rolling forward [rad/s].
    pub pitch_rate: f64,
}

/// Deviation of a rail from its design position and its velocity, of the rail marker.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RailMotion {
    /// Lateral deviation [m].
    pub y: f64,
    /// Vertical deviation, down [m].
    pub z: f64,
    /// Roll angle, about x through the rail marker [rad].
    pub roll: f64,
    /// Lateral velocity [m/s].
    pub vy: f64,
    /// Vertical velocity, down [m/s].
    pub vz: f64,
    /// Rate of the roll angle [rad/s].
    pub roll_rate: f64,
}
