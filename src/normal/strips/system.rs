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

use super::cell::Cell;
use super::influence::{Integrals, STATION};
use super::nodes::{Lobe, Matrices, Nodes, Scratch};
use super::pair_sums::{
    Acting, Column, LANES, MOST_TARGETS, Source, Sums, Targets, from_elsewhere, weighed,
    within_lobe,
};
use super::rule::LobeRule;
use crate::math::linear_system::stride;

/// Regularisation of the shape terms beyond the first: what the equations hardly determine stays small.
pub const SHAPE_REGULARISATION: f64 = 1e-5;

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
                    rows.put_node(targets, acting, number, k);
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
            let own = k.wrapping_sub(part.begin);
            if own < part.count {
                targets.other[own] = 0.0;
            }
            within_lobe(&self.source(lobe, k), self.skewed, targets, logarithm, acting, sums);
            if own < part.count {
                targets.other[own] = 1.0;
            }
            rows.put_node(targets, acting, part.lobe, k);
        }
        self.singular(part, targets, sums, &mut rows);
        rows.put_lobe(targets, sums, part.lobe);
        for side in 0..2 {
            rows.put_fall(targets, part.lobe * block + n + side, 1.0, &sums.fall_by_edge[side]);
        }
        self.residuals(part, scratch, &mut rows, right);
    }

    /// Takes the nodes of a part as targets.
    fn fill(&self, part: &LobePart, targets: &mut Targets) {
        let (nodes, rule) = (self.nodes, self.rule);
        let first = self.lobes[part.lobe].first + part.begin;
        targets.vectors = part.count.div_ceil(LANES);
        targets.fall_vectors = targets.vectors;
        for k in 0..LANES * targets.vectors {
            let i = first + k.min(part.count - 1);
            targets.y[k] = nodes.y[i];
            targets.x[k] = nodes.x[i];
            targets.x_slope[k] = nodes.x_slope[i];
            targets.tangent[0][k] = nodes.tangent[i][0];
            targets.tangent[1][k] = nodes.tangent[i][1];
            targets.pressure[k] = nodes.pressure[i];
            targets.half_length[k] = nodes.half_length[i];
            targets.inverse_length[k] = 1.0 / nodes.half_length[i];
            targets.other[k] = 1.0;
            // Falls are compared with that of the wheel.
            let distance = STATION * nodes.half_length[i];
            let weight = if k < part.count {
                2.0 * self.share(part, k) * nodes.radius[i] / (distance * distance)
            } else {
                0.0
            };
            let polynomials = rule.legendre[part.begin + k.min(part.count - 1)];
            for (weights, polynomial) in targets.weights.iter_mut().zip(polynomials) {
                weights[k] = weight * polynomial;
            }
        }
    }

    /// Share of target `k` of a part in the load of its lobe, none where it is not loaded.
    fn share(&self, part: &LobePart, k: usize) -> f64 {
        let (nodes, i) = (self.nodes, self.lobes[part.lobe].first + part.begin + k);
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
        let stretch = 1.0 / (edges[1] - edges[0]);
        for k in 0..part.count {
            let t = part.begin + k;
            let i = first + t;
            let (y, q, a) = (nodes.y[i], nodes.pressure[i], nodes.half_length[i]);
            let inverse = targets.inverse_length[k];
            let (mut u, mut fall) = (-q * sums.own_u[k], -q * sums.own_fall[k]);
            let (mut by_pressure, mut fall_by_pressure) = (-sums.own_q[k], -sums.own_fall_q[k]);
            let (mut slope, mut fall_slope) = ([0.0; 2], [0.0; 2]);
            for side in 0..2 {
                let sigma = (edges[side] - y).abs() * inverse;
                let [[psi, at], [less, at_less]] = self.integrals.at(sigma);
                u += q * a * psi;
                by_pressure += a * (2.0 * psi - sigma * at);
                fall += q * a * less;
                fall_by_pressure += a * (2.0 * less - sigma * at_less);
                slope[side] = q * at;
                fall_slope[side] = q * at_less;
            }
            sums.u[k] += u;
            sums.fall[k] += fall;
            let of_wheel = (STATION * a) * (STATION * a) / (2.0 * nodes.radius[i]);
            let excess = sums.fall[k] - of_wheel;
            sums.excess[k] = excess;
            // The stations move with the half length; the weights of the equations of the fall are pressures over it.
            let moved = sums.pulled[k] - 2.0 * of_wheel;
            let moved_q = if q > 0.0 { moved / q } else { 0.0 };
            rows.put_own(targets, k, by_pressure, fall_by_pressure + moved_q);
            let by_length = q * by_pressure - u;
            let fall_by_length = q * fall_by_pressure - fall + moved - excess;
            for (term, polynomial) in rule.legendre[t].into_iter().enumerate() {
                sums.by_shape[term][k] += by_length * polynomial;
                sums.fall_by_shape[term][k] += fall_by_length * polynomial;
            }
            for side in 0..2 {
                let moved = rule.travel[side][t];
                // How far the left and the right edge go away from the node.
                let (away, stretch) = if side == 0 {
                    ([moved - 1.0, -moved], -stretch)
                } else {
                    ([moved, 1.0 - moved], stretch)
                };
                sums.by_edge[side][k] = sums.scaled_u[k] * stretch
                    + slope[0] * away[0]
                    + slope[1] * away[1]
                    + (sums.passed[k] - nodes.overlap_slope[i]) * moved;
                sums.fall_by_edge[side][k] = sums.scaled_fall[k] * stretch
                    + fall_slope[0] * away[0]
                    + fall_slope[1] * away[1];
            }
        }
    }

    /// Residuals of a part.
    fn residuals(&self, part: &LobePart, scratch: &Scratch, rows: &mut Rows, right: &mut [f64]) {
        let nodes = self.nodes;
        let (n, block) = (self.rule.count(), self.unknowns_per_lobe());
        let Lobe { first, cell } = self.lobes[part.lobe];
        for k in 0..part.count {
            let t = part.begin + k;
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
        let errors = weighed(&scratch.targets, &scratch.sums.excess);
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
    fn put_node(&mut self, targets: &Targets, acting: &Acting, lobe: usize, k: usize) {
        let assembly = self.assembly;
        let column = lobe * assembly.unknowns_per_lobe() + k;
        let factor = assembly.ratio_factor(lobe, k);
        self.put(column, factor, &acting.by_pressure);
        self.put_fall(targets, column, factor, &acting.fall_by_pressure);
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
            self.put_fall(targets, edges + 2 + term, -1.0, &sums.fall_by_shape[term]);
        }
    }

    /// What target `k` does to itself.
    fn put_own(&mut self, targets: &Targets, k: usize, by_pressure: f64, fall_by_pressure: f64) {
        let assembly = self.assembly;
        let begin = self.part.lobe * assembly.unknowns_per_lobe();
        let column = begin + self.part.begin + k;
        let factor = assembly.ratio_factor(self.part.lobe, self.part.begin + k);
        self.newton[assembly.entry(column, column)] += factor * by_pressure * self.inverse_depth;
        let at = assembly.entry(begin + assembly.rule.count() + 2, column);
        for (entry, weights) in self.newton[at..].iter_mut().zip(&targets.weights) {
            *entry += weights[k] * factor * fall_by_pressure;
        }
    }

    /// Adds a derivative of the displacements.
    fn put(&mut self, column: usize, factor: f64, values: &Column) {
        let assembly = self.assembly;
        let row = self.part.lobe * assembly.unknowns_per_lobe() + self.part.begin;
        let at = assembly.entry(row, column);
        let factor = factor * self.inverse_depth;
        for (entry, value) in self.newton[at..at + self.part.count].iter_mut().zip(values) {
            *entry = factor * value;
        }
    }

    /// Adds a derivative of the falls to the conditions of the lobe.
    fn put_fall(&mut self, targets: &Targets, column: usize, factor: f64, values: &Column) {
        let assembly = self.assembly;
        let row = self.part.lobe * assembly.unknowns_per_lobe() + assembly.rule.count() + 2;
        let at = assembly.entry(row, column);
        for (entry, value) in self.newton[at..].iter_mut().zip(weighed(targets, values)) {
            *entry += factor * value;
        }
    }
}
