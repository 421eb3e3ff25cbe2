//! Where the nodes stand, and what is to be known of each.
//!
//! The overlap o is taken at steps of every interval in which the bodies overlap, with its slope,
//! and is a cubic between two of them; a step is halved until the place in its middle agrees. With
//! s = o/δ, δ and b the depth and half the width of the parabola with the same integrals of o² and
//! o³, nodes stand at whole steps of the measure
//!
//! ```text
//! M = n/A ∫ E^(1/4) hypot(s dy/∫ s dy, ½ |d(s^(3/2)/E^(3/2))|),   E = 7/6 ∫ s³ dy/∫ s² dy
//! ```
//!
//! where the integrals go over the lobe that a place belongs to. What is another lobe is not decided:
//! all places of the interval count, but those behind a valley the less the deeper it is, by the
//! eighth power of the least s on the way over the lower one of s at both ends of it. Behind a valley
//! of three quarters it is a tenth.
//!
//! The measure is counted from its mean weighted by s². A is the integral for a parabola, so that a
//! parabola has n nodes; a second lobe has E^(1/4) times as many, however narrow it is and however far
//! away. All of that is continuous in the pose: a lobe grows out of nothing, two lobes that join have
//! the same nodes before and after, and nodes come and go at the ends of overlaps, where they carry
//! nothing.

use super::line::{LinePlace, OverlapLine};
use super::overlap::{End, MAX_OVERLAPS, Overlaps};
use super::scales::Scales;
use crate::math::fixed_vec::FixedVec;
use crate::math::real::Real;

/// Steps in each interval in which the overlap is taken at first, and how often one is halved at
/// most: a millimetre of a rail down to a hundredth of it.
const STEPS: usize = 8;
const MAX_HALVINGS: f64 = 6.0;
/// Most places of all intervals at which the overlap is taken.
const MAX_SAMPLES: usize = 1024;
/// Integral that a step may be wrong by over the depth times the width of a parabola of the same
/// width and slopes at its ends: from there to twice as much the halves of the step come in.
const SAMPLE_ERROR: f64 = 1e-6;
/// Steps in each interval for the measure.
const STATIONS: usize = 32;
/// The integral of the measure for a parabola, n/A apart.
const PARABOLA: f64 = 1.5;
/// Width of a hat beyond the end of its overlap over that of the overlap: no hat is without width.
const OVERHANG: f64 = 0.01;
/// Depth of a parabola over the mean of its overlap, weighted by the square of the overlap.
const DEPTH_OVER_MEAN: f64 = 7.0 / 6.0;
/// Half its width over the integral of the square of the overlap over the square of its depth.
const HALF_WIDTH_OVER_INTEGRAL: f64 = 15.0 / 16.0;

/// A place at which the overlap is taken.
#[derive(Clone, Copy, Debug)]
struct Sample<T> {
    at: LinePlace<T>,
    /// Number of the interval of overlap.
    interval: usize,
    /// Derivatives of the overlap and of the parameter by the coordinate across, before and behind
    /// the place: only where the line folds they are two [-].
    slope: [T; 2],
    rate: [T; 2],
    /// Integral of the overlap from the first place of the interval on, and the integral of that
    /// [m², m³].
    integrals: [T; 2],
}

/// A place up to which nodes are measured; those of an interval are equally far apart.
#[derive(Clone, Copy, Debug)]
struct Station<T> {
    /// Coordinate across [m], and number of the sample before it.
    y: T,
    sample: usize,
    /// Number of the interval of overlap.
    interval: usize,
    /// Overlap, not below zero [m]; that over the depth of the parabola [-].
    overlap: T,
    share: T,
    /// Integrals of its square and its cube over the lobe [m].
    lobe: [T; 3],
    /// Measure of the nodes up to here [-].
    measure: T,
}

