//! The overlap at places across, and how many nodes are wanted there.
//!
//! Nodes are wanted by the curvature of the overlap to the power of 2/5, by which the squared error of linear interpolation is least on the whole, and fewer where the
//! overlap is too small to carry load. Curvatures are second differences between places that stand still on the rail, so that the density is one of the place alone:
//! where two intervals of overlap join, nodes stay where they are.

use super::equations::Scales;
use super::line::{OverlapLine, Place};
use super::overlap::{End, MOST_OVERLAPS};
use crate::math::real::Real;
use crate::math::room::Room;

/// Parts of an interval of overlap: those that Simpson's rule for its integrals takes, and the fewest by which the density is taken.
const PARTS: usize = 24;
/// Parts between places at which the radius of the wheel is taken, which varies little.
const RADII: usize = 6;
/// Distance between the places that curvatures are taken by, about that of points in measured profiles [m]; and the greatest number of them, beyond which it is
/// doubled.
const SPACING: f64 = 5e-4;
const MOST_BENDS: usize = 256;

/// Depth of a parabola over the mean of its overlap, weighted by the square of the overlap.
const DEPTH_OVER_MEAN: f64 = 7.0 / 6.0;
/// Half its width over the integral of the square of the overlap over the square of its depth.
const HALF_WIDTH_OVER_INTEGRAL: f64 = 15.0 / 16.0;
/// Overlap over that at the edge of an ellipse at which half of the nodes are left out, as an ellipse does not tell the edge.
const UNLOADED: f64 = 0.6;
/// Power of the squared curvature that nodes are laid by.
const DENSITY_POWER: f64 = 0.2;
/// Least overlap over the depth where nodes are laid by it.
const LEAST_OVERLAP: f64 = 1e-3;

/// Share of the nodes wanted where the overlap over the depth is `overlap`, that at the edge of the contact region being near `level`: fewer where no
/// load is to be expected.
fn share_loaded<T: Real>(overlap: T, level: T) -> T {
    let beyond = level / overlap * UNLOADED;
    let square = beyond * beyond;
    T::from(1.0) / (square * square + 1.0)
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
    /// Overlap [m], and the square of its curvature [1/m²].
    overlap: T,
    bend2: T,
    /// Nodes wanted per length.
    density: T,
}

/// Nodes wanted between two samples, their density being linear.
pub(super) fn nodes_between<T: Real>([a, b]: [&Sample<T>; 2]) -> T {
    (b.y - a.y) * (a.density + b.density) * 0.5
}

/// Share of the way between two samples behind which there are as many `nodes`, which are no more than all.
pub(super) fn share_behind<T: Real>([a, b]: [&Sample<T>; 2], nodes: T) -> T {
    let (first, last) = (a.density, b.density);
    let wanted = nodes / (b.y - a.y) * 2.0;
    wanted / (first + (first * first + (last - first) * wanted).at_least(0.0).sqrt())
}

/// Samples of all overlaps, by their coordinates.
#[derive(Clone, Debug)]
pub(super) struct Samples<T = f64> {
    pub list: Room<Sample<T>>,
    /// Depth and half width of the parabola with the same integrals of the square and the cube of the overlap, which tell of the place that carries most [m].
    pub depth: T,
    pub half_width: T,
    /// Mean radius of the normal section of the wheel along x, weighted by the square of the overlap [m].
    pub radius: T,
    /// Overlaps at the places that stand still beside and within the interval under way; the number of the first.
    still: Room<Place<T>>,
    first: f64,
    spacing: f64,
}

impl<T: Real> Samples<T> {
    pub fn new() -> Self {
        let zero = T::from(0.0);
        Self {
            list: Room::new(MOST_OVERLAPS * (PARTS + 1) + MOST_BENDS),
            depth: zero,
            half_width: zero,
            radius: zero,
            still: Room::new(MOST_BENDS + 4),
            first: 0.0,
            spacing: SPACING,
        }
    }

