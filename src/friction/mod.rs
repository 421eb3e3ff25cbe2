//! Coefficients of friction over the surface of a rail and along the track.

mod changeover;
mod profile;
mod strip_friction;
mod table;

/// Greatest coefficient of friction that a surface may have [-]: a number in percent is beyond it.
pub(crate) const MAX_FRICTION: f64 = 10.0;

pub use changeover::Changeover;
pub use profile::{Across, FrictionProfile, FrictionTables, Section};
pub use strip_friction::StripFriction;
pub use table::{Table, direction};
