//! Where strips that stay where they are lie: evenly at first, then finer towards the ends of the load that these have.

use std::f64::consts::PI;

use super::Line;
use super::cell::{self, Cell, TERMS};
use super::nodes::Nodes;
use super::rule::legendre;
use super::solver::{MOST_LOBES, StripSolver};
use crate::geometry::separation::Probe;

/// Overlap over the deepest of its interval where the strips begin.
const BEGIN: f64 = 0.02;
/// Distance of two strips with which strips go on beyond the end of a load.
const MARGIN: f64 = 0.5;
/// Pressure between two peaks, over the lower of them, below which they are two stretches.
const VALLEY: f64 = 0.6;

/// A stretch of loaded strips with one greatest pressure: its strips, and where it begins and ends [m].
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Piece {
    pub strips: [usize; 2],
    pub ends: [f64; 2],
}

impl Nodes {
    /// Whether strip `i` lies beside the one before.
    pub(super) fn follows(&self, i: usize) -> bool {
        let apart = self.y[i] - self.y[i - 1] - 0.5 * (self.width[i] + self.width[i - 1]);
        apart < 0.5 * self.width[i]
    }
}

impl StripSolver {
    /// Strips of all intervals with their geometry and a first guess of their pressure.
    pub(super) fn lay_strips(&mut self, line: &mut impl Line, probes: &[Probe], level: f64) {
        let n = self.rule.count();
        let capacity = self.nodes.y.capacity().min(self.matrices.nodes());
        self.nodes.resize(0);
        self.nodes.u.clear();
        let mut begin = 0;
        while begin < self.cells.len() {
            let mut end = begin + 1;
            while end < self.cells.len() && self.cells[end - 1].joined {
                end += 1;
            }
            let mut overlap = |u: f64| line.place(u).overlap;
            let (first, last) = (self.cells[begin], self.cells[end - 1]);
            let from = cell::places(probes, level, &first, BEGIN, &mut overlap)[0];
            let to = cell::places(probes, level, &last, BEGIN, &mut overlap)[1];
            let [left, right] = [from, to].map(|u| line.place(u).y);
            let old = self.nodes.y.len();
            let count = (n * (end - begin + 1)).min(capacity - old);
            let width = (right - left) / count.max(1) as f64;
            self.nodes.resize(old + count);
            self.nodes.u.resize(old + count, from);
            let mut near = from;
            for i in old..old + count {
                let y = left + (0.5 + (i - old) as f64) * width;
                let place = line.across(y, near);
                near = place.u + width / place.dy;
                let inner = &self.cells[begin..end];
                let number = inner.iter().position(|c| y < c.bounds[1]).unwrap_or(inner.len() - 1);
                let cell = &self.cells[begin + number];
                let radius = line.radius(place.u);
                let span = cell.deepest[1] - cell.start_level;
                let share = ((place.overlap - cell.start_level) / span).max(0.0);
                let nodes = &mut self.nodes;
                (nodes.u[i], nodes.y[i], nodes.x[i]) = (place.u, y, place.x);
                (nodes.tangent[i], nodes.radius[i]) = (place.tangent, radius);
                (nodes.overlap[i], nodes.width[i]) = (place.overlap, width);
                nodes.pressure[i] = if cell.active { cell.begun_with * share.sqrt() } else { 0.0 };
                nodes.lobe[i] = begin + number;
            }
            begin = end;
        }
        self.lengths();
    }

