//! Displacements of elements under the tractions of all others, row after row with the newest
//! tractions.
//!
//! Gauss-Seidel needs the sum for one element after the other, each with the newest tractions,
//! which a transform of the whole grid cannot give. Rows can: while one is visited the others stay,
//! and their influence on it is one product of spectra along x for each of them and one transform
//! back. Sums within the row are direct. For M rows of N elements a sweep takes M² N + M N²
//! products instead of M² N².

use std::sync::Arc;

use realfft::num_complex::Complex;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};

use super::convolution::fast_length;
use super::grid::Grid;
use super::influence::{Influence, TangentialInfluence};
use crate::math::vectors::with_vectors;

/// Numbers along a row are summed in groups of this many; rows end with zeros up to the next whole
/// group.
const GROUP: usize = 4;

/// Tractions in rows that end with zeros, and the stretch of each row that is in contact.
#[derive(Clone, Debug)]
pub struct TractionRows {
    /// Numbers in a row.
    pub stride: usize,
    /// First column in contact, and whole groups of columns from it to the last.
    stretches: Vec<(usize, usize)>,
    /// Longitudinal tractions [Pa].
    pub x: Vec<f64>,
    /// Lateral tractions [Pa].
    pub y: Vec<f64>,
}

impl TractionRows {
    /// Room for the elements of `grid` with `bound` > 0, no traction.
    pub fn new(grid: &Grid, bound: &[f64]) -> Self {
        let stride = grid.along.next_multiple_of(GROUP) + GROUP;
        let stretches = bound.chunks_exact(grid.along).map(|row| {
            let first = row.iter().position(|&g| g > 0.0);
            let last = row.iter().rposition(|&g| g > 0.0);
            first
                .zip(last)
                .map_or((0, 0), |(first, last)| (first, (last + 1 - first).div_ceil(GROUP)))
        });
        let zeros = vec![0.0; stride * grid.across];
        Self { stride, stretches: stretches.collect(), x: zeros.clone(), y: zeros }
    }

    /// Whether a row is in contact.
    pub fn is_loaded(&self, j: usize) -> bool {
        self.stretches[j].1 > 0
    }
}

/// Sums of influence times traction.
pub struct Received {
    along: usize,
    across: usize,
    /// Frequencies of a row.
    frequencies: usize,
    /// xx and yy between elements of one row, by the offset of the source from the receiver, from
    /// along - 1 ahead of it; then zeros. What tractions along x do along y is odd in y and
    /// vanishes.
    own: [Vec<f64>; 2],
    /// For every offset across, -(across - 1) first: real and imaginary parts of the spectra of xx,
    /// xy and yy.
    influences: Vec<f64>,
    /// Of every row: real and imaginary parts of the spectra of both tractions.
    tractions: Vec<f64>,
    forward: Arc<dyn RealToComplex<f64>>,
    back: Arc<dyn ComplexToReal<f64>>,
    real: Vec<f64>,
    complex: Vec<Complex<f64>>,
    scratch: Vec<Complex<f64>>,
    sums: Vec<f64>,
    /// What the row under way receives from the others, along x and along y.
    from_others: [Vec<f64>; 2],
}

impl Received {
    /// For the elements of the grid of `influence` with the tractions `rows`.
    pub fn new(influence: &TangentialInfluence, rows: &TractionRows) -> Self {
        let [along, across] = influence.xx.extent();
        let padded = fast_length(2 * along - 1, 2);
        let mut planner = RealFftPlanner::new();
        let (forward, back) = (planner.plan_fft_forward(padded), planner.plan_fft_inverse(padded));
        let frequencies = padded / 2 + 1;
        let scratch = forward.get_scratch_len().max(back.get_scratch_len());
        let own = [&influence.xx, &influence.yy].map(|influence| {
            // The source ahead has the receiver behind it. A last group may reach beyond the last
            // source.
            let mut table: Vec<f64> = influence.row(0).iter().rev().copied().collect();
            table.resize(2 * along - 1 + GROUP, 0.0);
            table
        });
        let mut received = Self {
            along,
            across,
            frequencies,
            own,
            influences: vec![0.0; 6 * frequencies * (2 * across - 1)],
            tractions: vec![0.0; 4 * frequencies * across],
            forward,
            back,
            real: vec![0.0; padded],
            complex: vec![Complex::default(); frequencies],
            scratch: vec![Complex::default(); scratch],
            sums: vec![0.0; 4 * frequencies],
            from_others: [vec![0.0; along], vec![0.0; along]],
        };
        for (k, influence) in [&influence.xx, &influence.xy, &influence.yy].into_iter().enumerate()
        {
            received.transform_influence(k, influence);
        }
        for j in (0..across).filter(|&j| rows.is_loaded(j)) {
            received.renew(j, rows);
        }
        received
    }

