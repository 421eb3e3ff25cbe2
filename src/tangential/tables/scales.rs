//! Scales of the creepages and the linear forces of an ellipse.

use super::super::kalker_coefficients;
use super::nodes::SPIN_BY_WIDTH;
use crate::math::dual::Dual;

/// Kalker's coefficients of an ellipse and the scale of spin, with their derivatives by ln(a/b).
#[derive(Clone, Copy, Debug)]
pub struct Scales {
    /// ln(a/b).
    pub log_ratio: f64,
    /// Poisson's ratio, and how it grows with ln(a/b) where derivatives are taken: 0, or 1 by
    /// [`with_ratio_along`](Self::with_ratio_along).
    pub poisson_ratio: f64,
    pub poisson_slope: f64,
    /// c11, c22, c23, c33.
    pub kalker: [f64; 4],
    /// Their derivatives.
    pub kalker_slopes: [f64; 4],
    /// ζ: linear lateral force of spin, and a share of the longitudinal force that the creepage φ b
    /// would have.
    pub spin: f64,
    /// Its derivative.
    pub spin_slope: f64,
}

impl Scales {
    /// Scales of an ellipse of ln(a/b) = `log_ratio`.
    pub fn of(log_ratio: f64, poisson_ratio: f64) -> Self {
        let logarithms = kalker_coefficients::logarithms(log_ratio, poisson_ratio);
        let kalker = logarithms.map(|[c, _]| c.exp());
        let kalker_slopes = [0, 1, 2, 3].map(|k| kalker[k] * logarithms[k][1]);
        let narrow = SPIN_BY_WIDTH * (-0.5 * log_ratio).exp();
        Self {
            log_ratio,
            poisson_ratio,
            poisson_slope: 0.0,
            kalker,
            kalker_slopes,
            spin: kalker[2] + narrow * kalker[0],
            spin_slope: kalker_slopes[2] + narrow * (kalker_slopes[0] - 0.5 * kalker[0]),
        }
    }

    /// The same scales with derivatives by ln(a/b) to which those by Poisson's ratio are added, as
    /// if the ratio, `poisson_ratio` here, grew with ln(a/b).
    pub fn with_ratio_along(&self, poisson_ratio: f64) -> Self {
        let logarithms =
            kalker_coefficients::logarithms(self.log_ratio, Dual::<1>::variable(poisson_ratio, 0));
        let by_ratio = [0, 1, 2, 3].map(|k| self.kalker[k] * logarithms[k][0].slopes[0]);
        let narrow = SPIN_BY_WIDTH * (-0.5 * self.log_ratio).exp();
        Self {
            poisson_slope: 1.0,
            kalker_slopes: [0, 1, 2, 3].map(|k| self.kalker_slopes[k] + by_ratio[k]),
            spin_slope: self.spin_slope + by_ratio[2] + narrow * by_ratio[0],
            ..*self
        }
    }

    /// Linear force and moment for creepages v.
    pub fn linear(&self, [v1, v2, v3]: [f64; 3]) -> [f64; 3] {
        let [c11, c22, c23, c33] = self.kalker;
        [-c11 * v1, -c22 * v2 - c23 * v3, c23 * v2 - c33 * v3]
    }

    pub(super) fn linear_slopes(&self, [v1, v2, v3]: [f64; 3]) -> [[f64; 4]; 3] {
        let [c11, c22, c23, c33] = self.kalker;
        let [s11, s22, s23, s33] = self.kalker_slopes;
        [
            [-c11, 0.0, 0.0, -s11 * v1],
            [0.0, -c22, -c23, -s22 * v2 - s23 * v3],
            [0.0, c23, -c33, s23 * v2 - s33 * v3],
        ]
    }

    /// The scaled creepages X.
    pub(super) fn scaled(&self, [v1, v2, v3]: [f64; 3]) -> [f64; 3] {
        [self.kalker[0] * v1, self.kalker[1] * v2, self.spin * v3]
    }
}
