//! Hertzian contact: an ellipse from the curvatures at the contact point.
//!
//! With the undeformed distance A x² + B y², λ = max(A, B)/min(A, B), κ = major over minor
//! semi-axis and m = 1 - 1/κ² (Johnson, Contact Mechanics, 1985, section 4.2):
//!
//! ```text
//! λ = (κ² E - K)/(K - E),  major² = κ² E δ / (K (A + B)),  N = 2 π E* δ major / (3 K),  p0 = 3 N/(2 π a b)
//! ```

use std::f64::consts::PI;

use super::{LoadedStrip, NormalProblem, Strips, Zone};
use crate::geometry::contacts::separation::FrameSeparation;
use crate::leaves::CONTACT_MODULUS;
use crate::math::elliptic::{Complete, complete};
use crate::math::real::Real;

/// The contact ellipse and its load.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Ellipse<T = f64> {
    /// Semi-axis along rolling, a [m].
    pub semi_axis_along: T,
    /// Semi-axis across, b [m].
    pub semi_axis_across: T,
    /// Normal force [N].
    pub load: T,
    /// Greatest pressure p0 [Pa].
    pub max_pressure: T,
}

/// The ellipse for the approach δ > 0 [m] of bodies with undeformed distance `along` x² + `across`
/// y², both > 0 [1/m], and the contact modulus E* [Pa].
pub fn ellipse<T: Real>(along: T, across: T, approach: T, contact_modulus: f64) -> Ellipse<T> {
    let (axis_ratio, integrals) = axis_ratio(along.max(across) / along.min(across));
    let Complete { first, second, .. } = integrals;
    let major = axis_ratio * (second * approach / (first * (along + across))).sqrt();
    let minor = major / axis_ratio;
    let load = approach * (2.0 * PI * contact_modulus) * major / (first * 3.0);
    let (semi_axis_along, semi_axis_across) =
        if along > across { (minor, major) } else { (major, minor) };
    let max_pressure = load * 1.5 / (major * PI * minor);
    Ellipse { semi_axis_along, semi_axis_across, load, max_pressure }
}

/// Ratio κ ≥ 1 of the semi-axes for the ratio λ ≥ 1 of the curvatures, with the elliptic integrals
/// of m = 1 - 1/κ².
///
/// Starts from the rational fit of Antoine, Visa, Sauvey and Abba (2006), 5e-6 off up to λ = 1e4,
/// and corrects it by Newton steps in the logarithms.
pub(super) fn axis_ratio<T: Real>(curvature_ratio: T) -> (T, Complete<T>) {
    let moving = curvature_ratio.ln();
    let log_lambda = moving.value();
    let squared = (log_lambda / std::f64::consts::LN_10).powi(2);
    let polynomial =
        |c: [f64; 4]| 1.0 + squared * (c[0] + squared * (c[1] + squared * (c[2] + squared * c[3])));
    let exponent = 2.0 / 3.0
        * polynomial([0.402_274_36, 3.749_175_2e-2, 7.485_576_1e-4, 2.166_702_8e-6])
        / polynomial([0.426_788_78, 4.260_540_1e-2, 9.078_692_2e-4, 2.786_892_7e-6]);
    let mut log_kappa = exponent * log_lambda;
    // Of ln κ by ln λ: that of nearly equal curvatures, until there is a better one.
    let mut rate = 2.0 / 3.0;
    for _ in 0..3 {
        let integrals = complete((-2.0 * log_kappa).exp());
        // Below this the fit is exact to rounding and λ(κ) has lost its digits.
        if log_kappa < 1e-6 {
            break;
        }
        let (residual, slope) = log_curvature_ratio(log_kappa, &integrals);
        rate = 1.0 / slope;
        let step = (residual - log_lambda) / slope;
        log_kappa -= step;
        if step.abs() < 1e-9 {
            break;
        }
    }
    let log_kappa = moving.chain(log_kappa, || rate);
    (log_kappa.exp(), complete((log_kappa * -2.0).exp()))
}

/// Curvatures `along` and `across` of bodies that touch in the ellipse of ln(a/b) = `log_ratio` with
/// a b = 1 m² at an approach of 1 m: [`ellipse`] the other way round [1/m].
pub fn curvatures(log_ratio: f64) -> [f64; 2] {
    let log_kappa = log_ratio.abs();
    let integrals = complete((-2.0 * log_kappa).exp());
    let sum = log_kappa.exp() * integrals.second / integrals.first;
    // A circle has equal ones.
    let ratio = if log_kappa > 0.0 { curvature_ratio(log_kappa, &integrals) } else { 1.0 };
    let (greater, less) = (sum * ratio / (1.0 + ratio), sum / (1.0 + ratio));
    if log_ratio > 0.0 { [less, greater] } else { [greater, less] }
}

