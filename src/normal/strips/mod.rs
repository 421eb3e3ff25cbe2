//! Strips that all satisfy the contact condition.
//!
//! The semi-elliptical pressure of each strip is that of Piotrowski and Kik; instead of at one point, the displacement of the half-space
//! meets the overlap of the bodies on every strip, and its fall along x, to 0.7 of the half length, that of the wheel. With q the pressure and a the half length
//! of a strip, κ = q/a varies slowly over a lobe (it is constant on an ellipse, and E*/(2R) wherever a strip is much shorter than the
//! patch is wide), so that a = q/κ with few terms for κ ends the patch where its pressure ends:
//!
//! ```text
//! p(x, y) = κ(y) sqrt(a(y)² - (x - x_0(y))²),   κ = E*/(2R) exp(Σ_l κ_l P_l(t))
//! u_n(y_i) = overlap(y_i),   Σ_i ω_i P_l(t_i) (2 R (u_n(0) - u_n(0.7 a))/(0.7 a)² - 1) = 0,   q ~ sqrt of the distance at free edges
//! ```
//!
//! Unknowns are q at the Gauss-Legendre nodes of each lobe, its two edges and κ_l; Newton's method with derivatives in closed form. Lobes are
//! coupled through the half-space, the displacement at a strip being taken along its own normal.

mod cell;
mod changes;
mod closures;
mod faint_ridges;
mod fixed;
mod fixed_layout;
mod fixed_lobes;
pub(in crate::normal) mod influence;
mod joints;
mod lobes;
mod moving;
mod nodes;
mod pair_sums;
mod rule;
mod shoulders;
mod solver;
mod system;
#[cfg(test)]
mod two_peaks;
mod zones;

pub use moving::{MovingLine, MovingPlace, StripFollower};
pub use solver::{StripSolver, Work};

use crate::geometry::separation::{Probe, Separation};
use crate::normal::{NormalProblem, Strips};

/// Least strips of a lobe: each end follows three inner ones, and neither those of the other end.
pub const LEAST_STRIPS: usize = 7;

/// What is to be known about one place of the contact line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinePlace {
    /// Parameter of the line [m].
    pub u: f64,
    /// Coordinate across, along the surface [m].
    pub y: f64,
    /// Derivative of `y` by the parameter of the line, > 0 [-].
    pub dy: f64,
    /// Overlap of the undeformed bodies along their common normal, negative where they are apart [m].
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
    /// The overlap over `y` is as smooth as the surfaces; over the parameter it is not, where the contact line of a yawed wheel changes
    /// its speed with the curvature of the profile.
    fn across(&mut self, y: f64, guess: f64) -> LinePlace {
        walk_across(self, y, guess)
    }
}

/// As [`Line::across`], from place to place.
pub fn walk_across(line: &mut (impl Line + ?Sized), y: f64, guess: f64) -> LinePlace {
    let mut place = line.place(guess);
    for _ in 0..MOST_PLACES {
        let step = (y - place.y) / place.dy;
        if step.abs() <= NEAR {
            place.overlap += place.overlap_slope * step;
            place.u += step;
            place.y = y;
            break;
        }
        place = line.place(place.u + step);
    }
    place
}

/// Most places tried to find one at a given coordinate.
const MOST_PLACES: usize = 20;
/// Last step to a place at a given coordinate [m].
pub const NEAR: f64 = 1e-8;

/// The separation in one contact frame as a line: all normals are parallel.
pub(in crate::normal) struct FrameLine<'a, S> {
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

/// Solves for the zones of one contact frame; false where no solution was found, `strips` is then as before.
pub fn solve_in_frame(
    solver: &mut StripSolver,
    problem: &NormalProblem,
    separation: &mut impl Separation,
    probes: &[Probe],
    strips: &mut Strips,
) -> bool {
    let (approach, radius) = (problem.approach, problem.radius);
    let mut line = FrameLine { separation, approach, radius };
    solver.solve(&mut line, probes, approach, problem.contact_modulus, strips)
}
