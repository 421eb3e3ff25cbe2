//! Dual numbers: a value and its derivatives in some directions, carried through every operation by
//! the chain rule.
//!
//! Written out here for two reasons: an array of slopes without an option around it becomes vector
//! instructions, and a root of nothing has no slopes instead of some that are not numbers, so that
//! what does not count (a strip without length) does no harm.

use super::by_slopes::{functions_by_slopes, operations_by_slopes};
use super::real::Real;

/// A value with its derivatives in `N` directions.
#[derive(Clone, Copy, Debug)]
pub struct Dual<const N: usize> {
    /// Value.
    pub value: f64,
    /// Derivatives.
    pub slopes: [f64; N],
}

impl<const N: usize> Dual<N> {
    /// The variable with the value `value` that direction number `direction` is along.
    pub fn variable(value: f64, direction: usize) -> Self {
        let mut slopes = [0.0; N];
        slopes[direction] = 1.0;
        Self { value, slopes }
    }

    /// A function of it with this value and derivative.
    #[inline]
    fn by(self, value: f64, slope: f64) -> Self {
        Self { value, slopes: self.slopes.map(|s| s * slope) }
    }

    /// A function of two numbers with this value and these derivatives.
    #[inline]
    fn by_two(a: Self, b: Self, value: f64, by_a: f64, by_b: f64) -> Self {
        let mut slopes = [0.0; N];
        for (i, slope) in slopes.iter_mut().enumerate() {
            *slope = a.slopes[i] * by_a + b.slopes[i] * by_b;
        }
        Self { value, slopes }
    }

    #[inline]
    fn plus(mut self, other: Self) -> Self {
        self.value += other.value;
        for (own, other) in self.slopes.iter_mut().zip(other.slopes) {
            *own += other;
        }
        self
    }

    #[inline]
    fn minus(mut self, other: Self) -> Self {
        self.value -= other.value;
        for (own, other) in self.slopes.iter_mut().zip(other.slopes) {
            *own -= other;
        }
        self
    }
}

impl<const N: usize> From<f64> for Dual<N> {
    #[inline]
    fn from(value: f64) -> Self {
        Self { value, slopes: [0.0; N] }
    }
}

operations_by_slopes!(Dual<N>);

impl<const N: usize> Real for Dual<N> {
    #[inline]
    fn chain(self, value: f64, slope: impl FnOnce() -> f64) -> Self {
        self.by(value, slope())
    }

    functions_by_slopes!();

    #[inline]
    fn abs(self) -> Self {
        self.by(self.value.abs(), self.value.signum())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// A function of two variables that uses every operation.
    fn all<T: Real>(x: T, y: T) -> T {
        let (sine, cosine) = (x * y).sin_cos();
        let mut sum = (x + y).sqrt() + (x - y).powi(3) / (y * 2.0 + 1.0) - x.ln() * sine;
        sum += (x / y).exp() * cosine + (x * 0.3).asin() + y.atan2(x) * 0.5 - x.hypotenuse(y);
        sum -= (y - x).abs() * x.normal_ln() / 3.0 + (-x).copysign(1.0);
        sum *= x.max(y) + x.min(y) * 0.1 + x.at_least(5.0) + y.at_most(0.1) + x.within(0.0, 1.0);
        sum += (x * y).three_halves() + y.chain(y.value() * y.value(), || 2.0 * y.value());
        sum * [x, y].into_iter().sum::<T>()
    }

    #[test]
    fn all_operations_have_the_slopes_of_differences_and_the_values_of_real_numbers() {
        let at = all::<f64>;
        let (x, y, h) = (0.7, 1.3, 1e-5);
        let found = all(Dual::<2>::variable(x, 0), Dual::variable(y, 1));
        assert_relative_eq!(found.value, at(x, y), max_relative = 1e-15);
        let by_x = (at(x + h, y) - at(x - h, y)) / (2.0 * h);
        let by_y = (at(x, y + h) - at(x, y - h)) / (2.0 * h);
        assert_relative_eq!(found.slopes[0], by_x, max_relative = 1e-8);
        assert_relative_eq!(found.slopes[1], by_y, max_relative = 1e-8);
    }

    #[test]
    fn nothing_has_a_root_without_slopes() {
        let zero = Dual::<1>::variable(0.0, 0);
        for number in [zero.sqrt(), zero.hypotenuse(zero), zero.atan2(zero)] {
            assert!(number.slopes[0].abs() <= 0.0);
        }
    }
}
