//! Newton's method for the strips.
//!
//! All unknowns take one step with the exact derivative, each component of it bounded by itself, with other bounds where the node carries load. Nothing is tried again. The
//! solution, not the way to it, is continuous in the pose.

use multiversion::multiversion;

use super::columns::{Beside, Block, LANES, Rows, Sources, Sums, add, project, row};
use super::elimination;
use super::equations::{
    CellLoad, INFLUENCE, Pair, RULE, Strip, loaded_part, loaded_width, near_pair, slenderness,
    wanted_fall,
};
use super::grid::Grid;
use super::scales::Scales;
use super::shape::Knots;
use crate::math::fixed_vec::FixedVec;

/// Most Newton steps.
pub(super) const MOST_STEPS: u64 = 40;
/// First steps, in which nodes that a yawed wheel has ahead of each other are taken as if side by side, with two influences for a pair instead of three: the steps after
/// them find what that leaves out.
const FIRST_STEPS: u64 = 2;
/// Last change of a load per width, over that in the middle of the ellipse, and of χ, weighted by the load: what is left is of the order of their
/// squares, which a search for a given load does not feel.
const LAST_CHANGE: f64 = 1e-6;
/// Greatest fall in one step of z, and rise where there is no load, over itself or the load per width in the middle of the ellipse, whichever is greater; and greatest
/// change of χ: less than where the equations have left what their derivatives tell.
const MOST_CHANGE: [f64; 2] = [0.5, 0.3];
/// Greatest growth in one step of a load that is next to nothing, over that in the middle of the ellipse; others double at most. The displacement by such a load goes with its
/// square.
const MOST_GROWTH: f64 = 0.1;
/// Share of the way beyond zero that a node takes that begins to carry load: its gap, by which it goes there, is about as much flatter than its load where both are
/// small, and it would come back and go again.
const SHARE_ACROSS: f64 = 0.1;
/// Least slope of the equation of a node over the greatest residual of all of them, both in units of the ellipse: a node of little load or little gap has an equation that
/// is flat on both sides, and moves by no more than some loads of the ellipse. It goes to nothing with the residual, so that the last steps are Newton's.
const LEAST_SLOPE: f64 = 0.2;
/// Displacement of a node by a load of its own over (2/π²) times width over half length: ln(8 a/h), for nodes a seventh of a half length apart. What is left of the overlap
/// of a node when its gap has closed is carried with that slope, and not with that of the gap.
const SELF_INFLUENCE: f64 = 4.0;

/// Unknowns and memory for as many nodes as the solver was made for.
#[derive(Clone, Debug)]
pub(super) struct Newton {
    /// Unknowns: z at the nodes and χ at the knots.
    pub z: FixedVec<f64>,
    pub shape: Vec<f64>,
    /// χ and 1/c at the nodes, and their strips.
    pub shapes: FixedVec<f64>,
    slenderness: FixedVec<f64>,
    strips: FixedVec<Strip>,
    /// Loads of the cells, their strips, and the derivatives of the logarithms of half lengths by z and χ at both ends.
    cells: Vec<CellLoad>,
    cell_strips: Vec<Strip>,
    cell_lengths: Vec<[[f64; 2]; 2]>,
    rows: Rows,
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
    by_length: Vec<Block>,
    /// Displacements by the moments of cells, by columns.
    moments: Vec<Block>,
    /// Shares of the knots in each node, and what their equations have of its fall: shares of load over the fall that is wanted.
    shares: Vec<Block>,
    falls: Vec<Block>,
    penalty: Vec<Block>,
    /// Derivatives of all equations by columns, and behind them minus their residuals, which become the step.
    matrix: Vec<Block>,
    /// The row of each equation: nodes, and behind the block of the last of them the knots.
    pivots: FixedVec<usize>,
    /// Derivatives of the equations of the knots by their own χ.
    weights: Vec<f64>,
    /// Steps so far.
    pub steps: u64,
    /// Largest distance left at a node that carries load, or overlap left at one that does not, over the greatest overlap, before the last step.
    pub residual: f64,
    /// Blocks of nodes and of knots.
    nodes: usize,
    behind: usize,
}

