//! How many nodes there are up to each place.
//!
//! With s = o/δ, δ and b the depth and half the width of the parabola with the same integrals of o²
//! and o³, nodes stand at whole steps of the measure
//!
//! ```text
//! M = (n/A) ∫ hypot(E^(1/4) s dy/∫ s dy, ½ |d(s^(3/2)/E^(5/4))|),   E = 7/6 ∫ s³ dy/∫ s² dy
//! ```
//!
//! where the integrals go over the lobe that a place belongs to, of which E is the height. Of the
//! nodes of an interval those on a pedestal p (`lobes`) come 1 + 2 p times as densely as others, as
//! on ground rails the tops alone carry load. The measure is counted from its mean weighted by s².
//! A is the integral for a parabola, so that a parabola has n nodes; a second lobe has E^(1/4) times
//! as many, however narrow it is and however far away. A lobe grows out of nothing, and two lobes
//! that join have the same nodes before and after.

use std::array::from_fn;

use super::super::line::OverlapLine;
use super::Lattice;
use super::lobes::{self, PLACES};
use super::parabola::Parabola;
use super::sample::{Sample, between, section};
use super::station::{Station, for_pairs};
use crate::math::parabola::{DEPTH_OVER_MEAN, HALF_WIDTH_OVER_INTEGRAL};
use crate::math::real::Real;

/// The integral of the measure for a parabola, n/A apart.
const PARABOLA: f64 = 1.5;
/// How much denser nodes are on a pedestal as deep as the parabola; chosen: 1 to 4 do as well.
const ON_PEDESTAL: f64 = 2.0;
/// Square of that half width over the variance of a place, weighted so.
const SQUARE_OVER_VARIANCE: f64 = 7.0;

impl<T: Real> Lattice<T> {
    /// The parabola of the overlap; false where there is none.
    pub(super) fn size_up(&mut self, line: &mut impl OverlapLine<T>) -> bool {
        let Some(Parabola { depth, half_width, y }) = Parabola::of(&self.stations) else {
            return false;
        };
        let (samples, t) = self.around(y);
        let radius = section(line, samples, t, between(samples[0], samples[1], t).at).radius;
        // Where the wheel stands upright this grows beyond all bounds and comes back from below.
        let radius = if radius.value() < 0.0 { -radius } else { radius };
        (self.depth, self.half_width, self.radius) = (depth, half_width, radius);
        let scale = T::from(1.0) / self.depth;
        for station in self.stations.iter_mut() {
            station.share = station.overlap * scale;
        }
        true
    }

    /// What samples say of the place `y` across.
    pub(super) fn at(&self, y: T) -> Sample<T> {
        let (samples, t) = self.around(y);
        between(samples[0], samples[1], t)
    }

    /// The samples before and behind the place `y` across, and its share of the way between them.
    fn around(&self, y: T) -> ([&Sample<T>; 2], T) {
        let before = self.sample_before(y);
        let [a, b] = [&self.samples[before], &self.samples[before + 1]];
        ([a, b], ((y - a.at.y) / (b.at.y - a.at.y)).within(0.0, 1.0))
    }

    /// Number of the sample before the place `y` across, of an interval that goes on behind it.
    fn sample_before(&self, y: T) -> usize {
        let behind = self.samples.partition_point(|sample| sample.at.y.value() <= y.value());
        let last = behind.clamp(1, self.samples.len() - 1);
        if self.samples[last - 1].interval == self.samples[last].interval { last - 1 } else { last }
    }

