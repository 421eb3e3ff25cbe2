//! The marches on a Hertzian ellipse, whose errors there correct them elsewhere.
//!
//! Units as in [`tables`](crate::tangential::tables): lengths over c = sqrt(a b), forces over μ N,
//! a shear modulus of one.

use super::solver::Solver;
use super::state::Strip;
use crate::kinematics::creepage::Creepage;

/// Strips across the ellipse.
const STRIPS: usize = 16;

/// An ellipse and the memory to march through it.
#[derive(Clone, Debug)]
pub struct MarchedEllipse {
    solver: Solver,
    strips: Vec<Strip>,
    poisson_ratio: f64,
}

impl MarchedEllipse {
    /// That of ln(a/b) = `log_ratio` for bodies of equal `poisson_ratio`.
    #[must_use]
    pub fn new(log_ratio: f64, poisson_ratio: f64) -> Self {
        Self::with_strips(STRIPS, log_ratio, poisson_ratio)
    }

    /// The same in a number of strips.
    #[must_use]
    pub fn with_strips(count: usize, log_ratio: f64, poisson_ratio: f64) -> Self {
        let a = (0.5 * log_ratio).exp();
        let b = 1.0 / a;
        let width = 2.0 * b / count as f64;
        let places = (0..count).map(|j| (2 * j + 1) as f64 / count as f64 - 1.0);
        let load: f64 = places.clone().map(|u| (1.0 - u * u) * width).sum();
        let strips = places.map(|u| Strip {
            y: b * u,
            half_length: a * (1.0 - u * u).sqrt(),
            width,
            limit: (1.0 - u * u) / load,
            shear_modulus: 1.0,
            creepage: Creepage::default(),
            load: (1.0 - u * u) * width / load,
            left: 1.0,
        });
        Self { solver: Solver::new(count), strips: strips.collect(), poisson_ratio }
    }

    /// Force and moment on the body whose creepage is given.
    pub fn force(&mut self, [longitudinal, lateral, spin]: [f64; 3]) -> [f64; 3] {
        self.solver.take(self.strips.iter().map(|strip| Strip {
            creepage: Creepage { longitudinal: longitudinal - spin * strip.y, lateral, spin },
            ..*strip
        }));
        self.solver.solve(self.poisson_ratio);
        let mut force = [0.0; 3];
        for (strip, found) in self.strips.iter().zip(self.solver.resultants()) {
            let [[x, _], [y, moment]] = found.moments;
            for (sum, own) in force.iter_mut().zip([x, y, moment - strip.y * x]) {
                *sum -= own;
            }
        }
        force
    }
}
