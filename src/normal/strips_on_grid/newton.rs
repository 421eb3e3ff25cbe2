//! Newton's method for the strips.
//!
//! All unknowns take one step with the exact derivative, each component of it bounded by itself,
//! with other bounds where the node carries load. Nothing is tried again. The solution, not the way
//! to it, is continuous in the pose.

use multiversion::multiversion;

use super::columns::{LANES, row};
use super::elimination;
use super::equations::INFLUENCE;
use super::grid::Grid;
use super::linearised::Linearised;
use super::scales::Scales;
use super::shape::Knots;
use super::unknowns::Unknowns;

/// Most Newton steps.
pub(super) const MAX_STEPS: u64 = 40;
/// First steps, in which nodes that a yawed wheel has ahead of each other are taken as if side by
/// side, with two influences for a pair instead of three: the steps after them find what that
/// leaves out.
const FIRST_STEPS: u64 = 2;
/// Last change of a load per width, over that in the middle of the ellipse, and of χ, weighted by
/// the load: what is left is of the order of their squares, which a search for a given load does
/// not feel.
const LAST_CHANGE: f64 = 1e-6;
/// Greatest decrease in one step of z, and rise where there is no load, over itself or the load per
/// width in the middle of the ellipse, whichever is greater; and greatest change of χ: less than
/// where the equations have left what their derivatives tell.
const MAX_CHANGE: [f64; 2] = [0.5, 0.3];
/// Greatest growth in one step of a load that is next to nothing, over that in the middle of the
/// ellipse; others double at most. The displacement by such a load goes with its square.
const MAX_GROWTH: f64 = 0.1;
/// Share of the way beyond zero that a node takes that begins to carry load: its gap, by which it
/// goes there, is about as much flatter than its load where both are small, and it would come back
/// and go again.
const SHARE_ACROSS: f64 = 0.1;
/// Least slope of the equation of a node over the greatest residual of all of them, both in units
/// of the ellipse: a node of little load or little gap has an equation that is flat on both sides,
/// and moves by no more than some loads of the ellipse. It goes to nothing with the residual, so
/// that the last steps are Newton's.
const MIN_SLOPE: f64 = 0.2;
/// Displacement of a node by a load of its own over (2/π²) times width over half length: ln(8 a/h),
/// for nodes a seventh of a half length apart. What is left of the overlap of a node when its gap
/// has closed is carried with that slope, and not with that of the gap.
const SELF_INFLUENCE: f64 = 4.0;

/// Unknowns and memory for as many nodes as the solver was made for.
#[derive(Clone, Debug)]
pub(super) struct Newton {
    pub unknowns: Unknowns,
    system: Linearised,
    /// Steps so far.
    pub steps: u64,
    /// Largest distance left at a node that carries load, or overlap left at one that does not,
    /// over the greatest overlap, before the last step.
    pub residual: f64,
}

impl Newton {
    /// Memory for up to `n` nodes, the `knots` and `cells` cells.
    pub fn new(n: usize, knots: &Knots, cells: usize) -> Self {
        Self {
            unknowns: Unknowns::new(n, knots.count(), cells),
            system: Linearised::new(n, knots, cells),
            steps: 0,
            residual: 0.0,
        }
    }

    /// Solves the equations on `grid`; false where the last step was longer than it should be.
    pub fn solve(&mut self, grid: &Grid, knots: &Knots) -> bool {
        solve(self, grid, knots)
    }

    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn solve_here(&mut self, grid: &Grid, knots: &Knots) -> bool {
        let scales = Scales::new(&grid.samples);
        self.system.fit(grid, knots);
        self.system.measure(grid, &scales);
        self.unknowns.start(grid, &scales);
        let is_skewed = grid.is_skewed();
        let mut settled = false;
        for step in 0..MAX_STEPS {
            self.steps += 1;
            let is_first = is_skewed && step < FIRST_STEPS;
            self.linearise(grid, &scales, is_skewed && !is_first);
            let Some(change) = self.step(grid, &scales) else { break };
            settled = !is_first && change <= LAST_CHANGE;
            if settled {
                break;
            }
        }
        self.unknowns.place(grid, &scales);
        settled
    }

