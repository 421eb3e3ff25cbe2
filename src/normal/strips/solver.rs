//! Newton's method on the lobes.

use super::Line;
use super::cell::{self, Cell};
use super::faint_ridges::{self, WithoutRidge};
use super::influence::Integrals;
use super::joints::Apart;
use super::nodes::{Lobe, Matrices, Nodes};
use super::rule::LobeRule;
use super::system::Assembly;
use crate::geometry::separation::Probe;
use crate::math::room::Room;
use crate::normal::Strips;

/// Most lobes at once; what has no room is left to its neighbour.
pub(super) const MOST_LOBES: usize = 6;
/// Most Newton steps for one set of lobes, and most changes of that set.
const MOST_STEPS: u64 = 24;
const MOST_CHANGES: usize = 16;
/// Most Newton steps for a problem, with all its starts and sets of lobes: of 20 000 random poses of a wheel those with a solution took up to 72.
pub(super) const MOST_STEPS_IN_ALL: u64 = 128;
/// Last Newton step, relative: convergence is quadratic, so that what is left is of the order of its square. A longer step is the last one
/// where the one before it shows that no more than this is left.
const LAST_STEP: f64 = 1e-7;
const LONGEST_LAST_STEP: f64 = 1e-4;
const LEFT_OVER: f64 = 5e-10;
/// Least change that a change of one leaves.
const LEAST_RATE: f64 = 0.3;
/// Change from which a set of loaded nodes is believed.
const SETTLED: f64 = 0.1;
/// Share of what a step should have got shorter by that it has to, and least share of a step that is taken otherwise.
const STALLED: f64 = 0.3;
const LEAST_DAMPING: f64 = 0.5;
/// Greatest change of an edge in one step, share of the width, and of a ratio downwards.
const MOST_EDGE_STEP: f64 = 0.2;
const MOST_DROP: f64 = 0.7;
/// Share of the greatest ratio below which a node may be emptied.
const EMPTY: f64 = 1e-3;
/// Starts, tried in turn.
pub(super) const STARTS: [Start; 4] = [
    Start { approach: 1.0, caution: 1.0, met: false },
    Start { approach: 0.7, caution: 0.6, met: false },
    Start { approach: 1.0, caution: 1.0, met: true },
    Start { approach: 0.45, caution: 0.4, met: false },
];
/// Caution of a start below which lobes on both sides of a shoulder begin apart.
const AGAIN_APART: f64 = 0.5;
/// Logarithm of pressure over half length, in units of E*/(2R), beyond which a step has gone astray.
const MOST_SHAPE: f64 = 4.0;
/// Share from which a ridge counts.
pub(super) const LEAST_SHARE: f64 = 0.05;
/// Greatest change of a shape term in one step.
const MOST_SHAPE_STEP: f64 = 0.6;

/// How the lobes begin.
#[derive(Clone, Copy, Debug)]
pub(super) struct Start {
    /// Approach over the overlap.
    pub approach: f64,
    /// Share of the Newton step that is taken far from the solution.
    pub caution: f64,
    /// Whether lobes on both sides of a ridge begin as one zone.
    pub met: bool,
}

/// Work of one solver since it was made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Problems solved.
    pub solved: u64,
    /// Newton steps.
    pub steps: u64,
    /// Problems solved with strips that stay where they are, since no edges were found.
    pub fixed: u64,
    /// Problems without a solution.
    pub failed: u64,
}

/// Solver with its tables and scratch memory; it keeps no result.
#[derive(Debug)]
pub struct StripSolver {
    pub(super) rule: LobeRule,
    pub(super) integrals: Integrals,
    pub(super) cells: Room<Cell>,
    pub(super) lobes: Room<Lobe>,
    pub(super) nodes: Nodes,
    pub(super) matrices: Matrices,
    pub(super) apart: Apart,
    pub(super) without_ridge: WithoutRidge,
    /// Whether the strips are between two solutions.
    pub(super) is_mixed: bool,
    /// Share of the Newton step that is taken far from the solution.
    pub(super) caution: f64,
    /// Count of Newton steps at which the present problem is given up.
    pub(super) last_step: u64,
    /// Work so far.
    pub work: Work,
}

impl Clone for StripSolver {
    /// A solver of its own with as much room; nothing else is kept from one problem to the next.
    fn clone(&self) -> Self {
        Self { work: self.work, ..Self::new(self.rule.count()) }
    }
}

impl StripSolver {
    /// A solver with `strips` strips for each lobe, at least [`LEAST_STRIPS`](super::LEAST_STRIPS).
    #[must_use]
    pub fn new(strips: usize) -> Self {
        let strips = strips.max(super::LEAST_STRIPS);
        let rule = LobeRule::new(strips);
        let nodes = strips * MOST_LOBES;
        let unknowns = (strips + 2 + rule.terms) * MOST_LOBES;
        Self {
            rule,
            integrals: Integrals::new(),
            cells: Room::new(64),
            lobes: Room::new(MOST_LOBES),
            nodes: Nodes::with_capacity(nodes),
            matrices: Matrices::new(MOST_LOBES, nodes, unknowns),
            apart: Apart::with_capacity(nodes, MOST_LOBES),
            without_ridge: WithoutRidge::with_capacity(nodes),
            is_mixed: false,
            caution: 1.0,
            last_step: 0,
            work: Work::default(),
        }
    }

