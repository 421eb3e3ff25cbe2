//! The energy of some nodes, its gradient and its Hessian.
//!
//! Unknown are the loads of the nodes, λ_i = w_i l_i over that of the ellipse [m], and χ at the
//! knots. With s = T λ, the mean of the load per width over a hat,
//!
//! ```text
//! P_i = a_i² = f² + Q_i,  Q_i = s_i q_0 exp(-χ_i)
//! W = ½ Σ λ_i λ_j K_ij(P_i, P_j) - Σ λ_i (o_i - κ_i P_i) + ½ penalty(χ),   κ_i = π/(8 R_i) over the load of the ellipse
//! ```
//!
//! Derivatives by s are found first, with Q_i as the function of s_i and χ_i that it is. T takes
//! those by s to the loads, and -s_i times the hats of the knots takes them to χ, which changes Q_i
//! as a change of s_i does. Nodes without load act on nothing: those far from all load are left
//! out, and [`System::pull`] tells what they feel.

use super::factor::Factor;
use super::kernel::Table;
use super::lanes::{FEW, Four, LANES, Lanes, Simd, by_blocks, first, first_mut, stride};
use super::pairs::{Hats, Pairs};
use super::potential::{potential, potentials};
use super::problem::Problem;
use super::shape::Knots;
use crate::math::fixed_vec::FixedVec;

const ZERO: Lanes = [0.0; LANES];

/// What four nodes have from the problem.
#[derive(Clone, Copy, Debug, Default)]
struct Fixed {
    inverse_width: Lanes,
    overlap: Lanes,
    bending: Lanes,
    /// T, on the diagonal and beside it.
    diagonal: Lanes,
    before: Lanes,
    behind: Lanes,
}

impl Fixed {
    /// T times a column, of which these are four numbers with those before and behind them.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn tie<S: Simd>(&self, simd: S, [before, here, behind]: [Four<S>; 3]) -> Four<S> {
        (simd.four(&self.diagonal) * here)
            .add_product(simd.four(&self.before), here.before(before))
            .add_product(simd.four(&self.behind), here.behind(behind))
    }
}

/// Four nodes as they are at present.
#[derive(Clone, Copy, Debug, Default)]
struct State {
    load: Lanes,
    /// s, ∂P/∂s, P, and load times ∂P/∂s.
    smooth: Lanes,
    rate: Lanes,
    square: Lanes,
    load_rate: Lanes,
}

/// Sums over all strips that act on four nodes: displacement, and its derivatives by their own P.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    displacement: Lanes,
    by_square: Lanes,
    by_square_twice: Lanes,
}

/// Second derivatives of four nodes i with one j: by λ_i and λ_j; λ_i and s_j; s_i and λ_j; s_i and
/// s_j.
#[derive(Clone, Copy, Debug, Default)]
struct Second {
    value: Lanes,
    mixed: Lanes,
    across: Lanes,
    twice: Lanes,
}

/// Adds `a` `b` to `sum`.
#[allow(clippy::inline_always)]
#[inline(always)]
fn add_product<S: Simd>(simd: S, sum: &mut Lanes, a: Four<S>, b: Four<S>) {
    *sum = simd.four(sum).add_product(a, b).lanes();
}

/// Column j of K + M T: four rows, from those of columns j - 1 to j + 1.
#[allow(clippy::inline_always)]
#[inline(always)]
fn by_load<S: Simd>(simd: S, ties: [f64; 3], [a, b, c]: [&Second; 3]) -> Four<S> {
    combine(simd, &b.value, ties, [&a.mixed, &b.mixed, &c.mixed])
}

/// As [`by_load`], of Mᵀ + S T.
#[allow(clippy::inline_always)]
#[inline(always)]
fn by_smooth<S: Simd>(simd: S, ties: [f64; 3], [a, b, c]: [&Second; 3]) -> Four<S> {
    combine(simd, &b.across, ties, [&a.twice, &b.twice, &c.twice])
}

/// `sum` and three columns times `factors`.
#[allow(clippy::inline_always)]
#[inline(always)]
fn combine<S: Simd>(simd: S, sum: &Lanes, factors: [f64; 3], columns: [&Lanes; 3]) -> Four<S> {
    simd.four(sum)
        .add_product(simd.splat(factors[0]), simd.four(columns[0]))
        .add_product(simd.splat(factors[1]), simd.four(columns[1]))
        .add_product(simd.splat(factors[2]), simd.four(columns[2]))
}

/// Adds the sums of the numbers `of` of four nodes to `sum`.
#[allow(clippy::inline_always)]
#[inline(always)]
fn add_sums<S: Simd>(simd: S, sum: &mut Lanes, nodes: &[[Lanes; 3]; LANES], of: usize) {
    let [a, b, c, d] = Four::columns(simd, nodes.map(|node| node[of]));
    *sum = (simd.four(sum) + ((a + b) + (c + d))).lanes();
}

