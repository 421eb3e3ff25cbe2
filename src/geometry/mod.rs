//! Profiles, the placed wheel and rail, and where they touch.

mod analytic_profiles;
pub(crate) mod arc_length;
#[doc(hidden)]
pub mod clearance;
#[doc(hidden)]
pub mod contact;
pub mod contact_line;
#[doc(hidden)]
pub mod contact_search;
pub mod curve;
pub(crate) mod curve_sections;
pub(crate) mod line_separation;
pub(crate) mod longitudinal;
pub(crate) mod moving_contact;
pub(crate) mod moving_separation;
mod nearest_point;
#[doc(hidden)]
pub mod placed_rail;
pub(crate) mod point_noise;
pub mod profile;
mod profile_checks;
mod profile_error;
mod profile_kind;
mod profile_of_points;
mod profile_order;
pub(crate) mod profile_points;
mod profile_remark;
mod rail_heads;
pub(crate) mod rail_outline;
mod rows;
#[doc(hidden)]
pub mod separation;
pub(crate) mod slices;
pub mod standard_profiles;
pub(crate) mod surface_point;
pub(crate) mod varying_rail;
pub(crate) mod varying_wheel;
pub(crate) mod waviness;
pub(crate) mod wheel_pose;