    /// Fills `strips` with the loaded zones of `line`, whose overlap is `level` - f at the `probes`; the contact modulus in Pa.
    ///
    /// Returns false where no solution was found; `strips` is then as before.
    pub fn solve(
        &mut self,
        line: &mut impl Line,
        probes: &[Probe],
        level: f64,
        contact_modulus: f64,
        strips: &mut Strips,
    ) -> bool {
        self.work.solved += 1;
        let least = cell::fill(probes, level, LEAST_SHARE, &mut self.cells);
        let weight = faint_ridges::weight(least);
        let without = weight < 1.0 && self.find(line, (probes, level), least);
        // What is between two solutions already is not mixed once more.
        let kept = without && !self.is_mixed;
        if kept {
            self.keep_without_ridge();
        }
        let mut found = kept && self.find_from_without_ridge(line, (probes, level))
            || self.find(line, (probes, level), LEAST_SHARE);
        if found && kept && !self.is_mixed {
            self.mix_without_ridge(line, weight);
        } else if !found && without {
            found = self.find(line, (probes, level), least);
        }
        if found {
            self.emit(contact_modulus, strips);
            return true;
        }
        if !self.solve_fixed(line, (probes, level), contact_modulus, strips) {
            strips.clear();
            self.work.failed += 1;
            return false;
        }
        // Strips that stay where they are show where the lobes are.
        if self.find_from_fixed(line, (probes, level)) {
            strips.clear();
            self.emit(contact_modulus, strips);
        } else {
            self.work.fixed += 1;
        }
        true
    }

    /// Finds a solution for the cells between ridges of more than `least_share`.
    fn find(&mut self, line: &mut impl Line, overlap: (&[Probe], f64), least_share: f64) -> bool {
        self.last_step = self.work.steps + MOST_STEPS_IN_ALL;
        STARTS.iter().any(|start| {
            cell::fill(overlap.0, overlap.1, least_share, &mut self.cells);
            self.caution = start.caution;
            self.begin(line, overlap, *start);
            // Lobes on both sides of a shoulder mostly are one zone.
            let has_met = start.caution >= AGAIN_APART && self.begin_met(!start.met);
            (!start.met || has_met) && self.settle(line, overlap)
        })
    }

    /// Finds a solution for the cells between all ridges from the one without the least of them.
    fn find_from_without_ridge(&mut self, line: &mut impl Line, overlap: (&[Probe], f64)) -> bool {
        self.last_step = self.work.steps + MOST_STEPS_IN_ALL;
        cell::fill(overlap.0, overlap.1, LEAST_SHARE, &mut self.cells);
        self.caution = 1.0;
        self.begin_from_without_ridge(line) && self.settle(line, overlap)
    }

    /// Finds the lobes of all cells from those that have begun.
    pub(super) fn settle(&mut self, line: &mut impl Line, overlap: (&[Probe], f64)) -> bool {
        self.apart.lobe = None;
        self.is_mixed = false;
        for _ in 0..MOST_CHANGES {
            if !self.lobes.is_empty() && !self.newton(line) {
                // A cell that lost its lobe on the way: go on without.
                if !self.drop_marked() {
                    return false;
                }
                continue;
            }
            if !self.revise(line, overlap) && !self.meet_or_part(line, overlap) {
                self.mix(line);
                return true;
            }
        }
        false
    }