impl Newton {
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
        let numbers = |count: usize| vec![0.0; count];
        let blocks = |count: usize| vec![Block::ZERO; count];
        Self {
            z: FixedVec::new(n),
            shape: numbers(m),
            shapes: FixedVec::new(n),
            slenderness: FixedVec::new(n),
            strips: FixedVec::new(n),
            cells: vec![CellLoad::default(); cells],
            cell_strips: vec![Strip::default(); cells],
            cell_lengths: vec![[[0.0; 2]; 2]; cells],
            rows: Rows::new(nodes),
            far: Sources::new(cells, nodes),
            beside: Beside::new(RULE.len(), nodes),
            sums: Sums::new(nodes),
            by_cells: [blocks(cells * 2 * nodes), blocks(cells * 2 * nodes)],
            by_node: [blocks(2 * nodes), blocks(2 * nodes)],
            by_falls: blocks(behind),
            by_length: blocks(nodes),
            moments: blocks(cells * nodes),
            shares: blocks(nodes * LANES * behind),
            falls: blocks(nodes * LANES * behind),
            penalty,
            matrix: blocks((n + m + 1) * stride),
            pivots: FixedVec::new(n + m),
            weights: numbers(m),
            steps: 0,
            residual: 0.0,
            nodes,
            behind,
        }
    }

    /// Makes columns as long as the nodes of `grid` need.
    fn fit(&mut self, grid: &Grid, knots: &Knots) {
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
        self.falls[..long * self.behind].fill(Block::ZERO);
    }

    /// Solves the equations on `grid`; false where the last step was longer than it should be.
    pub fn solve(&mut self, grid: &Grid, knots: &Knots) -> bool {
        solve(self, grid, knots)
    }

    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn solve_here(&mut self, grid: &Grid, knots: &Knots) -> bool {
        let scales = Scales::new(&grid.samples);
        self.fit(grid, knots);
        self.measure(grid, &scales);
        self.start(grid, &scales);
        let is_skewed = grid.is_skewed();
        let mut settled = false;
        for step in 0..MOST_STEPS {
            self.steps += 1;
            let is_first = is_skewed && step < FIRST_STEPS;
            self.linearise(grid, &scales, is_skewed && !is_first);
            let Some(change) = self.step(grid, &scales) else { break };
            settled = !is_first && change <= LAST_CHANGE;
            if settled {
                break;
            }
        }
        self.place(grid, &scales);
        settled
    }

    /// Where all sources are from all nodes.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn measure(&mut self, grid: &Grid, scales: &Scales) {
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

    /// The ellipse, cut to the overlap.
    fn start(&mut self, grid: &Grid, scales: &Scales) {
        self.z.clear();
        self.z.extend(grid.nodes.iter().map(|node| {
            let level =
                (node.place.overlap / grid.samples.depth - scales.level) / (1.0 - scales.level);
            scales.load * level.max(-1.0)
        }));
        self.shape.fill(scales.shape);
    }

    /// Loads, shapes and strips of the present unknowns.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn place(&mut self, grid: &Grid, scales: &Scales) {
        self.shapes.clear();
        self.shapes.extend(grid.nodes.iter().map(|node| node.between.value(&self.shape)));
        self.slenderness.clear();
        self.slenderness.extend(self.shapes.iter().map(|shape| (-shape).exp()));
        self.strips.clear();
        self.strips.extend(
            self.z
                .iter()
                .zip(self.slenderness.iter())
                .map(|(&z, &slenderness)| Strip::new(z.max(0.0), slenderness, scales.least_square)),
        );
        for (c, cell) in grid.cells.iter().enumerate() {
            let load = CellLoad::new(cell.nodes.map(|node| self.end(node, scales)));
            let [slender, by_z, by_shape] = self.slenderness_between(cell.nodes);
            let strip = Strip::new(load.weighted, slender[0], scales.least_square);
            let by_slender = strip.length_by_load * load.weighted / slender[0];
            self.cell_lengths[c] = [0, 1].map(|end| {
                let by_load = strip.length_by_load * load.slopes[end][1];
                [by_load + by_slender * by_z[end], by_slender * by_shape[end]]
            });
            (self.cells[c], self.cell_strips[c]) = (load, strip);
        }
    }

    /// z at an end of a cell; before and behind an overlap nothing is loaded.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn end(&self, node: Option<usize>, scales: &Scales) -> f64 {
        node.map_or(-scales.load, |j| self.z[j])
    }

    /// 1/c between two nodes, and its derivatives by z and by χ of both.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn slenderness_between(&self, nodes: [Option<usize>; 2]) -> [[f64; 2]; 3] {
        let of = |node: Option<usize>| {
            node.map_or([0.0; 2], |j| [self.z[j].max(0.0), self.slenderness[j]])
        };
        let [a, b] = nodes.map(of);
        let [mean, share] = slenderness(a, b);
        let squares = a[0] * a[0] + b[0] * b[0];
        let by_z = if squares > 0.0 {
            [2.0 * a[0] * (a[1] - mean) / squares, 2.0 * b[0] * (b[1] - mean) / squares]
        } else {
            [0.0; 2]
        };
        // Rows without load have some 1/c too.
        let mean = if mean > 0.0 { mean } else { 1.0 };
        [[mean; 2], by_z, [-share * a[1], (share - 1.0) * b[1]]]
    }

    /// Residuals at the present unknowns and all derivatives of them, with regard to how far nodes are ahead of each other if the grid `is_skewed`.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn linearise(&mut self, grid: &Grid, scales: &Scales, is_skewed: bool) {
        self.place(grid, scales);
        let (n, m) = (grid.nodes.len(), self.shape.len());
        let (nodes, stride) = (self.nodes, self.nodes + self.behind);
        let long = nodes * LANES;
        for (i, node) in grid.nodes.iter().enumerate() {
            let strip = &self.strips[i];
            let wanted = wanted_fall(strip, node);
            *row(&mut self.rows.lengths, i) = strip.half_length;
            *row(&mut self.rows.loads, i) = strip.load;
            *row(&mut self.rows.length_by_load, i) = strip.length_by_load;
            *row(&mut self.rows.wanted, i) = wanted;
            let others = node.neighbours.map(|other| self.end(other, scales));
            let [width, by_width @ ..] = loaded_width(node, self.z[i], others);
            for (column, by) in self.rows.widths.iter_mut().zip(by_width) {
                *row(column, i) = by / width;
            }
            let scale = scales.weight(width, strip.load) / wanted;
            let falls = self.falls[i..long * self.behind].iter_mut().step_by(long);
            for (fall, share) in falls.zip(self.shares[i..].iter().step_by(long)) {
                *fall = share.times(scale);
            }
        }
        self.sums.clear();
        for (c, load) in self.cells[..grid.cells.len()].iter().enumerate() {
            let range = 2 * c * nodes..2 * (c + 1) * nodes;
            let [value, by_source] =
                self.by_cells.each_mut().map(|column| &mut column[range.clone()]);
            if load.mean <= 0.0 {
                value.fill(Block::ZERO);
                by_source.fill(Block::ZERO);
                continue;
            }
            let half_length = self.cell_strips[c].half_length;
            let strip = [load.mean, 1.0 / half_length, 1.0, 1.0].map(|value| Block([value; LANES]));
            let (rows, columns) = (&self.rows, [value, by_source, &mut self.by_length]);
            self.far.act(c, |_| strip, rows, is_skewed, columns, &mut self.sums);
            add(load.moment, &self.moments[c * nodes..][..nodes], &mut self.sums.values[..nodes]);
        }
        self.add_near_cells(grid, scales, is_skewed);
        self.matrix[n * stride..(n + m + 1) * stride].fill(Block::ZERO);
        for j in 0..n {
            self.gather(grid, scales, j);
        }
        let (matrix, right) = self.matrix.split_at_mut((n + m) * stride);
        for (k, penalty) in self.penalty.chunks_exact(stride - nodes).enumerate() {
            let column = &mut matrix[(n + k) * stride..][..stride];
            add(-self.shape[k], penalty, &mut right[nodes..stride]);
            add(1.0, penalty, &mut column[nodes..]);
            self.weights[k] = row(column, long + k).abs();
        }
        let (displacements, falls) = self.sums.values[..2 * nodes].split_at_mut(nodes);
        for (i, node) in grid.nodes.iter().enumerate() {
            let below = (-self.z[i]).max(0.0);
            let gap = scales.gap * below * below.sqrt();
            *row(right, i) = node.place.overlap + gap - *row(displacements, i);
        }
        add(-1.0, &self.rows.wanted, falls);
        project(falls, &self.falls, &mut self.by_falls);
        add(-1.0, &self.by_falls, &mut right[nodes..stride]);
    }

    /// What the two cells beside each node do to it.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn add_near_cells(&mut self, grid: &Grid, scales: &Scales, is_skewed: bool) {
        self.beside.clear();
        for side in [0, 1] {
            for (i, node) in grid.nodes.iter().enumerate() {
                let other = self.end(node.neighbours[side], scales);
                let [mean, by_z, by_shape] =
                    self.slenderness_between([Some(i), node.neighbours[side]]);
                let [from, part] = loaded_part(self.z[i], other);
                let cells = &mut self.beside.side;
                *row(&mut cells.other_loads, i) = other.max(0.0);
                let slenderness = [mean[0], by_z[0], by_z[1], by_shape[0], by_shape[1]];
                for (column, value) in cells.slenderness.iter_mut().zip(slenderness) {
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
    fn gather(&mut self, grid: &Grid, scales: &Scales, j: usize) {
        let (stride, nodes) = (self.nodes + self.behind, self.nodes);
        let (matrix, by_knots) = self.matrix.split_at_mut(grid.nodes.len() * stride);
        let column = &mut matrix[j * stride..][..stride];
        let gap = 1.5 * scales.gap * (-self.z[j]).max(0.0).sqrt();
        let first = grid.nodes[j].cell;
        if self.cells[first].mean <= 0.0 && self.cells[first + 1].mean <= 0.0 {
            column.fill(Block::ZERO);
            *row(column, j) = gap;
            return;
        }
        // It is the right end of the cell on its left.
        let [[mean_a, load_a, moment_a, shape_a], [mean_b, load_b, moment_b, shape_b]] =
            [(first, 1), (first + 1, 0)].map(|(c, end)| {
                let load = &self.cells[c];
                let ([mean, _, moment], lengths) = (load.slopes[end], self.cell_lengths[c][end]);
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
        let (by_nodes, by_falls) = column.split_at_mut(nodes);
        by_nodes.copy_from_slice(&by_z[..nodes]);
        project(&by_z[nodes..], &self.falls, by_falls);
        *row(by_nodes, j) += gap;
        project(&by_shape[nodes..], &self.falls, &mut self.by_falls);
        for (k, share) in grid.nodes[j].between.weights() {
            let (by_nodes, by_falls) = by_knots[k * stride..][..stride].split_at_mut(nodes);
            add(share, by_shape, by_nodes);
            add(share, &self.by_falls, by_falls);
        }
    }

    /// The derivatives of all residuals by all unknowns at the present ones, by rows, into `matrix`; returns their number.
    pub fn matrix_at(&mut self, grid: &Grid, knots: &Knots, matrix: &mut Vec<f64>) -> usize {
        let scales = Scales::new(&grid.samples);
        self.linearise(grid, &scales, grid.is_skewed());
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

    /// Makes the equations of nodes as steep as they have to be and finds their residual; returns the greatest overlap that a node without load has beyond its gap, over the depth.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn steepen(&mut self, grid: &Grid, scales: &Scales) -> f64 {
        let (n, stride) = (grid.nodes.len(), self.nodes + self.behind);
        let (matrix, right) = self.matrix.split_at_mut(self.pivots.len() * stride);
        let greatest = (0..n).map(|i| row(right, i).abs()).fold(0.0, f64::max);
        let least = LEAST_SLOPE * greatest.min(grid.samples.depth) / scales.load;
        let (mut not_carried, mut apart) = (0.0f64, 0.0f64);
        for (i, column) in matrix.chunks_exact_mut(stride).take(n).enumerate() {
            let slope = row(column, i);
            *slope = slope.max(least);
            let (node, z, residual) = (&grid.nodes[i], self.z[i], *row(right, i));
            let below = (-z).max(0.0);
            let overlap = residual - scales.gap * below * below.sqrt();
            if z > 0.0 {
                apart = apart.max(residual.abs());
            } else if overlap > 0.0 {
                let width = 0.5 * (node.reach[1] - node.reach[0]);
                let loaded = SELF_INFLUENCE * INFLUENCE * width / scales.length;
                *slope = slope.max(residual / (below + overlap / loaded));
                not_carried = not_carried.max(overlap);
            }
        }
        self.residual = apart.max(not_carried) / grid.samples.depth;
        not_carried / grid.samples.depth
    }

    /// One step; its greatest change, or nothing where the equations have no solution.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn step(&mut self, grid: &Grid, scales: &Scales) -> Option<f64> {
        let stride = self.nodes + self.behind;
        let mut greatest = self.steepen(grid, scales);
        if !elimination::solve(&mut self.matrix, stride, &self.pivots) {
            return None;
        }
        let change = &mut self.matrix[self.pivots.len() * stride..];
        let least = f64::EPSILON * scales.load;
        for (i, z) in self.z.iter_mut().enumerate() {
            let change = *row(change, i);
            let is_loaded = *z > 0.0;
            let most = MOST_CHANGE[0] * scales.load.max(z.abs());
            let growth = if is_loaded { z.max(MOST_GROWTH * scales.load) } else { most };
            *z += change.clamp(-most, growth);
            if !is_loaded && *z > 0.0 {
                *z *= SHARE_ACROSS;
            }
            // A load of nothing has no side.
            if z.abs() < least {
                *z = least;
            }
            // Nodes that stay without load have their gap from all the others.
            if is_loaded || *z > 0.0 {
                greatest = greatest.max(change.abs() / scales.load);
            }
        }
        let heaviest = self.weights.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        for (k, (shape, weight)) in self.shape.iter_mut().zip(&self.weights).enumerate() {
            let change = *row(change, self.nodes * LANES + k);
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
