//! An arc tangent that vectorises.
//!
//! The one of the standard library is a call for each number; this one is plain arithmetic, as the
//! logarithm beside it.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

/// tan(π/8): below it the polynomial holds.
const TURN: f64 = std::f64::consts::SQRT_2 - 1.0;

/// (arctan √s)/√s for s from 0 to tan²(π/8), highest power first: the polynomial of degree 10 of
/// least greatest error, 4e-17.
#[rustfmt::skip]
const POLYNOMIAL: [f64; 11] = [
    0.021_133_752_033_748_36, -0.043_479_198_390_465_37, 0.056_883_034_036_332_5, -0.066_402_251_735_395,
    0.076_899_524_882_330_16, -0.090_907_730_032_408_28, 0.111_111_061_773_752_27, -0.142_857_141_809_006_45,
    0.199_999_999_988_541_67, -0.333_333_333_333_284_34, 1.0,
];

/// arctan(y/x) for x ≥ 0, -π/2 to π/2, to within 3e-16; 0 for y = x = 0.
///
/// The angle is taken from 0, π/4 or π/2, whichever is nearest.
#[inline]
pub fn arctangent(y: f64, x: f64) -> f64 {
    debug_assert!(x >= 0.0 && y.is_finite());
    let side = y.abs();
    let near = side <= TURN * x;
    let far = TURN * side > x;
    let (from, top, bottom) = if near {
        (0.0, side, x)
    } else if far {
        (FRAC_PI_2, -x, side)
    } else {
        (FRAC_PI_4, side - x, side + x)
    };
    // Nothing over nothing is an angle of nothing.
    let t = top / (bottom + f64::MIN_POSITIVE);
    let s = t * t;
    let mut series = POLYNOMIAL[0];
    for coefficient in &POLYNOMIAL[1..] {
        series = series * s + coefficient;
    }
    (from + t * series).copysign(y)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_that_of_the_standard_library_at_all_angles() {
        for i in -20_000..=20_000 {
            let angle = FRAC_PI_2 * f64::from(i) / 20_000.0;
            for size in [1e-12, 1.0, 1e9] {
                let (y, x) = (size * angle.sin(), (size * angle.cos()).max(0.0));
                let error = (arctangent(y, x) - y.atan2(x)).abs();
                assert!(error <= 3e-16, "{y} over {x} is off by {error}");
            }
        }
        for (y, x) in [(0.0, 0.0), (0.0, 1.0), (1.0, 0.0), (-1.0, 0.0), (1.0, 1.0), (-3.0, 1e-300)]
        {
            assert!((arctangent(y, x) - y.atan2(x)).abs() <= 3e-16, "{y} over {x}");
        }
    }
}
