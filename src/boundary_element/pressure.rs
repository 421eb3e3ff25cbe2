//! Pressure of two half-spaces pressed together: bound-constrained conjugate gradients.
//!
//! Find p ≥ 0 with the deformed distance e = h - δ + A p ≥ 0 and p e = 0 on every element: the
//! minimum of ½ p A p - (δ - h) p over p ≥ 0. Each iteration is one step of preconditioned
//! conjugate gradients on the elements in contact; pressures that turn negative leave the contact,
//! elements that overlap join it, and the directions start anew (Polonsky and Keer 1999; Vollebregt
//! 2014, "The bound-constrained conjugate gradient method for non-negative matrices").
//!
//! The preconditioner is a stencil of 5 by 5 elements, cut from the inverse of the influence on an
//! endless grid. Its weights away from the centre are not positive and their sum is not negative,
//! so that it is positive definite.

use nalgebra::{DMatrix, DVector};

use super::convolution::{Convolution, Spectrum};
use super::grid::Grid;
use super::influence::normal_influence;

/// A grid prepared for normal problems.
pub struct PressureSolver {
    grid: Grid,
    convolution: Convolution,
    spectrum: Spectrum,
    preconditioner: Stencil,
    tolerance: f64,
}

/// A pressure and how it was found.
#[derive(Clone, Debug, PartialEq)]
pub struct PressureSolution {
    /// Pressure on every element of the grid, ≥ 0 [Pa].
    pub pressure: Vec<f64>,
    /// Approach δ [m].
    pub approach: f64,
    /// Iterations of conjugate gradients, those of all approaches tried.
    pub iterations: usize,
    /// Root mean square of the distance left in the contact, over the approach [-].
    pub residual: f64,
    /// Whether the residual is within the tolerance.
    pub converged: bool,
}

/// Distance left in the contact, over the approach, at which a solution is accepted [-].
pub const TOLERANCE: f64 = 1e-5;

/// Iterations after which the search ends: 15 to 40 are usual.
const MAX_ITERATIONS: usize = 500;

impl PressureSolver {
    /// For bodies with contact modulus `contact_modulus`, E* [Pa], on the elements of `grid`.
    pub fn new(grid: Grid, contact_modulus: f64) -> Self {
        let influence = normal_influence(&grid, contact_modulus);
        let mut convolution = Convolution::new(grid.along, grid.across);
        let spectrum = convolution.spectrum_of(&influence);
        let preconditioner = Stencil::new(&grid);
        Self { grid, convolution, spectrum, preconditioner, tolerance: TOLERANCE }
    }

    /// The same with another distance left in the contact, over the approach, at which a solution
    /// is accepted [-].
    #[must_use]
    pub fn with_tolerance(self, tolerance: f64) -> Self {
        Self { tolerance, ..self }
    }

    /// The grid.
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// The pressure at the approach `approach` [m] of bodies with the undeformed distance
    /// `separation` [m] at the centres of the elements. `start` is a first guess.
    pub fn at_approach(
        &mut self,
        separation: &[f64],
        approach: f64,
        start: Option<&[f64]>,
    ) -> PressureSolution {
        let overlap: Vec<f64> = separation.iter().map(|h| approach - h).collect();
        let mut p = match start {
            Some(start) => start.to_vec(),
            None => guess(&overlap, approach),
        };
        let count = p.len();
        let mut displacement = vec![0.0; count];
        if start.is_none() {
            // The best multiple of the guess.
            self.displace(&p, &mut displacement);
            let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            let energy = dot(&p, &displacement);
            let scale = if energy > 0.0 { dot(&p, &overlap) / energy } else { 0.0 };
            for value in p.iter_mut().chain(displacement.iter_mut()) {
                *value *= scale;
            }
        } else {
            self.displace(&p, &mut displacement);
        }
        let mut rest: Vec<f64> = overlap.iter().zip(&displacement).map(|(b, u)| b - u).collect();
        let mut direction = vec![0.0; count];
        let mut image = vec![0.0; count];
        let mut scaled = vec![0.0; count];
        let mut last_rest = vec![0.0; count];
        let mut last_product = 0.0;
        let mut restart = true;
        let mut residual = f64::INFINITY;
        let limit = self.tolerance * approach.abs();
        for iteration in 0..MAX_ITERATIONS {
            // In contact: loaded, or overlapping.
            let mut joined = false;
            let (mut sum, mut elements) = (0.0, 0usize);
            for k in 0..count {
                if p[k] > 0.0 {
                    sum += rest[k] * rest[k];
                    elements += 1;
                } else if rest[k] > 0.0 {
                    sum += rest[k] * rest[k];
                    elements += 1;
                    joined |= rest[k] > limit;
                    restart |= direction[k] == 0.0;
                } else {
                    rest[k] = 0.0;
                }
            }
            residual = if elements > 0 { (sum / elements as f64).sqrt() } else { 0.0 };
            if residual <= limit && !joined {
                return solution(p, approach, iteration, residual, self.tolerance);
            }
            let in_contact = |k: usize, p: &[f64], rest: &[f64]| p[k] > 0.0 || rest[k] > 0.0;
            self.preconditioner.apply(&self.grid, &rest, &mut scaled);
            let (mut product, mut change) = (0.0, 0.0);
            for k in 0..count {
                if in_contact(k, &p, &rest) {
                    product += scaled[k] * rest[k];
                    change += scaled[k] * (rest[k] - last_rest[k]);
                }
            }
            let carried =
                if restart || last_product <= 0.0 { 0.0 } else { (change / last_product).max(0.0) };
            last_product = product;
            last_rest.copy_from_slice(&rest);
            for k in 0..count {
                direction[k] =
                    if in_contact(k, &p, &rest) { scaled[k] + carried * direction[k] } else { 0.0 };
            }
            self.displace(&direction, &mut image);
            let (mut slope, mut bend) = (0.0, 0.0);
            for k in 0..count {
                slope += rest[k] * direction[k];
                bend += direction[k] * image[k];
            }
            let step = if bend > 0.0 { slope / bend } else { 0.0 };
            let mut truncated = false;
            for k in 0..count {
                p[k] += step * direction[k];
                displacement[k] += step * image[k];
                if p[k] < 0.0 {
                    p[k] = 0.0;
                    truncated = true;
                }
            }
            restart = truncated;
            if truncated {
                self.displace(&p, &mut displacement);
            }
            for k in 0..count {
                rest[k] = overlap[k] - displacement[k];
            }
        }
        solution(p, approach, MAX_ITERATIONS, residual, self.tolerance)
    }

