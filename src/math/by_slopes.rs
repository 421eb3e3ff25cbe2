//! Operations and functions of numbers with derivatives, once for all kinds of them.
//!
//! A kind has a `value` and is made `From` a constant; `by` gives a function of it its value and
//! derivative, `by_two` one of two numbers, `plus` and `minus` are sum and difference.

/// Operators, comparisons, which look at the value alone, and neutral elements of a kind, which may
/// have a number of directions.
macro_rules! operations_by_slopes {
    ($number:ident $(<$n:ident>)?) => {
        use std::cmp::Ordering;
        use std::iter::Sum;
        use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

        use num_traits::{One, Zero};

        use $crate::math::by_slopes::operator;

        operator!($number $(<$n>)?, Add(Self) add, |a: Self, b: Self| a.plus(b));
        operator!($number $(<$n>)?, Sub(Self) sub, |a: Self, b: Self| a.minus(b));
        operator!($number $(<$n>)?, Mul(Self) mul, |a: Self, b: Self| {
            Self::by_two(a, b, a.value * b.value, b.value, a.value)
        });
        operator!($number $(<$n>)?, Div(Self) div, |a: Self, b: Self| {
            let inverse = 1.0 / b.value;
            let value = a.value / b.value;
            Self::by_two(a, b, value, inverse, -value * inverse)
        });
        // A constant more has the same derivatives.
        operator!($number $(<$n>)?, Add(f64) add, |a: Self, b| Self { value: a.value + b, ..a });
        operator!($number $(<$n>)?, Sub(f64) sub, |a: Self, b| Self { value: a.value - b, ..a });
        operator!($number $(<$n>)?, Mul(f64) mul, |a: Self, b: f64| a.by(a.value * b, b));
        operator!($number $(<$n>)?, Div(f64) div, |a: Self, b: f64| a.by(a.value / b, 1.0 / b));
        operator!($number $(<$n>)?, AddAssign(Self) add_assign, |a: Self, b| a + b, in place);
        operator!($number $(<$n>)?, SubAssign(Self) sub_assign, |a: Self, b| a - b, in place);
        operator!($number $(<$n>)?, MulAssign(Self) mul_assign, |a: Self, b| a * b, in place);
        operator!($number $(<$n>)?, DivAssign(Self) div_assign, |a: Self, b| a / b, in place);
        operator!($number $(<$n>)?, MulAssign(f64) mul_assign, |a: Self, b: f64| a * b, in place);

        impl $(<const $n: usize>)? Neg for $number $(<$n>)? {
            type Output = Self;

            #[inline]
            fn neg(self) -> Self {
                self.by(-self.value, -1.0)
            }
        }

        impl $(<const $n: usize>)? Default for $number $(<$n>)? {
            #[inline]
            fn default() -> Self {
                Self::from(0.0)
            }
        }

        impl $(<const $n: usize>)? Zero for $number $(<$n>)? {
            #[inline]
            fn zero() -> Self {
                Self::from(0.0)
            }

            #[inline]
            fn is_zero(&self) -> bool {
                self.value.is_zero()
            }
        }

        impl $(<const $n: usize>)? One for $number $(<$n>)? {
            #[inline]
            fn one() -> Self {
                Self::from(1.0)
            }
        }

        impl $(<const $n: usize>)? Sum for $number $(<$n>)? {
            fn sum<I: Iterator<Item = Self>>(numbers: I) -> Self {
                numbers.fold(Self::from(0.0), |sum, number| sum + number)
            }
        }

        impl $(<const $n: usize>)? PartialEq for $number $(<$n>)? {
            #[inline]
            fn eq(&self, other: &Self) -> bool {
                self.value.eq(&other.value)
            }
        }

        impl $(<const $n: usize>)? PartialEq<f64> for $number $(<$n>)? {
            #[inline]
            fn eq(&self, other: &f64) -> bool {
                self.value.eq(other)
            }
        }

        impl $(<const $n: usize>)? PartialOrd for $number $(<$n>)? {
            #[inline]
            fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
                self.value.partial_cmp(&other.value)
            }
        }

        impl $(<const $n: usize>)? PartialOrd<f64> for $number $(<$n>)? {
            #[inline]
            fn partial_cmp(&self, other: &f64) -> Option<Ordering> {
                self.value.partial_cmp(other)
            }
        }
    };
}

