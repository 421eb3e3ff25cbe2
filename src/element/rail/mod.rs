//! All contacts of a wheel with one rail: the pose of the wheel over it, the search, and the normal
//! models.

pub(super) mod boundary_contact;
mod boundary_tractions;
pub(super) mod cut_strip;
pub(super) mod flattened;
pub(super) mod local_line;
mod local_place;
pub(super) mod moving_contact;
pub(super) mod moving_strips;
mod overlapping;
pub(super) mod rail_contact;
pub(super) mod rail_forces;
pub(super) mod strip_contact;
pub(super) mod strip_damping;
pub(super) mod taken_zone;
