//! Surfaces that are not even along the track: their waves, and where along it they overlap.

pub(crate) mod bridge;
pub(crate) mod stretches;
pub(crate) mod waviness;
pub(crate) mod wavy_section;
