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
//! The curvature along x follows in the same way with D/(a² + Δy²) for D.

use std::ops::Range;

use multiversion::multiversion;

use super::cell::{Cell, TERMS};
use super::influence::{Integrals, skewed, straight};
use super::nodes::{LANES, Lobe, Matrices, Nodes};
use super::pair_sums::{self, Point, Sources};
use super::rule::LobeRule;

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

    /// Influence of all nodes on all nodes.
    pub fn influences(&self, m: &mut Matrices) {
        let nodes = self.nodes;
        let count = nodes.y.len();
        let padded = count.next_multiple_of(LANES);
        let Matrices { d, slope, own_d, own_slope, padded: columns, .. } = m;
        let [y, x, a, own, near, row_d, row_slope] = columns;
        for (to, from) in [(&mut *y, &nodes.y), (x, &nodes.x), (a, &nodes.half_length)] {
            to[..count].copy_from_slice(from);
            to[count..padded].fill(from[count - 1]);
        }
        let (y, x, a) = (&y[..padded], &x[..padded], &a[..padded]);
        let (row_d, row_slope) = (&mut row_d[..padded], &mut row_slope[..padded]);
        for i in 0..count {
            let row = i * count..(i + 1) * count;
            if self.skewed {
                skewed([nodes.x[i], nodes.y[i]], x, y, a, row_d, row_slope);
            } else {
                straight(nodes.y[i], y, a, row_d, row_slope);
            }
            d[row.clone()].copy_from_slice(&row_d[..count]);
            slope[row].copy_from_slice(&row_slope[..count]);
        }
        if !self.skewed {
            for i in 0..count {
                for j in 0..count {
                    own_d[i * count + j] = d[j * count + i];
                    own_slope[i * count + j] = slope[j * count + i];
                }
            }
            return;
        }
        // Only those of the own lobe are asked for.
        let n = self.rule.count();
        let padded = n.next_multiple_of(LANES);
        for lobe in self.lobes {
            let range = lobe.first..lobe.first + n;
            let near = &mut near[..padded];
            near[..n].copy_from_slice(&nodes.y[range.clone()]);
            near[n..].fill(nodes.y[range.end - 1]);
            for i in range.clone() {
                let own = &mut own[..padded];
                own.fill(nodes.half_length[i]);
                let (row_d, row_slope) = (&mut row_d[..padded], &mut row_slope[..padded]);
                straight(nodes.y[i], near, own, row_d, row_slope);
                let row = i * count + range.start..i * count + range.end;
                own_d[row.clone()].copy_from_slice(&row_d[..n]);
                own_slope[row].copy_from_slice(&row_slope[..n]);
            }
        }
    }

    /// Fills the Newton matrix and its right side (minus the residuals).
    pub fn assemble(&self, m: &mut Matrices) {
        assemble(self, m);
    }

    /// Equation of one node and its share of the curvature equations of its lobe.
    // One formula and its derivatives, term by term; inside each instruction set or not at all: a call would not be vectorised.
    #[allow(clippy::too_many_lines, clippy::inline_always)]
    #[inline(always)]
    fn node_row(&self, m: &mut Matrices, unknowns: usize, lobe: usize, t: usize) {
        let (nodes, rule) = (self.nodes, self.rule);
        let (n, count) = (rule.count(), nodes.y.len());
        let Lobe { first, cell } = self.lobes[lobe];
        let edge_y = self.cells[cell].edges;
        let i = first + t;
        let pairs = i * count..(i + 1) * count;
        let (d, slope) = (&m.d[pairs.clone()], &m.slope[pairs.clone()]);
        let (own_d, own_slope) = (&m.own_d[pairs.clone()], &m.own_slope[pairs]);
        let (y, x, q_i, a_i) = (nodes.y[i], nodes.x[i], nodes.pressure[i], nodes.half_length[i]);
        let at = Point { y, x, tangent: nodes.tangent[i], pressure: q_i, own_length: a_i };
        let sources = |range: Range<usize>| Sources {
            y: &nodes.y[range.clone()],
            x: &nodes.x[range.clone()],
            tangent: &nodes.tangent[range.clone()],
            width: &nodes.width[range.clone()],
            pressure: &nodes.pressure[range.clone()],
            half_length: &nodes.half_length[range.clone()],
            d: &d[range.clone()],
            slope: &slope[range],
        };
        // All strips but the node's own.
        pair_sums::pairs(&at, &sources(0..count), &mut m.pairs);
        for column in &mut m.pairs {
            column[i] = 0.0;
        }
        let sum = |column: &[f64]| column.iter().sum::<f64>();
        let mut u = sum(&m.pairs[0][..count]);
        let mut curvature = sum(&m.pairs[1][..count]);
        // Singularity of its own lobe: taken out of the sum, integrated instead; derivatives by the scale of the lobe.
        let half = 0.5 * (self.cells[cell].edges[1] - self.cells[cell].edges[0]);
        let corrections = &rule.corrections[t * n..(t + 1) * n];
        for (weight, correction) in m.logarithm.iter_mut().zip(corrections) {
            *weight = -2.0 * correction * half;
        }
        let range = first..first + n;
        let (near_d, near_slope) = (&own_d[range.clone()], &own_slope[range.clone()]);
        pair_sums::own(&at, &sources(range), near_d, near_slope, &m.logarithm, &mut m.own);
        for column in &mut m.own {
            column[t] = 0.0;
        }
        let own: [f64; 8] = std::array::from_fn(|k| sum(&m.own[k][..n]));
        let [own_u, own_q, own_a, own_x, own_xq, own_xa, scaled_u, scaled_x] = own;
        // The logarithm of the pairs.
        for k in 0..n {
            let j = first + k;
            let a2 = nodes.half_length[j] * nodes.half_length[j];
            let share = a2 / (a2 + (y - nodes.y[j]) * (y - nodes.y[j]));
            let weight = if k == t { 0.0 } else { m.logarithm[k] * nodes.pressure[j] * share };
            u += weight;
            curvature += weight * share / a2;
        }
        let [_, _, row_q, row_a, row_xq, row_xa] = &mut m.pairs;
        for k in 0..n {
            row_q[first + k] += m.own[8][k];
            row_a[first + k] += m.own[9][k];
            row_xq[first + k] += m.own[10][k];
            row_xa[first + k] += m.own[11][k];
        }
        u -= q_i * own_u;
        curvature -= q_i * own_x;
        row_q[i] -= own_q;
        row_a[i] -= q_i * own_a;
        row_xq[i] -= own_xq;
        row_xa[i] -= q_i * own_xa;
        let mut edge_slope = [0.0; 2];
        let mut edge_slope_x = [0.0; 2];
        for side in 0..2 {
            let reach = (edge_y[side] - y).abs();
            let sigma = reach / a_i;
            let [psi, weighted, at] = self.integrals.at(sigma);
            u += q_i * a_i * psi;
            row_q[i] += a_i * (2.0 * psi - sigma * at);
            row_a[i] += q_i * a_i * (psi - sigma * at);
            edge_slope[side] = q_i * at;
            let inverse = 1.0 / a_i;
            let falling = sigma * at / (1.0 + sigma * sigma);
            curvature += q_i * inverse * weighted;
            row_xq[i] -= inverse * falling;
            row_xa[i] -= q_i * inverse * (weighted + falling);
            edge_slope_x[side] = q_i * at / ((1.0 + sigma * sigma) * a_i * a_i);
        }
        let load: f64 = (first..first + n)
            .map(|j| nodes.width[j] * nodes.pressure[j] * nodes.half_length[j])
            .sum();
        // Into the system.
        let block = self.unknowns_per_lobe();
        let loaded = nodes.ratio[i] > 0.0;
        let equation = lobe * block + t;
        let inverse_depth = 1.0 / self.depth;
        let radius = nodes.radius[i];
        let share = if loaded { nodes.width[i] * q_i * a_i / load } else { 0.0 };
        let error = radius * curvature - 1.0;
        m.right[equation] = -(u - nodes.overlap[i]) * inverse_depth;
        let finds_edge =
            [1, n - 2].iter().zip(self.cells[cell].met).any(|(&second, met)| t == second && !met);
        if !loaded && !finds_edge {
            // An unloaded node may lie apart: its ratio below zero is that distance.
            m.right[equation] -= nodes.ratio[i] / self.scale;
            m.newton[equation * unknowns + equation] += 1.0 / self.scale;
        }
        for term in 0..rule.terms {
            let row = lobe * block + n + 2 + term;
            let weight = share * rule.legendre[term][t];
            m.right[row] -= weight * error;
            // The weight is a load, q a.
            if loaded {
                m.newton[row * unknowns + equation] += weight * error * 2.0 / nodes.ratio[i];
                for l in 0..rule.terms {
                    m.newton[row * unknowns + lobe * block + n + 2 + l] -=
                        weight * error * rule.legendre[l][t];
                }
            }
        }
        let weights: [f64; TERMS] =
            std::array::from_fn(|l| rule.legendre.get(l).map_or(0.0, |p| share * p[t] * radius));
        let Matrices { newton, pairs, own, .. } = m;
        let [_, _, row_q, row_a, row_xq, row_xa] = pairs;
        let [moved_q, moved_x, ..] = own;
        let (moved_q, moved_x) = (&mut moved_q[..n], &mut moved_x[..n]);
        for (other, source) in self.lobes.iter().enumerate() {
            let column = other * block;
            let range = source.first..source.first + n;
            // What is not loaded does not act.
            for (k, j) in range.clone().enumerate() {
                let factor = if nodes.ratio[j] > 0.0 { nodes.edge_shape[j] } else { 0.0 };
                moved_q[k] = row_q[j] * factor * inverse_depth;
                moved_x[k] = row_xq[j] * factor;
            }
            let at = equation * unknowns + column;
            for (entry, value) in newton[at..at + n].iter_mut().zip(moved_q.iter()) {
                *entry += value;
            }
            for (term, weight) in weights.iter().enumerate().take(rule.terms) {
                let at = (lobe * block + n + 2 + term) * unknowns + column;
                for (entry, value) in newton[at..at + n].iter_mut().zip(moved_x.iter()) {
                    *entry += weight * value;
                }
            }
            for (term, polynomial) in rule.legendre.iter().enumerate() {
                let dot = |row: &[f64]| -> f64 {
                    row[range.clone()].iter().zip(polynomial).map(|(a, p)| a * p).sum()
                };
                let (by_u, by_x) = (dot(row_a), dot(row_xa));
                let at = column + n + 2 + term;
                newton[equation * unknowns + at] -= by_u * inverse_depth;
                for (l, weight) in weights.iter().enumerate().take(rule.terms) {
                    newton[(lobe * block + n + 2 + l) * unknowns + at] -= weight * by_x;
                }
            }
            // Edges of that lobe.
            let half = 0.5 * (self.cells[source.cell].edges[1] - self.cells[source.cell].edges[0]);
            for side in 0..2 {
                let stretch = if side == 1 { 0.5 / half } else { -0.5 / half };
                let (mut by_u, mut by_x) = (0.0, 0.0);
                if other == lobe {
                    by_u += scaled_u * stretch;
                    by_x += scaled_x * stretch;
                    let moved = rule.travel[side][t];
                    by_u += edge_slope[0] * (moved - if side == 0 { 1.0 } else { 0.0 });
                    by_u += edge_slope[1] * (if side == 1 { 1.0 } else { 0.0 } - moved);
                    by_x += edge_slope_x[0] * (moved - if side == 0 { 1.0 } else { 0.0 });
                    by_x += edge_slope_x[1] * (if side == 1 { 1.0 } else { 0.0 } - moved);
                    by_u -= nodes.overlap_slope[i] * rule.travel[side][t];
                    // Sources elsewhere are passed.
                    for j in (0..count).filter(|&j| nodes.lobe[j] != lobe) {
                        let dy = y - nodes.y[j];
                        let steep = nodes.width[j] * nodes.pressure[j] * (d[j] - slope[j]);
                        let dx = x - nodes.x[j];
                        let apart = dy + dx * nodes.x_slope[i];
                        by_u += steep * moved * apart / (dy * dy + dx * dx);
                    }
                } else {
                    for k in 0..n {
                        let j = source.first + k;
                        let dy = y - nodes.y[j];
                        let load = nodes.width[j] * nodes.pressure[j];
                        let moved = rule.travel[side][k];
                        by_u += load * d[j] * stretch;
                        let dx = x - nodes.x[j];
                        let apart = dy + dx * nodes.x_slope[j];
                        by_u -= load * (d[j] - slope[j]) * moved * apart / (dy * dy + dx * dx);
                    }
                }
                let at = column + n + side;
                newton[equation * unknowns + at] += by_u * inverse_depth;
                for l in 0..rule.terms {
                    let row = lobe * block + n + 2 + l;
                    newton[row * unknowns + at] += share * rule.legendre[l][t] * radius * by_x;
                }
            }
        }
    }

    /// Closure of the edges, and the regularisation of the shape.
    fn edge_rows(&self, m: &mut Matrices, unknowns: usize, lobe: usize) {
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
                    m.newton[row * unknowns + begin + place(k)] = factor / self.scale;
                    m.right[row] -= factor * nodes.ratio[first + place(k)] / self.scale;
                }
            };
            if cell.met[side] {
                // The outermost node, as good as at the joint, has the pressure of the next one: its own condition would be that of the
                // outermost one on the other side.
                let outermost = begin + place(0);
                m.newton[outermost * unknowns..(outermost + 1) * unknowns].fill(0.0);
                m.right[outermost] = 0.0;
                close(m, outermost, [1.0, -1.0, 0.0, 0.0], [0, 1, 2, 3]);
            }
            if !cell.met[side] {
                // The outermost node has no condition of its own: both outermost ones follow the smooth ratio of the others, so that
                // the condition of the second one finds the edge.
                let outermost = begin + place(0);
                let [edge, second] = rule.outer_closures;
                close(m, row, edge, [0, 2, 3, 4]);
                m.newton[outermost * unknowns..(outermost + 1) * unknowns].fill(0.0);
                m.right[outermost] = 0.0;
                close(m, outermost, second, [1, 2, 3, 4]);
            } else if side == 0 {
                // The end of the lobe before.
                let before = &self.cells[self.lobes[lobe - 1].cell];
                let inverse = 1.0 / (cell.edges[1] - before.edges[0]);
                m.newton[row * unknowns + row] = inverse;
                m.newton[row * unknowns + begin - block + n + 1] = -inverse;
                m.right[row] = -(cell.edges[0] - before.edges[1]) * inverse;
            } else {
                // At the ridge.
                let beyond = &self.cells[self.lobes[lobe + 1].cell];
                let inverse = 1.0 / (beyond.edges[1] - cell.edges[0]);
                m.newton[row * unknowns + row] = inverse;
                m.right[row] = -(cell.edges[1] - cell.bounds[1]) * inverse;
            }
        }
        for term in 1..rule.terms {
            let row = begin + n + 2 + term;
            m.newton[row * unknowns + row] += SHAPE_REGULARISATION;
            m.right[row] -= SHAPE_REGULARISATION * cell.shape[term];
        }
    }
}

/// See [`Assembly::assemble`].
#[multiversion(targets("x86_64+avx512f+avx512dq", "x86_64+avx2", "aarch64+neon"))]
fn assemble(assembly: &Assembly, m: &mut Matrices) {
    let unknowns = assembly.lobes.len() * assembly.unknowns_per_lobe();
    m.newton[..unknowns * unknowns].fill(0.0);
    m.right[..unknowns].fill(0.0);
    let n = assembly.rule.count();
    for lobe in 0..assembly.lobes.len() {
        for t in 0..n {
            assembly.node_row(m, unknowns, lobe, t);
        }
        assembly.edge_rows(m, unknowns, lobe);
    }
}
