//! The second derivatives of the energy, as a matrix.

use super::super::factor::Factor;
use super::super::lanes::{FEW, Four, LANES, Lanes, Simd, by_blocks, first, first_mut, stride};
use super::super::problem::Problem;
use super::{Second, System, ZERO};

/// Column j of K + M T: four rows, from those of columns j - 1 to j + 1.
#[inline(always)]
fn by_load<S: Simd>(simd: S, ties: [f64; 3], [a, b, c]: [&Second; 3]) -> Four<S> {
    combine(simd, &b.value, ties, [&a.mixed, &b.mixed, &c.mixed])
}

/// As [`by_load`], of Mᵀ + S T.
#[inline(always)]
fn by_smooth<S: Simd>(simd: S, ties: [f64; 3], [a, b, c]: [&Second; 3]) -> Four<S> {
    combine(simd, &b.across, ties, [&a.twice, &b.twice, &c.twice])
}

/// `sum` and three columns times `factors`.
#[inline(always)]
fn combine<S: Simd>(simd: S, sum: &Lanes, factors: [f64; 3], columns: [&Lanes; 3]) -> Four<S> {
    simd.four(sum)
        .add_product(simd.splat(factors[0]), simd.four(columns[0]))
        .add_product(simd.splat(factors[1]), simd.four(columns[1]))
        .add_product(simd.splat(factors[2]), simd.four(columns[2]))
}

impl System {
    /// Adds what the second derivatives have on the diagonal, and mirrors those that the Hessian
    /// needs on both sides.
    #[inline(always)]
    pub(super) fn complete<S: Simd>(&mut self, simd: S) {
        let (blocks, stride) = (self.blocks, stride::<0>(self.blocks));
        for j in 0..self.nodes.len() {
            let (block, lane) = (j / LANES, j % LANES);
            let (state, sums) = (&self.state[block], &self.sums[block]);
            let (rate, load_rate) = (state.rate[lane], state.load_rate[lane]);
            let second = &mut self.second[(j + 1) * stride + block];
            second.mixed[lane] += rate * sums.by_square[lane];
            second.across[lane] = second.mixed[lane];
            second.twice[lane] += rate * load_rate * sums.by_square_twice[lane];
        }
        for right in 1..blocks {
            for upper in 0..right {
                let from = (upper * LANES + 1) * stride + right;
                let lower: [Second; LANES] =
                    std::array::from_fn(|k| self.second[from + k * stride]);
                let mixed = Four::columns(simd, lower.map(|second| second.across));
                let twice = Four::columns(simd, lower.map(|second| second.twice));
                let to = (right * LANES + 1) * stride + upper;
                for (k, (mixed, twice)) in mixed.into_iter().zip(twice).enumerate() {
                    let second = &mut self.second[to + k * stride];
                    (second.mixed, second.twice) = (mixed.lanes(), twice.lanes());
                }
            }
            // Of what is across, the one number beside the diagonal.
            let column = (right * LANES + 1) * stride;
            self.second[column + right - 1].across[LANES - 1] =
                self.second[column - stride + right].mixed[0];
        }
    }

    /// Puts the Hessian into `factor`: χ first, then loads.
    #[inline(always)]
    pub fn assemble<S: Simd>(&mut self, simd: S, problem: &Problem, factor: &mut Factor) {
        factor.resize([problem.knots.count, self.nodes.len()]);
        for block in 0..self.blocks {
            by_blocks!(self.blocks - block, self.blocks => R, {
                self.take_to_loads::<S, R>(simd, block, factor);
            });
        }
        by_blocks!(self.blocks => B, {
            self.take_to_shape::<S, B>(simd, problem, factor);
        });
    }

    /// Second derivatives by the loads, K + M T + T (Mᵀ + S T) with M by loads and s, S by s twice,
    /// for four number `block`.
    #[inline(always)]
    fn take_to_loads<S: Simd, const R: usize>(&self, simd: S, block: usize, factor: &mut Factor) {
        let (stride, rest) = (stride::<R>(self.blocks), self.blocks - block);
        let own = &self.fixed[block];
        let fixed = first::<R, _>(&self.fixed[block..], rest);
        let above = factor.first;
        for lane in 0..LANES.min(self.nodes.len() - block * LANES) {
            let j = block * LANES + lane;
            let ties = [own.before[lane], own.diagonal[lane], own.behind[lane]];
            let columns = [j, j + 1, j + 2].map(|column| &self.second[column * stride + block..]);
            let columns = columns.map(|column| first::<R, _>(column, rest));
            let mut last = simd.splat(0.0);
            if lane == 0 && block > 0 {
                let columns = [j, j + 1, j + 2].map(|column| column * stride + block - 1);
                last = by_smooth(simd, ties, columns.map(|at| &self.second[at]));
            }
            let to = &mut factor.column(above * LANES + j)[above + block..];
            let to = first_mut::<R, _>(to, rest);
            let mut here = by_smooth(simd, ties, columns.map(|column| &column[0]));
            for b in 0..to.len() {
                let mut next = simd.splat(0.0);
                if b + 1 < to.len() {
                    next = by_smooth(simd, ties, columns.map(|column| &column[b + 1]));
                }
                let by_load = by_load(simd, ties, columns.map(|column| &column[b]));
                to[b] = (by_load + fixed[b].tie(simd, [last, here, next])).lanes();
                (last, here) = (here, next);
            }
        }
    }

