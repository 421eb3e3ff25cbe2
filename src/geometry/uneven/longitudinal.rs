//! Wheel and rail along the track where one of them is not even: how far the wheel is lifted by it,
//! and where it overlaps.
//!
//! With e(x) the sum of the deviations of both surfaces at the place x (larger bodies are positive)
//! and the radius r of the wheel, the distance of the surfaces below a point x_l of the contact
//! line is that of the even bodies plus
//!
//! ```text
//! Q(x) = (x - x_l)²/(2 r) - e(x)
//! ```
//!
//! First touch is at the least Q, wherever that is: the even bodies come nearer to each other by
//! the lift M = -min Q. As a function of x_l the lift is the path of a wheel that rolls over the
//! deviations, continuous, with kinks where the wheel stands on two points at once.

mod lift;
mod stretches;

pub use lift::Lift;

use crate::geometry::uneven::waviness::Waviness;
use crate::math::fixed_vec::FixedVec;

/// Least and greatest distance of samples [m].
const SPACING: [f64; 2] = [2.5e-4, 4e-3];
/// Distance over that of samples below which differences are no better than the curvature itself.
pub(in crate::geometry) const MIN_REACH: f64 = 1e-2;
/// Most samples that are kept for an evaluation.
const MAX_SAMPLES: usize = 600;

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
    /// Place of the nominal rolling circle that is straight below the axle [m].
    turn: f64,
    /// First of the samples [m].
    first: f64,
    samples: FixedVec<f64>,
}

impl Longitudinal {
    /// The deviations of a wheel, over the arc of its nominal rolling circle with `nominal_radius`
    /// [m], and of a rail; nothing where both are even.
    #[must_use]
    pub fn new(wheel: Waviness, rail: Waviness, nominal_radius: f64) -> Option<Self> {
        if wheel.is_empty() && rail.is_empty() {
            return None;
        }
        let (w, r) = (wheel.bounds(), rail.bounds());
        let highest = w.range[1] + r.range[1];
        let range = highest - w.range[0] - r.range[0];
        // Circles of the wheel are at most twice as large as the nominal rolling circle.
        let largest = 2.0 * nominal_radius;
        let reach = (2.0 * largest * range).sqrt().min(largest * (w.slope + r.slope));
        let spacing = w.spacing.min(r.spacing).min(0.5 * reach).clamp(SPACING[0], SPACING[1]);
        let curvature = w.curvature + r.curvature;
        let samples = FixedVec::new(MAX_SAMPLES);
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

    /// Takes the samples for a wheel marker at `station` [m] and a wheel turned by `pitch` [rad],
    /// for points of the contact line up to `ahead` from the marker [m].
    pub fn place(&mut self, station: f64, pitch: f64, ahead: f64) {
        self.station = station;
        self.turn = -pitch * self.nominal_radius;
        let wanted = ((self.reach + ahead) / self.spacing).ceil() as usize + 3;
        let side = wanted.min((MAX_SAMPLES - 1) / 2);
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

    /// Deviation of the wheel at `x`: radius beyond that of the round wheel [m], and its slope
    /// along the circle [-].
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

    /// Curvature of Q about `x`, from its rise over the distance `reach` to either side; that at
    /// `x` itself if `reach` is nothing [1/m].
    #[must_use]
    pub fn mean_curvature(&self, radius: f64, x: f64, reach: f64) -> f64 {
        let even = 1.0 / radius;
        if reach <= self.spacing * MIN_REACH {
            return even - self.nearness(x)[2];
        }
        let [here, ahead, behind] = [x, x + reach, x - reach].map(|x| self.nearness(x)[0]);
        even + (2.0 * here - ahead - behind) / (reach * reach)
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

    /// sqrt(2 r (level - Q)) at `x`, the root of the overlap by which pressure goes [m], and the
    /// [`slopes`](Self::slopes) there.
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
    use crate::geometry::uneven::waviness::{Flat, FlatShape, Harmonic};
    use std::f64::consts::TAU;

    pub(in crate::geometry) const RADIUS: f64 = 0.5;

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

    pub(in crate::geometry) fn cases() -> Vec<Longitudinal> {
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
    fn even_bodies_have_no_deviations_to_follow() {
        assert!(Longitudinal::new(Waviness::new(Some(3.0)), Waviness::new(None), 0.46).is_none());
    }
}