/// The energy at the present unknowns.
#[derive(Clone, Debug)]
pub(super) struct System {
    /// Nodes that are taken.
    pub nodes: FixedVec<usize>,
    /// χ at the knots [-].
    pub shape: FixedVec<f64>,
    /// Fours of nodes.
    pub blocks: usize,
    /// Where the nodes of each interval between knots end, and the hat of each knot over the nodes.
    ends: FixedVec<usize>,
    hats_of_knots: Vec<Lanes>,
    hats: Hats,
    fixed: Vec<Fixed>,
    /// Column after column, as the second derivatives, which have one column more on both sides.
    pairs: Vec<Pairs>,
    pairs_of_one: Vec<Pairs>,
    state: Vec<State>,
    sums: Vec<Sums>,
    /// What pairs in other fours than its own add to the sums of a node.
    beyond: Vec<[Lanes; 3]>,
    second: Vec<Second>,
    /// ∂W/∂s, and the gradient by loads and by χ.
    by_smooth: Vec<Lanes>,
    gradient: Vec<Lanes>,
    pub shape_gradient: FixedVec<f64>,
    /// Derivatives of s by χ but for the sign of their effect, and second ones by loads and by s and χ.
    smooth_by_shape: Vec<Lanes>,
    by_load_and_shape: Vec<Lanes>,
    by_smooth_and_shape: Vec<Lanes>,
    /// W.
    pub energy: f64,
}

#[allow(clippy::inline_always)]
impl System {
    pub fn new(most: usize) -> Self {
        let blocks = most.div_ceil(LANES).max(FEW);
        let knots = Knots::<f64>::most(most);
        let columns = || vec![ZERO; blocks * knots];
        Self {
            nodes: FixedVec::new(most),
            shape: FixedVec::new(knots),
            blocks: 0,
            ends: FixedVec::new(knots),
            hats_of_knots: columns(),
            hats: Hats::new(most),
            fixed: vec![Fixed::default(); blocks],
            pairs: vec![Pairs::default(); blocks * LANES * blocks],
            pairs_of_one: vec![Pairs::default(); blocks],
            state: vec![State::default(); blocks],
            sums: vec![Sums::default(); blocks],
            beyond: vec![[ZERO; 3]; blocks * LANES],
            second: vec![Second::default(); (blocks * LANES + 2) * blocks],
            by_smooth: vec![ZERO; blocks],
            gradient: vec![ZERO; blocks],
            shape_gradient: FixedVec::new(knots),
            smooth_by_shape: columns(),
            by_load_and_shape: columns(),
            by_smooth_and_shape: columns(),
            energy: 0.0,
        }
    }

    /// Takes the nodes of `problem` that are in `nodes`, with their `loads`.
    #[inline(always)]
    pub fn take<S: Simd>(&mut self, simd: S, problem: &Problem, loads: &[f64]) {
        let n = self.nodes.len();
        let blocks = n.div_ceil(LANES);
        let stride = stride::<0>(blocks);
        self.blocks = blocks;
        self.hats.take(problem, &self.nodes);
        self.ends.clear();
        self.hats_of_knots[..problem.knots.count * stride].fill(ZERO);
        self.fixed[..blocks].fill(Fixed::default());
        self.state[..blocks].fill(State::default());
        let mut last = usize::MAX;
        for (k, &i) in self.nodes.iter().enumerate() {
            let (block, lane) = (k / LANES, k % LANES);
            let point = &problem.points[i];
            let fixed = &mut self.fixed[block];
            fixed.inverse_width[lane] = 1.0 / point.width;
            fixed.overlap[lane] = point.overlap;
            fixed.bending[lane] = point.bending;
            fixed.diagonal[lane] = point.diagonal;
            if last.wrapping_add(1) == i && k > 0 {
                fixed.before[lane] = point.before;
                self.fixed[(k - 1) / LANES].behind[(k - 1) % LANES] = point.before;
            }
            last = i;
            self.state[block].load[lane] = loads[i];
            let (knot, share) = problem.knots.between[i];
            while self.ends.len() < knot {
                self.ends.push(k);
            }
            let hat = knot * stride + block;
            self.hats_of_knots[hat][lane] = 1.0 - share;
            self.hats_of_knots[hat + stride][lane] = share;
            let pairs = &mut self.pairs[k * stride + block..k * stride + blocks];
            self.hats.measure(simd, block, &point.hat, pairs);
        }
        self.ends.resize(problem.knots.count, n);
        // The column behind the last one counts with nothing.
        self.second[(n + 1) * stride..(n + 2) * stride].fill(Second::default());
    }

