//! What sources do to all nodes, by columns: the part of a Newton step that takes the time, as loops that become vector instructions.
//!
//! The rows of a column are the nodes. What is beyond the last one counts for nothing.

use super::equations::{Displacement, Fall, Pair, Strip, far_pair};
use super::grid::Cell;
use super::influence::{centred_at, shifted_at};

/// Rows of a block: one register of AVX2, so that few numbers have to leave the registers and the nodes of an element as it starts fill all rows.
pub(super) const LANES: usize = 4;

/// Where rows without a node are across, away from all cells [m]: what has no distance from a cell has no influence either.
const BEYOND: f64 = 1.0;

/// Rows that are taken together.
#[derive(Clone, Copy, Debug)]
#[repr(align(32))]
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
    /// Half lengths and loads per width.
    pub lengths: Vec<Block>,
    pub loads: Vec<Block>,
    /// Derivatives of the logarithms of half lengths by loads per width, and falls that the wheel wants.
    pub length_by_load: Vec<Block>,
    pub wanted: Vec<Block>,
    /// Derivatives of the logarithms of loaded widths by z of the node and of those on both sides.
    pub widths: [Vec<Block>; 3],
}

impl Rows {
    /// For `count` blocks.
    pub fn new(count: usize) -> Self {
        let blocks = || vec![Block::ZERO; count];
        Self {
            places: [blocks(), vec![Block([BEYOND; LANES]); count], blocks(), blocks()],
            lengths: blocks(),
            loads: blocks(),
            length_by_load: blocks(),
            wanted: blocks(),
            widths: [blocks(), blocks(), blocks()],
        }
    }

    /// No nodes.
    pub fn clear(&mut self) {
        let Self { places: [x, y, a, b], lengths, loads, length_by_load, wanted, widths } = self;
        let columns = [x, a, b, lengths, loads, length_by_load, wanted];
        for column in columns.into_iter().chain(widths) {
            column.fill(Block::ZERO);
        }
        y.fill(Block([BEYOND; LANES]));
    }
}

/// Where sources are from the nodes.
#[derive(Clone, Debug)]
pub(super) struct Sources {
    along: Vec<Block>,
    across: Vec<Block>,
    factors: Vec<Block>,
    /// Blocks of nodes.
    pub nodes: usize,
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

    /// Takes source number `c` away from all nodes.
    pub fn remove(&mut self, c: usize) {
        let range = c * self.nodes..(c + 1) * self.nodes;
        self.along[range.clone()].fill(Block::ZERO);
        self.across[range.clone()].fill(Block([BEYOND; LANES]));
        self.factors[range].fill(Block::ZERO);
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

    /// What source number `c` does, added to `sums`; and per load per width, with the derivatives by the logarithm of the half length of the source, and that of
    /// the fall by that of the node into `own`. `strip` gives for each block of nodes its load per width, the reciprocal of its half length, by how much its
    /// distances are longer and the share with which it counts.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn act<'a>(
        &self,
        c: usize,
        strip: impl Fn(usize) -> [Block; 4],
        rows: &Rows,
        is_skewed: bool,
        [value, by_source, own]: [&'a mut [Block]; 3],
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
        let own = &mut own[..n];
        let range = c * self.nodes..(c + 1) * self.nodes;
        let (along, across) = (&self.along[range.clone()], &self.across[range.clone()]);
        let factors = &self.factors[range];
        let (along, across, factors) = (&along[..n], &across[..n], &factors[..n]);
        for b in 0..n {
            // Copies, so that nothing is read again after something has been written.
            let [load, Block(inverse), Block(scale), Block(part)] = strip(b);
            let along = Block::of(|i| scale[i] * along[b].0[i]).0;
            let across = Block::of(|i| scale[i] * across[b].0[i]).0;
            let factor = Block::of(|i| part[i] * factors[b].0[i]).0;
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
            own[b] = by_node;
            sum[b].add(&load, &one);
            fall_sum[b].add(&load, &three);
            fall_by_node[b].add(&load, &by_node);
        }
    }
}

/// The cells on one side of all nodes.
#[derive(Clone, Debug)]
pub(super) struct Side {
    /// Loads per width of the nodes at their other ends.
    pub other_loads: Vec<Block>,
    /// 1/c in them, its derivatives by z of the node and of the other one, and those by χ.
    pub slenderness: [Vec<Block>; 5],
    /// Where their loaded parts begin and how long they are, as shares, with the derivatives by z of the node and of the other one.
    pub from: [Vec<Block>; 3],
    pub part: [Vec<Block>; 3],
}

/// What the sources in both cells beside each node do to it.
#[derive(Clone, Debug)]
pub(super) struct Beside {
    sources: Sources,
    effect: [Vec<Block>; 2],
    by_node: Vec<Block>,
    strips: Vec<[Block; 4]>,
    /// The cells on the side under way.
    pub side: Side,
    /// Derivatives of displacements and falls by z and χ of the node and of those at both other ends.
    pub ends: [[Vec<Block>; 2]; 3],
}

impl Beside {
    /// For `points` points of the rule in each cell and `nodes` blocks of nodes.
    pub fn new(points: usize, nodes: usize) -> Self {
        let blocks = || vec![Block::ZERO; nodes];
        let both = || vec![Block::ZERO; 2 * nodes];
        // Rows without a node have a cell too.
        let whole = || vec![Block([1.0; LANES]); nodes];
        Self {
            sources: Sources::new(2 * points, nodes),
            effect: [both(), both()],
            by_node: blocks(),
            strips: vec![[Block::ZERO; 4]; nodes],
            side: Side {
                other_loads: blocks(),
                slenderness: [whole(), blocks(), blocks(), blocks(), blocks()],
                from: [blocks(), blocks(), blocks()],
                part: [whole(), blocks(), blocks()],
            },
            ends: [[both(), both()], [both(), both()], [both(), both()]],
        }
    }

