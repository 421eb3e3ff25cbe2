//! Newton's method for the strips.
//!
//! All unknowns take one step with the exact derivative, and each component of it is bounded by itself. Every step is a continuous map of the
//! pose, whichever nodes carry load: there is nothing to be decided on the way, and nothing is tried again.

use multiversion::multiversion;

use super::columns::{Beside, LANES, Rows, Sources, Sums, add, scale};
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
/// Sources beside a node: the points of the rule on both sides.
const NEAR: usize = 2 * RULE.len();

/// Unknowns and memory for as many nodes as the solver was made for.
///
/// Rows are nodes, and behind them the knots.
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
    near: Sources,
    beside: Beside,
    sums: Sums,
    /// Displacements by the moments of cells, per load per width of each node, by columns.
    moments: Vec<f64>,
    /// First of both knots of each node, and what their equations have of its fall: share of load over the fall that is wanted.
    falls: Vec<(usize, [f64; 2])>,
    /// Derivatives of displacements by χ of a node, and of falls by its load per width and χ.
    by_shape: Vec<f64>,
    fall_by_load: Vec<f64>,
    fall_by_shape: Vec<f64>,
    knot_sums: Vec<f64>,
    penalty: Vec<f64>,
    /// Derivatives of all equations by columns, and behind them minus their residuals, which become the step.
    matrix: Vec<f64>,
    pivots: Vec<usize>,
    factors: Vec<f64>,
    /// Derivatives of the equations of the knots by their own χ.
    weights: Vec<f64>,
    /// Steps so far.
    pub steps: u64,
    /// Length of a column over all nodes, in whole vectors, and with the knots.
    column: usize,
    stride: usize,
}

