//! Wheel-rail contact element.

pub mod element;
pub mod error;
pub mod fmi;
pub mod geometry;
pub mod variables;
