//! The contact element: one wheel and the rails under it.

mod evaluate;
pub mod input;
pub mod output;
pub mod parameters;
mod rail_contact;

pub use evaluate::{Element, Work};
pub use input::Input;
pub use output::Output;
pub use parameters::Parameters;
