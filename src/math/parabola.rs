//! A parabola by the integrals of its square and its cube where it is positive.

/// Depth of a parabola over the integral of its cube over that of its square.
pub const DEPTH_OVER_MEAN: f64 = 7.0 / 6.0;
/// Half its width over the integral of its square over the square of its depth.
pub const HALF_WIDTH_OVER_INTEGRAL: f64 = 15.0 / 16.0;
