//! The energy and its first derivatives.

use super::super::kernel::Table;
use super::super::lanes::{FEW, Four, LANES, Lanes, Simd, by_blocks, first, first_mut, stride};
use super::super::potential::potentials;
use super::super::problem::Problem;
use super::{Second, Sums, System, ZERO, add_product};

/// Adds the sums of the numbers `of` of four nodes to `sum`.
#[inline(always)]
fn add_sums<S: Simd>(simd: S, sum: &mut Lanes, nodes: &[[Lanes; 3]; LANES], of: usize) {
    let [a, b, c, d] = Four::columns(simd, nodes.map(|node| node[of]));
    *sum = (simd.four(sum) + ((a + b) + (c + d))).lanes();
}

impl System {
    /// Energy and gradient, and with `SECOND` what the Hessian consists of, at the present
    /// unknowns.
    #[inline(always)]
    pub fn differentiate<S: Simd, const SECOND: bool>(
        &mut self,
        simd: S,
        table: &Table,
        problem: &Problem,
    ) {
        self.stretch(simd, problem);
        simd.apart(
            #[inline(always)]
            || self.sum_up::<S, SECOND>(simd, table),
        );
        by_blocks!(self.blocks => B, self.add_up::<S, B>(simd, problem));
        if SECOND {
            simd.apart(
                #[inline(always)]
                || self.complete(simd),
            );
        }
    }

    /// Gives the curvature of the displacement along each node that is taken, over that of the
    /// wheel, at the present unknowns.
    #[inline(always)]
    pub fn give_curvatures<S: Simd>(
        &mut self,
        simd: S,
        table: &Table,
        problem: &Problem,
        curvatures: &mut [f64],
    ) {
        self.stretch(simd, problem);
        simd.apart(
            #[inline(always)]
            || self.sum_up::<S, false>(simd, table),
        );
        for (nodes, sums) in self.nodes.chunks(LANES).zip(&self.sums) {
            for (&i, by_square) in nodes.iter().zip(sums.by_square) {
                curvatures[i] = -by_square / problem.points[i].bending;
            }
        }
    }

    /// Sums and second derivatives over all pairs, those below the diagonal and beside it.
    #[inline(always)]
    pub(super) fn sum_up<S: Simd, const SECOND: bool>(&mut self, simd: S, table: &Table) {
        if self.hats.is_skewed {
            self.sum_up_pairs::<S, SECOND, true>(simd, table);
        } else {
            self.sum_up_pairs::<S, SECOND, false>(simd, table);
        }
    }

    #[inline(always)]
    fn sum_up_pairs<S: Simd, const SECOND: bool, const SKEWED: bool>(
        &mut self,
        simd: S,
        table: &Table,
    ) {
        let blocks = self.blocks;
        let stride = stride::<0>(blocks);
        self.sums[..blocks].fill(Sums::default());
        for j in 0..self.nodes.len() {
            let (from, lane) = (j / LANES, j % LANES);
            let own = &self.state[from];
            let q = simd.splat(own.square[lane]);
            let load = simd.splat(own.load[lane]);
            let rate = simd.splat(own.load_rate[lane]);
            let mut beyond = [simd.splat(0.0); 3];
            let column = &self.pairs[j * stride + from..j * stride + blocks];
            let state = &self.state[from..blocks];
            let sums = &mut self.sums[from..blocks];
            let second = (j + 1) * stride;
            let second = &mut self.second[second + from..second + blocks];
            let rows = column.iter().zip(state).zip(sums).zip(second);
            for (b, (((pairs, state), sums), second)) in rows.enumerate() {
                let k = potentials::<S, SECOND, SKEWED>(
                    simd,
                    table,
                    pairs,
                    simd.four(&state.square),
                    q,
                );
                add_product(simd, &mut sums.displacement, k.value, load);
                add_product(simd, &mut sums.by_square, k.by_p, load);
                let others = simd.four(&state.load);
                // Pairs in the four of the node are met from both sides.
                if b > 0 {
                    beyond[0] = beyond[0].add_product(k.value, others);
                    beyond[1] = beyond[1].add_product(k.by_q, others);
                }
                second.value = k.value.lanes();
                if SECOND {
                    add_product(simd, &mut sums.by_square_twice, k.by_pp, load);
                    if b > 0 {
                        beyond[2] = beyond[2].add_product(k.by_qq, others);
                    }
                    let rates = simd.four(&state.load_rate);
                    *second = Second {
                        value: k.value.lanes(),
                        mixed: (rate * k.by_q).lanes(),
                        across: (rates * k.by_p).lanes(),
                        twice: (rate * rates * k.by_pq).lanes(),
                    };
                }
            }
            let [displacement, once, twice] = beyond;
            self.beyond[j] = [displacement.lanes(), once.lanes(), twice.lanes()];
        }
        self.beyond[self.nodes.len()..blocks * LANES].fill([ZERO; 3]);
        for (sums, beyond) in self.sums[..blocks].iter_mut().zip(self.beyond.as_chunks().0) {
            add_sums(simd, &mut sums.displacement, beyond, 0);
            add_sums(simd, &mut sums.by_square, beyond, 1);
            if SECOND {
                add_sums(simd, &mut sums.by_square_twice, beyond, 2);
            }
        }
    }

