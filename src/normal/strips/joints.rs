//! Joints: two lobes with a ridge between them that are one zone, or are about to be.
//!
//! Lobes apart have ends that are found, lobes with a joint meet at the ridge and end beside it where strips are not loaded. Both describe
//! the same bodies, to the accuracy of so many strips, as long as the gap between them is narrow. Which one is taken follows from that gap, as
//! found with the lobes apart: from one share of the width of both lobes to another the one goes over into the other, so that the force does not jump.

use super::Line;
use super::cell::{Cell, Joint};
use super::nodes::Lobe;
use super::solver::{STARTS, Start, StripSolver};
use crate::geometry::separation::Probe;
use crate::math::smooth_step::smooth_step;

/// How lobes that turned out to be apart begin again.
const AGAIN: Start = STARTS[1];

/// Gap of two lobes over the width of both: below it they have a joint, and from it on they are apart.
const JOINED: f64 = 0.1;
const APART: f64 = 0.15;
/// Stretch without load beside a joint, over the width, from which it is seen whether the lobes are apart.
const UNLOADED: f64 = 0.06;
/// Least width of a lobe with a joint, share of both.
const LEAST_WIDTH: f64 = 0.02;

/// Strips of two lobes apart, while the same are solved with a joint.
#[derive(Clone, Debug, Default)]
pub(super) struct Apart {
    /// Number of the left one of the two lobes that are about to meet, if there are any.
    pub lobe: Option<usize>,
    /// Their share, 0 to 1.
    share: f64,
    /// Pressure over π E* and half length of all nodes; ends of all lobes.
    pub nodes: Vec<[f64; 2]>,
    edges: Vec<[f64; 2]>,
}

impl Apart {
    /// Room for so many nodes and lobes.
    pub fn with_capacity(nodes: usize, lobes: usize) -> Self {
        Self {
            nodes: Vec::with_capacity(nodes),
            edges: Vec::with_capacity(lobes),
            ..Self::default()
        }
    }
}

impl StripSolver {
    /// Joins all lobes on both sides of a ridge, or those on both sides of a shoulder, before the first step; whether there are any.
    pub(super) fn begin_met(&mut self, only_shoulders: bool) -> bool {
        let mut found = false;
        for number in 1..self.lobes.len() {
            let (left, right) = (self.lobes[number - 1].cell, self.lobes[number].cell);
            let [a, b] = [&self.cells[left], &self.cells[right]];
            let is_shoulder = a.is_on_shoulder() || b.is_on_shoulder();
            if right == left + 1 && a.joined && (is_shoulder || !only_shoulders) {
                let ridge = self.cells[left].bounds[1];
                (self.cells[left].edges[1], self.cells[right].edges[0]) = (ridge, ridge);
                (self.cells[left].met[1], self.cells[right].met[0]) = (true, true);
                found = true;
            }
        }
        found
    }

    /// Joins lobes whose edges have come to each other; whether there were any.
    pub(super) fn meet(&mut self) -> bool {
        let mut changed = false;
        for number in 1..self.lobes.len() {
            let (left, right) = (self.lobes[number - 1].cell, self.lobes[number].cell);
            let [outer_left, inner_left] = self.cells[left].edges;
            let [inner_right, outer_right] = self.cells[right].edges;
            if !self.cells[left].met[1] && inner_left >= inner_right && outer_left < outer_right {
                // Those that were parted come back for good.
                if self.cells[left].joint == Joint::Parted {
                    self.cells[left].joint = Joint::Stays;
                }
                self.join(number - 1);
                changed = true;
            }
        }
        changed
    }

    /// Joins lobes of a solution that are close to each other, and parts those with a gap at their joint; whether there were any. What
    /// two lobes on their way from one to the other are apart is kept.
    pub(super) fn meet_or_part(&mut self, line: &mut impl Line, overlap: (&[Probe], f64)) -> bool {
        if self.apart.lobe.is_some() {
            return false;
        }
        for number in 1..self.lobes.len() {
            let (left, right) = (self.lobes[number - 1].cell, self.lobes[number].cell);
            let width = self.cells[right].edges[1] - self.cells[left].edges[0];
            if self.cells[left].met[1] {
                if self.cells[left].joint != Joint::Stays
                    && self.unloaded(number - 1) > UNLOADED * width
                {
                    self.part(number - 1, line, overlap);
                    return true;
                }
            } else if let Some(gap) = self.gap(number - 1) {
                if gap >= APART {
                    continue;
                }
                if gap > JOINED {
                    self.keep(number - 1, smooth_step((gap - JOINED) / (APART - JOINED)));
                }
                self.cells[left].joint = Joint::Stays;
                self.join(number - 1);
                return true;
            }
        }
        false
    }

