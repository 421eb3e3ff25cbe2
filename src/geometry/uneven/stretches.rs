//! Waves along the track by samples: where the bodies are nearest, and on which stretches they
//! overlap.
//!
//! Between samples e is the cubic with the values and slopes of both ends. It departs from a wave of
//! height A by A (k h)⁴/384 at most, with h a 64th of the shortest wave: 2e-7 of it.

use super::wavy_section::WavySection;
use crate::math::fixed_vec::FixedVec;
use crate::math::root::bracketed;

/// Bracket within which an edge along x is interpolated, and a place where Q is stationary [m].
const BRACKET: [f64; 2] = [1e-7, 1e-9];
/// Newton steps towards a place where Q is stationary; two or three are the rule.
const NEWTON_STEPS: usize = 6;
/// Samples between two of those that tell valleys apart.
const FINER: i64 = 4;
/// Most samples: beyond them e is computed anew.
const MOST: usize = 600;

/// Room for samples.
#[derive(Clone, Debug)]
pub struct WaveSamples(FixedVec<Sample>);

/// e, its rise over the distance of samples by the slope there [m], and the slope of the rail's part
/// of it [-].
type Sample = [f64; 3];

impl WaveSamples {
    /// No samples yet.
    pub fn new() -> Self {
        Self(FixedVec::new(MOST))
    }

    /// Samples the `waves` within the distance `reach` of `centre` [m].
    pub fn take<'a>(
        &'a mut self,
        waves: WavySection<'a>,
        centre: f64,
        reach: f64,
    ) -> SampledWaves<'a> {
        let step = waves.spacing / FINER as f64;
        let side = ((reach / step).ceil() as usize + 1).min((MOST - 1) / 2) as i64;
        let middle = (centre / step).round() as i64;
        self.0.clear();
        self.0.extend((middle - side..=middle + side).map(|i| {
            let [rail, wheel] = waves.each(i as f64 * step);
            [rail[0] + wheel[0], step * (rail[1] + wheel[1]), rail[1]]
        }));
        SampledWaves { waves, step, per_step: 1.0 / step, first: middle - side, samples: &self.0 }
    }
}

/// The second and third coefficient of the cubic over a step with these values and rises, each
/// first here and then there.
#[inline]
fn cubic([a, a_rise, b, b_rise]: [f64; 4]) -> [f64; 2] {
    let way = b - a;
    [3.0 * way - 2.0 * a_rise - b_rise, a_rise + b_rise - 2.0 * way]
}

/// Waves along the track, and samples of them.
#[derive(Clone, Copy, Debug)]
pub struct SampledWaves<'a> {
    waves: WavySection<'a>,
    /// Distance of the samples [m] and one over it, and the number of the first one, counted from x = 0.
    step: f64,
    per_step: f64,
    first: i64,
    samples: &'a [Sample],
}

