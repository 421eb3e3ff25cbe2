//! Where the nodes stand, and what is to be known of each.
//!
//! The overlap is taken along every interval in which the bodies overlap (`sample`), a parabola with
//! the same moments gives it its size (`parabola`), the nodes are measured out on it (`measure`,
//! `lobes`), and each gets its hat and the mean of the overlap over it. All of that is continuous in the pose: nodes come and go at the ends of overlaps, where they
//! carry nothing.

mod lobes;
mod measure;
mod parabola;
mod sample;
mod station;
mod steps;

use super::line::{LinePlace, OverlapLine, Section};
use super::overlap::{MAX_OVERLAPS, Overlaps};
use super::scales::Scales;
use crate::math::fixed_vec::FixedVec;
use crate::math::real::Real;
use lobes::PLACES;
use sample::{MAX_SAMPLES, Sample, between, section};
use station::Station;

/// Width of a hat beyond the end of its overlap where the node stands on that, over that of the
/// overlap: no hat is without width. It shrinks as the node goes inside, to nothing three times as
/// far: what stands there when the next node comes in ends where that one comes.
const OVERHANG: f64 = 0.01;

/// Share of a node's own load in the mean of a load that is linear between nodes over its hat.
const INNER_SHARE: f64 = 2.0 / 3.0;

/// A node: one unknown load per width, which is linear between nodes.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Node<T = f64> {
    /// Parameter of the line [m].
    pub u: T,
    /// Coordinates across and along the track, the latter of the middle of the strip, and how far
    /// that is from the line of greatest overlap [m].
    pub y: T,
    pub x: T,
    pub off: T,
    /// Unit tangent (y, z) across.
    pub tangent: [T; 2],
    /// How far its hat reaches to either side, > 0 [m].
    pub reach: [T; 2],
    /// Integral of its hat [m].
    pub width: T,
    /// Share of its own load in the mean over its hat [-].
    pub own_share: T,
    /// Overlap at the node, and its mean over the hat [m].
    pub depth: T,
    pub overlap: T,
    /// Radius of the normal section of the wheel along x [m].
    pub radius: T,
    /// Number of steps of the measure from its mean [-].
    pub number: f64,
    /// Number of the interval of overlap.
    pub interval: usize,
}

/// Nodes of one problem, and the parabola that their overlap is measured by.
#[derive(Clone, Debug)]
pub(in super::super) struct Lattice<T = f64> {
    pub nodes: FixedVec<Node<T>>,
    samples: FixedVec<Sample<T>>,
    stations: FixedVec<Station<T>>,
    /// Whether the line goes back from the last sample on.
    is_folded: bool,
    /// Integrals of the overlap up to each node [m², m³].
    integrals: FixedVec<[T; 2]>,
    /// Depth and half width of the parabola with the same integrals of the square and the cube of
    /// the overlap [m].
    pub depth: T,
    pub half_width: T,
    /// Radius of the normal section along x in the middle of the square of the overlap [m].
    pub radius: T,
    /// Sizes of the ellipse of that parabola.
    pub scales: Scales<T>,
    /// Steps of the measure from its mean to either end [-].
    pub extent: [T; 2],
    /// Nodes of a parabola.
    pub wanted: usize,
}

impl<T: Real> Lattice<T> {
    /// Room for problems whose parabola has `wanted` nodes, and for `most` nodes at most.
    pub fn new(wanted: usize, most: usize) -> Self {
        let zero = T::from(0.0);
        Self {
            nodes: FixedVec::new(most),
            samples: FixedVec::new(MAX_SAMPLES),
            stations: FixedVec::new(PLACES * MAX_OVERLAPS),
            is_folded: false,
            integrals: FixedVec::new(most),
            depth: zero,
            half_width: zero,
            radius: zero,
            scales: Scales::default(),
            extent: [zero; 2],
            wanted,
        }
    }

    /// What the hats of nodes `i` - 1 and `i` have in common in a mean over hats, over both widths
    /// [1/m]; nothing between nodes of two overlaps, nor at their ends, where there is no load.
    pub fn tie(&self, i: usize) -> T {
        let nodes = &self.nodes;
        if i == 0 || i == nodes.len() || nodes[i - 1].interval != nodes[i].interval {
            return T::from(0.0);
        }
        nodes[i].reach[0] / (nodes[i].width * nodes[i - 1].width * 6.0)
    }

    /// Mean over the hat of node `i` of what has the integrals `parts` over the hats.
    pub fn mean_over_hats(&self, i: usize, parts: &[T]) -> T {
        let nodes = &self.nodes;
        let mut sum = parts[i] * nodes[i].own_share / nodes[i].width;
        for (tie, other) in [(i, i.wrapping_sub(1)), (i + 1, i + 1)] {
            if other < nodes.len() {
                sum += parts[other] * self.tie(tie);
            }
        }
        sum
    }

    /// Takes the overlap of all `overlaps`, without nodes.
    pub fn take(&mut self, line: &mut impl OverlapLine<T>, overlaps: &Overlaps) {
        self.nodes.clear();
        self.samples.clear();
        self.stations.clear();
        for (interval, ends) in overlaps.intervals.iter().enumerate() {
            self.sample(line, interval, ends);
        }
    }

