//! One grid over all overlaps: nodes, and the cells between them, which carry the load.
//!
//! Nodes lie at equal shares of the integral of the curvature of the overlap to the power of 2/5 over all intervals in which the undeformed bodies
//! overlap, by which the squared error of linear interpolation is least on the whole; fewer lie where the overlap is too small to carry load. The ends of the
//! intervals are nodes too. Nothing else is known of intervals: a node that leaves one of them for the next one does so where it is unloaded, with a cell of no width.
//!
//! The load per width is the positive part of a line in a cell. The two cells beside a node act on it from the points of a rule for logarithms, all others from their
//! middles, with the half length that belongs to the load there.

use super::equations::Scales;
use super::line::{OverlapLine, Place};
use super::overlap::End;
use crate::math::real::Real;
use crate::math::room::Room;

/// Parts of an interval of overlap, in each of which the density of nodes is linear: it rises from nothing to its own within a few of them.
const PARTS: usize = 24;
/// Parts between places at which the radius of the wheel is taken, which varies little.
const RADII: usize = 6;
/// Depth of a parabola over the mean of its overlap, weighted by the square of the overlap.
const DEPTH_OVER_MEAN: f64 = 7.0 / 6.0;
/// Half its width over the integral of the square of the overlap over the square of its depth.
const HALF_WIDTH_OVER_INTEGRAL: f64 = 15.0 / 16.0;

/// Overlap over that at the edge of an ellipse at which half of the nodes are left out, as an ellipse does not tell the edge.
const UNLOADED: f64 = 0.6;
/// Power of the squared curvature that nodes are laid by: the squared error of linear interpolation is least on the whole with 2/5 of the curvature.
const DENSITY_POWER: f64 = 0.2;
/// Least overlap over the depth where nodes are laid by it.
const LEAST_OVERLAP: f64 = 1e-3;

/// Share of the nodes wanted where the overlap over the depth is `overlap`, that at the edge of the contact region being near `level`: fewer where no
/// load is to be expected.
fn density<T: Real>(overlap: T, level: T) -> T {
    let beyond = level / overlap * UNLOADED;
    let square = beyond * beyond;
    T::from(1.0) / (square * square + 1.0)
}

/// A node: one unknown load per width.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node<T = f64> {
    /// Coordinate across [m].
    pub y: T,
    /// Its number among the nodes that are not ends of overlaps; these have that of a node beside them.
    pub number: usize,
    pub place: Place<T>,
    /// Radius of the normal section of the wheel along x [m].
    pub radius: T,
    /// Width that its load per width counts with: half of both cells [m].
    pub width: T,
    /// Coordinates of the other ends of its cells, across and along [m].
    pub reach: [T; 2],
    pub reach_x: [T; 2],
    /// Number of the cell before it; the one behind it follows.
    pub cell: usize,
    /// The nodes there; nothing where the overlap ends.
    pub neighbours: [Option<usize>; 2],
}

/// The load between two nodes, or between a node and the end of an overlap.
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
    /// Depth and half width of the parabola with the same integrals of the square and the cube of the overlap, which tell of the place that carries most [m].
    pub depth: T,
    pub half_width: T,
    /// Mean radius of the normal section of the wheel along x, weighted by the square of the overlap [m].
    pub radius: T,
    samples: Room<Sample<T>>,
}

/// One step between samples of the overlap.
#[derive(Clone, Copy, Debug)]
struct Sample<T> {
    /// Number of the interval of overlap.
    interval: usize,
    /// Coordinate across at its beginning, and its width [m].
    y: T,
    step: T,
    /// Parameters of the line at its ends [m].
    parameters: [f64; 2],
    /// Square of the curvature of the overlap [1/m²], and the overlap [m], at its ends.
    curvatures2: [T; 2],
    overlaps: [T; 2],
    /// Nodes wanted at its ends, per length.
    densities: [T; 2],
}

impl<T: Real> Sample<T> {
    /// Nodes wanted in it: their density is linear.
    fn nodes(&self) -> T {
        self.step * (self.densities[0] + self.densities[1]) * 0.5
    }

    /// Share of its width behind which there are as many `nodes`, which are no more than all.
    fn behind(&self, nodes: T) -> T {
        let [first, last] = self.densities;
        let wanted = nodes / self.step * 2.0;
        wanted / (first + (first * first + (last - first) * wanted).at_least(0.0).sqrt())
    }
}

impl<T: Real> Grid<T> {
    /// Room for `nodes` nodes within `intervals` intervals, whose ends are nodes too.
    pub fn new(nodes: usize, intervals: usize) -> Self {
        let zero = T::from(0.0);
        Self {
            nodes: Room::new(nodes + 2 * intervals),
            cells: Room::new(nodes + 3 * intervals),
            depth: zero,
            half_width: zero,
            radius: zero,
            samples: Room::new(intervals * PARTS),
        }
    }

