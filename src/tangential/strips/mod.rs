//! Steady rolling on the strips of the true patch: `tangential.model` = strips.
//!
//! Tractions in a few points along a few strips, which lie between those of the normal problem
//! (`layout`). Within a strip the gradient of displacement is that of boundary elements on
//! Chebyshev points (`points`, `equations`); between strips it is a few coefficients by a few
//! moments of the tractions, in closed form (`kernel`, `influence`). One semi-smooth Newton method
//! solves all of it (`newton`, `coupling`). Nothing is given of the shape of the zone, and the
//! coefficients of Kalker's linear theory come out.
//!
//! Zones beside the one asked for have no part in it, nor has the other lobe of a zone in that of one
//! lobe (`span`). Friction may differ from strip to strip, and
//! so may the creepage.

mod coupling;
mod equations;
mod influence;
mod kernel;
mod layout;
mod linear_strip;
mod moving;
mod newton;
mod points;
mod scratch;
mod sizes;
mod solver;
mod span;
mod taped;

pub use newton::Settled;
pub use points::MAX_POINTS;
pub use scratch::Scratch;
pub use solver::TractionStrips;
pub use span::Span;
