//! Wheel and rail along the track where one of them is not even: how far the wheel is lifted by it, and where it overlaps.
//!
//! With e(x) the sum of the deviations of both surfaces at the place x (larger bodies are positive) and the radius r of the
//! wheel, the distance of the surfaces below a point x_l of the contact line is that of the even bodies plus
//!
//! ```text
//! Q(x) = (x - x_l)²/(2 r) - e(x)
//! ```
//!
//! First touch is at the least Q, wherever that is: the even bodies come nearer to each other by the lift M = -min Q. As a function
//! of x_l the lift is the path of a wheel that rolls over the deviations, continuous, with kinks where the wheel stands on two
//! points at once.
//!
//! The minimum is found without fail and cheaply: it lies within `reach` of x_l, because there e falls off less than the
//! circle rises; samples as close as the deviations are smooth tell the valleys of Q apart; the lowest ones are pinned down by the
//! exact derivative. Samples are taken once for an evaluation.

use crate::geometry::waviness::Waviness;
use crate::math::room::Room;
use crate::math::root::bracketed;

/// Least and greatest distance of samples [m].
const SPACING: [f64; 2] = [2.5e-4, 4e-3];
/// Most samples that are kept for an evaluation.
const MOST_SAMPLES: usize = 600;
/// Last Newton step towards a minimum, and bracket within which one is interpolated [m].
const BRACKET: f64 = 1e-9;
/// Bracket within which an edge along x is interpolated [m].
const EDGE_BRACKET: f64 = 1e-7;
/// Newton steps towards a minimum; two or three are the rule.
const NEWTON_STEPS: usize = 6;

/// The lift of a wheel at one place of its contact line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lift {
    /// How much nearer the surfaces are than those of even bodies, M [m].
    pub height: f64,
    /// Where they are nearest, from the wheel marker [m].
    pub x: f64,
}

/// Deviations of a wheel and a rail, and where both of them stand.
#[derive(Clone, Debug)]
pub struct Longitudinal {
    wheel: Waviness,
    rail: Waviness,
    /// Radius on which the wheel's deviations are given [m].
    nominal_radius: f64,
    spacing: f64,
    reach: f64,
    /// Bound of e, and of its curvature.
    highest: f64,
    curvature: f64,
    /// Station below the wheel marker [m].
    station: f64,
    /// Place of the running circle that is straight below the axle [m].
    turn: f64,
    /// First of the samples [m].
    first: f64,
    samples: Room<f64>,
}

impl Longitudinal {
    /// The deviations of a wheel, over the arc of its running circle with `nominal_radius` [m], and of a rail; nothing where both
    /// are even.
    #[must_use]
    pub fn new(wheel: Waviness, rail: Waviness, nominal_radius: f64) -> Option<Self> {
        if wheel.is_empty() && rail.is_empty() {
            return None;
        }
        let (w, r) = (wheel.bounds(), rail.bounds());
        let highest = w.range[1] + r.range[1];
        let range = highest - w.range[0] - r.range[0];
        // Circles of the wheel are at most twice as large as the running circle.
        let largest = 2.0 * nominal_radius;
        let reach = (2.0 * largest * range).sqrt().min(largest * (w.slope + r.slope));
        let spacing = w.spacing.min(r.spacing).min(0.5 * reach).clamp(SPACING[0], SPACING[1]);
        let curvature = w.curvature + r.curvature;
        let samples = Room::new(MOST_SAMPLES);
        let (station, turn, first) = (0.0, 0.0, 0.0);
        Some(Self {
            wheel,
            rail,
            nominal_radius,
            spacing,
            reach,
            highest,
            curvature,
            station,
            turn,
            first,
            samples,
        })
    }

    /// Bound of the lift [m].
    #[must_use]
    pub fn highest(&self) -> f64 {
        self.highest
    }

    /// Greatest distance from x_l at which first touch can be [m].
    #[must_use]
    pub fn reach(&self) -> f64 {
        self.reach
    }

    /// Distance of the samples, a sixteenth of the shortest wave or less [m].
    #[must_use]
    pub fn spacing(&self) -> f64 {
        self.spacing
    }

    /// Takes the samples for a wheel marker at `station` [m] and a wheel turned by `pitch` [rad], for points of the contact line
    /// up to `ahead` from the marker [m].
    pub fn place(&mut self, station: f64, pitch: f64, ahead: f64) {
        self.station = station;
        self.turn = -pitch * self.nominal_radius;
        let wanted = ((self.reach + ahead) / self.spacing).ceil() as usize + 3;
        let side = wanted.min((MOST_SAMPLES - 1) / 2);
        self.first = -(side as f64) * self.spacing;
        self.samples.clear();
        for i in 0..=2 * side {
            let e = self.nearness(self.first + i as f64 * self.spacing)[0];
            self.samples.push(e);
        }
    }

