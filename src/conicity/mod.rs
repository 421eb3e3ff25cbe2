//! Rolling radius difference and equivalent conicity of a wheelset on a track.
//!
//! A free wheelset that rolls without slip follows y'' = -Δr(y)/(e r0), e the distance of the
//! contact points, r0 the rolling radius when centred. With the same wavelength as cones of the
//! angle γe of Klingel (1883), λ = 2π sqrt(e r0/(2 tan γe)), a motion of the amplitude ŷ between
//! the turning points a and b = a + 2 ŷ has the equivalent conicity
//!
//! ```text
//! S(y) = ∫ Δr dy,  S(a) = S(b),  Λ = 2 ∫_a^b dy / sqrt(2 (S(b) - S(y))),  tan γe = (2π/Λ)²/2
//! ```
//!
//! in which e and r0 have cancelled. This is the integration of the equation of motion of EN 15302.
//! Δr is taken as straight between its points. With y = (a + b)/2 + ŷ sin θ the integrand is smooth
//! up to the turning points, so that Gauss-Legendre quadrature between the points of Δr leaves
//! nothing to be seen.

mod rolling_radius;

pub use rolling_radius::{RollingRadii, TrackedWheelset};

use std::f64::consts::{FRAC_PI_2, PI};

use crate::math::quadrature::GaussLegendre;
use crate::math::root::bracketed;

/// Rolling radius difference over the lateral displacement of a wheelset, straight between its
/// points.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct RollingRadiusDifference {
    /// Displacement y and Δr = r_right - r_left [m].
    points: Vec<[f64; 2]>,
    /// S at the points [m²].
    integral: Vec<f64>,
    rule: GaussLegendre,
}

/// Nodes between two points of Δr.
const NODES: usize = 8;

impl RollingRadiusDifference {
    /// From at least two points (y, Δr), y growing, positive to the right [m].
    ///
    /// # Panics
    /// With fewer points, or with y that do not grow.
    pub fn new(points: Vec<[f64; 2]>) -> Self {
        assert!(points.len() >= 2, "a function needs two points");
        assert!(points.windows(2).all(|p| p[1][0] > p[0][0]), "y must grow");
        // S is zero next to the equilibrium: the digits of small motions about it are kept.
        let centre = equilibrium(&points).unwrap_or(0.0);
        let away = |i: &usize| (points[*i][0] - centre).abs();
        let nearest = |a: &usize, b: &usize| away(a).total_cmp(&away(b));
        let origin = (0..points.len()).min_by(nearest).unwrap_or(0);
        let cell =
            |i: usize| 0.5 * (points[i][1] + points[i + 1][1]) * (points[i + 1][0] - points[i][0]);
        let mut integral = vec![0.0; points.len()];
        for i in origin..points.len() - 1 {
            integral[i + 1] = integral[i] + cell(i);
        }
        for i in (0..origin).rev() {
            integral[i] = integral[i + 1] - cell(i);
        }
        Self { points, integral, rule: GaussLegendre::new(NODES) }
    }

    /// The points (y, Δr) [m].
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// Equivalent conicity tan γe of motions of `amplitude` > 0 [m] about the equilibrium nearest
    /// to y = 0.
    ///
    /// 0 where the wheelset does not swing at that amplitude, because Δr pushes it away from there.
    /// Nothing where the turning points lie outside the points of Δr, or there is no equilibrium.
    pub fn equivalent_conicity(&self, amplitude: f64) -> Option<f64> {
        let left = self.left_turning_point(amplitude)?;
        let right = left + 2.0 * amplitude;
        let middle = 0.5 * (left + right);
        let angle = |y: f64| ((y - middle) / amplitude).clamp(-1.0, 1.0).asin();
        let inner = self.points.iter().map(|p| p[0]).filter(|&y| y > left && y < right);
        let ends: Vec<f64> = std::iter::once(-FRAC_PI_2)
            .chain(inner.map(angle))
            .chain(std::iter::once(FRAC_PI_2))
            .collect();
        let mut length = 0.0;
        for pair in ends.windows(2) {
            let (centre, half) = (0.5 * (pair[0] + pair[1]), 0.5 * (pair[1] - pair[0]));
            for (node, weight) in self.rule.nodes.iter().zip(&self.rule.weights) {
                let angle = centre + half * node;
                let (sine, cosine) = angle.sin_cos();
                let y = middle + amplitude * sine;
                // From the nearer turning point, ŷ (1 - |sin θ|) away.
                let (end, away) = if sine > 0.0 { (right, 1.0) } else { (left, -1.0) };
                let distance = 2.0 * amplitude * (0.5 * (FRAC_PI_2 - angle.abs())).sin().powi(2);
                let squared = 2.0 * self.rise(y, end, away * distance);
                if squared <= 0.0 {
                    return Some(0.0);
                }
                length += half * weight * amplitude * cosine / squared.sqrt();
            }
        }
        // Λ is twice the length of the way from one turning point to the other.
        Some(0.5 * (PI / length).powi(2))
    }

    /// The displacement nearest to zero at which Δr vanishes [m].
    pub fn equilibrium(&self) -> Option<f64> {
        equilibrium(&self.points)
    }

