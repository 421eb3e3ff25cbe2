//! What sources do to all nodes, by columns: the part of a Newton step that takes the time, as loops that become vector instructions.
//!
//! The rows of a column are the nodes. What is beyond the last one counts for nothing.

use super::equations::{Displacement, Fall, Pair, Strip, far_pair};
use super::grid::Cell;
use super::influence::{centred_at, shifted_at};

/// Rows of a block.
pub(super) const LANES: usize = 8;

/// Where rows without a node are across, away from all cells [m]: what has no distance from a cell has no influence either.
const BEYOND: f64 = 1.0;

/// Rows that are taken together.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(super) struct Block(pub [f64; LANES]);

impl Block {
    pub const ZERO: Self = Self([0.0; LANES]);

    // Inside each instruction set or not at all: a call would not be vectorised. So with all that follows.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn of(row: impl Fn(usize) -> f64) -> Self {
        let mut rows = [0.0; LANES];
        for (i, out) in rows.iter_mut().enumerate() {
            *out = row(i);
        }
        Self(rows)
    }

    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn times(&self, factor: f64) -> Self {
        Self::of(|i| factor * self.0[i])
    }

    /// Adds the product of two blocks.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn add(&mut self, one: &Self, other: &Self) {
        *self = Self::of(|i| self.0[i] + one.0[i] * other.0[i]);
    }
}

/// Row number `row` of some blocks.
#[allow(clippy::inline_always)]
#[inline(always)]
pub(super) fn row(blocks: &mut [Block], row: usize) -> &mut f64 {
    &mut blocks[row / LANES].0[row % LANES]
}

/// Adds a multiple of `column` to `sums`.
#[allow(clippy::inline_always)]
#[inline(always)]
pub(super) fn add(factor: f64, column: &[Block], sums: &mut [Block]) {
    for (sum, rows) in sums.iter_mut().zip(column) {
        *sum = Block::of(|i| sum.0[i] + factor * rows.0[i]);
    }
}

/// Falls of nodes, taken to the knots by the `shares` that these have in each of them, one block of knots after the other.
#[allow(clippy::inline_always)]
#[inline(always)]
pub(super) fn project(falls: &[Block], shares: &[Block], knots: &mut [Block]) {
    let shares = shares.chunks_exact(falls.len() * LANES);
    for (knots, shares) in knots.iter_mut().zip(shares) {
        let mut sum = Block::ZERO;
        for (Block(falls), shares) in falls.iter().zip(shares.as_chunks::<LANES>().0) {
            for i in 0..LANES {
                sum = Block::of(|lane| sum.0[lane] + falls[i] * shares[i].0[lane]);
            }
        }
        *knots = sum;
    }
}

/// The nodes by rows.
#[derive(Clone, Debug)]
pub(super) struct Rows {
    /// Places along and across and unit tangents (y, z).
    pub places: [Vec<Block>; 4],
    /// Half lengths, loads per width and 1/c.
    pub lengths: Vec<Block>,
    pub loads: Vec<Block>,
    pub slenderness: Vec<Block>,
    /// Derivatives of the logarithms of half lengths by loads per width, and falls that the wheel wants.
    pub length_by_load: Vec<Block>,
    pub wanted: Vec<Block>,
}

impl Rows {
    /// For `count` blocks.
    pub fn new(count: usize) -> Self {
        let blocks = || vec![Block::ZERO; count];
        Self {
            places: [blocks(), vec![Block([BEYOND; LANES]); count], blocks(), blocks()],
            lengths: blocks(),
            loads: blocks(),
            slenderness: blocks(),
            length_by_load: blocks(),
            wanted: blocks(),
        }
    }
}

/// Where sources are from the nodes.
#[derive(Clone, Debug)]
pub(super) struct Sources {
    along: Vec<Block>,
    across: Vec<Block>,
    factors: Vec<Block>,
    /// Blocks of nodes.
    nodes: usize,
}

/// Displacements of all nodes and behind them their falls, by all sources, and the derivatives of falls by the logarithms of the half lengths of the nodes.
#[derive(Clone, Debug)]
pub(super) struct Sums {
    pub values: Vec<Block>,
    pub fall_by_node: Vec<Block>,
}

impl Sums {
    /// For `count` blocks of nodes.
    pub fn new(count: usize) -> Self {
        let blocks = |count| vec![Block::ZERO; count];
        Self { values: blocks(2 * count), fall_by_node: blocks(count) }
    }

    pub fn clear(&mut self) {
        self.values.fill(Block::ZERO);
        self.fall_by_node.fill(Block::ZERO);
    }
}

impl Sources {
    /// Room for `count` sources seen by `nodes` blocks of nodes.
    pub fn new(count: usize, nodes: usize) -> Self {
        let blocks = |value: f64| vec![Block([value; LANES]); count * nodes];
        Self { along: blocks(0.0), across: blocks(1.0), factors: blocks(0.0), nodes }
    }

