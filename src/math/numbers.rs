//! Structs, arrays and lists of numbers, taken number by number, in the order of their fields.

use super::fixed_vec::FixedVec;
use super::real::Real;

/// What is made of numbers `T`, and the same of other numbers.
pub trait Numbers<T: Real> {
    /// The same of numbers `S`.
    type Of<S>;

    /// Each number made by `turn` from that of this and of an `other`.
    fn each_with<U: Copy, S: Default>(
        &self,
        other: &Self::Of<U>,
        turn: &mut impl FnMut(T, U) -> S,
    ) -> Self::Of<S>;

    /// Each number made by `turn` from that of this.
    fn each<S: Default>(&self, turn: &mut impl FnMut(T) -> S) -> Self::Of<S>;
}

impl<T: Real> Numbers<T> for T {
    type Of<S> = S;

    #[inline]
    fn each_with<U: Copy, S: Default>(&self, other: &U, turn: &mut impl FnMut(T, U) -> S) -> S {
        turn(*self, *other)
    }

    #[inline]
    fn each<S: Default>(&self, turn: &mut impl FnMut(T) -> S) -> S {
        turn(*self)
    }
}

impl<T: Real, A: Numbers<T>, const N: usize> Numbers<T> for [A; N] {
    type Of<S> = [A::Of<S>; N];

    #[inline]
    fn each_with<U: Copy, S: Default>(
        &self,
        other: &Self::Of<U>,
        turn: &mut impl FnMut(T, U) -> S,
    ) -> Self::Of<S> {
        std::array::from_fn(|i| self[i].each_with(&other[i], turn))
    }

    #[inline]
    fn each<S: Default>(&self, turn: &mut impl FnMut(T) -> S) -> Self::Of<S> {
        std::array::from_fn(|i| self[i].each(turn))
    }
}

impl<T: Real, A: Numbers<T>> Numbers<T> for FixedVec<A> {
    type Of<S> = FixedVec<A::Of<S>>;

    fn each_with<U: Copy, S: Default>(
        &self,
        other: &Self::Of<U>,
        turn: &mut impl FnMut(T, U) -> S,
    ) -> Self::Of<S> {
        let mut turned = FixedVec::new(self.len());
        turned.extend(self.iter().zip(&**other).map(|(own, other)| own.each_with(other, turn)));
        turned
    }

    fn each<S: Default>(&self, turn: &mut impl FnMut(T) -> S) -> Self::Of<S> {
        let mut turned = FixedVec::new(self.len());
        turned.extend(self.iter().map(|own| own.each(turn)));
        turned
    }
}

/// [`Numbers`] of a struct by its fields: those that are made of numbers, those that are `kept` as
/// they are, and where all others come from.
macro_rules! numbers {
    (
        $name:ident $(<$life:lifetime>)?: $($field:ident),+
        $(; kept $($kept:ident),+)? $(; ..$rest:expr)?
    ) => {
        impl<$($life,)? T: $crate::math::real::Real> $crate::math::numbers::Numbers<T>
            for $name<$($life,)? T>
        {
            type Of<S> = $name<$($life,)? S>;

            #[inline]
            fn each_with<U: Copy, S: Default>(
                &self,
                other: &Self::Of<U>,
                turn: &mut impl FnMut(T, U) -> S,
            ) -> Self::Of<S> {
                $name {
                    $($field: self.$field.each_with(&other.$field, turn),)+
                    $($($kept: self.$kept,)+)?
                    $(..$rest)?
                }
            }

            #[inline]
            fn each<S: Default>(&self, turn: &mut impl FnMut(T) -> S) -> Self::Of<S> {
                $name {
                    $($field: self.$field.each(turn),)+
                    $($($kept: self.$kept,)+)?
                    $(..$rest)?
                }
            }
        }
    };
}
pub(crate) use numbers;
