//! Sums, products and quotients of numbers on the tape.

use std::iter::Sum;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Zero};

use super::Taped;

impl Neg for Taped {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        self.by(-self.value, -1.0)
    }
}

impl Add for Taped {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self::by_two(self, other, self.value + other.value, 1.0, 1.0)
    }
}

impl Sub for Taped {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::by_two(self, other, self.value - other.value, 1.0, -1.0)
    }
}

impl Mul for Taped {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::by_two(self, other, self.value * other.value, other.value, self.value)
    }
}

impl Div for Taped {
    type Output = Self;

    #[inline]
    fn div(self, other: Self) -> Self {
        let inverse = 1.0 / other.value;
        let value = self.value / other.value;
        Self::by_two(self, other, value, inverse, -value * inverse)
    }
}

impl Add<f64> for Taped {
    type Output = Self;

    // A constant more has the same derivatives, and so the same place.
    #[inline]
    fn add(self, other: f64) -> Self {
        Self { value: self.value + other, ..self }
    }
}

impl Sub<f64> for Taped {
    type Output = Self;

    #[inline]
    fn sub(self, other: f64) -> Self {
        Self { value: self.value - other, ..self }
    }
}

impl Mul<f64> for Taped {
    type Output = Self;

    #[inline]
    fn mul(self, other: f64) -> Self {
        self.by(self.value * other, other)
    }
}

impl Div<f64> for Taped {
    type Output = Self;

    #[inline]
    fn div(self, other: f64) -> Self {
        self.by(self.value / other, 1.0 / other)
    }
}

impl AddAssign for Taped {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Taped {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl MulAssign for Taped {
    #[inline]
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

impl DivAssign for Taped {
    #[inline]
    fn div_assign(&mut self, other: Self) {
        *self = *self / other;
    }
}

impl MulAssign<f64> for Taped {
    #[inline]
    fn mul_assign(&mut self, other: f64) {
        *self = *self * other;
    }
}

impl Zero for Taped {
    #[inline]
    fn zero() -> Self {
        Self::from(0.0)
    }

    #[inline]
    fn is_zero(&self) -> bool {
        self.value.is_zero()
    }
}

impl One for Taped {
    #[inline]
    fn one() -> Self {
        Self::from(1.0)
    }
}

impl Sum for Taped {
    fn sum<I: Iterator<Item = Self>>(numbers: I) -> Self {
        numbers.fold(Self::from(0.0), |sum, number| sum + number)
    }
}
