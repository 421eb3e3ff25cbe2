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

mod gradient;
mod hessian;
mod left_out;
mod relaxation;
mod step;

use super::lanes::{FEW, Four, LANES, Lanes, Simd, by_blocks, first, first_mut, stride};
use super::pairs::{Hats, Pairs};
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
#[inline(always)]
fn add_product<S: Simd>(simd: S, sum: &mut Lanes, a: Four<S>, b: Four<S>) {
    *sum = simd.four(sum).add_product(a, b).lanes();
}

/// The energy at the present unknowns.
#[derive(Clone, Debug)]
pub(in super::super) struct System {
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

    /// Takes over the overlaps of the nodes.
    pub fn put_overlaps(&mut self, problem: &Problem) {
        for (k, &i) in self.nodes.iter().enumerate() {
            self.fixed[k / LANES].overlap[k % LANES] = problem.points[i].overlap;
        }
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
}
