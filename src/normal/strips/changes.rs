//! How the set of lobes changes: lobes that meet or part, that vanish or appear.

use super::nodes::Lobe;
use super::solver::StripSolver;
use super::{Line, LinePlace};
use crate::geometry::separation::Probe;

/// How often free ends of a lobe may be moved.
const MOST_RETREATS: u8 = 2;
/// Share of its first pressure or width with which a lobe has vanished.
const VANISHED: f64 = 0.02;

impl StripSolver {
    /// Multiplies the ratios of a lobe by the distance from its end `side` to the given power.
    fn reshape(&mut self, number: usize, side: usize, power: f64) {
        let first = self.lobes[number].first;
        for (t, a) in self.rule.nodes.iter().enumerate() {
            let distance = if side == 0 { 1.0 + a } else { 1.0 - a };
            self.nodes.ratio[first + t] *= distance.powf(power);
        }
    }

    /// Joins the lobe `number` and the next one, or parts them.
    pub(super) fn set_met(&mut self, number: usize, met: bool) {
        let power = if met { 0.5 } else { -0.5 };
        for (number, side) in [(number, 1), (number + 1, 0)] {
            let cell = self.lobes[number].cell;
            if self.cells[cell].met[side] != met {
                self.cells[cell].met[side] = met;
                self.reshape(number, side, power);
            }
        }
    }

    /// Where the load of the lobe `number` ends before its end `side`: the first node without pressure, seen from the greatest one [m].
    pub(super) fn early_end(&self, number: usize, side: usize) -> Option<f64> {
        let n = self.rule.count();
        let first = self.lobes[number].first;
        let pressure = &self.nodes.pressure[first..first + n];
        let greatest =
            (0..n).fold(0, |best, t| if pressure[t] > pressure[best] { t } else { best });
        let unloaded = |&t: &usize| pressure[t] <= 0.0;
        let t = if side == 0 {
            (0..greatest).rev().find(unloaded)
        } else {
            (greatest..n).find(unloaded)
        };
        t.map(|t| self.nodes.y[first + t])
    }

    /// Moves the end `side` of the lobe `number`; pressures stay where they are.
    pub(super) fn move_end(&mut self, number: usize, side: usize, edge: f64) {
        let n = self.rule.count();
        let Lobe { cell, first } = self.lobes[number];
        let cell = &mut self.cells[cell];
        cell.edges[side] = edge;
        let [left, right] = cell.edges;
        let met = cell.met;
        let mut k = 0;
        self.nodes.spare.clear();
        for a in &self.rule.nodes {
            let y = 0.5 * (left + right) + 0.5 * (right - left) * a;
            let old = &self.nodes.y[first..first + n];
            while k < n - 2 && old[k + 1] < y {
                k += 1;
            }
            let share = ((y - old[k]) / (old[k + 1] - old[k])).clamp(0.0, 1.0);
            let old = &self.nodes.pressure[first..first + n];
            let mut ratio = (old[k] + share * (old[k + 1] - old[k])).max(0.0);
            for (met, distance) in met.into_iter().zip([1.0 + a, 1.0 - a]) {
                if !met {
                    ratio /= distance.max(0.05).sqrt();
                }
            }
            self.nodes.spare.push(ratio);
        }
        self.nodes.ratio[first..first + n].copy_from_slice(&self.nodes.spare);
    }

    /// Moves free ends of a solution to where the load ends, if more than the outermost node is without; whether there were any.
    pub(super) fn retreat_free_ends(&mut self) -> bool {
        let n = self.rule.count();
        let mut changed = false;
        for number in 0..self.lobes.len() {
            let Lobe { cell, first } = self.lobes[number];
            for side in 0..2 {
                if self.cells[cell].met[side] || self.cells[cell].retreats >= MOST_RETREATS {
                    continue;
                }
                let second = self.nodes.y[first + if side == 0 { 1 } else { n - 2 }];
                let Some(end) = self.early_end(number, side) else { continue };
                let early = if side == 0 { end >= second } else { end <= second };
                if early {
                    self.cells[cell].retreats += 1;
                    self.move_end(number, side, end);
                    changed = true;
                }
            }
        }
        changed
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
        for number in 0..self.lobes.len() {
            let cell = self.lobes[number].cell;
            if !self.cells[cell].vanishing {
                continue;
            }
            if self.cells[cell].met[0] {
                self.set_met(number - 1, false);
            }
            if self.cells[cell].met[1] {
                self.set_met(number, false);
            }
            let cell = &mut self.cells[cell];
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
            let Lobe { cell, first } = self.lobes[number];
            if !(0..n).any(|t| self.nodes.ratio[first + t] > 0.0) {
                self.cells[cell].vanishing = true;
                changed = true;
            }
        }
        if changed {
            self.drop_marked();
        }
        for i in 0..self.cells.len() {
            if self.cells[i].active || self.cells[i].dropped > 2 {
                continue;
            }
            let place = line.place(self.cells[i].deepest[0]);
            let within = |lobe: &Lobe| {
                let [left, right] = self.cells[lobe.cell].edges;
                place.y > left && place.y < right
            };
            if self.lobes.iter().any(within) {
                continue;
            }
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
            let [[_, d], _] = self.integrals.at(sigma.max(1e-6));
            sum += nodes.width[j] * nodes.pressure[j] * cosine * d;
        }
        sum
    }
}
