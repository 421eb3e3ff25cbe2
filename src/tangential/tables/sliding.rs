//! Full sliding of an ellipse: every particle pulls against its rigid slip.
//!
//! With spin the slip turns about a pole at x₀ = -η/φ, y₀ = ξ/φ, so that its direction depends on
//! the angle about the pole alone. Along a ray from the pole the Hertzian pressure is a half
//! ellipse again, whose moments are closed; what is left is one integral over the angle.
//!
//! Units as in [`super`]: lengths over c = sqrt(a b), forces over μ N.

use crate::math::real::Real;
use std::f64::consts::{FRAC_PI_2, PI};

/// Force and moment on the body whose creepage (ξ, η, c φ) is given; any scale of it will do.
pub fn sliding_force(log_axis_ratio: f64, [xi, eta, phi]: [f64; 3]) -> [f64; 3] {
    let slip = xi.hypotenuse(eta);
    if phi.abs() < 1e-9 * slip {
        return [-xi / slip, -eta / slip, 0.0];
    }
    let a = (0.5 * log_axis_ratio).exp();
    let ellipse = Ellipse { a, b: 1.0 / a, pole: [-eta / phi, xi / phi] };
    ellipse.integral().map(|f| phi.signum() * f)
}

struct Ellipse {
    a: f64,
    b: f64,
    pole: [f64; 2],
}

/// Points of a quadrature over the angle.
const POINTS: usize = 400;

impl Ellipse {
    /// For φ > 0.
    fn integral(&self) -> [f64; 3] {
        let Self { a, b, pole: [x, y] } = *self;
        let outside = (x / a).powi(2) + (y / b).powi(2) - 1.0;
        let mut sum = [0.0; 3];
        let mut add = |angle: f64, weight: f64| {
            let ray = self.ray(angle);
            for (sum, f) in sum.iter_mut().zip(ray) {
                *sum += weight * f;
            }
        };
        if outside > 0.0 {
            // The angles at which rays leave a unit circle, where the ellipse is stretched to one.
            let (u, v) = (x / a, y / b);
            let (middle, half) = ((-v).atan2(-u), (1.0 / u.hypotenuse(v)).min(1.0).asin());
            for k in 0..POINTS {
                // Chords vanish at the ends as the square root of the distance: in τ they are
                // smooth and flat there.
                let tau = PI * ((k as f64 + 0.5) / POINTS as f64 - 0.5);
                let weight = PI / POINTS as f64 * half * tau.cos();
                let circle = middle + half * tau.sin();
                let (cos, sin) = (a * circle.cos(), b * circle.sin());
                // dθ of the true angle for that of the circle
                let turn = a * b / (cos * cos + sin * sin);
                add(sin.atan2(cos), weight * turn);
            }
        } else {
            for k in 0..POINTS {
                let circle = 2.0 * PI * (k as f64 + 0.5) / POINTS as f64;
                let (cos, sin) = (a * circle.cos(), b * circle.sin());
                let turn = a * b / (cos * cos + sin * sin);
                add(sin.atan2(cos), 2.0 * PI / POINTS as f64 * turn);
            }
        }
        sum
    }

    /// Integral of the tractions along a ray from the pole, per angle.
    fn ray(&self, angle: f64) -> [f64; 3] {
        let Self { a, b, pole: [x, y] } = *self;
        let (cos, sin) = (angle.cos(), angle.sin());
        // p = 3/2π sqrt(α (d² - u²)), u = r - r₀ the distance from the middle of the chord
        let alpha = (cos / a).powi(2) + (sin / b).powi(2);
        let middle = -(x * cos / (a * a) + y * sin / (b * b)) / alpha;
        let inside = (1.0 - (x / a).powi(2) - (y / b).powi(2)) / alpha;
        let square = middle * middle + inside;
        if square <= 0.0 {
            return [0.0; 3];
        }
        let half = square.sqrt();
        // Moments of sqrt(d² - u²) from the pole, or from the near end of the chord, to its far
        // end.
        let from = (-middle).clamp(-half, half);
        let height = (square - from * from).max(0.0).sqrt();
        let zeroth = 0.5 * (FRAC_PI_2 * square - from * height - square * (from / half).asin());
        let first = height.powi(3) / 3.0;
        let second = 0.25 * square * zeroth + 0.25 * from * height.powi(3);
        let (r1, r2) =
            (first + middle * zeroth, second + 2.0 * middle * first + middle * middle * zeroth);
        let scale = 1.5 / PI * alpha.sqrt();
        // The traction is (sin, -cos) at every point of the ray.
        [scale * r1 * sin, -scale * r1 * cos, -scale * ((x * cos + y * sin) * r1 + r2)]
    }
}

