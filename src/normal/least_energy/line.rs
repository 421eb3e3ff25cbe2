//! The overlap of two bodies along their contact line.

use crate::geometry::contacts::separation::Separation;
use crate::math::real::Real;

/// What the strips need to know of one place of the contact line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinePlace<T = f64> {
    /// Parameter of the line [m].
    pub u: T,
    /// Coordinate across, along the surface [m].
    pub y: T,
    /// Derivative of `y` by the parameter of the line, > 0 [-].
    pub dy: T,
    /// Overlap of the undeformed bodies along their common normal, negative where they are apart
    /// [m].
    pub overlap: T,
    /// Derivative of the overlap by the parameter of the line [-].
    pub overlap_slope: T,
    /// Place along the track [m].
    pub x: T,
    /// Unit tangent (y, z) of the surface across, which turns with the normal.
    pub tangent: [T; 2],
}

/// The overlap of two bodies along their contact line, with derivatives where the numbers have
/// them.
pub trait OverlapLine<T: Real = f64> {
    /// At parameter `u` [m].
    fn place(&mut self, u: T) -> LinePlace<T>;

    /// Radius of the normal section of the wheel along x at a place `at` the line, > 0 [m].
    fn radius(&mut self, at: &LinePlace<T>) -> T;

    /// The parameter at which a body ends, which it does at the value `u`, as it moves with the
    /// bodies [m].
    fn body_end(&mut self, u: f64) -> T {
        T::from(u)
    }
}

/// The separation in one contact frame as a line: all normals are parallel.
pub(super) struct FrameLine<'a, S> {
    pub separation: &'a mut S,
    pub approach: f64,
    pub radius: f64,
}

impl<S: Separation> OverlapLine for FrameLine<'_, S> {
    fn place(&mut self, u: f64) -> LinePlace {
        let (at, slope) = self.separation.with_slope(u);
        LinePlace {
            u,
            y: at.y,
            dy: at.dy,
            overlap: self.approach - at.f,
            overlap_slope: -slope,
            x: at.x,
            tangent: [1.0, 0.0],
        }
    }

    fn radius(&mut self, _: &LinePlace) -> f64 {
        self.radius
    }
}
