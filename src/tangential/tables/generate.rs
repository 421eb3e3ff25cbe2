//! Generation of the table: node by node from boundary elements on two grids.

use super::exact::Ellipse;
use super::nodes::{
    AZIMUTH_CELLS, ELEVATION_CELLS, HALF, RING, SATURATION_CELLS, SLIDING_AZIMUTH_CELLS,
    SLIDING_ELEVATION_CELLS, SLIDING_RING, log_ratio, ring_direction,
};
use super::scales::Scales;
use super::sliding;
use crate::math::real::Real;

/// Poisson's ratio of the table.
pub const POISSON_RATIO: f64 = 0.28;
/// Elements along and across on the two grids of the committed table.
pub const ELEMENTS: [usize; 2] = [24, 36];
/// Power of the element size with which the error falls: measured between 11x11 and 44x44 on 300
/// ellipses.
const ORDER: f64 = 1.5;

/// An ellipse of the table and where its nodes are.
#[derive(Clone, Copy, Debug)]
pub struct ScaledEllipse {
    log_ratio: f64,
    scales: Scales,
}

/// An ellipse of the table on both grids.
#[derive(Clone, Debug)]
pub struct EllipseNodes {
    scaled: ScaledEllipse,
    grids: [Ellipse; 2],
}

/// A force in the limit of small elements, the share that slips, and the estimated error of the
/// force.
#[derive(Clone, Copy, Debug)]
pub struct Extrapolated {
    /// Longitudinal and lateral force and moment over μ N, μ N c.
    pub force: [f64; 3],
    /// Share of the area that slips.
    pub slip_share: f64,
    /// Half of what the extrapolation added to the finer grid.
    pub error: f64,
}

impl ScaledEllipse {
    /// The ellipse of ln(a/b) = `log_ratio` for bodies of Poisson's ratio `poisson_ratio`.
    pub fn new(log_ratio: f64, poisson_ratio: f64) -> Self {
        Self { log_ratio, scales: Scales::of(log_ratio, poisson_ratio) }
    }

    /// Creepages v of a direction of scaled creepage and a saturation.
    pub fn creepage(&self, direction: [f64; 3], saturation: f64) -> [f64; 3] {
        let length = HALF * saturation / (1.0 - saturation);
        let Scales { kalker: [c11, c22, ..], spin, .. } = self.scales;
        let [x, y, z] = direction.map(|d| length * d);
        [x / c11, y / c22, z / spin]
    }

    /// Linear law and full sliding of creepages `v`.
    fn limits(&self, v: [f64; 3]) -> [[f64; 3]; 2] {
        [self.scales.linear(v), sliding::sliding_force(self.log_ratio, v)]
    }

    /// The force that has the `correction` at creepages `v` of a saturation.
    pub fn force(&self, v: [f64; 3], saturation: f64, correction: [f64; 4]) -> [f64; 3] {
        let [linear, full] = self.limits(v);
        let left = 1.0 - saturation;
        let squared = saturation * saturation;
        [0, 1, 2].map(|n| left * left * linear[n] + squared * (full[n] + left * correction[n]))
    }
}

impl EllipseNodes {
    /// The ellipse of ln(a/b) = `log_ratio` for bodies of Poisson's ratio `poisson_ratio` on square
    /// grids of `elements`.
    pub fn new(log_ratio: f64, poisson_ratio: f64, elements: [usize; 2]) -> Self {
        Self {
            scaled: ScaledEllipse::new(log_ratio, poisson_ratio),
            grids: elements.map(|n| Ellipse::new(log_ratio.exp(), poisson_ratio, n)),
        }
    }

    /// Ellipse number `i` of a table from square grids of `elements`.
    pub fn number(i: usize, elements: [usize; 2]) -> Self {
        Self::new(log_ratio(i), POISSON_RATIO, elements)
    }

    /// The force for creepages v; `None` where a solution did not converge.
    pub fn force(&self, v: [f64; 3]) -> Option<Extrapolated> {
        let coarse = self.grids[0].force(v)?;
        let fine = self.grids[1].force(v)?;
        let ratio = self.grids[1].elements() as f64 / self.grids[0].elements() as f64;
        let gain = 1.0 / (ratio.powf(ORDER) - 1.0);
        let limit = |fine: f64, coarse: f64| fine + gain * (fine - coarse);
        let step = [0, 1].map(|k| gain * (fine.force[k] - coarse.force[k]));
        Some(Extrapolated {
            force: [0, 1, 2].map(|k| limit(fine.force[k], coarse.force[k])),
            slip_share: limit(fine.slip_share, coarse.slip_share).clamp(0.0, 1.0),
            error: 0.5 * step[0].hypotenuse(step[1]),
        })
    }

    /// As [`ScaledEllipse::creepage`].
    pub fn creepage(&self, direction: [f64; 3], saturation: f64) -> [f64; 3] {
        self.scaled.creepage(direction, saturation)
    }

    /// Correction and share of slip, and the error estimate, at node `k` of saturation `j` from 1
    /// on.
    pub fn creep_node(&self, j: usize, k: usize) -> Option<([f64; 4], f64)> {
        let saturation = j as f64 / SATURATION_CELLS as f64;
        let direction = ring_direction(k, ELEVATION_CELLS, AZIMUTH_CELLS);
        let v = self.creepage(direction, saturation);
        let Extrapolated { force, slip_share, error } = self.force(v)?;
        let [linear, full] = self.scaled.limits(v);
        let (squared, left) = (saturation * saturation, 1.0 - saturation);
        let mut correction = [0, 1, 2]
            .map(|n| (force[n] - left * left * linear[n] - squared * full[n]) / (squared * left));
        // What the symmetries say.
        if k < AZIMUTH_CELLS {
            correction[0] = 0.0;
        }
        if k == RING - 1 {
            (correction[1], correction[2]) = (0.0, 0.0);
        }
        let [x, y, m] = correction;
        Some(([x, y, m, slip_share], error))
    }

    /// Full sliding less its closed form at node `k`.
    pub fn sliding_node(&self, k: usize) -> [f64; 3] {
        let v = ring_direction(k, SLIDING_ELEVATION_CELLS, SLIDING_AZIMUTH_CELLS);
        if k == SLIDING_RING - 1 || k.is_multiple_of(SLIDING_AZIMUTH_CELLS) {
            return [0.0; 3];
        }
        let t = self.scaled.log_ratio;
        let (exact, closed) = (sliding::sliding_force(t, v), sliding::closed_form(t, v));
        let [x, y, m] = [0, 1, 2].map(|n| exact[n] - closed[n]);
        [if k < SLIDING_AZIMUTH_CELLS { 0.0 } else { x }, y, m]
    }
}