    /// Takes `nodes` blocks of nodes, none of which has a cell that is loaded.
    pub fn fit(&mut self, nodes: usize) {
        self.sources.nodes = nodes;
        self.sources.factors.fill(Block::ZERO);
        self.sources.across.fill(Block([1.0; LANES]));
        let Side { other_loads, slenderness: [mean, slopes @ ..], from, part: [part, parts @ ..] } =
            &mut self.side;
        for column in [other_loads].into_iter().chain(slopes).chain(from).chain(parts) {
            column.fill(Block::ZERO);
        }
        for column in [mean, part] {
            column.fill(Block([1.0; LANES]));
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

    /// What source number `c` does, which is at a share `t` of the way through the loaded part of the cell on a `side`.
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
        let cells = &self.side;
        let nodes = self.sources.nodes;
        for (b, strip) in self.strips[..nodes].iter_mut().enumerate() {
            let (Block(loads), Block(other_loads)) = (rows.loads[b], cells.other_loads[b]);
            let Block(slender) = cells.slenderness[0][b];
            let (Block(from), Block(part)) = (cells.from[0][b], cells.part[0][b]);
            let mut out = [[0.0; LANES]; 4];
            for i in 0..LANES {
                let load = loads[i] + (other_loads[i] - loads[i]) * t;
                out[0][i] = load;
                out[1][i] = 1.0 / Strip::new(load, slender[i], least_square).half_length;
                out[2][i] = (from[i] + part[i] * t) / t;
                out[3][i] = part[i];
            }
            *strip = out.map(Block);
        }
        let strips = &self.strips;
        let [value, by_source] = &mut self.effect;
        let columns = [value, by_source, &mut self.by_node].map(Vec::as_mut_slice);
        self.sources.act(c, |b| strips[b], rows, is_skewed, columns, sums);
        let [[own_z, own_shape], others @ ..] = &mut self.ends;
        let [other_z, other_shape] = &mut others[side];
        let ([values, by_sources], by_node) = (&self.effect, &self.by_node);
        for b in 0..nodes {
            let [Block(load), Block(inverse), Block(scale), Block(part)] = strips[b];
            let (Block(loads), Block(other_loads)) = (rows.loads[b], cells.other_loads[b]);
            let [slender, by_own, by_other, by_own_shape, by_other_shape] =
                cells.slenderness.each_ref().map(|column| column[b].0);
            let [_, from_own, from_other] = cells.from.each_ref().map(|column| column[b].0);
            let [_, part_own, part_other] = cells.part.each_ref().map(|column| column[b].0);
            // Factors of the value and of its derivatives by the logarithms of the half length and of the distances, in the derivatives by z of the
            // node and of the other one; and of that by the half length in those by χ.
            let mut factors = [[[0.0; LANES]; 3]; 2];
            let mut shapes = [[0.0; LANES]; 2];
            for i in 0..LANES {
                let square = inverse[i] * inverse[i] * std::f64::consts::FRAC_1_PI;
                let along = 1.0 / (scale[i] * t);
                let [own, other] =
                    [loads[i], other_loads[i]].map(|load| f64::from(u8::from(load > 0.0)));
                let [own, other] = [(1.0 - t) * own, t * other];
                factors[0][0][i] = own + load[i] * part_own[i] / part[i];
                factors[1][0][i] = other + load[i] * part_other[i] / part[i];
                factors[0][1][i] = load[i] * square * (slender[i] * own + load[i] * by_own[i]);
                factors[1][1][i] = load[i] * square * (slender[i] * other + load[i] * by_other[i]);
                factors[0][2][i] = load[i] * along * (from_own[i] + part_own[i] * t);
                factors[1][2][i] = load[i] * along * (from_other[i] + part_other[i] * t);
                shapes[0][i] = load[i] * load[i] * square * by_own_shape[i];
                shapes[1][i] = load[i] * load[i] * square * by_other_shape[i];
            }
            let Block(fall_by_node) = by_node[b];
            for (row, by_node) in [(b, [0.0; LANES]), (nodes + b, fall_by_node)] {
                let (Block(value), Block(by_source)) = (values[row], by_sources[row]);
                let mut out = [own_z[row].0, other_z[row].0, own_shape[row].0, other_shape[row].0];
                for i in 0..LANES {
                    // All lengths scaled alike scale the influence by the reciprocal.
                    let by_distance = -(value[i] + by_source[i] + by_node[i]);
                    let of =
                        |[a, b, c]: [f64; 3]| a * value[i] + b * by_source[i] + c * by_distance;
                    out[0][i] += of(factors[0].map(|factor| factor[i]));
                    out[1][i] += of(factors[1].map(|factor| factor[i]));
                    out[2][i] += shapes[0][i] * by_source[i];
                    out[3][i] += shapes[1][i] * by_source[i];
                }
                [own_z[row], other_z[row], own_shape[row], other_shape[row]] = out.map(Block);
            }
        }
    }

    /// Adds what falls change by with the half lengths of their own nodes, as errors over the weights that they count with.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn add_own_lengths(&mut self, rows: &Rows, sums: &Sums) {
        let nodes = self.sources.nodes;
        let [[by_z, by_shape], [by_left, _], [by_right, _]] = &mut self.ends;
        for b in 0..nodes {
            let widths = rows.widths.each_ref().map(|column| column[b].0);
            let (Block(load), Block(by)) = (rows.loads[b], rows.length_by_load[b]);
            let (Block(wanted), Block(fallen)) = (rows.wanted[b], sums.values[nodes + b]);
            let Block(by_node) = sums.fall_by_node[b];
            let columns = [&by_z, &by_shape, &by_left, &by_right];
            let mut out = columns.map(|column| column[nodes + b].0);
            for i in 0..LANES {
                let by_length = (by_node[i] - 2.0 * fallen[i]) * by[i];
                let error = fallen[i] - wanted[i];
                // The weight goes with the power 3/2 of the load, and with the loaded width.
                let change = by_length + (1.5 / load[i] + widths[0][i]) * error;
                let is_loaded = load[i] > 0.0;
                out[0][i] += if is_loaded { change } else { 0.0 };
                out[1][i] -= by_length * load[i];
                out[2][i] += if is_loaded { widths[1][i] * error } else { 0.0 };
                out[3][i] += if is_loaded { widths[2][i] * error } else { 0.0 };
            }
            [by_z[nodes + b], by_shape[nodes + b], by_left[nodes + b], by_right[nodes + b]] =
                out.map(Block);
        }
    }
}
