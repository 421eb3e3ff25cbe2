//! Profiles, the placed wheel and rail, and where they touch.

mod analytic_profiles;
pub mod curve;
pub(crate) mod curve_sections;
pub mod profile;
mod profile_checks;
mod profile_error;
pub(crate) mod profile_points;
mod rail_heads;
pub mod standard_profiles;
