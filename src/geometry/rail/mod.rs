//! The placed rail: its outline as the wheel above it meets it.

pub(crate) mod course;
mod gauge_face;
#[doc(hidden)]
pub mod placed_rail;
pub(crate) mod placement_slopes;
pub(crate) mod rail_outline;
pub(crate) mod varying_rail;
