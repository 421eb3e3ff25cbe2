//! Rows of a body whose section varies: lines through the same place of all its sections.
//!
//! A varying rail lies along its rows, a varying wheel turns with them. Each row meets the other
//! body somewhere; the envelope of these places is the outline that touches.

pub mod along;
pub mod envelope;
pub mod met;
pub mod plane;
pub mod roller;
pub mod surface;
