//! The system of equations of all lobes: residuals and their derivatives.
//!
//! At node i, in lengths after division by π E*, with the trailing sums over the nodes of its own lobe
//!
//! ```text
//! u_i = Σ_j≠i w_j q_j D_ij cos_ij - q_i Σ_j≠i w_j D(Δy_ij/a_i) + q_i a_i [Ψ(S_left/a_i) + Ψ(S_right/a_i)]
//!       - 2 Σ_j C_ij (q_j B_ij - q_i B'_ij)
//! ```
//!
//! The second and third term take the singularity out of the sum and put its integral in its place; the last one mends the sum for
//! the logarithm that is left. Strips shifted along x lie no further apart for that, so that the singularity is that of straight ones;
//! cos_ij is that of the angle between the normals.
//! The fall of u from x = 0 to both [`STATION`]s along the strip follows in the same way with that of D.

use super::cell::{Cell, TERMS};
use super::influence::{Integrals, STATION};
use super::nodes::{Lobe, Matrices, Nodes, Scratch};
use super::pair_sums::{
    Acting, Column, LANES, MOST_TARGETS, Source, Sums, Targets, from_elsewhere, weighed,
    within_lobe,
};
use super::rule::LobeRule;
use crate::math::linear_system::stride;

/// Regularisation of the shape terms beyond the first: what the equations hardly determine stays small.
pub const SHAPE_REGULARISATION: f64 = 2.5e-6;

/// What the assembly needs beside nodes and lobes.
pub struct Assembly<'a> {
    pub rule: &'a LobeRule,
    pub integrals: &'a Integrals,
    pub cells: &'a [Cell],
    pub lobes: &'a [Lobe],
    pub nodes: &'a Nodes,
    /// Whether strips are centred beside each other's ends, on a yawed wheel.
    pub skewed: bool,
    /// Greatest overlap [m].
    pub depth: f64,
    /// Typical ratio q over π E* [-].
    pub scale: f64,
}

