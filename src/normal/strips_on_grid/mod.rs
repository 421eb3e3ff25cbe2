//! Strips that all satisfy the contact condition: `normal.model` = strips, the default.
//!
//! Each strip has a semi-elliptical pressure, as with Piotrowski and Kik (2008). In their model the
//! displacement of the half-space equals the overlap of the bodies at one point, here at every node
//! that carries load:
//!
//! ```text
//! p(x, y) = c(y) sqrt(a(y)² - (x - x_0(y))²),   P = (π/2) c a²
//! P ≥ 0,   u_n - overlap ≥ 0,   P (u_n - overlap) = 0
//! ```
//!
//! | symbol | quantity | unit |
//! |---|---|---|
//! | x, y | along the track; across, as arc of the rail | m |
//! | x_0, a | centre and half length of a strip | m |
//! | c | peak pressure of a strip over its half length | Pa/m |
//! | P | load per width of a strip | N/m |
//! | u_n | displacement of both bodies together along the normal of the node | m |
//! | overlap | of the undeformed bodies, along the same normal | m |
//! | R | radius of the normal section of the wheel along x | m |
//!
//! Unknown are P and c. P goes to zero linearly where the contact ends and determines the
//! displacement far away. c varies slowly over a contact region, and is constant on an ellipse; it
//! follows from a condition along x: the difference of displacement between x = 0 and x = 0.7 a
//! equals that of the wheel's section, (0.7 a)²/(2 R).
//!
//! All overlaps of a rail are one problem on one grid, without a list of regions or edges: contact
//! zones are extracted from the solution (`zones`).
//!
//! The equations in these unknowns are in `equations`, the influence of a strip in `influence`,
//! units and weights in `scales`; docs/theory.md, section 6, has the derivation,
//! docs/validation.md the errors.

mod beside;
mod columns;
mod derivative;
mod elimination;
mod equations;
mod grid;
mod influence;
mod line;
mod linearised;
mod newton;
mod overlap;
mod samples;
mod scales;
mod shape;
mod sources;
mod turns;
mod unknowns;
mod valleys;
mod zones;

pub use derivative::GridFollower;
pub use influence::STATION;
pub use line::{Line, LinePlace, NEAR, OverlapLine, Place, walk_across};

use crate::geometry::contacts::separation::{Probe, Separation};
use crate::normal::{NormalProblem, Strips};
use grid::Grid;
use line::FrameLine;
use newton::Newton;
use overlap::Overlaps;
use shape::Knots;
use unknowns::Unknowns;
use zones::Loads;

/// Least strips: fewer do not tell the shape of a contact region.
pub const MIN_STRIPS: usize = 8;

/// Work of one solver since it was made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Work {
    /// Problems solved.
    pub solved: u64,
    /// Newton steps.
    pub steps: u64,
    /// Greatest number of steps of one problem.
    pub most_steps: u64,
    /// Problems whose last step was longer than it should have been.
    pub unsettled: u64,
}

/// Solver with its scratch memory; it keeps no result.
#[derive(Clone, Debug)]
pub struct GridSolver {
    knots: Knots,
    overlaps: Overlaps,
    grid: Grid,
    newton: Newton,
    /// Work so far.
    pub work: Work,
}

impl GridSolver {
    /// A solver with `strips` strips for each rail, at least [`MIN_STRIPS`].
    #[must_use]
    pub fn new(strips: usize) -> Self {
        let strips = strips.max(MIN_STRIPS);
        // The ends of an overlap are nodes too.
        let knots = Knots::new(strips - 2);
        let grid = Grid::new(strips - 2);
        let newton = Newton::new(grid.nodes.capacity(), &knots, grid.cells.capacity());
        Self { knots, overlaps: Overlaps::new(), grid, newton, work: Work::default() }
    }

    /// Largest distance left at a node of the last problem that carries load, or overlap left at
    /// one that does not, over the greatest overlap, before the last Newton step; 0 without a
    /// problem [-].
    #[must_use]
    pub fn residual(&self) -> f64 {
        self.newton.residual
    }

    /// Adds the loaded zones of `line` to `strips`, whose overlap is `level` - f at the `probes`;
    /// the contact modulus in Pa.
    ///
    /// Returns the number of fallbacks: zones that found no room, and one where the last step was
    /// longer than it should have been.
    pub fn solve(
        &mut self,
        line: &mut impl Line,
        probes: &[Probe],
        level: f64,
        contact_modulus: f64,
        strips: &mut Strips,
    ) -> usize {
        self.work.solved += 1;
        self.newton.residual = 0.0;
        self.overlaps.fill(line, probes, level);
        if self.overlaps.intervals.is_empty() {
            return 0;
        }
        self.grid.lay(line, &self.overlaps, &self.knots);
        if self.grid.nodes.is_empty() {
            return 0;
        }
        let before = self.newton.steps;
        let settled = self.newton.solve(&self.grid, &self.knots);
        let steps = self.newton.steps - before;
        self.work.steps += steps;
        self.work.most_steps = self.work.most_steps.max(steps);
        self.work.unsettled += u64::from(!settled);
        let Unknowns { z, shapes, .. } = &self.newton.unknowns;
        Loads { grid: &self.grid, z, shapes }.emit(contact_modulus, strips) + usize::from(!settled)
    }
}

/// Adds the zones of one contact frame to `strips`; returns the number of fallbacks as
/// [`GridSolver::solve`] does.
pub fn solve_in_frame(
    solver: &mut GridSolver,
    problem: &NormalProblem,
    separation: &mut impl Separation,
    probes: &[Probe],
    strips: &mut Strips,
) -> usize {
    let (approach, radius) = (problem.approach, problem.radius);
    let mut line = FrameLine { separation, approach, radius };
    solver.solve(&mut line, probes, approach, problem.contact_modulus, strips)
}
