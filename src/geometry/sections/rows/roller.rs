//! A row of a roller along the track: a circle about its axle, higher by its corrugation.
//!
//! At the angle α forward from the top, with ρ the distance of the even row from the axle, R that
//! of the rail marker, h the corrugation and s the arc of the marker's circle that is on top,
//!
//! ```text
//! r = ρ + h(s + R α),   x = r sin α,   z = R - r cos α
//! ```
//!
//! so that z is a function of x and ρ. With r' and x' the derivatives by α,
//!
//! ```text
//! x' = r cos α + r' sin α,           ∂z/∂x = (r sin α - r' cos α)/x'
//! ∂z/∂ρ = ∂z/∂h = -r/x',             ∂²z/∂x² = (r² + 2 r'² - r r'')/x'³
//! ```
//!
//! Without corrugation z(x) = R - sqrt(ρ² - x²).

use crate::geometry::uneven::waviness::Waviness;
use crate::math::real::Real;

/// Least radius of a row, over that of the marker; square of the least height above the axle, and
/// least rate by which a row goes forward with the angle, over those of the radius [-].
const MIN_ROW: f64 = 0.1;

/// A roller of a rig, whose axle lies across the track.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::geometry) struct Roller {
    /// Distance of the rail marker from the axle, > 0 [m].
    pub radius: f64,
    /// Arc of the marker's circle that is on top, growing backwards around the roller as that
    /// brings it up when it turns under a wheel that rolls forward [m].
    pub top: f64,
}

/// A row at one place along the track.
#[derive(Clone, Copy, Debug)]
pub(in crate::geometry) struct Around<T> {
    /// Depth below the marker [m].
    pub z: T,
    /// Its derivative by the depth that the row has at the top [-].
    pub by_row: T,
    /// Derivatives of both along the track.
    pub first: [T; 2],
    /// Second derivative of the depth along the track [1/m].
    pub second: T,
}

/// A place of a row by its angle: the distance from the axle with two derivatives by the angle [m],
/// and the angle's sine and cosine.
struct Polar<T> {
    distance: [T; 3],
    sine: T,
    cosine: T,
}

impl<T: Real> Polar<T> {
    /// x' [m].
    fn forward(&self) -> T {
        let [r, first, _] = self.distance;
        (r * self.cosine + first * self.sine).at_least(MIN_ROW * r.value())
    }
}

impl Roller {
    /// The row that is `depth` [m] below the marker at the top, at `x` from the axle [m].
    pub fn row<T: Real>(&self, depth: f64, corrugation: &Waviness, x: T) -> Around<T> {
        // Rows below the axle lie inside, where nothing touches.
        let own = (self.radius - depth).max(MIN_ROW * self.radius);
        let place = if corrugation.is_empty() {
            let root = (-(x * x) + own * own).at_least(MIN_ROW * own * own).sqrt();
            let distance = [T::from(own), T::from(0.0), T::from(0.0)];
            Polar { distance, sine: x / own, cosine: root / own }
        } else {
            self.on_waves(own, corrugation, x)
        };
        let Polar { distance: [r, first, second], sine, cosine } = place;
        let inverse = T::from(1.0) / place.forward();
        let twice = second * sine + first * cosine * 2.0 - r * sine;
        Around {
            z: -(r * cosine) + self.radius,
            by_row: r * inverse,
            first: [
                (r * sine - first * cosine) * inverse,
                (first - r * twice * inverse) * inverse * inverse,
            ],
            second: (r * r + first * first * 2.0 - r * second) * inverse * inverse * inverse,
        }
    }

    /// The place at `x` of a row whose even circle has the radius `own` [m]: by Newton's method from
    /// that on the circle. Waves are so low that a step leaves their height times the square of
    /// their slope; the last one moves with x.
    fn on_waves<T: Real>(&self, own: f64, waves: &Waviness, x: T) -> Polar<T> {
        let at = |angle: f64| {
            let [height, slope, curvature] = waves.at(self.top + self.radius * angle);
            let (sine, cosine) = angle.sin_cos();
            let [first, second] = [slope * self.radius, curvature * self.radius * self.radius];
            Polar { distance: [own + height, first, second], sine, cosine }
        };
        let least = (1.0 - MIN_ROW).sqrt();
        let mut angle = (x.value() / own).clamp(-least, least).asin();
        let on_circle = at(angle);
        angle += (x.value() - on_circle.distance[0] * on_circle.sine) / on_circle.forward();
        let found = at(angle);
        let [r, first, second] = found.distance;
        let rest = (x - r * found.sine) / found.forward();
        Polar {
            distance: [rest * first + r, rest * second + first, second.into()],
            sine: rest * found.cosine + found.sine,
            cosine: rest * -found.sine + found.cosine,
        }
    }

