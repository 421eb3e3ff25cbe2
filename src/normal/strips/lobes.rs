//! Lobes: which cells begin with one, their first guess, and their nodes.

use std::f64::consts::PI;

use super::cell::{self, Joint, TERMS};
use super::nodes::Lobe;
use super::solver::{MOST_LOBES, Start, StripSolver};
use super::{Line, LinePlace};
use crate::geometry::separation::Probe;
use crate::math::root::bracketed;
use crate::normal::hertz;

/// Overlap, over the deepest, from which a cell has a lobe from the start.
const FIRST_LOBES: f64 = 0.4;
/// Share of the approach that several lobes leave each other.
const SHARED: f64 = 0.75;

/// Slope of the overlap, over that between two probes, up to which a probe is the ridge itself, and share of their distance to which one is found.
const LEVEL: f64 = 1e-6;
const AT_RIDGE: f64 = 1e-9;

/// Parameter of the ridge near the probe at `u`, between those beside it: a joint that goes from probe to probe would make the force jump.
fn ridge(line: &mut (impl Line + ?Sized), u: f64, [before, after]: [f64; 2]) -> f64 {
    let mut slope = |u: f64| line.place(u).overlap_slope;
    let [left, here, right] = [slope(before), slope(u), slope(after)];
    if here.abs() <= LEVEL * (right - left) || !(left < 0.0 && right > 0.0) {
        return u;
    }
    let tolerance = AT_RIDGE * (after - before);
    if here < 0.0 {
        bracketed((u, here), (after, right), tolerance, slope)
    } else {
        bracketed((before, left), (u, here), tolerance, slope)
    }
}

impl StripSolver {
    /// Starts a lobe in the deepest cells; the others follow where they still overlap then.
    pub(super) fn begin(&mut self, line: &mut impl Line, overlap: (&[Probe], f64), start: Start) {
        self.bound_cells(line);
        let most = self.cells.iter().map(|c| c.deepest[1]).fold(0.0, f64::max);
        let first = self.cells.iter().filter(|c| c.deepest[1] > FIRST_LOBES * most).count();
        let approach = if first > 1 { SHARED * start.approach } else { start.approach };
        for i in 0..self.cells.len() {
            let depth = self.cells[i].deepest[1];
            if depth > FIRST_LOBES * most || self.cells[i].is_on_shoulder() {
                self.start_lobe(line, overlap, i, approach * depth);
            }
        }
        self.gather();
    }

    /// Coordinates of the cells and of their intervals of overlap; no lobes yet.
    pub(super) fn bound_cells(&mut self, line: &mut impl Line) {
        self.lobes.clear();
        for i in 1..self.cells.len() {
            let before = self.cells[i - 1];
            if let Some(within) = before.ridge {
                let ridge = ridge(line, before.range[1], within);
                (self.cells[i - 1].range[1], self.cells[i].range[0]) = (ridge, ridge);
            }
        }
        for cell in self.cells.iter_mut() {
            cell.bounds = cell.range.map(|u| line.place(u).y);
        }
        let mut begin = 0;
        for i in 0..self.cells.len() {
            if self.cells[i].joined && i + 1 < self.cells.len() {
                continue;
            }
            let reach = [self.cells[begin].bounds[0], self.cells[i].bounds[1]];
            for cell in &mut self.cells[begin..=i] {
                cell.reach = reach;
            }
            begin = i + 1;
        }
    }

    /// A first guess for the lobe of cell `i` from the ellipse of the approach `depth` [m] at its deepest place.
    pub(super) fn start_lobe(
        &mut self,
        line: &mut impl Line,
        (probes, level): (&[Probe], f64),
        i: usize,
        depth: f64,
    ) {
        if self.cells.iter().filter(|c| c.active).count() >= MOST_LOBES {
            return;
        }
        let cell = &mut self.cells[i];
        let place = line.place(cell.deepest[0]);
        let radius = line.radius(cell.deepest[0]);
        let mut overlap = |u: f64| line.place(u).overlap;
        let half = cell::places(probes, level, cell, 0.5, &mut overlap);
        let width = (half[1] - half[0]) * place.dy;
        let along = 0.5 / radius;
        // Curvature of the parabola as wide at half of the depth; what is shallower is narrower.
        let across = (2.0 * cell.deepest[1] / (width * width)).clamp(1e-4 * along, 1e6 * along);
        let ellipse = hertz::ellipse(along, across, depth, 1.0);
        // The ellipse ends where the separation has used up this share of the approach.
        let used = (across * ellipse.semi_axis_across * ellipse.semi_axis_across / depth).min(0.95);
        let left = (1.0 - used * depth / cell.deepest[1]).clamp(0.05, 0.999_999);
        let places = cell::places(probes, level, cell, left, &mut overlap);
        cell.near = [
            places[0].min(cell.deepest[0]).max(cell.range[0]),
            places[1].max(cell.deepest[0]).min(cell.range[1]),
        ];
        cell.edges = cell.near.map(|u| line.place(u).y);
        cell.start_level = left * cell.deepest[1];
        cell.active = true;
        cell.met = [false; 2];
        cell.joint = Joint::Untried;
        cell.start_width = cell.edges[1] - cell.edges[0];
        cell.shape = [0.0; TERMS];
        // q/(π E*) = a e^κ0/(2 π R)
        let greatest = ellipse.max_pressure / PI;
        cell.shape[0] = (greatest * 2.0 * PI * radius / ellipse.semi_axis_along).ln();
        cell.start_ratio = greatest;
        cell.begun_with = greatest;
    }