/// A closed form near it: exact without spin, and to first order in the spin for longitudinal
/// creepage.
pub fn closed_form(log_axis_ratio: f64, [xi, eta, phi]: [f64; 3]) -> [f64; 3] {
    let a2 = log_axis_ratio.exp();
    let b2 = 1.0 / a2;
    let q2 = 0.2 * (a2 + b2);
    let u2 = xi * xi + eta * eta + q2 * phi * phi;
    let per_u = 1.0 / u2.sqrt();
    let arm = 0.2 * (a2 * xi * xi + b2 * eta * eta) + q2 * q2 * phi * phi;
    [-xi * per_u, -eta * per_u, -arm / u2 * phi * per_u]
}

/// The closed form with derivatives of each component by (ξ, η, c φ) and ln(a/b).
pub fn closed_form_and_slopes(
    log_axis_ratio: f64,
    creepage: [f64; 3],
) -> ([f64; 3], [[f64; 4]; 3]) {
    let [xi, eta, phi] = creepage;
    let force = closed_form(log_axis_ratio, creepage);
    let a2 = log_axis_ratio.exp();
    let b2 = 1.0 / a2;
    let (q2, q2_by_t) = (0.2 * (a2 + b2), 0.2 * (a2 - b2));
    let u2 = xi * xi + eta * eta + q2 * phi * phi;
    let u = u2.sqrt();
    // Logarithmic derivative of u.
    let by = [xi / u2, eta / u2, q2 * phi / u2, 0.5 * q2_by_t * phi * phi / u2];
    let m = (0.2 * (a2 * xi * xi + b2 * eta * eta) + q2 * q2 * phi * phi) / u2;
    let arm_by = [
        0.4 * a2 * xi,
        0.4 * b2 * eta,
        2.0 * q2 * q2 * phi,
        0.2 * (a2 * xi * xi - b2 * eta * eta) + 2.0 * q2 * q2_by_t * phi * phi,
    ];
    let mut slopes = [[0.0; 4]; 3];
    for k in 0..4 {
        let unit = |n: usize| if k == n { 1.0 / u } else { 0.0 };
        slopes[0][k] = -unit(0) - force[0] * by[k];
        slopes[1][k] = -unit(1) - force[1] * by[k];
        slopes[2][k] = -m * unit(2) - phi / u * arm_by[k] / u2 - 3.0 * force[2] * by[k];
    }
    (force, slopes)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tangential::tables::exact::Ellipse as Elements;
    use approx::{assert_abs_diff_eq, assert_relative_eq};

    #[test]
    fn pure_spin_of_a_circle_has_its_closed_moment() {
        let [x, y, moment] = sliding_force(0.0, [0.0, 0.0, 2.0]);
        assert_abs_diff_eq!(x, 0.0, epsilon = 1e-12);
        assert_abs_diff_eq!(y, 0.0, epsilon = 1e-12);
        assert_relative_eq!(moment, -3.0 * PI / 16.0, max_relative = 1e-10);
    }

    #[test]
    fn poles_inside_and_outside_meet_a_sum_over_elements() {
        for t in [-2.0_f64, 0.0, 1.5] {
            let elements = Elements::new(t.exp(), 0.28, 300);
            for creepage in [[0.3, -0.4, 1.0], [1.0, 2.0, 0.5], [0.01, 0.0, 1.0], [2.0, 0.3, -1.0]]
            {
                let (found, expected) =
                    (sliding_force(t, creepage), elements.sliding_force(creepage));
                for k in 0..3 {
                    assert_abs_diff_eq!(found[k], expected[k], epsilon = 3e-4);
                }
            }
        }
    }

    #[test]
    fn the_closed_form_has_the_slopes_of_differences() {
        let at = |t: f64, v: [f64; 3]| closed_form(t, v);
        for (t, v) in [(0.7, [0.4, -1.0, 0.6]), (-1.2, [1.0, 0.2, -2.0])] {
            let slopes = closed_form_and_slopes(t, v).1;
            let h = 1e-6;
            for k in 0..4 {
                let shifted = |h: f64| {
                    let mut v = v;
                    if k < 3 {
                        v[k] += h;
                        at(t, v)
                    } else {
                        at(t + h, v)
                    }
                };
                let (plus, minus) = (shifted(h), shifted(-h));
                for c in 0..3 {
                    let slope = (plus[c] - minus[c]) / (2.0 * h);
                    assert_abs_diff_eq!(slopes[c][k], slope, epsilon = 1e-8);
                }
            }
        }
    }
}
