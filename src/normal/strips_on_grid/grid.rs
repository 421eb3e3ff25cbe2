//! One grid over all overlaps: nodes, and the cells between them, which carry the load.
//!
//! Nodes lie at equal shares of the integral of the curvature of the overlap to the power of 2/5 over all intervals in which the undeformed bodies
//! overlap, by which the squared error of linear interpolation is least on the whole; fewer lie where the overlap is too small to carry load. The ends of the
//! intervals are nodes too, and valleys between intervals that have joined. A node that leaves one of them for the next one does so where it is unloaded, with a cell
//! of no width.
//!
//! The load per width is the positive part of a line in a cell. The two cells beside a node act on it from the points of a rule for logarithms, all others from their
//! middles, with the half length that belongs to the load there.

use super::equations::Scales;
use super::line::{OverlapLine, Place};
use super::overlap::End;
use super::samples::{MOST_VALLEYS, Samples, nodes_between, share_behind};
use crate::math::real::Real;
use crate::math::room::Room;

/// A node: one unknown load per width.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node<T = f64> {
    /// Coordinate across [m].
    pub y: T,
    /// Its number among the nodes that are neither ends nor valleys of overlaps; these have that of a node beside them.
    pub number: usize,
    pub place: Place<T>,
    /// Radius of the normal section of the wheel along x [m].
    pub radius: T,
    /// Coordinates of the other ends of its cells, across and along [m].
    pub reach: [T; 2],
    pub reach_x: [T; 2],
    /// Number of the cell before it; the one behind it follows.
    pub cell: usize,
    /// The nodes there; nothing where the overlap ends.
    pub neighbours: [Option<usize>; 2],
}

/// The load between two nodes; of no width before the first and behind the last node of an overlap.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell<T = f64> {
    /// Nodes on both sides.
    pub nodes: [Option<usize>; 2],
    /// Middle across and along, and width [m].
    pub y: T,
    pub x: T,
    pub width: T,
    /// Unit tangent (y, z) across.
    pub tangent: [T; 2],
}

/// Nodes and cells of one problem.
#[derive(Clone, Debug)]
pub(super) struct Grid<T = f64> {
    pub nodes: Room<Node<T>>,
    pub cells: Room<Cell<T>>,
    pub samples: Samples<T>,
}

impl<T: Real> Grid<T> {
    /// Room for `nodes` nodes within `intervals` intervals, whose ends are nodes too.
    pub fn new(nodes: usize, intervals: usize) -> Self {
        Self {
            nodes: Room::new(nodes + 2 * intervals + MOST_VALLEYS),
            cells: Room::new(nodes + 3 * intervals + MOST_VALLEYS),
            samples: Samples::new(),
        }
    }

    /// Lays `count` nodes over the intervals of overlap between `ends`, of which there is at least one.
    pub fn lay(&mut self, line: &mut impl OverlapLine<T>, ends: &[[End; 2]], count: usize) {
        self.nodes.clear();
        self.cells.clear();
        // An overlap of the order of rounding, or of numbers that have none.
        if !self.samples.take(line, ends) {
            return;
        }
        let scales = Scales::new(&self.samples);
        let wanted = self.samples.lay(&scales);
        if !(wanted.value() > 0.0 && wanted.value().is_finite()) {
            return;
        }
        let share = wanted / (count + 1) as f64;
        let mut passed = T::from(0.0);
        let (mut next, mut laid, mut valley) = (0, 0, 0);
        while next < self.samples.list.len() {
            let (first, before) = (self.nodes.len(), laid);
            let begin = self.samples.list[next];
            self.push_node(line, begin.y, begin.u, laid);
            let mut last = begin;
            next += 1;
            while let Some(&sample) =
                self.samples.list.get(next).filter(|s| s.interval == begin.interval)
            {
                let pair = [&last, &sample];
                next += 1;
                let own = nodes_between(pair);
                while laid < count {
                    let ahead = share * (laid + 1) as f64 - passed;
                    let is_here = ahead < own && own > 0.0;
                    if !is_here {
                        break;
                    }
                    let behind = share_behind(pair, ahead.at_least(0.0));
                    let parameter = last.u + (sample.u - last.u) * behind.value();
                    let y = last.y + (sample.y - last.y) * behind;
                    self.push_valleys(line, &mut valley, y, laid);
                    self.push_node(line, y, parameter, laid);
                    laid += 1;
                }
                passed += own;
                last = sample;
            }
            if laid == before {
                // Nothing is known of an overlap in which no node lies, nor of its valleys.
                self.nodes.truncate(first);
                while self.samples.valleys.get(valley).is_some_and(|v| v.interval == begin.interval)
                {
                    valley += 1;
                }
                continue;
            }
            self.push_valleys(line, &mut valley, last.y, laid - 1);
            self.push_node(line, last.y, last.u, laid - 1);
            self.link(first);
        }
    }