    /// Newton's method for the present lobes; false where it does not converge.
    fn newton(&mut self, line: &mut impl Line) -> bool {
        let depth = self.lobes.iter().map(|l| self.cells[l.cell].deepest[1]).fold(0.0, f64::max);
        let (mut before, mut damping) = (f64::INFINITY, 1.0f64);
        let mut given_up = self.work.steps + MOST_STEPS;
        while self.work.steps < given_up {
            if self.work.steps >= self.last_step {
                return false;
            }
            self.work.steps += 1;
            let skewed = self.place_nodes(line);
            let scale = self.nodes.ratio.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
            // Centimetres inside a rail lobes may lose their width.
            let is_placed = self.nodes.ratio.iter().all(|ratio| ratio.is_finite())
                && self.nodes.half_length.iter().all(|a| a.is_finite() && *a > 0.0);
            if !is_placed || scale <= 0.0 {
                return false;
            }
            let assembly = Assembly {
                rule: &self.rule,
                integrals: &self.integrals,
                cells: &self.cells,
                lobes: &self.lobes,
                nodes: &self.nodes,
                skewed,
                depth,
                scale,
            };
            assembly.assemble(&mut self.matrices);
            let unknowns = self.lobes.len() * (self.rule.count() + 2 + self.rule.terms);
            if !assembly.solve(&mut self.matrices)
                || !self.matrices.right[..unknowns].iter().all(|step| step.is_finite())
            {
                return false;
            }
            let (share, change) = self.step_share(scale);
            let caution = if change < 0.03 { 1.0 } else { self.caution };
            // Steps that do not get shorter go to and fro between two sets of loaded nodes: the solution lies in between.
            let settled = change < SETTLED;
            if settled && change > (1.0 - STALLED * damping) * before {
                damping = (0.5 * damping).max(LEAST_DAMPING);
            } else {
                damping = (2.0 * damping).min(1.0);
            }
            self.advance(share * caution * damping, scale, settled);
            // A change c leaves about k c².
            let k = (change / (before * before)).max(LEAST_RATE);
            // Where k is large it still grows.
            let left = k * k.max(1.0).powi(2) * change * change;
            let near = change < LONGEST_LAST_STEP && left < LEFT_OVER;
            before = change;
            if self
                .lobes
                .iter()
                .any(|l| self.cells[l.cell].shape.iter().any(|s| s.abs() > MOST_SHAPE))
            {
                return false;
            }
            let changed = self.meet();
            if !changed && share * damping >= 1.0 && (change < LAST_STEP || near) {
                self.place_nodes(line);
                if !self.is_about_to_meet() && self.retreat_free_ends() {
                    before = f64::INFINITY;
                    given_up = self.work.steps + MOST_STEPS;
                    continue;
                }
                return true;
            }
            if self.mark_vanishing() {
                return false;
            }
        }
        false
    }

    /// Share of the Newton step that is safe, and the greatest relative change of it.
    fn step_share(&self, scale: f64) -> (f64, f64) {
        let n = self.rule.count();
        let block = n + 2 + self.rule.terms;
        let (mut share, mut change) = (1.0f64, 0.0f64);
        for (number, lobe) in self.lobes.iter().enumerate() {
            let step = &self.matrices.right[number * block..(number + 1) * block];
            let cell = &self.cells[lobe.cell];
            let width = cell.edges[1] - cell.edges[0];
            let ratios = &self.nodes.ratio[lobe.first..lobe.first + n];
            for ((step, ratio), t) in step[..n].iter().zip(ratios).zip(&self.rule.nodes) {
                let weight =
                    if cell.is_beside_joint(*t) { (ratio.abs() / scale).min(1.0) } else { 1.0 };
                change = change.max(weight * step.abs() / scale);
            }
            for side in 0..2 {
                let moved = step[n + side].abs() / width;
                change = change.max(moved);
                share = share.min(MOST_EDGE_STEP / moved);
            }
            for s in &step[n + 2..] {
                change = change.max(s.abs());
            }
        }
        (share, change)
    }

    /// Takes `share` of the Newton step.
    fn advance(&mut self, share: f64, scale: f64, settled: bool) {
        let n = self.rule.count();
        let block = n + 2 + self.rule.terms;
        for number in 0..self.lobes.len() {
            let Lobe { cell, first, .. } = self.lobes[number];
            let step = &self.matrices.right[number * block..(number + 1) * block];
            let cell = &mut self.cells[cell];
            let ratios = &mut self.nodes.ratio[first..first + n];
            for ((ratio, step), t) in ratios.iter_mut().zip(step).zip(&self.rule.nodes) {
                if cell.is_beside_joint(*t) {
                    // Loads go with the square of the pressure: those are near to linear where there is hardly any.
                    if *ratio > 0.0 {
                        let size = *ratio;
                        let load = size * (size + 2.0 * share * step);
                        *ratio = if load > 0.0 {
                            load.sqrt().min(3.0 * size + scale)
                        } else {
                            -1e-6 * scale
                        };
                    } else {
                        *ratio = (*ratio + share * step).min(scale).max(-scale);
                    }
                    continue;
                }
                // A node is not emptied at once: its edge may be on the way.
                let kept = !settled && *ratio > EMPTY * scale;
                let least = if kept { (1.0 - MOST_DROP) * *ratio } else { -scale };
                *ratio = (*ratio + share * step).min(3.0 * ratio.abs() + scale).max(least);
            }
            for (end, next) in [(0, 1), (n - 1, n - 2)] {
                if cell.met[usize::from(end > 0)] {
                    ratios[end] = ratios[next];
                }
            }
            let moved = [share * step[n], share * step[n + 1]];
            for l in 0..self.rule.terms {
                cell.shape[l] += (share * step[n + 2 + l]).clamp(-MOST_SHAPE_STEP, MOST_SHAPE_STEP);
            }
            for (side, moved) in moved.into_iter().enumerate() {
                let (edge, bound) = (cell.edges[side] + moved, cell.reach[side]);
                let beyond = if side == 0 { edge <= bound } else { edge >= bound };
                cell.edges[side] = if beyond { 0.5 * (cell.edges[side] + bound) } else { edge };
            }
        }
    }
}
