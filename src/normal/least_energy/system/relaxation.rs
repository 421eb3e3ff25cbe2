//! Steps towards the least energy without second derivatives, for Newton's method to start from.

use super::super::kernel::Table;
use super::super::lanes::{Four, LANES, Simd, stride};
use super::super::problem::Problem;
use super::{System, add_product};
use crate::math::real::Real;

/// Times that each load is brought to rest in one step.
const SWEEPS: usize = 4;

impl System {
    /// Improves loads and χ without second derivatives; returns the greatest change of a load per
    /// width over that of the ellipse.
    ///
    /// χ follows the curvature of the displacement along the strips as it does where zones are read
    /// off. Lengths at rest, the energy is a square of the loads, whose least value is approached
    /// load by load.
    #[inline(always)]
    pub fn relax<S: Simd>(&mut self, simd: S, table: &Table, problem: &Problem) -> f64 {
        self.stretch(simd, problem);
        simd.apart(
            #[inline(always)]
            || {
                self.sum_up::<S, false>(simd, table);
                self.relax_shape(simd);
                self.mirror_values(simd);
                self.relax_loads(simd)
            },
        )
    }

    /// Moves χ at each knot by the mean of what the strips around it ask for.
    #[inline(always)]
    fn relax_shape<S: Simd>(&mut self, simd: S) {
        let (blocks, stride) = (self.blocks, stride::<0>(self.blocks));
        let columns = self.hats_of_knots.chunks_exact(stride);
        for (shape, hats) in self.shape.iter_mut().zip(columns) {
            let (mut sum, mut weight) = (simd.splat(0.0), simd.splat(f64::MIN_POSITIVE));
            let nodes = self.fixed[..blocks].iter().zip(&self.state).zip(&self.sums).zip(hats);
            for (((fixed, state), sums), hat) in nodes {
                let bending = simd.four(&fixed.bending);
                // Work of the curvature: strips without load or length say nothing.
                let work = simd.four(&state.load) * simd.four(&state.square) * simd.four(hat);
                let flatter = (simd.four(&sums.by_square) + bending) * work;
                weight = weight.add_product(work, bending);
                sum = sum + flatter;
            }
            let step = sum.sum() / weight.sum();
            *shape += step / step.hypotenuse(1.0);
        }
    }

    /// Gives all potentials to both of their strips.
    #[inline(always)]
    fn mirror_values<S: Simd>(&mut self, simd: S) {
        let stride = stride::<0>(self.blocks);
        for right in 1..self.blocks {
            for upper in 0..right {
                let from = (upper * LANES + 1) * stride + right;
                let lower = std::array::from_fn(|k| self.second[from + k * stride].value);
                let to = (right * LANES + 1) * stride + upper;
                for (k, value) in Four::columns(simd, lower).into_iter().enumerate() {
                    self.second[to + k * stride].value = value.lanes();
                }
            }
        }
    }

    /// Brings load after load to where its strip rests, up and down the nodes; as
    /// [`relax`](Self::relax).
    #[inline(always)]
    fn relax_loads<S: Simd>(&mut self, simd: S) -> f64 {
        let (blocks, stride) = (self.blocks, stride::<0>(self.blocks));
        for b in 0..blocks {
            let (fixed, state, sums) = (&self.fixed[b], &self.state[b], &self.sums[b]);
            let bending = simd.four(&fixed.bending);
            let rest = simd.four(&sums.displacement) - simd.four(&fixed.overlap);
            self.gradient[b] = rest.add_product(bending, simd.four(&state.square)).lanes();
            // What nodes beside loaded ones feel hangs on it.
            let by_square = simd.four(&sums.by_square) + bending;
            self.by_smooth[b] = (by_square * simd.four(&state.load_rate)).lanes();
        }
        let mut greatest = 0.0_f64;
        for sweep in 0..SWEEPS {
            greatest = 0.0;
            for k in 0..self.nodes.len() {
                let j = if sweep % 2 == 0 { k } else { self.nodes.len() - 1 - k };
                let (block, lane) = (j / LANES, j % LANES);
                let column = &self.second[(j + 1) * stride..(j + 1) * stride + blocks];
                let load = &mut self.state[block].load[lane];
                let step = (-self.gradient[block][lane] / column[block].value[lane]).max(-*load);
                *load += step;
                greatest = greatest.max(step.abs() * self.fixed[block].inverse_width[lane]);
                let step = simd.splat(step);
                for (gradient, second) in self.gradient[..blocks].iter_mut().zip(column) {
                    add_product(simd, gradient, step, simd.four(&second.value));
                }
            }
        }
        greatest
    }
}
