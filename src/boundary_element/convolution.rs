//! Displacements of all elements under the tractions of all elements: products with an influence by
//! fast Fourier transforms.
//!
//! The product is exact (up to rounding): the grid is padded so that nothing wraps around.

use std::sync::Arc;

use realfft::num_complex::Complex;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};
use rustfft::{Fft, FftPlanner};

use super::influence::Influence;

/// Plans and scratch memory for products on one grid.
pub struct Convolution {
    along: usize,
    across: usize,
    /// Padded lengths along and across.
    padded: [usize; 2],
    rows: Arc<dyn RealToComplex<f64>>,
    rows_back: Arc<dyn ComplexToReal<f64>>,
    columns: Arc<dyn Fft<f64>>,
    columns_back: Arc<dyn Fft<f64>>,
    real: Vec<f64>,
    half_row: Vec<Complex<f64>>,
    scratch: Vec<Complex<f64>>,
    /// Spectrum under work, column after column.
    spectrum: Vec<Complex<f64>>,
}

/// The spectrum of an influence on the padded grid, scaled for the way back.
#[derive(Clone)]
pub struct Spectrum(Vec<Complex<f64>>);

impl Convolution {
    /// For grids of `along` by `across` elements.
    pub fn new(along: usize, across: usize) -> Self {
        let padded = [fast_length(2 * along - 1, 2), fast_length(2 * across - 1, 1)];
        let mut real = RealFftPlanner::new();
        let mut complex = FftPlanner::new();
        let rows = real.plan_fft_forward(padded[0]);
        let rows_back = real.plan_fft_inverse(padded[0]);
        let columns = complex.plan_fft_forward(padded[1]);
        let columns_back = complex.plan_fft_inverse(padded[1]);
        let scratch = rows
            .get_scratch_len()
            .max(rows_back.get_scratch_len())
            .max(columns.get_inplace_scratch_len())
            .max(columns_back.get_inplace_scratch_len());
        let half = padded[0] / 2 + 1;
        Self {
            along,
            across,
            padded,
            rows,
            rows_back,
            columns,
            columns_back,
            real: vec![0.0; padded[0]],
            half_row: vec![Complex::default(); half],
            scratch: vec![Complex::default(); scratch],
            spectrum: vec![Complex::default(); half * padded[1]],
        }
    }

    /// The spectrum of an influence.
    ///
    /// # Panics
    /// If the influence belongs to another grid.
    pub fn spectrum_of(&mut self, influence: &Influence) -> Spectrum {
        assert_eq!(influence.extent(), [self.along, self.across]);
        let (along, across) = (self.along as isize, self.across as isize);
        let [length, width] = self.padded;
        self.spectrum.fill(Complex::default());
        for j in 1 - across..across {
            self.real.fill(0.0);
            for (k, value) in influence.row(j).iter().enumerate() {
                let i = k as isize + 1 - along;
                self.real[i.rem_euclid(length as isize) as usize] = *value;
            }
            self.row_forward(j.rem_euclid(width as isize) as usize);
        }
        self.transform_columns(&Arc::clone(&self.columns));
        let scale = 1.0 / (length * width) as f64;
        Spectrum(self.spectrum.iter().map(|value| value * scale).collect())
    }

    /// Displacements under `tractions` by the influence with spectrum `influence`, into
    /// `displacements`.
    pub fn apply(&mut self, influence: &Spectrum, tractions: &[f64], displacements: &mut [f64]) {
        self.forward(tractions);
        for (value, factor) in self.spectrum.iter_mut().zip(&influence.0) {
            *value *= factor;
        }
        self.backward(displacements);
    }

    /// Transforms a field on the grid.
    fn forward(&mut self, field: &[f64]) {
        debug_assert_eq!(field.len(), self.along * self.across);
        self.spectrum.fill(Complex::default());
        for j in 0..self.across {
            self.real.fill(0.0);
            self.real[..self.along].copy_from_slice(&field[j * self.along..(j + 1) * self.along]);
            self.row_forward(j);
        }
        self.transform_columns(&Arc::clone(&self.columns));
    }

