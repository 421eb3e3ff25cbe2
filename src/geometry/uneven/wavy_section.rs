//! The section along the track of a wheel over a rail, either of which has waves.
//!
//! With e(x) the sum of the deviations of both surfaces at the place x (larger bodies are positive)
//! and the radius r of the wheel, the distance of the surfaces below the middle x_c of its circle is
//! that of even bodies plus
//!
//! ```text
//! Q(x) = (x - x_c)²/(2 r) - e(x)
//! ```
//!
//! Where the bodies are nearest Q is least.

use crate::geometry::uneven::waviness::Waviness;

/// Least and greatest distance of samples [m].
pub(in crate::geometry) const SPACING: [f64; 2] = [2.5e-4, 4e-3];

/// Waves of one body along the track.
#[derive(Clone, Copy, Debug)]
pub struct Waves<'a> {
    /// The waves over a length of the body [m].
    pub surface: &'a Waviness,
    /// Place on it that is at x = 0 [m], and how fast that goes with x [-].
    pub at: f64,
    pub rate: f64,
}

impl Waves<'_> {
    /// Height [m], slope [-] and curvature [1/m] at `x`.
    fn over(&self, x: f64) -> [f64; 3] {
        if self.surface.is_empty() {
            return [0.0; 3];
        }
        let [height, slope, curvature] = self.surface.at(self.at + self.rate * x);
        [height, self.rate * slope, self.rate * self.rate * curvature]
    }
}

/// Waves of a wheel and a rail below one place of its contact line.
#[derive(Clone, Copy, Debug)]
pub struct WavySection<'a> {
    /// Those of rail and wheel.
    waves: [Waves<'a>; 2],
    /// Distance of samples, a sixteenth of the shortest wave or less [m].
    pub(super) spacing: f64,
    /// Bounds of e, and by how much it varies [m].
    pub(super) highest: f64,
    range: f64,
    /// Bound of its slope [-].
    slope: f64,
    /// Bound of its curvature [1/m].
    curvature: f64,
}

impl<'a> WavySection<'a> {
    /// The section of waves of `rail` and `wheel`.
    pub fn new(rail: Waves<'a>, wheel: Waves<'a>) -> Self {
        let [r, w] = [rail, wheel].map(|waves| waves.surface.bounds());
        let highest = w.range[1] + r.range[1];
        Self {
            waves: [rail, wheel],
            spacing: w.spacing.min(r.spacing).clamp(SPACING[0], SPACING[1]),
            highest,
            range: highest - w.range[0] - r.range[0],
            slope: w.slope + r.slope,
            curvature: w.curvature + r.curvature,
        }
    }

    /// e(x) [m], its slope [-] and curvature [1/m].
    pub fn nearness(&self, x: f64) -> [f64; 3] {
        let [rail, wheel] = self.each(x);
        [0, 1, 2].map(|i| rail[i] + wheel[i])
    }

    /// The same of rail and wheel.
    pub(super) fn each(&self, x: f64) -> [[f64; 3]; 2] {
        self.waves.map(|waves| waves.over(x))
    }

    /// Height of the rail [m], its slope [-] and curvature [1/m] at `x`.
    pub fn rail(&self, x: f64) -> [f64; 3] {
        self.waves[0].over(x)
    }

    /// Slopes of the rail's and of the wheel's part of e at `x` [-].
    pub fn slopes(&self, x: f64) -> [f64; 2] {
        self.each(x).map(|[_, slope, _]| slope)
    }

    /// Whether the wheel has no waves.
    pub fn is_round(&self) -> bool {
        self.waves[1].surface.is_empty()
    }

    /// Deviation of the wheel at `x`, and how far ahead of the axle its normal passes there, of a
    /// wheel of `nominal_radius` [m].
    pub fn wheel(&self, x: f64, nominal_radius: f64) -> [f64; 2] {
        let [_, [value, slope, _]] = self.each(x);
        [value, slope * self.lever_per_slope(nominal_radius)]
    }

    /// How far ahead of its axle the normal of a wheel of `nominal_radius` passes, over the slope of
    /// its waves [m].
    pub fn lever_per_slope(&self, nominal_radius: f64) -> f64 {
        nominal_radius / self.waves[1].rate
    }

    /// Distance from the middle of a circle of radius `radius` within which all is that overlaps by
    /// `depth` [m].
    pub fn overlapping(&self, radius: f64, depth: f64) -> f64 {
        (2.0 * radius * (depth + self.range)).sqrt()
    }

    /// Greatest distance from the middle of a circle of radius `radius` at which bodies can be
    /// nearest [m].
    pub fn reach(&self, radius: f64) -> f64 {
        (2.0 * radius * self.range).sqrt().min(radius * self.slope)
    }

    /// How far the least Q between samples can lie below the lower one of them [m].
    pub(super) fn dip(&self, radius: f64) -> f64 {
        0.5 * (1.0 / radius + self.curvature) * self.spacing * self.spacing
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::geometry::uneven::waviness::{Flat, FlatShape, Harmonic};
    use std::f64::consts::TAU;

    impl WavySection<'_> {
        /// Q at `x` for a circle of radius `radius` about `centre` [m].
        pub fn distance(&self, centre: f64, radius: f64, x: f64) -> f64 {
            let to = x - centre;
            0.5 * to * to / radius - self.nearness(x)[0]
        }
    }

    pub(in crate::geometry::uneven) const RADIUS: f64 = 0.5;

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

    /// The section of both at a `station`.
    pub(in crate::geometry::uneven) fn section<'a>(
        rail: &'a Waviness,
        wheel: &'a Waviness,
        station: f64,
    ) -> WavySection<'a> {
        let waves = |surface| Waves { surface, at: station, rate: 1.0 };
        WavySection::new(waves(rail), waves(wheel))
    }

    /// Wheels and rails with waves.
    pub(in crate::geometry::uneven) fn cases() -> [[Waviness; 2]; 6] {
        let even = || Waviness::new(None);
        let round = || Waviness::new(Some(TAU * RADIUS));
        [
            [corrugated(6e-5, 0.033), round()],
            [corrugated(2e-5, 0.033), round()],
            [corrugated(3e-5, 0.009), round()],
            [even(), flat(0.05, FlatShape::Fresh)],
            [even(), flat(0.1, FlatShape::Worn)],
            [corrugated(4e-5, 0.04), flat(0.04, FlatShape::Fresh)],
        ]
    }
}
