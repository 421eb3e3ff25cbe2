//! Plane curves, and places on them.

pub(crate) mod arc_length;
pub mod curve;
pub(crate) mod curve_sections;
pub(super) mod nearest_point;
