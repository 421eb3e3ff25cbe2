//! The equations at the present unknowns, and their derivatives by all of them: the system of a
//! Newton step.

use super::beside::Beside;
use super::columns::{Block, LANES, Rows, Sums, add, project, row};
use super::equations::{Pair, RULE, loaded_part, loaded_width, near_pair, required_drop};
use super::grid::Grid;
use super::scales::Scales;
use super::shape::Knots;
use super::sources::Sources;
use super::unknowns::Unknowns;
use crate::math::fixed_vec::FixedVec;

/// The system of a Newton step, with memory for as many nodes as the solver was made for.
#[derive(Clone, Debug)]
pub(super) struct Linearised {
    rows: Rows,
    /// The cells, and the points of the rule beside the nodes.
    far: Sources,
    beside: Beside,
    sums: Sums,
    /// What each cell does to displacements and drops per load per width, and its derivatives by
    /// the logarithm of its half length, by columns.
    by_cells: [Vec<Block>; 2],
    /// Derivatives of displacements and drops by the load per width and χ of the node under way.
    by_node: [Vec<Block>; 2],
    /// Sum of drops, taken to the knots.
    by_drops: Vec<Block>,
    by_length: Vec<Block>,
    /// Displacements by the moments of cells, by columns.
    moments: Vec<Block>,
    /// Shares of the knots in each node, and what their equations have of its drop: shares of load
    /// over the drop that is required.
    shares: Vec<Block>,
    drops: Vec<Block>,
    penalty: Vec<Block>,
    /// Derivatives of all equations by columns, and behind them minus their residuals, which become
    /// the step.
    pub matrix: Vec<Block>,
    /// The row of each equation: nodes, and behind the block of the last of them the knots.
    pub pivots: FixedVec<usize>,
    /// Derivatives of the equations of the knots by their own χ.
    pub weights: Vec<f64>,
    /// Blocks of nodes and of knots.
    pub nodes: usize,
    pub behind: usize,
}

impl Linearised {
    /// Memory for up to `n` nodes, the `knots` and `cells` cells.
    pub fn new(n: usize, knots: &Knots, cells: usize) -> Self {
        let m = knots.count();
        let (nodes, behind) = (n.div_ceil(LANES), m.div_ceil(LANES));
        let stride = nodes + behind;
        let mut penalty = vec![Block::ZERO; m * behind];
        for (k, column) in penalty.chunks_exact_mut(behind).enumerate() {
            for l in 0..m {
                *row(column, l) = knots.penalty(k, l);
            }
        }
        let blocks = |count: usize| vec![Block::ZERO; count];
        Self {
            rows: Rows::new(nodes),
            far: Sources::new(cells, nodes),
            beside: Beside::new(RULE.len(), nodes),
            sums: Sums::new(nodes),
            by_cells: [blocks(cells * 2 * nodes), blocks(cells * 2 * nodes)],
            by_node: [blocks(2 * nodes), blocks(2 * nodes)],
            by_drops: blocks(behind),
            by_length: blocks(nodes),
            moments: blocks(cells * nodes),
            shares: blocks(nodes * LANES * behind),
            drops: blocks(nodes * LANES * behind),
            penalty,
            matrix: blocks((n + m + 1) * stride),
            pivots: FixedVec::new(n + m),
            weights: vec![0.0; m],
            nodes,
            behind,
        }
    }

    /// Makes columns as long as the nodes of `grid` need.
    pub fn fit(&mut self, grid: &Grid, knots: &Knots) {
        let (n, m) = (grid.nodes.len(), knots.count());
        self.nodes = n.div_ceil(LANES);
        let long = self.nodes * LANES;
        self.pivots.clear();
        self.pivots.extend((0..n).chain(long..long + m));
        self.rows.clear();
        self.far.nodes = self.nodes;
        self.beside.fit(self.nodes);
        let shares = &mut self.shares[..long * self.behind];
        shares.fill(Block::ZERO);
        for (i, node) in grid.nodes.iter().enumerate() {
            for (k, share) in node.between.weights() {
                shares[k / LANES * long + i].0[k % LANES] = share;
            }
        }
        self.drops[..long * self.behind].fill(Block::ZERO);
    }

