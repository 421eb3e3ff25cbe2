//! How the set of lobes changes: ends that come to a ridge or leave it, lobes that vanish or appear.

use super::nodes::Lobe;
use super::solver::{EMPTY, StripSolver};
use super::{Line, LinePlace};
use crate::geometry::separation::Probe;

/// How often an end may leave its ridge.
const MOST_RELEASES: u8 = 2;
/// Share of its first pressure or width with which a lobe has vanished.
const VANISHED: f64 = 0.02;

impl StripSolver {
    /// Puts one end of a lobe on its ridge.
    pub(super) fn pin(&mut self, number: usize, side: usize) {
        let Lobe { cell, first, .. } = self.lobes[number];
        let cell = &mut self.cells[cell];
        cell.edges[side] = cell.bounds[side];
        cell.pinned[side] = true;
        for (t, a) in self.rule.nodes.iter().enumerate() {
            let distance = if side == 0 { 1.0 + a } else { 1.0 - a };
            self.nodes.ratio[first + t] *= distance.sqrt();
        }
    }

    /// Ends on a ridge whose pressure vanishes there: they keep their place with the shape of a free edge.
    pub(super) fn hold_empty_ends(&mut self, scale: f64) {
        let n = self.rule.count();
        for number in 0..self.lobes.len() {
            let Lobe { cell, first, .. } = self.lobes[number];
            let cell = &mut self.cells[cell];
            for side in 0..2 {
                let outermost = first + if side == 0 { 0 } else { n - 1 };
                let empty = self.nodes.ratio[outermost] < EMPTY * scale;
                if cell.pinned[side] && !cell.held[side] && empty {
                    cell.held[side] = true;
                    for t in 0..n {
                        let a = self.rule.nodes[t];
                        let distance: f64 = if side == 0 { 1.0 + a } else { 1.0 - a };
                        let ratio = self.nodes.ratio[first + t].max(EMPTY * scale);
                        // Close to the end the ratio follows the smooth one further in.
                        self.nodes.ratio[first + t] = ratio / distance.max(0.05).sqrt();
                    }
                }
            }
        }
    }

    /// Marks lobes that shrink to nothing; whether there is one.
    pub(super) fn mark_vanishing(&mut self) -> bool {
        let n = self.rule.count();
        let mut found = false;
        for lobe in self.lobes.iter() {
            let cell = &mut self.cells[lobe.cell];
            let nodes = &self.nodes.ratio[lobe.first..lobe.first + n];
            let most = nodes.iter().fold(0.0, |a: f64, b| a.max(*b));
            if cell.edges[1] - cell.edges[0] < VANISHED * cell.start_width
                || most < VANISHED * cell.begun_with
            {
                cell.vanishing = true;
                found = true;
            }
        }
        found
    }

    /// Gives up the lobes that vanish, or else the one with the least load that has others beside it; whether there was one.
    pub(super) fn drop_marked(&mut self) -> bool {
        let mut dropped = false;
        for cell in self.cells.iter_mut().filter(|c| c.active && c.vanishing) {
            (cell.active, cell.vanishing) = (false, false);
            cell.dropped += 1;
            dropped = true;
        }
        if dropped {
            self.gather();
        }
        dropped
    }

    /// Looks at a converged set of lobes: ends that left their ridge, lobes without load, cells that overlap without one. Whether
    /// anything changed.
    pub(super) fn revise(&mut self, line: &mut impl Line, overlap: (&[Probe], f64)) -> bool {
        let n = self.rule.count();
        let mut changed = false;
        for number in 0..self.lobes.len() {
            let Lobe { cell, first, .. } = self.lobes[number];
            let cell = &mut self.cells[cell];
            let loaded = (0..n).any(|t| self.nodes.ratio[first + t] > 0.0);
            if !loaded {
                cell.active = false;
                cell.dropped += 1;
                changed = true;
                continue;
            }
            for side in 0..2 {
                // Too wide, the pressure falls below its smooth course towards the end.
                let place = |k: usize| first + if side == 0 { k } else { n - 1 - k };
                let e = &self.rule.extrapolation[0];
                let smooth: f64 = (0..3).map(|k| e[k] * self.nodes.ratio[place(k + 2)]).sum();
                let short = self.nodes.ratio[place(0)] < smooth - EMPTY * smooth.abs();
                if cell.held[side] && short && cell.releases < MOST_RELEASES {
                    (cell.pinned[side], cell.held[side]) = (false, false);
                    (cell.hits[side], cell.releases) = (0, cell.releases + 1);
                    let inwards = 0.03 * (cell.edges[1] - cell.edges[0]);
                    cell.edges[side] += if side == 0 { inwards } else { -inwards };
                    changed = true;
                }
            }
        }
        for i in 0..self.cells.len() {
            if self.cells[i].active || self.cells[i].dropped > 2 {
                continue;
            }
            let place = line.place(self.cells[i].deepest[0]);
            let excess = place.overlap - self.displacement(&place);
            if excess > 1e-6 * self.cells[i].deepest[1] {
                self.start_lobe(line, overlap, i, excess);
                changed |= self.cells[i].active;
            }
        }
        if changed {
            self.gather();
        }
        changed
    }

    /// Displacement of the half-space at a place outside all lobes [m].
    pub(super) fn displacement(&self, place: &LinePlace) -> f64 {
        let mut sum = 0.0;
        let nodes = &self.nodes;
        let [cos, sin] = place.tangent;
        for j in 0..nodes.y.len() {
            let cosine = (cos * nodes.tangent[j][0] + sin * nodes.tangent[j][1]).max(0.0);
            let a = nodes.half_length[j];
            let sigma = (place.y - nodes.y[j]).hypot(place.x - nodes.x[j]) / a;
            let [_, _, d] = self.integrals.at(sigma.max(1e-6));
            sum += nodes.width[j] * nodes.pressure[j] * cosine * d;
        }
        sum
    }
}
