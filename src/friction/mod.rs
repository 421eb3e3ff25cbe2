//! Coefficients of friction over the surface of a rail and along the track.

mod changeover;
mod profile;
mod strip_friction;

pub use changeover::Changeover;
pub use profile::{Across, FrictionProfile, Section};
pub use strip_friction::StripFriction;
