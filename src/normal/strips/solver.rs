//! Newton's method on the lobes, and which cells have one.

use std::f64::consts::PI;

use super::cell::{self, Cell, TERMS};
use super::influence::Integrals;
use super::rule::LobeRule;
use super::system::{Assembly, Lobe, Matrices, Nodes};
use super::{Line, LinePlace};
use crate::geometry::separation::Probe;
use crate::math::linear_system;
use crate::math::room::Room;
use crate::normal::hertz;
use crate::normal::{Strips, Zone};

/// Most lobes at once; what has no room is left to its neighbour.
const MOST_LOBES: usize = 6;
/// Overlap, over the deepest, from which a cell has a lobe from the start.
const FIRST_LOBES: f64 = 0.4;
/// Most Newton steps for one set of lobes, and most changes of that set.
const MOST_STEPS: usize = 40;
const MOST_CHANGES: usize = 16;
/// Last Newton step, relative: convergence is quadratic, so that what is left is of the order of its square. A longer step is the last one
/// where the one before it shows that no more than this is left.
const LAST_STEP: f64 = 3e-6;
const LONGEST_LAST_STEP: f64 = 1e-4;
const LEFT_OVER: f64 = 1e-10;
/// Greatest change of an edge in one step, share of the width, and of a ratio downwards.
const MOST_EDGE_STEP: f64 = 0.2;
const MOST_DROP: f64 = 0.7;
/// Distance from a ridge, over the width, from which a lobe meets another that has come to it.
const MEETING: f64 = 0.3;
/// How often an end may leave its ridge.
const MOST_RELEASES: u8 = 2;
/// Share of the greatest ratio below which a node may be emptied, and a lobe with no more has vanished.
const EMPTY: f64 = 1e-3;
const VANISHED: f64 = 0.02;
/// How often an edge may come to a ridge before it stays there: it may have been on the way to elsewhere.
const MOST_HITS: u8 = 2;
/// Starts: approach over the overlap, share of the Newton step, and share from which a ridge counts; the last ones take lobes that
/// are about to meet as one.
const STARTS: [[f64; 3]; 8] = [
    [1.0, 1.0, LEAST_SHARE],
    [0.7, 0.6, LEAST_SHARE],
    [0.45, 0.4, LEAST_SHARE],
    [0.8, 0.5, 0.2],
    [1.0, 0.7, 0.5],
    [1.0, 0.5, 1.0],
    [0.7, 0.3, 1.0],
    [0.5, 0.2, 1.0],
];
/// Share from which a ridge counts.
const LEAST_SHARE: f64 = 0.05;
/// Greatest change of a shape term in one step.
const MOST_SHAPE_STEP: f64 = 0.6;

/// Work of one solver since it was made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Problems solved.
    pub solved: u64,
    /// Newton steps.
    pub steps: u64,
    /// Problems that did not converge.
    pub failed: u64,
}

