//! Mathematics without railway words.

pub(crate) mod arctangent;
pub(crate) mod b_spline;
pub(crate) mod broyden;
mod by_slopes;
pub(crate) mod dual;
pub mod elliptic;
pub(crate) mod fixed_vec;
pub(crate) mod linear_system;
pub(crate) mod logarithm;
pub(crate) mod nearest_whole;
pub(crate) mod numbers;
pub(crate) mod parabola;
pub mod quadrature;
pub(crate) mod real;
pub mod root;
pub(crate) mod smooth_step;
pub mod spline;
pub(crate) mod tape;
pub(crate) mod transposed_spline;
pub(crate) mod until_unload;
pub(crate) mod vectors;
