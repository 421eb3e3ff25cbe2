use approx::assert_relative_eq;

use super::*;
use crate::math::dual::Dual;

/// Pairs of strips of all proportions, off the knots, over which differences are less exact:
/// row, p, q and 1/h².
fn pairs() -> Vec<(usize, f64, f64, f64)> {
    let inside = (0..PIECES).step_by(5).map(|n| 0.6 * knot(n) + 0.4 * knot(n + 1));
    let mut pairs = Vec::new();
    for w in inside.chain([0.2 * knot(0), 3.0 * LAST_W]) {
        for (row, t) in (0..ROWS).flat_map(|row| [-0.95, -0.3, 0.0, 0.02].map(|t| (row, t))) {
            let square = 6e-8 * (1.0 + 0.3 * t);
            pairs.push((row, w * (1.0 + t) * square, w * (1.0 - t) * square, 1.0 / square));
        }
    }
    pairs
}

/// [`Kernel::value`] at 1/h².
pub(super) fn kernel_at<T: Real>(
    kernel: &Kernel,
    row: usize,
    p: T,
    q: T,
    inverse_square: T,
) -> [T; 3] {
    kernel.value(row, [p, q], inverse_square * 0.5, inverse_square.sqrt())
}

#[test]
fn strips_far_apart_are_points() {
    let h: f64 = 3e-3;
    for length in [1e-6, 1e-5, 3e-5] {
        let [p, q] = [1.0, 0.5].map(|share| share * length * length);
        let [value, _, _] = kernel_at(Kernel::shared(), ROWS - 1, p, q, 1.0 / (h * h));
        assert_relative_eq!(value * h, 1.0, max_relative = 1e-4);
    }
}

#[test]
fn strips_close_together_feel_the_logarithm_of_their_distance() {
    // Equal semi-ellipses: E = 32/(3 π² a) (ln(16 a/d) - 7/3), to within (d/a)².
    let (h, a): (f64, f64) = (2e-5, 3e-3);
    let p = a * a;
    let factor = 32.0 / (3.0 * std::f64::consts::PI.powi(2) * a);
    let [value, ..] = kernel_at(Kernel::shared(), ROWS - 1, p, p, 1.0 / (h * h));
    let exact = factor * ((16.0 * a / h).ln() - 7.0 / 3.0);
    // That is the error of the fit over t.
    assert_relative_eq!(value, exact, max_relative = 2e-3);
    let [closer, ..] = kernel_at(Kernel::shared(), ROWS - 1, p, p, 4.0 / (h * h));
    assert_relative_eq!(closer - value, factor * 2f64.ln(), max_relative = 1e-2);
}

#[test]
fn derivatives_are_those_of_differences() {
    let kernel = Kernel::shared();
    for (row, p, q, inverse) in pairs() {
        let found = kernel.second(row, p, q, inverse);
        let step = 1e-5 * (p + q);
        let difference = |along: [f64; 2]| {
            let at = |s: f64| kernel_at(kernel, row, p + s * along[0], q + s * along[1], inverse);
            let (up, down) = (at(step), at(-step));
            [0, 1, 2].map(|i| (up[i] - down[i]) / (2.0 * step))
        };
        let (by_p, by_q) = (difference([1.0, 0.0]), difference([0.0, 1.0]));
        let unit = found[0] / (p + q);
        for (found, expected, unit) in [
            (found[1], by_p[0], unit),
            (found[2], by_q[0], unit),
            (found[3], by_p[1], unit / (p + q)),
            (found[4], by_p[2], unit / (p + q)),
            (found[4], by_q[1], unit / (p + q)),
            (found[5], by_q[2], unit / (p + q)),
        ] {
            assert_relative_eq!(found / unit, expected / unit, epsilon = 1e-7);
        }
    }
}