    /// Integrals of the overlap, its square and its cube over the lobe of each station, and where
    /// its strips lie.
    fn sum_up_lobes(&mut self) {
        let is_skewed = self.is_skewed();
        let Self { stations, depth, radius, .. } = self;
        for stations in stations.chunks_exact_mut(PLACES) {
            let h = stations[PLACES - 1].y - stations[0].y;
            let from = stations[0].x;
            let shares = from_fn(|k| stations[k].share);
            let places = from_fn(|k| stations[k].x - from);
            let sums = if is_skewed {
                lobes::sums::<T, true>(&shares, &places)
            } else {
                lobes::sums::<T, false>(&shares, &places)
            };
            for (k, station) in stations.iter_mut().enumerate() {
                station.lobe = [0, 1, 2].map(|power| sums[power][k] * h);
                let [_, square, cube, place, place_square, pedestal] =
                    sums.each_ref().map(|sums| sums[k]);
                station.pedestal = pedestal;
                if is_skewed && square.value() > 0.0 {
                    let height = cube / square * DEPTH_OVER_MEAN;
                    let half_width = square * h / (height * height) * HALF_WIDTH_OVER_INTEGRAL;
                    let per_square = T::from(1.0) / (half_width * half_width);
                    let middle = place / square;
                    let variance = (place_square / square - middle * middle).at_least(0.0);
                    let slope_square = variance * per_square * SQUARE_OVER_VARIANCE;
                    let ratio = *depth * height * *radius * 2.0 * per_square;
                    station.centre = from + middle;
                    station.spread = spread(slope_square, ratio);
                }
            }
        }
    }

    /// Whether the line of greatest overlap is not straight across the track.
    fn is_skewed(&self) -> bool {
        let first = self.samples[0].at.x.value().to_bits();
        T::HAS_SLOPES || self.samples.iter().any(|sample| sample.at.x.value().to_bits() != first)
    }

    /// Measures the nodes up to each station.
    pub(super) fn measure(&mut self) {
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
        for stations in self.stations.chunks_exact_mut(PLACES) {
            let (mut number, mut dense) = (zero, zero);
            let mut before = rise(&stations[0]);
            stations[0].measure = zero;
            for k in 1..PLACES {
                let [a, b] = [&stations[k - 1], &stations[k]];
                let here = rise(b);
                let across = (b.y - a.y) * (before[0] + here[0]) * 0.5;
                let step = across.hypotenuse((here[1] - before[1]) * 0.5) * scale;
                number += step;
                dense += step * ((a.pedestal + b.pedestal) * (0.5 * ON_PEDESTAL) + 1.0);
                stations[k].measure = dense;
                before = here;
            }
            // An interval keeps the number of its nodes.
            let share = if dense.value() > 0.0 { number / dense } else { zero };
            for station in stations {
                station.measure = measure + station.measure * share;
            }
            measure += number;
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

    /// The place the share `t` of the measure behind station `k`: a smooth curve over the measure,
    /// which rises with it.
    pub(super) fn between_stations(&self, k: usize, t: T) -> T {
        let [a, b] = [&self.stations[k], &self.stations[k + 1]];
        let (h, step) = (b.y - a.y, b.measure - a.measure);
        let of_interval = |of: &&Station<T>| of.interval == a.interval;
        let before = k.checked_sub(1).map(|k| &self.stations[k]).filter(of_interval);
        let behind = self.stations.get(k + 2).filter(of_interval);
        // The rates at both ends over that of the step: those from one neighbour to the other, where
        // both are of the interval.
        let rate = |from: &Station<T>, to: &Station<T>| {
            (to.y - from.y) * step / ((to.measure - from.measure) * h)
        };
        let (from, to) = (rate(before.unwrap_or(a), b), rate(a, behind.unwrap_or(b)));
        let bend = -(from * 2.0) - to + 3.0;
        a.y + h * (t * (from + t * (bend + t * (from + to - 2.0))))
    }
}

/// How much more a contact ellipse is turned than the line of greatest overlap of its bodies:
/// middles of strips lie further from the middle of the ellipse by this share. Of the square of the
/// slope of that line, and the curvature of the overlap along it, over that along the track.
fn spread<T: Real>(slope_square: T, ratio: T) -> T {
    let root = ratio.sqrt();
    let wide = root + 1.0;
    let turn = (root * (slope_square + wide * wide)).sqrt();
    ratio / (slope_square + 1.0 - root * 0.8 + turn * 1.4)
}