    /// Takes over the `loads` of the nodes.
    #[inline(always)]
    pub fn put_loads(&mut self, loads: &[f64]) {
        for (k, &i) in self.nodes.iter().enumerate() {
            self.state[k / LANES].load[k % LANES] = loads[i];
        }
    }

    /// Gives the loads of the nodes to `loads`.
    #[inline(always)]
    pub fn give_loads(&self, loads: &mut [f64]) {
        for (nodes, state) in self.nodes.chunks(LANES).zip(&self.state) {
            for (&i, load) in nodes.iter().zip(state.load) {
                loads[i] = load;
            }
        }
    }

    /// Half lengths at the present unknowns.
    #[inline(always)]
    pub fn stretch<S: Simd>(&mut self, simd: S, problem: &Problem) {
        by_blocks!(self.blocks => B, self.stretch_fours::<S, B>(simd, problem));
    }

    #[inline(always)]
    fn stretch_fours<S: Simd, const B: usize>(&mut self, simd: S, problem: &Problem) {
        let (scales, blocks) = (&problem.scales, self.blocks);
        let stride = stride::<B>(blocks);
        let zero = simd.splat(0.0);
        let least = simd.splat(scales.least_square);
        let unit = scales.load * scales.square_over_load;
        let state = first_mut::<B, _>(&mut self.state, blocks);
        let fixed = first::<B, _>(&self.fixed, blocks);
        for state in state.iter_mut() {
            state.rate = ZERO;
        }
        let hats = self.hats_of_knots.chunks_exact(stride);
        for (&shape, hats) in self.shape.iter().zip(hats.clone()) {
            for (state, hat) in state.iter_mut().zip(first::<B, _>(hats, blocks)) {
                let sum = simd.four(&state.rate);
                state.rate = sum.sub_product(simd.splat(shape), simd.four(hat)).lanes();
            }
        }
        let (mut last, mut here) = (zero, simd.four(&state[0].load));
        for b in 0..state.len() {
            let next = if b + 1 < state.len() { simd.four(&state[b + 1].load) } else { zero };
            let smooth = fixed[b].tie(simd, [last, here, next]);
            let rate = simd.four(&state[b].rate).exp() * unit;
            state[b] = State {
                load: state[b].load,
                smooth: smooth.lanes(),
                rate: rate.lanes(),
                square: least.add_product(smooth, rate).lanes(),
                load_rate: (here * rate).lanes(),
            };
            (last, here) = (here, next);
        }
        let columns = self.smooth_by_shape.chunks_exact_mut(stride).zip(hats);
        for ((by, hats), _) in columns.zip(self.shape.iter()) {
            let by = first_mut::<B, _>(by, blocks);
            for ((by, hat), state) in by.iter_mut().zip(hats).zip(&*state) {
                *by = zero.sub_product(simd.four(&state.smooth), simd.four(hat)).lanes();
            }
        }
    }

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

