//! Stretches along the track on which the bodies overlap.

use super::{Lift, Longitudinal};
use crate::math::root::bracketed;

/// Bracket within which an edge along x is interpolated [m].
const EDGE_BRACKET: f64 = 1e-7;

impl Longitudinal {
    /// Calls `found` with both ends of every stretch along x on which Q < `level`, in growing x
    /// [m].
    pub fn stretches(&self, centre: f64, radius: f64, level: f64, mut found: impl FnMut(f64, f64)) {
        // Q is at least (x - x_l)²/(2 r) - highest.
        let half = (2.0 * radius * (level + self.highest).max(0.0)).sqrt();
        let first = self.before(centre - half);
        let last = self.before(centre + half) + 1;
        let at = |i: i64| self.sampled_distance(centre, radius, i) - level;
        let height = |x: f64| self.distance(centre, radius, x) - level;
        let edge = |from: (f64, f64), to: (f64, f64)| bracketed(from, to, EDGE_BRACKET, height);
        let dip = self.dip(radius);
        let mut start: Option<f64> = None;
        let (mut before, mut here) = (at(first - 1), at(first));
        for i in first..=last {
            let after = at(i + 1);
            if here >= 0.0 && before >= 0.0 && after >= 0.0 {
                // Between samples it may just reach below the level.
                if here < dip && here <= before && here <= after {
                    let q = [before, here, after].map(|q| q + level);
                    let Lift { height, x } = self.valley(centre, radius, i, q);
                    let lowest = (x, -height - level);
                    if lowest.1 < 0.0 {
                        let (left, right) = (self.place_of(i - 1), self.place_of(i + 1));
                        found(edge(lowest, (left, before)), edge(lowest, (right, after)));
                    }
                }
            } else if here < 0.0 {
                let [left, middle, right] = [i - 1, i, i + 1].map(|i| self.place_of(i));
                if before >= 0.0 {
                    start = Some(edge((middle, here), (left, before)));
                } else if here > -dip && here >= before && here >= after && after < 0.0 {
                    // Or just above it.
                    let q = [before, here, after].map(|q| q + level);
                    let Lift { height, x } = self.valley(centre, radius, i, q);
                    let highest = (x, -height - level);
                    if highest.1 > 0.0
                        && let Some(from) = start
                    {
                        found(from, edge((left, before), highest));
                        start = Some(edge((right, after), highest));
                    }
                }
                if after >= 0.0
                    && let Some(from) = start.take()
                {
                    found(from, edge((middle, here), (right, after)));
                }
            }
            (before, here) = (here, after);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{RADIUS, cases};

    #[test]
    fn stretches_are_those_of_a_scan() {
        let mut several = 0;
        for mut case in cases() {
            for step in 0..24 {
                let station = 2.7e-3 * f64::from(step) - 0.03;
                case.place(station, -station / RADIUS, 0.0);
                let lift = case.lift(0.0, RADIUS).height;
                for depth in [1e-7, 5e-6, 5e-5] {
                    let level = depth - lift;
                    let (mut found, mut length) = (0, 0.0);
                    case.stretches(0.0, RADIUS, level, |a, b| {
                        found += 1;
                        length += b - a;
                    });
                    let inside = |i: i32| case.distance(0.0, RADIUS, 1e-5 * f64::from(i)) < level;
                    let scan = (-12_000..=12_000).filter(|&i| inside(i)).count() as f64 * 1e-5;
                    assert!(found > 0);
                    assert!((length - scan).abs() < 4e-5 * f64::from(found), "{length} {scan}");
                    several += usize::from(found > 1);
                }
            }
        }
        assert!(several > 2, "{several}");
    }
}
