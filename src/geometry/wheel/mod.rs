//! The placed wheel: the line on it that can touch a rail.

pub mod contact_line;
pub(crate) mod surface_point;
pub(crate) mod varying_wheel;
pub(crate) mod wheel_pose;
