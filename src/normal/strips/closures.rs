//! The linear system of the lobes without what its free ends say at once.
//!
//! At a free end the two outermost nodes follow the next three, r_0 = e - Σ f_k r_k: these rows and unknowns are taken out of the system
//! before it is solved as a dense one, so that of a lobe with free ends four less are left.

use multiversion::multiversion;

use super::nodes::Matrices;
use super::system::Assembly;
use crate::math::linear_system::{LANES, solve_by_columns, stride};

/// An unknown that follows three others.
#[derive(Clone, Copy, Debug)]
pub struct Closure {
    unknown: usize,
    others: [usize; 3],
    factors: [f64; 3],
    rest: f64,
}

/// Rows side by side that stay, and where they come to lie.
#[derive(Clone, Copy, Debug)]
pub struct Run {
    from: usize,
    to: usize,
    length: usize,
}

/// Closures of one end of a lobe.
const OF_END: usize = 2;
/// Most closures and most runs of a lobe.
pub const OF_LOBE: usize = 2 * OF_END;

impl Assembly<'_> {
    /// Solves the assembled system: `right` becomes the step. False where there is none.
    pub fn solve(&self, m: &mut Matrices) -> bool {
        self.close_ends(m);
        self.list_rest(m);
        let size = self.lobes.len() * self.unknowns_per_lobe();
        let Matrices { newton, right, runs, columns, closures, .. } = m;
        let count = runs.last().map_or(0, |run| run.to + run.length);
        // To smaller places, so that none is written before it is read.
        for (k, column) in columns.iter().enumerate() {
            let (from, to) = (column * stride(size), k * stride(count));
            for run in runs.iter() {
                let begin = from + run.from;
                newton.copy_within(begin..begin + run.length, to + run.to);
            }
            newton[to + count..to + stride(count)].fill(0.0);
        }
        for run in runs.iter() {
            right.copy_within(run.from..run.from + run.length, run.to);
        }
        if !solve_by_columns(newton, &mut right[..count]) {
            return false;
        }
        for (k, &column) in columns.iter().enumerate().rev() {
            right[column] = right[k];
        }
        for closure in closures.iter() {
            let others = closure.others.map(|other| right[other]);
            let known: f64 = closure.factors.iter().zip(others).map(|(f, r)| f * r).sum();
            right[closure.unknown] = closure.rest - known;
        }
        true
    }

    /// Puts the inner nodes in the place of the outermost ones at all free ends.
    fn close_ends(&self, m: &mut Matrices) {
        let (n, block) = (self.rule.count(), self.unknowns_per_lobe());
        let size = self.lobes.len() * block;
        let stride = stride(size);
        m.closures.clear();
        for (number, lobe) in self.lobes.iter().enumerate() {
            let begin = number * block;
            let free = [0, 1].map(|side| self.cells[lobe.cell].is_free(side));
            for side in (0..2).filter(|&side| free[side]) {
                let place = |k: usize| begin + if side == 0 { k } else { n - 1 - k };
                // The row of the edge closes the outermost node, that of the outermost node the second one.
                let rests = [begin + n + side, place(0)].map(|row| self.scale * m.right[row]);
                let [edge, second] = self.rule.outer_closures;
                for (k, closure) in [edge, second].into_iter().enumerate() {
                    m.closures.push(Closure {
                        unknown: place(k),
                        others: [2, 3, 4].map(place),
                        factors: [closure[1], closure[2], closure[3]],
                        rest: rests[k],
                    });
                }
                let Matrices { newton, right, .. } = m;
                let right = &mut right[..stride];
                let factors = [1, 2, 3].map(|k| [edge[k], second[k]]);
                if side == 0 {
                    let columns = &mut newton[begin * stride..(begin + 5) * stride];
                    let (closed, others) = columns.split_at_mut(2 * stride);
                    let (first, second) = closed.split_at(stride);
                    substitute([first, second], factors, rests, others, right);
                } else {
                    let columns = &mut newton[(begin + n - 5) * stride..(begin + n) * stride];
                    let (others, closed) = columns.split_at_mut(3 * stride);
                    let (second, first) = closed.split_at(stride);
                    let [a, b, c] = factors;
                    substitute([first, second], [c, b, a], rests, others, right);
                }
            }
        }
    }

    /// Lists the rows and the columns that are left.
    fn list_rest(&self, m: &mut Matrices) {
        let (n, block) = (self.rule.count(), self.unknowns_per_lobe());
        m.runs.clear();
        m.columns.clear();
        let mut to = 0;
        for (number, lobe) in self.lobes.iter().enumerate() {
            let free = [0, 1].map(|side| self.cells[lobe.cell].is_free(side));
            let [left, right] = free.map(usize::from);
            // Nodes without the outermost ones, edges that meet others, and shape; all at once where nothing lies between.
            for [begin, end] in [[left, n - right], [n + left, n + 1], [n + 1 + right, block]] {
                let (from, length) = (number * block + begin, end - begin);
                match m.runs.last_mut() {
                    _ if length == 0 => {}
                    Some(last) if last.from + last.length == from => last.length += length,
                    _ => m.runs.push(Run { from, to, length }),
                }
                to += length;
            }
            let [left, right] = free.map(|is_free| if is_free { OF_END } else { 0 });
            let begin = number * block;
            m.columns.extend((left..n - right).chain(n..block).map(|k| begin + k));
        }
    }
}

