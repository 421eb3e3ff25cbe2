//! Profiles, the placed wheel and rail, and where they touch.

mod analytic_profiles;
pub mod arc_length;
pub mod clearance;
pub mod contact;
pub mod contact_line;
pub mod contact_search;
pub mod curve;
pub(crate) mod curve_sections;
pub mod line_separation;
pub mod longitudinal;
pub mod moving_contact;
pub mod moving_separation;
pub mod placed_rail;
pub(crate) mod point_noise;
pub mod profile;
mod profile_checks;
mod profile_error;
pub(crate) mod profile_points;
mod profile_remark;
mod rail_heads;
pub mod rail_outline;
pub mod separation;
pub mod slices;
pub mod standard_profiles;
pub mod varying_rail;
pub mod varying_wheel;
pub mod waviness;
