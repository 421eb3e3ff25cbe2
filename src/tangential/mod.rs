//! Tangential contact: creep forces of loaded zones.

pub(crate) mod boundary_element;
mod convergence;
mod creep_number;
mod ellipse_force;
pub(crate) mod equivalent_ellipse;
pub(crate) mod fastrip;
pub mod fastsim;
pub(crate) mod fastsim_correction;
pub mod field;
pub mod flash_temperature;
pub(crate) mod flexibility;
mod forces;
pub mod friction_law;
pub mod kalker_coefficients;
pub(crate) mod linear;
mod loaded_zone;
mod march;
mod model;
pub(crate) mod neck;
mod outline;
mod own_friction;
pub mod rigid_slip;
mod rolling;
mod solve;
pub(crate) mod strips;
pub mod tables;
mod under_law;

pub use crate::kinematics::creepage::Creepage;
pub use convergence::Convergence;
pub use creep_number::CreepNumber;
pub use forces::{CreepForce, StripForce};
pub use loaded_zone::LoadedZone;
pub use model::{Flexibilities, TangentialModel};
pub use rolling::{Rolling, RollingState};
pub use solve::{Solved, Tangential};
pub use under_law::UnderLaw;