    /// Energy and gradient from the sums.
    #[inline(always)]
    fn add_up<S: Simd, const B: usize>(&mut self, simd: S, problem: &Problem) {
        let blocks = self.blocks;
        let zero = simd.splat(0.0);
        let mut energy = zero;
        let fixed = first::<B, _>(&self.fixed, blocks);
        let state = first::<B, _>(&self.state, blocks);
        let sums = first_mut::<B, _>(&mut self.sums, blocks);
        let by_smooth = first_mut::<B, _>(&mut self.by_smooth, blocks);
        let gradient = first_mut::<B, _>(&mut self.gradient, blocks);
        for b in 0..fixed.len() {
            let bending = simd.four(&fixed[b].bending);
            let by_square = simd.four(&sums[b].by_square) + bending;
            sums[b].by_square = by_square.lanes();
            by_smooth[b] = (by_square * simd.four(&state[b].load_rate)).lanes();
            let displacement = simd.four(&sums[b].displacement);
            let by_load = (displacement - simd.four(&fixed[b].overlap))
                .add_product(bending, simd.four(&state[b].square));
            gradient[b] = by_load.lanes();
            let per_load = by_load.sub_product(displacement, simd.splat(0.5));
            energy = energy.add_product(simd.four(&state[b].load), per_load);
        }
        let (mut last, mut here) = (zero, simd.four(&by_smooth[0]));
        for b in 0..fixed.len() {
            let next = if b + 1 < fixed.len() { simd.four(&by_smooth[b + 1]) } else { zero };
            let tied = fixed[b].tie(simd, [last, here, next]);
            gradient[b] = (simd.four(&gradient[b]) + tied).lanes();
            (last, here) = (here, next);
        }
        self.energy = energy.sum();
        let unit = problem.scales.energy;
        self.shape_gradient.clear();
        let stiffness = problem.knots.penalties.chunks_exact(problem.knots.count);
        let columns = self.smooth_by_shape.chunks_exact(stride::<B>(blocks));
        for ((stiffness, column), own) in stiffness.zip(columns).zip(self.shape.iter()) {
            let mut by = zero;
            for (smooth, by_smooth) in first::<B, _>(column, blocks).iter().zip(&*by_smooth) {
                by = by.add_product(simd.four(smooth), simd.four(by_smooth));
            }
            let force: f64 = stiffness.iter().zip(self.shape.iter()).map(|(a, x)| a * x).sum();
            self.energy += 0.5 * unit * own * force;
            self.shape_gradient.push(by.sum() + unit * force);
        }
    }
}
