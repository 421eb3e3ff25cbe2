//! Numbers that the mechanics is written for: plain ones and dual numbers, which carry derivatives.

use std::any::Any;
use std::fmt::Debug;
use std::iter::Sum;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Zero};

use super::logarithm;

/// Number of a constant that derivatives can be taken by, from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Leaf(pub u32);

/// `x` as an `O`, if that is what it is.
#[inline]
pub fn as_is<T: 'static, O: 'static>(x: &T) -> Option<&O> {
    (x as &dyn Any).downcast_ref()
}

/// Sum of two squares above which what a square loses near zero is less than its rounding.
const LEAST_SQUARE: f64 = f64::MIN_POSITIVE / (f64::EPSILON * f64::EPSILON);

/// Coefficients of (y, z) in growing powers of the distance from the start of a piece of a curve.
pub type Cubic = [[f64; 2]; 4];

/// A number and its derivatives by `K` others.
#[derive(Clone, Copy, Debug)]
pub struct Linear<const K: usize> {
    /// Value.
    pub value: f64,
    /// Derivatives.
    pub slopes: [f64; K],
}

/// `M` functions of `K` numbers, of whatever kind these are.
pub trait Function<const K: usize, const M: usize> {
    /// Their values.
    fn at<T: Real>(&self, numbers: [T; K]) -> [T; M];
}

/// A real number, or one with its derivatives: forwards ([`Dual`](super::dual::Dual)) or backwards
/// ([`Taped`](super::tape::Taped)).
///
/// Comparisons look at the value alone: where a formula has branches, derivatives are those of the
/// branch that the value takes. For `f64` methods are those of the standard library where nothing
/// else is said.
pub trait Real:
    Copy
    + Debug
    + Default
    + PartialOrd
    + PartialOrd<f64>
    + From<f64>
    + Zero
    + One
    + Sum
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + DivAssign
    + MulAssign<f64>
    + 'static
{
    /// Whether there are derivatives to be carried along.
    const HAS_SLOPES: bool;

    /// Whether they are carried backwards, each operation at a price whatever it does.
    const IS_BACKWARD: bool = false;

    /// The number without derivatives.
    fn value(self) -> f64;

    /// The number `value` with the derivatives of `rates`: what a search has found, and how it
    /// moves.
    fn moving(value: f64, rates: Self) -> Self;

    /// The number `value` that is by each of the `operands` what stands beside it.
    fn combined<'a>(value: f64, operands: impl Iterator<Item = (&'a Self, f64)>) -> Self {
        let moved = operands.map(|(operand, slope)| *operand * slope);
        Self::moving(value, moved.sum())
    }

    /// The function of this number that has the value `value` and the derivative `slope()` there.
    fn chain(self, value: f64, slope: impl FnOnce() -> f64) -> Self;

    /// Itself times a constant of the model, by which derivatives go back to `leaf`.
    #[inline]
    fn times(self, constant: f64, leaf: Leaf) -> Self {
        let _ = leaf;
        self * constant
    }

    /// Itself times a `multiple` of a constant of the model, by the logarithm of which derivatives
    /// go back to `leaf`.
    #[inline]
    fn scaled(self, multiple: f64, leaf: Leaf) -> Self {
        let _ = leaf;
        self * multiple
    }

    /// A constant of the model, by which derivatives go back to `leaf`.
    #[inline]
    fn known(value: f64, leaf: Leaf) -> Self {
        let _ = leaf;
        value.into()
    }

    /// (y, z) of a curve at this parameter, its first and its second derivatives, by the
    /// `coefficients` of a piece that begins at `start`; `piece` is its address, by which
    /// derivatives go back to the curve.
    // Taken apart where it is used: half of its callers leave out the second derivative.
    #[inline(always)]
    fn on_cubic(self, start: f64, coefficients: &Cubic, piece: usize) -> [[Self; 2]; 3] {
        let _ = piece;
        (self - start).cubic(coefficients)
    }

    /// (y, z) of a piece of a curve at this distance from its start, its first and its second
    /// derivatives.
    // As above.
    #[inline(always)]
    fn cubic(self, [c0, c1, c2, c3]: &Cubic) -> [[Self; 2]; 3] {
        let u = self;
        // Both coordinates at once: one vector instruction for the pair.
        let zero = [Self::from(0.0); 2];
        let (mut point, mut first, mut second) = (zero, zero, zero);
        for i in 0..2 {
            point[i] = u * (u * (u * c3[i] + c2[i]) + c1[i]) + c0[i];
            first[i] = u * (u * (3.0 * c3[i]) + 2.0 * c2[i]) + c1[i];
            second[i] = u * (6.0 * c3[i]) + 2.0 * c2[i];
        }
        [point, first, second]
    }

    /// A function of a few numbers; derivatives backwards see the function as a whole, which is
    /// cheaper the more there is in it.
    #[inline]
    fn as_whole<const K: usize, const M: usize>(
        numbers: [Self; K],
        function: &impl Function<K, M>,
    ) -> [Self; M] {
        function.at(numbers)
    }

    /// The same where the function was asked for at the same values before, and what it found then
    /// may have been `kept`.
    #[inline]
    fn as_whole_again<const K: usize, const M: usize>(
        numbers: [Self; K],
        function: &impl Function<K, M>,
        kept: &mut Option<[Linear<K>; M]>,
    ) -> [Self; M] {
        let _ = kept;
        function.at(numbers)
    }

    /// Itself and `a` `b`; of plain numbers rounded once if `IS_FUSED`, which is fast where the
    /// instructions that are compiled for have that.
    #[inline]
    fn add_product<const IS_FUSED: bool>(self, a: Self, b: Self) -> Self {
        self + a * b
    }

    /// Square root; at zero without derivatives.
    fn sqrt(self) -> Self;

    /// Whole power.
    fn powi(self, power: i32) -> Self;

    /// Power 3/2.
    fn three_halves(self) -> Self;

    /// Natural logarithm.
    fn ln(self) -> Self;

    /// Natural logarithm of a normal number > 0, as [`logarithm::ln`].
    fn normal_ln(self) -> Self;

    /// Exponential.
    fn exp(self) -> Self;

    /// Sine and cosine.
    fn sin_cos(self) -> (Self, Self);

    /// Arc sine.
    fn asin(self) -> Self;

    /// Angle of the point (`x`, self).
    fn atan2(self, x: Self) -> Self;

    /// sqrt(self² + other²); not that of the C library, whose last digit is another one on each
    /// platform.
    fn hypotenuse(self, other: Self) -> Self;

    /// Magnitude.
    fn abs(self) -> Self;

    /// 1 or -1, as the sign of the value.
    fn signum(self) -> f64;

    /// The greater one; a number where one of them is none.
    fn max(self, other: Self) -> Self;

    /// The lesser one; a number where one of them is none.
    fn min(self, other: Self) -> Self;

    /// The greater one of it and a constant.
    fn at_least(self, least: f64) -> Self;

    /// The lesser one of it and a constant.
    fn at_most(self, most: f64) -> Self;

    /// Between two constants.
    fn within(self, least: f64, most: f64) -> Self;

    /// Its magnitude with the sign of `sign`.
    fn copysign(self, sign: f64) -> Self;
}

