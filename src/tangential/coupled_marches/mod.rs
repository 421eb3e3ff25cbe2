//! Marches through strips that feel each other: `tangential.model` = marches.
//!
//! FASTSIM's march in each strip has flexibilities of a long strip's full adhesion (`adhesion`), so
//! that nothing is asked of an ellipse, and slip that may turn within a cell (`march`). What strips do
//! to each other through the half-space goes by three moments of their tractions, in functions of one
//! variable (`band`, `influence`, `functions`). All strips march, feel each other, and march again, a
//! few rounds without any equation to be solved (`solver`).
//!
//! What is left is made up for by what the same marches lack on the ellipse of each zone or lobe
//! (`ellipse`, `parts`), from a table of differences (`differences`).
//!
//! All zones of a rail are in one solution. Every step of it is continuous in the strips of the
//! normal problem, which come and go without load.

mod adhesion;
mod band;
pub mod differences;
pub mod ellipse;
mod functions;
mod influence;
mod march;
mod model;
mod parts;
mod solver;
mod solvers;
mod state;

pub use solvers::{CoupledMarches, MarchNumber};
