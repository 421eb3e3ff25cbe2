//! Influence of each source of pressure on all nodes, by columns: the part of a Newton step that
//! takes the time.

use super::columns::{BEYOND, Block, LANES, Rows, Sums, row};
use super::equations::{Displacement, DisplacementDrop, Pair, far_pair};
use super::grid::Cell;
use super::influence::{centred_at, shifted_at};

/// Where sources are from the nodes.
#[derive(Clone, Debug)]
pub(super) struct Sources {
    pub along: Vec<Block>,
    pub across: Vec<Block>,
    pub factors: Vec<Block>,
    /// Blocks of nodes.
    pub nodes: usize,
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

    /// Puts source number `c` in the place of a `cell`, for all nodes, without regard to whether
    /// they are beside it; its moments, with the half length `length`, into `moments`.
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

    /// What source number `c` does, added to `sums`; and per load per width, with the derivatives
    /// by the logarithm of the half length of the source, and that of the drop by that of the node
    /// into `own`. `strip` gives for each block of nodes its load per width, the reciprocal of its
    /// half length, by how much its distances are longer and the share with which it counts.
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
        let (value, drop) = halves(value);
        let (by_source, drop_by_source) = halves(by_source);
        let (sum, fall_sum) = halves(&mut sums.values);
        let (lengths, drop_by_node) = (&rows.lengths[..n], &mut sums.drop_by_node[..n]);
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
                    let at = DisplacementDrop::shifted(
                        centre, along[i], across[i], inverse[i], length[i],
                    );
                    (out[2][i], out[3][i]) = (factor[i] * at.value, factor[i] * at.by_source);
                    out[4][i] = factor[i] * at.by_node;
                }
            } else {
                for i in 0..LANES {
                    let centre = [centre[0][i], centre[1][i]];
                    let at = DisplacementDrop::straight(centre, across[i], inverse[i], length[i]);
                    (out[2][i], out[3][i]) = (factor[i] * at.value, factor[i] * at.by_source);
                    out[4][i] = factor[i] * at.by_node;
                }
            }
            let [one, two, three, four, by_node] = out.map(Block);
            (value[b], by_source[b], drop[b], drop_by_source[b]) = (one, two, three, four);
            own[b] = by_node;
            sum[b].add(&load, &one);
            fall_sum[b].add(&load, &three);
            drop_by_node[b].add(&load, &by_node);
        }
    }
}
