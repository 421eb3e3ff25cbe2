//! Creep forces of an ellipse by boundary elements: what the tables are made of.
//!
//! All quantities are over μ N (moments over μ N c), lengths over c = sqrt(a b), and creepages such
//! that the shear modulus is one: G c² ξ/(μ N), G c² η/(μ N), G c³ φ/(μ N).

use std::f64::consts::PI;

use super::ellipse_force::EllipseForce;
use crate::boundary_element::grid::Grid;
use crate::boundary_element::rolling::steady_rolling;
use crate::material::{Material, MaterialPair};
use crate::math::quadrature::GaussLegendre;

/// An ellipse with Hertzian pressure on rectangular elements, in units of c and μ N.
#[derive(Clone, Debug)]
pub struct Ellipse {
    grid: Grid,
    material: MaterialPair,
    /// Mean of the bound over each element.
    bound: Vec<f64>,
}

impl Ellipse {
    /// The ellipse with semi-axes a/b = `axis_ratio` on `elements` along and as many across, for
    /// bodies of equal `poisson_ratio`.
    pub fn new(axis_ratio: f64, poisson_ratio: f64, elements: usize) -> Self {
        let a = axis_ratio.sqrt();
        let b = 1.0 / a;
        let grid = Grid::over([-a, a], [-b, b], elements, elements);
        let body = Material { young_modulus: 2.0 * (1.0 + poisson_ratio), poisson_ratio };
        let rule = GaussLegendre::new(6);
        // The mean of (3/2π) sqrt(1 - (x/a)² - (y/b)²): closed along x, quadrature across.
        let mean = |x: f64, y: f64| {
            let row = |y: f64| {
                let h = (1.0 - (y / b) * (y / b)).max(0.0).sqrt();
                let integral = |x: f64| {
                    let t = if h > 0.0 { (x / (a * h)).clamp(-1.0, 1.0) } else { 0.0 };
                    0.5 * a * h * h * (t * (1.0 - t * t).max(0.0).sqrt() + t.asin())
                };
                integral(x + 0.5 * grid.dx) - integral(x - 0.5 * grid.dx)
            };
            let nodes = rule.nodes.iter().zip(&rule.weights);
            let sum: f64 = nodes.map(|(t, w)| 0.5 * w * row(y + 0.5 * grid.dy * t)).sum();
            1.5 / PI * sum / grid.dx
        };
        let mut bound = grid.sample(mean);
        let total: f64 = bound.iter().sum::<f64>() * grid.element_area();
        for p in &mut bound {
            *p /= total;
        }
        Self { grid, material: MaterialPair::new(body, body), bound }
    }

    /// Elements along, and across.
    pub fn elements(&self) -> usize {
        self.grid.along
    }

    /// Force and moment on the body whose creepage is given, and the share of the area that slips;
    /// `None` where the solution did not converge.
    pub fn force(&self, creepage: [f64; 3]) -> Option<EllipseForce> {
        let found = steady_rolling(&self.grid, &self.material, &self.bound, &self.slip(creepage));
        let tractions = found.x.iter().zip(&found.y).map(|(x, y)| [*x, *y]);
        let count = |of: &dyn Fn(usize) -> bool| {
            (0..self.grid.len()).filter(|&k| self.bound[k] > 0.0 && of(k)).count() as f64
        };
        found.converged.then(|| EllipseForce {
            force: self.resultant(tractions),
            slip_share: count(&|k| found.slips[k]) / count(&|_| true),
        })
    }

    /// The same with no elasticity: every element slides along its rigid slip.
    #[cfg(test)]
    pub fn sliding_force(&self, creepage: [f64; 3]) -> [f64; 3] {
        let slip = self.slip(creepage);
        let tractions = self.bound.iter().zip(slip).map(|(bound, [x, y])| {
            let share = bound / x.hypot(y).max(f64::MIN_POSITIVE);
            [-share * x, -share * y]
        });
        self.resultant(tractions)
    }

    fn slip(&self, [longitudinal, lateral, spin]: [f64; 3]) -> Vec<[f64; 2]> {
        let at = |k: usize| [self.grid.x(k % self.grid.along), self.grid.y(k / self.grid.along)];
        let slip = |[x, y]: [f64; 2]| [longitudinal - spin * y, lateral + spin * x];
        (0..self.grid.len()).map(|k| slip(at(k))).collect()
    }

    fn resultant(&self, tractions: impl Iterator<Item = [f64; 2]>) -> [f64; 3] {
        let area = self.grid.element_area();
        let mut force = [0.0; 3];
        for (k, [px, py]) in tractions.enumerate() {
            let (x, y) = (self.grid.x(k % self.grid.along), self.grid.y(k / self.grid.along));
            force[0] += area * px;
            force[1] += area * py;
            force[2] += area * (x * py - y * px);
        }
        force
    }
}
