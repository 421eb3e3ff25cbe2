//! Lobes out of strips that stay where they are: cut where these have least pressure, with ends where their load ends.
//!
//! Where no edges are found the overlap mostly has a shoulder, a bulge on its flank without a ridge before it: two lobes of pressure with little or
//! nothing between them, which one lobe does not describe. The strips show where to cut, and are a start next to the solution.

use super::Line;
use super::fixed_layout::Piece;
use super::solver::{MOST_LOBES, MOST_STEPS_IN_ALL, StripSolver};
use crate::geometry::separation::Probe;

impl StripSolver {
    /// Finds lobes from the present solution with strips that stay where they are; false where there are none.
    pub(super) fn find_from_fixed(
        &mut self,
        line: &mut impl Line,
        overlap: (&[Probe], f64),
    ) -> bool {
        self.last_step = self.work.steps + MOST_STEPS_IN_ALL;
        self.begin_from_fixed(line, overlap) && self.settle(line, overlap)
    }

    /// Begins with a lobe for each loaded stretch of the strips; false where one has no width.
    fn begin_from_fixed(&mut self, line: &mut impl Line, (probes, level): (&[Probe], f64)) -> bool {
        let mut pieces = [Piece::default(); MOST_LOBES];
        let count = self.pieces(&mut pieces, 0.0);
        let pieces = &pieces[..count];
        self.without_ridge.ratio.clear();
        self.shape_pieces(pieces);
        for (k, piece) in pieces.iter().enumerate() {
            let [first, last] = piece.strips;
            let [left, right] = piece.ends;
            if right <= left {
                return false;
            }
            let meets = |other: Option<&Piece>, side: usize| {
                other.is_some_and(|o| o.ends[1 - side].to_bits() == piece.ends[side].to_bits())
            };
            let met = [meets(k.checked_sub(1).map(|k| &pieces[k]), 0), meets(pieces.get(k + 1), 1)];
            let mut greatest = 0.0f64;
            for (abscissa, roots) in self.rule.nodes.iter().zip(&self.rule.roots) {
                let pressure =
                    self.pressure_at(piece, 0.5 * (left + right + (right - left) * abscissa));
                let root = |side: usize| if met[side] { 1.0 } else { roots[side] };
                let ratio = pressure / (root(0) * root(1));
                greatest = greatest.max(ratio);
                self.without_ridge.ratio.push(ratio);
            }
            let nodes = &self.nodes;
            let deepest = (first..=last)
                .max_by(|&a, &b| nodes.overlap[a].total_cmp(&nodes.overlap[b]))
                .unwrap_or(first);
            let near = [nodes.u[first], nodes.u[last]];
            let Some(inside) = probes.iter().position(|p| p.u > near[0] && p.f < level) else {
                return false;
            };
            let begin = (0..inside).rev().find(|&i| probes[i].f >= level);
            let end = (inside..probes.len()).find(|&i| probes[i].f >= level);
            let end = end.unwrap_or(probes.len() - 1);
            let begin = begin.unwrap_or(0);
            let joined =
                pieces.get(k + 1).is_some_and(|next| nodes.u[next.strips[0]] < probes[end].u);
            let cut = match pieces.get(k + 1) {
                Some(next) if joined => {
                    let middle = 0.5 * (right + next.ends[0]);
                    line.across(middle, near[1]).u
                }
                _ => probes[end].u,
            };
            let start = match k.checked_sub(1) {
                Some(before) if self.cells[before].joined => self.cells[before].range[1],
                _ => probes[begin].u,
            };
            if start >= cut {
                return false;
            }
            let cell = &mut self.cells[k];
            cell.range = [start, cut];
            cell.joined = joined;
            // The strip at a cut may lie beside it.
            cell.deepest = [nodes.u[deepest].clamp(start, cut), nodes.overlap[deepest]];
            cell.probes = [begin, end];
            (cell.near, cell.start_width) = (near, right - left);
            (cell.met, cell.begun_with) = (met, greatest);
        }
        self.bound_cells(line);
        for cell in self.cells.iter_mut() {
            cell.active = true;
        }
        self.gather();
        self.nodes.ratio.copy_from_slice(&self.without_ridge.ratio);
        self.caution = 1.0;
        count > 0
    }

    /// Pressure over π E* at `y` of the strips of a piece: its square goes straight from strip to strip, to zero at ends that are no joint.
    fn pressure_at(&self, piece: &Piece, y: f64) -> f64 {
        let [first, last] = piece.strips;
        let nodes = &self.nodes;
        let after = first + nodes.y[first..=last].partition_point(|&at| at < y);
        let square = |i: usize| nodes.pressure[i].powi(2);
        let from_end = |i: usize, end: f64| {
            let whole = nodes.y[i] - end;
            if whole.abs() > 0.0 {
                square(i) * ((y - end) / whole).clamp(0.0, 1.0)
            } else {
                square(i)
            }
        };
        let square = if after == first {
            from_end(first, piece.ends[0])
        } else if after > last {
            from_end(last, piece.ends[1])
        } else {
            let share = (y - nodes.y[after - 1]) / (nodes.y[after] - nodes.y[after - 1]);
            square(after - 1) + share * (square(after) - square(after - 1))
        };
        square.sqrt()
    }
}
