//! Vectors in the plane of a section.

use crate::math::real::Real;

/// Scalar product.
pub(in crate::geometry) fn dot<T: Real>(a: [T; 2], b: [T; 2]) -> T {
    a[0] * b[0] + a[1] * b[1]
}

/// First vector across the second: positive where it turns from y to z on the way from one to the
/// other.
pub(in crate::geometry) fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}