    /// Lays the nodes of all active cells out anew; ratios of lobes that stay are kept.
    pub(super) fn gather(&mut self) {
        let n = self.rule.count();
        let mut kept = std::mem::take(&mut self.nodes.spare);
        kept.clear();
        for i in 0..self.cells.len() {
            if !self.cells[i].active {
                continue;
            }
            let old = self.lobes.iter().find(|l| l.cell == i && self.cells[i].start_ratio <= 0.0);
            match old {
                Some(old) => {
                    kept.extend_from_slice(&self.nodes.ratio[old.first..old.first + n]);
                }
                None => {
                    kept.extend(std::iter::repeat_n(f64::NAN, n));
                }
            }
        }
        self.lobes.clear();
        for i in 0..self.cells.len() {
            if self.cells[i].active {
                let first = self.lobes.len() * n;
                self.lobes.push(Lobe { cell: i, first });
            }
        }
        std::mem::swap(&mut self.nodes.ratio, &mut kept);
        self.nodes.spare = kept;
        self.nodes.u.clear();
        self.nodes.u.resize(self.lobes.len() * n, f64::NAN);
        self.nodes.resize(self.lobes.len() * n);
    }

    /// Geometry and pressure at all nodes for the present unknowns; whether any strips are shifted against each other.
    pub(super) fn place_nodes(&mut self, line: &mut impl Line) -> bool {
        let n = self.rule.count();
        let mut skewed = false;
        for number in 0..self.lobes.len() {
            let Lobe { cell, first, .. } = self.lobes[number];
            let cell = self.cells[cell];
            let [left, right] = cell.edges;
            let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
            let nodes = &mut self.nodes;
            for t in 0..n {
                let (i, abscissa) = (first + t, self.rule.nodes[t]);
                let y = middle + half * abscissa;
                let near = if !nodes.u[i].is_nan() {
                    nodes.u[i] + (y - nodes.y[i]) * nodes.rate[i]
                } else if t == 0 {
                    0.5 * (cell.near[0] + cell.near[1] + abscissa * (cell.near[1] - cell.near[0]))
                } else {
                    // On from the node before, with the change of the rate between the two before.
                    let (k, step) = (i - 1, y - nodes.y[i - 1]);
                    let before = if t == 1 { k } else { k - 1 };
                    let trend = if t == 1 {
                        0.0
                    } else {
                        (nodes.rate[k] - nodes.rate[before]) / (nodes.y[k] - nodes.y[before])
                    };
                    nodes.u[k] + step * (nodes.rate[k] + 0.5 * step * trend)
                };
                let LinePlace { u, dy, overlap, overlap_slope, x, tangent, .. } =
                    line.across(y, near);
                let radius = line.radius(u);
                nodes.u[i] = u;
                nodes.rate[i] = 1.0 / dy;
                nodes.y[i] = y;
                nodes.x[i] = x;
                nodes.tangent[i] = tangent;
                nodes.overlap[i] = overlap;
                nodes.overlap_slope[i] = overlap_slope / dy;
                nodes.radius[i] = radius;
                nodes.width[i] = half * self.rule.weights[t];
                nodes.lobe[i] = number;
                let shape =
                    |side: usize| if cell.met[side] { 1.0 } else { self.rule.roots[t][side] };
                nodes.edge_shape[i] = shape(0) * shape(1);
                if cell.start_ratio > 0.0 {
                    let span = cell.deepest[1] - cell.start_level;
                    let share = ((overlap - cell.start_level) / span).clamp(0.01, 1.0);
                    nodes.ratio[i] =
                        cell.start_ratio * share.sqrt() / nodes.edge_shape[i].max(0.05);
                }
                let exponent: f64 =
                    cell.shape.iter().zip(self.rule.legendre[t]).map(|(s, p)| s * p).sum();
                nodes.pressure[i] = nodes.ratio[i].max(0.0) * nodes.edge_shape[i];
                let per_pressure = 2.0 * PI * radius * (-exponent).exp();
                nodes.half_length[i] = (nodes.pressure[i] * per_pressure).max(1e-12 * half);
                skewed |= (x - nodes.x[0]).abs() > 0.0;
            }
            self.cells[self.lobes[number].cell].start_ratio = 0.0;
            let nodes = &mut self.nodes;
            for i in first..first + n {
                let (a, b) = (i.max(first + 1) - 1, (i + 1).min(first + n - 1));
                nodes.x_slope[i] = (nodes.x[b] - nodes.x[a]) / (nodes.y[b] - nodes.y[a]);
            }
        }
        skewed
    }
}