    /// Puts source number `c` at `pair` from a node.
    pub fn put(&mut self, c: usize, node: usize, pair: &Pair) {
        let at = c * self.nodes * LANES + node;
        *row(&mut self.along, at) = pair.along;
        *row(&mut self.across, at) = pair.across;
        *row(&mut self.factors, at) = pair.factor;
    }

    /// Puts source number `c` in the place of a `cell`, for all nodes, without regard to whether they are beside it; its moments, with the half
    /// length `length`, into `moments`.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn put_cell(
        &mut self,
        c: usize,
        cell: &Cell,
        length: f64,
        rows: &Rows,
        moments: &mut [Block],
    ) {
        let range = c * self.nodes..(c + 1) * self.nodes;
        let (along, across) = (&mut self.along[range.clone()], &mut self.across[range.clone()]);
        let factors = &mut self.factors[range];
        for b in 0..self.nodes {
            let [x, y, c, d] = rows.places.each_ref().map(|place| place[b].0);
            let mut out = [[0.0; LANES]; 4];
            for i in 0..LANES {
                let (pair, moment) = far_pair([x[i], y[i], c[i], d[i]], cell, length);
                (out[0][i], out[1][i]) = (pair.along, pair.across);
                (out[2][i], out[3][i]) = (pair.factor, moment);
            }
            [along[b], across[b], factors[b], moments[b]] = out.map(Block);
        }
    }

    /// What source number `c` does, whose load per width and reciprocal of the half length `strip` gives for each block of nodes, added to `sums`; and
    /// per load per width, with the derivatives by the logarithm of the half length of the source.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn act<'a>(
        &self,
        c: usize,
        strip: impl Fn(usize) -> [Block; 2],
        rows: &Rows,
        is_skewed: bool,
        [value, by_source]: [&'a mut [Block]; 2],
        sums: &'a mut Sums,
    ) {
        // Of lengths that are seen to be equal, so that they are not checked block by block.
        let n = self.nodes;
        let halves = |column: &'a mut [Block]| {
            let (one, other) = column.split_at_mut(n);
            (&mut one[..n], &mut other[..n])
        };
        let (value, fall) = halves(value);
        let (by_source, fall_by_source) = halves(by_source);
        let (sum, fall_sum) = halves(&mut sums.values);
        let (lengths, fall_by_node) = (&rows.lengths[..n], &mut sums.fall_by_node[..n]);
        let range = c * self.nodes..(c + 1) * self.nodes;
        let (along, across) = (&self.along[range.clone()], &self.across[range.clone()]);
        let factors = &self.factors[range];
        let (along, across, factors) = (&along[..n], &across[..n], &factors[..n]);
        for b in 0..n {
            // Copies, so that nothing is read again after something has been written.
            let [load, Block(inverse)] = strip(b);
            let (Block(along), Block(across), Block(factor)) = (along[b], across[b], factors[b]);
            let Block(length) = lengths[b];
            let mut centre = [[0.0; LANES]; 2];
            let mut out = [[0.0; LANES]; 5];
            if is_skewed {
                for i in 0..LANES {
                    let at = shifted_at(along[i] * inverse[i], across[i] * inverse[i]);
                    (centre[0][i], centre[1][i]) = (at.d, at.slope);
                }
            } else {
                for i in 0..LANES {
                    let at = centred_at(across[i] * inverse[i]);
                    (centre[0][i], centre[1][i]) = (at.d, at.slope);
                }
            }
            for i in 0..LANES {
                let at = Displacement::of([centre[0][i], centre[1][i]], inverse[i]);
                (out[0][i], out[1][i]) = (factor[i] * at.value, factor[i] * at.by_source);
            }
            if is_skewed {
                for i in 0..LANES {
                    let centre = [centre[0][i], centre[1][i]];
                    let at = Fall::shifted(centre, along[i], across[i], inverse[i], length[i]);
                    (out[2][i], out[3][i]) = (factor[i] * at.value, factor[i] * at.by_source);
                    out[4][i] = factor[i] * at.by_node;
                }
            } else {
                for i in 0..LANES {
                    let centre = [centre[0][i], centre[1][i]];
                    let at = Fall::straight(centre, across[i], inverse[i], length[i]);
                    (out[2][i], out[3][i]) = (factor[i] * at.value, factor[i] * at.by_source);
                    out[4][i] = factor[i] * at.by_node;
                }
            }
            let [one, two, three, four, by_node] = out.map(Block);
            (value[b], by_source[b], fall[b], fall_by_source[b]) = (one, two, three, four);
            sum[b].add(&load, &one);
            fall_sum[b].add(&load, &three);
            fall_by_node[b].add(&load, &by_node);
        }
    }
}

