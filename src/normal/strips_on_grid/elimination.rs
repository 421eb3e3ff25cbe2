//! Elimination without exchange of rows, for the Newton matrix of the strips.
//!
//! Its diagonal needs none: a load displaces its own node most, and so does χ of a knot with the fall there.

use super::columns::{LANES, blocks, blocks_mut};

/// Solves A x = b for the columns `matrix` of A, each of `stride` numbers, with b behind them; x takes the place of b.
///
/// The pivot of column number k is row number `pivots[k]`, in growing order; other rows are of no account. False where a pivot is none.
#[must_use]
#[allow(clippy::inline_always)]
#[inline(always)]
pub(super) fn solve(
    matrix: &mut [f64],
    stride: usize,
    pivots: &[usize],
    factors: &mut [f64],
) -> bool {
    let n = pivots.len();
    for (k, &pivot) in pivots.iter().enumerate() {
        let (done, left) = matrix.split_at_mut((k + 1) * stride);
        let own = &mut done[k * stride..];
        let inverse = 1.0 / own[pivot];
        if !inverse.is_finite() {
            return false;
        }
        let from = pivot / LANES;
        let factors = &mut blocks_mut(factors)[from..];
        let own = &mut blocks_mut(own)[from..][..factors.len()];
        for i in 0..factors.len() {
            factors[i] = own[i].map(|value| value * inverse);
        }
        // The rest of its vector is not to be taken for what is above the pivot.
        own[0][pivot % LANES + 1..].fill(0.0);
        factors[0][..=pivot % LANES].fill(0.0);
        // A node without load moves nothing but itself.
        if factors.as_flattened().iter().all(|&factor| factor == 0.0) {
            continue;
        }
        let count = factors.len();
        let mut fours = left[..(n - k) * stride].chunks_exact_mut(4 * stride);
        for four in &mut fours {
            let (one, others) = four.split_at_mut(2 * stride);
            let ((a, b), (c, d)) = (one.split_at_mut(stride), others.split_at_mut(stride));
            let shares = [a[pivot], b[pivot], c[pivot], d[pivot]];
            let [a, b, c, d] = [a, b, c, d].map(|column| &mut blocks_mut(column)[from..][..count]);
            for i in 0..count {
                let factors = factors[i];
                a[i] = less(a[i], shares[0], factors);
                b[i] = less(b[i], shares[1], factors);
                c[i] = less(c[i], shares[2], factors);
                d[i] = less(d[i], shares[3], factors);
            }
        }
        for column in fours.into_remainder().chunks_exact_mut(stride) {
            let share = column[pivot];
            let column = &mut blocks_mut(column)[from..][..count];
            for i in 0..count {
                column[i] = less(column[i], share, factors[i]);
            }
        }
    }
    let (matrix, right) = matrix.split_at_mut(n * stride);
    let right = &mut right[..stride];
    for (k, &pivot) in pivots.iter().enumerate().rev() {
        let column = &matrix[k * stride..(k + 1) * stride];
        right[pivot] /= column[pivot];
        let x = right[pivot];
        let count = pivot / LANES + 1;
        let (rows, column) = (&mut blocks_mut(right)[..count], &blocks(column)[..count]);
        for i in 0..count {
            rows[i] = less(rows[i], x, column[i]);
        }
        right[pivot] = x;
    }
    right.iter().all(|x| x.is_finite())
}

/// A vector less `share` times the `factors`.
#[allow(clippy::inline_always)]
#[inline(always)]
fn less(mut from: [f64; LANES], share: f64, factors: [f64; LANES]) -> [f64; LANES] {
    for i in 0..LANES {
        from[i] -= share * factors[i];
    }
    from
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn a_system_with_rows_of_no_account_is_solved() {
        for n in 1..=11usize {
            // Every third row counts for nothing.
            let pivots: Vec<usize> = (0..n).map(|k| k + k / 2).collect();
            let stride = (pivots[n - 1] + 1).next_multiple_of(LANES);
            let entry =
                |i: usize, j: usize| if i == j { 9.0 } else { ((7 * i + 3 * j) % 5) as f64 - 2.0 };
            let x = |j: usize| 1.0 - 0.3 * j as f64;
            let mut matrix = vec![0.0; (n + 1) * stride];
            for i in 0..n {
                for j in 0..n {
                    matrix[j * stride + pivots[i]] = entry(i, j);
                    matrix[n * stride + pivots[i]] += entry(i, j) * x(j);
                }
            }
            assert!(solve(&mut matrix, stride, &pivots, &mut vec![0.0; stride]));
            for j in 0..n {
                assert_relative_eq!(
                    matrix[n * stride + pivots[j]],
                    x(j),
                    max_relative = 1e-12,
                    epsilon = 1e-13
                );
            }
        }
        assert!(!solve(&mut [0.0; 2 * LANES], LANES, &[0], &mut [0.0; LANES]));
    }
}