    /// e(x) [m], its slope [-] and curvature [1/m] at `x` from the wheel marker [m].
    #[must_use]
    pub fn nearness(&self, x: f64) -> [f64; 3] {
        let mut sum = [0.0; 3];
        if !self.rail.is_empty() {
            sum = self.rail.at(self.station + x);
        }
        if !self.wheel.is_empty() {
            let own = self.wheel.at(self.turn + x);
            sum = [0, 1, 2].map(|i| sum[i] + own[i]);
        }
        sum
    }

    /// Deviation of the wheel at `x`: radius beyond that of the round wheel [m], and its slope along the circle [-].
    #[must_use]
    pub fn wheel_deviation(&self, x: f64) -> [f64; 2] {
        if self.wheel.is_empty() {
            return [0.0; 2];
        }
        let [value, slope, _] = self.wheel.at(self.turn + x);
        [value, slope]
    }

    /// Slopes of the rail's and of the wheel's part of e at `x` [-].
    #[must_use]
    pub fn slopes(&self, x: f64) -> [f64; 2] {
        let rail = if self.rail.is_empty() { 0.0 } else { self.rail.at(self.station + x)[1] };
        [rail, self.wheel_deviation(x)[1]]
    }

    /// Whether the rail has deviations.
    #[must_use]
    pub fn has_uneven_rail(&self) -> bool {
        !self.rail.is_empty()
    }

    /// Sample number `i`, also beyond those that are kept.
    #[inline]
    fn sample(&self, i: i64) -> f64 {
        match usize::try_from(i).ok().and_then(|i| self.samples.get(i)) {
            Some(&e) => e,
            None => self.nearness(self.place_of(i))[0],
        }
    }

    #[inline]
    fn place_of(&self, i: i64) -> f64 {
        self.first + i as f64 * self.spacing
    }

    /// Number of the last sample at or before `x`.
    #[inline]
    fn before(&self, x: f64) -> i64 {
        ((x - self.first) / self.spacing).floor() as i64
    }

    /// Q at `x` for circles of radius `radius` below `centre` [m].
    #[inline]
    #[must_use]
    pub fn distance(&self, centre: f64, radius: f64, x: f64) -> f64 {
        let to = x - centre;
        0.5 * to * to / radius - self.nearness(x)[0]
    }

    /// Q at sample number `i`.
    #[inline]
    fn sampled_distance(&self, centre: f64, radius: f64, i: i64) -> f64 {
        let to = self.place_of(i) - centre;
        0.5 * to * to / radius - self.sample(i)
    }

    /// How far the least Q between samples can lie below the lower one of them [m].
    fn dip(&self, radius: f64) -> f64 {
        0.5 * (1.0 / radius + self.curvature) * self.spacing * self.spacing
    }

    /// The lift at the place `centre` = x_l of the contact line for a circle of radius `radius` [m].
    #[must_use]
    pub fn lift(&self, centre: f64, radius: f64) -> Lift {
        let first = self.before(centre - self.reach);
        let last = self.before(centre + self.reach) + 1;
        let at = |i: i64| self.sampled_distance(centre, radius, i);
        let lowest = (first..=last).map(at).fold(f64::INFINITY, f64::min);
        let level = lowest + self.dip(radius);
        let mut best = Lift { height: f64::NEG_INFINITY, x: centre };
        let (mut before, mut here) = (at(first - 1), at(first));
        for i in first..=last {
            let after = at(i + 1);
            if here <= level && here <= before && here <= after {
                let lift = self.valley(centre, radius, i, [before, here, after]);
                if lift.height > best.height {
                    best = lift;
                }
            }
            (before, here) = (here, after);
        }
        if best.height == f64::NEG_INFINITY {
            // A section flatter than any circle of the wheel, as that of a flange back near its rim: lowest at an end of the reach.
            let x = [first, last].map(|i| self.place_of(i));
            let [left, right] = x.map(|x| -self.distance(centre, radius, x));
            let (height, x) = if left > right { (left, x[0]) } else { (right, x[1]) };
            return Lift { height, x };
        }
        best
    }

