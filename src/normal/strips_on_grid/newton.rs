//! Newton's method for the strips.
//!
//! All unknowns take one step with the exact derivative, and each component of it is bounded by itself. Every step is a continuous map of the
//! pose, whichever nodes carry load: there is nothing to be decided on the way, and nothing is tried again.

use std::ops::Range;

use multiversion::multiversion;

use super::equations::{Displacement, Fall, Scales, Strip, factor, plus, touching, wanted_fall};
use super::grid::Grid;
use super::influence::{Integrals, centred_at, shifted_at};
use super::shape::Knots;
use crate::math::linear_system::{room, solve_by_columns, stride};

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
    pub z: Vec<f64>,
    pub shape: Vec<f64>,
    /// Load per width at the nodes, its derivative by z, and χ there.
    pub loads: Vec<f64>,
    slopes: Vec<f64>,
    pub shapes: Vec<f64>,
    strips: Vec<Strip>,
    /// Distance across and along and factor of the influence of each panel on each node, panel by panel.
    across: Vec<f64>,
    along: Vec<f64>,
    factors: Vec<f64>,
    is_skewed: bool,
    penalty: Vec<f64>,
    /// Half lengths at the nodes, and share of load over the fall that is wanted of each loaded one.
    lengths: Vec<f64>,
    scales: Vec<f64>,
    /// Influence of the panel under way.
    columns: [Vec<f64>; 3],
    /// The displacement that its fall is counted from, and its derivative.
    centres: [Vec<f64>; 2],
    displacement: Vec<f64>,
    fallen: Vec<f64>,
    fall_by_node: Vec<f64>,
    /// Derivatives of the displacements by the loads per width, by χ of the nodes and by the knots, by columns.
    by_load: Vec<f64>,
    by_shape: Vec<f64>,
    by_knot: Vec<f64>,
    /// The same of the falls.
    fall_by_load: Vec<f64>,
    fall_by_shape: Vec<f64>,
    /// Derivatives of the equations of the knots, by columns.
    knot_by_load: Vec<f64>,
    knot_by_knot: Vec<f64>,
    /// Nodes that may carry load.
    active: Vec<usize>,
    matrix: Vec<f64>,
    right: Vec<f64>,
    change: Vec<f64>,
    /// Steps so far.
    pub steps: u64,
    /// Length of a column over all nodes, in whole vectors.
    column: usize,
}

impl Newton {
    /// Memory for `n` nodes, `knots` and `panels` panels.
    pub fn new(n: usize, knots: &Knots, panels: usize) -> Self {
        let m = knots.count();
        let long = n.next_multiple_of(LANES);
        let column = || vec![0.0; long];
        Self {
            z: column(),
            shape: vec![0.0; m],
            loads: column(),
            slopes: column(),
            shapes: column(),
            strips: vec![Strip::default(); panels],
            across: vec![0.0; long * panels],
            along: vec![0.0; long * panels],
            factors: vec![0.0; long * panels],
            is_skewed: false,
            penalty: (0..m * m).map(|i| knots.penalty(i / m, i % m)).collect(),
            lengths: column(),
            scales: column(),
            columns: [column(), column(), column()],
            centres: [column(), column()],
            displacement: column(),
            fallen: column(),
            fall_by_node: column(),
            by_load: vec![0.0; long * n],
            by_shape: vec![0.0; long * n],
            by_knot: vec![0.0; long * m],
            fall_by_load: vec![0.0; long * n],
            fall_by_shape: vec![0.0; long * n],
            knot_by_load: vec![0.0; n * m],
            knot_by_knot: vec![0.0; m * m],
            active: vec![0; n],
            matrix: vec![0.0; room(n + m)],
            right: vec![0.0; n + m],
            change: vec![0.0; n + m],
            steps: 0,
            column: long,
        }
    }

