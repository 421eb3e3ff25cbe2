//! Cubic splines through given values, and near them: interpolation and smoothing.
//!
//! A cubic spline is handed over as its values and first derivatives at the knots, which fix it.
//! Plane curves take one spline for each coordinate over the same parameter.

/// How an interpolating spline ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SplineEnd {
    /// Vanishing second derivative.
    Natural,
    /// Given first derivative.
    Clamped(f64),
}

/// Values and first derivatives of a cubic spline at its knots.
#[derive(Clone, Debug, PartialEq)]
pub struct KnotValues {
    /// Value at each knot.
    pub values: Vec<f64>,
    /// First derivative at each knot.
    pub slopes: Vec<f64>,
}

/// First derivatives at the knots of the cubic spline through `values`, twice differentiable.
///
/// `knots` grow strictly, in any spacing; `values` is as long. The spline minimises the integral of
/// the squared second derivative among all curves through the values that respect clamped ends.
///
/// # Panics
/// With fewer than two knots, with lengths that differ, or (debug builds) with knots that do not
/// grow.
pub fn interpolating_slopes(knots: &[f64], values: &[f64], ends: [SplineEnd; 2]) -> Vec<f64> {
    let mut slopes = Vec::new();
    put_interpolating_slopes(knots, values, ends, &mut Vec::new(), &mut slopes);
    slopes
}

/// As [`interpolating_slopes`], into `slopes` and with the scratch `rows`: allocates nothing within
/// the room that they have.
///
/// # Panics
/// As there.
pub fn put_interpolating_slopes(
    knots: &[f64],
    values: &[f64],
    ends: [SplineEnd; 2],
    rows: &mut Vec<[f64; 4]>,
    slopes: &mut Vec<f64>,
) {
    let n = knots.len();
    check(knots, values);
    // Rows of the tridiagonal system for the slopes: lower, diagonal, upper, right-hand side.
    rows.clear();
    rows.resize(n, [0.0; 4]);
    let h = |i: usize| knots[i + 1] - knots[i];
    let chord = |i: usize| (values[i + 1] - values[i]) / h(i);
    rows[0] = match ends[0] {
        SplineEnd::Natural => [0.0, 2.0, 1.0, 3.0 * chord(0)],
        SplineEnd::Clamped(slope) => [0.0, 1.0, 0.0, slope],
    };
    rows[n - 1] = match ends[1] {
        SplineEnd::Natural => [1.0, 2.0, 0.0, 3.0 * chord(n - 2)],
        SplineEnd::Clamped(slope) => [0.0, 1.0, 0.0, slope],
    };
    for (i, row) in rows.iter_mut().enumerate().take(n - 1).skip(1) {
        let (before, after) = (1.0 / h(i - 1), 1.0 / h(i));
        let right = 3.0 * (chord(i - 1) * before + chord(i) * after);
        *row = [before, 2.0 * (before + after), after, right];
    }
    // The matrix is diagonally dominant: elimination needs no pivoting.
    for i in 1..n {
        let factor = rows[i][0] / rows[i - 1][1];
        rows[i][1] -= factor * rows[i - 1][2];
        rows[i][3] -= factor * rows[i - 1][3];
    }
    slopes.clear();
    slopes.resize(n, 0.0);
    slopes[n - 1] = rows[n - 1][3] / rows[n - 1][1];
    for i in (0..n - 1).rev() {
        slopes[i] = (rows[i][3] - rows[i][2] * slopes[i + 1]) / rows[i][1];
    }
}

/// Penalty that halves the amplitude of a wave of the given length.
///
/// ```text
/// λ = (L / 2π)⁴        amplitude passed at wavenumber k: 1 / (1 + λ k⁴)
/// ```
pub fn penalty_of_wavelength(wavelength: f64) -> f64 {
    (wavelength / std::f64::consts::TAU).powi(4)
}

