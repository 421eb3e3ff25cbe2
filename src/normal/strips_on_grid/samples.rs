//! The overlap at places across, and how many nodes are wanted there.
//!
//! Nodes are wanted by the curvature of the overlap to the power of 2/5, by which the squared error
//! of linear interpolation is least on the whole, and fewer where the overlap is too small to carry
//! load. The overlap is taken at equal distances from the middle of all overlaps, with parabolas in
//! between, whatever belongs to which interval: where two of them join, nodes stay where they are.

use super::line::OverlapLine;
use super::overlap::{End, MAX_OVERLAPS, Overlaps};
use super::turns::turns;
use super::valleys::{MAX_VALLEYS, Valley};
use crate::math::fixed_vec::FixedVec;
use crate::math::real::Real;

/// Distance between the places that the overlap is taken at, over the width of all overlaps; and
/// how far they are apart at most, about as far as points in measured profiles, but in that many
/// places at most.
const SPACING: f64 = 1.0 / 24.0;
const MAX_SPACING: f64 = 5e-4;
const MAX_PLACES: usize = 256;
/// Parts between two of them, in each of which the density is linear.
const PARTS: usize = 6;
/// Most samples of all overlaps.
const MAX_SAMPLES: usize = (MAX_PLACES + 3 * MAX_OVERLAPS) * PARTS + MAX_VALLEYS;

/// Depth of a parabola over the mean of its overlap, weighted by the square of the overlap.
const DEPTH_OVER_MEAN: f64 = 7.0 / 6.0;
/// Half its width over the integral of the square of the overlap over the square of its depth.
const HALF_WIDTH_OVER_INTEGRAL: f64 = 15.0 / 16.0;
/// Overlap over that at the edge of an ellipse at which half of the nodes are left out: edges may
/// lie farther out than an ellipse tells.
const UNLOADED: f64 = 0.9;
/// Power of the squared curvature that nodes are laid by.
const DENSITY_POWER: f64 = 0.2;
/// Least overlap over the depth where nodes are laid by it.
const MIN_OVERLAP: f64 = 1e-3;

/// Share of the nodes wanted where the overlap over the depth is `overlap`, that at the edge of an
/// ellipse being `level`: fewer where no load is to be expected.
fn share_loaded<T: Real>(overlap: T, level: T) -> T {
    let beyond = level / overlap * UNLOADED;
    T::from(1.0) / (beyond * beyond + 1.0)
}

/// A place in an overlap.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample<T> {
    /// Number of the interval of overlap.
    pub interval: usize,
    /// Coordinate across [m].
    pub y: T,
    /// Parameter of the line [m].
    pub u: f64,
    /// Overlap [m], and its second derivative [1/m].
    overlap: T,
    bend: T,
    /// Nodes wanted per length.
    density: T,
    /// Nodes that stand here: one between lobes.
    pub standing: T,
}

impl<T: Real> Sample<T> {
    /// At a share of the way to an `other` one, where no node stands: a parabola, whose bend is
    /// that in the middle.
    fn towards(&self, other: &Self, share: T) -> Self {
        let mix = |a: T, b: T| a + (b - a) * share;
        let width = other.y - self.y;
        let bulge = width * width * (self.bend + other.bend) * (share * 0.25 * (-share + 1.0));
        Self {
            interval: self.interval,
            y: self.y + width * share,
            u: self.u + (other.u - self.u) * share.value(),
            overlap: mix(self.overlap, other.overlap) - bulge,
            bend: mix(self.bend, other.bend),
            density: self.density,
            standing: T::from(0.0),
        }
    }
}

/// Nodes wanted between two samples, their density being linear.
pub(super) fn nodes_between<T: Real>([a, b]: [&Sample<T>; 2]) -> T {
    (b.y - a.y) * (a.density + b.density) * 0.5
}

/// Share of the way between two samples behind which there are as many `nodes`, which are no more
/// than all.
pub(super) fn share_behind<T: Real>([a, b]: [&Sample<T>; 2], nodes: T) -> T {
    let (first, last) = (a.density, b.density);
    let wanted = nodes / (b.y - a.y) * 2.0;
    wanted / (first + (first * first + (last - first) * wanted).at_least(0.0).sqrt())
}