/// One operator, by what it makes of both sides.
macro_rules! operator {
    ($number:ident $(<$n:ident>)?, $name:ident($other:ty) $method:ident, $work:expr) => {
        impl $(<const $n: usize>)? $name<$other> for $number $(<$n>)? {
            type Output = Self;

            #[inline]
            fn $method(self, other: $other) -> Self {
                ($work)(self, other)
            }
        }
    };
    ($number:ident $(<$n:ident>)?, $name:ident($other:ty) $method:ident, $work:expr, in place) => {
        impl $(<const $n: usize>)? $name<$other> for $number $(<$n>)? {
            #[inline]
            fn $method(&mut self, other: $other) {
                *self = ($work)(*self, other);
            }
        }
    };
}

/// The functions of [`Real`](super::real::Real) that follow from the derivatives by their arguments.
macro_rules! functions_by_slopes {
    () => {
        const HAS_SLOPES: bool = true;

        #[inline]
        fn value(self) -> f64 {
            self.value
        }

        #[inline]
        fn moving(value: f64, rates: Self) -> Self {
            Self { value, ..rates }
        }

        #[inline]
        fn sqrt(self) -> Self {
            let root = self.value.sqrt();
            if root == 0.0 { Self::from(0.0) } else { self.by(root, 0.5 / root) }
        }

        #[inline]
        fn powi(self, power: i32) -> Self {
            self.by(self.value.powi(power), f64::from(power) * self.value.powi(power - 1))
        }

        #[inline]
        fn three_halves(self) -> Self {
            let root = self.value.sqrt();
            self.by(self.value * root, 1.5 * root)
        }

        #[inline]
        fn ln(self) -> Self {
            self.by(self.value.ln(), 1.0 / self.value)
        }

        #[inline]
        fn normal_ln(self) -> Self {
            self.by($crate::math::logarithm::ln(self.value), 1.0 / self.value)
        }

        #[inline]
        fn exp(self) -> Self {
            let value = self.value.exp();
            self.by(value, value)
        }

        #[inline]
        fn sin_cos(self) -> (Self, Self) {
            let (sine, cosine) = self.value.sin_cos();
            (self.by(sine, cosine), self.by(cosine, -sine))
        }

        #[inline]
        fn asin(self) -> Self {
            let rest = 1.0 - self.value * self.value;
            let slope = if rest > 0.0 { 1.0 / rest.sqrt() } else { 0.0 };
            self.by(self.value.asin(), slope)
        }

        #[inline]
        fn atan2(self, x: Self) -> Self {
            let square = self.value * self.value + x.value * x.value;
            let inverse = if square > 0.0 { 1.0 / square } else { 0.0 };
            let (by_y, by_x) = (x.value * inverse, -self.value * inverse);
            Self::by_two(self, x, self.value.atan2(x.value), by_y, by_x)
        }

        #[inline]
        fn hypotenuse(self, other: Self) -> Self {
            let length = self.value.hypotenuse(other.value);
            if length == 0.0 {
                return Self::from(0.0);
            }
            let (by_self, by_other) = (self.value / length, other.value / length);
            Self::by_two(self, other, length, by_self, by_other)
        }

        #[inline]
        fn signum(self) -> f64 {
            self.value.signum()
        }

        #[inline]
        fn max(self, other: Self) -> Self {
            if self.value >= other.value || other.value.is_nan() { self } else { other }
        }

        #[inline]
        fn min(self, other: Self) -> Self {
            if self.value <= other.value || other.value.is_nan() { self } else { other }
        }

        #[inline]
        fn at_least(self, least: f64) -> Self {
            if self.value >= least { self } else { Self::from(least) }
        }

        #[inline]
        fn at_most(self, most: f64) -> Self {
            if self.value <= most { self } else { Self::from(most) }
        }

        #[inline]
        fn within(self, least: f64, most: f64) -> Self {
            if self.value < least {
                Self::from(least)
            } else if self.value > most {
                Self::from(most)
            } else {
                self
            }
        }

        #[inline]
        fn copysign(self, sign: f64) -> Self {
            let value = self.value.copysign(sign);
            if value.is_sign_positive() == self.value.is_sign_positive() { self } else { -self }
        }
    };
}

pub(super) use {functions_by_slopes, operations_by_slopes, operator};