/// The natural cubic spline that balances closeness to `values` against bending.
///
/// ```text
/// minimise   Σ w_i (v_i - f(s_i))² + λ ∫ f''² ds,      w_i: half the distance of the two neighbours of s_i
/// ```
///
/// With these weights the sum approaches an integral, and the result depends on the shape sampled
/// and not on how densely it was sampled. `penalty` is λ ≥ 0 [length⁴]; zero interpolates. Source:
/// Reinsch, Numerische Mathematik 10 (1967), 177-183; the cost is linear in the number of knots.
///
/// # Panics
/// With fewer than two knots, with lengths that differ, or (debug builds) with knots that do not
/// grow.
pub fn smoothing_spline(knots: &[f64], values: &[f64], penalty: f64) -> KnotValues {
    debug_assert!(penalty >= 0.0);
    let n = knots.len();
    check(knots, values);
    if n == 2 || penalty == 0.0 {
        let slopes = interpolating_slopes(knots, values, [SplineEnd::Natural; 2]);
        return KnotValues { values: values.to_vec(), slopes };
    }
    let h: Vec<f64> = knots.windows(2).map(|s| s[1] - s[0]).collect();
    let inverse_weight = |i: usize| {
        let before = if i > 0 { h[i - 1] } else { 0.0 };
        let after = if i + 1 < n { h[i] } else { 0.0 };
        2.0 / (before + after)
    };
    // Second divided difference at inner knot j + 1: q[j] · (v_j, v_{j+1}, v_{j+2}).
    let q: Vec<[f64; 3]> =
        h.windows(2).map(|h| [1.0 / h[0], -1.0 / h[0] - 1.0 / h[1], 1.0 / h[1]]).collect();
    let m = n - 2;
    let rows: Vec<[f64; 3]> = (0..m)
        .map(|j| {
            let product = |offset: usize| {
                if j + offset >= m {
                    return 0.0;
                }
                (offset..3)
                    .map(|k| q[j][k] * q[j + offset][k - offset] * inverse_weight(j + k))
                    .sum::<f64>()
            };
            let next = if j + 1 < m { h[j + 1] / 6.0 } else { 0.0 };
            [
                (h[j] + h[j + 1]) / 3.0 + penalty * product(0),
                next + penalty * product(1),
                penalty * product(2),
            ]
        })
        .collect();
    let right: Vec<f64> = (0..m).map(|j| (0..3).map(|k| q[j][k] * values[j + k]).sum()).collect();
    let inner = solve_pentadiagonal(rows, right);

    let mut bending = vec![0.0; n];
    bending[1..=m].copy_from_slice(&inner);
    let mut smoothed = values.to_vec();
    for (j, row) in q.iter().enumerate() {
        for (k, coefficient) in row.iter().enumerate() {
            smoothed[j + k] -= penalty * inverse_weight(j + k) * coefficient * inner[j];
        }
    }
    let slope_after = |i: usize| {
        (smoothed[i + 1] - smoothed[i]) / h[i] - h[i] * (2.0 * bending[i] + bending[i + 1]) / 6.0
    };
    let mut slopes: Vec<f64> = (0..n - 1).map(slope_after).collect();
    let last = n - 2;
    slopes.push(slopes[last] + h[last] * (bending[last] + bending[last + 1]) / 2.0);
    KnotValues { values: smoothed, slopes }
}

/// Solves a symmetric positive definite system with two bands on each side.
///
/// Row j of `rows` holds the elements (j, j), (j, j+1), (j, j+2). Decomposed as L D Lᵀ in place.
fn solve_pentadiagonal(mut rows: Vec<[f64; 3]>, mut right: Vec<f64>) -> Vec<f64> {
    let m = rows.len();
    for j in 0..m {
        let [diagonal, first, second] = rows[j];
        let (l1, l2) = (first / diagonal, second / diagonal);
        if j + 1 < m {
            rows[j + 1][0] -= l1 * first;
            rows[j + 1][1] -= l1 * second;
            right[j + 1] -= l1 * right[j];
        }
        if j + 2 < m {
            rows[j + 2][0] -= l2 * second;
            right[j + 2] -= l2 * right[j];
        }
        rows[j] = [diagonal, l1, l2];
    }
    for j in (0..m).rev() {
        let mut value = right[j] / rows[j][0];
        for (offset, factor) in rows[j][1..].iter().enumerate() {
            if let Some(known) = right.get(j + offset + 1) {
                value -= factor * known;
            }
        }
        right[j] = value;
    }
    right
}

