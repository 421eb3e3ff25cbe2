//! The functions that FMI 3.0 asks of a unit for co-simulation and model exchange, as the library
//! exports them.
//!
//! Arguments are as in the standard; raw pointers become slices and texts here and nowhere else.
//! What the unit does not have, clocks, scheduled execution, structural parameters and some types
//! of variables, is exported, explains itself to the logger and answers `fmi3Error`.
#![allow(unsafe_code)]
// The names are the standard's, and so is the contract of their pointers.
#![allow(non_snake_case, clippy::missing_safety_doc)]

mod functions;
mod life;
pub mod types;

pub use super::both::v3::*;
pub use functions::*;
pub use life::*;