    /// Lays the strips of a solution anew: as many for each loaded stretch, finer towards its ends; those where nothing is loaded stay.
    /// Pressures and shapes stay what they are.
    pub(super) fn lay_strips_anew(&mut self, line: &mut impl Line) {
        let mut pieces = [Piece::default(); MOST_LOBES];
        let count = self.pieces(&mut pieces, MARGIN);
        let pieces = &pieces[..count];
        let capacity = self.nodes.y.capacity().min(self.matrices.nodes());
        let is_beside = |y: f64| !pieces.iter().any(|p| y >= p.ends[0] && y <= p.ends[1]);
        let beside = self.nodes.y.iter().filter(|y| is_beside(**y)).count();
        let n = self.rule.count();
        // Where there is no room for both those that are loaded are what counts.
        let stay = beside + n * count <= capacity;
        let is_outside = |y: f64| stay && is_beside(y);
        let outside = if stay { beside } else { 0 };
        let strips = (2 * n).min((capacity - outside) / count.max(1));
        let old = self.nodes.y.len();
        // Places and widths, parameters near them, pressures.
        self.apart.nodes.clear();
        self.nodes.spare.clear();
        self.without_ridge.ratio.clear();
        let mut next = 0;
        for i in 0..=old {
            let here = if i < old { self.nodes.y[i] } else { f64::INFINITY };
            while next < count && pieces[next].ends[0] < here {
                let [left, right] = pieces[next].ends;
                let bound = |k: usize| {
                    0.5 * (left + right - (right - left) * (PI * k as f64 / strips as f64).cos())
                };
                for k in 0..strips {
                    let [begin, end] = [bound(k), bound(k + 1)];
                    self.lay(0.5 * (begin + end), end - begin);
                }
                next += 1;
            }
            if i < old && is_outside(here) {
                self.lay(here, self.nodes.width[i]);
            }
        }
        self.shape_pieces(pieces);
        let count = self.apart.nodes.len();
        self.nodes.resize(count);
        self.nodes.u.resize(count, 0.0);
        for i in 0..count {
            let [y, width] = self.apart.nodes[i];
            let place = line.across(y, self.nodes.spare[i]);
            let radius = line.radius(place.u);
            let away = |cell: &Cell| (cell.edges[0] - y).max(y - cell.edges[1]);
            let nearest = (0..self.cells.len())
                .min_by(|&a, &b| away(&self.cells[a]).total_cmp(&away(&self.cells[b])));
            let nodes = &mut self.nodes;
            (nodes.u[i], nodes.y[i], nodes.x[i]) = (place.u, y, place.x);
            (nodes.tangent[i], nodes.radius[i]) = (place.tangent, radius);
            (nodes.overlap[i], nodes.width[i]) = (place.overlap, width);
            nodes.pressure[i] = self.without_ridge.ratio[i];
            nodes.lobe[i] = nearest.unwrap_or(0);
        }
        self.lengths();
    }

    /// Finds the loaded stretches, with ends so much further out, in distances of two strips, cut at valleys of the pressure; their count.
    pub(super) fn pieces(&self, pieces: &mut [Piece; MOST_LOBES], margin: f64) -> usize {
        let nodes = &self.nodes;
        let strips = nodes.y.len();
        let (mut count, mut i) = (0, 0);
        while i < strips {
            if nodes.pressure[i] <= 0.0 {
                i += 1;
                continue;
            }
            let begin = i;
            i += 1;
            while i < strips && nodes.pressure[i] > 0.0 && nodes.follows(i) {
                i += 1;
            }
            let ends = [(begin, begin.wrapping_sub(1)), (i - 1, i)]
                .map(|(last, beyond)| self.load_end(last, beyond, margin));
            let (mut first, mut start) = (begin, ends[0]);
            let mut peak = nodes.pressure[begin];
            let (mut valley, mut low) = (begin, peak);
            for k in begin + 1..i {
                let here = nodes.pressure[k];
                if here < low {
                    (valley, low) = (k, here);
                } else if low < VALLEY * here.min(peak) && count + 1 < MOST_LOBES {
                    pieces[count] =
                        Piece { strips: [first, valley], ends: [start, nodes.y[valley]] };
                    (count, first, start) = (count + 1, valley, nodes.y[valley]);
                    (peak, valley, low) = (here, k, here);
                } else if here > peak {
                    (peak, valley, low) = (here, k, here);
                }
            }
            if count < MOST_LOBES {
                pieces[count] = Piece { strips: [first, i - 1], ends: [start, ends[1]] };
                count += 1;
            }
        }
        for k in 1..count {
            if pieces[k].ends[0] < pieces[k - 1].ends[1] {
                let middle = 0.5 * (pieces[k].ends[0] + pieces[k - 1].ends[1]);
                (pieces[k].ends[0], pieces[k - 1].ends[1]) = (middle, middle);
            }
        }
        count
    }

