//! Mathematics without railway words.

pub mod b_spline;
pub mod elliptic;
pub mod linear_system;
pub mod logarithm;
pub mod quadrature;
pub mod room;
pub mod root;
pub mod spline;