/// λ for ln κ > 0.
fn curvature_ratio(log_kappa: f64, c: &Complete) -> f64 {
    // λ = (E - (1 - m) K) / ((1 - m) (K - E))
    c.second_minus_reduced_first / ((-2.0 * log_kappa).exp() * c.first_minus_second)
}

/// ln λ as a function of ln κ, and its derivative.
fn log_curvature_ratio(log_kappa: f64, c: &Complete) -> (f64, f64) {
    let complement = (-2.0 * log_kappa).exp();
    let m = 1.0 - complement;
    let (upper, lower) = (c.second_minus_reduced_first, c.first_minus_second);
    // d upper/dm = K/2, d lower/dm = E/(2 (1 - m)); dm/d ln κ = 2 (1 - m).
    let slope =
        2.0 * complement * (0.5 * c.first / upper - 0.5 * c.second / (complement * lower)) + 2.0;
    debug_assert!(m > 0.0);
    (curvature_ratio(log_kappa, c).ln(), slope)
}

/// Least curvature across over that along which is taken as it stands: flatter or conformal pairs
/// have no Hertzian ellipse and are treated as this flat.
const MIN_CURVATURE_RATIO: f64 = 1e-3;

/// Fills `strips` with the ellipse at the contact point.
pub fn solve<T: Real>(
    problem: &NormalProblem<T>,
    separation: &mut impl FrameSeparation<T>,
    strips: &mut Strips<T>,
) {
    let along = T::from(0.5) / problem.radius;
    let across = (problem.lateral_curvature * 0.5).max(along * MIN_CURVATURE_RATIO);
    let found = ellipse(along, across, problem.approach, problem.contact_modulus);
    // Both go with the modulus.
    let [load, max_pressure] =
        [found.load, found.max_pressure].map(|own| own.scaled(1.0, CONTACT_MODULUS));
    let at = separation.point(problem.contact_u);
    let first = strips.y.len();
    for (node, weight) in problem.rule.nodes.iter().zip(&problem.rule.weights) {
        let chord = (1.0 - node * node).sqrt();
        strips.push(LoadedStrip {
            y: found.semi_axis_across * *node,
            width: found.semi_axis_across * *weight,
            x: at.x,
            half_length: found.semi_axis_along * chord,
            pressure: max_pressure * chord,
            // The contact line straight on from its contact point: the ellipse does not know more.
            u: problem.contact_u + found.semi_axis_across * *node / at.dy,
        });
    }
    strips.zones.push(Zone {
        first,
        count: problem.rule.nodes.len(),
        load,
        max_pressure,
        length: found.semi_axis_along * 2.0,
        width: found.semi_axis_across * 2.0,
        beyond: [T::from(0.0); 2],
        area: found.semi_axis_along * PI * found.semi_axis_across,
        x: at.x,
        off: T::from(0.0),
        y: T::from(0.0),
        u: problem.contact_u,
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn equal_curvatures_give_the_sphere() {
        let (radius, approach, modulus): (f64, f64, f64) = (0.5, 1e-4, 1.1e11);
        let e = ellipse(0.5 / radius, 0.5 / radius, approach, modulus);
        assert_relative_eq!(e.semi_axis_along, (radius * approach).sqrt(), max_relative = 1e-14);
        let load = 4.0 / 3.0 * modulus * radius.sqrt() * approach.powf(1.5);
        assert_relative_eq!(e.load, load, max_relative = 1e-14);
    }

    #[test]
    fn the_axis_ratio_solves_its_equation_from_round_to_slender() {
        for i in 0..60 {
            let lambda = 10f64.powf(f64::from(i) / 10.0);
            let (kappa, c) = axis_ratio(lambda);
            let back = (kappa * kappa * c.second - c.first) / (c.first - c.second);
            if i > 0 {
                assert_relative_eq!(back, lambda, max_relative = 1e-10 * lambda.max(1.0).sqrt());
            } else {
                assert_relative_eq!(kappa, 1.0, max_relative = 1e-14);
            }
        }
    }

    #[test]
    fn curvatures_are_those_of_the_ellipse_that_they_give() {
        for i in -30..=30 {
            let log_ratio = 0.1 * f64::from(i);
            let [along, across] = curvatures(log_ratio);
            let e = ellipse(along, across, 1.0, 1.0);
            let (a, b) = (e.semi_axis_along, e.semi_axis_across);
            assert_relative_eq!(a * b, 1.0, max_relative = 1e-9);
            assert_relative_eq!((a / b).ln(), log_ratio, epsilon = 1e-9);
        }
    }

    #[test]
    fn the_axis_ratio_is_smooth_where_the_ellipse_becomes_a_circle() {
        let mut previous = axis_ratio(1.0).0;
        for i in 1..200 {
            let kappa = axis_ratio(1.0 + 1e-7 * f64::from(i)).0;
            assert_relative_eq!(kappa - previous, 2.0 / 3.0 * 1e-7, max_relative = 1e-4);
            previous = kappa;
        }
    }
}
