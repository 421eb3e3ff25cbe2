//! Faint ridges: where the least ridge of the overlap comes or goes, one lobe goes over into two.
//!
//! A ridge that is hardly there parts no lobes. Between two shares of the overlap beside it the problem is solved without the least ridge and
//! with it, and the strips of the latter get pressures and half lengths between those of both: to the accuracy of so many strips the
//! two are the same, but what they differ by would be a jump of the force.

use std::f64::consts::{FRAC_PI_2, PI};

use super::Line;
use super::cell::{Cell, TERMS};
use super::nodes::Lobe;
use super::rule::legendre;
use super::solver::{LEAST_SHARE, MOST_LOBES, StripSolver};
use crate::math::smooth_step::smooth_step;

/// Share from which a ridge parts lobes for good.
const CLEAR_SHARE: f64 = 0.08;

/// Least width of a lobe that is cut off from a solution, share of its zone.
const LEAST_WIDTH: f64 = 0.02;

/// How much of a solution with a ridge of the given share counts, beside that without.
pub(super) fn weight(share: f64) -> f64 {
    smooth_step(((share - LEAST_SHARE) / (CLEAR_SHARE - LEAST_SHARE)).clamp(0.0, 1.0))
}

/// A lobe of the solution without the ridge.
#[derive(Clone, Copy, Debug)]
struct Kept {
    edges: [f64; 2],
    met: [bool; 2],
    shape: [f64; TERMS],
    /// Sum of width, half length and pressure over π E* of its strips [m³].
    load: f64,
    /// Parameters of its outermost strips [m].
    near: [f64; 2],
}

/// The solution without the least ridge.
#[derive(Clone, Debug, Default)]
pub(super) struct WithoutRidge {
    lobes: Vec<Kept>,
    /// Ratios of all nodes [-].
    pub ratio: Vec<f64>,
}

impl WithoutRidge {
    /// Room for so many nodes.
    pub fn with_capacity(nodes: usize) -> Self {
        Self { lobes: Vec::with_capacity(MOST_LOBES), ratio: Vec::with_capacity(nodes) }
    }

    /// Ends of the zone that begins with lobe `first`, and its last lobe.
    fn zone(&self, first: usize) -> Option<([f64; 2], usize)> {
        let begin = self.lobes.get(first)?;
        let last = (first..self.lobes.len()).find(|&k| !self.lobes[k].met[1])?;
        Some(([begin.edges[0], self.lobes[last].edges[1]], last))
    }
}

impl StripSolver {
    /// Keeps a solution without the least ridge.
    pub(super) fn keep_without_ridge(&mut self) {
        let Self { without_ridge, lobes, cells, nodes, .. } = self;
        without_ridge.lobes.clear();
        let n = self.rule.count();
        without_ridge.lobes.extend(lobes.iter().map(|lobe| {
            let cell = &cells[lobe.cell];
            let load = (lobe.first..lobe.first + n)
                .map(|i| nodes.width[i] * nodes.half_length[i] * nodes.pressure[i])
                .sum();
            let near = [nodes.u[lobe.first], nodes.u[lobe.first + n - 1]];
            Kept { edges: cell.edges, met: cell.met, shape: cell.shape, load, near }
        }));
        without_ridge.ratio.clear();
        without_ridge.ratio.extend_from_slice(&nodes.ratio);
    }