/// Takes two unknowns with the columns `closed` out of three columns `others` and the right side.
#[multiversion(targets("x86_64+avx2", "aarch64+neon"))]
fn substitute(
    closed: [&[f64]; 2],
    factors: [[f64; 2]; 3],
    rests: [f64; 2],
    others: &mut [f64],
    right: &mut [f64],
) {
    let stride = closed[0].len();
    let [first, second] = closed.map(|column| column.as_chunks::<LANES>().0);
    let targets = others.chunks_exact_mut(stride).chain([right]);
    for (target, [f, g]) in targets.zip(factors.into_iter().chain([rests])) {
        let target = target.as_chunks_mut::<LANES>().0;
        for ((values, a), b) in target.iter_mut().zip(first).zip(second) {
            let mut rest = *values;
            for k in 0..LANES {
                rest[k] -= f * a[k] + g * b[k];
            }
            *values = rest;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    use crate::geometry::separation::{Probe, Separation, SeparationPoint};
    use crate::normal::Strips;
    use crate::normal::strips::FrameLine;
    use crate::normal::strips::solver::StripSolver;

    /// Two bowls beside each other, whose lobes have met.
    struct Bowls;

    impl Separation for Bowls {
        fn at(&mut self, u: f64) -> SeparationPoint {
            let f = 4e7 * (u * u - 9e-6) * (u * u - 9e-6) / 81.0;
            SeparationPoint { y: u, dy: 1.0, f, x: 0.0 }
        }
    }

    #[test]
    fn the_smaller_system_has_the_solution_of_the_whole_one() {
        for (approach, met) in [(3e-5, false), (3e-4, true)] {
            for count in [7, 8, 12, 35] {
                let probes: Vec<Probe> = (-90..=90)
                    .map(|i| f64::from(i) * 1e-4)
                    .map(|u| Probe { u, f: Bowls.at(u).f })
                    .collect();
                let mut line = FrameLine { separation: &mut Bowls, approach, radius: 0.5 };
                let mut solver = StripSolver::new(count);
                let mut strips = Strips::with_capacity(4, count);
                assert!(solver.solve(&mut line, &probes, approach, 1e11, &mut strips));
                assert_eq!(solver.lobes.len(), 2);
                assert_eq!(solver.cells[0].met, [false, met]);
                // Away from the solution, so that there is a step.
                for (k, ratio) in solver.nodes.ratio.iter_mut().enumerate() {
                    *ratio *= 1.0 + 0.01 * (k as f64).sin();
                }
                let assembly = Assembly {
                    rule: &solver.rule,
                    integrals: &solver.integrals,
                    cells: &solver.cells,
                    lobes: &solver.lobes,
                    nodes: &solver.nodes,
                    skewed: false,
                    depth: approach,
                    scale: solver.nodes.ratio.iter().fold(0.0, |a: f64, b| a.max(*b)),
                };
                let size = 2 * assembly.unknowns_per_lobe();
                assembly.assemble(&mut solver.matrices);
                let mut whole = solver.matrices.newton.clone();
                let mut step = solver.matrices.right[..size].to_vec();
                assert!(solve_by_columns(&mut whole, &mut step));
                assert!(assembly.solve(&mut solver.matrices));
                let greatest = step.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
                for (own, step) in solver.matrices.right.iter().zip(&step) {
                    approx::assert_abs_diff_eq!(own, step, epsilon = 1e-9 * greatest);
                }
            }
        }
    }
}
