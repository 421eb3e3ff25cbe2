//! Position and angles of a wheel against a rail.

/// Where and how a wheel stands in the frame of a rail.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WheelPose<T = f64> {
    /// Wheel marker, from the rail marker [m].
    pub marker: [T; 3],
    /// Roll angle against the rail [rad].
    pub roll: T,
    /// Yaw angle [rad].
    pub yaw: T,
}