    /// Arc of the marker's circle at `x` from the axle and the depth `z` below the marker [m].
    pub fn arc<T: Real>(&self, x: T, z: T) -> T {
        x.atan2(-z + self.radius) * self.radius + self.top
    }

    /// How much higher the corrugated roller gets at `x` from the axle and the depth `z` below the
    /// marker [m] as the arc on top grows [-].
    pub fn rise(&self, corrugation: &Waviness, x: f64, z: f64) -> f64 {
        let (sine, cosine) = x.atan2(self.radius - z).sin_cos();
        let [_, slope, _] = corrugation.at(self.arc(x, z));
        let r = x.hypotenuse(self.radius - z);
        slope / (cosine + self.radius / r * slope * sine).max(MIN_ROW)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::uneven::waviness::Harmonic;
    use approx::assert_relative_eq;
    use std::f64::consts::TAU;

    const ROLLER: Roller = Roller { radius: 0.5, top: 0.0 };

    fn waves(amplitude: f64, count: f64) -> Waviness {
        let circumference = TAU * ROLLER.radius;
        let mut waves = Waviness::new(Some(circumference));
        waves.add_harmonic(Harmonic { amplitude, wavelength: circumference / count, phase: 0.3 });
        waves
    }

    #[test]
    fn places_are_on_the_wave_and_change_as_they_say() {
        for (amplitude, count) in [(5e-5, 95.0), (2e-3, 1.0)] {
            let waves = waves(amplitude, count);
            for step in -20..=20 {
                let roller = Roller { top: 0.37, ..ROLLER };
                let (x, depth) = (0.005 * f64::from(step), 3e-3);
                let row = |x: f64, depth: f64| roller.row(depth, &waves, x);
                let here = row(x, depth);
                let angle = x.atan2(roller.radius - here.z);
                let distance = x.hypotenuse(roller.radius - here.z);
                let expected = roller.radius - depth + waves.at(0.37 + roller.radius * angle)[0];
                assert_relative_eq!(distance, expected, epsilon = 1e-13);
                let h = 1e-6;
                let [a, b] = [row(x - h, depth), row(x + h, depth)];
                let [c, d] = [row(x, depth - h), row(x, depth + h)];
                assert_relative_eq!(here.first[0], (b.z - a.z) / (2.0 * h), epsilon = 1e-8);
                assert_relative_eq!(here.by_row, (d.z - c.z) / (2.0 * h), epsilon = 1e-8);
                let bend = (b.first[0] - a.first[0]) / (2.0 * h);
                assert_relative_eq!(here.second, bend, epsilon = 1e-6);
                let turn = (b.by_row - a.by_row) / (2.0 * h);
                assert_relative_eq!(here.first[1], turn, epsilon = 1e-6);
                let [before, after] = [-h, h]
                    .map(|by| Roller { top: roller.top + by, ..roller }.row(depth, &waves, x).z);
                let rise = roller.rise(&waves, x, here.z);
                assert_relative_eq!(rise, (before - after) / (2.0 * h), epsilon = 1e-8);
            }
        }
    }

    #[test]
    fn waves_without_height_leave_the_circle() {
        let (even, none) = (Waviness::new(None), waves(0.0, 95.0));
        for x in [-0.3, -0.02, 0.0, 0.11] {
            let (a, b) = (ROLLER.row(0.01, &even, x), ROLLER.row(0.01, &none, x));
            assert_relative_eq!(a.z, b.z, epsilon = 1e-15);
            assert_relative_eq!(a.by_row, b.by_row, max_relative = 1e-14);
            assert_relative_eq!(a.first[0], b.first[0], epsilon = 1e-14);
            assert_relative_eq!(a.first[1], b.first[1], epsilon = 1e-13);
            assert_relative_eq!(a.second, b.second, max_relative = 1e-13);
        }
    }
}
