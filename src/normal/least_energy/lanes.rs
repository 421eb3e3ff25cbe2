//! Four numbers at once: with AVX2 and FMA where the processor has them, found out at run time, else
//! by plain arithmetic.
//!
//! What is written for a [`Simd`] is to be inlined into the one function that is compiled for its
//! instructions. Both ways to calculate differ in the last bits, since one rounds a product and a sum
//! at once.

#[cfg(target_arch = "x86_64")]
mod avx2;

use std::array::from_fn;
use std::ops::{Add, Div, Mul, Sub};

/// Numbers taken together.
pub(super) const LANES: usize = 4;
pub(super) type Lanes = [f64; LANES];

/// Fours that are few: contacts have no more of them, and are worth straight code for their number.
pub(super) const FEW: usize = 8;

/// Calls for `count` of `blocks` fours as a constant, or for 0 where there are more than a few, and
/// where the instructions `S` have no straight code.
macro_rules! by_blocks {
    ($count:expr, $blocks:expr => $b:ident, $call:expr) => {
        if S::IS_STRAIGHT {
            match if $blocks > FEW { 0 } else { $count } {
                1 => { const $b: usize = 1; $call }
                2 => { const $b: usize = 2; $call }
                3 => { const $b: usize = 3; $call }
                4 => { const $b: usize = 4; $call }
                5 => { const $b: usize = 5; $call }
                6 => { const $b: usize = 6; $call }
                7 => { const $b: usize = 7; $call }
                8 => { const $b: usize = 8; $call }
                _ => { const $b: usize = 0; $call }
            }
        } else {
            const $b: usize = 0;
            $call
        }
    };
    ($blocks:expr => $b:ident, $call:expr) => { by_blocks!($blocks, $blocks => $b, $call) };
}
pub(super) use by_blocks;

/// From one column of a matrix to the next, for `B` as [`by_blocks`] has it.
#[inline(always)]
pub(super) fn stride<const B: usize>(blocks: usize) -> usize {
    if B > 0 { FEW } else { blocks.max(FEW) }
}

/// The first `B` of a column, or `count` of them for 0.
#[inline(always)]
pub(super) fn first<const B: usize, T>(column: &[T], count: usize) -> &[T] {
    if B > 0 { &column[..B] } else { &column[..count] }
}

/// As [`first`], to be changed.
#[inline(always)]
pub(super) fn first_mut<const B: usize, T>(column: &mut [T], count: usize) -> &mut [T] {
    if B > 0 { &mut column[..B] } else { &mut column[..count] }
}

/// Instructions on four numbers.
pub(super) trait Simd: Copy {
    /// Whether there is straight code for a few fours.
    const IS_STRAIGHT: bool = true;

    /// Four numbers in a register.
    type Raw: Copy;

    fn load(self, x: Lanes) -> Self::Raw;
    fn store(self, x: Self::Raw) -> Lanes;
    fn add(self, a: Self::Raw, b: Self::Raw) -> Self::Raw;
    fn sub(self, a: Self::Raw, b: Self::Raw) -> Self::Raw;
    fn mul(self, a: Self::Raw, b: Self::Raw) -> Self::Raw;
    fn div(self, a: Self::Raw, b: Self::Raw) -> Self::Raw;
    fn min(self, a: Self::Raw, b: Self::Raw) -> Self::Raw;
    fn max(self, a: Self::Raw, b: Self::Raw) -> Self::Raw;
    fn sqrt(self, x: Self::Raw) -> Self::Raw;
    /// `c` + `a` `b`.
    fn add_product(self, c: Self::Raw, a: Self::Raw, b: Self::Raw) -> Self::Raw;
    /// `c` - `a` `b`.
    fn sub_product(self, c: Self::Raw, a: Self::Raw, b: Self::Raw) -> Self::Raw;
    /// `yes` where `a` = `b`, else `no`.
    fn where_equal(self, a: Self::Raw, b: Self::Raw, yes: Self::Raw, no: Self::Raw) -> Self::Raw;
    /// `yes` where `a` < `b`, else `no`.
    fn where_less(self, a: Self::Raw, b: Self::Raw, yes: Self::Raw, no: Self::Raw) -> Self::Raw;
    /// The last one of `x`, then the first three of `y`.
    fn shift_in(self, x: Self::Raw, y: Self::Raw) -> Self::Raw;
    /// The last three of `x`, then the first one of `y`.
    fn shift_out(self, x: Self::Raw, y: Self::Raw) -> Self::Raw;
    /// First numbers of four rows, second ones, third ones, fourth ones.
    fn columns(self, rows: [Lanes; LANES]) -> [Self::Raw; LANES];
    /// (binary digits of `x` over 2^`SHIFT` + `add`) and `mask`.
    fn digits<const SHIFT: i32>(self, x: Self::Raw, add: [u64; LANES], mask: u64) -> [u64; LANES];
    /// Exponential, of numbers below 700.
    fn exp(self, x: Self::Raw) -> Self::Raw;