/// A node: one unknown load per width, which is linear between nodes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node<T = f64> {
    /// Parameter of the line [m].
    pub u: T,
    /// Coordinates across and along the track [m].
    pub y: T,
    pub x: T,
    /// Unit tangent (y, z) across.
    pub tangent: [T; 2],
    /// How far its hat reaches to either side, > 0 [m].
    pub reach: [T; 2],
    /// Integral of its hat [m].
    pub width: T,
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
pub(super) struct Lattice<T = f64> {
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

/// Value and both integrals of the cubic between two samples at the share `t` of the way.
fn cubic<T: Real>(a: &Sample<T>, b: &Sample<T>, t: T) -> [T; 3] {
    let h = b.at.y - a.at.y;
    let (rise, [d0, d1]) = (b.at.overlap - a.at.overlap, [a.slope[1] * h, b.slope[0] * h]);
    let (c0, c1, c2, c3) = (a.at.overlap, d0, rise * 3.0 - d0 * 2.0 - d1, d0 + d1 - rise * 2.0);
    let value = c0 + t * (c1 + t * (c2 + t * c3));
    let first = t * (c0 + t * (c1 * 0.5 + t * (c2 * (1.0 / 3.0) + t * c3 * 0.25)));
    let second =
        t * t * (c0 * 0.5 + t * (c1 * (1.0 / 6.0) + t * (c2 * (1.0 / 12.0) + t * c3 * 0.05)));
    let [one, two] = a.integrals;
    [value, one + h * first, two + h * (t * one + h * second)]
}

/// What two samples say of the place at the share `t` of the way: overlap and parameter of the line
/// are cubics.
fn between<T: Real>(a: &Sample<T>, b: &Sample<T>, t: T) -> Sample<T> {
    let (h, rise) = (b.at.y - a.at.y, b.at.u - a.at.u);
    let rates = [a.rate[1] * h, b.rate[0] * h];
    let bend = rise * 3.0 - rates[0] * 2.0 - rates[1];
    let turn = rates[0] + rates[1] - rise * 2.0;
    let u = a.at.u + t * (rates[0] + t * (bend + t * turn));
    let rate = (rates[0] + t * (bend * 2.0 + t * turn * 3.0)) / h;
    let [overlap, one, two] = cubic(a, b, t);
    let secant = (b.at.overlap - a.at.overlap) / h;
    let [from, to] = [a.slope[1], b.slope[0]];
    let slope =
        from + t * (secant * 6.0 - from * 4.0 - to * 2.0 + t * ((from + to - secant * 2.0) * 3.0));
    let mix = |a: T, b: T| a + (b - a) * t;
    let (x, y) = (mix(a.at.x, b.at.x), mix(a.at.y, b.at.y));
    let tangent = [0, 1].map(|axis| mix(a.at.tangent[axis], b.at.tangent[axis]));
    let at = LinePlace { u, y, overlap, x, tangent, ..a.at };
    Sample { at, interval: a.interval, slope: [slope; 2], rate: [rate; 2], integrals: [one, two] }
}

impl<T: Real> Sample<T> {
    /// This one, `weight` of the way towards another one of the same place across.
    fn towards(&self, other: &Self, weight: T) -> Self {
        let mix = |a: T, b: T| a + (b - a) * weight;
        let (a, b) = (&self.at, &other.at);
        let both = |a: [T; 2], b: [T; 2]| [mix(a[0], b[0]), mix(a[1], b[1])];
        let at = LinePlace {
            u: mix(a.u, b.u),
            overlap: mix(a.overlap, b.overlap),
            x: mix(a.x, b.x),
            tangent: both(a.tangent, b.tangent),
            ..*b
        };
        let (slope, rate) = (both(self.slope, other.slope), both(self.rate, other.rate));
        Self { at, slope, rate, ..*other }
    }
}

impl<T: Real> Lattice<T> {
    /// Room for problems whose parabola has `wanted` nodes, and for `most` nodes at most.
    pub fn new(wanted: usize, most: usize) -> Self {
        let zero = T::from(0.0);
        Self {
            nodes: FixedVec::new(most),
            samples: FixedVec::new(MAX_SAMPLES),
            stations: FixedVec::new((STATIONS + 1) * MAX_OVERLAPS),
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
    /// [1/m]; nothing between nodes of two overlaps.
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
        let mut sum = parts[i] / nodes[i].width;
        for (tie, other) in [(i, i.wrapping_sub(1)), (i + 1, i + 1)] {
            if other < nodes.len() {
                let share = self.tie(tie);
                sum += (parts[other] - parts[i] * nodes[other].width / nodes[i].width) * share;
            }
        }
        sum
    }

    /// Lays nodes over all `overlaps`; leaves none where there is no overlap beyond rounding.
    pub fn lay(&mut self, line: &mut impl OverlapLine<T>, overlaps: &Overlaps) {
        self.nodes.clear();
        self.samples.clear();
        self.stations.clear();
        for (interval, ends) in overlaps.intervals.iter().enumerate() {
            self.sample(line, interval, ends);
        }
        if self.size_up(line) {
            self.scales = Scales::new(self.depth, self.half_width, self.radius);
            self.measure();
            self.place_nodes(line);
        }
    }

    /// Takes the overlap in one interval.
    fn sample(&mut self, line: &mut impl OverlapLine<T>, interval: usize, ends: &[End; 2]) {
        let zero = T::from(0.0);
        let [from, to] = [0, 1].map(|side| ends[side].moving(line));
        let mut take = |u: T, is_end: bool| {
            let mut at = line.place(u);
            // Where an overlap ends there is none, to rounding: its powers would feel that.
            if is_end {
                at.overlap = zero;
            }
            let rate = T::from(1.0) / at.dy;
            let (slope, rate) = ([at.overlap_slope * rate; 2], [rate; 2]);
            Sample { at, interval, slope, rate, integrals: [zero; 2] }
        };
        // Beyond the last interval there is no room for.
        if self.samples.len() + 2 * STEPS >= self.samples.capacity() {
            return;
        }
        let first = self.samples.len();
        let ends_taken = [take(from, ends[0].is_free), take(to, ends[1].is_free)];
        let width = ends_taken[1].at.y - ends_taken[0].at.y;
        let slopes = ends_taken[0].slope[1].abs() + ends_taken[1].slope[0].abs();
        let most = width * width * slopes * (SAMPLE_ERROR / 8.0);
        self.samples.push(ends_taken[0]);
        self.is_folded = false;
        for k in 1..=STEPS {
            let share = k as f64 / STEPS as f64;
            let to =
                if k < STEPS { take(from + (to - from) * share, false) } else { ends_taken[1] };
            self.go_to(&mut take, to, most, [T::from(1.0), T::from(MAX_HALVINGS)]);
        }
        let [low, high] = [self.samples[first].at.y, self.samples[self.samples.len() - 1].at.y];
        if self.samples.len() - first < 2 {
            self.samples.truncate(first);
            return;
        }
        let mut sample = first;
        for k in 0..=STATIONS {
            let y = low + (high - low) * (k as f64 / STATIONS as f64);
            while sample + 2 < self.samples.len() && self.samples[sample + 1].at.y <= y {
                sample += 1;
            }
            let [a, b] = [&self.samples[sample], &self.samples[sample + 1]];
            let t = (y - a.at.y) / (b.at.y - a.at.y);
            let overlap = if (k == 0 && ends[0].is_free) || (k == STATIONS && ends[1].is_free) {
                zero
            } else {
                cubic(a, b, t)[0].at_least(0.0)
            };
            let (share, lobe, measure) = (zero, [zero; 3], zero);
            self.stations.push(Station { y, sample, interval, overlap, share, lobe, measure });
        }
    }

    /// Takes the places up to `to`, the step halved up to `halvings` times. What the place in its
    /// middle says beside what both ends say has the weight `weight`, so that places come and go
    /// without a jump.
    fn go_to(
        &mut self,
        take: &mut impl FnMut(T, bool) -> Sample<T>,
        to: Sample<T>,
        most: T,
        [weight, halvings]: [T; 2],
    ) {
        let from = self.samples[self.samples.len() - 1];
        let found = take((from.at.u + to.at.u) * 0.5, false);
        let h = to.at.y - from.at.y;
        let expected = between(&from, &to, (found.at.y - from.at.y) / h);
        let middle = expected.towards(&found, weight);
        let error = (expected.at.overlap - found.at.overlap).abs() * h / most - 1.0;
        let has_room = self.samples.len() + 2 * STEPS < self.samples.capacity();
        if error > 0.0 && halvings > 0.0 && has_room {
            let error = error.at_most(1.0);
            let weight = weight * error * error * (error * -2.0 + 3.0);
            let halves = [weight, halvings - 1.0];
            self.go_to(take, middle, most, halves);
            self.go_to(take, to, most, halves);
        } else {
            self.push(middle);
            self.push(to);
        }
    }

    /// Adds a sample with the integrals up to it. Where the line folds, what lies behind is passed
    /// over, straight.
    fn push(&mut self, mut sample: Sample<T>) {
        let last = self.samples.len() - 1;
        let before = &mut self.samples[last];
        if sample.at.y.value() <= before.at.y.value() {
            self.is_folded = true;
            return;
        }
        if self.is_folded {
            self.is_folded = false;
            let h = sample.at.y - before.at.y;
            let slope = (sample.at.overlap - before.at.overlap) / h;
            let rate = (sample.at.u - before.at.u) / h;
            (before.slope[1], before.rate[1]) = (slope, rate);
            (sample.slope[0], sample.rate[0]) = (slope, rate);
        }
        let [_, one, two] = cubic(before, &sample, T::from(1.0));
        sample.integrals = [one, two];
        self.samples.push(sample);
    }

    /// The parabola of the overlap; false where there is none.
    fn size_up(&mut self, line: &mut impl OverlapLine<T>) -> bool {
        let zero = T::from(0.0);
        let (mut square, mut cube, mut place) = (zero, zero, zero);
        for_pairs(&self.stations, |a, b| {
            let h = (b.y - a.y) * 0.5;
            for station in [a, b] {
                let weight = h * station.overlap * station.overlap;
                square += weight;
                cube += weight * station.overlap;
                place += weight * station.y;
            }
        });
        if !(square.value().is_normal() && cube.value().is_normal()) {
            return false;
        }
        self.depth = cube / square * DEPTH_OVER_MEAN;
        self.half_width = square / (self.depth * self.depth) * HALF_WIDTH_OVER_INTEGRAL;
        let middle = self.sample_before(place / square);
        let [a, b] = [&self.samples[middle], &self.samples[middle + 1]];
        let t = ((place / square - a.at.y) / (b.at.y - a.at.y)).within(0.0, 1.0);
        self.radius = line.radius(between(a, b, t).at.u);
        let scale = T::from(1.0) / self.depth;
        for station in self.stations.iter_mut() {
            station.share = station.overlap * scale;
        }
        true
    }

    /// Number of the sample before the place `y` across, of an interval that goes on behind it.
    fn sample_before(&self, y: T) -> usize {
        let behind = self.samples.partition_point(|sample| sample.at.y.value() <= y.value());
        let last = behind.clamp(1, self.samples.len() - 1);
        if self.samples[last - 1].interval == self.samples[last].interval { last - 1 } else { last }
    }

    /// Integrals of the overlap, its square and its cube over the lobe of each station: of what lies
    /// behind a valley the less the deeper the valley is.
    fn sum_up_lobes(&mut self) {
        let add = |station: &mut Station<T>, share: T, weight: T| {
            let mut part = weight;
            for sum in &mut station.lobe {
                part *= share;
                *sum += part;
            }
        };
        for stations in self.stations.chunks_exact_mut(STATIONS + 1) {
            let h = stations[1].y - stations[0].y;
            for one in 0..stations.len() {
                let own = stations[one].share;
                if own.value() <= 0.0 {
                    continue;
                }
                add(&mut stations[one], own, h);
                let mut least = own;
                for other in one + 1..stations.len() {
                    let share = stations[other].share;
                    if share.value() <= 0.0 {
                        break;
                    }
                    least = least.min(share);
                    let lower = own.min(share);
                    let mut weight = h;
                    if least < lower {
                        let dip = least / lower;
                        let fourth = (dip * dip) * (dip * dip);
                        weight *= fourth * fourth;
                    }
                    add(&mut stations[one], share, weight);
                    add(&mut stations[other], own, weight);
                }
            }
        }
    }

    /// Measures the nodes up to each station.
    fn measure(&mut self) {
        let zero = T::from(0.0);
        self.sum_up_lobes();
        // s over the area of the lobe times E^(1/4), and s^(3/2)/E^(5/4).
        let rise = |station: &Station<T>| {
            let [area, square, cube] = station.lobe;
            if station.share > 0.0 && square > 0.0 {
                let height = cube / square * DEPTH_OVER_MEAN;
                let root = height.sqrt().sqrt();
                [
                    station.share / area * root,
                    station.share * station.share.sqrt() / (height * root),
                ]
            } else {
                [zero; 2]
            }
        };
        let mut measure = zero;
        let scale = self.wanted as f64 / PARABOLA;
        let mut before = self.stations.first().map_or([zero; 2], rise);
        for k in 0..self.stations.len() {
            let here = rise(&self.stations[k]);
            if k > 0 && self.stations[k].interval == self.stations[k - 1].interval {
                let [a, b] = [&self.stations[k - 1], &self.stations[k]];
                let across = (b.y - a.y) * (before[0] + here[0]) * 0.5;
                measure += across.hypot((here[1] - before[1]) * 0.5) * scale;
            }
            self.stations[k].measure = measure;
            before = here;
        }
        // As many as there is room for.
        let most = (self.nodes.capacity() - 1) as f64;
        if measure > most {
            let less = T::from(most) / measure;
            for station in self.stations.iter_mut() {
                station.measure *= less;
            }
            measure = T::from(most);
        }
        let (mut sum, mut weight) = (zero, zero);
        for_pairs(&self.stations, |a, b| {
            let h = b.y - a.y;
            for station in [a, b] {
                let own = h * station.share * station.share;
                weight += own;
                sum += own * station.measure;
            }
        });
        let mean = sum / weight;
        self.extent = [-mean, measure - mean];
    }

    /// Places the nodes at whole steps of the measure.
    fn place_nodes(&mut self, line: &mut impl OverlapLine<T>) {
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
                let mut sample = a.sample;
                while sample < b.sample && self.samples[sample + 1].at.y <= y {
                    sample += 1;
                }
                let [a, b] = [self.samples[sample], self.samples[sample + 1]];
                let t = ((y - a.at.y) / (b.at.y - a.at.y)).within(0.0, 1.0);
                self.place_node(line, &a, &b, t, number);
            }
            number += 1.0;
        }
        self.spread_hats();
    }

