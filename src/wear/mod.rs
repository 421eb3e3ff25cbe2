//! Wear of wheel and rail alongside the dynamics, and numbers for rolling contact fatigue.
//!
//! Source: Piotrowski and Kik 2008, section 6. At every step of time a law turns what happens in
//! each patch into a volume of material per time; it is spread over the patch and summed up on
//! fixed grids along both profiles; at the end of an interval the sums become new profiles.
//!
//! | quantity | unit |
//! |---|---|
//! | volume rate of a law | m³/s |
//! | worn volume, of all the wheel's circumference or of the distance that a rail stands for | m³ |
//! | worn volume per length of the profile's arc | m³/m |
//! | worn area of the cross section | m² |
//! | wear depth, along the inward normal of the unworn profile | m |
//!
//! `laws` has the laws, `distribution` how the wear of a patch is spread, `worn_arc` the sums along
//! a profile, `update` the new profile (`smoothing` of the sums, `section` of the unworn body),
//! [`depth`] the depth between two profiles at hand, `rcf` the fatigue numbers. What belongs to a
//! wheel on its rails is in `element`.

mod body;
pub mod depth;
pub(crate) mod distribution;
pub(crate) mod laws;
pub mod parameters;
pub(crate) mod rcf;
mod scratch;
mod section;
mod smoothing;
pub(crate) mod update;
pub(crate) mod worn_arc;

pub use body::Body;
pub use laws::{LawCoefficients, StripLoad, WearModel};
pub use parameters::{WearDistribution, WearParameters};
pub use update::UpdateReport;
pub use worn_arc::{ArcState, WornArc};