    /// Does `work` in a function of its own, which keeps the code around it simple; the work is to be
    /// inlined.
    fn apart<R>(self, work: impl FnMut() -> R) -> R;

    #[inline(always)]
    fn four(self, x: &Lanes) -> Four<Self> {
        Four { simd: self, raw: self.load(*x) }
    }

    #[inline(always)]
    fn splat(self, x: f64) -> Four<Self> {
        Four { simd: self, raw: self.load([x; LANES]) }
    }
}

/// Four numbers that calculate with the instructions `S`.
#[derive(Clone, Copy)]
pub(super) struct Four<S: Simd> {
    simd: S,
    raw: S::Raw,
}

/// An operation of two [`Four`], and of one and a number.
macro_rules! operation {
    ($trait:ident $function:ident) => {
        impl<S: Simd> $trait for Four<S> {
            type Output = Self;

            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                Self { raw: self.simd.$function(self.raw, other.raw), ..self }
            }
        }

        impl<S: Simd> $trait<f64> for Four<S> {
            type Output = Self;

            #[inline(always)]
            fn $function(self, other: f64) -> Self {
                $trait::$function(self, self.simd.splat(other))
            }
        }
    };
}
operation!(Add add);
operation!(Sub sub);
operation!(Mul mul);
operation!(Div div);

