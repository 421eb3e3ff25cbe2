//! Functions of numbers with derivatives, once for all kinds of them.

/// The functions of [`Real`](super::real::Real) that follow from the derivatives by their arguments:
/// `one` is the method that gives a function its value and derivative, `two` what does so for one of
/// two numbers.
macro_rules! functions_by_slopes {
    ($one:ident, $two:expr) => {
        #[inline]
        fn sqrt(self) -> Self {
            let root = self.value.sqrt();
            if root == 0.0 { Self::from(0.0) } else { self.$one(root, 0.5 / root) }
        }

        #[inline]
        fn powi(self, power: i32) -> Self {
            self.$one(self.value.powi(power), f64::from(power) * self.value.powi(power - 1))
        }

        #[inline]
        fn three_halves(self) -> Self {
            let root = self.value.sqrt();
            self.$one(self.value * root, 1.5 * root)
        }

        #[inline]
        fn ln(self) -> Self {
            self.$one(self.value.ln(), 1.0 / self.value)
        }

        #[inline]
        fn normal_ln(self) -> Self {
            self.$one($crate::math::logarithm::ln(self.value), 1.0 / self.value)
        }

        #[inline]
        fn exp(self) -> Self {
            let value = self.value.exp();
            self.$one(value, value)
        }

        #[inline]
        fn sin_cos(self) -> (Self, Self) {
            let (sine, cosine) = self.value.sin_cos();
            (self.$one(sine, cosine), self.$one(cosine, -sine))
        }

        #[inline]
        fn asin(self) -> Self {
            let rest = 1.0 - self.value * self.value;
            let slope = if rest > 0.0 { 1.0 / rest.sqrt() } else { 0.0 };
            self.$one(self.value.asin(), slope)
        }

        #[inline]
        fn atan2(self, x: Self) -> Self {
            let square = self.value * self.value + x.value * x.value;
            let inverse = if square > 0.0 { 1.0 / square } else { 0.0 };
            let (by_y, by_x) = (x.value * inverse, -self.value * inverse);
            ($two)(self, x, self.value.atan2(x.value), by_y, by_x)
        }

        #[inline]
        fn hypotenuse(self, other: Self) -> Self {
            let length = self.value.hypotenuse(other.value);
            if length == 0.0 {
                return Self::from(0.0);
            }
            let (by_self, by_other) = (self.value / length, other.value / length);
            ($two)(self, other, length, by_self, by_other)
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

pub(super) use functions_by_slopes;