    /// Where the strips of a load that ends at strip `last` are to end: a little beyond where the square of its pressure, extrapolated, vanishes
    /// before strip `beyond`.
    fn load_end(&self, last: usize, beyond: usize, margin: f64) -> f64 {
        let nodes = &self.nodes;
        let [y, square] = [nodes.y[last], nodes.pressure[last].powi(2)];
        let outwards = if beyond == last + 1 { 1.0 } else { -1.0 };
        let neighbour = nodes.y.get(beyond).filter(|_| nodes.follows(last.max(beyond)));
        let spacing = neighbour.map_or(0.5 * nodes.width[last], |beyond| (beyond - y).abs());
        let inner = last.wrapping_add_signed(if beyond == last + 1 { -1 } else { 1 });
        let way = match nodes.y.get(inner) {
            Some(before) if nodes.pressure[inner].powi(2) > square => {
                let fall = (nodes.pressure[inner].powi(2) - square) / (y - before).abs();
                (square / fall).min(spacing)
            }
            _ => spacing,
        };
        let margin = if neighbour.is_some() { margin * spacing } else { 0.0 };
        y + outwards * (way + margin)
    }

    /// Notes a new strip, with what the present strips have there.
    fn lay(&mut self, y: f64, width: f64) {
        let nodes = &self.nodes;
        let after = nodes.y.partition_point(|&at| at < y).clamp(1, nodes.y.len().max(2) - 1);
        let (a, b) = (after - 1, after.min(nodes.y.len() - 1));
        let share = if b > a { (y - nodes.y[a]) / (nodes.y[b] - nodes.y[a]) } else { 0.0 };
        let inner = share.clamp(0.0, 1.0);
        let square = |i: usize| nodes.pressure[i].powi(2);
        let pressure = (square(a) + inner * (square(b) - square(a))).sqrt();
        let u = nodes.u[a] + share * (nodes.u[b] - nodes.u[a]);
        self.apart.nodes.push([y, width]);
        self.nodes.spare.push(u);
        self.without_ridge.ratio.push(pressure);
    }

    /// Makes every piece a cell with the shape that its strips have.
    pub(super) fn shape_pieces(&mut self, pieces: &[Piece]) {
        self.cells.clear();
        for &Piece { strips: [first, last], ends: edges } in pieces {
            let mut shape = [0.0; TERMS];
            for (abscissa, weight) in self.rule.nodes.iter().zip(&self.rule.weights) {
                let y = 0.5 * (edges[0] + edges[1] + (edges[1] - edges[0]) * abscissa);
                let nodes = &self.nodes;
                let exponent = |i: usize| (2.0 * PI * nodes.radius[i] / nodes.edge_shape[i]).ln();
                let after = first + nodes.y[first..=last].partition_point(|&at| at < y);
                let (a, b) = (after.max(first + 1) - 1, after.min(last));
                let share = if b > a { (y - nodes.y[a]) / (nodes.y[b] - nodes.y[a]) } else { 0.0 };
                let value = exponent(a) + share.clamp(0.0, 1.0) * (exponent(b) - exponent(a));
                for (degree, (term, p)) in shape.iter_mut().zip(legendre(*abscissa)).enumerate() {
                    *term += (degree as f64 + 0.5) * weight * value * p;
                }
            }
            self.cells.push(Cell { edges, shape, ..Cell::default() });
        }
    }
}
