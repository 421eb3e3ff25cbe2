//! The overlap of two bodies at given coordinates across.

use crate::math::real::Real;
use crate::normal::strips::{Line, LinePlace};

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