    /// Where all sources are from all nodes.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn measure(&mut self, grid: &Grid, scales: &Scales) {
        let nodes = &grid.nodes;
        let count = self.nodes;
        for (i, node) in nodes.iter().enumerate() {
            let [a, b] = node.place.tangent;
            for (column, value) in self.rows.places.iter_mut().zip([node.place.x, node.y, a, b]) {
                *row(column, i) = value;
            }
        }
        for (c, cell) in grid.cells.iter().enumerate() {
            let moments = &mut self.moments[c * count..(c + 1) * count];
            self.far.put_cell(c, cell, scales.length, &self.rows, moments);
            if cell.width <= 0.0 {
                // It may be in the place of a node beside which it is not.
                self.far.remove(c);
                moments.fill(Block::ZERO);
            }
            // The points of the rule take the place of cells beside a node.
            for &i in cell.nodes.iter().flatten() {
                let nothing = Pair { along: 0.0, across: 1.0, factor: 0.0 };
                self.far.put(c, i, &nothing);
                *row(moments, i) = 0.0;
            }
        }
        for slot in 0..2 * RULE.len() {
            for i in 0..nodes.len() {
                let pair = near_pair(nodes, i, slot / RULE.len(), slot % RULE.len());
                self.beside.put(slot, i, &pair);
            }
        }
    }

    /// Residuals at the present unknowns and all derivatives of them, with regard to how far nodes
    /// are ahead of each other if the grid `is_skewed`.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn linearise(
        &mut self,
        unknowns: &Unknowns,
        grid: &Grid,
        scales: &Scales,
        is_skewed: bool,
    ) {
        let (n, m) = (grid.nodes.len(), unknowns.shape.len());
        let (nodes, stride) = (self.nodes, self.nodes + self.behind);
        let long = nodes * LANES;
        for (i, node) in grid.nodes.iter().enumerate() {
            let strip = &unknowns.strips[i];
            let required = required_drop(strip, node);
            *row(&mut self.rows.lengths, i) = strip.half_length;
            *row(&mut self.rows.loads, i) = strip.load;
            *row(&mut self.rows.length_by_load, i) = strip.length_by_load;
            *row(&mut self.rows.required_drop, i) = required;
            let others = node.neighbours.map(|other| unknowns.end(other, scales));
            let [width, by_width @ ..] = loaded_width(node, unknowns.z[i], others);
            for (column, by) in self.rows.widths.iter_mut().zip(by_width) {
                *row(column, i) = by / width;
            }
            let scale = scales.weight(width, strip.load) / required;
            let drops = self.drops[i..long * self.behind].iter_mut().step_by(long);
            for (drop, share) in drops.zip(self.shares[i..].iter().step_by(long)) {
                *drop = share.times(scale);
            }
        }
        self.sums.clear();
        for (c, load) in unknowns.cells[..grid.cells.len()].iter().enumerate() {
            let range = 2 * c * nodes..2 * (c + 1) * nodes;
            let [value, by_source] =
                self.by_cells.each_mut().map(|column| &mut column[range.clone()]);
            if load.mean <= 0.0 {
                value.fill(Block::ZERO);
                by_source.fill(Block::ZERO);
                continue;
            }
            let half_length = unknowns.cell_strips[c].half_length;
            let strip = [load.mean, 1.0 / half_length, 1.0, 1.0].map(|value| Block([value; LANES]));
            let (rows, columns) = (&self.rows, [value, by_source, &mut self.by_length]);
            self.far.act(c, |_| strip, rows, is_skewed, columns, &mut self.sums);
            add(load.moment, &self.moments[c * nodes..][..nodes], &mut self.sums.values[..nodes]);
        }
        self.add_near_cells(unknowns, grid, scales, is_skewed);
        self.matrix[n * stride..(n + m + 1) * stride].fill(Block::ZERO);
        for j in 0..n {
            self.gather(unknowns, grid, scales, j);
        }
        let (matrix, right) = self.matrix.split_at_mut((n + m) * stride);
        for (k, penalty) in self.penalty.chunks_exact(stride - nodes).enumerate() {
            let column = &mut matrix[(n + k) * stride..][..stride];
            add(-unknowns.shape[k], penalty, &mut right[nodes..stride]);
            add(1.0, penalty, &mut column[nodes..]);
            self.weights[k] = row(column, long + k).abs();
        }
        let (displacements, drops) = self.sums.values[..2 * nodes].split_at_mut(nodes);
        for (i, node) in grid.nodes.iter().enumerate() {
            let below = (-unknowns.z[i]).max(0.0);
            let gap = scales.gap * below * below.sqrt();
            *row(right, i) = node.place.overlap + gap - *row(displacements, i);
        }
        add(-1.0, &self.rows.required_drop, drops);
        project(drops, &self.drops, &mut self.by_drops);
        add(-1.0, &self.by_drops, &mut right[nodes..stride]);
    }

    /// What the two cells beside each node do to it.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn add_near_cells(
        &mut self,
        unknowns: &Unknowns,
        grid: &Grid,
        scales: &Scales,
        is_skewed: bool,
    ) {
        self.beside.clear();
        for side in [0, 1] {
            for (i, node) in grid.nodes.iter().enumerate() {
                let other = unknowns.end(node.neighbours[side], scales);
                let [mean, by_z, by_shape] =
                    unknowns.length_per_pressure_between([Some(i), node.neighbours[side]]);
                let [from, part] = loaded_part(unknowns.z[i], other);
                let cells = &mut self.beside.side;
                *row(&mut cells.other_loads, i) = other.max(0.0);
                let length_per_pressure = [mean[0], by_z[0], by_z[1], by_shape[0], by_shape[1]];
                for (column, value) in cells.length_per_pressure.iter_mut().zip(length_per_pressure)
                {
                    *row(column, i) = value;
                }
                for ((from_column, from), (part_column, part)) in
                    (cells.from.iter_mut().zip(from)).zip(cells.part.iter_mut().zip(part))
                {
                    *row(from_column, i) = from;
                    *row(part_column, i) = part;
                }
            }
            for (k, [t, _]) in RULE.into_iter().enumerate() {
                let (rows, sums) = (&self.rows, &mut self.sums);
                let slot = [side * RULE.len() + k, side];
                self.beside.act(slot, [t, scales.least_square], rows, is_skewed, sums);
            }
        }
        self.beside.add_own_lengths(&self.rows, &self.sums);
    }

    /// Derivatives of all equations by z of node `j`, and its part in those by the knots.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn gather(&mut self, unknowns: &Unknowns, grid: &Grid, scales: &Scales, j: usize) {
        let (stride, nodes) = (self.nodes + self.behind, self.nodes);
        let (matrix, by_knots) = self.matrix.split_at_mut(grid.nodes.len() * stride);
        let column = &mut matrix[j * stride..][..stride];
        let gap = 1.5 * scales.gap * (-unknowns.z[j]).max(0.0).sqrt();
        let first = grid.nodes[j].cell;
        if unknowns.cells[first].mean <= 0.0 && unknowns.cells[first + 1].mean <= 0.0 {
            column.fill(Block::ZERO);
            *row(column, j) = gap;
            return;
        }
        // It is the right end of the cell on its left.
        let [[mean_a, load_a, moment_a, shape_a], [mean_b, load_b, moment_b, shape_b]] =
            [(first, 1), (first + 1, 0)].map(|(c, end)| {
                let load = &unknowns.cells[c];
                let ([mean, _, moment], lengths) =
                    (load.slopes[end], unknowns.cell_lengths[c][end]);
                [mean, load.mean * lengths[0], moment, load.mean * lengths[1]]
            });
        // Of lengths that are seen to be equal, so that they are not checked block by block.
        let long = 2 * nodes;
        let [[value_a, value_b], [source_a, source_b]] = self
            .by_cells
            .each_ref()
            .map(|columns| [first, first + 1].map(|c| &columns[c * long..][..long]));
        let [by_z, by_shape] = self.by_node.each_mut().map(|column| &mut column[..long]);
        for b in 0..long {
            let (values, sources) = ([value_a[b].0, value_b[b].0], [source_a[b].0, source_b[b].0]);
            let mut out = [[0.0; LANES]; 2];
            for i in 0..LANES {
                let (one, other) = (sources[0][i], sources[1][i]);
                let value = mean_a * values[0][i] + mean_b * values[1][i];
                out[0][i] = value + load_a * one + load_b * other;
                out[1][i] = shape_a * one + shape_b * other;
            }
            [by_z[b], by_shape[b]] = out.map(Block);
        }
        for (c, moment) in [(first, moment_a), (first + 1, moment_b)] {
            add(moment, &self.moments[c * nodes..][..nodes], &mut by_z[..nodes]);
        }
        let neighbours = grid.nodes[j].neighbours;
        // It is on the left of the one on its right.
        for (end, i) in [Some(j), neighbours[1], neighbours[0]].into_iter().enumerate() {
            let Some(i) = i else { continue };
            let (block, lane) = (i / LANES, i % LANES);
            let ends = &self.beside.ends[end];
            for (column, end) in [&mut *by_z, &mut *by_shape].into_iter().zip(ends) {
                column[block].0[lane] += end[block].0[lane];
                column[nodes + block].0[lane] += end[nodes + block].0[lane];
            }
        }
        let (by_nodes, by_drops) = column.split_at_mut(nodes);
        by_nodes.copy_from_slice(&by_z[..nodes]);
        project(&by_z[nodes..], &self.drops, by_drops);
        *row(by_nodes, j) += gap;
        project(&by_shape[nodes..], &self.drops, &mut self.by_drops);
        for (k, share) in grid.nodes[j].between.weights() {
            let (by_nodes, by_drops) = by_knots[k * stride..][..stride].split_at_mut(nodes);
            add(share, by_shape, by_nodes);
            add(share, &self.by_drops, by_drops);
        }
    }

    /// The derivatives of all residuals by all unknowns, by rows, into `matrix`; returns their
    /// number.
    pub fn matrix(&self, grid: &Grid, knots: &Knots, matrix: &mut Vec<f64>) -> usize {
        let (n, m) = (grid.nodes.len(), knots.count());
        matrix.clear();
        for (k, &row) in self.pivots.iter().enumerate() {
            let (block, lane) = (row / LANES, row % LANES);
            let scale = if k < n { grid.samples.depth } else { 1.0 };
            let columns = self.matrix.chunks_exact(self.nodes + self.behind).take(n + m);
            matrix.extend(columns.map(|column| column[block].0[lane] / scale));
        }
        n + m
    }
}