fn check(knots: &[f64], values: &[f64]) {
    assert!(knots.len() >= 2, "a spline needs two knots");
    assert_eq!(knots.len(), values.len(), "one value for each knot");
    debug_assert!(knots.windows(2).all(|s| s[1] > s[0]), "knots must grow");
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use approx::assert_relative_eq;

    use super::*;

    /// Knots from 0 to `end` whose spacing varies by a factor of about ten.
    fn uneven(count: usize, end: f64) -> Vec<f64> {
        let raw: Vec<f64> = (0..count)
            .scan(0.0, |s, i| {
                let at = *s;
                *s += 1.0 + 0.82 * (1.7 * i as f64).sin();
                Some(at)
            })
            .collect();
        raw.iter().map(|s| s * end / raw[count - 1]).collect()
    }

    #[test]
    fn clamped_spline_reproduces_a_cubic_on_uneven_knots() {
        let f = |s: f64| 1.0 - 2.0 * s + 0.5 * s * s + 3.0 * s * s * s;
        let d = |s: f64| -2.0 + s + 9.0 * s * s;
        let knots = uneven(40, 2.0);
        let values: Vec<f64> = knots.iter().map(|&s| f(s)).collect();
        let ends = [SplineEnd::Clamped(d(0.0)), SplineEnd::Clamped(d(2.0))];
        for (s, slope) in knots.iter().zip(interpolating_slopes(&knots, &values, ends)) {
            assert_relative_eq!(slope, d(*s), epsilon = 1e-11);
        }
    }

    #[test]
    fn interpolation_and_smoothing_without_penalty_agree_and_end_without_bending() {
        let knots = uneven(20, 1.0);
        let values: Vec<f64> = knots.iter().map(|s| (3.0 * s).sin()).collect();
        let natural = interpolating_slopes(&knots, &values, [SplineEnd::Natural; 2]);
        let nearly = smoothing_spline(&knots, &values, 1e-18);
        for (a, b) in natural.iter().zip(&nearly.slopes) {
            assert_relative_eq!(a, b, epsilon = 1e-9);
        }
        let h = knots[1] - knots[0];
        let chord = (values[1] - values[0]) / h;
        let bending = (6.0 * chord - 4.0 * natural[0] - 2.0 * natural[1]) / h;
        assert_relative_eq!(bending, 0.0, epsilon = 1e-11);
    }

    #[test]
    fn clamped_spline_converges_with_the_fourth_power() {
        let error = |count: usize| {
            let knots: Vec<f64> = (0..count).map(|i| i as f64 / (count - 1) as f64).collect();
            let values: Vec<f64> = knots.iter().map(|s| s.exp()).collect();
            let ends = [SplineEnd::Clamped(1.0), SplineEnd::Clamped(1f64.exp())];
            let slopes = interpolating_slopes(&knots, &values, ends);
            let middle = count / 2;
            let h = knots[1] - knots[0];
            let value = 0.5 * (values[middle] + values[middle + 1])
                + h / 8.0 * (slopes[middle] - slopes[middle + 1]);
            (value - (0.5 * (knots[middle] + knots[middle + 1])).exp()).abs()
        };
        let order = (error(21) / error(41)).log2();
        assert_relative_eq!(order, 4.0, epsilon = 0.2);
    }

    /// Amplitude of the wave of the given length that is left in the middle of a long record.
    fn passed_amplitude(knots: &[f64], wavelength: f64, filter: f64) -> f64 {
        let wave = |s: f64| (TAU * s / wavelength).cos();
        let values: Vec<f64> = knots.iter().map(|&s| wave(s)).collect();
        let smooth = smoothing_spline(knots, &values, penalty_of_wavelength(filter));
        let end = knots[knots.len() - 1];
        let inner = (0..knots.len() - 1).filter(|&i| (knots[i] / end - 0.5).abs() < 0.25);
        let (mut product, mut norm) = (0.0, 0.0);
        for i in inner {
            let weight = knots[i + 1] - knots[i];
            product += weight * smooth.values[i] * wave(knots[i]);
            norm += weight * wave(knots[i]).powi(2);
        }
        product / norm
    }

    #[test]
    fn smoothing_halves_the_amplitude_at_the_stated_wavelength() {
        for count in [400, 4000, 20000] {
            let even: Vec<f64> = (0..count).map(|i| 0.1 * i as f64 / count as f64).collect();
            for knots in [even, uneven(count, 0.1)] {
                let tolerance = if count == 400 { 0.02 } else { 2e-3 };
                assert_relative_eq!(
                    passed_amplitude(&knots, 0.004, 0.004),
                    0.5,
                    epsilon = tolerance
                );
                assert_relative_eq!(
                    passed_amplitude(&knots, 0.008, 0.004),
                    16.0 / 17.0,
                    epsilon = tolerance
                );
                assert_relative_eq!(
                    passed_amplitude(&knots, 0.002, 0.004),
                    1.0 / 17.0,
                    epsilon = tolerance
                );
            }
        }
    }

    #[test]
    fn smoothing_leaves_a_straight_line_alone_and_is_stationary() {
        let knots = uneven(50, 1.0);
        let line: Vec<f64> = knots.iter().map(|s| 2.0 - 3.0 * s).collect();
        let smooth = smoothing_spline(&knots, &line, 0.1);
        for (i, value) in line.iter().enumerate() {
            assert_relative_eq!(smooth.values[i], *value, epsilon = 1e-12);
            assert_relative_eq!(smooth.slopes[i], -3.0, epsilon = 1e-10);
        }
        // At the minimum no small change of the values lowers the sum that is minimised.
        let values: Vec<f64> = knots.iter().map(|s| (40.0 * s).sin()).collect();
        let penalty = 1e-6;
        let best = smoothing_spline(&knots, &values, penalty).values;
        let cost = |f: &[f64]| {
            let slopes = interpolating_slopes(&knots, f, [SplineEnd::Natural; 2]);
            let (mut closeness, mut bending) = (0.0, 0.0);
            for i in 0..knots.len() {
                let before = if i > 0 { knots[i] - knots[i - 1] } else { 0.0 };
                let after = if i + 1 < knots.len() { knots[i + 1] - knots[i] } else { 0.0 };
                closeness += 0.5 * (before + after) * (values[i] - f[i]).powi(2);
            }
            for i in 0..knots.len() - 1 {
                let h = knots[i + 1] - knots[i];
                let chord = (f[i + 1] - f[i]) / h;
                let a = (6.0 * chord - 4.0 * slopes[i] - 2.0 * slopes[i + 1]) / h;
                let b = (2.0 * slopes[i] + 4.0 * slopes[i + 1] - 6.0 * chord) / h;
                bending += h * (a * a + a * b + b * b) / 3.0;
            }
            closeness + penalty * bending
        };
        let least = cost(&best);
        for i in 0..knots.len() {
            for step in [-1e-4, 1e-4] {
                let mut other = best.clone();
                other[i] += step;
                assert!(cost(&other) > least, "value {i} is not at the minimum");
            }
        }
    }

    #[test]
    fn two_knots_give_a_line() {
        let smooth = smoothing_spline(&[0.0, 2.0], &[1.0, 2.0], 5.0);
        assert_relative_eq!(smooth.slopes[0], 0.5, epsilon = 1e-15);
        assert_relative_eq!(smooth.slopes[1], 0.5, epsilon = 1e-15);
    }
}