/// Samples of all overlaps, by their coordinates.
#[derive(Clone, Debug)]
pub(super) struct Samples<T = f64> {
    pub list: FixedVec<Sample<T>>,
    pub valleys: FixedVec<Valley<T>>,
    /// Depth and half width of the parabola with the same integrals of the square and the cube of
    /// the overlap, which tell of the place that carries most [m].
    pub depth: T,
    pub half_width: T,
    /// Radius of the normal section of the wheel along x in the middle of the square of the overlap
    /// [m].
    pub radius: T,
    /// Ends of the intervals of overlap [m].
    ends: FixedVec<[T; 2]>,
    /// Overlaps at the places within the interval under way and beside it.
    places: FixedVec<T>,
    /// Integrals of the square and the cube of the overlap up to each sample [m^3, m^4].
    integrals: FixedVec<[T; 2]>,
}

impl<T: Real> Samples<T> {
    pub fn new() -> Self {
        let zero = T::from(0.0);
        Self {
            list: FixedVec::new(MAX_SAMPLES),
            valleys: FixedVec::new(MAX_VALLEYS),
            depth: zero,
            half_width: zero,
            radius: zero,
            ends: FixedVec::new(MAX_OVERLAPS),
            places: FixedVec::new(MAX_PLACES + 4),
            integrals: FixedVec::new(MAX_SAMPLES),
        }
    }

    /// Takes the overlaps; false where there is nothing but rounding, or no numbers.
    pub fn take(&mut self, line: &mut impl OverlapLine<T>, overlaps: &Overlaps) -> bool {
        self.list.clear();
        self.valleys.clear();
        self.ends.clear();
        let intervals = &overlaps.intervals;
        self.ends.extend(intervals.iter().map(|pair| [0, 1].map(|end| pair[end].moving(line))));
        let width: T = self.ends.iter().map(|&[left, right]| right - left).sum();
        let middle =
            self.ends.iter().map(|&[left, right]| (right - left) * (left + right)).sum::<T>() * 0.5
                / width;
        let spacing = (width * SPACING).at_most(MAX_SPACING).max(width * (1.0 / MAX_PLACES as f64));
        // Not in the middle itself, or the ends of a single interval would be places too, on this
        // side or that by rounding.
        for (interval, ends) in intervals.iter().enumerate() {
            self.take_interval(line, interval, ends, [middle + spacing * 0.5, spacing]);
        }
        let zero = T::from(0.0);
        let [mut squares, mut cubes, mut moment, mut parameter] = [zero; 4];
        for pair in self.list.windows(2).filter(|pair| pair[0].interval == pair[1].interval) {
            let width = pair[1].y - pair[0].y;
            let middle = pair[0].towards(&pair[1], T::from(0.5));
            // Simpson's rule.
            for (sample, weight) in [(&pair[0], 1.0), (&middle, 4.0), (&pair[1], 1.0)] {
                let depth = sample.overlap.at_least(0.0);
                let square = width * depth * depth * (weight / 6.0);
                squares += square;
                cubes += square * depth;
                moment += square * sample.y;
                parameter += square * sample.u;
            }
        }
        self.depth = cubes / squares * DEPTH_OVER_MEAN;
        self.half_width = squares / (self.depth * self.depth) * HALF_WIDTH_OVER_INTEGRAL;
        if !(squares.value() > 0.0 && squares.value().is_finite()) {
            return false;
        }
        let middle = line.at(moment / squares, (parameter / squares).value());
        self.radius = line.section_radius(middle.u);
        let is_size = |x: T| x.value() > 0.0 && x.value().is_finite();
        [self.depth, self.half_width, self.radius, self.half_width / self.depth]
            .into_iter()
            .all(is_size)
    }

