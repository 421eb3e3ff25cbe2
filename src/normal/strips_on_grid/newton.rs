//! Newton's method for the strips.
//!
//! All unknowns take one step with the exact derivative, and each component of it is bounded by itself. Every step is a continuous map of the
//! pose, whichever nodes carry load: there is nothing to be decided on the way, and nothing is tried again.

use multiversion::multiversion;

use super::columns::{Beside, Block, LANES, Rows, Sources, Sums, add, project, row};
use super::elimination;
use super::equations::{Pair, RULE, Scales, Strip, near_pair, plus, wanted_fall};
use super::grid::Grid;
use super::shape::Knots;

/// Most Newton steps.
pub(super) const MOST_STEPS: u64 = 40;
/// Last change of a load per width, over that in the middle of the ellipse, and of χ, weighted by the load: what is left is of the order of their
/// squares.
const LAST_CHANGE: f64 = 1e-5;
/// Greatest change of z over the load per width in the middle of the ellipse, and of χ, in one step: more than the whole way to a solution, and less than
/// where an exponential has left what its derivative tells.
const MOST_CHANGE: [f64; 2] = [1.5, 0.5];

/// Unknowns and memory for as many nodes as the solver was made for.
#[derive(Clone, Debug)]
pub(super) struct Newton {
    /// Unknowns: z at the nodes and χ at the knots.
    pub z: Vec<f64>,
    pub shape: Vec<f64>,
    /// Load per width at the nodes, its derivative by z, χ and 1/c there, and their strips.
    pub loads: Vec<f64>,
    slopes: Vec<f64>,
    pub shapes: Vec<f64>,
    slenderness: Vec<f64>,
    strips: Vec<Strip>,
    /// Strips of the cells.
    cells: Vec<Strip>,
    rows: Rows,
    is_skewed: bool,
    /// The cells, and the points of the rule beside the nodes.
    far: Sources,
    beside: Beside,
    sums: Sums,
    /// What each cell does to displacements and falls per load per width, and its derivatives by the logarithm of its half length, by columns.
    by_cells: [Vec<Block>; 2],
    /// Derivatives of displacements and falls by the load per width and χ of the node under way.
    by_node: [Vec<Block>; 2],
    /// Sum of falls, taken to the knots.
    by_falls: Vec<Block>,
    /// Displacements by the moments of cells, per load per width of each node, by columns.
    moments: Vec<Block>,
    moment: Vec<Block>,
    /// Shares of the knots in each node, and what their equations have of its fall: shares of load over the fall that is wanted.
    shares: Vec<Block>,
    falls: Vec<Block>,
    penalty: Vec<Block>,
    /// Derivatives of all equations by columns, and behind them minus their residuals, which become the step.
    matrix: Vec<Block>,
    /// The row of each equation, and the number of rows of nodes, in whole blocks.
    pivots: Vec<usize>,
    long: usize,
    /// Blocks of a column.
    stride: usize,
    /// Derivatives of the equations of the knots by their own χ.
    weights: Vec<f64>,
    /// Steps so far.
    pub steps: u64,
}

