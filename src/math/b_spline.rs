//! Uniform cubic B-splines: twice differentiable interpolation on a regular grid in any number of
//! dimensions.
//!
//! On knots at 0, 1, 2, … the spline is Σ c_k β(u - k). The coefficients of a grid come from
//! one-dimensional interpolation along one axis after the other; c_{-1} and c_n lie outside the
//! values.

/// Weights of c_{k-1} to c_{k+2} at `fraction` of the way from knot k to k + 1.
pub fn weights(fraction: f64) -> [f64; 4] {
    let (t, r) = (fraction, 1.0 - fraction);
    [
        r * r * r / 6.0,
        2.0 / 3.0 - 0.5 * t * t * (1.0 + r),
        2.0 / 3.0 - 0.5 * r * r * (1.0 + t),
        t * t * t / 6.0,
    ]
}

/// Derivatives of [`weights`] by the fraction.
pub fn weight_slopes(fraction: f64) -> [f64; 4] {
    let (t, r) = (fraction, 1.0 - fraction);
    [-0.5 * r * r, t * (1.5 * t - 2.0), r * (2.0 - 1.5 * r), 0.5 * t * t]
}

/// Knot before `u` and the fraction of the way to the next one, for coefficients of `cells` ≥ 1
/// intervals.
pub fn locate(u: f64, cells: usize) -> (usize, f64) {
    // A value that is not a number counts as 0.
    let cell = (u.max(0.0) as usize).min(cells - 1);
    (cell, u - cell as f64)
}

/// Coefficients c_{-1} to c_n of the spline through n ≥ 4 `values`; the slopes at both ends are
/// those of cubics through the last four.
pub fn coefficients(values: &[f64]) -> Vec<f64> {
    let n = values.len();
    let end_slope = |f: [f64; 4]| (-11.0 * f[0] + 18.0 * f[1] - 9.0 * f[2] + 2.0 * f[3]) / 6.0;
    let left = end_slope([values[0], values[1], values[2], values[3]]);
    let right = -end_slope([values[n - 1], values[n - 2], values[n - 3], values[n - 4]]);
    // (c_{k-1} + 4 c_k + c_{k+1})/6 = f_k, (c_1 - c_{-1})/2 and (c_n - c_{n-2})/2 the slopes; the
    // matrix is diagonally dominant.
    let mut right_side: Vec<f64> = values.iter().map(|f| 6.0 * f).collect();
    right_side[0] += 2.0 * left;
    right_side[n - 1] -= 2.0 * right;
    let mut upper = vec![0.0; n];
    for k in 0..n {
        let lower = match k {
            0 => 0.0,
            k if k == n - 1 => 2.0,
            _ => 1.0,
        };
        let before = if k > 0 { [upper[k - 1], right_side[k - 1]] } else { [0.0; 2] };
        let pivot = 4.0 - lower * before[0];
        upper[k] = if k == 0 { 2.0 } else { 1.0 } / pivot;
        right_side[k] = (right_side[k] - lower * before[1]) / pivot;
    }
    for k in (0..n - 1).rev() {
        right_side[k] -= upper[k] * right_side[k + 1];
    }
    let mut coefficients = Vec::with_capacity(n + 2);
    coefficients.push(right_side[1] - 2.0 * left);
    coefficients.extend(&right_side);
    coefficients.push(right_side[n - 2] + 2.0 * right);
    coefficients
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn value(c: &[f64], u: f64, weights: fn(f64) -> [f64; 4]) -> f64 {
        let (k, fraction) = locate(u, c.len() - 3);
        weights(fraction).iter().zip(&c[k..]).map(|(w, c)| w * c).sum()
    }

    #[test]
    fn a_cubic_is_reproduced_with_its_slope() {
        let f = |u: f64| 1.0 - 2.0 * u + 0.3 * u * u - 0.05 * u * u * u;
        let slope = |u: f64| -2.0 + 0.6 * u - 0.15 * u * u;
        let values: Vec<f64> = (0..7).map(|k| f(f64::from(k))).collect();
        let c = coefficients(&values);
        for i in 0..=60 {
            let u = 0.1 * f64::from(i);
            assert_relative_eq!(value(&c, u, weights), f(u), epsilon = 1e-13);
            assert_relative_eq!(value(&c, u, weight_slopes), slope(u), epsilon = 1e-13);
        }
    }

    #[test]
    fn any_values_are_met_at_the_knots() {
        let values: Vec<f64> = (0..9).map(|k| f64::from((7 * k) % 5)).collect();
        let c = coefficients(&values);
        for (k, expected) in values.iter().enumerate() {
            assert_relative_eq!(value(&c, k as f64, weights), expected, epsilon = 1e-13);
        }
    }
}