    /// Takes the interval of a number between its ends.
    fn take_interval(
        &mut self,
        line: &mut impl OverlapLine<T>,
        interval: usize,
        [one, other]: &[End; 2],
        [origin, spacing]: [T; 2],
    ) {
        let rate = (other.u - one.u) / (other.y - one.y);
        let parameter = |y: f64| one.u + rate * (y - one.y);
        let [left, right] = self.ends[interval];
        let number = |y: T| ((y - origin) / spacing).value().floor();
        // Two places beyond both ends.
        let first = number(left) - 1.0;
        let count = (number(right) + 3.0 - first) as usize;
        let place = |k: usize| origin + spacing * (first + k as f64);
        self.places.clear();
        for k in 0..count {
            let y = place(k);
            self.places.push(line.at(y, parameter(y.value())).overlap);
        }
        let places = &self.places;
        let bend_at =
            |k: usize| (places[k - 1] - places[k] * 2.0 + places[k + 1]) / (spacing * spacing);
        let density = T::from(0.0);
        let mut end = |end: &End, y: T, k: usize| {
            let (before, behind) = (bend_at(k), bend_at(k + 1));
            let bend = before + (behind - before) * ((y - place(k)) / spacing);
            // A body may end before the overlap does.
            let overlap =
                if end.slope.is_some() { T::from(0.0) } else { line.at(y, end.u).overlap };
            Sample { interval, y, u: end.u, overlap, bend, density, standing: density }
        };
        let (begin, last) = (end(one, left, 1), end(other, right, count - 3));
        self.list.push(begin);
        for k in 2..count - 2 {
            let y = place(k);
            let (overlap, bend) = (places[k], bend_at(k));
            self.list.push(Sample {
                interval,
                y,
                u: parameter(y.value()),
                overlap,
                bend,
                density,
                standing: density,
            });
        }
        self.list.push(last);
        self.take_valleys(interval, [begin.overlap, last.overlap], place);
    }

    /// Takes the valleys of the interval of a number with overlaps at its ends, whose `places` are
    /// there.
    fn take_valleys(
        &mut self,
        interval: usize,
        [mut peak, last]: [T; 2],
        place: impl Fn(usize) -> T,
    ) {
        let [left, right] = self.ends[interval];
        let spacing = place(1) - place(0);
        let mut valley: Option<Valley<T>> = None;
        for k in 1..self.places.len() - 2 {
            let around = [0, 1, 2, 3].map(|i| self.places[k - 1 + i]);
            for turn in turns(around).into_iter().flatten() {
                let y = place(k) + spacing * turn.share;
                if !(y > left && y < right) {
                    continue;
                }
                if !turn.is_valley {
                    peak = peak.max(turn.height);
                    continue;
                }
                self.end_valley(valley, peak);
                let standing = T::from(0.0);
                valley = Some(Valley { interval, y, overlap: turn.height, peak, standing });
                peak = turn.height;
            }
        }
        self.end_valley(valley, peak.max(last));
    }

    /// Takes a valley, if there is one, behind which is a `peak` [m].
    fn end_valley(&mut self, valley: Option<Valley<T>>, peak: T) {
        if let Some(valley) = valley.filter(|_| self.valleys.len() < MAX_VALLEYS) {
            self.valleys.push(Valley { peak: peak.min(valley.peak), ..valley });
        }
    }

    /// Takes the density of nodes, the `level` being the overlap at the edge of an ellipse over its
    /// depth; returns the number that it makes.
    pub fn lay(&mut self, level: T) -> T {
        self.part();
        self.integrate();
        let width = self.sum_of(|[a, b]| b.y - a.y);
        // Where the bodies are parallel there is no curvature to go by.
        let least = self.depth / (width * width);
        let mut window = [0; 2];
        for k in 0..self.list.len() {
            let sample = self.list[k];
            let near = self.depth_near(sample.y, &mut window);
            let overlap = (sample.overlap / near).at_least(MIN_OVERLAP);
            let square = sample.bend * sample.bend + least * least;
            let bend = (square.normal_ln() * DENSITY_POWER).exp();
            // Where the overlap is less deep there are fewer, by the root of its depth besides its
            // width: less depends on it.
            self.list[k].density = bend * share_loaded(overlap, level) * (near / self.depth).sqrt();
        }
        self.stand_in_valleys(level);
        self.stand_beside_gaps();
        self.sum_of(nodes_between)
    }