impl Assembly<'_> {
    /// Unknowns of one lobe: ratios at the nodes, left and right edge, shape.
    pub fn unknowns_per_lobe(&self) -> usize {
        self.rule.count() + 2 + self.rule.terms
    }

    /// Place of an entry of the Newton matrix.
    pub fn entry(&self, row: usize, column: usize) -> usize {
        column * stride(self.lobes.len() * self.unknowns_per_lobe()) + row
    }

    /// Derivative of the pressure of node `k` of a lobe by its ratio [-].
    fn ratio_factor(&self, lobe: usize, k: usize) -> f64 {
        let j = self.lobes[lobe].first + k;
        if self.nodes.ratio[j] > 0.0 { self.nodes.edge_shape[j] } else { 0.0 }
    }

    /// Fills the Newton matrix and its right side (minus the residuals).
    pub fn assemble(&self, m: &mut Matrices) {
        let unknowns = self.lobes.len() * self.unknowns_per_lobe();
        let n = self.rule.count();
        let columns = m.newton[..unknowns * stride(unknowns)].chunks_exact_mut(stride(unknowns));
        for column in columns {
            for lobe in column[..unknowns].chunks_exact_mut(self.unknowns_per_lobe()) {
                lobe[n..].fill(0.0);
            }
            column[unknowns..].fill(0.0);
        }
        m.right.fill(0.0);
        for (number, lobe) in self.lobes.iter().enumerate() {
            let nodes = self.nodes;
            let load = (lobe.first..lobe.first + n)
                .map(|j| nodes.width[j] * nodes.pressure[j] * nodes.half_length[j])
                .sum();
            for begin in (0..n).step_by(MOST_TARGETS) {
                let count = (n - begin).min(MOST_TARGETS);
                self.node_rows(m, &LobePart { lobe: number, load, begin, count });
            }
            self.edge_rows(m, number);
        }
    }

    /// Equations of the nodes of a part and their share of the equations of the fall of its lobe.
    fn node_rows(&self, m: &mut Matrices, part: &LobePart) {
        let n = self.rule.count();
        let block = self.unknowns_per_lobe();
        let Matrices { scratch, newton, right, .. } = m;
        let Scratch { targets, acting, sums, logarithm } = &mut **scratch;
        self.fill(part, targets);
        sums.begin(targets.vectors);
        let inverse_depth = 1.0 / self.depth;
        let mut rows = Rows { assembly: self, part, newton, inverse_depth };
        for (number, lobe) in self.lobes.iter().enumerate() {
            if number == part.lobe {
                continue;
            }
            sums.begin_lobe(targets.vectors);
            for k in 0..n {
                if self.nodes.pressure[lobe.first + k] > 0.0 {
                    from_elsewhere(&self.source(lobe, k), self.skewed, targets, acting, sums);
                    rows.put_node(acting, number, k);
                } else {
                    // What is not loaded does not act.
                    rows.put(number * block + k, 0.0, &sums.u);
                }
            }
            rows.put_lobe(targets, sums, number);
        }
        let lobe = &self.lobes[part.lobe];
        sums.begin_lobe(targets.vectors);
        sums.begin_own_lobe(targets.vectors);
        let [left, right_end] = self.cells[lobe.cell].edges;
        for k in 0..n {
            let corrections = &self.rule.corrections_of(k)[part.begin..];
            for (weight, correction) in logarithm.iter_mut().zip(corrections) {
                *weight = (left - right_end) * correction;
            }
            let own = self.rule.target_of_node(k).wrapping_sub(part.begin);
            if own < part.count {
                targets.other[own] = 0.0;
            }
            within_lobe(&self.source(lobe, k), self.skewed, targets, logarithm, acting, sums);
            if own < part.count {
                targets.other[own] = 1.0;
            }
            rows.put_node(acting, part.lobe, k);
        }
        self.singular(part, targets, sums, &mut rows);
        rows.put_lobe(targets, sums, part.lobe);
        rows.put_falls(part.lobe * block + n, 1.0, &weighed(targets, &sums.fall_by_edge));
        self.residuals(part, scratch, &mut rows, right);
    }

    /// Takes the nodes of a part as targets.
    fn fill(&self, part: &LobePart, targets: &mut Targets) {
        let (nodes, rule) = (self.nodes, self.rule);
        let first = self.lobes[part.lobe].first;
        targets.vectors = part.count.div_ceil(LANES);
        let falls = part.count - 2 * rule.outer;
        targets.fall_vectors = falls.div_ceil(LANES);
        for k in 0..LANES * targets.vectors {
            let t = rule.node_of_target(part.begin + k.min(part.count - 1));
            let i = first + t;
            targets.y[k] = nodes.y[i];
            targets.x[k] = nodes.x[i];
            targets.x_slope[k] = nodes.x_slope[i];
            targets.tangent[0][k] = nodes.tangent[i][0];
            targets.tangent[1][k] = nodes.tangent[i][1];
            targets.pressure[k] = nodes.pressure[i];
            let inverse = 1.0 / nodes.half_length[i];
            targets.half_length[k] = nodes.half_length[i];
            targets.inverse_length[k] = inverse;
            targets.other[k] = 1.0;
            // Falls are compared with that of the wheel.
            let weight = if k < falls {
                self.share(part, i) * nodes.radius[i] * (inverse * inverse)
            } else {
                0.0
            };
            for (weights, polynomial) in targets.weights.iter_mut().zip(rule.legendre[t]) {
                weights[k] = weight * polynomial;
            }
        }
    }

    /// Share of node `i` in the load of its lobe, none where it is not loaded.
    fn share(&self, part: &LobePart, i: usize) -> f64 {
        let nodes = self.nodes;
        if nodes.ratio[i] > 0.0 {
            nodes.width[i] * nodes.pressure[i] * nodes.half_length[i] / part.load
        } else {
            0.0
        }
    }

    /// Node `k` of a lobe as a source.
    fn source(&self, lobe: &Lobe, k: usize) -> Source {
        let (nodes, rule, j) = (self.nodes, self.rule, lobe.first + k);
        let [left, right] = self.cells[lobe.cell].edges;
        let stretch = 1.0 / (right - left);
        Source {
            y: nodes.y[j],
            x: nodes.x[j],
            x_slope: nodes.x_slope[j],
            tangent: nodes.tangent[j],
            width: nodes.width[j],
            pressure: nodes.pressure[j],
            half_length: nodes.half_length[j],
            legendre: rule.legendre[k],
            travel: [rule.travel[0][k], rule.travel[1][k]],
            stretch: [-stretch, stretch],
        }
    }

    /// The singularity of the own lobe, taken out of the sum and integrated instead, and what moves with the edges of that lobe.
    fn singular(&self, part: &LobePart, targets: &Targets, sums: &mut Sums, rows: &mut Rows) {
        let (nodes, rule) = (self.nodes, self.rule);
        let Lobe { first, cell } = self.lobes[part.lobe];
        let edges = self.cells[cell].edges;
        let inverse = 1.0 / (edges[1] - edges[0]);
        let stretch = [-inverse, inverse];
        for k in 0..part.count {
            let t = rule.node_of_target(part.begin + k);
            let i = first + t;
            let (y, q, a) = (nodes.y[i], nodes.pressure[i], nodes.half_length[i]);
            let inverse = targets.inverse_length[k];
            // How far the left and the right edge go away from the node, by each of them.
            let moved = [rule.travel[0][t], rule.travel[1][t]];
            let away = [[moved[0] - 1.0, -moved[0]], [moved[1], 1.0 - moved[1]]];
            let integrals = edges.map(|edge| self.integrals.at((edge - y).abs() * inverse));
            let sigma = edges.map(|edge| (edge - y).abs() * inverse);
            let mut u = -q * sums.own_u[k];
            let mut by_pressure = -sums.own_q[k];
            for side in 0..2 {
                let [psi, at] = integrals[side][0];
                u += q * a * psi;
                by_pressure += a * (2.0 * psi - sigma[side] * at);
            }
            sums.u[k] += u;
            rows.put_own(part.begin + k, by_pressure);
            let by_length = q * by_pressure - u;
            for (term, polynomial) in rule.legendre[t].into_iter().enumerate() {
                sums.by_shape[term][k] += by_length * polynomial;
            }
            for side in 0..2 {
                let [_, left] = integrals[0][0];
                let [_, right] = integrals[1][0];
                sums.by_edge[side][k] = sums.scaled_u[k] * stretch[side]
                    + q * (left * away[side][0] + right * away[side][1])
                    + (sums.passed[k] - nodes.overlap_slope[i]) * moved[side];
            }
            if k + 2 * rule.outer >= part.count {
                continue;
            }
            let mut fall = -q * sums.own_fall[k];
            let mut by_pressure = -sums.own_fall_q[k];
            for side in 0..2 {
                let [less, at] = integrals[side][1];
                fall += q * a * less;
                by_pressure += a * (2.0 * less - sigma[side] * at);
            }
            sums.fall[k] += fall;
            let of_wheel = (STATION * a) * (STATION * a) / (2.0 * nodes.radius[i]);
            let excess = sums.fall[k] - of_wheel;
            sums.excess[0][k] = excess;
            // The stations move with the half length; the weights of the equations of the fall are pressures over it.
            let by_station = sums.pulled[k] - 2.0 * of_wheel;
            let by_station_q = if q > 0.0 { by_station / q } else { 0.0 };
            rows.put_own_fall(targets, k, by_pressure + by_station_q);
            let by_length = q * by_pressure - fall + by_station - excess;
            for (term, polynomial) in rule.legendre[t].into_iter().enumerate() {
                sums.fall_by_shape[term][k] += by_length * polynomial;
            }
            for side in 0..2 {
                let [_, left] = integrals[0][1];
                let [_, right] = integrals[1][1];
                sums.fall_by_edge[side][k] = sums.scaled_fall[k] * stretch[side]
                    + q * (left * away[side][0] + right * away[side][1]);
            }
        }
    }

    /// Residuals of a part.
    fn residuals(&self, part: &LobePart, scratch: &Scratch, rows: &mut Rows, right: &mut [f64]) {
        let nodes = self.nodes;
        let (n, block) = (self.rule.count(), self.unknowns_per_lobe());
        let Lobe { first, cell } = self.lobes[part.lobe];
        for k in 0..part.count {
            let t = self.rule.node_of_target(part.begin + k);
            let (i, equation) = (first + t, part.lobe * block + t);
            right[equation] = -(scratch.sums.u[k] - nodes.overlap[i]) * rows.inverse_depth;
            let finds_edge = [1, n - 2]
                .iter()
                .zip(self.cells[cell].met)
                .any(|(&second, met)| t == second && !met);
            if nodes.ratio[i] <= 0.0 && !finds_edge {
                // An unloaded node may lie apart: its ratio below zero is that distance.
                right[equation] -= nodes.ratio[i] / self.scale;
                rows.newton[self.entry(equation, equation)] += 1.0 / self.scale;
            }
        }
        let shape = part.lobe * block + n + 2;
        let [errors] = weighed(&scratch.targets, &scratch.sums.excess);
        for (right, error) in right[shape..].iter_mut().zip(errors) {
            *right -= error;
        }
    }

    /// Sets an equation to zero.
    fn clear_row(&self, m: &mut Matrices, row: usize) {
        for column in 0..self.lobes.len() * self.unknowns_per_lobe() {
            m.newton[self.entry(row, column)] = 0.0;
        }
        m.right[row] = 0.0;
    }

    /// Closure of the edges, and the regularisation of the shape.
    fn edge_rows(&self, m: &mut Matrices, lobe: usize) {
        let (rule, nodes) = (self.rule, self.nodes);
        let n = rule.count();
        let block = self.unknowns_per_lobe();
        let begin = lobe * block;
        let Lobe { first, cell, .. } = self.lobes[lobe];
        let cell = &self.cells[cell];
        for side in 0..2 {
            let row = begin + n + side;
            let place = |k: usize| if side == 0 { k } else { n - 1 - k };
            let close = |m: &mut Matrices, row: usize, factors: [f64; 4], from_end: [usize; 4]| {
                for (factor, k) in factors.into_iter().zip(from_end) {
                    m.newton[self.entry(row, begin + place(k))] = factor / self.scale;
                    m.right[row] -= factor * nodes.ratio[first + place(k)] / self.scale;
                }
            };
            if cell.met[side] {
                // The outermost node, as good as at the joint, has the pressure of the next one: its own condition would be that of the
                // outermost one on the other side.
                let outermost = begin + place(0);
                self.clear_row(m, outermost);
                close(m, outermost, [1.0, -1.0, 0.0, 0.0], [0, 1, 2, 3]);
            }
            if !cell.met[side] {
                // The outermost node has no condition of its own: both outermost ones follow the smooth ratio of the others, so that
                // the condition of the second one finds the edge.
                let outermost = begin + place(0);
                let [edge, second] = rule.outer_closures;
                close(m, row, edge, [0, 2, 3, 4]);
                self.clear_row(m, outermost);
                close(m, outermost, second, [1, 2, 3, 4]);
            } else if side == 0 {
                // The end of the lobe before.
                let before = &self.cells[self.lobes[lobe - 1].cell];
                let inverse = 1.0 / (cell.edges[1] - before.edges[0]);
                m.newton[self.entry(row, row)] = inverse;
                m.newton[self.entry(row, begin - block + n + 1)] = -inverse;
                m.right[row] = -(cell.edges[0] - before.edges[1]) * inverse;
            } else {
                // At the ridge.
                let beyond = &self.cells[self.lobes[lobe + 1].cell];
                let inverse = 1.0 / (beyond.edges[1] - cell.edges[0]);
                m.newton[self.entry(row, row)] = inverse;
                m.right[row] = -(cell.edges[1] - cell.bounds[1]) * inverse;
            }
        }
        for term in 1..rule.terms {
            let row = begin + n + 2 + term;
            m.newton[self.entry(row, row)] += SHAPE_REGULARISATION;
            m.right[row] -= SHAPE_REGULARISATION * cell.shape[term];
        }
    }
}

