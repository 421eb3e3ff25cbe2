//! Mathematics without railway words.

pub mod b_spline;
pub mod dual;
pub mod elliptic;
pub mod linear_system;
pub mod logarithm;
pub mod quadrature;
pub mod real;
pub mod room;
pub mod root;
pub mod smooth_step;
pub mod spline;