    /// Takes the integrals of the square and the cube of the overlap up to each sample.
    fn integrate(&mut self) {
        self.integrals.clear();
        let mut sums = [T::from(0.0); 2];
        for (k, sample) in self.list.iter().enumerate() {
            let before = k.checked_sub(1).map(|k| &self.list[k]);
            if let Some(before) = before.filter(|before| before.interval == sample.interval) {
                let half = (sample.y - before.y) * 0.5;
                let [a, b] = [before, sample].map(|sample| sample.overlap.at_least(0.0));
                sums[0] += half * (a * a + b * b);
                sums[1] += half * (a * a * a + b * b * b);
            }
            self.integrals.push(sums);
        }
    }

    /// Depth of the parabola with the integrals of the overlap within the half width to both sides
    /// of coordinate `y`; the samples at which such a `window` begins and ends are near those of
    /// the last one, which lay before [m].
    fn depth_near(&self, y: T, window: &mut [usize; 2]) -> T {
        let [begin, end] = [-self.half_width, self.half_width].map(|way| y + way);
        let last = self.list.len() - 1;
        let up_to = |y: T, k: &mut usize| {
            while *k < last && self.list[*k + 1].y <= y {
                *k += 1;
            }
            let here = &self.list[*k];
            if *k == last || y <= here.y {
                return self.integrals[*k];
            }
            let share = (y - here.y) / (self.list[*k + 1].y - here.y);
            let [from, to] = [self.integrals[*k], self.integrals[*k + 1]];
            [0, 1].map(|n| from[n] + (to[n] - from[n]) * share)
        };
        let [first, second] = window;
        let (from, to) = (up_to(begin, first), up_to(end, second));
        let [squares, cubes] = [0, 1].map(|n| (to[n] - from[n]).at_least(f64::MIN_POSITIVE));
        cubes / squares * DEPTH_OVER_MEAN
    }

    /// Nodes stand in valleys, the `level` being the overlap at the edge of an ellipse over its
    /// depth; the density does not change there.
    fn stand_in_valleys(&mut self, level: T) {
        let mut window = [0; 2];
        for k in 0..self.valleys.len() {
            let near = self.depth_near(self.valleys[k].y, &mut window);
            self.valleys[k].stand(level * near);
        }
        let mut k = 1;
        for &Valley { interval, y, standing, .. } in self.valleys.iter() {
            while self.list[k].interval < interval || self.list[k].y <= y {
                k += 1;
            }
            let [before, behind] = [self.list[k - 1], self.list[k]];
            let share = (y - before.y) / (behind.y - before.y);
            let density = before.density + (behind.density - before.density) * share;
            self.list.insert(k, Sample { density, standing, ..before.towards(&behind, share) });
        }
    }

    /// Half a node stands at each of the two ends beside a gap between intervals.
    fn stand_beside_gaps(&mut self) {
        for k in 1..self.list.len() {
            if self.list[k - 1].interval != self.list[k].interval {
                let half = T::from(0.5);
                (self.list[k - 1].standing, self.list[k].standing) = (half, half);
            }
        }
    }

    /// Puts samples of parabolas between all samples.
    fn part(&mut self) {
        let before = self.list.len();
        let any = self.list[0];
        self.list.resize(before * PARTS, any);
        for k in (0..before).rev() {
            let one = self.list[k];
            let other = if k + 1 < before { self.list[(k + 1) * PARTS] } else { one };
            for part in 0..PARTS {
                // Behind the last sample of an interval there is nothing.
                let share = part as f64 / PARTS as f64;
                self.list[k * PARTS + part] = if other.interval == one.interval {
                    one.towards(&other, T::from(share))
                } else {
                    one
                };
            }
        }
    }

    /// Sum over all pairs of neighbours of an interval.
    fn sum_of(&self, of: impl Fn([&Sample<T>; 2]) -> T) -> T {
        let pairs = self.list.windows(2).filter(|pair| pair[0].interval == pair[1].interval);
        pairs.map(|pair| of([&pair[0], &pair[1]])).sum()
    }
}
