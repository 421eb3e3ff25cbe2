//! Derivatives of a solution of the strips.
//!
//! The solution fulfils a system of equations r(z, p) = 0 in the unknowns z and the pose p. With
//! the unknowns as dual numbers, whose derivatives z' are wanted, the residual has the derivatives
//! r' = (∂r/∂z) z' + (∂r/∂p) p', which have to vanish:
//!
//! ```text
//! z' ← z' - M^-1 r'(z'),   M the Newton matrix at the solution
//! ```
//!
//! The grid moves with the pose as it is laid: nodes have derivatives too.

use super::GridSolver;
use super::equations::residuals;
use super::grid::Grid;
use super::line::OverlapLine;
use super::zones::Loads;
use crate::math::dual::Dual;
use crate::math::fixed_vec::FixedVec;
use crate::math::linear_system::Factors;
use crate::math::real::Real;
use crate::normal::Strips;

/// Most turns, and the last change of derivatives, over the greatest of the same kind.
const MAX_TURNS: usize = 20;
const LAST_CHANGE: f64 = 1e-9;

/// Memory for derivatives of solutions of the strips.
#[derive(Clone, Debug)]
pub struct GridFollower<T> {
    grid: Grid<T>,
    z: FixedVec<T>,
    shape: FixedVec<T>,
    residuals: FixedVec<T>,
    matrix: FixedVec<f64>,
    factors: Factors,
    right: FixedVec<f64>,
    per_pressure: FixedVec<T>,
    shapes: FixedVec<T>,
}

impl<T: Real> GridFollower<T> {
    /// With room for the solutions of a solver.
    #[must_use]
    pub fn new(solver: &GridSolver) -> Self {
        let (nodes, knots) = (solver.grid.nodes.capacity(), solver.knots.count());
        let unknowns = nodes + knots;
        Self {
            grid: Grid::new(solver.knots.nodes()),
            z: FixedVec::new(nodes),
            shape: FixedVec::new(knots),
            residuals: FixedVec::new(unknowns),
            matrix: FixedVec::new(unknowns * unknowns),
            factors: Factors::with_capacity(unknowns),
            right: FixedVec::new(unknowns),
            per_pressure: FixedVec::new(nodes),
            shapes: FixedVec::new(nodes),
        }
    }
}