/// What the sources in both cells beside each node do to it.
#[derive(Clone, Debug)]
pub(super) struct Beside {
    sources: Sources,
    effect: [Vec<Block>; 2],
    /// Loads per width and 1/c at the other ends of the cell under way.
    pub other_loads: Vec<Block>,
    pub other_slenderness: Vec<Block>,
    /// Load per width of the source under way and reciprocal of its half length; the load times the derivative of the logarithm of the half length
    /// by it, and the share of the other end in 1/c.
    strips: Vec<[Block; 4]>,
    /// Derivatives of displacements and falls by the loads per width and χ of the node and of those at both other ends.
    pub ends: [[Vec<Block>; 2]; 3],
}

impl Beside {
    /// For `points` points of the rule in each cell and `nodes` blocks of nodes.
    pub fn new(points: usize, nodes: usize) -> Self {
        let blocks = || vec![Block::ZERO; nodes];
        let both = || vec![Block::ZERO; 2 * nodes];
        Self {
            sources: Sources::new(2 * points, nodes),
            effect: [both(), both()],
            other_loads: blocks(),
            other_slenderness: blocks(),
            strips: vec![[Block::ZERO; 4]; nodes],
            ends: [[both(), both()], [both(), both()], [both(), both()]],
        }
    }

    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn clear(&mut self) {
        for column in self.ends.as_flattened_mut() {
            column.fill(Block::ZERO);
        }
    }

    /// Puts source number `c` at `pair` from a node.
    pub fn put(&mut self, c: usize, node: usize, pair: &Pair) {
        self.sources.put(c, node, pair);
    }

    /// What source number `c` does, which is at a share `t` of the way through the cell on a `side`.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn act(
        &mut self,
        [c, side]: [usize; 2],
        [t, least_square]: [f64; 2],
        rows: &Rows,
        is_skewed: bool,
        sums: &mut Sums,
    ) {
        for (b, strip) in self.strips.iter_mut().enumerate() {
            let (Block(loads), Block(slenderness)) = (rows.loads[b], rows.slenderness[b]);
            let Block(other_loads) = self.other_loads[b];
            let Block(other_slenderness) = self.other_slenderness[b];
            let mut out = [[0.0; LANES]; 4];
            for i in 0..LANES {
                let between = loads[i] + (other_loads[i] - loads[i]) * t;
                let [own, other] = [(1.0 - t) * slenderness[i], t * other_slenderness[i]];
                let strip = Strip::new(between, own + other, least_square);
                out[0][i] = strip.load;
                out[1][i] = 1.0 / strip.half_length;
                out[2][i] = strip.load * strip.length_by_load;
                out[3][i] = other / (own + other);
            }
            *strip = out.map(Block);
        }
        let (strips, nodes) = (&self.strips, self.strips.len());
        let effect = self.effect.each_mut().map(Vec::as_mut_slice);
        self.sources.act(c, |b| [strips[b][0], strips[b][1]], rows, is_skewed, effect, sums);
        let [[own_load, own_shape], others @ ..] = &mut self.ends;
        let [by_load, by_shape] = &mut others[side];
        let [values, by_sources] = &self.effect;
        for b in 0..2 * nodes {
            let [Block(load), _, Block(share), Block(part)] =
                strips[if b < nodes { b } else { b - nodes }];
            let (Block(value), Block(by_source)) = (values[b], by_sources[b]);
            let mut out = [own_load[b].0, own_shape[b].0, by_load[b].0, by_shape[b].0];
            for i in 0..LANES {
                let pull = share[i] * by_source[i];
                let (slope, by_other) = (value[i] + pull, load[i] * pull * part[i]);
                out[0][i] += (1.0 - t) * slope;
                out[1][i] -= load[i] * pull - by_other;
                out[2][i] += t * slope;
                out[3][i] -= by_other;
            }
            [own_load[b], own_shape[b], by_load[b], by_shape[b]] = out.map(Block);
        }
    }

    /// Adds what falls change by with the half lengths of their own nodes, as errors over the loads that they count with.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn add_own_lengths(&mut self, rows: &Rows, sums: &Sums) {
        let nodes = self.strips.len();
        let [by_load, by_shape] = &mut self.ends[0];
        for b in 0..nodes {
            let (Block(load), Block(by)) = (rows.loads[b], rows.length_by_load[b]);
            let (Block(wanted), Block(fallen)) = (rows.wanted[b], sums.values[nodes + b]);
            let Block(by_node) = sums.fall_by_node[b];
            let mut out = [by_load[nodes + b].0, by_shape[nodes + b].0];
            for i in 0..LANES {
                let by_length = (by_node[i] - 2.0 * fallen[i]) * by[i];
                let error = fallen[i] - wanted[i];
                out[0][i] += by_length + if load[i] > 0.0 { error / load[i] } else { 0.0 };
                out[1][i] -= by_length * load[i];
            }
            [by_load[nodes + b], by_shape[nodes + b]] = out.map(Block);
        }
    }
}
