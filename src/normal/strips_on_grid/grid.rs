//! One grid over all overlaps: nodes, and the cells between them, which carry the load.
//!
//! Nodes lie at equal shares of the integral of the curvature of the overlap to the power of 2/5
//! over all intervals in which the undeformed bodies overlap, by which the squared error of linear
//! interpolation is least on the whole; fewer lie where the overlap is too small to carry load. The
//! ends of the intervals are nodes too, and another node stands between each two of them. Where
//! intervals join, three nodes become one, which stays in the valley between the lobes of the
//! overlap and goes over to the others as the valley is filled: so the places of all nodes are
//! continuous in the pose. A node that goes from one interval to the next one does so where it is
//! unloaded, with a cell of no width.
//!
//! The load per width is the positive part of a line in a cell. The two cells beside a node act on
//! it from the points of a rule for logarithms, all others from their middles, with the half length
//! that belongs to the load there.

use super::line::{OverlapLine, Place};
use super::overlap::{MAX_OVERLAPS, Overlaps};
use super::samples::{Samples, nodes_between, share_behind};
use super::scales::Scales;
use super::shape::{Between, Knots};
use super::valleys::MAX_VALLEYS;
use crate::math::fixed_vec::FixedVec;
use crate::math::real::Real;

/// A node: one unknown load per width.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node<T = f64> {
    /// Coordinate across [m].
    pub y: T,
    /// Where it is between the knots.
    pub between: Between<T>,
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
    pub nodes: FixedVec<Node<T>>,
    pub cells: FixedVec<Cell<T>>,
    pub samples: Samples<T>,
}

impl<T: Real> Grid<T> {
    /// Room for `nodes` nodes; the ends of overlaps are nodes too, and there is one more for each
    /// gap and each valley between lobes.
    pub fn new(nodes: usize) -> Self {
        let nodes = nodes + 2 * MAX_OVERLAPS + MAX_VALLEYS;
        Self {
            nodes: FixedVec::new(nodes),
            cells: FixedVec::new(nodes + MAX_OVERLAPS),
            samples: Samples::new(),
        }
    }

    /// Lays nodes over all `overlaps`, of which there is at least one: as many as the `knots` are
    /// for, and those of gaps and valleys.
    pub fn lay(&mut self, line: &mut impl OverlapLine<T>, overlaps: &Overlaps, knots: &Knots) {
        self.nodes.clear();
        self.cells.clear();
        // An overlap of the order of rounding, or of numbers that have none.
        if !self.samples.take(line, overlaps) {
            return;
        }
        let level = Scales::new(&self.samples).level;
        let wanted = self.samples.lay(level);
        if !(wanted.value() > 0.0 && wanted.value().is_finite()) {
            return;
        }
        let share = wanted / (knots.nodes() + 1) as f64;
        let standing: T = self.samples.list.iter().map(|sample| sample.standing).sum();
        let count = ((knots.nodes() + 1) as f64 + standing.value()).ceil() as usize - 1;
        // Nodes passed with those that stand, nodes passed without them, and nodes laid.
        let (mut passed, mut own) = (T::from(0.0), T::from(0.0));
        let (mut next, mut laid) = (0, 0);
        while next < self.samples.list.len() {
            let (first, before) = (self.nodes.len(), laid);
            let begin = self.samples.list[next];
            self.push_node(line, begin.y, begin.u, knots.between(own));
            let mut last = begin;
            loop {
                while laid < count && T::from((laid + 1) as f64) < passed + last.standing {
                    self.push_node(line, last.y, last.u, knots.between(own));
                    laid += 1;
                }
                passed += last.standing;
                next += 1;
                let following = self.samples.list.get(next);
                let Some(&sample) = following.filter(|s| s.interval == begin.interval) else {
                    break;
                };
                let pair = [&last, &sample];
                let between = nodes_between(pair) / share;
                while laid < count {
                    let ahead = (T::from((laid + 1) as f64) - passed).at_least(0.0);
                    if ahead >= between {
                        break;
                    }
                    let behind = share_behind(pair, ahead * share);
                    let parameter = last.u + (sample.u - last.u) * behind.value();
                    let y = last.y + (sample.y - last.y) * behind;
                    self.push_node(line, y, parameter, knots.between(own + ahead));
                    laid += 1;
                }
                passed += between;
                own += between;
                last = sample;
            }
            if laid == before {
                // Nothing is known of an overlap in which no node lies.
                self.nodes.truncate(first);
                continue;
            }
            self.push_node(line, last.y, last.u, knots.between(own));
            self.link(first);
        }
    }

    /// Whether nodes are ahead of each other.
    pub fn is_skewed(&self) -> bool {
        self.nodes.iter().any(|node| node.place.x != self.nodes[0].place.x)
    }

    /// Adds a node at `y`, which is `between` knots, where the line has about the `parameter`.
    fn push_node(
        &mut self,
        line: &mut impl OverlapLine<T>,
        y: T,
        parameter: f64,
        between: Between<T>,
    ) {
        let place = line.at(y, parameter);
        let radius = line.section_radius(place.u);
        let (reach, reach_x) = ([y; 2], [place.x; 2]);
        let (cell, neighbours) = (0, [None; 2]);
        self.nodes.push(Node { y, between, place, radius, reach, reach_x, cell, neighbours });
    }

    /// Links the nodes from number `first` on, which are those of one interval, by cells; before
    /// and behind them are cells of no width.
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
    /// Distance at which all of it would act as it does at the distance `away` of its middle, were
    /// its load constant: near a strip of the half length `length` with the mean of the logarithm,
    /// ½∫_-1^1 ln(1 + r t) dt by its series in the ratio r of half its width to the distance, far
    /// from it with that of the reciprocal, which has twice the leading term.
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
