//! Dense systems of linear equations, solved in place.

use multiversion::multiversion;

/// Solves A x = b by Gaussian elimination with partial pivoting; `matrix` holds A by rows of length
/// `stride` ≥ n, n the length of `right`. A is destroyed, `right` becomes x.
///
/// Returns false, with `right` unusable, where A is singular to working precision.
#[must_use]
#[multiversion(targets("x86_64+avx512f+avx512dq", "x86_64+avx2", "aarch64+neon"))]
pub fn solve(matrix: &mut [f64], stride: usize, right: &mut [f64]) -> bool {
    let n = right.len();
    for column in 0..n {
        let (mut pivot, mut largest) = (column, 0.0);
        for row in column..n {
            let size = matrix[row * stride + column].abs();
            if size > largest {
                (pivot, largest) = (row, size);
            }
        }
        // Not a number compares false as well.
        if !(largest > f64::MIN_POSITIVE && largest.is_finite()) {
            return false;
        }
        if pivot != column {
            let (upper, lower) = matrix.split_at_mut(pivot * stride);
            upper[column * stride..column * stride + n].swap_with_slice(&mut lower[..n]);
            right.swap(column, pivot);
        }
        let (upper, lower) = matrix.split_at_mut((column + 1) * stride);
        let pivot_row = &upper[column * stride + column..column * stride + n];
        let inverse = 1.0 / pivot_row[0];
        let pivot_right = right[column];
        for (row, value) in lower.chunks_mut(stride).zip(right[column + 1..].iter_mut()) {
            let factor = row[column] * inverse;
            if factor != 0.0 {
                for (a, p) in row[column..n].iter_mut().zip(pivot_row) {
                    *a -= factor * p;
                }
                *value -= factor * pivot_right;
            }
        }
    }
    for row in (0..n).rev() {
        let (head, tail) = right.split_at_mut(row + 1);
        let coefficients = &matrix[row * stride + row + 1..row * stride + n];
        let known: f64 = coefficients.iter().zip(tail.iter()).map(|(a, x)| a * x).sum();
        head[row] = (head[row] - known) / matrix[row * stride + row];
    }
    right.iter().all(|x| x.is_finite())
}

/// A matrix in two triangular factors, with its rows in the order of their pivots, for many right
/// sides.
#[derive(Clone, Debug, Default)]
pub struct Factors {
    rows: Vec<f64>,
    order: Vec<usize>,
    scratch: Vec<f64>,
}

impl Factors {
    /// With room for `n` equations.
    #[must_use]
    pub fn with_capacity(n: usize) -> Self {
        let (rows, scratch) = (Vec::with_capacity(n * n), Vec::with_capacity(n));
        Self { rows, order: Vec::with_capacity(n), scratch }
    }

    /// Takes the `n` by `n` `matrix`; false where it is singular to working precision.
    #[must_use]
    pub fn of(&mut self, matrix: &[f64], n: usize) -> bool {
        self.rows.clear();
        self.rows.extend_from_slice(matrix);
        self.order.clear();
        self.order.extend(0..n);
        let rows = &mut self.rows;
        for column in 0..n {
            let size = |row: usize| rows[row * n + column].abs();
            let pivot =
                (column..n).fold(column, |best, r| if size(r) > size(best) { r } else { best });
            let largest = size(pivot);
            if !(largest > f64::MIN_POSITIVE && largest.is_finite()) {
                return false;
            }
            if pivot != column {
                let (upper, lower) = rows.split_at_mut(pivot * n);
                upper[column * n..(column + 1) * n].swap_with_slice(&mut lower[..n]);
                self.order.swap(column, pivot);
            }
            let (upper, lower) = rows.split_at_mut((column + 1) * n);
            let pivot_row = &upper[column * n + column..];
            for row in lower.chunks_mut(n) {
                let factor = row[column] / pivot_row[0];
                row[column] = factor;
                for (a, p) in row[column + 1..].iter_mut().zip(&pivot_row[1..]) {
                    *a -= factor * p;
                }
            }
        }
        true
    }

    /// Solves for one right side, in place.
    pub fn solve(&mut self, right: &mut [f64]) {
        let n = self.order.len();
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        self.scratch.clear();
        for (row, &from) in self.order.iter().enumerate() {
            let known = dot(&self.rows[row * n..row * n + row], &self.scratch);
            self.scratch.push(right[from] - known);
        }
        for row in (0..n).rev() {
            let known = dot(&self.rows[row * n + row + 1..(row + 1) * n], &right[row + 1..n]);
            right[row] = (self.scratch[row] - known) / self.rows[row * n + row];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_system_that_needs_pivots_is_solved() {
        let mut a = [0.0, 2.0, 1.0, 9.0, 1.0, 0.0, 3.0, 9.0, 4.0, 1.0, 0.0, 9.0];
        let x = [1.0, -2.0, 0.5];
        let mut b = [-3.5, 2.5, 2.0];
        assert!(solve(&mut a, 4, &mut b));
        for i in 0..3 {
            approx::assert_relative_eq!(b[i], x[i], max_relative = 1e-14);
        }
    }

    #[test]
    fn factors_solve_for_several_right_sides() {
        let a = [0.0, 2.0, 1.0, 1.0, 0.0, 3.0, 4.0, 1.0, 0.0];
        let mut factors = Factors::default();
        assert!(factors.of(&a, 3));
        for x in [[1.0, -2.0, 0.5], [0.3, 4.0, -7.0]] {
            let mut b = [0, 3, 6].map(|row| (0..3).map(|k| a[row + k] * x[k]).sum::<f64>());
            factors.solve(&mut b);
            for i in 0..3 {
                approx::assert_relative_eq!(b[i], x[i], max_relative = 1e-14);
            }
        }
        assert!(!factors.of(&[1.0, 2.0, 2.0, 4.0], 2));
    }

    #[test]
    fn a_singular_system_is_refused() {
        assert!(!solve(&mut [1.0, 2.0, 0.0, 0.0], 2, &mut [1.0, 0.0]));
        assert!(!solve(&mut [f64::NAN, 2.0, 1.0, 1.0], 2, &mut [1.0, 0.0]));
    }
}