/// Some nodes of a lobe: its number and load over π E* [m²], and the nodes.
struct LobePart {
    lobe: usize,
    load: f64,
    begin: usize,
    count: usize,
}

/// Rows of the Newton matrix for a part.
struct Rows<'a> {
    assembly: &'a Assembly<'a>,
    part: &'a LobePart,
    newton: &'a mut [f64],
    /// One over the greatest overlap [1/m].
    inverse_depth: f64,
}

impl Rows<'_> {
    /// What node `k` of a lobe does.
    fn put_node(&mut self, acting: &Acting, lobe: usize, k: usize) {
        let assembly = self.assembly;
        let column = lobe * assembly.unknowns_per_lobe() + k;
        let factor = assembly.ratio_factor(lobe, k);
        self.put(column, factor, &acting.by_pressure);
        self.put_falls(column, factor, &[acting.weighed]);
    }

    /// What the edges and the shape of a lobe do.
    fn put_lobe(&mut self, targets: &Targets, sums: &Sums, lobe: usize) {
        let rule = self.assembly.rule;
        let edges = lobe * self.assembly.unknowns_per_lobe() + rule.count();
        for (side, column) in sums.by_edge.iter().enumerate() {
            self.put(edges + side, 1.0, column);
        }
        for term in 0..rule.terms {
            self.put(edges + 2 + term, -1.0, &sums.by_shape[term]);
        }
        let falls = weighed(targets, &sums.fall_by_shape);
        self.put_falls(edges + 2, -1.0, &falls[..rule.terms]);
    }

    /// Column of the node that is target `k` of the lobe, and the derivative of its pressure.
    fn own_column(&self, k: usize) -> (usize, f64) {
        let (assembly, lobe) = (self.assembly, self.part.lobe);
        let t = assembly.rule.node_of_target(k);
        (lobe * assembly.unknowns_per_lobe() + t, assembly.ratio_factor(lobe, t))
    }

    /// What target `k` of the lobe does to its displacement.
    fn put_own(&mut self, k: usize, by_pressure: f64) {
        let (column, factor) = self.own_column(k);
        self.newton[self.assembly.entry(column, column)] +=
            factor * by_pressure * self.inverse_depth;
    }

    /// What target `k` of the part does to its fall.
    fn put_own_fall(&mut self, targets: &Targets, k: usize, by_pressure: f64) {
        let (column, factor) = self.own_column(self.part.begin + k);
        let falls = targets.weights.each_ref().map(|weights| weights[k] * by_pressure);
        self.put_falls(column, factor, &[falls]);
    }

    /// Puts a derivative of the displacements.
    fn put(&mut self, column: usize, factor: f64, values: &Column) {
        let assembly = self.assembly;
        let row = self.part.lobe * assembly.unknowns_per_lobe() + self.part.begin;
        let at = assembly.entry(row, column);
        let factor = factor * self.inverse_depth;
        let outer = assembly.rule.outer;
        let (last, first) = self.newton[at..at + self.part.count].split_at_mut(outer);
        let (inner, values) = values.split_at(self.part.count - outer);
        for (entry, value) in first.iter_mut().zip(inner).chain(last.iter_mut().zip(values)) {
            *entry = factor * value;
        }
    }

    /// Adds derivatives of the falls by the unknowns from `column` on, weighed, to the conditions of the lobe.
    fn put_falls(&mut self, column: usize, factor: f64, falls: &[[f64; TERMS]]) {
        let assembly = self.assembly;
        let row = self.part.lobe * assembly.unknowns_per_lobe() + assembly.rule.count() + 2;
        for (k, values) in falls.iter().enumerate() {
            let at = assembly.entry(row, column + k);
            for (entry, value) in self.newton[at..at + assembly.rule.terms].iter_mut().zip(values) {
                *entry += factor * value;
            }
        }
    }
}