    /// Mixes the solution, which has `weight`, with that without the least ridge; as it is where the two have not the same zones.
    pub(super) fn mix_without_ridge(&mut self, line: &mut impl Line, weight: f64) {
        let n = self.rule.count();
        // Zone by zone: first and last lobe, ends, here and there.
        let mut zones = [([0; 2], [0.0; 2], [0; 2], [0.0; 2]); MOST_LOBES];
        let (mut count, mut first, mut other) = (0, 0, 0);
        while first < self.lobes.len() {
            let mut last = first;
            while self.cells[self.lobes[last].cell].met[1] {
                last += 1;
            }
            let here = [self.lobes[first].cell, self.lobes[last].cell];
            let here = [self.cells[here[0]].edges[0], self.cells[here[1]].edges[1]];
            let Some((there, last_other)) = self.without_ridge.zone(other) else { return };
            if there[0] >= here[1] || there[1] <= here[0] {
                return;
            }
            zones[count] = ([first, last], here, [other, last_other], there);
            (count, first, other) = (count + 1, last + 1, last_other + 1);
        }
        if other != self.without_ridge.lobes.len() {
            return;
        }
        let between = |with: f64, without: f64| weight * with + (1.0 - weight) * without;
        self.nodes.spare.clear();
        for &([first, last], here, [other, last_other], there) in &zones[..count] {
            let scale = (there[1] - there[0]) / (here[1] - here[0]);
            let over = |y: f64| there[0] + scale * (y - here[0]);
            // Where the pressure has a narrow peak, other strips have another sum of it: the load is that of the solution.
            let kept = &self.without_ridge.lobes[other..=last_other];
            let load: f64 = kept.iter().map(|lobe| lobe.load).sum();
            let mut of_strips = 0.0;
            self.apart.nodes.clear();
            for i in first * n..(last + 1) * n {
                let [pressure, per_length] =
                    self.pressure_without_ridge(other, over(self.nodes.y[i]));
                let half_length = pressure * self.nodes.radius[i] * per_length;
                of_strips += scale * self.nodes.width[i] * half_length * pressure;
                self.apart.nodes.push([pressure, half_length]);
            }
            let evened = if of_strips > 0.0 { load / of_strips } else { 1.0 };
            for number in first..=last {
                for i in number * n..(number + 1) * n {
                    let [pressure, half_length] = self.apart.nodes[i - first * n];
                    let pressure = evened * pressure;
                    self.nodes.pressure[i] = between(self.nodes.pressure[i], pressure);
                    let least = self.nodes.half_length[i];
                    self.nodes.spare.push(between(least, half_length));
                }
                let cell = &mut self.cells[self.lobes[number].cell];
                cell.edges = cell.edges.map(|y| between(y, over(y)));
                cell.load_ends = cell.edges;
            }
        }
        std::mem::swap(&mut self.nodes.half_length, &mut self.nodes.spare);
        self.place_mixed(line);
    }

    /// Begins with the solution without the least ridge, its zones cut at all ridges with joints there; false where that leaves a
    /// lobe of no width.
    pub(super) fn begin_from_without_ridge(&mut self, line: &mut impl Line) -> bool {
        self.bound_cells(line);
        let mut zones = [0; MOST_LOBES];
        let (mut count, mut first) = (0, 0);
        while let Some(([left, right], last)) = self.without_ridge.zone(first) {
            let near = [first, last].map(|k| self.without_ridge.lobes[k].near);
            let least = LEAST_WIDTH * (right - left);
            for i in 0..self.cells.len() {
                let cell = &mut self.cells[i];
                let edges = [cell.bounds[0].max(left), cell.bounds[1].min(right)];
                let width = edges[1] - edges[0];
                if width <= 0.0 {
                    continue;
                }
                if width < least || count == MOST_LOBES || cell.active {
                    return false;
                }
                cell.active = true;
                cell.edges = edges;
                cell.met = [cell.bounds[0] > left, cell.bounds[1] < right];
                let start = if cell.met[0] { cell.range[0] } else { near[0][0] };
                let end = if cell.met[1] { cell.range[1] } else { near[1][1] };
                (cell.near, cell.start_width) = ([start, end], width);
                zones[count] = first;
                count += 1;
            }
            first = last + 1;
        }
        self.gather();
        for (number, zone) in zones.into_iter().enumerate().take(self.lobes.len()) {
            self.take_from_without_ridge(number, zone);
        }
        count > 0
    }

    /// Gives the lobe `number` the pressures and half lengths that are there in the zone that begins with lobe `zone` without the ridge.
    fn take_from_without_ridge(&mut self, number: usize, zone: usize) {
        let Lobe { cell, first } = self.lobes[number];
        let Cell { edges: [left, right], met, .. } = self.cells[cell];
        let mut shape = [0.0; TERMS];
        let mut greatest = 0.0f64;
        for (t, abscissa) in self.rule.nodes.iter().enumerate() {
            let y = 0.5 * (left + right + (right - left) * abscissa);
            let [pressure, per_length] = self.pressure_without_ridge(zone, y);
            let root = |side: usize| if met[side] { 1.0 } else { self.rule.roots[t][side] };
            let ratio = pressure / (root(0) * root(1));
            self.nodes.ratio[first + t] = ratio;
            greatest = greatest.max(ratio);
            // The projection on each polynomial.
            let exponent = -(per_length / (2.0 * PI)).ln();
            let terms = shape.iter_mut().zip(self.rule.legendre[t]).take(self.rule.terms);
            for (degree, (term, polynomial)) in terms.enumerate() {
                *term += (degree as f64 + 0.5) * self.rule.weights[t] * exponent * polynomial;
            }
        }
        let cell = &mut self.cells[cell];
        (cell.shape, cell.begun_with) = (shape, greatest);
    }

