//! Structs and arrays of numbers, taken number by number, in the order of their fields.

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

/// [`Numbers`] of a struct by its fields: those that are made of numbers, those that are `kept` as
/// they are, and where all others come from.
macro_rules! numbers {
    ($name:ident: $($field:ident),+ $(; kept $kept:ident)? $(; ..$rest:expr)?) => {
        impl<T: $crate::math::real::Real> $crate::math::numbers::Numbers<T> for $name<T> {
            type Of<S> = $name<S>;

            #[inline]
            fn each_with<U: Copy, S: Default>(
                &self,
                other: &$name<U>,
                turn: &mut impl FnMut(T, U) -> S,
            ) -> $name<S> {
                $name {
                    $($field: self.$field.each_with(&other.$field, turn),)+
                    $($kept: self.$kept,)?
                    $(..$rest)?
                }
            }

            #[inline]
            fn each<S: Default>(&self, turn: &mut impl FnMut(T) -> S) -> $name<S> {
                $name {
                    $($field: self.$field.each(turn),)+
                    $($kept: self.$kept,)?
                    $(..$rest)?
                }
            }
        }
    };
}
pub(crate) use numbers;
