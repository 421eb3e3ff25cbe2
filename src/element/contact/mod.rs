//! One contact of a wheel with a rail: its frame and bodies, how its loaded zones roll, and the
//! forces that follow.

pub(super) mod contact_forces;
pub(super) mod contact_setup;
pub(super) mod curved_strips;
pub(super) mod given_tractions;
pub(super) mod laid_zones;
pub(super) mod models;
pub(super) mod number;
pub(super) mod rail_frame;
pub(super) mod rail_friction;
pub(super) mod rail_walk;
pub(super) mod rolling_zones;
pub(super) mod tractions;
pub(super) mod zone_rolling;
pub(super) mod zone_surface;