/// Solver with its tables and scratch memory; it keeps no result.
#[derive(Debug)]
pub struct StripSolver {
    rule: LobeRule,
    integrals: Integrals,
    cells: Room<Cell>,
    lobes: Room<Lobe>,
    nodes: Nodes,
    matrices: Matrices,
    /// Share of the Newton step that is taken far from the solution.
    caution: f64,
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
    /// A solver with `strips` ≥ 4 strips for each lobe.
    #[must_use]
    pub fn new(strips: usize) -> Self {
        let rule = LobeRule::new(strips);
        let nodes = strips * MOST_LOBES;
        let unknowns = (strips + 2 + rule.terms) * MOST_LOBES;
        Self {
            rule,
            integrals: Integrals::new(),
            cells: Room::new(64),
            lobes: Room::new(MOST_LOBES),
            nodes: Nodes::with_capacity(nodes),
            matrices: Matrices::new(strips, nodes, unknowns),
            caution: 1.0,
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
        for [approach, caution, least_share] in STARTS {
            cell::fill(probes, level, least_share, &mut self.cells);
            self.caution = caution;
            if self.settle(line, (probes, level), approach) {
                self.emit(contact_modulus, strips);
                return true;
            }
        }
        self.work.failed += 1;
        false
    }

    /// Finds the lobes of all cells.
    fn settle(&mut self, line: &mut impl Line, overlap: (&[Probe], f64), approach: f64) -> bool {
        self.begin(line, overlap, approach);
        for _ in 0..MOST_CHANGES {
            if !self.lobes.is_empty() && !self.newton(line) {
                // A cell that lost its lobe on the way: go on without.
                if !self.drop_marked() {
                    return false;
                }
                continue;
            }
            if !self.revise(line, overlap) {
                return true;
            }
        }
        false
    }

    /// Starts a lobe in the deepest cells; the others follow where they still overlap then.
    fn begin(&mut self, line: &mut impl Line, overlap: (&[Probe], f64), approach: f64) {
        self.lobes.clear();
        let most = self.cells.iter().map(|c| c.deepest[1]).fold(0.0, f64::max);
        for i in 0..self.cells.len() {
            let depth = self.cells[i].deepest[1];
            if depth > FIRST_LOBES * most {
                self.start_lobe(line, overlap, i, approach * depth);
            }
        }
        for i in 0..self.cells.len() {
            let joined = self.cells[i].joined && i + 1 < self.cells.len();
            self.cells[i].at_ridge[1] = joined;
            if joined {
                self.cells[i + 1].at_ridge[0] = true;
            }
        }
        self.gather();
    }

    /// A first guess for the lobe of cell `i` from the ellipse of the approach `depth` [m] at its deepest place.
    fn start_lobe(
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
        let mut overlap = |u: f64| line.place(u).overlap;
        let half = cell::places(probes, level, cell, 0.5, &mut overlap);
        let width = (half[1] - half[0]) * place.dy;
        let along = 0.5 / place.radius;
        // Curvature of the parabola as wide at half of the depth; what is shallower is narrower.
        let across = (2.0 * cell.deepest[1] / (width * width)).clamp(1e-4 * along, 1e6 * along);
        let ellipse = hertz::ellipse(along, across, depth, 1.0);
        // The ellipse ends where the separation has used up this share of the approach.
        let used = (across * ellipse.semi_axis_across * ellipse.semi_axis_across / depth).min(0.95);
        let left = (1.0 - used * depth / cell.deepest[1]).clamp(0.05, 0.999_999);
        let places = cell::places(probes, level, cell, left, &mut overlap);
        cell.edges = [
            places[0].clamp(cell.bounds[0], cell.deepest[0]),
            places[1].clamp(cell.deepest[0], cell.bounds[1]),
        ];
        cell.start_level = left * cell.deepest[1];
        cell.active = true;
        cell.pinned = [false; 2];
        cell.start_width = cell.edges[1] - cell.edges[0];
        cell.shape = [0.0; TERMS];
        // q/(π E*) = a e^κ0/(2 π R)
        let greatest = ellipse.max_pressure / PI;
        cell.shape[0] = (greatest * 2.0 * PI * place.radius / ellipse.semi_axis_along).ln();
        cell.start_ratio = greatest;
        cell.begun_with = greatest;
        (cell.hits, cell.held) = ([0; 2], [false; 2]);
    }

    /// Lays the nodes of all active cells out anew; ratios of lobes that stay are kept.
    fn gather(&mut self) {
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
                self.lobes.push(Lobe { cell: i, first, edge_y: [0.0; 2], edge_dy: [0.0; 2] });
            }
        }
        std::mem::swap(&mut self.nodes.ratio, &mut kept);
        self.nodes.spare = kept;
        self.nodes.resize(self.lobes.len() * n);
    }

    /// Geometry and pressure at all nodes for the present unknowns; whether any strips are shifted against each other.
    fn place_nodes(&mut self, line: &mut impl Line) -> bool {
        let n = self.rule.count();
        let mut skewed = false;
        for number in 0..self.lobes.len() {
            let Lobe { cell, first, .. } = self.lobes[number];
            let cell = self.cells[cell];
            let [left, right] = cell.edges;
            let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
            for side in 0..2 {
                let place = line.place(cell.edges[side]);
                self.lobes[number].edge_y[side] = place.y;
                self.lobes[number].edge_dy[side] = place.dy;
            }
            let nodes = &mut self.nodes;
            for t in 0..n {
                let (i, abscissa) = (first + t, self.rule.nodes[t]);
                let u = middle + half * abscissa;
                let LinePlace { y, dy, overlap, overlap_slope, x, tangent, radius } = line.place(u);
                nodes.u[i] = u;
                nodes.y[i] = y;
                nodes.dy[i] = dy;
                nodes.x[i] = x;
                nodes.tangent[i] = tangent;
                nodes.overlap[i] = overlap;
                nodes.overlap_slope[i] = overlap_slope;
                nodes.radius[i] = radius;
                nodes.width[i] = half * self.rule.weights[t] * dy;
                nodes.lobe[i] = number;
                let shape = |side: usize, distance: f64| {
                    if cell.pinned[side] && !cell.held[side] { 1.0 } else { distance.sqrt() }
                };
                nodes.edge_shape[i] = shape(0, 1.0 + abscissa) * shape(1, 1.0 - abscissa);
                if cell.start_ratio > 0.0 {
                    let span = cell.deepest[1] - cell.start_level;
                    let share = ((overlap - cell.start_level) / span).clamp(0.01, 1.0);
                    nodes.ratio[i] =
                        cell.start_ratio * share.sqrt() / nodes.edge_shape[i].max(0.05);
                }
                let exponent: f64 =
                    (0..self.rule.terms).map(|l| cell.shape[l] * self.rule.legendre[l][t]).sum();
                nodes.pressure[i] = nodes.ratio[i].max(0.0) * nodes.edge_shape[i];
                let per_pressure = 2.0 * PI * radius * (-exponent).exp();
                nodes.half_length[i] = (nodes.pressure[i] * per_pressure).max(1e-12 * half);
                skewed |= (x - nodes.x[0]).abs() > 0.0;
            }
            self.cells[self.lobes[number].cell].start_ratio = 0.0;
            for t in 0..n {
                let i = first + t;
                let row = &self.rule.derivative[t * n..(t + 1) * n];
                let slope = |values: &[f64]| -> f64 {
                    row.iter().zip(values).map(|(d, v)| d * v).sum::<f64>() / half
                };
                let slant = slope(&nodes.x[first..first + n]) / nodes.dy[i];
                nodes.slant[i] = (1.0 + slant * slant).sqrt();
            }
        }
        skewed
    }

    /// Newton's method for the present lobes; false where it does not converge.
    fn newton(&mut self, line: &mut impl Line) -> bool {
        let n = self.rule.count();
        let block = n + 2 + self.rule.terms;
        let depth = self.lobes.iter().map(|l| self.cells[l.cell].deepest[1]).fold(0.0, f64::max);
        let mut before = f64::INFINITY;
        for _ in 0..MOST_STEPS {
            self.work.steps += 1;
            let skewed = self.place_nodes(line);
            let unknowns = self.lobes.len() * block;
            let scale = self.nodes.ratio.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
            if scale.is_nan() || scale <= 0.0 {
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
            assembly.influences(&mut self.matrices);
            assembly.assemble(&mut self.matrices);
            let Matrices { newton, right, .. } = &mut self.matrices;
            if !linear_system::solve(newton, unknowns, &mut right[..unknowns]) {
                return false;
            }
            let (share, change) = self.step_share(scale);
            let caution = if change < 0.03 { 1.0 } else { self.caution };
            self.advance(share * caution, scale);
            // A change c leaves about k c².
            let k = (change / (before * before)).max(1.0);
            let near = change < LONGEST_LAST_STEP && k * change * change < LEFT_OVER;
            before = change;
            if share >= 1.0 && (change < LAST_STEP || near) {
                self.place_nodes(line);
                return true;
            }
            if self.mark_vanishing() {
                return false;
            }
            self.hold_empty_ends(scale);
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
            for ratio in &step[..n] {
                change = change.max(ratio.abs() / scale);
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

    /// Takes `share` of the Newton step; edges that come to a ridge stay there.
    fn advance(&mut self, share: f64, scale: f64) {
        let n = self.rule.count();
        let block = n + 2 + self.rule.terms;
        for number in 0..self.lobes.len() {
            let Lobe { cell, first, .. } = self.lobes[number];
            let step = &self.matrices.right[number * block..(number + 1) * block];
            for (ratio, step) in self.nodes.ratio[first..first + n].iter_mut().zip(step) {
                // A node is not emptied at once: its edge may be on the way.
                let least =
                    if *ratio > EMPTY * scale { (1.0 - MOST_DROP) * *ratio } else { -scale };
                *ratio = (*ratio + share * step).clamp(least, 3.0 * ratio.abs() + scale);
            }
            let moved = [share * step[n], share * step[n + 1]];
            let cell = &mut self.cells[cell];
            for l in 0..self.rule.terms {
                cell.shape[l] += (share * step[n + 2 + l]).clamp(-MOST_SHAPE_STEP, MOST_SHAPE_STEP);
            }
            for (side, moved) in moved.into_iter().enumerate() {
                let cell = &mut self.cells[self.lobes[number].cell];
                if cell.pinned[side] {
                    continue;
                }
                let edge = cell.edges[side] + moved;
                let bound = cell.bounds[side];
                let beyond = if side == 0 { edge <= bound } else { edge >= bound };
                if beyond && !(cell.at_ridge[side] && cell.hits[side] >= MOST_HITS) {
                    cell.edges[side] = 0.5 * (cell.edges[side] + bound);
                    cell.hits[side] += 1;
                    continue;
                }
                cell.edges[side] = edge;
                if beyond {
                    self.pin(number, side);
                    // The lobe on the other side meets it there.
                    let other = if side == 0 { number.wrapping_sub(1) } else { number + 1 };
                    let facing = self.cells[self.lobes[number].cell].bounds[side];
                    if let Some(beside) = self.lobes.get(other) {
                        let beside = &self.cells[beside.cell];
                        let gap = (beside.edges[1 - side] - facing).abs();
                        let near = gap < MEETING * (beside.edges[1] - beside.edges[0]);
                        let same = (beside.bounds[1 - side] - facing).abs() <= 0.0;
                        if same && near && !beside.pinned[1 - side] {
                            self.pin(other, 1 - side);
                        }
                    }
                    break;
                }
            }
        }
    }

    /// Puts one end of a lobe on its ridge.
    fn pin(&mut self, number: usize, side: usize) {
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
    fn hold_empty_ends(&mut self, scale: f64) {
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
    fn mark_vanishing(&mut self) -> bool {
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
    fn drop_marked(&mut self) -> bool {
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
    fn revise(&mut self, line: &mut impl Line, overlap: (&[Probe], f64)) -> bool {
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
    fn displacement(&self, place: &LinePlace) -> f64 {
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

    /// Greatest pressure over π E* of the lobe that begins at node `first`: the vertex of the parabola of its square, exact on ellipses.
    fn greatest_pressure(&self, first: usize) -> f64 {
        let n = self.rule.count();
        let q = &self.nodes.pressure[first..first + n];
        let most = (0..n).fold(0, |best, t| if q[t] > q[best] { t } else { best });
        if most == 0 || most == n - 1 {
            return q[most];
        }
        let t = &self.rule.nodes[most - 1..=most + 1];
        let square = [most - 1, most, most + 1].map(|k| q[k] * q[k]);
        let (left, right) = (t[0] - t[1], t[2] - t[1]);
        let slopes = [(square[0] - square[1]) / left, (square[2] - square[1]) / right];
        let bend = (slopes[1] - slopes[0]) / (right - left);
        let slope = slopes[0] - bend * left;
        let vertex = if bend < 0.0 { (-0.5 * slope / bend).clamp(left, right) } else { 0.0 };
        (square[1] + vertex * (slope + bend * vertex)).max(square[1]).sqrt()
    }

    /// Hands the lobes over as strips; lobes that meet at a ridge are one zone.
    fn emit(&self, contact_modulus: f64, strips: &mut Strips) {
        let n = self.rule.count();
        let mut number = 0;
        while number < self.lobes.len() {
            let begin = number;
            while number + 1 < self.lobes.len() {
                let (here, next) = (self.lobes[number].cell, self.lobes[number + 1].cell);
                let meets = next == here + 1
                    && self.cells[here].joined
                    && self.cells[here].pinned[1]
                    && self.cells[next].pinned[0];
                if !meets {
                    break;
                }
                number += 1;
            }
            number += 1;
            let count = (number - begin) * n;
            if !strips.has_room_for(count) {
                continue;
            }
            let mut zone = Zone { first: strips.y.len(), count, ..Zone::default() };
            for lobe in &self.lobes[begin..number] {
                for i in lobe.first..lobe.first + n {
                    let nodes = &self.nodes;
                    strips.y.push(nodes.y[i]);
                    strips.width.push(nodes.width[i]);
                    strips.x.push(nodes.x[i]);
                    strips.half_length.push(nodes.half_length[i]);
                    strips.pressure.push(PI * contact_modulus * nodes.pressure[i]);
                    strips.u.push(nodes.u[i]);
                    zone.length = zone.length.max(2.0 * nodes.half_length[i]);
                }
                let greatest = PI * contact_modulus * self.greatest_pressure(lobe.first);
                zone.max_pressure = zone.max_pressure.max(greatest);
            }
            zone.width = self.lobes[number - 1].edge_y[1] - self.lobes[begin].edge_y[0];
            strips.summarise(&mut zone);
            strips.zones.push(zone);
        }
    }
}
