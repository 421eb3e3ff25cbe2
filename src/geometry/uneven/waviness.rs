//! Deviation of a surface from its design along one coordinate: corrugation of a rail over its
//! station, out-of-roundness and flats of a wheel over the arc of its nominal rolling circle.
//!
//! Positive values make the body larger: a rail higher, a wheel's radius greater.

use std::f64::consts::{PI, TAU};

use crate::geometry::curves::curve::{Curve, Knot};
use crate::math::nearest_whole::nearest_whole;
use crate::math::real::Real;
use crate::math::smooth_step::smooth_step;
use crate::math::spline::{SplineEnd, interpolating_slopes};

/// A sine wave, amplitude · cos(2π c/wavelength + phase).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Harmonic {
    /// Half the distance from trough to crest, ≥ 0 [m].
    pub amplitude: f64,
    /// Wavelength, > 0 [m].
    pub wavelength: f64,
    /// Phase at the origin of the coordinate [rad].
    pub phase: f64,
}

/// Shape of a flat.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum FlatShape {
    /// A chord, as sliding leaves it; its two corners are rounded over a tenth of its length.
    #[default]
    Fresh,
    /// A hollow without corners, as rolling makes of it: -depth/2 (1 + cos(2π c/length)).
    Worn,
}

/// A flat of a wheel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flat {
    /// Length along the nominal rolling circle, > 0 [m].
    pub length: f64,
    /// Place of its middle along the nominal rolling circle [m].
    pub middle: f64,
    /// Greatest depth, > 0 [m]; that of a chord follows from its length.
    pub depth: f64,
    /// Shape.
    pub shape: FlatShape,
}

/// Half the stretch over which a corner of a fresh flat is rounded, over the length of the flat.
const CORNER_SHARE: f64 = 0.05;
/// A way over which the curvature of a table, straight between its points, surely goes on as it does
/// [m].
const PIECE: f64 = 1e-7;
/// Samples for each wavelength, and for each stretch of a flat over which it bends.
const SAMPLES_PER_WAVE: f64 = 16.0;

impl Flat {
    /// Depth of a chord of `length` in a circle of `radius`, L²/(8 R) [m].
    pub fn chord_depth(length: f64, radius: f64) -> f64 {
        length * length / (8.0 * radius)
    }

    /// Value, slope [-] and curvature [1/m] at the distance `c` from the middle [m].
    fn at(&self, c: f64) -> [f64; 3] {
        let (t, sign) = (c.abs(), c.signum());
        let [value, slope, curvature] = match self.shape {
            FlatShape::Worn if t >= 0.5 * self.length => [0.0; 3],
            FlatShape::Worn => {
                let wave = TAU / self.length;
                let (sine, cosine) = (wave * t).sin_cos();
                let half = 0.5 * self.depth;
                [-half * (1.0 + cosine), half * wave * sine, half * wave * wave * cosine]
            }
            FlatShape::Fresh => self.chord(t),
        };
        [value, sign * slope, curvature]
    }

    /// Derivative of the curvature at the distance `c` from the middle [1/m²].
    fn slope_of_curvature(&self, c: f64) -> f64 {
        let (t, sign, length) = (c.abs(), c.signum(), self.length);
        match self.shape {
            FlatShape::Worn if t >= 0.5 * length => 0.0,
            FlatShape::Worn => {
                let wave = TAU / length;
                -0.5 * sign * self.depth * wave.powi(3) * (wave * t).sin()
            }
            FlatShape::Fresh => {
                let corner = 2.0 * CORNER_SHARE * length;
                let share = (t - 0.5 * (length - corner)) / corner;
                if share <= 0.0 || share >= 1.0 {
                    return 0.0;
                }
                let bend = 12.0 * share * (1.0 - share) + 6.0 * t / corner * (1.0 - 2.0 * share);
                -sign * 8.0 * self.depth / (length * length) * bend / corner
            }
        }
    }

