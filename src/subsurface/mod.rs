//! Displacements and stresses below the surface of a wheel or a rail in contact.
//!
//! The surface carries the pressure and the tractions of a contact problem, uniform on each element
//! of a grid: those of boundary elements, or those of strips spread over one
//! ([`crate::planar::fields`]). Each element does what Boussinesq's and Cerruti's solutions give in
//! closed form, and the body is a half-space: where the contact is not small against the body, as on
//! a rail's gauge corner, that is an approximation.

mod corner;
pub(crate) mod greatest;
mod load;
mod points;
mod state;

pub use crate::boundary_element::grid::Grid;
pub use greatest::Greatest;
pub use load::{Body, SurfaceLoad};
pub use points::{evenly, lattice};
pub use state::{Measure, State, Stress};