    /// The a with S(a) = S(a + 2 ŷ) that is nearest to a motion centred at the equilibrium.
    fn left_turning_point(&self, amplitude: f64) -> Option<f64> {
        let [first, last] = [self.points[0][0], self.points[self.points.len() - 1][0]];
        // Rounding of the ends must not lose the greatest amplitude.
        let tolerance = 1e-12 * (last - first);
        let most = last - 2.0 * amplitude;
        let centred = self.equilibrium()? - amplitude;
        if !(amplitude > 0.0 && most >= first - tolerance) {
            return None;
        }
        let most = most.max(first);
        let difference = |a: f64| self.potential(a + 2.0 * amplitude) - self.potential(a);
        let start = centred.clamp(first, most);
        let step = (last - first) / (self.points.len() - 1) as f64;
        let mut at = [(start, difference(start)); 2];
        while at[0].0 > first || at[1].0 < most {
            for (side, limit) in [(0, first), (1, most)] {
                let from = at[side];
                let next =
                    if side == 0 { (from.0 - step).max(limit) } else { (from.0 + step).min(limit) };
                let to = (next, difference(next));
                if from.1 * to.1 <= 0.0 {
                    return Some(bracketed(from, to, 1e-16, difference));
                }
                at[side] = to;
            }
        }
        // A single admitted place, as at the greatest amplitude of a symmetric function.
        (difference(start).abs() <= 1e-9 * self.potential(start).abs()).then_some(start)
    }

    /// S(`end`) - S(`y`), with `end` - `y` given to more digits than the difference has.
    fn rise(&self, y: f64, end: f64, distance: f64) -> f64 {
        let i = self.cell(y);
        if i != self.cell(end) {
            return self.potential(end) - self.potential(y);
        }
        let ([y0, d0], [y1, d1]) = (self.points[i], self.points[i + 1]);
        let slope = (d1 - d0) / (y1 - y0);
        distance * (d0 + slope * (0.5 * (y + end) - y0))
    }

    /// The points i and i + 1 between which `y` lies.
    fn cell(&self, y: f64) -> usize {
        let after = self.points.partition_point(|p| p[0] <= y);
        after.clamp(1, self.points.len() - 1) - 1
    }

    /// S(y), y inside the points.
    fn potential(&self, y: f64) -> f64 {
        let i = self.cell(y);
        let ([y0, d0], [y1, d1]) = (self.points[i], self.points[i + 1]);
        let t = y - y0;
        self.integral[i] + t * (d0 + 0.5 * t * (d1 - d0) / (y1 - y0))
    }
}

fn equilibrium(points: &[[f64; 2]]) -> Option<f64> {
    let crossings = points.windows(2).filter(|p| p[0][1] * p[1][1] <= 0.0);
    let zeros = crossings.map(|p| {
        let ([y0, d0], [y1, d1]) = (p[0], p[1]);
        if d1 - d0 == 0.0 { 0.5 * (y0 + y1) } else { y0 - d0 * (y1 - y0) / (d1 - d0) }
    });
    zeros.min_by(|a, b| a.abs().total_cmp(&b.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn sampled(range: f64, difference: impl Fn(f64) -> f64) -> RollingRadiusDifference {
        let y = (-200..=200).map(|i| range * f64::from(i) / 200.0);
        RollingRadiusDifference::new(y.map(|y| [y, difference(y)]).collect())
    }

    #[test]
    fn a_straight_line_is_a_cone_at_every_amplitude_and_wherever_its_zero_lies() {
        for shift in [0.0, 1.234e-3, -0.5e-3] {
            let line = sampled(8e-3, |y| 2.0 * 0.17 * (y - shift));
            for amplitude in [1e-7, 1.3e-5, 1e-3, 6e-3] {
                let found = line.equivalent_conicity(amplitude).unwrap();
                assert_relative_eq!(found, 0.17, max_relative = 1e-9);
            }
            assert_relative_eq!(line.equilibrium().unwrap(), shift, epsilon = 1e-15);
        }
    }

    #[test]
    fn a_cubic_has_the_period_of_the_lemniscate() {
        // y'' = -2 y³ has the quarter period 1.311028777/ŷ.
        let cubic = sampled(8e-3, |y| 2.0 * y.powi(3) * 1e3);
        let amplitude: f64 = 5e-3;
        let wave = 4.0 * 1.311_028_777_146_06 / (amplitude * 1e3f64.sqrt());
        let expected = 0.5 * (2.0 * std::f64::consts::PI / wave).powi(2);
        let found = cubic.equivalent_conicity(amplitude).unwrap();
        assert_relative_eq!(found, expected, max_relative = 2e-4);
    }

    #[test]
    fn a_wheelset_that_is_pushed_away_has_none_and_one_too_far_out_no_answer() {
        let away = sampled(8e-3, |y| -0.1 * y);
        assert_eq!(away.equivalent_conicity(3e-3), Some(0.0));
        let cone = sampled(8e-3, |y| 0.1 * y);
        assert!(cone.equivalent_conicity(8e-3).is_some());
        assert!(cone.equivalent_conicity(8.1e-3).is_none());
        assert!(sampled(8e-3, |y| 1.0 + y).equivalent_conicity(1e-3).is_none());
    }
}
