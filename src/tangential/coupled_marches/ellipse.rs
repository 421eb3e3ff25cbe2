//! The marches on a Hertzian ellipse, whose errors there correct them elsewhere.
//!
//! Its strips are those of the normal problem, not even ones of the exact ellipse: their hats reach
//! beyond an edge or not up to it, and marches through them have linear creep coefficients that are
//! low, that of the moment of a spin most. Where edges lie between nodes differs from patch to
//! patch, so that the forces are means over problems of a few numbers of nodes.
//!
//! Units as in [`tables`](crate::tangential::tables): lengths over c = sqrt(a b), forces over μ N,
//! a shear modulus of one.

use std::f64::consts::FRAC_PI_2;
use std::ops::RangeInclusive;

use super::solver::Solver;
use super::state::Strip;
use crate::geometry::contacts::separation::Probe;
use crate::kinematics::creepage::Creepage;
use crate::normal::Strips;
use crate::normal::hertz;
use crate::normal::least_energy::{LinePlace, OverlapLine, Section, StripSolver};

/// Nodes of the normal problems: about those of an element as it starts.
const NODES: RangeInclusive<usize> = 13..=17;

/// An ellipse and the memory to march through it.
#[derive(Clone, Debug)]
pub struct MarchedEllipse {
    solver: Solver,
    /// Strips of each normal problem.
    problems: Vec<Vec<Strip>>,
    /// Poisson's ratio of both bodies.
    pub poisson_ratio: f64,
}

impl MarchedEllipse {
    /// That of ln(a/b) = `log_ratio` for bodies of equal `poisson_ratio`.
    pub fn new(log_ratio: f64, poisson_ratio: f64) -> Self {
        let bodies = Bodies::of(log_ratio);
        let problems: Vec<_> = NODES.map(|nodes| bodies.strips(nodes)).collect();
        let most = problems.iter().map(Vec::len).max().unwrap_or(0);
        Self { solver: Solver::new(most), problems, poisson_ratio }
    }

    /// Force and moment on the body whose creepage is given.
    pub fn force(&mut self, [longitudinal, lateral, spin]: [f64; 3]) -> [f64; 3] {
        let mut force = [0.0; 3];
        for strips in &self.problems {
            self.solver.take(strips.iter().map(|strip| Strip {
                creepage: Creepage { longitudinal: longitudinal - spin * strip.y, lateral, spin },
                ..*strip
            }));
            self.solver.solve(self.poisson_ratio);
            for (strip, found) in strips.iter().zip(self.solver.resultants()) {
                let [[x, _], [y, moment]] = found.moments;
                for (sum, own) in force.iter_mut().zip([x, y, moment - strip.y * x]) {
                    *sum -= own;
                }
            }
        }
        force.map(|sum| sum / self.problems.len() as f64)
    }
}

/// Bodies whose undeformed distance is x²/(2 radius) + across y² and whose approach is one.
#[derive(Clone, Copy, Debug)]
struct Bodies {
    radius: f64,
    across: f64,
}

impl Bodies {
    /// Those that touch in an ellipse of ln(a/b) = `log_ratio` with a b = 1.
    fn of(log_ratio: f64) -> Self {
        let [along, across] = hertz::curvatures(log_ratio);
        Self { radius: 0.5 / along, across }
    }

    /// Strips of their contact by a problem of so many `nodes`, with a friction limit of one.
    fn strips(mut self, nodes: usize) -> Vec<Strip> {
        let end = self.across.sqrt().recip();
        let probes = [-1.5, -0.5, 0.5, 1.5]
            .map(|share| Probe { u: share * end, f: self.across * (share * end).powi(2) });
        let mut strips = Strips::with_capacity(1, 2 * nodes);
        StripSolver::new(nodes).solve(&mut self, &probes, 1.0, 1.0, None, &mut strips);
        let load = strips.load();
        let per_width = |j: usize| strips.pressure[j] * strips.half_length[j] * FRAC_PI_2 / load;
        let strip = |j: usize| Strip {
            y: strips.y[j],
            half_length: strips.half_length[j],
            width: strips.width[j],
            limit: per_width(j),
            shear_modulus: 1.0,
            creepage: Creepage::default(),
            load: per_width(j) * strips.width[j],
            left: 1.0,
        };
        (0..strips.y.len()).map(strip).collect()
    }
}

impl OverlapLine for Bodies {
    fn place(&mut self, u: f64) -> LinePlace {
        LinePlace {
            u,
            y: u,
            dy: 1.0,
            overlap: 1.0 - self.across * u * u,
            overlap_slope: -2.0 * self.across * u,
            x: 0.0,
            tangent: [1.0, 0.0],
        }
    }

    fn section(&mut self, _: &LinePlace) -> Section {
        Section::even(self.radius)
    }
}
