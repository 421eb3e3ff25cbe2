//! Functions of one positive variable, four at a time: cubics between knots that are found from the
//! bits of the variable alone.
//!
//! The knots are powers of two and what lies evenly between them, so that the exponent and the first
//! bits of the mantissa are the number of an interval and the other bits the place in it. Cubics of
//! neighbouring intervals have values and slopes in common: those of a cubic spline over the
//! logarithm.

use crate::math::real::Real;
use crate::math::spline::{SplineEnd, interpolating_slopes};

/// Numbers taken together.
pub(super) type Four<T> = [T; 4];

/// Bits of the mantissa that count the intervals between powers of two: with two intervals for a
/// factor of two what cubics leave changes forces by less than 1e-4 of themselves.
const COUNTED: u32 = 1;
const MANTISSA: u32 = f64::MANTISSA_DIGITS - 1;
/// Bits behind the number of an interval.
const WITHIN: u32 = MANTISSA - COUNTED;

/// Cubic over the distance from the beginning of an interval, over the power of two before it:
/// constant, linear, square and cubic term of `V` fours of functions.
type Cubic<const V: usize> = [[Four<f64>; V]; 4];

/// `V` fours of functions.
#[derive(Clone, Debug)]
pub(super) struct Functions<const V: usize> {
    /// Least and greatest variable; beyond them the functions rest.
    ends: [f64; 2],
    /// Number of the first interval.
    first: u64,
    cubics: Vec<Cubic<V>>,
}

impl<const V: usize> Functions<V> {
    /// The functions that `values` gives from the first to the last of `ends`, which are to lie within
    /// what plain numbers have at full precision.
    pub fn through(ends: [f64; 2], values: impl Fn(f64) -> [Four<f64>; V]) -> Self {
        let [first, last] = ends.map(|end| end.to_bits() >> WITHIN);
        let knots: Vec<f64> = (first..=last + 1).map(|k| f64::from_bits(k << WITHIN)).collect();
        let logarithms: Vec<f64> = knots.iter().map(|knot| knot.ln()).collect();
        let at_ends = [0, knots.len() - 1].map(|k| {
            // Slopes there by differences.
            [-1e-5, 1e-5].map(|step| values(knots[k] * f64::exp(step)))
        });
        let values: Vec<_> = knots.iter().map(|&knot| values(knot)).collect();
        let mut cubics = vec![[[[0.0; 4]; V]; 4]; knots.len() - 1];
        for v in 0..V {
            for lane in 0..4 {
                let column: Vec<f64> = values.iter().map(|values| values[v][lane]).collect();
                let ends = at_ends.map(|[below, above]| {
                    SplineEnd::Clamped((above[v][lane] - below[v][lane]) / 2e-5)
                });
                let slopes = interpolating_slopes(&logarithms, &column, ends);
                for (k, cubic) in cubics.iter_mut().enumerate() {
                    let scale = f64::from_bits(knots[k].to_bits() >> MANTISSA << MANTISSA);
                    let length = (knots[k + 1] - knots[k]) / scale;
                    let [left, right] = [k, k + 1].map(|k| slopes[k] / knots[k] * scale);
                    let mean = (column[k + 1] - column[k]) / length;
                    cubic[0][v][lane] = column[k];
                    cubic[1][v][lane] = left;
                    cubic[2][v][lane] = (3.0 * mean - 2.0 * left - right) / length;
                    cubic[3][v][lane] = (left + right - 2.0 * mean) / (length * length);
                }
            }
        }
        Self { ends, first, cubics }
    }

    /// The functions at `x` > 0.
    #[inline(always)]
    pub fn at<const F: bool, T: Real>(&self, x: T) -> [Four<T>; V] {
        let x = x.within(self.ends[0], self.ends[1]);
        let bits = x.value().to_bits();
        // Of what is not a number that of the last interval.
        let number = (bits >> WITHIN).wrapping_sub(self.first) as usize;
        let [c0, c1, c2, c3] = &self.cubics[number.min(self.cubics.len() - 1)];
        let within = bits & ((1 << WITHIN) - 1);
        let place = f64::from_bits(within | 1f64.to_bits()) - 1.0;
        let per_x = if T::HAS_SLOPES {
            // One over the power of two before x.
            f64::from_bits((2 * 1f64.to_bits()).wrapping_sub(bits >> MANTISSA << MANTISSA))
        } else {
            0.0
        };
        let mut found = [[T::from(0.0); 4]; V];
        for v in 0..V {
            for lane in 0..4 {
                let [c0, c1, c2, c3] = [c0[v][lane], c1[v][lane], c2[v][lane], c3[v][lane]];
                let value = c2.add_product::<F>(c3, place);
                let value = c1.add_product::<F>(value, place);
                let value = c0.add_product::<F>(value, place);
                found[v][lane] =
                    x.chain(value, || ((3.0 * c3 * place + 2.0 * c2) * place + c1) * per_x);
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
        // Cubics leave h⁴/384 of the fourth derivative, 6/x⁴, with h up to x/2.
        for x in [0.011, 0.3, 1.0, 7.0, 99.0] {
            let [[log, root, one, two]] = functions.at::<false, _>(Dual::<1>::variable(x, 0));
            assert_relative_eq!(log.value, x.ln(), epsilon = 1e-3);
            assert_relative_eq!(log.slopes[0], 1.0 / x, max_relative = 1e-2);
            assert_relative_eq!(root.value, x.sqrt(), max_relative = 1e-3);
            assert_relative_eq!(one.value + two.value, 3.0, max_relative = 1e-12);
            assert!((functions.at::<false, _>(x)[0][0] - log.value).abs() <= 0.0);
        }
        let [[beyond, ..]] = functions.at::<false, _>(Dual::<1>::variable(1e3, 0));
        assert_relative_eq!(beyond.value, 100f64.ln(), epsilon = 1e-3);
        assert!(beyond.slopes[0].abs() <= 0.0);
    }

    #[test]
    fn pieces_join_with_their_slopes() {
        let functions = Functions::<1>::through([0.01, 100.0], |x| [[1.0 / x, x.sqrt(), x, x * x]]);
        for knot in [0.25, 0.375, 1.0, 1.5, 2.0, 48.0] {
            let [below, above] = [knot * (1.0 - 1e-15), knot]
                .map(|x| functions.at::<false, _>(Dual::<1>::variable(x, 0))[0]);
            for (below, above) in below.into_iter().zip(above) {
                assert_relative_eq!(below.value, above.value, max_relative = 1e-13);
                assert_relative_eq!(below.slopes[0], above.slopes[0], max_relative = 1e-12);
            }
        }
    }
}
