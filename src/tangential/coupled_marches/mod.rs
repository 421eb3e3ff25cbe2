//! Marches through strips that feel each other: `tangential.model` = marches.
mod adhesion;
mod band;
pub mod differences;
pub mod ellipse;
mod functions;
mod influence;
mod march;
mod model;
mod solver;

pub use model::{CoupledMarches, MarchNumber};