    /// Lays nodes over all `overlaps`; leaves none where there is no overlap beyond rounding.
    pub fn lay(&mut self, line: &mut impl OverlapLine<T>, overlaps: &Overlaps) {
        self.take(line, overlaps);
        if self.size_up(line) {
            self.scales = Scales::new(self.depth, self.half_width, self.radius);
            self.measure();
            self.place_nodes(line, overlaps);
        }
    }

    /// Places the nodes at whole steps of the measure.
    fn place_nodes(&mut self, line: &mut impl OverlapLine<T>, overlaps: &Overlaps) {
        self.integrals.clear();
        let [low, high] = self.extent;
        let mean = -low;
        let mut k = 0;
        let mut number = low.value().ceil();
        while number <= high.value() && self.nodes.len() < self.nodes.capacity() {
            let target = mean + number;
            while k + 2 < self.stations.len() && self.stations[k + 1].measure <= target {
                k += 1;
            }
            let [a, b] = [self.stations[k], self.stations[k + 1]];
            let step = b.measure - a.measure;
            if a.interval == b.interval && step > 0.0 {
                let t = ((target - a.measure) / step).within(0.0, 1.0);
                let y = self.between_stations(k, t);
                let part = (y - a.y) / (b.y - a.y);
                let lobe = [[a.centre, b.centre], [a.spread, b.spread]];
                let lobe = lobe.map(|[a, b]| a + (b - a) * part);
                let mut sample = a.sample;
                while sample < b.sample && self.samples[sample + 1].at.y <= y {
                    sample += 1;
                }
                let [a, b] = [self.samples[sample], self.samples[sample + 1]];
                let t = ((y - a.at.y) / (b.at.y - a.at.y)).within(0.0, 1.0);
                self.place_node(line, [&a, &b], t, lobe, number);
            }
            number += 1.0;
        }
        self.spread_hats(overlaps);
    }

    fn place_node(
        &mut self,
        line: &mut impl OverlapLine<T>,
        [a, b]: [&Sample<T>; 2],
        t: T,
        [centre, spread]: [T; 2],
        number: f64,
    ) {
        let h = b.at.y - a.at.y;
        let Sample { at, integrals, .. } = between(a, b, t);
        let LinePlace { u, y, x, tangent, overlap: depth, .. } = at;
        let length = (tangent[0] * tangent[0] + tangent[1] * tangent[1]).sqrt();
        self.integrals.push(integrals);
        let Section { radius, ahead, less } = section(line, [a, b], t, at);
        // Off the line of greatest overlap there is less of it.
        let off = (x - centre) * spread;
        let less = less + off * off * 0.5 / radius;
        self.nodes.push(Node {
            u,
            y,
            x: x + ahead + off,
            off,
            tangent: tangent.map(|component| component / length),
            reach: [h; 2],
            width: h,
            own_share: INNER_SHARE.into(),
            depth: depth - less,
            overlap: less,
            radius,
            number,
            interval: a.interval,
        });
    }

    /// Gives each node its hat and the mean of the overlap over it.
    fn spread_hats(&mut self, overlaps: &Overlaps) {
        let mut end = 0;
        while end < self.nodes.len() {
            let (begin, interval) = (end, self.nodes[end].interval);
            while end < self.nodes.len() && self.nodes[end].interval == interval {
                end += 1;
            }
            let of_interval = |sample: &&Sample<T>| sample.interval == interval;
            let first = self.samples.iter().find(of_interval).copied();
            let last = self.samples.iter().rev().find(of_interval).copied();
            let (Some(first), Some(last)) = (first, last) else { return };
            let most = (last.at.y - first.at.y) * OVERHANG;
            let overhang = |inside: T| {
                let rest = (-inside / (most * 3.0) + 1.0).at_least(0.0);
                most * (rest * rest * rest)
            };
            for i in begin..end {
                let y = self.nodes[i].y;
                let [one, two] = self.integrals[i];
                // Integral of the overlap times the hat to either side, by parts.
                let (left, before) = if i > begin {
                    let left = y - self.nodes[i - 1].y;
                    (left, one - (two - self.integrals[i - 1][1]) / left)
                } else {
                    let inside = y - first.at.y;
                    let left = inside + overhang(inside);
                    (left, one - two / left)
                };
                let (right, behind) = if i + 1 < end {
                    let right = self.nodes[i + 1].y - y;
                    (right, (self.integrals[i + 1][1] - two) / right - one)
                } else {
                    let inside = last.at.y - y;
                    let beyond = overhang(inside);
                    let right = inside + beyond;
                    let [all, twice] = last.integrals;
                    (right, (twice - two) / right - one + all * (beyond / right))
                };
                let node = &mut self.nodes[i];
                node.reach = [left, right];
                node.width = (left + right) * 0.5;
                node.overlap = (before + behind) / node.width - node.overlap;
                // Where a body ends what goes beyond stays with the node.
                let [start, stop] = overlaps.intervals[interval];
                for (is_last, reach) in
                    [(i == begin && !start.is_free, left), (i + 1 == end && !stop.is_free, right)]
                {
                    if is_last {
                        node.own_share += reach / (node.width * 6.0);
                    }
                }
            }
        }
    }
}