    /// The displacement under `tractions` [m].
    pub fn displace(&mut self, tractions: &[f64], displacement: &mut [f64]) {
        self.convolution.apply(&self.spectrum, tractions, displacement);
    }
}

fn solution(
    pressure: Vec<f64>,
    approach: f64,
    iterations: usize,
    residual: f64,
    tolerance: f64,
) -> PressureSolution {
    let residual = if approach == 0.0 { 0.0 } else { residual / approach.abs() };
    PressureSolution { pressure, approach, iterations, residual, converged: residual <= tolerance }
}

/// A pressure of about the right shape: that of Hertz has the contour lines of the separation.
fn guess(overlap: &[f64], approach: f64) -> Vec<f64> {
    // The contact is about where the undeformed bodies overlap by half of the approach.
    overlap.iter().map(|b| (b - 0.5 * approach).max(0.0).sqrt()).collect()
}

/// Symmetric weights of 5 by 5 neighbours.
struct Stencil {
    weights: [[f64; 3]; 3],
}

impl Stencil {
    /// For elements of the shape of those of `grid`.
    fn new(grid: &Grid) -> Self {
        const SIDE: usize = 7;
        let influence = normal_influence(&Grid { along: SIDE, across: SIDE, ..*grid }, 1.0);
        let matrix = DMatrix::from_fn(SIDE * SIDE, SIDE * SIDE, |a, b| {
            let offset = |a: usize, b: usize| a as isize - b as isize;
            influence.at(offset(a % SIDE, b % SIDE), offset(a / SIDE, b / SIDE))
        });
        let middle = SIDE / 2 * (SIDE + 1);
        let mut unit = DVector::zeros(SIDE * SIDE);
        unit[middle] = 1.0;
        let row = matrix.cholesky().map_or(unit.clone(), |factors| factors.solve(&unit));
        let weight = |i: usize, j: usize| {
            let weight = row[middle + j * SIDE + i] / row[middle];
            if (i, j) == (0, 0) { weight } else { weight.min(0.0) }
        };
        Self { weights: [0, 1, 2].map(|j| [0, 1, 2].map(|i| weight(i, j))) }
    }

    /// Applies the stencil to a field that is zero beyond the grid.
    fn apply(&self, grid: &Grid, field: &[f64], result: &mut [f64]) {
        let (along, across) = (grid.along, grid.across);
        result.fill(0.0);
        for j in 0..across {
            let target = &mut result[j * along..(j + 1) * along];
            for from in j.saturating_sub(2)..(j + 3).min(across) {
                let [centre, near, far] = self.weights[from.abs_diff(j)];
                let row = &field[from * along..(from + 1) * along];
                for (t, v) in target.iter_mut().zip(row) {
                    *t += centre * v;
                }
                for (offset, weight) in [(1, near), (2, far)] {
                    if offset >= along {
                        continue;
                    }
                    for (t, v) in target[offset..].iter_mut().zip(row) {
                        *t += weight * v;
                    }
                    for (t, v) in target.iter_mut().zip(&row[offset..]) {
                        *t += weight * v;
                    }
                }
            }
        }
    }
}
