//! Plane curves, and places on them.

pub(crate) mod arc_length;
pub mod curve;
pub(crate) mod curve_sections;
pub(crate) mod knot_slopes;
pub(super) mod nearest_point;