impl Newton {
    /// Memory for `n` nodes, the `knots` and `cells` cells.
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
        let mut shares = vec![Block::ZERO; nodes * LANES * behind];
        for i in 0..n {
            for (k, share) in knots.of(i) {
                shares[k / LANES * nodes * LANES + i].0[k % LANES] = share;
            }
        }
        let numbers = |count: usize| vec![0.0; count];
        let blocks = |count: usize| vec![Block::ZERO; count];
        Self {
            z: numbers(n),
            shape: numbers(m),
            loads: numbers(n),
            slopes: numbers(n),
            shapes: numbers(n),
            slenderness: numbers(n),
            strips: vec![Strip::default(); n],
            cells: vec![Strip::default(); cells],
            rows: Rows::new(nodes),
            is_skewed: false,
            far: Sources::new(cells, nodes),
            beside: Beside::new(RULE.len(), nodes),
            sums: Sums::new(nodes),
            by_cells: [blocks(cells * 2 * nodes), blocks(cells * 2 * nodes)],
            by_node: [blocks(2 * nodes), blocks(2 * nodes)],
            by_falls: blocks(behind),
            moments: blocks(n * nodes),
            moment: blocks(nodes),
            shares,
            falls: blocks(nodes * LANES * behind),
            penalty,
            matrix: blocks((n + m + 1) * stride),
            pivots: (0..n).chain(nodes * LANES..nodes * LANES + m).collect(),
            long: nodes * LANES,
            weights: numbers(m),
            steps: 0,
            stride,
        }
    }

    /// Solves the equations on `grid`; false where the last step was longer than it should be.
    pub fn solve(&mut self, grid: &Grid, knots: &Knots) -> bool {
        solve(self, grid, knots)
    }

    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn solve_here(&mut self, grid: &Grid, knots: &Knots) -> bool {
        let scales = Scales::new(grid);
        self.measure(grid, &scales);
        self.start(grid, &scales);
        for _ in 0..MOST_STEPS {
            self.steps += 1;
            self.linearise(grid, knots, &scales);
            match self.step(&scales) {
                Some(change) if change <= LAST_CHANGE => {
                    self.place(grid, knots, &scales);
                    return true;
                }
                Some(_) => {}
                None => break,
            }
        }
        self.place(grid, knots, &scales);
        false
    }

    /// Where all sources are from all nodes.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn measure(&mut self, grid: &Grid, scales: &Scales) {
        let nodes = &grid.nodes;
        let count = self.moment.len();
        self.is_skewed = grid.is_skewed();
        for (i, node) in nodes.iter().enumerate() {
            let [a, b] = node.place.tangent;
            for (column, value) in self.rows.places.iter_mut().zip([node.place.x, node.y, a, b]) {
                *row(column, i) = value;
            }
        }
        self.moments.fill(Block::ZERO);
        for (c, cell) in grid.cells.iter().enumerate() {
            self.far.put_cell(c, cell, scales.length, &self.rows, &mut self.moment);
            // The points of the rule take the place of cells beside a node.
            for &i in cell.nodes.iter().flatten() {
                let nothing = Pair { along: 0.0, across: 1.0, factor: 0.0 };
                self.far.put(c, i, &nothing);
                *row(&mut self.moment, i) = 0.0;
            }
            for (end, sign) in cell.nodes.into_iter().zip([-1.0, 1.0]) {
                let Some(j) = end else { continue };
                add(sign, &self.moment, &mut self.moments[j * count..(j + 1) * count]);
            }
        }
        for slot in 0..2 * RULE.len() {
            for i in 0..nodes.len() {
                let pair = near_pair(nodes, i, slot / RULE.len(), slot % RULE.len());
                self.beside.put(slot, i, &pair);
            }
        }
    }

    /// The ellipse, cut to the overlap.
    fn start(&mut self, grid: &Grid, scales: &Scales) {
        for (z, node) in self.z.iter_mut().zip(grid.nodes.iter()) {
            let level = (node.place.overlap / grid.depth - scales.level) / (1.0 - scales.level);
            *z = scales.load * level.clamp(-1.0, 1.0);
        }
        self.shape.fill(scales.shape);
    }

    /// Loads, shapes and strips of the present unknowns.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn place(&mut self, grid: &Grid, knots: &Knots, scales: &Scales) {
        for i in 0..grid.nodes.len() {
            [self.loads[i], self.slopes[i]] = plus(self.z[i], scales.corner);
            self.shapes[i] = knots.value(i, &self.shape);
            self.slenderness[i] = (-self.shapes[i]).exp();
            self.strips[i] = Strip::new(self.loads[i], self.slenderness[i], scales.least_square);
        }
        for (strip, cell) in self.cells.iter_mut().zip(grid.cells.iter()) {
            *strip = cell.strip(&self.loads, &self.slenderness, scales.least_square);
        }
    }

    /// Residuals at the present unknowns and all derivatives of them.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn linearise(&mut self, grid: &Grid, knots: &Knots, scales: &Scales) {
        self.place(grid, knots, scales);
        let (n, m) = (grid.nodes.len(), self.shape.len());
        let (nodes, stride) = (self.moment.len(), self.stride);
        for (i, node) in grid.nodes.iter().enumerate() {
            let strip = &self.strips[i];
            let wanted = wanted_fall(strip, node);
            *row(&mut self.rows.lengths, i) = strip.half_length;
            *row(&mut self.rows.loads, i) = strip.load;
            *row(&mut self.rows.slenderness, i) = self.slenderness[i];
            *row(&mut self.rows.length_by_load, i) = strip.length_by_load;
            *row(&mut self.rows.wanted, i) = wanted;
            let scale = node.width * strip.load / (scales.total * wanted);
            let falls = self.falls[i..].iter_mut().step_by(self.long);
            for (fall, share) in falls.zip(self.shares[i..].iter().step_by(self.long)) {
                *fall = share.times(scale);
            }
        }
        self.sums.clear();
        for (c, strip) in self.cells[..grid.cells.len()].iter().enumerate() {
            let range = 2 * c * nodes..2 * (c + 1) * nodes;
            let columns = self.by_cells.each_mut().map(|column| &mut column[range.clone()]);
            if strip.load <= 0.0 {
                for column in columns {
                    column.fill(Block::ZERO);
                }
                continue;
            }
            let strip = [strip.load, 1.0 / strip.half_length].map(|value| Block([value; LANES]));
            let rows = &self.rows;
            self.far.act(c, |_| strip, rows, self.is_skewed, columns, &mut self.sums);
        }
        self.add_near_cells(grid, scales);
        for (j, load) in self.loads.iter().enumerate() {
            add(*load, &self.moments[j * nodes..][..nodes], &mut self.sums.values[..nodes]);
        }
        self.matrix[n * stride..].fill(Block::ZERO);
        for j in 0..n {
            self.gather(grid, knots, scales, j);
        }
        let (matrix, right) = self.matrix.split_at_mut((n + m) * stride);
        for (k, penalty) in self.penalty.chunks_exact(stride - nodes).enumerate() {
            let column = &mut matrix[(n + k) * stride..][..stride];
            add(-self.shape[k], penalty, &mut right[nodes..]);
            add(1.0, penalty, &mut column[nodes..]);
            self.weights[k] = row(column, self.long + k).abs();
        }
        let (displacements, falls) = self.sums.values.split_at_mut(nodes);
        for (i, node) in grid.nodes.iter().enumerate() {
            let gap = scales.gap * (self.loads[i] - self.z[i]);
            *row(right, i) = node.place.overlap + gap - *row(displacements, i);
        }
        add(-1.0, &self.rows.wanted, falls);
        project(falls, &self.falls, &mut self.by_falls);
        add(-1.0, &self.by_falls, &mut right[nodes..]);
    }

    /// What the two cells beside each node do to it.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn add_near_cells(&mut self, grid: &Grid, scales: &Scales) {
        self.beside.clear();
        for side in [0, 1] {
            for (i, node) in grid.nodes.iter().enumerate() {
                // Beyond the last node χ stays what it is.
                let (load, slenderness) = match node.neighbours[side] {
                    Some(j) => (self.loads[j], self.slenderness[j]),
                    None => (0.0, self.slenderness[i]),
                };
                *row(&mut self.beside.other_loads, i) = load;
                *row(&mut self.beside.other_slenderness, i) = slenderness;
            }
            for (k, [t, _]) in RULE.into_iter().enumerate() {
                let (rows, sums) = (&self.rows, &mut self.sums);
                let slot = [side * RULE.len() + k, side];
                self.beside.act(slot, [t, scales.least_square], rows, self.is_skewed, sums);
            }
        }
        let [[_, own], others @ ..] = &mut self.beside.ends;
        for (i, node) in grid.nodes.iter().enumerate() {
            for ([_, other], neighbour) in others.iter_mut().zip(node.neighbours) {
                if neighbour.is_none() {
                    *row(own, i) += *row(other, i);
                    *row(own, i + self.long) += *row(other, i + self.long);
                }
            }
        }
        self.beside.add_own_lengths(&self.rows, &self.sums);
    }

    /// Derivatives of all equations by z of node `j`, and its part in those by the knots.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn gather(&mut self, grid: &Grid, knots: &Knots, scales: &Scales, j: usize) {
        let (stride, nodes) = (self.stride, self.moment.len());
        let (matrix, by_knots) = self.matrix.split_at_mut(grid.nodes.len() * stride);
        let column = &mut matrix[j * stride..][..stride];
        let slope = self.slopes[j];
        let gap = scales.gap * (slope - 1.0);
        let first = grid.nodes[j].cell;
        if self.cells[first].load <= 0.0 && self.cells[first + 1].load <= 0.0 {
            column.fill(Block::ZERO);
            *row(column, j) = -gap;
            return;
        }
        let [[load_a, shape_a], [load_b, shape_b]] = [first, first + 1].map(|c| {
            let strip = &self.cells[c];
            let share = strip.load * strip.length_by_load;
            // Beyond the last node χ stays what it is.
            let all: f64 = grid.cells[c].nodes.iter().flatten().map(|&k| self.slenderness[k]).sum();
            [0.5 * share, -strip.load * share * self.slenderness[j] / all]
        });
        // Of lengths that are seen to be equal, so that they are not checked block by block.
        let long = 2 * nodes;
        let [[value_a, value_b], [source_a, source_b]] = self
            .by_cells
            .each_ref()
            .map(|columns| [first, first + 1].map(|c| &columns[c * long..][..long]));
        let moments = &self.moments[j * nodes..][..nodes];
        let [by_load, by_shape] = self.by_node.each_mut().map(|column| &mut column[..long]);
        for b in 0..long {
            let (values, sources) = ([value_a[b].0, value_b[b].0], [source_a[b].0, source_b[b].0]);
            let mut out = [[0.0; LANES]; 2];
            for i in 0..LANES {
                let (one, other) = (sources[0][i], sources[1][i]);
                let mean = 0.5 * (values[0][i] + values[1][i]);
                out[0][i] = mean + load_a * one + load_b * other;
                out[1][i] = shape_a * one + shape_b * other;
            }
            [by_load[b], by_shape[b]] = out.map(Block);
        }
        add(1.0, moments, &mut by_load[..nodes]);
        let neighbours = grid.nodes[j].neighbours;
        // It is on the left of the one on its right.
        for (end, i) in [Some(j), neighbours[1], neighbours[0]].into_iter().enumerate() {
            let Some(i) = i else { continue };
            let (block, lane) = (i / LANES, i % LANES);
            let ends = &self.beside.ends[end];
            for (column, end) in [&mut *by_load, &mut *by_shape].into_iter().zip(ends) {
                column[block].0[lane] += end[block].0[lane];
                column[nodes + block].0[lane] += end[nodes + block].0[lane];
            }
        }
        let (by_nodes, by_falls) = column.split_at_mut(nodes);
        for (out, by_load) in by_nodes.iter_mut().zip(&*by_load) {
            *out = by_load.times(slope);
        }
        project(&by_load[nodes..], &self.falls, by_falls);
        for out in by_falls {
            *out = out.times(slope);
        }
        *row(by_nodes, j) -= gap;
        project(&by_shape[nodes..], &self.falls, &mut self.by_falls);
        for (k, share) in knots.of(j) {
            let (by_nodes, by_falls) = by_knots[k * stride..][..stride].split_at_mut(nodes);
            add(share, by_shape, by_nodes);
            add(share, &self.by_falls, by_falls);
        }
    }

    /// The derivatives of all residuals by all unknowns at the present ones, by rows, into `matrix`; returns their number.
    pub fn matrix_at(&mut self, grid: &Grid, knots: &Knots, matrix: &mut Vec<f64>) -> usize {
        let scales = Scales::new(grid);
        self.linearise(grid, knots, &scales);
        let (n, m) = (grid.nodes.len(), knots.count());
        matrix.clear();
        for &row in &self.pivots {
            let (block, lane) = (row / LANES, row % LANES);
            let scale = if row < self.long { grid.depth } else { 1.0 };
            let columns = self.matrix.chunks_exact(self.stride).take(n + m);
            matrix.extend(columns.map(|column| column[block].0[lane] / scale));
        }
        n + m
    }

    /// One step; its greatest change, or nothing where the equations have no solution.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn step(&mut self, scales: &Scales) -> Option<f64> {
        if !elimination::solve(&mut self.matrix, self.stride, &self.pivots) {
            return None;
        }
        let change = &mut self.matrix[self.pivots.len() * self.stride..];
        let mut greatest = 0.0f64;
        let most = MOST_CHANGE[0] * scales.load;
        for (i, (z, slope)) in self.z.iter_mut().zip(&self.slopes).enumerate() {
            let change = *row(change, i);
            *z += change.clamp(-most, most);
            // Nodes without load have their gap from all the others.
            if *slope > 0.0 {
                greatest = greatest.max(change.abs() / scales.load);
            }
        }
        let heaviest = self.weights.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        for (k, (shape, weight)) in self.shape.iter_mut().zip(&self.weights).enumerate() {
            let change = *row(change, self.long + k);
            *shape += change.clamp(-MOST_CHANGE[1], MOST_CHANGE[1]);
            greatest = greatest.max(change.abs() * weight / heaviest);
        }
        Some(greatest)
    }
}

/// [`Newton::solve`], once for each set of instructions, with all that it calls.
#[multiversion(targets("x86_64+avx512f+avx512dq", "x86_64+avx2", "aarch64+neon"))]
fn solve(newton: &mut Newton, grid: &Grid, knots: &Knots) -> bool {
    newton.solve_here(grid, knots)
}