    fn transform_influence(&mut self, k: usize, influence: &Influence) {
        let (count, padded) = (self.frequencies, self.real.len());
        for offset in 0..2 * self.across - 1 {
            self.real.fill(0.0);
            let row = influence.row(offset as isize + 1 - self.across as isize);
            for (i, value) in row.iter().enumerate() {
                let behind = i as isize + 1 - self.along as isize;
                self.real[behind.rem_euclid(padded as isize) as usize] = value / padded as f64;
            }
            self.forward_row();
            let to = &mut self.influences[(6 * offset + 2 * k) * count..][..2 * count];
            for (i, value) in self.complex.iter().enumerate() {
                (to[i], to[count + i]) = (value.re, value.im);
            }
        }
    }

    fn forward_row(&mut self) {
        let Self { forward, real, complex, scratch, .. } = self;
        let done = forward.process_with_scratch(real, complex, scratch);
        debug_assert!(done.is_ok());
    }

    /// Takes the tractions of row `j` as they are now.
    pub fn renew(&mut self, j: usize, rows: &TractionRows) {
        let count = self.frequencies;
        for (c, tractions) in [&rows.x, &rows.y].into_iter().enumerate() {
            self.real.fill(0.0);
            self.real[..self.along].copy_from_slice(&tractions[j * rows.stride..][..self.along]);
            self.forward_row();
            let to = &mut self.tractions[(4 * j + 2 * c) * count..][..2 * count];
            for (i, value) in self.complex.iter().enumerate() {
                (to[i], to[count + i]) = (value.re, value.im);
            }
        }
    }

    /// Sums what row `j` receives from the other rows, as they were taken last.
    pub fn begin_row(&mut self, j: usize, rows: &TractionRows) {
        let count = self.frequencies;
        self.sums.fill(0.0);
        for source in (0..self.across).filter(|&source| source != j && rows.is_loaded(source)) {
            let offset = j + self.across - 1 - source;
            let influence = &self.influences[6 * offset * count..][..6 * count];
            let tractions = &self.tractions[4 * source * count..][..4 * count];
            add_products(count, influence, tractions, &mut self.sums);
        }
        for c in 0..2 {
            let sums = &self.sums[2 * c * count..][..2 * count];
            for (i, value) in self.complex.iter_mut().enumerate() {
                *value = Complex::new(sums[i], sums[count + i]);
            }
            // Real by symmetry; what rounding leaves is refused by the transform.
            self.complex[0].im = 0.0;
            self.complex[count - 1].im = 0.0;
            let Self { back, real, complex, scratch, .. } = self;
            let done = back.process_with_scratch(complex, real, scratch);
            debug_assert!(done.is_ok());
            self.from_others[c].copy_from_slice(&self.real[..self.along]);
        }
    }

    /// What element `i` of row `j`, begun last, receives from all tractions.
    pub fn at(&self, i: usize, j: usize, rows: &TractionRows) -> [f64; 2] {
        let (first, groups) = rows.stretches[j];
        let (from, source, length) =
            (self.along - 1 - i + first, j * rows.stride + first, groups * GROUP);
        let [xx, yy] = [0, 1].map(|c| &self.own[c][from..from + length]);
        let [x, y] = [&rows.x, &rows.y].map(|p| &p[source..source + length]);
        let own = sums_of_products([xx, yy], [x, y]);
        [0, 1].map(|c| own[c] + self.from_others[c][i])
    }
}

