//! Derivatives by the values of a cubic spline from those by its slopes.

/// Adds to `by_values` what a number is by the values of the natural cubic spline over `knots`, of
/// which it is `by_slopes` by the slopes that
/// [`interpolating_slopes`](super::spline::interpolating_slopes) finds: A m = B v, so v̄ += Bᵀ A⁻ᵀ m̄.
///
/// All three are as long, two numbers at least; knots grow strictly. The `work` grows to that length
/// once.
pub fn add_by_values(
    knots: &[f64],
    by_slopes: &[f64],
    by_values: &mut [f64],
    work: &mut [Vec<f64>; 2],
) {
    let n = knots.len();
    let inverse = |i: usize| 1.0 / (knots[i + 1] - knots[i]);
    // A has 2, 1 in its first row, 1, 2 in its last one, and 1/h, 2/h + 2/h', 1/h' between.
    let below = |i: usize| if i == n - 1 { 1.0 } else { inverse(i - 1) };
    let above = |i: usize| if i == 0 { 1.0 } else { inverse(i) };
    let diagonal = |i: usize| {
        if i == 0 || i == n - 1 { 2.0 } else { 2.0 * (inverse(i - 1) + inverse(i)) }
    };
    // Elimination of the transposed matrix, whose columns are dominant: without pivoting.
    let [pivots, solved] = work;
    pivots.clear();
    solved.clear();
    pivots.push(diagonal(0));
    solved.push(by_slopes[0]);
    for i in 1..n {
        let factor = above(i - 1) / pivots[i - 1];
        pivots.push(diagonal(i) - factor * below(i));
        solved.push(by_slopes[i] - factor * solved[i - 1]);
    }
    for i in (0..n).rev() {
        let behind = if i + 1 < n { below(i + 1) * solved[i + 1] } else { 0.0 };
        solved[i] = (solved[i] - behind) / pivots[i];
    }
    // Rows of B: 3 chord, and 3 (chord/h + chord'/h').
    for i in 0..n - 1 {
        let chord = inverse(i);
        let of = |row: usize| {
            let weight = if row == 0 || row == n - 1 { 1.0 } else { chord };
            3.0 * weight * solved[row]
        };
        let share = (of(i) + of(i + 1)) * chord;
        by_values[i + 1] += share;
        by_values[i] -= share;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::spline::{SplineEnd, interpolating_slopes};

    #[test]
    fn sums_of_slopes_go_back_to_values() {
        let knots = [0.0, 0.3, 0.4, 1.1, 1.9, 2.0];
        for count in 2..=knots.len() {
            let (knots, weights) = (&knots[..count], [0.7, -1.1, 0.3, 2.0, -0.4, 0.9]);
            let mut by_values = vec![0.0; count];
            add_by_values(knots, &weights[..count], &mut by_values, &mut Default::default());
            for (i, by) in by_values.iter().enumerate() {
                // The spline is linear in its values.
                let mut unit = vec![0.0; count];
                unit[i] = 1.0;
                let slopes = interpolating_slopes(knots, &unit, [SplineEnd::Natural; 2]);
                let sum: f64 = slopes.iter().zip(weights).map(|(slope, w)| slope * w).sum();
                approx::assert_relative_eq!(*by, sum, epsilon = 1e-12, max_relative = 1e-12);
            }
        }
    }
}
