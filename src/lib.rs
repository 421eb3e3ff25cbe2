//! Wheel-rail contact element.

pub mod element;
pub mod error;
pub mod geometry;
pub mod material;
pub mod planar;
pub mod variables;
