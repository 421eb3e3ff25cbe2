//! A separation with two peaks for tests: f(u) = ridge (u²/c² - 1)² + tilt u, on a wheel of 0.5 m.

use super::FrameLine;
use super::solver::StripSolver;
use crate::geometry::separation::{Probe, Separation, SeparationPoint};
use crate::normal::Strips;

/// Height of the ridge between the peaks [m], half of their distance c [m], tilt [-].
#[derive(Clone, Copy, Debug)]
pub(super) struct TwoPeaks {
    pub ridge: f64,
    pub half_distance: f64,
    pub tilt: f64,
}

impl Separation for TwoPeaks {
    fn at(&mut self, u: f64) -> SeparationPoint {
        SeparationPoint { y: u, dy: 1.0, f: self.height(u), x: 0.0 }
    }
}

impl TwoPeaks {
    /// Contact modulus [Pa].
    pub const MODULUS: f64 = 1e11;

    fn height(&self, u: f64) -> f64 {
        let way = (u / self.half_distance).powi(2) - 1.0;
        self.ridge * way * way + self.tilt * u
    }

    /// Probes of the separation.
    pub fn probes(&self) -> Vec<Probe> {
        (-160..=160)
            .map(|i| f64::from(i) / 40.0 * self.half_distance)
            .map(|u| Probe { u, f: self.height(u) })
            .collect()
    }

    /// Strips under the approach `level` [m].
    pub fn pressed(mut self, solver: &mut StripSolver, level: f64) -> Strips {
        let probes = self.probes();
        let mut line = FrameLine { separation: &mut self, approach: level, radius: 0.5 };
        let mut strips = Strips::with_capacity(4, solver.rule.count());
        assert!(solver.solve(&mut line, &probes, level, Self::MODULUS, &mut strips));
        strips
    }
}
