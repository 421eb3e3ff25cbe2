//! What an evaluation depends on besides the parameters.

use super::parameters::RAILS;

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

/// All inputs; one field for each FMU input of design section 3.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Input {
    /// The wheel.
    pub wheel: WheelMotion,
    /// The rails, `rail[1]` first.
    pub rails: [RailMotion; RAILS],
    /// Station along the track [m].
    pub track_s: f64,
    /// Coefficient of friction, ≥ 0 [-].
    pub friction: f64,
}

impl Default for Input {
    /// The nominal position of a right wheel, just lifted, at rest.
    fn default() -> Self {
        Self {
            wheel: WheelMotion {
                position: [0.0, 0.75, -0.46],
                roll: 0.0,
                yaw: 0.0,
                pitch: 0.0,
                velocity: [0.0; 3],
                roll_rate: 0.0,
                yaw_rate: 0.0,
                pitch_rate: 0.0,
            },
            rails: [RailMotion::default(); RAILS],
            track_s: 0.0,
            friction: 0.3,
        }
    }
}