    /// The place the share `t` of the measure behind station `k`: a smooth curve over the measure,
    /// which rises with it.
    fn between_stations(&self, k: usize, t: T) -> T {
        let [a, b] = [&self.stations[k], &self.stations[k + 1]];
        let (h, step) = (b.y - a.y, b.measure - a.measure);
        // Twice the way from one neighbour to the other, where both are of the interval.
        let slope = |before: Option<&Station<T>>, behind: Option<&Station<T>>| {
            let measure = |of: Option<&Station<T>>, end: &Station<T>, other: T| {
                of.filter(|of| of.interval == a.interval)
                    .map_or(other, |of| of.measure - end.measure)
            };
            let (back, ahead) = (measure(before, a, -step), measure(behind, b, step));
            [step * 2.0 / (step - back), step * 2.0 / (step + ahead)]
        };
        let before = k.checked_sub(1).map(|before| &self.stations[before]);
        let [from, to] = slope(before, self.stations.get(k + 2));
        let bend = -(from * 2.0) - to + 3.0;
        a.y + h * (t * (from + t * (bend + t * (from + to - 2.0))))
    }

    fn place_node(
        &mut self,
        line: &mut impl OverlapLine<T>,
        a: &Sample<T>,
        b: &Sample<T>,
        t: T,
        number: f64,
    ) {
        let h = b.at.y - a.at.y;
        let Sample { at, integrals, .. } = between(a, b, t);
        let LinePlace { u, y, x, tangent, overlap: depth, .. } = at;
        let length = (tangent[0] * tangent[0] + tangent[1] * tangent[1]).sqrt();
        self.integrals.push(integrals);
        self.nodes.push(Node {
            u,
            y,
            x,
            tangent: tangent.map(|component| component / length),
            reach: [h; 2],
            width: h,
            depth,
            overlap: depth,
            radius: line.radius(u),
            number,
            interval: a.interval,
        });
    }

