//! The section of an unworn body along the arc of its profile: what the layer worn off is measured
//! from.

use super::body::Body;
use crate::geometry::curves::curve::{Curve, Knot};
use crate::math::quadrature::GaussLegendre;
use crate::math::real::Real;

/// Half length over which the curvature of the unworn profile is averaged [m]: profiles jump in
/// curvature, and the tangent of the worn one must not.
const CURVATURE_REACH: f64 = 1e-3;
/// Points on each piece of a curve: exact for what is integrated.
pub(super) const POINTS: usize = 5;

/// A knot of the unworn curve.
#[derive(Clone, Copy, Debug)]
pub(super) struct Station {
    pub(super) point: [f64; 2],
    pub(super) first: [f64; 2],
    /// Unit vector into the body.
    pub(super) inward: [f64; 2],
    /// Mean curvature about the knot, positive where the body bulges [1/m].
    pub(super) curvature: f64,
    /// Moments of the piece of the curve that ends here; see [`moments`].
    pub(super) before: [f64; 2],
    /// Length of that piece by its chord and turn [m].
    pub(super) length: f64,
}

/// The knots at parameters `knots` of an unworn curve.
pub(super) fn stations(base: &Curve, body: Body, knots: &[f64]) -> Vec<Station> {
    let rule = GaussLegendre::new(POINTS);
    let knot = |s: f64| {
        let at = base.at(s);
        Knot { s, point: at.point, tangent: at.first }
    };
    let station = |(i, &s): (usize, &f64)| {
        let [before, here] = [knot(knots[i.saturating_sub(1)]), knot(s)];
        let Knot { point, tangent: first, .. } = here;
        let length = first[0].hypotenuse(first[1]);
        let normal = [-first[1] / length, first[0] / length];
        let inward = match body {
            Body::Rail { .. } => normal,
            Body::Wheel { .. } => normal.map(|n| -n),
        };
        Station {
            point,
            first,
            inward,
            curvature: bulge(base, body, s),
            before: moments(body.radius(), [&before, &here], &rule),
            length: arc_length([before.point, point], [before.tangent, first]),
        }
    };
    knots.iter().enumerate().map(station).collect()
}

/// ∫ (R + z)² dy and ∫ z dy over the cubic between two knots, R a `radius` [m]: exact with
/// [`POINTS`] points.
pub(super) fn moments(radius: f64, [from, to]: [&Knot; 2], rule: &GaussLegendre) -> [f64; 2] {
    let h = to.s - from.s;
    let mut sums = [0.0; 2];
    if h <= 0.0 {
        return sums;
    }
    let cubic = |t: f64, c: usize| {
        hermite(t, h, [from.point[c], to.point[c]], [from.tangent[c], to.tangent[c]])
    };
    for (node, weight) in rule.nodes.iter().zip(&rule.weights) {
        let t = 0.5 * (1.0 + node);
        let ([_, dy], [z, _]) = (cubic(t, 0), cubic(t, 1));
        let share = 0.5 * h * weight * dy;
        sums = [sums[0] + share * (radius + z) * (radius + z), sums[1] + share * z];
    }
    sums
}

/// Mean curvature of an unworn profile about `s`, positive where the body bulges [1/m].
pub(super) fn bulge(base: &Curve, body: Body, s: f64) -> f64 {
    let from = (s - CURVATURE_REACH).max(base.start());
    let to = (s + CURVATURE_REACH).min(base.end());
    let (a, b) = (base.at(from).first, base.at(to).first);
    let turn = (a[0] * b[1] - a[1] * b[0]).atan2(a[0] * b[0] + a[1] * b[1]) / (to - from);
    match body {
        Body::Rail { .. } => turn,
        Body::Wheel { .. } => -turn,
    }
}

/// Share by which the circumference at `s` shrinks with the depth [1/m].
pub(super) fn shrinking(base: &Curve, body: Body, s: f64) -> f64 {
    match body {
        Body::Rail { .. } => 0.0,
        Body::Wheel { nominal_radius } => {
            let at = base.at(s);
            at.first[0] / (at.first[0].hypotenuse(at.first[1]) * (nominal_radius + at.point[1]))
        }
    }
}

/// Value and derivative of a cubic at the share `t` of a piece of length `h`.
pub(super) fn hermite(t: f64, h: f64, values: [f64; 2], slopes: [f64; 2]) -> [f64; 2] {
    let rise = (values[1] - values[0]) / h;
    let [m0, m1] = slopes;
    let (c2, c3) = ((3.0 * rise - 2.0 * m0 - m1) * t, (m0 + m1 - 2.0 * rise) * t * t);
    [values[0] + h * t * (m0 + c2 + c3), m0 + 2.0 * c2 + 3.0 * c3]
}

/// Length of an arc between two points with the tangents there, from its chord and its turn.
pub(super) fn arc_length(points: [[f64; 2]; 2], tangents: [[f64; 2]; 2]) -> f64 {
    let [p, q] = points;
    let [a, b] = tangents;
    let turn = (a[0] * b[1] - a[1] * b[0]).atan2(a[0] * b[0] + a[1] * b[1]);
    (q[0] - p[0]).hypotenuse(q[1] - p[1]) * (1.0 + turn * turn / 24.0)
}