/// Adds to `sums` (real and imaginary parts for x, then y) the products of the spectra of an
/// influence and of the tractions of a row.
fn add_products(count: usize, influence: &[f64], tractions: &[f64], sums: &mut [f64]) {
    with_vectors(
        #[inline(always)]
        || {
            let part = |of: usize| &influence[of * count..(of + 1) * count];
            let (xx, xxi, xy, xyi, yy, yyi) =
                (part(0), part(1), part(2), part(3), part(4), part(5));
            let part = |of: usize| &tractions[of * count..(of + 1) * count];
            let (x, xi, y, yi) = (part(0), part(1), part(2), part(3));
            let (to_x, to_y) = sums.split_at_mut(2 * count);
            let (sx, sxi) = to_x.split_at_mut(count);
            let (sy, syi) = to_y.split_at_mut(count);
            let (sxi, syi) = (&mut sxi[..count], &mut syi[..count]);
            for k in 0..count {
                sx[k] += xx[k] * x[k] - xxi[k] * xi[k] + xy[k] * y[k] - xyi[k] * yi[k];
                sxi[k] += xx[k] * xi[k] + xxi[k] * x[k] + xy[k] * yi[k] + xyi[k] * y[k];
                sy[k] += xy[k] * x[k] - xyi[k] * xi[k] + yy[k] * y[k] - yyi[k] * yi[k];
                syi[k] += xy[k] * xi[k] + xyi[k] * x[k] + yy[k] * yi[k] + yyi[k] * y[k];
            }
        },
    );
}

/// Sums of products of two pairs of rows of whole groups.
fn sums_of_products(a: [&[f64]; 2], b: [&[f64]; 2]) -> [f64; 2] {
    with_vectors(
        #[inline(always)]
        || {
            let mut sums = [[0.0; GROUP]; 2];
            let [ax, ay] = a.map(|row| row.as_chunks::<GROUP>().0);
            let [bx, by] = b.map(|row| row.as_chunks::<GROUP>().0);
            for ((ax, bx), (ay, by)) in ax.iter().zip(bx).zip(ay.iter().zip(by)) {
                for l in 0..GROUP {
                    sums[0][l] += ax[l] * bx[l];
                    sums[1][l] += ay[l] * by[l];
                }
            }
            sums.map(|groups| groups.iter().sum())
        },
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::{Material, MaterialPair};
    use approx::assert_relative_eq;

    #[test]
    fn sums_are_those_of_the_full_matrix() {
        let steel = Material { young_modulus: 2.0, poisson_ratio: 0.3 };
        for (along, across) in [(1, 1), (1, 3), (5, 1), (11, 4)] {
            let grid = Grid::over([0.0, 3.0], [0.0, 2.0], along, across);
            let influence =
                TangentialInfluence::rolling_slip(&grid, &MaterialPair::new(steel, steel));
            let bound: Vec<f64> =
                (0..grid.len()).map(|k| f64::from(u8::from(k % 7 != 2))).collect();
            let mut rows = TractionRows::new(&grid, &bound);
            let mut received = Received::new(&influence, &rows);
            let traction = |k: usize| {
                if bound[k] > 0.0 {
                    [((3 * k) % 5) as f64 - 1.5, ((7 * k) % 11) as f64 - 5.0]
                } else {
                    [0.0; 2]
                }
            };
            for k in 0..grid.len() {
                let at = k / along * rows.stride + k % along;
                [rows.x[at], rows.y[at]] = traction(k);
            }
            for j in (0..across).filter(|&j| rows.is_loaded(j)) {
                received.renew(j, &rows);
            }
            for k in 0..grid.len() {
                if k % along == 0 {
                    received.begin_row(k / along, &rows);
                }
                let mut expected = [0.0; 2];
                for source in 0..grid.len() {
                    let offset = |n: usize, m: usize| n as isize - m as isize;
                    let (i, j) =
                        (offset(k % along, source % along), offset(k / along, source / along));
                    let p = traction(source);
                    expected[0] += influence.xx.at(i, j) * p[0] + influence.xy.at(i, j) * p[1];
                    expected[1] += influence.xy.at(i, j) * p[0] + influence.yy.at(i, j) * p[1];
                }
                let found = received.at(k % along, k / along, &rows);
                for c in 0..2 {
                    assert_relative_eq!(
                        found[c],
                        expected[c],
                        epsilon = 1e-11,
                        max_relative = 1e-11
                    );
                }
            }
        }
    }
}
