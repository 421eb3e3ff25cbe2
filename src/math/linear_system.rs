//! Dense systems of linear equations, solved in place.

use super::vectors::with_vectors;

/// Solves A x = b by Gaussian elimination with partial pivoting; `matrix` holds A by rows of length
/// `stride` ≥ n, n the length of `right`. A is destroyed, `right` becomes x.
///
/// Returns false, with `right` unusable, where A is singular to working precision.
#[must_use]
pub fn solve(matrix: &mut [f64], stride: usize, right: &mut [f64]) -> bool {
    with_vectors(
        #[inline(always)]
        || {
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
        },
    )
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
    fn a_singular_system_is_refused() {
        assert!(!solve(&mut [1.0, 2.0, 0.0, 0.0], 2, &mut [1.0, 0.0]));
        assert!(!solve(&mut [f64::NAN, 2.0, 1.0, 1.0], 2, &mut [1.0, 0.0]));
    }
}
