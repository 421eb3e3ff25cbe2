//! Strips whose pressures have the least energy (Kalker's variational principle, restricted to
//! pressures that are semi-elliptical along rolling).
//!
//! ```text
//! p(x, y) = c(y) sqrt(a(y)² - (x - x_0(y))²),   l = (π/2) c a²/E*,   a² = (2/π) (S l) e^-χ/c_0 + f²
//! W(l, χ) = ½ Σ w_i w_j l_i l_j K_ij/π - Σ w_i l_i (o_i - a_i²/(8 R_i)) + penalty(χ)   least over l ≥ 0 and χ
//! ```
//!
//! | symbol | quantity | unit |
//! |---|---|---|
//! | l | load per width over E* at the nodes, linear between them | m |
//! | w, o | integral of the hat of a node; mean of the overlap over it | m |
//! | a, f | half length of a strip; the least one | m |
//! | c, c_0 | peak pressure over half length and E*; that of the ellipse | 1/m |
//! | χ | ln(c/c_0), a smooth field of a few knots | - |
//! | S | mean of the load per width over a hat | - |
//! | K | mutual potential of two strips with unit loads, mean over both hats | 1/m |
//! | R | radius of the normal section of the wheel along x | m |
//!
//! The force is the derivative of W by the approach, so that errors of l and χ enter it in second
//! order only. There are no regions, edges or valleys: nodes stand where the bodies overlap
//! (`lattice`), the pairs of them have a potential (`pairs`, `displaced`, `kernel`), Newton's method
//! finds the least energy (`system`, `newton`), and loaded runs of nodes are zones (`zones`).

mod derivative;
mod descend;
mod displaced;
mod factor;
mod hat;
mod kernel;
mod lanes;
mod lattice;
mod line;
mod newton;
mod overlap;
mod pairs;
mod potential;
mod problem;
mod scales;
mod shape;
mod system;
mod zones;

pub use derivative::{StripFollower, StripNumber};
pub use line::{LinePlace, OverlapLine, Section};

use crate::geometry::contacts::separation::{Probe, Separation};
use crate::math::fixed_vec::FixedVec;
use crate::normal::{Descent, NormalProblem, Pose, Strips};
use lattice::Lattice;
use line::FrameLine;
use newton::Newton;
use overlap::Overlaps;
use zones::Zones;

/// Least nodes of an overlap.
pub const MIN_STRIPS: usize = 8;
/// Most nodes of a rail over those of one overlap that is a parabola: ground rails touch in five or six
/// narrow zones. And how many at most, as work grows with their cube: room for 200 asked for.
const MOST: [usize; 2] = [6, 240];

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
pub struct StripSolver {
    overlaps: Overlaps,
    lattice: Lattice,
    newton: Newton,
    zones: Zones,
    /// Way of the overlap of each node with that of the wheel down [-].
    cosines: FixedVec<f64>,
    /// Work so far.
    pub work: Work,
}

impl StripSolver {
    /// A solver with `strips` nodes for an overlap that is a parabola, at least [`MIN_STRIPS`]; other
    /// overlaps get them by their lobes.
    pub fn new(strips: usize) -> Self {
        let (strips, most) = (strips.max(MIN_STRIPS), Self::most_nodes(strips));
        Self {
            overlaps: Overlaps::new(),
            lattice: Lattice::new(strips, most),
            newton: Newton::new(most),
            zones: Zones::new(most),
            cosines: FixedVec::new(most),
            work: Work::default(),
        }
    }

    /// Most nodes of all overlaps of a rail, of which `strips` are for a parabola.
    pub fn most_nodes(strips: usize) -> usize {
        (MOST[0] * strips.max(MIN_STRIPS)).min(MOST[1])
    }

    /// Greatest displacement left of the overlap at a node that carries load, over the depth, before
    /// the last step; 0 without a problem [-].
    pub fn residual(&self) -> f64 {
        self.newton.residual
    }

    /// Adds the loaded zones of `line` to `strips`, whose overlap is `level` - f at the `probes`; the
    /// contact modulus in Pa. With a `descent` they are those at the way down that it asks for.
    ///
    /// Returns the number of fallbacks: zones that found no room, and one where Newton's method has
    /// not converged.
    pub fn solve(
        &mut self,
        line: &mut impl OverlapLine,
        probes: &[Probe],
        level: f64,
        contact_modulus: f64,
        descent: Option<&mut Descent>,
        strips: &mut Strips,
    ) -> usize {
        self.work.solved += 1;
        let pose = descent.as_ref().map_or(Pose::New, |descent| descent.pose);
        if !pose.is_same() {
            self.newton.residual = 0.0;
            self.overlaps.fill(line, probes, level);
            self.lattice.lay(line, &self.overlaps);
        }
        if self.lattice.nodes.is_empty() {
            return 0;
        }
        // Where the line folds at all of them, none may overlap.
        if !self.lattice.nodes.iter().any(|node| node.overlap > 0.0) {
            return 1;
        }
        let before = self.newton.steps;
        let mut settled = pose.is_same() || self.newton.solve(&self.lattice, pose == Pose::Near);
        if let Some(descent) = descent {
            settled &= self.descend(descent, contact_modulus);
        }
        settled = settled && self.newton.finish();
        let steps = self.newton.steps - before;
        self.work.steps += steps;
        self.work.most_steps = self.work.most_steps.max(steps);
        self.work.unsettled += u64::from(!settled);
        let Newton { problem, system, load, curvature, .. } = &self.newton;
        let solution = [&load[..], &system.shape, curvature];
        let (scales, knots) = (&problem.scales, &problem.knots);
        let left_out =
            self.zones.emit(&self.lattice, scales, knots, solution, contact_modulus, strips);
        left_out + usize::from(!settled)
    }
}

/// Adds the zones of one contact frame to `strips`; returns the number of fallbacks as
/// [`StripSolver::solve`] does.
pub fn solve_in_frame(
    solver: &mut StripSolver,
    problem: &NormalProblem,
    separation: &mut impl Separation,
    probes: &[Probe],
    strips: &mut Strips,
) -> usize {
    let (approach, radius) = (problem.approach, problem.radius);
    let mut line = FrameLine { separation, approach, radius };
    solver.solve(&mut line, probes, approach, problem.contact_modulus, None, strips)
}