    /// Takes the intervals of overlap between `ends`; false where there is nothing but rounding, or no numbers.
    pub fn take(&mut self, line: &mut impl OverlapLine<T>, ends: &[[End; 2]]) -> bool {
        self.list.clear();
        let zero = T::from(0.0);
        let (mut squares, mut cubes, mut radii) = (zero, zero, [zero; 2]);
        let width: f64 = ends.iter().map(|[left, right]| right.y - left.y).sum();
        self.spacing = SPACING;
        while width > self.spacing * MOST_BENDS as f64 {
            self.spacing *= 2.0;
        }
        for (interval, [one, other]) in ends.iter().enumerate() {
            let [left, right] = [one.moving(line), other.moving(line)];
            let rate = (other.u - one.u) / (other.y - one.y);
            let parameter = |y: f64| one.u + rate * (y - one.y);
            self.take_still(line, [one.y, other.y], parameter);
            let step = (right - left) * (1.0 / PARTS as f64);
            let mut next = (one.y / self.spacing).floor() + 1.0;
            for k in 0..=PARTS {
                let y = left + step * k as f64;
                while next * self.spacing < y.value() {
                    let place = self.still[(next - self.first) as usize];
                    self.push(interval, T::from(next * self.spacing), place);
                    next += 1.0;
                }
                let place = line.at(y, parameter(y.value()));
                self.push(interval, y, place);
                // Simpson's rule.
                let weight = if k == 0 || k == PARTS { 1.0 } else { 2.0 + 2.0 * (k % 2) as f64 };
                let depth = place.overlap.at_least(0.0);
                let share = step * depth * depth * (weight / 3.0);
                squares += share;
                cubes += share * depth;
                if k % RADII == 0 {
                    let weight = if k == 0 || k == PARTS { 0.5 } else { 1.0 };
                    let share = step * depth * depth * (weight * RADII as f64);
                    radii = [radii[0] + share * line.section_radius(place.u), radii[1] + share];
                }
            }
        }
        self.radius = radii[0] / radii[1];
        self.depth = cubes / squares * DEPTH_OVER_MEAN;
        self.half_width = squares / (self.depth * self.depth) * HALF_WIDTH_OVER_INTEGRAL;
        let is_size = |x: T| x.value() > 0.0 && x.value().is_finite();
        [self.depth, self.half_width, self.radius, self.half_width / self.depth]
            .into_iter()
            .all(is_size)
    }

    /// Takes the places that stand still between two coordinates, and two on both sides.
    fn take_still(
        &mut self,
        line: &mut impl OverlapLine<T>,
        [left, right]: [f64; 2],
        parameter: impl Fn(f64) -> f64,
    ) {
        self.still.clear();
        self.first = (left / self.spacing).floor() - 1.0;
        let count = (right / self.spacing).floor() + 2.0 - self.first;
        for k in 0..=count as usize {
            let y = (self.first + k as f64) * self.spacing;
            self.still.push(line.at(T::from(y), parameter(y)));
        }
    }

    /// Adds a place of an interval.
    fn push(&mut self, interval: usize, y: T, place: Place<T>) {
        let at = y / self.spacing - self.first;
        // Rounding may leave an end on the other side of a place that stands still.
        let k = (at.value() as usize).clamp(1, self.still.len() - 3);
        let bend = |k: usize| {
            let [a, b, c] = [k - 1, k, k + 1].map(|k| self.still[k].overlap);
            (a - b * 2.0 + c) / (self.spacing * self.spacing)
        };
        let (one, other) = (bend(k), bend(k + 1));
        let bend = one + (other - one) * (at - k as f64);
        self.list.push(Sample {
            interval,
            y,
            u: place.u.value(),
            overlap: place.overlap,
            bend2: bend * bend,
            density: T::from(0.0),
        });
    }

    /// Takes the density of nodes, for an ellipse of some `scales`; returns the number that it makes.
    pub fn lay(&mut self, scales: &Scales<T>) -> T {
        let depth = self.depth;
        let width = self.sum_of(|[a, b]| b.y - a.y);
        // Where the bodies are parallel there is no curvature to go by.
        let least = depth / (width * width);
        for sample in self.list.iter_mut() {
            let overlap = (sample.overlap / depth).at_least(LEAST_OVERLAP);
            let bend = (sample.bend2 + least * least).normal_ln() * DENSITY_POWER;
            sample.density = bend.exp() * share_loaded(overlap, scales.level);
        }
        self.sum_of(nodes_between)
    }

    /// Sum over all pairs of neighbours of an interval.
    fn sum_of(&self, of: impl Fn([&Sample<T>; 2]) -> T) -> T {
        let pairs = self.list.windows(2).filter(|pair| pair[0].interval == pair[1].interval);
        pairs.map(|pair| of([&pair[0], &pair[1]])).sum()
    }
}
