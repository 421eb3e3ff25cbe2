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

/// The section of both bodies along the track at a place of the contact line, as a circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section<T = f64> {
    /// Its radius, > 0 [m].
    pub radius: T,
    /// How far ahead of the place its middle is, and what the bodies overlap less there [m].
    pub ahead: T,
    pub less: T,
}

impl<T: Real> Section<T> {
    /// That of even bodies.
    pub fn even(radius: T) -> Self {
        Self { radius, ahead: T::from(0.0), less: T::from(0.0) }
    }
}

/// The overlap of two bodies along their contact line, with derivatives where the numbers have
/// them.
pub trait OverlapLine<T: Real = f64> {
    /// At parameter `u` [m].
    fn place(&mut self, u: T) -> LinePlace<T>;

    /// The section along x at a place `at` the line.
    fn section(&mut self, at: &LinePlace<T>) -> Section<T>;

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

    fn section(&mut self, _: &LinePlace) -> Section {
        Section::even(self.radius)
    }
}