impl Newton {
    /// Memory for `n` nodes, the `knots` and `cells` cells.
    pub fn new(n: usize, knots: &Knots, cells: usize) -> Self {
        let m = knots.count();
        let column = n.next_multiple_of(LANES);
        let stride = column + m.next_multiple_of(LANES);
        let numbers = |count: usize| vec![0.0; count];
        Self {
            z: numbers(n),
            shape: numbers(m),
            loads: numbers(n),
            slopes: numbers(n),
            shapes: numbers(n),
            slenderness: numbers(n),
            strips: vec![Strip::default(); n],
            cells: vec![Strip::default(); cells],
            rows: Rows::new(column),
            is_skewed: false,
            far: Sources::new(cells, column),
            near: Sources::new(NEAR, column),
            beside: Beside::new(column),
            sums: Sums::new(column),
            moments: numbers(n * column),
            falls: vec![(0, [0.0; 2]); n],
            by_shape: numbers(column),
            fall_by_load: numbers(column),
            fall_by_shape: numbers(column),
            knot_sums: numbers(stride - column),
            penalty: (0..m * m).map(|i| knots.penalty(i / m, i % m)).collect(),
            matrix: numbers((n + m + 1) * stride),
            pivots: (0..n).chain(column..column + m).collect(),
            factors: numbers(stride),
            weights: numbers(m),
            steps: 0,
            column,
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
            match self.step(grid, &scales) {
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
        self.is_skewed = grid.is_skewed();
        for (row, node) in nodes.iter().enumerate() {
            let [a, b] = node.place.tangent;
            for (column, value) in self.rows.places.iter_mut().zip([node.place.x, node.y, a, b]) {
                column[row] = value;
            }
        }
        self.moments.fill(0.0);
        for (c, cell) in grid.cells.iter().enumerate() {
            let moments = &mut self.by_shape;
            self.far.put_cell(c, cell, scales.length, &self.rows, moments);
            // The points of the rule take the place of cells beside a node.
            for &i in cell.nodes.iter().flatten() {
                let nothing = Pair { along: 0.0, across: 1.0, factor: 0.0 };
                self.far.put(c, i, &nothing);
                moments[i] = 0.0;
            }
            for (end, sign) in cell.nodes.into_iter().zip([-1.0, 1.0]) {
                let Some(j) = end else { continue };
                add(sign, moments, &mut self.moments[j * self.column..(j + 1) * self.column]);
            }
        }
        for slot in 0..NEAR {
            for i in 0..nodes.len() {
                let pair = near_pair(nodes, i, slot / RULE.len(), slot % RULE.len());
                self.near.put(slot, i, &pair);
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
        let n = grid.nodes.len();
        for (i, node) in grid.nodes.iter().enumerate() {
            let strip = &self.strips[i];
            self.rows.lengths[i] = strip.half_length;
            self.rows.loads[i] = strip.load;
            self.rows.slenderness[i] = self.slenderness[i];
            let scale = node.width * strip.load / (scales.total * wanted_fall(strip, node));
            let [(k, left), (_, right)] = knots.of(i);
            self.falls[i] = (k, [left * scale, right * scale]);
        }
        self.sums.clear();
        self.matrix[n * self.stride..].fill(0.0);
        for (c, strip) in self.cells[..grid.cells.len()].iter().enumerate() {
            self.far.act(c, strip, &self.rows, self.is_skewed, &mut self.sums);
        }
        for j in 0..n {
            self.gather(grid, knots, j);
        }
        self.add_near_cells(grid, knots, scales);
        self.finish(grid, knots, scales);
    }

    /// Takes derivatives by the cells on both sides of node `j` to those by its load per width and by the knots.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn gather(&mut self, grid: &Grid, knots: &Knots, j: usize) {
        let (long, stride) = (self.column, self.stride);
        let (matrix, by_knots) = self.matrix.split_at_mut(grid.nodes.len() * stride);
        let column = &mut matrix[j * stride..][..stride];
        column.fill(0.0);
        let first = grid.nodes[j].cell;
        if self.cells[first].load <= 0.0 && self.cells[first + 1].load <= 0.0 {
            return;
        }
        let shares = [first, first + 1].map(|c| {
            let strip = &self.cells[c];
            let share = strip.load * strip.length_by_load;
            // Beyond the last node χ stays what it is.
            let all: f64 = grid.cells[c].nodes.iter().flatten().map(|&k| self.slenderness[k]).sum();
            [0.5 * share, -strip.load * share * self.slenderness[j] / all]
        });
        let (by_load, of_knots) = column.split_at_mut(long);
        let moments = &self.moments[j * long..(j + 1) * long];
        self.far.gather(
            first,
            shares,
            moments,
            [by_load, &mut self.by_shape, &mut self.fall_by_load, &mut self.fall_by_shape],
        );
        add(self.loads[j], moments, &mut self.sums.displacement);
        let slope = self.slopes[j];
        scale(slope, by_load);
        self.knot_sums.fill(0.0);
        let falls = self.falls.iter().zip(&self.fall_by_load).zip(&self.fall_by_shape);
        for ((&(k, [a, b]), value), shape) in falls {
            let value = slope * value;
            of_knots[k] += a * value;
            of_knots[k + 1] += b * value;
            self.knot_sums[k] += a * shape;
            self.knot_sums[k + 1] += b * shape;
        }
        for (k, share) in knots.of(j) {
            let by_knot = &mut by_knots[k * stride..(k + 1) * stride];
            add(share, &self.by_shape, &mut by_knot[..long]);
            add(share, &self.knot_sums, &mut by_knot[long..]);
        }
    }

    /// Adds what the two cells beside each node do to it.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn add_near_cells(&mut self, grid: &Grid, knots: &Knots, scales: &Scales) {
        let (n, long, stride) = (grid.nodes.len(), self.column, self.stride);
        self.beside.clear();
        for side in [0, 1] {
            let Beside { other_loads, other_slenderness, .. } = &mut self.beside;
            for (i, node) in grid.nodes.iter().enumerate() {
                // Beyond the last node χ stays what it is.
                (other_loads[i], other_slenderness[i]) = match node.neighbours[side] {
                    Some(j) => (self.loads[j], self.slenderness[j]),
                    None => (0.0, self.slenderness[i]),
                };
            }
            for (k, [t, _]) in RULE.into_iter().enumerate() {
                let slot = [side * RULE.len() + k, side];
                let (rows, sums) = (&self.rows, &mut self.sums);
                let shares = [t, scales.least_square];
                self.beside.act(&mut self.near, slot, shares, rows, self.is_skewed, sums);
            }
        }
        let (matrix, by_knots) = self.matrix.split_at_mut(n * stride);
        let Beside { own, others: [left, right], .. } = &self.beside;
        for (i, node) in grid.nodes.iter().enumerate() {
            let (first, [a, b]) = self.falls[i];
            let neighbours = node.neighbours;
            let ends = [(Some(i), own), (neighbours[0], left), (neighbours[1], right)];
            for (j, [by_load, by_shape, fall_by_load, fall_by_shape]) in ends {
                if let Some(j) = j.filter(|&j| self.slopes[j] > 0.0) {
                    let column = &mut matrix[j * stride..][..stride];
                    column[i] += self.slopes[j] * by_load[i];
                    let value = self.slopes[j] * fall_by_load[i];
                    column[long + first] += a * value;
                    column[long + first + 1] += b * value;
                }
                for (k, part) in knots.of(j.unwrap_or(i)) {
                    let column = &mut by_knots[k * stride..][..stride];
                    column[i] += part * by_shape[i];
                    let value = part * fall_by_shape[i];
                    column[long + first] += a * value;
                    column[long + first + 1] += b * value;
                }
            }
        }
    }

    /// Residuals, what the equations of the knots have from the nodes' own half lengths and weights, and the gaps.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn finish(&mut self, grid: &Grid, knots: &Knots, scales: &Scales) {
        let (n, m, long, stride) = (grid.nodes.len(), self.shape.len(), self.column, self.stride);
        let (matrix, right) = self.matrix.split_at_mut((n + m) * stride);
        for (i, node) in grid.nodes.iter().enumerate() {
            let own = &self.strips[i];
            if own.load <= 0.0 {
                continue;
            }
            let (fallen, wanted) = (self.sums.fall[i], wanted_fall(own, node));
            let error = fallen / wanted - 1.0;
            let weight = node.width / scales.total;
            let by_length = weight * own.load * (self.sums.fall_by_node[i] - 2.0 * fallen) / wanted;
            let by_load = by_length * own.length_by_load + weight * error;
            let by_shape = -(by_length * own.length_by_load * own.load);
            for (k, share) in knots.of(i) {
                right[long + k] -= weight * own.load * error * share;
                matrix[i * stride + long + k] += share * by_load * self.slopes[i];
                for (other, part) in knots.of(i) {
                    matrix[(n + other) * stride + long + k] += share * part * by_shape;
                }
            }
        }
        for k in 0..m {
            let column = &mut matrix[(n + k) * stride + long..][..m];
            for (other, value) in column.iter_mut().enumerate() {
                let penalty = self.penalty[other * m + k];
                right[long + other] -= penalty * self.shape[k];
                *value += penalty;
            }
            self.weights[k] = column[k].abs();
        }
        for (i, node) in grid.nodes.iter().enumerate() {
            let gap = scales.gap * (self.loads[i] - self.z[i]);
            right[i] = node.place.overlap + gap - self.sums.displacement[i];
            matrix[i * stride + i] -= scales.gap * (self.slopes[i] - 1.0);
        }
    }

    /// The derivatives of all residuals by all unknowns at the present ones, by rows, into `matrix`; returns their number.
    pub fn matrix_at(&mut self, grid: &Grid, knots: &Knots, matrix: &mut Vec<f64>) -> usize {
        let scales = Scales::new(grid);
        self.linearise(grid, knots, &scales);
        let (n, m) = (grid.nodes.len(), knots.count());
        matrix.clear();
        for row in 0..n {
            matrix.extend((0..n + m).map(|j| self.matrix[j * self.stride + row] / grid.depth));
        }
        for row in self.column..self.column + m {
            matrix.extend((0..n + m).map(|j| self.matrix[j * self.stride + row]));
        }
        n + m
    }

    /// One step; its greatest change, or nothing where the equations have no solution.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn step(&mut self, grid: &Grid, scales: &Scales) -> Option<f64> {
        let (n, m) = (grid.nodes.len(), self.shape.len());
        if !elimination::solve(&mut self.matrix, self.stride, &self.pivots, &mut self.factors) {
            return None;
        }
        let change = &self.matrix[(n + m) * self.stride..];
        let mut greatest = 0.0f64;
        let most = MOST_CHANGE[0] * scales.load;
        for ((z, slope), change) in self.z.iter_mut().zip(&self.slopes).zip(change) {
            *z += change.clamp(-most, most);
            // Nodes without load have their gap from all the others.
            if *slope > 0.0 {
                greatest = greatest.max(change.abs() / scales.load);
            }
        }
        let heaviest = self.weights.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        let changes = change[self.column..].iter().zip(&self.weights);
        for (shape, (change, weight)) in self.shape.iter_mut().zip(changes) {
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