    /// Transforms the spectrum back onto the grid.
    fn backward(&mut self, field: &mut [f64]) {
        self.transform_columns(&Arc::clone(&self.columns_back));
        let width = self.padded[1];
        let last = self.half_row.len() - 1;
        for j in 0..self.across {
            for (k, value) in self.half_row.iter_mut().enumerate() {
                *value = self.spectrum[k * width + j];
            }
            // Real by symmetry; what rounding leaves is refused by the transform.
            self.half_row[0].im = 0.0;
            if self.padded[0].is_multiple_of(2) {
                self.half_row[last].im = 0.0;
            }
            let done = self.rows_back.process_with_scratch(
                &mut self.half_row,
                &mut self.real,
                &mut self.scratch,
            );
            debug_assert!(done.is_ok());
            field[j * self.along..(j + 1) * self.along].copy_from_slice(&self.real[..self.along]);
        }
    }

    /// Transforms `self.real` into row `j` of the spectrum.
    fn row_forward(&mut self, j: usize) {
        let done =
            self.rows.process_with_scratch(&mut self.real, &mut self.half_row, &mut self.scratch);
        debug_assert!(done.is_ok());
        let width = self.padded[1];
        for (k, value) in self.half_row.iter().enumerate() {
            self.spectrum[k * width + j] = *value;
        }
    }

    fn transform_columns(&mut self, plan: &Arc<dyn Fft<f64>>) {
        plan.process_with_scratch(&mut self.spectrum, &mut self.scratch);
    }
}

/// The least length ≥ `least` of factors 2, 3 and 5 that `divisor` divides.
pub(super) fn fast_length(least: usize, divisor: usize) -> usize {
    let is_fast = |length: usize| {
        let mut rest = length;
        for factor in [2, 3, 5] {
            while rest.is_multiple_of(factor) {
                rest /= factor;
            }
        }
        rest == 1 && length.is_multiple_of(divisor)
    };
    // There is a power of two at the latest.
    (least.max(1)..=4 * least).find(|&length| is_fast(length)).unwrap_or(least)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::boundary_element::grid::Grid;
    use crate::boundary_element::influence::{TangentialInfluence, normal_influence};
    use crate::material::{Material, MaterialPair};
    use approx::assert_relative_eq;

    fn compare(influence: &Influence, along: usize, across: usize) {
        let tractions: Vec<f64> =
            (0..along * across).map(|k| ((k * k + 3) % 17) as f64 - 5.0).collect();
        let mut convolution = Convolution::new(along, across);
        let spectrum = convolution.spectrum_of(influence);
        let mut found = vec![0.0; tractions.len()];
        convolution.apply(&spectrum, &tractions, &mut found);
        let size: f64 = 10.0 * influence.row(0).iter().map(|value| value.abs()).sum::<f64>();
        for (at, found) in found.iter().enumerate() {
            let (i, j) = ((at % along) as isize, (at / along) as isize);
            let expected: f64 = tractions
                .iter()
                .enumerate()
                .map(|(k, p)| p * influence.at(i - (k % along) as isize, j - (k / along) as isize))
                .sum();
            assert_relative_eq!(*found, expected, epsilon = 1e-13 * size, max_relative = 1e-12);
        }
    }

    #[test]
    fn products_are_those_of_the_full_matrix() {
        let steel = Material { young_modulus: 2.0, poisson_ratio: 0.3 };
        for (along, across) in [(1, 1), (1, 6), (7, 1), (6, 5), (13, 8)] {
            let grid = Grid::over([0.0, 3.0], [0.0, 2.0], along, across);
            compare(&normal_influence(&grid, 1.0), along, across);
            let rolling =
                TangentialInfluence::rolling_slip(&grid, &MaterialPair::new(steel, steel));
            for influence in [&rolling.xx, &rolling.xy, &rolling.yy] {
                compare(influence, along, across);
            }
        }
    }

    #[test]
    fn lengths_are_products_of_small_primes() {
        assert_eq!([1, 7, 97, 113, 127].map(|n| fast_length(n, 2)), [2, 8, 100, 120, 128]);
        assert_eq!(fast_length(75, 1), 75);
    }
}