    /// Whether two lobes are so close that they have a joint.
    pub(super) fn is_about_to_meet(&self) -> bool {
        (1..self.lobes.len()).any(|number| self.gap(number - 1).is_some_and(|gap| gap < JOINED))
    }

    /// Gap between the lobe `number` and the next one over the width of both, where they are apart and may meet.
    fn gap(&self, number: usize) -> Option<f64> {
        let [a, b] = [0, 1].map(|k| self.lobes[number + k].cell);
        let [left, right] = [&self.cells[a], &self.cells[b]];
        let may_meet = left.joined && b == a + 1 && !left.met[1];
        may_meet.then(|| (right.edges[0] - left.edges[1]) / (right.edges[1] - left.edges[0]))
    }

    /// Width without load beside the joint of the lobe `number` with the next one [m].
    fn unloaded(&self, number: usize) -> f64 {
        let joint = self.cells[self.lobes[number].cell].edges[1];
        let [left, right] = [self.early_end(number, 1), self.early_end(number + 1, 0)];
        right.unwrap_or(joint) - left.unwrap_or(joint)
    }

    /// Finds where the load of each lobe ends: where the square of the pressure, extrapolated, vanishes before a strip without load.
    pub(super) fn find_load_ends(&mut self) {
        let n = self.rule.count();
        for number in 0..self.lobes.len() {
            let Lobe { cell, first } = self.lobes[number];
            for side in 0..2 {
                let mut end = self.cells[cell].edges[side];
                if let Some(bound) =
                    self.early_end(number, side).filter(|_| self.cells[cell].met[side])
                {
                    let y = &self.nodes.y[first..first + n];
                    let Some(beyond) = y.iter().position(|y| y.to_bits() == bound.to_bits()) else {
                        continue;
                    };
                    let inner =
                        |k: usize| if side == 0 { beyond + k } else { beyond.saturating_sub(k) };
                    let [last, before] = [1, 2].map(|k| inner(k).min(n - 1));
                    let square = |k: usize| self.nodes.pressure[first + k].powi(2);
                    let fall = (square(before) - square(last)).max(f64::MIN_POSITIVE);
                    let share = square(last) / fall;
                    let way = share * (y[last] - y[before]);
                    end = if side == 0 {
                        (y[last] + way).clamp(bound, y[last])
                    } else {
                        (y[last] + way).clamp(y[last], bound)
                    };
                }
                self.cells[cell].load_ends[side] = end;
            }
        }
    }

    /// Whether the load of the lobe `number` goes on in the next one.
    pub(super) fn goes_on(&self, number: usize) -> bool {
        let cell = &self.cells[self.lobes[number].cell];
        let Some(next) = self.lobes.get(number + 1) else { return false };
        cell.met[1] && self.cells[next.cell].load_ends[0] <= cell.load_ends[1]
    }

    /// Joins the lobe `number` and the next one at the ridge; pressures stay where they are.
    fn join(&mut self, number: usize) {
        let (left, right) = (self.lobes[number].cell, self.lobes[number + 1].cell);
        let [begin, end] = [self.cells[left].edges[0], self.cells[right].edges[1]];
        let margin = LEAST_WIDTH * (end - begin);
        let joint = self.cells[left].bounds[1].clamp(begin + margin, end - margin);
        (self.cells[left].met[1], self.cells[right].met[0]) = (true, true);
        self.move_end(number, 1, joint);
        self.move_end(number + 1, 0, joint);
    }

    /// Parts the lobe `number` and the next one, which begin anew, narrower than at first.
    fn part(&mut self, number: usize, line: &mut impl Line, overlap: (&[Probe], f64)) {
        let cells = [0, 1].map(|k| self.lobes[number + k].cell);
        self.set_met(number, false);
        for cell in cells {
            let depth = AGAIN.approach * self.cells[cell].deepest[1];
            let (met, joint) = (self.cells[cell].met, self.cells[cell].joint);
            self.start_lobe(line, overlap, cell, depth);
            (self.cells[cell].met, self.cells[cell].joint) = (met, joint);
        }
        self.cells[cells[0]].joint = Joint::Parted;
        self.caution = AGAIN.caution;
        self.gather();
    }

    /// Keeps the solution with the lobe `number` and the next one apart, which is to have `share`.
    fn keep(&mut self, number: usize, share: f64) {
        let Self { apart, nodes, lobes, cells, .. } = self;
        (apart.lobe, apart.share) = (Some(number), share);
        apart.nodes.clear();
        let lengths = nodes.pressure.iter().zip(&nodes.half_length);
        apart.nodes.extend(lengths.map(|(pressure, length)| [*pressure, *length]));
        apart.edges.clear();
        apart.edges.extend(lobes.iter().map(|lobe| cells[lobe.cell].edges));
    }