    /// Second derivatives by χ and the loads, and by χ twice.
    #[inline(always)]
    fn take_to_shape<S: Simd, const B: usize>(
        &mut self,
        simd: S,
        problem: &Problem,
        factor: &mut Factor,
    ) {
        let (blocks, m, above) = (self.blocks, problem.knots.count, factor.first);
        let stride = stride::<B>(blocks);
        let zero = simd.splat(0.0);
        let weights = self.smooth_by_shape.as_flattened();
        let by_load = &mut self.by_load_and_shape[..m * stride];
        let by_smooth = &mut self.by_smooth_and_shape[..m * stride];
        by_load[..blocks].fill(ZERO);
        by_smooth[..blocks].fill(ZERO);
        let mut from = 0;
        for (knot, &end) in self.ends[..m - 1].iter().enumerate() {
            // The nodes between this knot and the next one.
            let column = knot * stride * LANES;
            let here = &weights[column + from..column + end];
            let there = &weights[column + stride * LANES + from..column + stride * LANES + end];
            let nodes = &self.second[(from + 1) * stride..(end + 1) * stride];
            let column = knot * stride..(knot + 2) * stride;
            let (own, next) = by_load[column.clone()].split_at_mut(stride);
            let (own_smooth, next_smooth) = by_smooth[column].split_at_mut(stride);
            for b in 0..if B > 0 { B } else { blocks } {
                let mut sums = [simd.four(&own[b]), zero, simd.four(&own_smooth[b]), zero];
                let nodes = nodes.chunks_exact(stride).zip(here.iter().zip(there));
                for (second, (&here, &there)) in nodes {
                    let (here, there) = (simd.splat(here), simd.splat(there));
                    let (mixed, twice) = (simd.four(&second[b].mixed), simd.four(&second[b].twice));
                    sums = [
                        sums[0].add_product(here, mixed),
                        sums[1].add_product(there, mixed),
                        sums[2].add_product(here, twice),
                        sums[3].add_product(there, twice),
                    ];
                }
                (own[b], next[b]) = (sums[0].lanes(), sums[1].lanes());
                (own_smooth[b], next_smooth[b]) = (sums[2].lanes(), sums[3].lanes());
            }
            from = end;
        }
        let unit = problem.scales.energy;
        let fixed = first::<B, _>(&self.fixed, blocks);
        for knot in 0..m {
            let column = knot * stride;
            let by_load = first::<B, _>(&self.by_load_and_shape[column..], blocks);
            let smooth = first_mut::<B, _>(&mut self.by_smooth_and_shape[column..], blocks);
            let hats = first::<B, _>(&self.hats_of_knots[column..], blocks);
            for ((smooth, hat), by_smooth) in smooth.iter_mut().zip(hats).zip(&self.by_smooth) {
                let own = simd.four(smooth);
                *smooth = own.sub_product(simd.four(by_smooth), simd.four(hat)).lanes();
            }
            let (head, to) = factor.column(knot).split_at_mut(above);
            let to = first_mut::<B, _>(to, blocks);
            let (mut last, mut here) = (zero, simd.four(&smooth[0]));
            for b in 0..to.len() {
                let next = if b + 1 < to.len() { simd.four(&smooth[b + 1]) } else { zero };
                let tied = fixed[b].tie(simd, [last, here, next]);
                to[b] = (simd.four(&by_load[b]) + tied).lanes();
                (last, here) = (here, next);
            }
            let others = self.smooth_by_shape.chunks_exact(stride).enumerate();
            for (other, by_shape) in others.take(m).skip(knot) {
                let mut sum = zero;
                for (a, b) in first::<B, _>(by_shape, blocks).iter().zip(&*smooth) {
                    sum = sum.add_product(simd.four(a), simd.four(b));
                }
                head[other / LANES][other % LANES] =
                    sum.sum() + unit * problem.knots.penalties[knot * m + other];
            }
        }
    }
}