#[test]
fn dual_numbers_carry_the_same_derivatives() {
    let kernel = Kernel::shared();
    for (row, p, q, inverse) in pairs() {
        let expected = kernel.second(row, p, q, inverse);
        let (sum, unit) = (p + q, expected[0] / (p + q));
        let at = [p, q, inverse];
        let [x, y, z] = std::array::from_fn(|i| Dual::<3>::variable(at[i], i));
        let [value, by_p, by_q] = kernel_at(kernel, row, x, y, z);
        for (found, expected, unit) in [
            (value.value, expected[0], expected[0]),
            (value.slopes[0], expected[1], unit),
            (value.slopes[1], expected[2], unit),
            (by_p.slopes[0], expected[3], unit / sum),
            (by_p.slopes[1], expected[4], unit / sum),
            (by_q.slopes[1], expected[5], unit / sum),
        ] {
            assert_relative_eq!(found / unit, expected / unit, epsilon = 1e-12);
        }
        // K goes with the inverse of all lengths.
        let by_lengths = p * expected[1] + q * expected[2] - inverse * value.slopes[2];
        assert_relative_eq!(-2.0 * by_lengths, expected[0], max_relative = 1e-12);
    }
}

#[test]
fn value_and_two_derivatives_go_on_over_the_knots() {
    let kernel = Kernel::shared();
    for row in 0..ROWS {
        for number in 1..PIECES {
            let w = knot(number);
            let after = piece(row, w);
            assert_eq!(piece(row, w.next_down()), after - COEFFICIENTS);
            assert_eq!(after, (row * ROW_PIECES + number) * COEFFICIENTS);
            let size = kernel.coefficients[after].abs();
            for part in [0, 4] {
                let [before, after] = [after - COEFFICIENTS, after].map(|at| {
                    let c = &kernel.coefficients[at + part..at + part + 4];
                    let [value, slope] = cubic(c, w);
                    [value, slope * w, (2.0 * c[2] + 6.0 * c[3] * w) * w * w]
                });
                for (before, after) in before.iter().zip(after) {
                    assert_relative_eq!(*before, after, epsilon = 1e-10 * size);
                }
            }
        }
    }
}

#[test]
fn powers_of_w_lose_no_digits_that_count() {
    for number in 0..PIECES {
        let (from, to) = (knot(number), knot(number + 1));
        let values = [from, to].map(|w| w.powf(-0.5));
        let slopes = [from, to].map(|w| -0.5 * w.powf(-1.5));
        let long = to - from;
        let c = powers([from, long], values, slopes);
        for x in [0.0, 0.25, 0.5, 0.75, 1.0_f64] {
            let local = values[0] * (1.0 - x).powi(2) * (1.0 + 2.0 * x)
                + values[1] * x * x * (3.0 - 2.0 * x)
                + long * x * (1.0 - x) * ((1.0 - x) * slopes[0] - x * slopes[1]);
            assert_relative_eq!(cubic(&c, from + x * long)[0], local, max_relative = 1e-14);
        }
    }
}

#[test]
fn the_strips_of_a_pair_can_be_exchanged() {
    let kernel = Kernel::shared();
    for (row, p, q, inverse) in pairs() {
        let [value, by_p, by_q, pp, pq, qq] = kernel.second(row, p, q, inverse);
        let exchanged = kernel.second(row, q, p, inverse);
        let unit = value / (p + q);
        for (a, b) in [value, by_q, by_p, qq, pq, pp].into_iter().zip(exchanged) {
            assert_relative_eq!(a, b, max_relative = 1e-12, epsilon = 1e-12 * unit);
        }
    }
}

#[test]
fn outside_the_table_it_stays_positive_and_falls_with_length() {
    let kernel = Kernel::shared();
    for row in 0..ROWS {
        let at = |w: f64| kernel_at(kernel, row, w, w, 1.0);
        let mut last = f64::INFINITY;
        for step in 0..200 {
            let w = 2f64.powf(f64::from(step) / 5.0 - 18.0);
            let [value, slope, _] = at(w);
            assert!(value > 0.0 && value <= last + 1e-11 && slope <= 1e-11 / w);
            last = value;
        }
        assert!(at(f64::MIN_POSITIVE)[0].is_finite());
        // What is left of σ beside 1/40, 1/(A w), falls still.
        assert_relative_eq!(at(1e9)[0], at(LAST_W)[0], max_relative = 2e-5);
        assert_relative_eq!(at(1e9)[1], 0.0);
    }
}

#[test]
fn a_table_of_another_size_is_refused() {
    for text in ["# head\n1.0 2.0\n", &format!("{FILE}x"), &format!("{FILE}0.0")] {
        assert!(Kernel::from_text(text).is_none());
    }
}