    /// The chord at the distance `t` ≥ 0 from its middle: slope k t, taken to zero over the corner
    /// by a smooth step.
    fn chord(&self, t: f64) -> [f64; 3] {
        let corner = 2.0 * CORNER_SHARE * self.length;
        let start = 0.5 * self.length - 0.5 * corner;
        // Slope per length 1/R, from depth = L²/(8 R).
        let rate = 8.0 * self.depth / (self.length * self.length);
        // Rise from the start of the corner to `share` of it, over the rate.
        let rise = |share: f64| {
            let [two, three, four] = [2, 3, 4].map(|power| share.powi(power));
            let five = share * four;
            corner
                * (start * (share - three + 0.5 * four)
                    + corner * (0.5 * two - 0.75 * four + 0.4 * five))
        };
        let share = (t - start) / corner;
        if share >= 1.0 {
            return [0.0; 3];
        }
        if share <= 0.0 {
            let depth = 0.5 * (start * start - t * t) + rise(1.0);
            return [-rate * depth, rate * t, rate];
        }
        let step = 1.0 - smooth_step(share);
        let bend = step - 6.0 * t * share * (1.0 - share) / corner;
        [-rate * (rise(1.0) - rise(share)), rate * t * step, rate * bend]
    }

    /// Greatest slope and curvature, and the stretch over which it bends.
    fn bounds(&self) -> [f64; 3] {
        let (d, l) = (self.depth, self.length);
        match self.shape {
            FlatShape::Worn => [PI * d / l, 2.0 * PI * PI * d / (l * l), l],
            FlatShape::Fresh => {
                let rate = 8.0 * d / (l * l);
                // The smooth step is at most 1.5 times as steep as a straight one.
                [0.55 * rate * l, 0.9 * rate / CORNER_SHARE, 8.0 * CORNER_SHARE * l]
            }
        }
    }
}

/// A sum of waves, a curve through given points and a flat.
#[derive(Clone, Debug, Default)]
pub struct Waviness {
    harmonics: Vec<Harmonic>,
    /// (coordinate, value) as a curve over the coordinate.
    table: Option<Curve>,
    flat: Option<Flat>,
    /// Length after which the surface comes again, that of the nominal rolling circle; none for a
    /// rail [m].
    period: Option<f64>,
    bounds: Bounds,
}

/// Bounds of a waviness.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bounds {
    /// Least and greatest value [m].
    pub range: [f64; 2],
    /// Greatest absolute slope [-].
    pub slope: f64,
    /// Greatest absolute curvature [1/m].
    pub curvature: f64,
    /// Distance of samples between which at most one wave is [m].
    pub spacing: f64,
}

impl Waviness {
    /// A surface without deviations; of a wheel, `period` is the length of its nominal rolling
    /// circle [m].
    pub fn new(period: Option<f64>) -> Self {
        let bounds = Bounds { spacing: f64::INFINITY, ..Bounds::default() };
        Self { period, bounds, ..Self::default() }
    }

    /// Whether there is nothing.
    pub fn is_empty(&self) -> bool {
        self.harmonics.is_empty() && self.table.is_none() && self.flat.is_none()
    }

    /// Bounds of value, slope and curvature.
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn extend(&mut self, range: [f64; 2], slope: f64, curvature: f64, spacing: f64) {
        let b = &mut self.bounds;
        b.range = [b.range[0] + range[0], b.range[1] + range[1]];
        b.slope += slope;
        b.curvature += curvature;
        b.spacing = b.spacing.min(spacing);
    }

    /// Adds a wave.
    pub fn add_harmonic(&mut self, wave: Harmonic) {
        let (a, k) = (wave.amplitude, TAU / wave.wavelength);
        self.extend([-a, a], a * k, a * k * k, wave.wavelength / SAMPLES_PER_WAVE);
        self.harmonics.push(wave);
    }

    /// Adds the flat of a wheel.
    pub fn add_flat(&mut self, flat: Flat) {
        let [slope, curvature, stretch] = flat.bounds();
        // Rounded corners make a chord a little deeper.
        self.extend([-1.01 * flat.depth, 0.0], slope, curvature, stretch / SAMPLES_PER_WAVE);
        self.flat = Some(flat);
    }

