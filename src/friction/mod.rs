//! Coefficients of friction over the surface of a rail and along the track.

mod changeover;
mod profile;
mod strip_friction;
mod table;

pub use changeover::Changeover;
pub use profile::{Across, FrictionProfile, FrictionTables, Section};
pub use strip_friction::StripFriction;
pub use table::{Table, direction};