    /// Sums and second derivatives over all pairs, those below the diagonal and beside it.
    #[inline(always)]
    fn sum_up<S: Simd, const SECOND: bool>(&mut self, simd: S, table: &Table) {
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
                let k = potentials::<S, SECOND>(simd, table, pairs, simd.four(&state.square), q);
                add_product(simd, &mut sums.displacement, k.value, load);
                add_product(simd, &mut sums.by_square, k.by_p, load);
                let others = simd.four(&state.load);
                // Pairs in the four of the node are met from both sides.
                if b > 0 {
                    beyond[0] = beyond[0].add_product(k.value, others);
                    beyond[1] = beyond[1].add_product(k.by_q, others);
                }
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

    /// Adds what the second derivatives have on the diagonal, and mirrors those that the Hessian
    /// needs on both sides.
    #[inline(always)]
    fn complete<S: Simd>(&mut self, simd: S) {
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

    /// Frees the loads that are positive or would grow in `free`.
    #[inline(always)]
    pub fn release<S: Simd, const B: usize>(&self, simd: S, free: &mut [Lanes]) {
        let (zero, one) = (simd.splat(0.0), simd.splat(1.0));
        let rows = first_mut::<B, _>(free, self.blocks).iter_mut();
        for ((free, state), gradient) in rows.zip(&self.state).zip(&self.gradient) {
            let gradient = simd.four(gradient);
            let is_loaded = zero.where_less(simd.four(&state.load), one, zero);
            *free = gradient.where_less(zero, one, is_loaded).lanes();
        }
    }

    /// The greatest gradient by a load that is positive.
    #[inline(always)]
    pub fn residual<S: Simd>(&self, simd: S) -> f64 {
        let zero = simd.splat(0.0);
        let mut greatest = zero;
        for (state, gradient) in self.state[..self.blocks].iter().zip(&self.gradient) {
            let gradient = simd.four(gradient).abs();
            greatest = greatest.max(zero.where_less(simd.four(&state.load), gradient, zero));
        }
        greatest.greatest()
    }

    /// Whether a load that is held would grow.
    #[inline(always)]
    pub fn is_pulled<S: Simd, const B: usize>(&self, simd: S, free: &[Lanes]) -> bool {
        let zero = simd.splat(0.0);
        let mut pulled = zero;
        let rows = first::<B, _>(free, self.blocks).iter();
        for (free, gradient) in rows.zip(&self.gradient) {
            let held = simd.splat(1.0) - simd.four(free);
            pulled = pulled.max(simd.four(gradient).where_less(zero, held, zero));
        }
        pulled.greatest() > 0.0
    }

    /// Puts what the step is to make zero into `right`: the gradients by what is free, and loads
    /// that are held times what holds them.
    #[inline(always)]
    pub fn load_up<S: Simd, const B: usize>(&self, simd: S, factor: &Factor, right: &mut [Lanes]) {
        let zero = simd.splat(0.0);
        let (head, right) = right.split_at_mut(factor.first);
        for (head, gradient) in head.as_flattened_mut().iter_mut().zip(self.shape_gradient.iter()) {
            *head = -gradient;
        }
        let right = first_mut::<B, _>(right, self.blocks);
        let (free, shift) = (&factor.free[factor.first..], &factor.shift[factor.first..]);
        for b in 0..right.len() {
            let held = simd.four(&shift[b]) * simd.four(&self.state[b].load);
            let force = simd.four(&free[b]).where_equal(1.0, simd.four(&self.gradient[b]), held);
            right[b] = (zero - force).lanes();
        }
    }

    /// Holds the loads that are free and would become negative with `step`; whether there are any.
    #[inline(always)]
    pub fn hold<S: Simd, const B: usize>(
        &self,
        simd: S,
        step: &[Lanes],
        free: &mut [Lanes],
    ) -> bool {
        let zero = simd.splat(0.0);
        let mut below = zero;
        let rows = first_mut::<B, _>(free, self.blocks).iter_mut();
        for ((free, state), step) in rows.zip(&self.state).zip(step) {
            let new = simd.four(&state.load) + simd.four(step);
            let own = new.where_less(zero, simd.four(free), zero);
            *free = (simd.four(free) - own).lanes();
            below = below.max(own);
        }
        below.greatest() > 0.0
    }

    /// Puts the inverse squares of the widths of the hats into `weights`.
    #[inline(always)]
    pub fn weigh(&self, weights: &mut [Lanes]) {
        for (weights, fixed) in weights.iter_mut().zip(&self.fixed[..self.blocks]) {
            *weights = fixed.inverse_width.map(|inverse| inverse * inverse);
        }
    }

    /// Greatest change of a load over the width of its hat by `step`, and what the energy changes by
    /// to first order.
    #[inline(always)]
    pub fn measure<S: Simd, const B: usize>(&self, simd: S, step: &[Lanes]) -> [f64; 2] {
        let (mut greatest, mut slope) = (simd.splat(0.0), simd.splat(0.0));
        let rows = first::<B, _>(step, self.blocks).iter().zip(&self.fixed).zip(&self.gradient);
        for ((step, fixed), gradient) in rows {
            let step = simd.four(step);
            greatest = greatest.max((step * simd.four(&fixed.inverse_width)).abs());
            slope = slope.add_product(step, simd.four(gradient));
        }
        [greatest.greatest(), slope.sum()]
    }

    /// Adds `part` of `step` to the loads, which do not become negative, and those held by a whole
    /// step become zero; whether a load is lost.
    #[inline(always)]
    pub fn change<S: Simd, const B: usize>(
        &mut self,
        simd: S,
        step: &[Lanes],
        free: &[Lanes],
        part: f64,
    ) -> bool {
        let (zero, one) = (simd.splat(0.0), simd.splat(1.0));
        let mut lost = zero;
        let rows = first_mut::<B, _>(&mut self.state, self.blocks).iter_mut();
        for ((state, step), free) in rows.zip(step).zip(free) {
            let old = simd.four(&state.load);
            let mut new = old.add_product(simd.four(step), simd.splat(part)).max(zero);
            if part >= 1.0 {
                new = new * simd.four(free);
            }
            state.load = new.lanes();
            lost = lost.max(new.where_equal(0.0, zero.where_less(old, one, zero), zero));
        }
        lost.greatest() > 0.0
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
                    let value = potential(simd, table, pairs, squares, simd.splat(square));
                    sum = sum.add_product(value, simd.four(&state.load));
                }
                sum.sum() + push
            },
        )
    }
}
