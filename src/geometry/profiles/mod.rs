//! Wheel and rail profiles: from formulas, and from the points of a file.

pub(super) mod analytic_profiles;
pub(crate) mod point_noise;
pub mod profile;
pub(super) mod profile_checks;
pub(super) mod profile_error;
pub(super) mod profile_kind;
pub(super) mod profile_of_points;
pub(super) mod profile_order;
pub(crate) mod profile_points;
pub(super) mod profile_remark;
pub(super) mod rail_heads;
mod smoothing;
pub mod standard_profiles;