    /// Pressure at `y` of the solution without the ridge, in the zone that begins with lobe `first`, and half length over that and the radius.
    fn pressure_without_ridge(&self, first: usize, y: f64) -> [f64; 2] {
        let (n, kept) = (self.rule.count(), &self.without_ridge);
        let mut number = first;
        while kept.lobes[number].met[1] && y > kept.lobes[number].edges[1] {
            number += 1;
        }
        let Kept { edges, met, shape, .. } = kept.lobes[number];
        let t = ((2.0 * y - edges[0] - edges[1]) / (edges[1] - edges[0])).clamp(-1.0, 1.0);
        let s = t.asin() / FRAC_PI_2;
        // The polynomial in s through the ratios.
        let (mut sum, mut weights) = (0.0, 0.0);
        let ratios = &kept.ratio[number * n..(number + 1) * n];
        for ((node, weight), ratio) in
            self.rule.nodes.iter().zip(&self.rule.barycentric).zip(ratios)
        {
            let distance = s - node.asin() / FRAC_PI_2;
            // At a node the others do not count.
            let part = weight / if distance.abs() < 1e-14 { 1e-14 } else { distance };
            sum += part * ratio.max(0.0);
            weights += part;
        }
        let end = |side: usize, distance: f64| if met[side] { 1.0 } else { distance.sqrt() };
        let pressure = (sum / weights).max(0.0) * end(0, 1.0 + t) * end(1, 1.0 - t);
        let exponent: f64 = shape.iter().zip(legendre(t)).map(|(s, p)| s * p).sum();
        [pressure, 2.0 * PI * (-exponent).exp()]
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::super::two_peaks::TwoPeaks;
    use super::*;

    #[test]
    fn a_ridge_counts_from_its_least_to_its_clear_share() {
        assert_relative_eq!(weight(LEAST_SHARE), 0.0);
        assert_relative_eq!(weight(CLEAR_SHARE), 1.0);
        assert_relative_eq!(weight(f64::INFINITY), 1.0);
        assert_relative_eq!(weight(0.5 * (LEAST_SHARE + CLEAR_SHARE)), 0.5, epsilon = 1e-12);
    }

    /// Level at which a ridge between equal peaks is so much lower than these.
    fn level(ridge: f64, share: f64) -> f64 {
        ridge / share
    }

    #[test]
    fn a_ridge_that_comes_leaves_the_load_as_it_is() {
        let peaks = TwoPeaks { ridge: 3e-6, half_distance: 5e-3, tilt: 5e-5 };
        let mut solver = StripSolver::new(15);
        // With the tilt the lower peak is as much lower as that place is further out.
        let lower = |share: f64| level(peaks.ridge, share);
        let (mut loads, mut mixed) = (Vec::new(), 0);
        for step in 0..=400 {
            let strips = peaks.pressed(&mut solver, lower(0.09) + 1e-7 * f64::from(step));
            mixed += usize::from(solver.is_mixed);
            loads.push(strips.load());
        }
        assert!(mixed > 20 && mixed < 380, "{mixed}");
        assert_eq!(solver.work.fixed, 0);
        let bend = |w: &[f64]| (w[2] - 2.0 * w[1] + w[0]).abs() / w[1];
        let worst = loads.windows(3).map(bend).fold(0.0, f64::max);
        assert!(worst < 2e-5, "{worst}");
    }

    #[test]
    fn what_is_mixed_has_the_load_of_both() {
        let peaks = TwoPeaks { ridge: 3e-6, half_distance: 5e-3, tilt: 0.0 };
        let mut solver = StripSolver::new(15);
        for share in [0.0501, 0.06, 0.07, 0.0799] {
            let strips = peaks.pressed(&mut solver, level(peaks.ridge, share));
            assert!(solver.is_mixed, "{share}");
            let load = solver.without_ridge.lobes.iter().map(|lobe| lobe.load).sum::<f64>();
            let load = 0.5 * std::f64::consts::PI.powi(2) * TwoPeaks::MODULUS * load;
            let with = weight(share);
            // All strips have loads between the two.
            let other =
                (strips.load() - (1.0 - with).powi(2) * load) / (1.0 - (1.0 - with).powi(2));
            assert_relative_eq!(other, load, max_relative = 2e-2);
            if share < 0.051 {
                assert_relative_eq!(strips.load(), load, max_relative = 1e-4);
            }
        }
    }
}
