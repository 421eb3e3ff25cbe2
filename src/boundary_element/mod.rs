//! The half-space solution of a contact patch on rectangular elements: slow and trusted, to measure
//! the fast models with.
//!
//! Kalker's contact problem as in his variational theory (Three-Dimensional Elastic Bodies in
//! Rolling Contact, 1990): constant pressure and traction on each element, influence of Boussinesq
//! and Cerruti.

pub(crate) mod convolution;
pub mod friction;
pub mod grid;
pub(crate) mod influence;
pub mod pressure;
pub(crate) mod received;
pub mod rolling;
pub mod shift;
pub(crate) mod steps;
pub mod transient;
pub mod unlike;
