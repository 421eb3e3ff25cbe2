//! Steps of any length of a contact with memory, on elements of one endless lattice, so that
//! contacts grow, shrink, move, split, merge, end and begin.
//!
//! A step longer than an element is divided into steps of an element
//! ([`transient`](super::transient)), and, beyond the length of the contact, of a tenth of what lies
//! behind them in the step. Of a step many times as long as the contact nothing but steady rolling
//! is left: it is solved as that.

mod kept;
mod lattice;
mod walk;

pub use kept::Kept;
pub use lattice::{Lattice, Window};
pub use walk::{Part, Solve, Walk};