    /// Mixes the solution with what was kept of lobes apart.
    pub(super) fn mix(&mut self, line: &mut impl Line) {
        self.find_load_ends();
        let Some(number) = self.apart.lobe else { return };
        if self.apart.nodes.len() != self.nodes.y.len() {
            // A lobe has gone or come: the solution is the one with a joint.
            self.apart.lobe = None;
            return;
        }
        let share = self.apart.share;
        let between = |joined: f64, apart: f64| joined + share * (apart - joined);
        for (i, [pressure, half_length]) in self.apart.nodes.iter().enumerate() {
            self.nodes.pressure[i] = between(self.nodes.pressure[i], *pressure);
            self.nodes.half_length[i] = between(self.nodes.half_length[i], *half_length);
        }
        for (lobe, apart) in self.lobes.iter().zip(&self.apart.edges) {
            let Cell { edges, load_ends, .. } = &mut self.cells[lobe.cell];
            for ends in [edges, load_ends] {
                for side in 0..2 {
                    ends[side] = between(ends[side], apart[side]);
                }
            }
        }
        self.place_mixed(line);
        let [left, right] = [0, 1].map(|k| self.lobes[number + k].cell);
        (self.cells[left].met[1], self.cells[right].met[0]) = (false, false);
    }

    /// Places the nodes anew between ends that are mixed, with the pressures and half lengths that they have.
    pub(super) fn place_mixed(&mut self, line: &mut impl Line) {
        let columns = (&self.nodes.pressure, &self.nodes.half_length);
        self.apart.nodes.clear();
        self.apart.nodes.extend(columns.0.iter().zip(columns.1).map(|(q, a)| [*q, *a]));
        self.place_nodes(line);
        for (i, [pressure, half_length]) in self.apart.nodes.iter().enumerate() {
            (self.nodes.pressure[i], self.nodes.half_length[i]) = (*pressure, *half_length);
        }
        self.is_mixed = true;
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::super::two_peaks::TwoPeaks;
    use super::*;

    const PEAKS: TwoPeaks = TwoPeaks { ridge: 5e-5, half_distance: 5e-3, tilt: 0.0 };

    /// Second difference of a load over the load.
    fn bend(loads: &[f64]) -> f64 {
        (loads[2] - 2.0 * loads[1] + loads[0]).abs() / loads[1]
    }

    #[test]
    fn two_equal_lobes_merge_without_a_jump() {
        let mut solver = StripSolver::new(15);
        let (mut loads, mut mixed, mut joined, mut zones) = (Vec::new(), 0, 0, [false; 3]);
        for step in 0..=75 {
            let strips = PEAKS.pressed(&mut solver, 9.5e-5 + 1e-6 * f64::from(step));
            zones[strips.zones.len()] = true;
            mixed += usize::from(solver.is_mixed);
            joined += usize::from(!solver.is_mixed && strips.zones.len() == 1);
            loads.push(strips.load());
            // Each strip has its mirror image.
            let count = strips.y.len();
            let most = strips.pressure.iter().fold(0.0f64, |a, b| a.max(*b));
            for i in 0..count / 2 {
                let other = count - 1 - i;
                assert_relative_eq!(strips.y[i], -strips.y[other], epsilon = 1e-9);
                let [a, b] = [i, other].map(|i| strips.pressure[i] / most);
                assert_relative_eq!(a, b, epsilon = 1e-7);
            }
        }
        assert!(zones[1] && zones[2] && mixed > 5 && joined > 5, "{zones:?} {mixed} {joined}");
        assert_eq!(solver.work.fixed, 0);
        assert!(loads.windows(2).all(|w| w[1] > w[0]));
        let worst = loads.windows(3).map(bend).fold(0.0, f64::max);
        assert!(worst < MOST_BEND, "{worst}");
    }

    /// Second difference of the load over steps of 1 µm, of the load: measured 7.8e-4, where strips with a joint carry 0.2 % less than strips apart and the
    /// one go over into the other within 7 µm.
    const MOST_BEND: f64 = 1e-3;

    #[test]
    fn a_joint_that_moves_leaves_no_jags() {
        for strips in [9, 12] {
            let mut solver = StripSolver::new(strips);
            // The ridge goes over two probes, 125 µm apart.
            let loads: Vec<f64> = (0..60)
                .map(|step| TwoPeaks { tilt: 4e-5 * f64::from(step), ..PEAKS })
                .map(|peaks| peaks.pressed(&mut solver, 1.8e-4).load())
                .collect();
            assert_eq!(solver.work.fixed, 0);
            let worst = loads.windows(3).map(bend).fold(0.0, f64::max);
            assert!(worst < 4e-6, "{strips} {worst}");
        }
    }
}