    /// Adds a curve through the points (coordinate, value) [m], at least four, the coordinates
    /// growing and, of a wheel, within one period. Twice differentiable. A rail goes on level
    /// beyond its ends.
    pub fn set_table(&mut self, points: &[[f64; 2]]) {
        let around: Vec<[f64; 2]> = match self.period {
            // The neighbours on either side stand for the rest of the wheel.
            Some(period) => [-period, 0.0, period]
                .iter()
                .flat_map(|shift| points.iter().map(move |p| [p[0] + shift, p[1]]))
                .collect(),
            None => points.to_vec(),
        };
        let at: Vec<f64> = around.iter().map(|p| p[0]).collect();
        let values: Vec<f64> = around.iter().map(|p| p[1]).collect();
        let end = if self.period.is_some() { SplineEnd::Natural } else { SplineEnd::Clamped(0.0) };
        let slopes = interpolating_slopes(&at, &values, [end; 2]);
        let knots: Vec<Knot> = (0..at.len())
            .map(|i| Knot { s: at[i], point: [at[i], values[i]], tangent: [1.0, slopes[i]] })
            .collect();
        let curve = Curve::through(&knots);
        let (mut low, mut high, mut slope, mut curvature) = (f64::MAX, f64::MIN, 0f64, 0f64);
        let mut least_step = f64::INFINITY;
        for pair in at.windows(2) {
            least_step = least_step.min(pair[1] - pair[0]);
            for i in 0..4 {
                let p = curve.at(pair[0] + 0.25 * f64::from(i) * (pair[1] - pair[0]));
                (low, high) = (low.min(p.point[1]), high.max(p.point[1]));
                slope = slope.max(p.first[1].abs());
                curvature = curvature.max(p.second[1].abs());
            }
        }
        // A cubic piece leaves the range of its samples by little; the length of a wave with that
        // height and curvature.
        let margin = 0.05 * (high - low);
        let wave = TAU * (0.5 * (high - low) / curvature.max(1e-12)).sqrt();
        let spacing = least_step.max(wave / SAMPLES_PER_WAVE);
        self.extend([low - margin, high + margin], 1.1 * slope, curvature, spacing);
        self.table = Some(curve);
    }

    /// Greatest curvature between two coordinates, at most [1/m].
    pub fn curvature_within(&self, [from, to]: [f64; 2]) -> f64 {
        let all = self.bounds.curvature;
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let beside = self.flat.filter(|flat| {
            let away = self.beside_middle(flat, middle).abs();
            away > half + 0.5 * (1.0 + 2.0 * CORNER_SHARE) * flat.length
        });
        beside.map_or(all, |flat| all - flat.bounds()[1])
    }

    /// Value at the coordinate `c`, both [m].
    pub fn height(&self, c: f64) -> f64 {
        let c = self.within_period(c);
        let wave =
            |wave: &Harmonic| wave.amplitude * (TAU / wave.wavelength * c + wave.phase).cos();
        let waves: f64 = self.harmonics.iter().map(wave).sum();
        let table = self
            .table
            .as_ref()
            .map_or(0.0, |curve| curve.at(c.clamp(curve.start(), curve.end())).point[1]);
        let flat = self.flat.map_or(0.0, |flat| flat.at(self.beside_middle(&flat, c))[0]);
        waves + table + flat
    }

    /// The coordinate that is as good as `c` and nearest to the origin [m].
    fn within_period(&self, c: f64) -> f64 {
        self.period.map_or(c, |period| c - period * nearest_whole(c / period))
    }

    /// How far a coordinate is from the middle of a flat [m].
    fn beside_middle(&self, flat: &Flat, c: f64) -> f64 {
        self.within_period(c - flat.middle)
    }

    /// Value [m], slope [-] and curvature [1/m] at the coordinate `c`, as it moves [m].
    pub fn moving<T: Real>(&self, c: T) -> [T; 3] {
        let [value, slope, curvature] = self.at(c.value());
        if !T::HAS_SLOPES {
            return [value.into(), slope.into(), curvature.into()];
        }
        let bending = || self.slope_of_curvature(c.value());
        [c.chain(value, || slope), c.chain(slope, || curvature), c.chain(curvature, bending)]
    }

    /// Derivative of the curvature at the coordinate `c` [m], of one side where that jumps [1/m²].
    fn slope_of_curvature(&self, c: f64) -> f64 {
        let c = self.within_period(c);
        let wave = |wave: &Harmonic| {
            let k = TAU / wave.wavelength;
            wave.amplitude * k.powi(3) * (k * c + wave.phase).sin()
        };
        let waves: f64 = self.harmonics.iter().map(wave).sum();
        let table = self.table.as_ref().map_or(0.0, |curve| {
            let is_there = c >= curve.start() && c + PIECE <= curve.end();
            let curvature = |c: f64| curve.at(c).second[1];
            if is_there { (curvature(c + PIECE) - curvature(c)) / PIECE } else { 0.0 }
        });
        let flat = self.flat.map_or(0.0, |f| f.slope_of_curvature(self.beside_middle(&f, c)));
        waves + table + flat
    }

