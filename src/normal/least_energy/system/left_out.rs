//! What the nodes without load feel, those that are left out among them.

use super::super::kernel::Table;
use super::super::lanes::{LANES, Simd};
use super::super::potential::potential;
use super::super::problem::Problem;
use super::System;

impl System {
    /// Gradient by the load of the node that was taken as number `k`, when it was last known.
    pub fn gradient(&self, k: usize) -> f64 {
        self.gradient[k / LANES][k % LANES]
    }

    /// Gradient by the load of node `i` of `problem`, which carries none, from the last derivatives
    /// by s: negative where the overlap is more than the others push away. Where it is certainly
    /// positive, a number below it that is positive too.
    #[inline(always)]
    pub fn pull<S: Simd>(&mut self, simd: S, table: &Table, problem: &Problem, i: usize) -> f64 {
        let (point, blocks) = (&problem.points[i], self.blocks);
        let place = self.nodes.partition_point(|&taken| taken < i);
        let (mut smooth, mut by) = (0.0, 0.0);
        let mut tie = |k: usize, other: usize, tie: f64| {
            if self.nodes.get(k) == Some(&other) {
                smooth += tie * self.state[k / LANES].load[k % LANES];
                by += tie * self.by_smooth[k / LANES][k % LANES];
            }
        };
        tie(place.wrapping_sub(1), i.wrapping_sub(1), point.before);
        let next = place + usize::from(self.nodes.get(place) == Some(&i));
        tie(next, i + 1, problem.points.get(i + 1).map_or(0.0, |next| next.before));
        let mut square = problem.scales.least_square;
        if smooth > 0.0 {
            let shape = problem.knots.value(i, &self.shape);
            square +=
                problem.scales.load * problem.scales.square_over_load * (-shape).exp() * smooth;
        }
        let push = by + point.bending * square - point.overlap;
        let mut least = simd.splat(0.0);
        for (b, state) in self.state[..blocks].iter().enumerate() {
            let squares = simd.four(&state.square) + square;
            let potential = self.hats.least_potential(simd, b, &point.hat, squares);
            least = least.add_product(potential, simd.four(&state.load));
        }
        let least = least.sum() + push;
        if least > 0.0 {
            return least;
        }
        simd.apart(
            #[inline(always)]
            || {
                let pairs = &mut self.pairs_of_one[..blocks];
                self.hats.measure(simd, 0, &point.hat, pairs);
                let mut sum = simd.splat(0.0);
                for (pairs, state) in pairs.iter().zip(&self.state) {
                    let squares = simd.four(&state.square);
                    let square = simd.splat(square);
                    let value = if self.hats.is_skewed {
                        potential::<S, true>(simd, table, pairs, squares, square)
                    } else {
                        potential::<S, false>(simd, table, pairs, squares, square)
                    };
                    sum = sum.add_product(value, simd.four(&state.load));
                }
                sum.sum() + push
            },
        )
    }
}