    /// Gives each node its hat and the mean of the overlap over it.
    fn spread_hats(&mut self) {
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
            let overhang = (last.at.y - first.at.y) * OVERHANG;
            for i in begin..end {
                let y = self.nodes[i].y;
                let [one, two] = self.integrals[i];
                // Integral of the overlap times the hat to either side, by parts.
                let (left, before) = if i > begin {
                    let left = y - self.nodes[i - 1].y;
                    (left, one - (two - self.integrals[i - 1][1]) / left)
                } else {
                    let inside = y - first.at.y;
                    let left = inside + overhang;
                    (left, one - two / left)
                };
                let (right, behind) = if i + 1 < end {
                    let right = self.nodes[i + 1].y - y;
                    (right, (self.integrals[i + 1][1] - two) / right - one)
                } else {
                    let inside = last.at.y - y;
                    let right = inside + overhang;
                    let [all, twice] = last.integrals;
                    (right, (twice - two) / right - one + all * (overhang / right))
                };
                let node = &mut self.nodes[i];
                node.reach = [left, right];
                node.width = (left + right) * 0.5;
                node.overlap = (before + behind) / node.width;
            }
        }
    }
}

/// Calls `each` with every two neighbouring stations of one interval.
fn for_pairs<T: Real>(stations: &[Station<T>], mut each: impl FnMut(&Station<T>, &Station<T>)) {
    for pair in stations.windows(2) {
        if pair[0].interval == pair[1].interval {
            each(&pair[0], &pair[1]);
        }
    }
}
