//! Surfaces that are not even along the track: their deviation, and how a wheel is lifted by it.

pub(crate) mod longitudinal;
pub(crate) mod waviness;
