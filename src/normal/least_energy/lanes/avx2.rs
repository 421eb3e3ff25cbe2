//! Four numbers in a register of AVX2, through the safe functions of `pulp`.

use std::arch::x86_64::{__m256d, __m256i};
use std::f64::consts::LOG2_E;

use pulp::cast;
use pulp::x86::V3;

use super::{LANES, Lanes, Simd};
use crate::math::vectors::Work;

/// ln 2 in two parts, of which the first one times a small whole number is exact.
const LN_2: [f64; 2] = [0.693_147_180_369_123_8, 1.908_214_929_270_587_7e-10];
/// 1.5 2^52, which added to a whole number puts it into the last binary digits, and the bias.
const TO_EXPONENT: f64 = 6_755_399_441_055_744.0 + 1023.0;
const MANTISSA: i32 = 52;

/// Operations that are one instruction.
macro_rules! instructions {
    ($($function:ident($($x:ident),+) = $set:ident.$instruction:ident($($operand:ident),+);)*) => {$(
        #[inline(always)]
        fn $function(self, $($x: __m256d),+) -> __m256d {
            self.$set.$instruction($($operand),+)
        }
    )*};
}

impl Simd for V3 {
    type Raw = __m256d;

    #[inline(always)]
    fn load(self, x: Lanes) -> __m256d {
        cast(x)
    }

    #[inline(always)]
    fn store(self, x: __m256d) -> Lanes {
        cast(x)
    }

    instructions! {
        add(a, b) = avx._mm256_add_pd(a, b);
        sub(a, b) = avx._mm256_sub_pd(a, b);
        mul(a, b) = avx._mm256_mul_pd(a, b);
        div(a, b) = avx._mm256_div_pd(a, b);
        min(a, b) = avx._mm256_min_pd(a, b);
        max(a, b) = avx._mm256_max_pd(a, b);
        sqrt(x) = avx._mm256_sqrt_pd(x);
        add_product(c, a, b) = fma._mm256_fmadd_pd(a, b, c);
        sub_product(c, a, b) = fma._mm256_fnmadd_pd(a, b, c);
    }

    #[inline(always)]
    fn where_equal(self, a: __m256d, b: __m256d, yes: __m256d, no: __m256d) -> __m256d {
        const EQUAL: i32 = 0;
        self.avx._mm256_blendv_pd(no, yes, self.avx._mm256_cmp_pd::<EQUAL>(a, b))
    }

    #[inline(always)]
    fn where_less(self, a: __m256d, b: __m256d, yes: __m256d, no: __m256d) -> __m256d {
        const LESS: i32 = 0x11;
        self.avx._mm256_blendv_pd(no, yes, self.avx._mm256_cmp_pd::<LESS>(a, b))
    }

    #[inline(always)]
    fn shift_in(self, x: __m256d, y: __m256d) -> __m256d {
        let middle = self.avx._mm256_permute2f128_pd::<0x21>(x, y);
        self.avx._mm256_shuffle_pd::<0b0101>(middle, y)
    }

    #[inline(always)]
    fn shift_out(self, x: __m256d, y: __m256d) -> __m256d {
        let middle = self.avx._mm256_permute2f128_pd::<0x21>(x, y);
        self.avx._mm256_shuffle_pd::<0b0101>(x, middle)
    }

    #[inline(always)]
    fn columns(self, rows: [Lanes; LANES]) -> [__m256d; LANES] {
        let avx = self.avx;
        let [r, s, t, u] = rows;
        // The halves of two rows side by side.
        let (a, b) =
            (pair(self, [r[0], r[1]], [t[0], t[1]]), pair(self, [s[0], s[1]], [u[0], u[1]]));
        let (c, d) =
            (pair(self, [r[2], r[3]], [t[2], t[3]]), pair(self, [s[2], s[3]], [u[2], u[3]]));
        [
            avx._mm256_unpacklo_pd(a, b),
            avx._mm256_unpackhi_pd(a, b),
            avx._mm256_unpacklo_pd(c, d),
            avx._mm256_unpackhi_pd(c, d),
        ]
    }

    #[inline(always)]
    fn digits<const SHIFT: i32>(self, x: __m256d, add: [u64; LANES], mask: u64) -> [u64; LANES] {
        let avx2 = self.avx2;
        let number = avx2._mm256_srli_epi64::<SHIFT>(cast::<__m256d, __m256i>(x));
        let sum = avx2._mm256_add_epi64(number, cast(add));
        cast(avx2._mm256_and_si256(sum, cast([mask; LANES])))
    }

    #[inline(always)]
    fn exp(self, x: __m256d) -> __m256d {
        const NEAREST: i32 = 8;
        // 1/12! to 1/0!.
        #[rustfmt::skip]
        const INVERSE_FACTORIALS: [f64; 13] = [
            1.0 / 479_001_600.0, 1.0 / 39_916_800.0, 1.0 / 3_628_800.0, 1.0 / 362_880.0,
            1.0 / 40_320.0, 1.0 / 5_040.0, 1.0 / 720.0, 1.0 / 120.0,
            1.0 / 24.0, 1.0 / 6.0, 0.5, 1.0,
            1.0,
        ];
        let all = |x: f64| cast::<Lanes, __m256d>([x; LANES]);
        let whole = self.avx._mm256_round_pd::<NEAREST>(self.mul(x, all(LOG2_E)));
        let rest = self.sub_product(x, whole, all(LN_2[0]));
        let rest = self.sub_product(rest, whole, all(LN_2[1]));
        let mut sum = all(INVERSE_FACTORIALS[0]);
        for next in &INVERSE_FACTORIALS[1..] {
            sum = self.add_product(all(*next), sum, rest);
        }
        let digits = cast::<__m256d, __m256i>(self.add(whole, all(TO_EXPONENT)));
        self.mul(sum, cast(self.avx2._mm256_slli_epi64::<MANTISSA>(digits)))
    }

    #[inline(never)]
    fn apart<R>(self, work: impl FnMut() -> R) -> R {
        self.vectorize(Work(work))
    }
}

/// Two numbers and two others.
#[inline(always)]
fn pair(simd: V3, low: [f64; 2], high: [f64; 2]) -> __m256d {
    let low = simd.avx._mm256_castpd128_pd256(cast(low));
    simd.avx._mm256_insertf128_pd::<1>(low, cast(high))
}
