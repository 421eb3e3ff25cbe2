//! Influence of the two cells beside each node on it: their loads end where the contact does, so
//! that they are integrated by a rule of their own.

use super::columns::{Block, LANES, Rows, Sums};
use super::equations::{Pair, Strip};
use super::sources::Sources;

/// The cells on one side of all nodes.
#[derive(Clone, Debug)]
pub(super) struct Side {
    /// Loads per width of the nodes at their other ends.
    pub other_loads: Vec<Block>,
    /// 1/c in them, its derivatives by z of the node and of the other one, and those by χ.
    pub length_per_pressure: [Vec<Block>; 5],
    /// Where their loaded parts begin and how long they are, as shares, with the derivatives by z
    /// of the node and of the other one.
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
    /// Derivatives of displacements and drops by z and χ of the node and of those at both other
    /// ends.
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
                length_per_pressure: [whole(), blocks(), blocks(), blocks(), blocks()],
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
        let Side {
            other_loads,
            length_per_pressure: [mean, slopes @ ..],
            from,
            part: [part, parts @ ..],
        } = &mut self.side;
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

    /// What source number `c` does, which is at a share `t` of the way through the loaded part of
    /// the cell on a `side`.
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
            let Block(per_pressure) = cells.length_per_pressure[0][b];
            let (Block(from), Block(part)) = (cells.from[0][b], cells.part[0][b]);
            let mut out = [[0.0; LANES]; 4];
            for i in 0..LANES {
                let load = loads[i] + (other_loads[i] - loads[i]) * t;
                out[0][i] = load;
                out[1][i] = 1.0 / Strip::new(load, per_pressure[i], least_square).half_length;
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
            let [per_pressure, by_own, by_other, by_own_shape, by_other_shape] =
                cells.length_per_pressure.each_ref().map(|column| column[b].0);
            let [_, from_own, from_other] = cells.from.each_ref().map(|column| column[b].0);
            let [_, part_own, part_other] = cells.part.each_ref().map(|column| column[b].0);
            // Factors of the value and of its derivatives by the logarithms of the half length and
            // of the distances, in the derivatives by z of the node and of the other one; and of
            // that by the half length in those by χ.
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
                factors[0][1][i] = load[i] * square * (per_pressure[i] * own + load[i] * by_own[i]);
                factors[1][1][i] =
                    load[i] * square * (per_pressure[i] * other + load[i] * by_other[i]);
                factors[0][2][i] = load[i] * along * (from_own[i] + part_own[i] * t);
                factors[1][2][i] = load[i] * along * (from_other[i] + part_other[i] * t);
                shapes[0][i] = load[i] * load[i] * square * by_own_shape[i];
                shapes[1][i] = load[i] * load[i] * square * by_other_shape[i];
            }
            let Block(drop_by_node) = by_node[b];
            for (row, by_node) in [(b, [0.0; LANES]), (nodes + b, drop_by_node)] {
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

    /// Adds what drops change by with the half lengths of their own nodes, as errors over the
    /// weights that they count with.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn add_own_lengths(&mut self, rows: &Rows, sums: &Sums) {
        let nodes = self.sources.nodes;
        let [[by_z, by_shape], [by_left, _], [by_right, _]] = &mut self.ends;
        for b in 0..nodes {
            let widths = rows.widths.each_ref().map(|column| column[b].0);
            let (Block(load), Block(by)) = (rows.loads[b], rows.length_by_load[b]);
            let (Block(required), Block(drop)) = (rows.required_drop[b], sums.values[nodes + b]);
            let Block(by_node) = sums.drop_by_node[b];
            let columns = [&by_z, &by_shape, &by_left, &by_right];
            let mut out = columns.map(|column| column[nodes + b].0);
            for i in 0..LANES {
                let by_length = (by_node[i] - 2.0 * drop[i]) * by[i];
                let error = drop[i] - required[i];
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