/// Methods that are functions of this name.
macro_rules! forwarded {
    ($($method:ident($($argument:ident: $kind:ty),*) -> $result:ty = $function:path;)*) => {$(
        #[inline]
        fn $method(self, $($argument: $kind),*) -> $result {
            $function(self, $($argument),*)
        }
    )*};
}

impl Real for f64 {
    const HAS_SLOPES: bool = false;

    #[inline]
    fn value(self) -> f64 {
        self
    }

    #[inline]
    fn moving(value: f64, _: Self) -> Self {
        value
    }

    #[inline]
    fn chain(self, value: f64, _: impl FnOnce() -> f64) -> Self {
        value
    }

    #[inline]
    fn add_product<const IS_FUSED: bool>(self, a: Self, b: Self) -> Self {
        if IS_FUSED { a.mul_add(b, self) } else { self + a * b }
    }

    forwarded! {
        sqrt() -> Self = f64::sqrt;
        powi(power: i32) -> Self = f64::powi;
        ln() -> Self = f64::ln;
        normal_ln() -> Self = logarithm::ln;
        exp() -> Self = f64::exp;
        sin_cos() -> (Self, Self) = f64::sin_cos;
        asin() -> Self = f64::asin;
        atan2(x: Self) -> Self = f64::atan2;
        abs() -> Self = f64::abs;
        signum() -> f64 = f64::signum;
        max(other: Self) -> Self = f64::max;
        min(other: Self) -> Self = f64::min;
        at_least(least: f64) -> Self = f64::max;
        at_most(most: f64) -> Self = f64::min;
        within(least: f64, most: f64) -> Self = f64::clamp;
        copysign(sign: f64) -> Self = f64::copysign;
    }

    #[inline]
    fn hypotenuse(self, other: Self) -> Self {
        let square = self * self + other * other;
        // The one of libm finds it elsewhere too, at a greater price.
        if square > LEAST_SQUARE && square < f64::INFINITY {
            square.sqrt()
        } else {
            libm::hypot(self, other)
        }
    }

    #[inline]
    fn three_halves(self) -> Self {
        self * self.sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::Real;
    use approx::assert_relative_eq;

    #[test]
    fn a_hypotenuse_is_found_from_the_least_numbers_to_the_greatest() {
        for exponent in [-320, -170, -154, -139, -138, -100, 0, 100, 153, 154, 300] {
            let scale = format!("1e{exponent}").parse::<f64>().expect("a number");
            for [a, b] in [[3.0, 4.0], [-1.0, 1e-9], [0.0, 1.0], [1.0, 1.0]] {
                let found = (a * scale).hypotenuse(b * scale);
                assert_relative_eq!(found, (a * scale).hypot(b * scale), max_relative = 1e-15);
            }
        }
        assert_eq!(0.0.hypotenuse(0.0).to_bits(), 0);
        assert!(f64::NAN.hypotenuse(1.0).is_nan());
    }
}