    /// Where Q is stationary near sample `i`, which is lower, or higher, than its neighbours, given Q at all three, and -Q there.
    fn valley(&self, centre: f64, radius: f64, i: i64, around: [f64; 3]) -> Lift {
        let (left, right) = (self.place_of(i - 1), self.place_of(i + 1));
        // From the parabola through the samples Newton's method needs two or three steps.
        let [before, here, after] = around;
        let bend = before - 2.0 * here + after;
        let mut x = self.place_of(i);
        if bend.abs() > 0.0 {
            x += 0.5 * self.spacing * ((before - after) / bend).clamp(-1.0, 1.0);
        }
        for _ in 0..NEWTON_STEPS {
            let [e, slope, curvature] = self.nearness(x);
            let to = x - centre;
            let (rise, bend) = (to / radius - slope, 1.0 / radius - curvature);
            let step = -rise / bend;
            if step.abs() < BRACKET {
                // The rest of the way changes Q by less than rounding.
                let height = e - 0.5 * to * to / radius - 0.5 * rise * step;
                return Lift { height, x: x + step };
            }
            let next = x + step;
            if !(next > left && next < right) {
                break;
            }
            x = next;
        }
        // Flat or kinked: by bisection.
        let slope = |x: f64| (x - centre) / radius - self.nearness(x)[1];
        let (a, b) = (slope(left), slope(right));
        let x = if a * b > 0.0 {
            self.place_of(i)
        } else {
            bracketed((left, a), (right, b), BRACKET, slope)
        };
        Lift { height: -self.distance(centre, radius, x), x }
    }

    /// Calls `found` with both ends of every stretch along x on which Q < `level`, in growing x [m].
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

    /// sqrt(2 r (level - Q)) at `x`, the root of the overlap by which pressure goes [m], and the [`slopes`](Self::slopes) there.
    #[inline]
    #[must_use]
    pub fn depth_root(&self, centre: f64, radius: f64, level: f64, x: f64) -> (f64, [f64; 2]) {
        let (mut e, mut slopes) = (0.0, [0.0; 2]);
        for (k, (surface, place)) in
            [(&self.rail, self.station), (&self.wheel, self.turn)].into_iter().enumerate()
        {
            if !surface.is_empty() {
                let [value, slope, _] = surface.at(place + x);
                e += value;
                slopes[k] = slope;
            }
        }
        let to = x - centre;
        let depth = level - 0.5 * to * to / radius + e;
        ((2.0 * radius * depth.max(0.0)).sqrt(), slopes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::waviness::{Flat, FlatShape, Harmonic};
    use std::f64::consts::TAU;

    const RADIUS: f64 = 0.5;

    fn corrugated(amplitude: f64, wavelength: f64) -> Waviness {
        let mut rail = Waviness::new(None);
        rail.add_harmonic(Harmonic { amplitude, wavelength, phase: 0.0 });
        rail
    }

    fn flat(length: f64, shape: FlatShape) -> Waviness {
        let mut wheel = Waviness::new(Some(TAU * RADIUS));
        let depth = Flat::chord_depth(length, RADIUS);
        wheel.add_flat(Flat { length, middle: 0.0, depth, shape });
        wheel
    }

    fn cases() -> Vec<Longitudinal> {
        let even = || Waviness::new(None);
        let round = || Waviness::new(Some(TAU * RADIUS));
        let pairs = [
            (round(), corrugated(6e-5, 0.033)),
            (round(), corrugated(2e-5, 0.033)),
            (round(), corrugated(3e-5, 0.009)),
            (flat(0.05, FlatShape::Fresh), even()),
            (flat(0.1, FlatShape::Worn), even()),
            (flat(0.04, FlatShape::Fresh), corrugated(4e-5, 0.04)),
        ];
        pairs.map(|(wheel, rail)| Longitudinal::new(wheel, rail, RADIUS).unwrap()).into()
    }

    #[test]
    fn first_touch_is_where_a_scan_of_the_surfaces_finds_it() {
        for mut case in cases() {
            for step in 0..24 {
                let station = 2.7e-3 * f64::from(step) - 0.03;
                case.place(station, -station / RADIUS, 0.01);
                for centre in [0.0, -0.004, 0.3] {
                    let lift = case.lift(centre, RADIUS);
                    let scan = (-6000..=6000)
                        .map(|i| centre + 2e-5 * f64::from(i))
                        .map(|x| -case.distance(centre, RADIUS, x))
                        .fold(f64::NEG_INFINITY, f64::max);
                    assert!((lift.height - scan).abs() < 1e-9, "{} {scan}", lift.height);
                    assert!((lift.x - centre).abs() <= case.reach() + 1e-9);
                }
            }
        }
    }

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

    #[test]
    fn sections_flatter_than_the_wheel_are_lifted_as_well() {
        for mut case in cases() {
            for step in 0..24 {
                let station = 2.7e-3 * f64::from(step) - 0.03;
                case.place(station, -station / RADIUS, 0.01);
                for radius in [1.0, 10.0, 1e3, 1e6] {
                    let lift = case.lift(0.0, radius);
                    assert!(lift.height.abs() < 0.01, "{radius}: {}", lift.height);
                    assert!(lift.x.abs() <= case.reach() + 2.0 * case.spacing());
                }
            }
        }
    }

    #[test]
    fn even_bodies_have_no_deviations_to_follow() {
        assert!(Longitudinal::new(Waviness::new(Some(3.0)), Waviness::new(None), 0.46).is_none());
    }
}
