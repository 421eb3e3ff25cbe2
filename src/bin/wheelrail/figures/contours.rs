//! Areas between the contours of a quantity on a lattice.

use std::collections::HashMap;

/// Values on a lattice.
pub struct Lattice<'a> {
    /// Places along both axes, growing.
    pub axes: [&'a [f64]; 2],
    /// Values, those of the first place along the second axis first.
    pub values: &'a [f64],
}

/// A closed contour and the band that lies just within it: 0 below the first level, 1 above it and
/// so on.
#[derive(Clone, Debug, PartialEq)]
pub struct Loop {
    pub points: Vec<(f64, f64)>,
    pub band: usize,
}

/// A side of a cell: its first corner, and 0 along the first axis, 1 along the second.
type Side = (usize, usize, usize);

impl Lattice<'_> {
    /// Contours at growing `levels`, the largest loop first: painted in this order, each covers what
    /// is not within it.
    pub fn loops(&self, levels: &[f64]) -> Vec<Loop> {
        let mut all: Vec<(f64, Loop)> = Vec::new();
        for (k, &level) in levels.iter().enumerate() {
            for points in self.contours(level) {
                // What is above the level lies left of a contour.
                let area = area(&points);
                let band = if area > 0.0 { k + 1 } else { k };
                all.push((area.abs(), Loop { points, band }));
            }
        }
        all.sort_by(|a, b| b.0.total_cmp(&a.0));
        all.into_iter().map(|(_, own)| own).collect()
    }

    /// Closed contours at `level`, closed along the edge of the lattice.
    fn contours(&self, level: f64) -> Vec<Vec<(f64, f64)>> {
        let mut next = HashMap::new();
        let [n, m] = self.counts();
        for (i, j) in (0..n - 1).flat_map(|i| (0..m - 1).map(move |j| (i, j))) {
            let corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)];
            let values = corners.map(|(i, j)| self.value(i, j));
            let above = values.map(|value| value >= level);
            let sides: [Side; 4] = [(i, j, 0), (i + 1, j, 1), (i, j + 1, 0), (i, j, 1)];
            // Where both diagonals differ the mean tells which corners belong together.
            let joined = values.iter().sum::<f64>() >= 4.0 * level;
            for k in (0..4).filter(|&k| above[k] && !above[(k + 1) % 4]) {
                let turn = if joined { 1 } else { 3 };
                let end = (1..4)
                    .map(|step| (k + turn * step) % 4)
                    .find(|&end| !above[end] && above[(end + 1) % 4]);
                if let Some(end) = end {
                    next.insert(sides[k], sides[end]);
                }
            }
        }
        let mut starts: Vec<Side> = next.keys().copied().collect();
        starts.sort_unstable();
        let mut loops = Vec::new();
        for start in starts {
            let (mut points, mut at) = (Vec::new(), start);
            while let Some(to) = next.remove(&at) {
                points.push(self.crossing(at, level));
                at = to;
            }
            if points.len() > 2 {
                loops.push(points);
            }
        }
        loops
    }

    /// Places along both axes, with one more at each end, beyond which there is nothing.
    fn counts(&self) -> [usize; 2] {
        self.axes.map(|axis| axis.len() + 2)
    }

    fn value(&self, i: usize, j: usize) -> f64 {
        let [n, m] = self.axes.map(<[f64]>::len);
        if (1..=n).contains(&i) && (1..=m).contains(&j) {
            self.values[(j - 1) * n + i - 1]
        } else {
            f64::MIN
        }
    }

    /// Where a contour crosses a side.
    fn crossing(&self, (i, j, axis): Side, level: f64) -> (f64, f64) {
        let place = |i: usize, j: usize| {
            let on = |axis: &[f64], k: usize| axis[k.clamp(1, axis.len()) - 1];
            [on(self.axes[0], i), on(self.axes[1], j)]
        };
        let (to_i, to_j) = if axis == 0 { (i + 1, j) } else { (i, j + 1) };
        let (from, to) = (place(i, j), place(to_i, to_j));
        let (a, b) = (self.value(i, j), self.value(to_i, to_j));
        let share = ((level - a) / (b - a)).clamp(0.0, 1.0);
        let [x, y] = [0, 1].map(|c| from[c] + share * (to[c] - from[c]));
        (x, y)
    }
}

/// Area within a loop, positive where it runs from the first axis to the second.
fn area(points: &[(f64, f64)]) -> f64 {
    let next = points.iter().cycle().skip(1);
    0.5 * points.iter().zip(next).map(|(a, b)| a.0 * b.1 - b.0 * a.1).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn loops(f: impl Fn(f64, f64) -> f64, levels: &[f64]) -> Vec<Loop> {
        let axis: Vec<f64> = (-40..=40).map(|k| 0.05 * f64::from(k)).collect();
        let values: Vec<f64> =
            axis.iter().flat_map(|y| axis.iter().map(|x| f(*x, *y)).collect::<Vec<_>>()).collect();
        Lattice { axes: [&axis, &axis], values: &values }.loops(levels)
    }

    #[test]
    fn contours_of_a_hill_are_circles_one_in_the_other() {
        let found = loops(|x, y| 4.0 - x * x - y * y, &[1.0, 3.0]);
        assert_eq!(found.iter().map(|l| l.band).collect::<Vec<_>>(), [1, 2]);
        for (own, radius) in found.iter().zip([3f64.sqrt(), 1.0]) {
            assert!((area(&own.points) / (PI * radius * radius) - 1.0).abs() < 2e-3);
        }
    }

    #[test]
    fn a_hollow_has_the_band_below_and_contours_close_along_the_edge() {
        let found = loops(|x, y| x * x + y * y, &[1.0]);
        assert_eq!(found.iter().map(|l| l.band).collect::<Vec<_>>(), [1, 0]);
        assert!((area(&found[0].points) - 16.0).abs() < 1e-9);
        assert!((area(&found[1].points) + PI).abs() < 0.01);
    }

    #[test]
    fn two_hills_are_two_loops_and_a_saddle_joins_them() {
        let hills = |x: f64, y: f64| {
            let hill = |x0: f64| (-4.0 * ((x - x0).powi(2) + y * y)).exp();
            hill(0.7) + hill(-0.7)
        };
        assert_eq!(loops(hills, &[0.5]).len(), 2);
        assert_eq!(loops(hills, &[0.1]).len(), 1);
        assert!(loops(hills, &[3.0]).is_empty());
    }
}