/// Methods of [`Four`] that are an instruction each.
macro_rules! instructions {
    ($($(#[$doc:meta])* $function:ident($($x:ident),*);)*) => {$(
        $(#[$doc])*
        #[inline(always)]
        pub fn $function(self, $($x: Self),*) -> Self {
            self.with(self.simd.$function(self.raw, $($x.raw),*))
        }
    )*};
}

impl<S: Simd> Four<S> {
    #[inline(always)]
    fn with(self, raw: S::Raw) -> Self {
        Self { raw, ..self }
    }

    #[inline(always)]
    pub fn lanes(self) -> Lanes {
        self.simd.store(self.raw)
    }

    instructions! {
        /// Itself and `a` `b`.
        add_product(a, b);
        /// Itself less `a` `b`.
        sub_product(a, b);
        /// The lesser ones.
        min(other);
        /// The greater ones.
        max(other);
        /// Square roots.
        sqrt();
        /// Exponentials, of numbers below 700.
        exp();
        /// `yes` where it is less than `other`, else `no`.
        where_less(other, yes, no);
    }

    /// Magnitudes.
    #[inline(always)]
    pub fn abs(self) -> Self {
        self.max(self.simd.splat(0.0) - self)
    }

    /// `yes` where it is `other`, else `no`.
    #[inline(always)]
    pub fn where_equal(self, other: f64, yes: Self, no: Self) -> Self {
        let other = self.simd.splat(other).raw;
        self.with(self.simd.where_equal(self.raw, other, yes.raw, no.raw))
    }

    /// The numbers that stand before each of them, after those of `last`.
    #[inline(always)]
    pub fn before(self, last: Self) -> Self {
        self.with(self.simd.shift_in(last.raw, self.raw))
    }

    /// The numbers that stand behind each of them, before those of `next`.
    #[inline(always)]
    pub fn behind(self, next: Self) -> Self {
        self.with(self.simd.shift_out(self.raw, next.raw))
    }

    /// (Binary digits over 2^`SHIFT` + `add`) and `mask`.
    #[inline(always)]
    pub fn digits<const SHIFT: i32>(self, add: [u64; LANES], mask: u64) -> [u64; LANES] {
        self.simd.digits::<SHIFT>(self.raw, add, mask)
    }

    /// First numbers of four rows, second ones, third ones, fourth ones.
    #[inline(always)]
    pub fn columns(simd: S, rows: [Lanes; LANES]) -> [Self; LANES] {
        let [a, b, c, d] = simd.columns(rows);
        [Self { simd, raw: a }, Self { simd, raw: b }, Self { simd, raw: c }, Self { simd, raw: d }]
    }

    /// The greatest of all four.
    #[inline(always)]
    pub fn greatest(self) -> f64 {
        let [a, b, c, d] = self.lanes();
        a.max(c).max(b.max(d))
    }

    /// The sum of all four.
    #[inline(always)]
    pub fn sum(self) -> f64 {
        let [a, b, c, d] = self.lanes();
        (a + c) + (b + d)
    }
}

/// Plain arithmetic; products are fused to sums where that is one instruction.
#[derive(Clone, Copy)]
pub(super) struct Plain;

/// Whether every processor that this is compiled for adds a product in one instruction.
const FUSED: bool = cfg!(any(target_feature = "fma", target_arch = "aarch64"));

/// What is done in each lane.
macro_rules! lane_by_lane {
    ($($(#[$attribute:meta])* $function:ident($($x:ident),+) = $one:expr;)*) => {$(
        $(#[$attribute])*
        #[inline(always)]
        fn $function(self, $($x: Lanes),+) -> Lanes {
            from_fn(|i| {
                let ($($x,)+) = ($($x[i],)+);
                $one
            })
        }
    )*};
}

impl Simd for Plain {
    /// Where there are better instructions these are for old processors.
    const IS_STRAIGHT: bool = cfg!(not(target_arch = "x86_64"));

    type Raw = Lanes;

    #[inline(always)]
    fn load(self, x: Lanes) -> Lanes {
        x
    }

    #[inline(always)]
    fn store(self, x: Lanes) -> Lanes {
        x
    }

    lane_by_lane! {
        add(a, b) = a + b;
        sub(a, b) = a - b;
        mul(a, b) = a * b;
        div(a, b) = a / b;
        min(a, b) = if a < b { a } else { b };
        max(a, b) = if a > b { a } else { b };
        sqrt(x) = x.sqrt();
        exp(x) = x.exp();
        add_product(c, a, b) = if FUSED { a.mul_add(b, c) } else { c + a * b };
        sub_product(c, a, b) = if FUSED { (-a).mul_add(b, c) } else { c - a * b };
        #[allow(clippy::float_cmp)]
        where_equal(a, b, yes, no) = if a == b { yes } else { no };
        where_less(a, b, yes, no) = if a < b { yes } else { no };
    }

    #[inline(always)]
    fn shift_in(self, x: Lanes, y: Lanes) -> Lanes {
        [x[3], y[0], y[1], y[2]]
    }

    #[inline(always)]
    fn shift_out(self, x: Lanes, y: Lanes) -> Lanes {
        [x[1], x[2], x[3], y[0]]
    }

    #[inline(always)]
    fn columns(self, rows: [Lanes; LANES]) -> [Lanes; LANES] {
        from_fn(|k| from_fn(|i| rows[i][k]))
    }

    #[inline(always)]
    fn digits<const SHIFT: i32>(self, x: Lanes, add: [u64; LANES], mask: u64) -> [u64; LANES] {
        from_fn(|i| (x[i].to_bits() >> SHIFT).wrapping_add(add[i]) & mask)
    }

    #[inline(never)]
    fn apart<R>(self, mut work: impl FnMut() -> R) -> R {
        work()
    }
}
