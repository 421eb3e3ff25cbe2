//! Functions of one positive variable, four at a time: cubic splines over its logarithm.

use crate::math::b_spline;
use crate::math::real::Real;

/// Numbers taken together.
pub(super) type Four<T> = [T; 4];

/// `V` fours of functions.
#[derive(Clone, Debug)]
pub(super) struct Functions<const V: usize> {
    /// Least and greatest variable; beyond them the functions rest.
    ends: [f64; 2],
    low: f64,
    per_step: f64,
    coefficients: Vec<[Four<f64>; V]>,
}

/// Knots over a factor e of the variable: what splines leave is some 1e-5 of the functions here.
const PER_LOGARITHM: f64 = 4.0;

impl<const V: usize> Functions<V> {
    /// Splines through what `values` gives from the first to the last of `ends`.
    pub fn through(ends: [f64; 2], values: impl Fn(f64) -> [Four<f64>; V]) -> Self {
        let [low, high] = ends.map(f64::ln);
        let cells = ((high - low) * PER_LOGARITHM).ceil();
        let per_step = cells / (high - low);
        let knots: Vec<_> =
            (0..=cells as usize).map(|k| values((low + k as f64 / per_step).exp())).collect();
        let mut coefficients = vec![[[0.0; 4]; V]; knots.len() + 2];
        for v in 0..V {
            for lane in 0..4 {
                let column: Vec<f64> = knots.iter().map(|knot| knot[v][lane]).collect();
                for (k, c) in b_spline::coefficients(&column).into_iter().enumerate() {
                    coefficients[k][v][lane] = c;
                }
            }
        }
        Self { ends, low, per_step, coefficients }
    }

    /// The functions at `x` > 0.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn at<const F: bool, T: Real>(&self, x: T) -> [Four<T>; V] {
        let place = (x.within(self.ends[0], self.ends[1]).normal_ln() - self.low) * self.per_step;
        let (first, fraction) = b_spline::locate(place.value(), self.coefficients.len() - 3);
        let mut found = [[T::from(0.0); 4]; V];
        let Some(rows) = self.coefficients.get(first..first + 4) else { return found };
        let sums = |weights: [f64; 4]| {
            let mut sums = [[0.0; 4]; V];
            for (row, weight) in rows.iter().zip(weights) {
                for (sum, four) in sums.iter_mut().zip(row) {
                    for lane in 0..4 {
                        sum[lane] = sum[lane].add_product::<F>(weight, four[lane]);
                    }
                }
            }
            sums
        };
        let values = sums(b_spline::weights(fraction));
        let slopes =
            if T::HAS_SLOPES { sums(b_spline::weight_slopes(fraction)) } else { [[0.0; 4]; V] };
        for ((found, values), slopes) in found.iter_mut().zip(&values).zip(&slopes) {
            for lane in 0..4 {
                found[lane] = place.chain(values[lane], || slopes[lane]);
            }
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::dual::Dual;
    use approx::assert_relative_eq;

    #[test]
    fn functions_and_their_slopes_are_met_and_rest_beyond_the_ends() {
        let functions = Functions::<1>::through([0.01, 100.0], |x| [[x.ln(), x.sqrt(), 1.0, 2.0]]);
        for x in [0.011, 0.3, 1.0, 7.0, 99.0] {
            let [[log, root, one, two]] = functions.at::<false, _>(Dual::<1>::variable(x, 0));
            assert_relative_eq!(log.value, x.ln(), epsilon = 1e-9);
            assert_relative_eq!(log.slopes[0], 1.0 / x, max_relative = 1e-6);
            assert_relative_eq!(root.value, x.sqrt(), max_relative = 3e-5);
            assert_relative_eq!(one.value + two.value, 3.0, max_relative = 1e-12);
            assert!((functions.at::<false, _>(x)[0][0] - log.value).abs() <= 0.0);
        }
        let [[beyond, ..]] = functions.at::<false, _>(Dual::<1>::variable(1e3, 0));
        assert_relative_eq!(beyond.value, 100f64.ln(), epsilon = 1e-9);
        assert!(beyond.slopes[0].abs() <= 0.0);
    }
}
