//! Surfaces whose section varies: the sections, and the rows of points that they have in common.

pub(super) mod rows;
pub(crate) mod slices;