impl<const N: usize> GridFollower<Dual<N>> {
    /// Fills `strips` with the zones of the last solution of `solver` as they move with `line`;
    /// false where that was not one.
    pub fn follow(
        &mut self,
        solver: &mut GridSolver,
        line: &mut impl OverlapLine<Dual<N>>,
        contact_modulus: f64,
        strips: &mut Strips<Dual<N>>,
    ) -> bool {
        if solver.overlaps.intervals.is_empty() || solver.grid.nodes.is_empty() {
            return true;
        }
        let count = solver.grid.nodes.len();
        let grid = &mut self.grid;
        grid.lay(line, &solver.overlaps, &solver.knots);
        if grid.nodes.len() != count {
            return false;
        }
        let size = solver.newton.matrix_at(&solver.grid, &solver.knots, &mut self.matrix);
        if !self.factors.of(&self.matrix, size) {
            return false;
        }
        self.z.clear();
        self.z.extend(solver.newton.unknowns.z[..count].iter().map(|&z| Dual::from(z)));
        self.shape.clear();
        self.shape.extend(solver.newton.unknowns.shape.iter().map(|&shape| Dual::from(shape)));
        for _ in 0..MAX_TURNS {
            let (z, shape) = (&self.z, &self.shape);
            residuals(grid, &solver.knots, z, shape, &mut self.per_pressure, &mut self.residuals);
            let mut worst = 0.0f64;
            for direction in 0..N {
                self.right.clear();
                self.right.extend(self.residuals.iter().map(|r| r.slopes[direction]));
                self.factors.solve(&mut self.right);
                let unknowns = self.z.iter_mut().chain(self.shape.iter_mut());
                let (mut change, mut greatest) = ([0.0f64; 2], [0.0f64; 2]);
                for (i, (unknown, step)) in unknowns.zip(self.right.iter()).enumerate() {
                    let kind = usize::from(i >= count);
                    let slope = &mut unknown.slopes[direction];
                    *slope -= step;
                    change[kind] = change[kind].max(step.abs());
                    greatest[kind] = greatest[kind].max(slope.abs());
                }
                for (change, greatest) in change.into_iter().zip(greatest) {
                    let share = if change == 0.0 { 0.0 } else { change / greatest };
                    // Not a number is no end.
                    worst = if share <= worst { worst } else { share };
                }
            }
            if worst < LAST_CHANGE {
                break;
            }
        }
        self.shapes.clear();
        self.shapes.extend(grid.nodes.iter().map(|node| node.between.value(&self.shape)));
        Loads { grid, z: &self.z, shapes: &self.shapes }.emit(contact_modulus, strips);
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::contacts::separation::Probe;
    use crate::normal::strips_on_grid::{Line, LinePlace};
    use crate::normal::strips_on_grid::{OverlapLine, Place};
    use approx::assert_relative_eq;

    /// Two humps, the second one shifted by `tilt` against the first one, `depth` deep; all of it
    /// tilted.
    #[derive(Clone, Copy)]
    struct Humps<T> {
        depth: T,
        tilt: T,
    }

    impl<T: Real> Humps<T> {
        fn overlap(&self, y: T) -> T {
            let wave = (y * 600.0).sin_cos().1;
            self.depth + self.tilt * y - y * y * 0.4 + wave * 8e-6
        }

        fn place_at(&self, y: T) -> Place<T> {
            let (sine, cosine) = (y * 20.0).sin_cos();
            Place { u: y, overlap: self.overlap(y), x: y * y * 2.0, tangent: [cosine, sine] }
        }
    }

    impl Line for Humps<f64> {
        fn place(&mut self, u: f64) -> LinePlace {
            let Place { overlap, x, tangent, .. } = self.place_at(u);
            let slope = self.tilt - 0.8 * u - (600.0 * u).sin() * 600.0 * 8e-6;
            LinePlace { u, y: u, dy: 1.0, overlap, overlap_slope: slope, x, tangent }
        }

        fn radius(&mut self, u: f64) -> f64 {
            0.46 + u
        }
    }

    impl OverlapLine<Dual<2>> for Humps<Dual<2>> {
        fn at(&mut self, y: Dual<2>, _: f64) -> Place<Dual<2>> {
            self.place_at(y)
        }

        fn section_radius(&mut self, u: Dual<2>) -> Dual<2> {
            u + 0.46
        }
    }

    fn solve(solver: &mut GridSolver, depth: f64, tilt: f64) -> Strips {
        let mut line = Humps { depth, tilt };
        let probes: Vec<Probe> = (-300..=300)
            .map(|i| 1e-4 * f64::from(i))
            .map(|u| Probe { u, f: -line.place(u).overlap })
            .collect();
        let mut strips = Strips::with_capacity(8, 40);
        solver.solve(&mut line, &probes, 0.0, 1.0, &mut strips);
        strips
    }

    #[test]
    fn derivatives_are_those_of_the_solution() {
        let mut solver = GridSolver::new(20);
        for (depth, tilt) in [(6e-5, 0.0), (3e-5, 1e-3), (1.2e-4, -2e-3), (1.5e-5, 4e-4)] {
            let sums = |strips: &Strips| -> [f64; 4] {
                let moment: f64 = strips.zones.iter().map(|zone| zone.load * zone.y).sum();
                let middle = strips.y.len() / 2;
                [strips.load(), moment, strips.half_length[middle], strips.u[middle]]
            };
            let step = 1e-9;
            let difference = |solver: &mut GridSolver, way: [f64; 2]| -> [f64; 4] {
                let at = |solver: &mut GridSolver, k: f64| {
                    sums(&solve(solver, depth + k * step * way[0], tilt + k * step * way[1]))
                };
                let [a, b] = [at(solver, 1.0), at(solver, -1.0)];
                [0, 1, 2, 3].map(|i| (a[i] - b[i]) / (2.0 * step))
            };
            let differences = [[1.0, 0.0], [0.0, 1.0]].map(|way| difference(&mut solver, way));
            let found = solve(&mut solver, depth, tilt);
            let mut line = Humps { depth: Dual::variable(depth, 0), tilt: Dual::variable(tilt, 1) };
            let mut strips = Strips::with_capacity(8, 40);
            let mut follower = GridFollower::new(&solver);
            assert!(follower.follow(&mut solver, &mut line, 1.0, &mut strips));
            assert_relative_eq!(strips.load().value, found.load(), max_relative = 1e-12);
            let moment: Dual<2> = strips.zones.iter().map(|zone| zone.load * zone.y).sum();
            let middle = strips.y.len() / 2;
            let numbers = [strips.load(), moment, strips.half_length[middle], strips.u[middle]];
            for (k, number) in numbers.into_iter().enumerate() {
                // Moments are those of loads millimetres away; lengths have slopes of their own.
                let scale = if k < 2 {
                    [1.0, 5e-3][k] * differences[0][0].abs().max(differences[1][0].abs())
                } else {
                    differences[0][k].abs().max(differences[1][k].abs())
                };
                for (slope, difference) in number.slopes.iter().zip(differences) {
                    // Lengths bend within the step where a node begins to carry load.
                    let share = if k == 2 { 1e-3 } else { 1e-4 };
                    assert_relative_eq!(*slope, difference[k], epsilon = share * scale);
                }
            }
        }
    }
}