    /// Solves the equations on `grid`; false where the last step was longer than it should be.
    pub fn solve(&mut self, grid: &Grid, integrals: &Integrals, knots: &Knots) -> bool {
        let scales = Scales::new(grid);
        self.measure(grid);
        self.start(grid, &scales);
        for _ in 0..MOST_STEPS {
            self.steps += 1;
            self.linearise(grid, integrals, knots, &scales);
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

    /// Distances and factors of all pairs.
    fn measure(&mut self, grid: &Grid) {
        let x = grid.nodes[0].place.x;
        // What is beyond the last node counts for nothing, as its factors are zero.
        self.across.fill(1.0);
        self.is_skewed = grid.nodes.iter().any(|node| (node.place.x - x).abs() > 0.0);
        for (p, panel) in grid.panels.iter().enumerate() {
            let range = p * self.column..(p + 1) * self.column;
            let columns = self.across[range.clone()]
                .iter_mut()
                .zip(&mut self.along[range.clone()])
                .zip(&mut self.factors[range]);
            for (node, ((across, along), share)) in grid.nodes.iter().zip(columns) {
                *across = panel.distance(node.y);
                *along = node.place.x - panel.x;
                *share = factor(node, panel);
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
    fn place(&mut self, grid: &Grid, knots: &Knots, scales: &Scales) {
        for i in 0..grid.nodes.len() {
            [self.loads[i], self.slopes[i]] = plus(self.z[i], scales.corner);
            self.shapes[i] = knots.value(i, &self.shape);
        }
        for (strip, panel) in self.strips.iter_mut().zip(grid.panels.iter()) {
            let load = panel.sum(panel.shares, &self.loads);
            *strip = if load > 0.0 && panel.width > 0.0 {
                Strip::new(load, panel.sum(panel.shape_shares, &self.shapes), scales.least_square)
            } else {
                Strip::default()
            };
        }
    }

    /// Displacements and their fall at the present unknowns, and all derivatives.
    fn linearise(&mut self, grid: &Grid, integrals: &Integrals, knots: &Knots, scales: &Scales) {
        self.place(grid, knots, scales);
        let n = grid.nodes.len();
        // Falls are wanted of loaded nodes alone.
        let mut loaded = n..0;
        for (i, node) in grid.nodes.iter().enumerate() {
            let load = self.loads[i];
            let own = Strip::new(load, self.shapes[i], scales.least_square);
            self.lengths[i] = own.half_length;
            self.scales[i] = node.width * load / (scales.total * wanted_fall(&own, node));
            if load > 0.0 {
                loaded = loaded.start.min(i)..i + 1;
            }
        }
        for sums in [&mut self.displacement, &mut self.fallen, &mut self.fall_by_node] {
            sums.fill(0.0);
        }
        for columns in [
            &mut self.by_load,
            &mut self.by_shape,
            &mut self.by_knot,
            &mut self.fall_by_load,
            &mut self.fall_by_shape,
            &mut self.knot_by_load,
        ] {
            columns.fill(0.0);
        }
        self.knot_by_knot.fill(0.0);
        let loaded = whole_vectors(&loaded);
        for p in 0..grid.panels.len() {
            if self.strips[p].load > 0.0 {
                self.add_displacement(grid, integrals, p);
                self.add_fall(grid, integrals, p, loaded.clone());
            }
        }
        self.take_to_knots(grid, knots, &loaded);
        self.finish_knots(grid, knots, scales);
    }

    /// Adds the displacements by panel number `p`, and their derivatives.
    fn add_displacement(&mut self, grid: &Grid, integrals: &Integrals, p: usize) {
        let (panel, strip) = (&grid.panels[p], self.strips[p]);
        let range = p * self.column..(p + 1) * self.column;
        let [value, by_panel, _] = &mut self.columns;
        let along = if self.is_skewed { &self.along[range.clone()] } else { &[][..] };
        let factors = &self.factors[range.clone()];
        let [centre, slope] = &mut self.centres;
        let columns = [value.as_mut_slice(), by_panel, centre, slope];
        displacements(along, &self.across[range], factors, 1.0 / strip.half_length, columns);
        if let Some(i) = panel.touches {
            let (own, _) = touching(integrals, panel, strip.half_length, self.lengths[i]);
            (value[i], by_panel[i]) = (factors[i] * own.value, factors[i] * own.by_panel);
        }
        let share = strip.load * strip.length_by_load;
        add(strip.load, value, &mut self.displacement);
        for (node, [weight, shape_weight]) in panel.weights() {
            let column = node * self.column..(node + 1) * self.column;
            let by_load = &mut self.by_load[column.clone()];
            add(weight, value, by_load);
            add(weight * share, by_panel, by_load);
            add(-shape_weight * share * strip.load, by_panel, &mut self.by_shape[column]);
        }
    }

    /// Adds the falls of the displacements by panel number `p` at the nodes `loaded`, and their derivatives.
    fn add_fall(&mut self, grid: &Grid, integrals: &Integrals, p: usize, loaded: Range<usize>) {
        let (panel, strip) = (&grid.panels[p], self.strips[p]);
        let range = p * self.column + loaded.start..p * self.column + loaded.end;
        let [value, by_panel, by_node] = &mut self.columns;
        let columns = [
            &mut value[loaded.clone()],
            &mut by_panel[loaded.clone()],
            &mut by_node[loaded.clone()],
        ];
        let along = if self.is_skewed { &self.along[range.clone()] } else { &[][..] };
        let factors = &self.factors[range.clone()];
        let lengths = &self.lengths[loaded.clone()];
        let centres = self.centres.each_ref().map(|centre| &centre[loaded.clone()]);
        let inverse = 1.0 / strip.half_length;
        falls(along, &self.across[range], factors, lengths, inverse, centres, columns);
        if let Some(i) = panel.touches.filter(|i| loaded.contains(i)) {
            let (_, own) = touching(integrals, panel, strip.half_length, self.lengths[i]);
            let factor = self.factors[p * self.column + i];
            value[i] = factor * own.value;
            by_panel[i] = factor * own.by_panel;
            by_node[i] = factor * own.by_node;
        }
        add(strip.load, &value[loaded.clone()], &mut self.fallen[loaded.clone()]);
        add(strip.load, &by_node[loaded.clone()], &mut self.fall_by_node[loaded.clone()]);
        let share = strip.load * strip.length_by_load;
        for (node, [weight, shape_weight]) in panel.weights() {
            let first = node * self.column;
            let rows = first + loaded.start..first + loaded.end;
            let by_load = &mut self.fall_by_load[rows.clone()];
            add(weight, &value[loaded.clone()], by_load);
            add(weight * share, &by_panel[loaded.clone()], by_load);
            let factor = -shape_weight * share * strip.load;
            add(factor, &by_panel[loaded.clone()], &mut self.fall_by_shape[rows]);
        }
    }

    /// Takes derivatives by χ of the nodes to those by χ at the knots, and falls at the nodes to the equations of the knots.
    fn take_to_knots(&mut self, grid: &Grid, knots: &Knots, loaded: &Range<usize>) {
        let (n, m, long) = (grid.nodes.len(), knots.count(), self.column);
        let loaded = loaded.start..loaded.end.min(n);
        for j in 0..n {
            let column = j * long..(j + 1) * long;
            for (k, share) in knots.of(j) {
                add(
                    share,
                    &self.by_shape[column.clone()],
                    &mut self.by_knot[k * long..(k + 1) * long],
                );
            }
            let by_load = &mut self.knot_by_load[j * m..(j + 1) * m];
            let falls = &self.fall_by_load[column.clone()];
            let by_shape = &self.fall_by_shape[column];
            for i in loaded.clone() {
                let [(k, first), (_, second)] = knots.of(i);
                let scale = self.scales[i];
                let (value, shape) = (scale * falls[i], scale * by_shape[i]);
                by_load[k] += first * value;
                by_load[k + 1] += second * value;
                for (other, share) in knots.of(j) {
                    let sums = &mut self.knot_by_knot[other * m..(other + 1) * m];
                    sums[k] += share * first * shape;
                    sums[k + 1] += share * second * shape;
                }
            }
        }
    }

    /// Residuals of the equations of the knots, into `right`, and what their derivatives have from the nodes' own half lengths and weights.
    fn finish_knots(&mut self, grid: &Grid, knots: &Knots, scales: &Scales) {
        let (n, m) = (grid.nodes.len(), knots.count());
        self.right.fill(0.0);
        for (i, node) in grid.nodes.iter().enumerate() {
            let load = self.loads[i];
            if load <= 0.0 {
                continue;
            }
            let own = Strip::new(load, self.shapes[i], scales.least_square);
            let wanted = wanted_fall(&own, node);
            let error = self.fallen[i] / wanted - 1.0;
            let per_load = node.width / scales.total;
            let by_length =
                per_load * load * (self.fall_by_node[i] - 2.0 * self.fallen[i]) / wanted;
            let by_load = by_length * own.length_by_load + per_load * error;
            let by_shape = -(by_length * own.length_by_load * load);
            for (row, share) in knots.of(i) {
                self.right[n + row] += per_load * load * error * share;
                self.knot_by_load[i * m + row] += share * by_load;
                for (k, other) in knots.of(i) {
                    self.knot_by_knot[k * m + row] += share * other * by_shape;
                }
            }
        }
        for row in 0..m {
            for k in 0..m {
                let penalty = self.penalty[row * m + k];
                self.right[n + row] += penalty * self.shape[k];
                self.knot_by_knot[k * m + row] += penalty;
            }
        }
        for (i, node) in grid.nodes.iter().enumerate() {
            let gap = scales.gap * (self.loads[i] - self.z[i]);
            self.right[i] = (self.displacement[i] - node.place.overlap - gap) / grid.depth;
        }
    }

    /// The derivatives of all residuals by all unknowns at the present ones, by rows, into `matrix`; returns their number.
    pub fn matrix_at(
        &mut self,
        grid: &Grid,
        integrals: &Integrals,
        knots: &Knots,
        matrix: &mut Vec<f64>,
    ) -> usize {
        let scales = Scales::new(grid);
        self.linearise(grid, integrals, knots, &scales);
        let (n, m) = (grid.nodes.len(), knots.count());
        matrix.clear();
        for i in 0..n {
            for j in 0..n {
                let own = f64::from(u8::from(i == j)) * scales.gap * (self.slopes[j] - 1.0);
                matrix
                    .push((self.by_load[j * self.column + i] * self.slopes[j] - own) / grid.depth);
            }
            matrix.extend((0..m).map(|k| self.by_knot[k * self.column + i] / grid.depth));
        }
        for row in 0..m {
            matrix.extend((0..n).map(|j| self.knot_by_load[j * m + row] * self.slopes[j]));
            matrix.extend((0..m).map(|k| self.knot_by_knot[k * m + row]));
        }
        n + m
    }

    /// One step; its greatest change, or nothing where the equations have no solution.
    fn step(&mut self, grid: &Grid, scales: &Scales) -> Option<f64> {
        let (n, m) = (grid.nodes.len(), self.shape.len());
        let mut count = 0;
        for i in 0..n {
            if self.slopes[i] > 0.0 {
                self.active[count] = i;
                count += 1;
            }
        }
        let active = &self.active[..count];
        let size = count + m;
        let stride = stride(size);
        // z in units of the load per width of the ellipse.
        let per_depth = scales.load / grid.depth;
        for (column, &j) in active.iter().enumerate() {
            let out = &mut self.matrix[column * stride..][..size];
            for (row, &i) in active.iter().enumerate() {
                out[row] = self.by_load[j * self.column + i] * self.slopes[j] * per_depth;
            }
            out[column] -= scales.gap * (self.slopes[j] - 1.0) * per_depth;
            for row in 0..m {
                out[count + row] = self.knot_by_load[j * m + row] * self.slopes[j] * scales.load;
            }
        }
        for k in 0..m {
            let out = &mut self.matrix[(count + k) * stride..][..size];
            for (row, &i) in active.iter().enumerate() {
                out[row] = self.by_knot[k * self.column + i] / grid.depth;
            }
            out[count..].copy_from_slice(&self.knot_by_knot[k * m..(k + 1) * m]);
        }
        let change = &mut self.change[..size];
        for (row, &i) in active.iter().enumerate() {
            change[row] = -self.right[i];
        }
        for row in 0..m {
            change[count + row] = -self.right[n + row];
        }
        if !solve_by_columns(&mut self.matrix, change) {
            return None;
        }
        // Nodes without load have their gap from all the others.
        let mut next = 0;
        let mut greatest = 0.0f64;
        for i in 0..n {
            let is_active = active.get(next) == Some(&i);
            let wanted = if is_active {
                next += 1;
                let wanted = change[next - 1] * scales.load;
                greatest = greatest.max(change[next - 1].abs());
                wanted
            } else {
                let by_loads: f64 = active
                    .iter()
                    .zip(change.iter())
                    .map(|(&j, d)| {
                        self.by_load[j * self.column + i] * self.slopes[j] * d * scales.load
                    })
                    .sum();
                let by_knots: f64 =
                    (0..m).map(|k| self.by_knot[k * self.column + i] * change[count + k]).sum();
                -(self.right[i] * grid.depth + by_loads + by_knots) / scales.gap
            };
            let most = MOST_CHANGE[0] * scales.load;
            self.z[i] += wanted.clamp(-most, most);
        }
        let weight = |k: usize| self.knot_by_knot[k * m + k].abs();
        let heaviest = (0..m).map(weight).fold(f64::MIN_POSITIVE, f64::max);
        for k in 0..m {
            let change = change[count + k];
            self.shape[k] += change.clamp(-MOST_CHANGE[1], MOST_CHANGE[1]);
            greatest = greatest.max(change.abs() * weight(k) / heaviest);
        }
        Some(greatest)
    }
}

/// The range, made as long as whole vectors.
fn whole_vectors(range: &Range<usize>) -> Range<usize> {
    range.start / LANES * LANES..range.end.next_multiple_of(LANES)
}

/// Numbers taken together: columns are as long as whole vectors of them, so that no loop has a rest.
const LANES: usize = 8;

/// Displacements by a panel at distances `across`, and `along` unless that is empty, times `factors`, and their derivatives; behind them the influences
/// that they are made of.
#[multiversion(targets("x86_64+avx512f+avx512dq", "x86_64+avx2", "aarch64+neon"))]
fn displacements(
    along: &[f64],
    across: &[f64],
    factors: &[f64],
    inverse: f64,
    [value, by_panel, centre, slope]: [&mut [f64]; 4],
) {
    let n = across.len();
    let (factors, value, by_panel) = (&factors[..n], &mut value[..n], &mut by_panel[..n]);
    let (centre, slope) = (&mut centre[..n], &mut slope[..n]);
    if along.is_empty() {
        for i in 0..n {
            let at = centred_at(across[i] * inverse);
            (centre[i], slope[i]) = (at.d, at.slope);
        }
    } else {
        let along = &along[..n];
        for i in 0..n {
            let at = shifted_at(along[i] * inverse, across[i] * inverse);
            (centre[i], slope[i]) = (at.d, at.slope);
        }
    }
    for i in 0..n {
        let own = Displacement::of(centre[i], slope[i], inverse);
        (value[i], by_panel[i]) = (factors[i] * own.value, factors[i] * own.by_panel);
    }
}

/// The falls from the influences `centres` = (D, its derivative) at nodes of half lengths `lengths`, times `factors`, and their derivatives.
#[multiversion(targets("x86_64+avx512f+avx512dq", "x86_64+avx2", "aarch64+neon"))]
fn falls(
    along: &[f64],
    across: &[f64],
    factors: &[f64],
    lengths: &[f64],
    inverse: f64,
    centres: [&[f64]; 2],
    [value, by_panel, by_node]: [&mut [f64]; 3],
) {
    let n = across.len();
    let (factors, lengths) = (&factors[..n], &lengths[..n]);
    let [d, slope] = centres.map(|centre| &centre[..n]);
    let (value, by_panel, by_node) = (&mut value[..n], &mut by_panel[..n], &mut by_node[..n]);
    if along.is_empty() {
        for i in 0..n {
            let at = Fall::straight([d[i], slope[i]], across[i], inverse, lengths[i]);
            value[i] = factors[i] * at.value;
            by_panel[i] = factors[i] * at.by_panel;
            by_node[i] = factors[i] * at.by_node;
        }
    } else {
        let along = &along[..n];
        for i in 0..n {
            let at = Fall::shifted([d[i], slope[i]], along[i], across[i], inverse, lengths[i]);
            value[i] = factors[i] * at.value;
            by_panel[i] = factors[i] * at.by_panel;
            by_node[i] = factors[i] * at.by_node;
        }
    }
}

/// Adds a multiple of `column` to `sums`.
#[multiversion(targets("x86_64+avx512f+avx512dq", "x86_64+avx2", "aarch64+neon"))]
fn add(factor: f64, column: &[f64], sums: &mut [f64]) {
    for (sum, value) in sums.iter_mut().zip(column) {
        *sum += factor * value;
    }
}