impl SampledWaves<'_> {
    /// e [m], its slope [-] and curvature [1/m] at `x`.
    fn at(&self, x: f64) -> [f64; 3] {
        let Some((t, [[a, a_rise, _], [b, b_rise, _]])) = self.around(x) else {
            return self.waves.nearness(x);
        };
        let [c2, c3] = cubic([a, a_rise, b, b_rise]);
        [
            a + t * (a_rise + t * (c2 + t * c3)),
            (a_rise + t * (2.0 * c2 + 3.0 * t * c3)) * self.per_step,
            (2.0 * c2 + 6.0 * t * c3) * self.per_step * self.per_step,
        ]
    }

    /// e at `x` [m], and the slope of the rail's part of it [-].
    #[inline]
    fn height(&self, x: f64) -> [f64; 2] {
        let Some((t, [[a, a_rise, a_rail], [b, b_rise, b_rail]])) = self.around(x) else {
            let [rail, wheel] = self.waves.each(x);
            return [rail[0] + wheel[0], rail[1]];
        };
        let [c2, c3] = cubic([a, a_rise, b, b_rise]);
        [a + t * (a_rise + t * (c2 + t * c3)), a_rail + t * (b_rail - a_rail)]
    }

    /// How far `x` is behind the sample before it, over their distance, and both around it; nothing
    /// beyond them.
    #[inline]
    fn around(&self, x: f64) -> Option<(f64, [Sample; 2])> {
        let place = x * self.per_step - self.first as f64;
        let before = place as usize;
        let both = self.samples.get(before..)?.first_chunk()?;
        (place >= 0.0).then_some((place - before as f64, *both))
    }

    /// Q at `x` for a circle of radius `radius` about `centre` [m].
    #[inline]
    pub fn distance(&self, centre: f64, radius: f64, x: f64) -> f64 {
        let to = x - centre;
        0.5 * to * to / radius - self.height(x)[0]
    }

    /// The same at sample `i` of those that tell valleys apart.
    #[inline]
    fn distance_at(&self, centre: f64, radius: f64, i: i64) -> f64 {
        let x = self.place_of(i);
        // A number below the first one wraps around, beyond the last one.
        let Some([height, ..]) = self.samples.get((i * FINER - self.first) as usize) else {
            return self.distance(centre, radius, x);
        };
        let to = x - centre;
        0.5 * to * to / radius - height
    }

    /// sqrt(2 r (level - Q)) at `x`, the root of the overlap by which pressure goes [m], and the
    /// slope of the rail's part of e there [-].
    #[inline]
    pub fn depth_root(&self, centre: f64, radius: f64, level: f64, x: f64) -> (f64, f64) {
        let [height, rail_slope] = self.height(x);
        let to = x - centre;
        let square = 2.0 * radius * (level + height) - to * to;
        (square.max(0.0).sqrt(), rail_slope)
    }

    /// Where Q is least for a circle of radius `radius` about `centre` [m]: the lowest of the valleys
    /// that samples tell apart.
    pub fn lowest(&self, centre: f64, radius: f64) -> f64 {
        let [first, last] = self.samples_within(centre, self.waves.reach(radius));
        let at = |i: i64| self.distance_at(centre, radius, i);
        let (mut before, mut here) = (at(first - 1), at(first));
        let mut lowest = (f64::INFINITY, centre);
        let dip = self.waves.dip(radius);
        for i in first..=last {
            let after = at(i + 1);
            if here <= before && here <= after && here < lowest.0 + dip {
                let x = self.stationary(centre, radius, i, [before, here, after]);
                let found = self.distance(centre, radius, x);
                if found < lowest.0 {
                    lowest = (found, x);
                }
            }
            (before, here) = (here, after);
        }
        lowest.1
    }

    /// Numbers of those samples that tell valleys apart within the distance `reach` of `centre`.
    fn samples_within(&self, centre: f64, reach: f64) -> [i64; 2] {
        let before = |x: f64| x.div_euclid(self.waves.spacing) as i64;
        [before(centre - reach), before(centre + reach) + 1]
    }

    fn place_of(&self, i: i64) -> f64 {
        (i * FINER) as f64 * self.step
    }

    /// Calls `found` with both ends of every stretch along x on which Q < `level`, in growing x
    /// [m], for a circle of radius `radius` about `centre` [m].
    pub fn stretches(&self, centre: f64, radius: f64, level: f64, mut found: impl FnMut(f64, f64)) {
        // Q is at least (x - x_c)²/(2 r) - highest.
        let half = (2.0 * radius * (level + self.waves.highest).max(0.0)).sqrt();
        let [first, last] = self.samples_within(centre, half);
        let height = |x: f64| self.distance(centre, radius, x) - level;
        let at = |i: i64| self.distance_at(centre, radius, i) - level;
        let edge = |from: (f64, f64), to: (f64, f64)| bracketed(from, to, BRACKET[0], height);
        let stationary = |i: i64, around: [f64; 3]| {
            let x = self.stationary(centre, radius, i, around);
            (x, height(x))
        };
        let dip = self.waves.dip(radius);
        let mut start: Option<f64> = None;
        let (mut before, mut here) = (at(first - 1), at(first));
        for i in first..=last {
            let after = at(i + 1);
            let around = [before, here, after];
            if here >= 0.0 && before >= 0.0 && after >= 0.0 {
                // Between samples it may just reach below the level.
                if here < dip && here <= before && here <= after {
                    let lowest = stationary(i, around);
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
                    let highest = stationary(i, around);
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

    /// Where Q is stationary near sample `i`, which is lower, or higher, than its neighbours, given
    /// Q at all three but for a constant [m].
    fn stationary(&self, centre: f64, radius: f64, i: i64, around: [f64; 3]) -> f64 {
        let (left, right) = (self.place_of(i - 1), self.place_of(i + 1));
        // From the parabola through the samples Newton's method needs two or three steps.
        let [before, here, after] = around;
        let bend = before - 2.0 * here + after;
        let mut x = self.place_of(i);
        if bend.abs() > 0.0 {
            x += 0.5 * self.waves.spacing * ((before - after) / bend).clamp(-1.0, 1.0);
        }
        for _ in 0..NEWTON_STEPS {
            let [_, slope, curvature] = self.at(x);
            let step = -((x - centre) / radius - slope) / (1.0 / radius - curvature);
            let next = x + step;
            if step.abs() < BRACKET[1] {
                return next;
            }
            if !(next > left && next < right) {
                break;
            }
            x = next;
        }
        // Flat or kinked: by bisection.
        let slope = |x: f64| (x - centre) / radius - self.at(x)[1];
        let (a, b) = (slope(left), slope(right));
        if a * b > 0.0 {
            self.place_of(i)
        } else {
            bracketed((left, a), (right, b), BRACKET[1], slope)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::wavy_section::tests::{RADIUS, cases, section};
    use super::WaveSamples;

    #[test]
    fn the_lowest_place_is_that_of_a_scan() {
        for [rail, wheel] in &cases() {
            for step in 0..24 {
                let station = 2.7e-3 * f64::from(step) - 0.03;
                let mut room = WaveSamples::new();
                let section = section(rail, wheel, station);
                for centre in [0.0, -0.004, 0.3] {
                    let distance = |x: f64| section.distance(centre, RADIUS, x);
                    let found = room.take(section, centre, 0.02).lowest(centre, RADIUS);
                    let scan = (-6000..=6000).map(|i| distance(centre + 2e-5 * f64::from(i)));
                    let least = scan.fold(f64::INFINITY, f64::min);
                    assert!((distance(found) - least).abs() < 1e-9, "{found}");
                }
            }
        }
    }

    #[test]
    fn stretches_are_those_of_a_scan() {
        let mut several = 0;
        for [rail, wheel] in &cases() {
            for step in 0..24 {
                let station = 2.7e-3 * f64::from(step) - 0.03;
                let mut room = WaveSamples::new();
                let section = section(rail, wheel, station);
                let distance = |i: i32| section.distance(0.0, RADIUS, 1e-5 * f64::from(i));
                let scan = || -12_000..=12_000;
                let least = scan().map(distance).fold(f64::INFINITY, f64::min);
                for depth in [1e-7, 5e-6, 5e-5] {
                    let level = depth + least;
                    let (mut found, mut length) = (0, 0.0);
                    room.take(section, 0.0, 0.02).stretches(0.0, RADIUS, level, |a, b| {
                        found += 1;
                        length += b - a;
                    });
                    let inside = scan().filter(|&i| distance(i) < level).count() as f64 * 1e-5;
                    assert!(found > 0);
                    assert!((length - inside).abs() < 4e-5 * f64::from(found), "{length} {inside}");
                    several += usize::from(found > 1);
                }
            }
        }
        assert!(several > 2, "{several}");
    }
}