    /// Lays `count` nodes over the intervals of overlap between `ends`, of which there is at least one.
    pub fn lay(&mut self, line: &mut impl OverlapLine<T>, ends: &[[End; 2]], count: usize) {
        self.nodes.clear();
        self.cells.clear();
        self.sample(line, ends);
        // An overlap of the order of rounding, or of numbers that have none.
        let is_size = |x: T| x.value() > 0.0 && x.value().is_finite();
        if ![self.depth, self.half_width, self.radius, self.half_width / self.depth].into_iter().all(is_size) {
            return;
        }
        let level = Scales::new(self).level;
        let depth = self.depth;
        let width: T = self.samples.iter().map(|s| s.step).sum();
        // Where the bodies are parallel there is no curvature to go by.
        let least = depth / (width * width);
        for sample in self.samples.iter_mut() {
            for end in 0..2 {
                let overlap = (sample.overlaps[end] / depth).at_least(LEAST_OVERLAP);
                let bend = (sample.curvatures2[end] + least * least).normal_ln() * DENSITY_POWER;
                sample.densities[end] = bend.exp() * density(overlap, level);
            }
        }
        let total: T = self.samples.iter().map(Sample::nodes).sum();
        let share = total / (count + 1) as f64;
        let mut passed = T::from(0.0);
        let (mut next, mut laid) = (0, 0);
        for interval in 0..ends.len() {
            let begin = next;
            let (first, before) = (self.nodes.len(), laid);
            while next < self.samples.len() && self.samples[next].interval == interval {
                let sample = self.samples[next];
                if next == begin {
                    self.push_node(line, sample.y, sample.parameters[0], laid);
                }
                next += 1;
                let own = sample.nodes();
                while laid < count {
                    let ahead = share * (laid + 1) as f64 - passed;
                    let is_here = ahead < own;
                    // Rounding may leave the last node beyond all samples.
                    if !is_here && next < self.samples.len() {
                        break;
                    }
                    let behind = if is_here { sample.behind(ahead) } else { T::from(1.0) };
                    let [from, to] = sample.parameters;
                    let parameter = from + (to - from) * behind.value();
                    self.push_node(line, sample.y + sample.step * behind, parameter, laid);
                    laid += 1;
                }
                passed += own;
            }
            if laid == before {
                // Nothing is known of an overlap in which no node lies.
                self.nodes.truncate(first);
                continue;
            }
            let last = self.samples[next - 1];
            self.push_node(line, last.y + last.step, last.parameters[1], laid - 1);
            self.link(first);
        }
    }

    /// Takes the curvatures of all intervals, their depth, their area and their radius.
    fn sample(&mut self, line: &mut impl OverlapLine<T>, ends: &[[End; 2]]) {
        self.samples.clear();
        let zero = T::from(0.0);
        let (mut squares, mut cubes, mut radii) = (zero, zero, [zero; 2]);
        for (interval, pair) in ends.iter().enumerate() {
            let [left, right] = [pair[0].moving(line), pair[1].moving(line)];
            let rate = (pair[1].u - pair[0].u) / (pair[1].y - pair[0].y);
            let parameter = |y: f64| pair[0].u + rate * (y - pair[0].y);
            let step = (right - left) * (1.0 / PARTS as f64);
            let y = |k: usize| left + step * k as f64;
            let mut overlaps = [zero; PARTS + 1];
            for (k, overlap) in overlaps.iter_mut().enumerate() {
                let place = line.at(y(k), parameter(y(k).value()));
                // Simpson's rule.
                let weight = if k == 0 || k == PARTS { 1.0 } else { 2.0 + 2.0 * (k % 2) as f64 };
                let depth = place.overlap.at_least(0.0);
                let share = step * depth * depth * (weight / 3.0);
                *overlap = place.overlap;
                squares += share;
                cubes += share * depth;
                if k % RADII == 0 {
                    let weight = if k == 0 || k == PARTS { 0.5 } else { 1.0 };
                    let share = step * depth * depth * (weight * RADII as f64);
                    radii = [radii[0] + share * line.section_radius(place.u), radii[1] + share];
                }
            }
            let curvature2 = |k: usize| {
                let k = k.clamp(1, PARTS - 1);
                let bend = (overlaps[k - 1] - overlaps[k] * 2.0 + overlaps[k + 1]) / (step * step);
                bend * bend
            };
            for k in 0..PARTS {
                self.samples.push(Sample {
                    interval,
                    y: y(k),
                    step,
                    parameters: [k, k + 1].map(|k| parameter(y(k).value())),
                    curvatures2: [k, k + 1].map(curvature2),
                    overlaps: [overlaps[k], overlaps[k + 1]],
                    densities: [zero; 2],
                });
            }
        }
        self.radius = radii[0] / radii[1];
        self.depth = cubes / squares * DEPTH_OVER_MEAN;
        self.half_width = squares / (self.depth * self.depth) * HALF_WIDTH_OVER_INTEGRAL;
    }

    /// Whether nodes are ahead of each other.
    pub fn is_skewed(&self) -> bool {
        self.nodes.iter().any(|node| node.place.x != self.nodes[0].place.x)
    }

    /// Adds the node number `number` at `y`, where the line has about the `parameter`.
    fn push_node(&mut self, line: &mut impl OverlapLine<T>, y: T, parameter: f64, number: usize) {
        let place = line.at(y, parameter);
        let radius = line.section_radius(place.u);
        let (width, reach, reach_x) = (T::from(0.0), [y; 2], [place.x; 2]);
        let (cell, neighbours) = (0, [None; 2]);
        self.nodes.push(Node { y, number, place, radius, width, reach, reach_x, cell, neighbours });
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
                node.width += width * 0.5;
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