    /// Value [m], slope [-] and curvature [1/m] at the coordinate `c` [m].
    pub fn at(&self, c: f64) -> [f64; 3] {
        let c = self.within_period(c);
        let mut sum = [0.0; 3];
        for wave in &self.harmonics {
            let k = TAU / wave.wavelength;
            let (sine, cosine) = (k * c + wave.phase).sin_cos();
            sum[0] += wave.amplitude * cosine;
            sum[1] -= wave.amplitude * k * sine;
            sum[2] -= wave.amplitude * k * k * cosine;
        }
        if let Some(curve) = &self.table {
            let p = curve.at(c.clamp(curve.start(), curve.end()));
            sum[0] += p.point[1];
            if c >= curve.start() && c <= curve.end() {
                sum[1] += p.first[1];
                sum[2] += p.second[1];
            }
        }
        if let Some(flat) = &self.flat {
            for (sum, part) in sum.iter_mut().zip(flat.at(self.beside_middle(flat, c))) {
                *sum += part;
            }
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Circumference of a wheel of radius 0.46 m.
    const PERIOD: f64 = TAU * 0.46;

    fn fresh(length: f64) -> Flat {
        let depth = Flat::chord_depth(length, 0.46);
        Flat { length, middle: 0.3, depth, shape: FlatShape::Fresh }
    }

    fn all() -> Vec<Waviness> {
        let wheel = || Waviness::new(Some(PERIOD));
        let mut waves = wheel();
        waves.add_harmonic(Harmonic { amplitude: 1e-4, wavelength: PERIOD / 3.0, phase: 0.4 });
        waves.add_flat(Flat { length: 0.06, middle: 2.88, depth: 4e-4, shape: FlatShape::Worn });
        let mut flat = wheel();
        flat.add_flat(fresh(0.05));
        let mut table = wheel();
        let points: Vec<[f64; 2]> = (0..90)
            .map(|i| PERIOD * f64::from(i) / 90.0)
            .map(|c| [c, 2e-4 * (TAU * 5.0 * c / PERIOD).sin()])
            .collect();
        table.set_table(&points);
        vec![waves, flat, table]
    }

    #[test]
    fn slopes_and_curvatures_are_those_of_the_values_and_within_their_bounds() {
        for waviness in all() {
            let bounds = waviness.bounds();
            let step = 1e-6;
            for i in 0..30_000 {
                let c = PERIOD * f64::from(i) / 30_000.0 + 1.3e-5;
                let [value, slope, curvature] = waviness.at(c);
                let [before, after] = [waviness.at(c - step), waviness.at(c + step)];
                assert!((slope - (after[0] - before[0]) / (2.0 * step)).abs() < 2e-5, "{c}");
                // Where the curvature does not jump.
                if (after[2] - before[2]).abs() < 0.1 * bounds.curvature {
                    let difference = (after[1] - before[1]) / (2.0 * step);
                    assert!((curvature - difference).abs() < 1e-2 * bounds.curvature, "{c}");
                }
                assert!(value >= bounds.range[0] && value <= bounds.range[1], "{value} at {c}");
                assert!(slope.abs() <= bounds.slope && curvature.abs() <= bounds.curvature * 1.001);
            }
        }
    }

    #[test]
    fn a_wheel_comes_again_after_a_revolution_without_a_step() {
        for waviness in all() {
            for c in [0.0, 0.1, 2.87] {
                assert_relative_eq!(waviness.at(c)[0], waviness.at(c + PERIOD)[0], epsilon = 1e-12);
            }
            let [before, after] = [-1e-9, 1e-9].map(|c| waviness.at(c)[0]);
            assert!((before - after).abs() < 1e-10);
        }
    }

    #[test]
    fn a_chord_is_as_deep_as_a_chord() {
        let mut waviness = Waviness::new(Some(PERIOD));
        let flat = fresh(0.05);
        waviness.add_flat(flat);
        // Rounding of the corners adds some.
        assert_relative_eq!(waviness.at(0.3)[0], -flat.depth, max_relative = 5e-3);
        assert_relative_eq!(waviness.at(0.3)[2], 1.0 / 0.46, max_relative = 1e-12);
    }

    #[test]
    fn a_rail_goes_on_level_beyond_its_table() {
        let mut rail = Waviness::new(None);
        rail.set_table(&[[0.0, 0.0], [0.1, 1e-4], [0.2, 0.0], [0.3, 2e-4]]);
        assert_relative_eq!(rail.at(0.1)[0], 1e-4, max_relative = 1e-12);
        assert!(rail.at(-5.0).iter().all(|part| part.abs() <= 0.0));
        assert_relative_eq!(rail.at(7.0)[0], 2e-4, max_relative = 1e-12);
        assert!(rail.at(7.0)[1].abs() <= 0.0);
    }
}