    /// The system at the present unknowns.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn linearise(&mut self, grid: &Grid, scales: &Scales, is_skewed: bool) {
        self.unknowns.place(grid, scales);
        self.system.linearise(&self.unknowns, grid, scales, is_skewed);
    }

    /// The derivatives of all residuals by all unknowns at the present ones, by rows, into
    /// `matrix`; returns their number.
    pub fn matrix_at(&mut self, grid: &Grid, knots: &Knots, matrix: &mut Vec<f64>) -> usize {
        let scales = Scales::new(&grid.samples);
        self.linearise(grid, &scales, grid.is_skewed());
        self.system.matrix(grid, knots, matrix)
    }

    /// Makes the equations of nodes as steep as they have to be and finds their residual; returns
    /// the greatest overlap that a node without load has beyond its gap, over the depth.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn steepen(&mut self, grid: &Grid, scales: &Scales) -> f64 {
        let (n, stride) = (grid.nodes.len(), self.system.nodes + self.system.behind);
        let (matrix, right) = self.system.matrix.split_at_mut(self.system.pivots.len() * stride);
        let greatest = (0..n).map(|i| row(right, i).abs()).fold(0.0, f64::max);
        let least = MIN_SLOPE * greatest.min(grid.samples.depth) / scales.load;
        let (mut not_carried, mut apart) = (0.0f64, 0.0f64);
        for (i, column) in matrix.chunks_exact_mut(stride).take(n).enumerate() {
            let slope = row(column, i);
            *slope = slope.max(least);
            let (node, z, residual) = (&grid.nodes[i], self.unknowns.z[i], *row(right, i));
            let below = (-z).max(0.0);
            let overlap = residual - scales.gap * below * below.sqrt();
            if z > 0.0 {
                apart = apart.max(residual.abs());
            } else if overlap > 0.0 {
                let width = 0.5 * (node.reach[1] - node.reach[0]);
                let loaded = SELF_INFLUENCE * INFLUENCE * width / scales.length;
                *slope = slope.max(residual / (below + overlap / loaded));
                not_carried = not_carried.max(overlap);
            }
        }
        self.residual = apart.max(not_carried) / grid.samples.depth;
        not_carried / grid.samples.depth
    }

    /// One step; its greatest change, or nothing where the equations have no solution.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn step(&mut self, grid: &Grid, scales: &Scales) -> Option<f64> {
        let stride = self.system.nodes + self.system.behind;
        let mut greatest = self.steepen(grid, scales);
        if !elimination::solve(&mut self.system.matrix, stride, &self.system.pivots) {
            return None;
        }
        let change = &mut self.system.matrix[self.system.pivots.len() * stride..];
        let least = f64::EPSILON * scales.load;
        for (i, z) in self.unknowns.z.iter_mut().enumerate() {
            let change = *row(change, i);
            let is_loaded = *z > 0.0;
            let most = MAX_CHANGE[0] * scales.load.max(z.abs());
            let growth = if is_loaded { z.max(MAX_GROWTH * scales.load) } else { most };
            *z += change.clamp(-most, growth);
            if !is_loaded && *z > 0.0 {
                *z *= SHARE_ACROSS;
            }
            // A load of nothing has no side.
            if z.abs() < least {
                *z = least;
            }
            // Nodes that stay without load have their gap from all the others.
            if is_loaded || *z > 0.0 {
                greatest = greatest.max(change.abs() / scales.load);
            }
        }
        let heaviest = self.system.weights.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        for (k, (shape, weight)) in
            self.unknowns.shape.iter_mut().zip(&self.system.weights).enumerate()
        {
            let change = *row(change, self.system.nodes * LANES + k);
            *shape += change.clamp(-MAX_CHANGE[1], MAX_CHANGE[1]);
            greatest = greatest.max(change.abs() * weight / heaviest);
        }
        Some(greatest)
    }
}

/// [`Newton::solve`], once for each set of instructions, with all that it calls.
#[multiversion(targets("x86_64+avx512f+avx512dq", "x86_64+avx2", "aarch64+neon"))]
fn solve(newton: &mut Newton, grid: &Grid, knots: &Knots) -> bool {
    newton.solve_here(grid, knots)
}
