//! Places on a curve by the length of its arc, from its start or from a place with an arc of its
//! own.

use crate::geometry::curves::curve::Curve;
use crate::math::quadrature::GaussLegendre;

/// The length of the arc of a curve from its start to each of its knots.
#[derive(Clone, Debug)]
pub struct ArcLength<'a> {
    curve: &'a Curve,
    knots: Vec<f64>,
    arcs: Vec<f64>,
    rule: GaussLegendre,
    /// Arc at the start of the curve [m].
    begin: f64,
}

/// Points of the rule on each cubic piece, whose speed is nearly constant.
const POINTS: usize = 4;
/// Newton steps to a place, and the step at which it is found [m].
const MAX_STEPS: usize = 8;
const LAST_STEP: f64 = 1e-13;

impl<'a> ArcLength<'a> {
    /// Of `curve`.
    pub fn new(curve: &'a Curve) -> Self {
        let knots: Vec<f64> = curve.knots().collect();
        let mut arcs = Self {
            curve,
            arcs: vec![0.0; knots.len()],
            knots,
            rule: GaussLegendre::new(POINTS),
            begin: 0.0,
        };
        for k in 1..arcs.knots.len() {
            arcs.arcs[k] = arcs.arcs[k - 1] + arcs.between(arcs.knots[k - 1], arcs.knots[k]);
        }
        arcs
    }

    /// The same arcs, counted so that the place with the parameter `s` has the arc `arc` [m].
    #[must_use]
    pub fn counted(self, s: f64, arc: f64) -> Self {
        let begin = arc - (self.arc(s) - self.begin);
        Self { begin, ..self }
    }

    /// Length of the arc between two parameters of one piece [m].
    fn between(&self, a: f64, b: f64) -> f64 {
        let half = 0.5 * (b - a);
        let points = self.rule.nodes.iter().zip(&self.rule.weights);
        half * points.map(|(t, w)| w * self.speed(a + half * (1.0 + t))).sum::<f64>()
    }

    fn speed(&self, s: f64) -> f64 {
        let [y, z] = self.curve.at(s).first;
        (y * y + z * z).sqrt()
    }

    /// Length of the whole arc [m].
    pub fn length(&self) -> f64 {
        self.arcs.last().copied().unwrap_or(0.0)
    }

    /// Arc at the parameter `s` of the curve [m].
    pub fn arc(&self, s: f64) -> f64 {
        let k = self.knots.partition_point(|&knot| knot <= s).clamp(1, self.knots.len() - 1) - 1;
        self.begin + (self.arcs[k] + self.between(self.knots[k], s))
    }

    /// Parameter of the curve at the arc `arc`; nothing beyond the ends of the curve [m].
    pub fn parameter(&self, arc: f64) -> Option<f64> {
        let arc = arc - self.begin;
        if !(arc > 0.0 && arc < self.length()) {
            return None;
        }
        let k = self.arcs.partition_point(|&a| a <= arc).clamp(1, self.arcs.len() - 1) - 1;
        let (a, b) = (self.knots[k], self.knots[k + 1]);
        let mut s = a + (b - a) * (arc - self.arcs[k]) / (self.arcs[k + 1] - self.arcs[k]);
        for _ in 0..MAX_STEPS {
            let step = (arc - self.arcs[k] - self.between(a, s)) / self.speed(s);
            s += step;
            if step.abs() <= LAST_STEP {
                break;
            }
        }
        Some(s)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::curves::curve::Knot;
    use approx::assert_relative_eq;

    #[test]
    fn arcs_of_a_circle_are_its_angles() {
        let radius = 0.08;
        // Parameters that are no arcs.
        let knots: Vec<Knot> = (0..=200)
            .map(|i| {
                let (s, angle) = (1e-3 * f64::from(i), 0.01 * f64::from(i));
                let (sine, cosine) = angle.sin_cos();
                let tangent = [10.0 * radius * cosine, 10.0 * radius * sine];
                Knot { s, point: [radius * sine, radius * (1.0 - cosine)], tangent }
            })
            .collect();
        let curve = Curve::through(&knots);
        let arcs = ArcLength::new(&curve);
        assert_relative_eq!(arcs.length(), 2.0 * radius, max_relative = 1e-9);
        for s in [0.0, 0.031, 0.0507, 0.1999] {
            assert_relative_eq!(arcs.arc(s), 10.0 * s * radius, epsilon = 1e-11);
            if s > 0.0 {
                assert_relative_eq!(arcs.parameter(arcs.arc(s)).unwrap(), s, epsilon = 1e-12);
            }
        }
        assert!(arcs.parameter(-1e-9).is_none() && arcs.parameter(0.161).is_none());
        let moved = arcs.clone().counted(0.05, 0.3);
        assert_relative_eq!(moved.arc(0.06), 0.3 + 0.1 * radius, epsilon = 1e-11);
        assert_relative_eq!(moved.parameter(0.3 - 0.1 * radius).unwrap(), 0.04, epsilon = 1e-11);
    }
}
