//! Gaussian elimination without pivoting, for the Newton matrix of the strips.
//!
//! No pivoting is needed: a load displaces its own node most, and χ of a knot acts most on the drop
//! there.

use super::columns::{Block, LANES};

/// Solves A x = b for the columns `matrix` of A, each of `stride` blocks, with b behind them; x
/// takes the place of b.
///
/// The pivot of column number k is row number `pivots[k]`, in growing order; other rows are of no
/// account. False where a pivot is none.
#[must_use]
#[allow(clippy::inline_always)]
#[inline(always)]
pub(super) fn solve(matrix: &mut [Block], stride: usize, pivots: &[usize]) -> bool {
    for (k, &pivot) in pivots.iter().enumerate() {
        let columns = &mut matrix[k * stride..(pivots.len() + 1) * stride];
        let (block, lane) = (pivot / LANES, pivot % LANES);
        let inverse = 1.0 / columns[block].0[lane];
        if !inverse.is_finite() {
            return false;
        }
        let mut from = block;
        while from < stride {
            let count = (stride - from).min(4);
            // Numbers of blocks that are known stay in registers.
            match count {
                1 => eliminate::<1>(columns, stride, pivot, from, inverse),
                2 => eliminate::<2>(columns, stride, pivot, from, inverse),
                3 => eliminate::<3>(columns, stride, pivot, from, inverse),
                _ => eliminate::<4>(columns, stride, pivot, from, inverse),
            }
            from += count;
        }
        // The rest of its block is not to be taken for what is above the pivot.
        columns[block].0[lane + 1..].fill(0.0);
    }
    let (matrix, right) = matrix.split_at_mut(pivots.len() * stride);
    for (column, &pivot) in matrix.chunks_exact(stride).zip(pivots).rev() {
        let (block, lane) = (pivot / LANES, pivot % LANES);
        let x = right[block].0[lane] / column[block].0[lane];
        for (rows, values) in right[..=block].iter_mut().zip(column) {
            *rows = less(rows, x, values);
        }
        right[block].0[lane] = x;
    }
    right[..stride].iter().all(|rows| rows.0.iter().all(|x| x.is_finite()))
}

/// Takes the first column out of `B` blocks of all others, those from number `from` on.
#[allow(clippy::inline_always)]
#[inline(always)]
fn eliminate<const B: usize>(
    columns: &mut [Block],
    stride: usize,
    pivot: usize,
    from: usize,
    inverse: f64,
) {
    let (own, others) = columns.split_at_mut(stride);
    let (block, lane) = (pivot / LANES, pivot % LANES);
    let mut factors = [Block::ZERO; B];
    for (factors, own) in factors.iter_mut().zip(&own[from..]) {
        *factors = own.times(inverse);
    }
    if from == block {
        factors[0].0[..=lane].fill(0.0);
    }
    // A node without load moves nothing but itself.
    if factors.iter().all(|block| block.0.iter().all(|&factor| factor == 0.0)) {
        return;
    }
    for column in others.chunks_exact_mut(stride) {
        let share = column[block].0[lane];
        for (rows, factors) in column[from..from + B].iter_mut().zip(&factors) {
            *rows = less(rows, share, factors);
        }
    }
}

/// `rows` less `share` times the `factors`.
#[allow(clippy::inline_always)]
#[inline(always)]
fn less(rows: &Block, share: f64, factors: &Block) -> Block {
    Block::of(|i| rows.0[i] - share * factors.0[i])
}

#[cfg(test)]
mod tests {
    use super::super::columns::row;
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn a_system_with_rows_of_no_account_is_solved() {
        for n in 1..=40usize {
            // Every third row counts for nothing.
            let pivots: Vec<usize> = (0..n).map(|k| k + k / 2).collect();
            let stride = pivots[n - 1] / LANES + 1;
            let entry =
                |i: usize, j: usize| if i == j { 99.0 } else { ((7 * i + 3 * j) % 5) as f64 - 2.0 };
            let x = |j: usize| 1.0 - 0.3 * j as f64;
            let mut matrix = vec![Block::ZERO; (n + 1) * stride];
            let at = |column: usize, i: usize| column * stride * LANES + pivots[i];
            for i in 0..n {
                for j in 0..n {
                    *row(&mut matrix, at(j, i)) = entry(i, j);
                    *row(&mut matrix, at(n, i)) += entry(i, j) * x(j);
                }
            }
            assert!(solve(&mut matrix, stride, &pivots));
            for j in 0..n {
                let found = *row(&mut matrix, at(n, j));
                assert_relative_eq!(found, x(j), max_relative = 1e-12, epsilon = 1e-13);
            }
        }
        assert!(!solve(&mut [Block::ZERO; 2], 1, &[0]));
    }
}