    /// Whether nodes are ahead of each other.
    pub fn is_skewed(&self) -> bool {
        self.nodes.iter().any(|node| node.place.x != self.nodes[0].place.x)
    }

    /// Adds nodes in the valleys from number `next` on that come before `y`, with the `number` of a node beside them.
    fn push_valleys(
        &mut self,
        line: &mut impl OverlapLine<T>,
        next: &mut usize,
        y: T,
        number: usize,
    ) {
        while let Some(&valley) = self.samples.valleys.get(*next).filter(|valley| valley.y < y) {
            self.push_node(line, valley.y, valley.u, number);
            *next += 1;
        }
    }

    /// Adds the node number `number` at `y`, where the line has about the `parameter`.
    fn push_node(&mut self, line: &mut impl OverlapLine<T>, y: T, parameter: f64, number: usize) {
        let place = line.at(y, parameter);
        let radius = line.section_radius(place.u);
        let (reach, reach_x) = ([y; 2], [place.x; 2]);
        let (cell, neighbours) = (0, [None; 2]);
        self.nodes.push(Node { y, number, place, radius, reach, reach_x, cell, neighbours });
    }

    /// Links the nodes from number `first` on, which are those of one interval, by cells; before and behind them are cells of no width.
    fn link(&mut self, first: usize) {
        let last = self.nodes.len();
        for right in first..=last {
            let nodes =
                [right.checked_sub(1).filter(|&k| k >= first), Some(right).filter(|&k| k < last)];
            let beside = nodes[0].or(nodes[1]).map_or(first, |k| k);
            let [one, other] = [0, 1].map(|side| self.nodes[nodes[side].unwrap_or(beside)]);
            let width = other.y - one.y;
            for (side, node) in nodes.into_iter().enumerate() {
                let Some(k) = node else { continue };
                let beside = [&one, &other][1 - side];
                let node = &mut self.nodes[k];
                if side == 1 {
                    node.cell = self.cells.len();
                }
                node.reach[1 - side] = beside.y;
                node.reach_x[1 - side] = beside.place.x;
                node.neighbours[1 - side] = nodes[1 - side];
            }
            let middle = |a: T, b: T| (a + b) * 0.5;
            self.cells.push(Cell {
                nodes,
                y: middle(one.y, other.y),
                x: middle(one.place.x, other.place.x),
                width,
                tangent: [0, 1].map(|i| middle(one.place.tangent[i], other.place.tangent[i])),
            });
        }
    }
}

impl<T: Real> Cell<T> {
    /// Distance at which all of it would act as it does at the distance `away` of its middle, were its load constant: near a strip of the half length
    /// `length` with the mean of the logarithm, ½∫_-1^1 ln(1 + r t) dt by its series in the ratio r of half its width to the distance, far from it
    /// with that of the reciprocal, which has twice the leading term.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn distance(&self, away: T, length: T) -> T {
        let r = self.width * 0.5 / away;
        let square = away * away;
        let r2 = r * r * (square / (square + length * length) + 1.0);
        away * (-(r2 * (r2 * (r2 * SERIES[2] + SERIES[1]) + SERIES[0])) + 1.0)
    }
}

/// Coefficients of -(r²/6 + r⁴/20 + r⁶/42) taken as the exponent of e.
const SERIES: [f64; 3] = [1.0 / 6.0, 13.0 / 360.0, 737.0 / 45_360.0];
