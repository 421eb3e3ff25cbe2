//! The overlap of two bodies at given coordinates across.

use crate::geometry::contacts::separation::Separation;
use crate::math::real::Real;

/// What the strips need to know of one place, with derivatives where the numbers have them.
#[derive(Clone, Copy, Debug)]
pub struct Place<T = f64> {
    /// Parameter of the line [m].
    pub u: T,
    /// Overlap [m].
    pub overlap: T,
    /// Place along the track [m].
    pub x: T,
    /// Unit tangent (y, z) across.
    pub tangent: [T; 2],
}

/// An overlap at given coordinates across, with derivatives where the numbers have them.
pub trait OverlapLine<T: Real = f64> {
    /// The place at coordinate `y` across [m], and its parameter, which is near `guess` [m].
    fn at(&mut self, y: T, guess: f64) -> Place<T>;

    /// Radius of the normal section of the wheel along x at parameter `u`, > 0 [m].
    fn section_radius(&mut self, u: T) -> T;
}

impl<L: Line> OverlapLine for L {
    fn at(&mut self, y: f64, guess: f64) -> Place {
        let LinePlace { u, overlap, x, tangent, .. } = self.across(y, guess);
        Place { u, overlap, x, tangent }
    }

    fn section_radius(&mut self, u: f64) -> f64 {
        self.radius(u)
    }
}

/// What is to be known about one place of the contact line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinePlace {
    /// Parameter of the line [m].
    pub u: f64,
    /// Coordinate across, along the surface [m].
    pub y: f64,
    /// Derivative of `y` by the parameter of the line, > 0 [-].
    pub dy: f64,
    /// Overlap of the undeformed bodies along their common normal, negative where they are apart
    /// [m].
    pub overlap: f64,
    /// Derivative of the overlap by the parameter of the line [-].
    pub overlap_slope: f64,
    /// Place along the track [m].
    pub x: f64,
    /// Unit tangent (y, z) of the surface across, which turns with the normal.
    pub tangent: [f64; 2],
}

/// The overlap of two bodies along their contact line.
pub trait Line {
    /// At parameter `u` [m].
    fn place(&mut self, u: f64) -> LinePlace;

    /// Radius of the normal section of the wheel along x at parameter `u`, > 0 [m].
    fn radius(&mut self, u: f64) -> f64;

    /// At coordinate `y` across, for a parameter near `guess` [m].
    ///
    /// The overlap over `y` is as smooth as the surfaces; over the parameter it is not, where the
    /// contact line of a yawed wheel changes its speed with the curvature of the profile.
    fn across(&mut self, y: f64, guess: f64) -> LinePlace {
        walk_across(self, y, guess)
    }
}

/// As [`Line::across`], from place to place: by Newton's method, kept between places on both sides.
/// Where a body is bent more than the other one is far, coordinates are passed over.
pub fn walk_across(line: &mut (impl Line + ?Sized), y: f64, guess: f64) -> LinePlace {
    let mut place = line.place(guess);
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    for _ in 0..MAX_PLACES {
        let bound = if place.y < y { &mut low } else { &mut high };
        *bound = place.u;
        let step = (y - place.y) / place.dy;
        if step.abs() <= NEAR {
            place.overlap += place.overlap_slope * step;
            place.u += step;
            place.y = y;
            break;
        }
        if high - low <= NEAR {
            break;
        }
        let next = place.u + step;
        let is_between = next > low && next < high;
        place = line.place(if is_between { next } else { 0.5 * (low + high) });
    }
    place
}

/// Most places tried to find one at a given coordinate.
const MAX_PLACES: usize = 40;
/// Last step to a place at a given coordinate [m].
pub const NEAR: f64 = 1e-8;

/// The separation in one contact frame as a line: all normals are parallel.
pub(super) struct FrameLine<'a, S> {
    pub separation: &'a mut S,
    pub approach: f64,
    pub radius: f64,
}

impl<S: Separation> Line for FrameLine<'_, S> {
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

    fn radius(&mut self, _: f64) -> f64 {
        self.radius
    }
}
