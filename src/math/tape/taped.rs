//! A number on the tape.

use super::{Entry, Look, TAPE, Tape};
use crate::math::by_slopes::{functions_by_slopes, operations_by_slopes};
use crate::math::dual::Dual;
use crate::math::real::{Cubic, Function, Leaf, Linear, Real};

/// A value with its place on the tape of the thread.
#[derive(Clone, Copy, Debug)]
pub struct Taped {
    /// Value.
    pub value: f64,
    /// 0 for constants.
    pub(super) place: u32,
}

impl Taped {
    /// The variable with the value `value` by which derivatives are found under `leaf`.
    pub fn leaf(value: f64, leaf: Leaf) -> Self {
        Self { value, place: leaf.0 }
    }

    /// A function of it with this value and derivative.
    #[inline]
    fn by(self, value: f64, slope: f64) -> Self {
        if self.place == 0 {
            return Self { value, place: 0 };
        }
        Self { value, place: enter([self.place, 0], [slope, 0.0]) }
    }

    /// A function of two numbers with this value and these derivatives.
    #[inline]
    fn by_two(a: Self, b: Self, value: f64, by_a: f64, by_b: f64) -> Self {
        if a.place == 0 {
            return b.by(value, by_b);
        }
        if b.place == 0 {
            return a.by(value, by_a);
        }
        Self { value, place: enter([a.place, b.place], [by_a, by_b]) }
    }

    #[inline]
    fn plus(self, other: Self) -> Self {
        Self::by_two(self, other, self.value + other.value, 1.0, 1.0)
    }

    #[inline]
    fn minus(self, other: Self) -> Self {
        Self::by_two(self, other, self.value - other.value, 1.0, -1.0)
    }
}

// Out of line: it is everywhere.
#[inline(never)]
fn enter(places: [u32; 2], slopes: [f64; 2]) -> u32 {
    TAPE.with_borrow_mut(|tape| tape.enter(Entry { places, slopes }))
}

impl From<f64> for Taped {
    #[inline]
    fn from(value: f64) -> Self {
        Self { value, place: 0 }
    }
}

operations_by_slopes!(Taped);

impl Real for Taped {
    const IS_BACKWARD: bool = true;

    fn combined<'a>(value: f64, operands: impl Iterator<Item = (&'a Self, f64)>) -> Self {
        let place = TAPE.with_borrow_mut(|tape| tape.enter_many(operands));
        Self { value, place }
    }

    #[inline]
    fn chain(self, value: f64, slope: impl FnOnce() -> f64) -> Self {
        if self.place == 0 { Self::from(value) } else { self.by(value, slope()) }
    }

    fn times(self, constant: f64, leaf: Leaf) -> Self {
        self * Self::leaf(constant, leaf)
    }

    fn scaled(self, multiple: f64, leaf: Leaf) -> Self {
        let value = self.value * multiple;
        Self::by_two(self, Self::leaf(multiple, leaf), value, multiple, value)
    }

    #[inline]
    fn known(value: f64, leaf: Leaf) -> Self {
        Self::leaf(value, leaf)
    }

    fn on_cubic(self, start: f64, coefficients: &Cubic, piece: usize) -> [[Self; 2]; 3] {
        let [c0, c1, c2, c3] = coefficients;
        let u = self.value - start;
        let mut found = [[Self::default(); 2]; 3];
        TAPE.with_borrow_mut(|tape| {
            let first = tape.entries.len() as u32;
            tape.looks.push(Look { piece, distance: u, first });
            let enter = |tape: &mut Tape, value, slope| {
                let entry = Entry { places: [self.place, 0], slopes: [slope, 0.0] };
                Self { value, place: tape.enter(entry) }
            };
            let first = [0, 1].map(|i| u * (u * (3.0 * c3[i]) + 2.0 * c2[i]) + c1[i]);
            let second = [0, 1].map(|i| u * (6.0 * c3[i]) + 2.0 * c2[i]);
            found[0] = [0, 1].map(|i| {
                let value = u * (u * (u * c3[i] + c2[i]) + c1[i]) + c0[i];
                enter(tape, value, first[i])
            });
            found[1] = [0, 1].map(|i| enter(tape, first[i], second[i]));
            found[2] = [0, 1].map(|i| enter(tape, second[i], 6.0 * c3[i]));
        });
        found
    }

    fn as_whole<const K: usize, const M: usize>(
        numbers: [Self; K],
        function: &impl Function<K, M>,
    ) -> [Self; M] {
        Self::as_whole_again(numbers, function, &mut None)
    }

    fn as_whole_again<const K: usize, const M: usize>(
        numbers: [Self; K],
        function: &impl Function<K, M>,
        kept: &mut Option<[Linear<K>; M]>,
    ) -> [Self; M] {
        let found = kept.get_or_insert_with(|| {
            let found = function.at(std::array::from_fn(|k| Dual::variable(numbers[k].value, k)));
            found.map(|Dual { value, slopes }| Linear { value, slopes })
        });
        found.map(|found| Self::combined(found.value, numbers.iter().zip(found.slopes)))
    }

    functions_by_slopes!();

    #[inline]
    fn abs(self) -> Self {
        if self.value.is_sign_positive() { self } else { -self }
    }
}
