//! Wheel-rail contact element.

pub mod element;
pub mod error;
pub mod fmi;
pub mod geometry;
pub mod io;
pub mod kinematics;
pub mod material;
pub mod math;
pub mod normal;
pub mod planar;
pub mod tangential;
pub mod variables;
