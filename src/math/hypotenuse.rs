//! sqrt(x² + y²) by the same operations everywhere.
//!
//! That of a C library has its last digit by what the library is and by what its processor adds at
//! once. Such a digit of a direction on the profile moves forces by up to some 1e-10, as the
//! contact of a wheel that hardly touches goes with differences of heights: units for other
//! platforms would not give the same ones. Square roots, products and sums are the same on all.
//!
//! Source: Borges (2019), An Improved Algorithm for hypot(a, b), arXiv:1904.09481: the plain root,
//! corrected by the rest that it leaves, without fused products. Exact to within one unit in the last
//! place; the bits of glibc 2.35 and later on x86-64.

/// Lesser over greater number up to which the lesser one does not count.
const NOTHING: f64 = 1.0 / (1_u64 << 54) as f64;

/// 2 to this power, which is not too small for a normal number.
const fn power_of_two(exponent: i64) -> f64 {
    f64::from_bits(((1023 + exponent) as u64) << 52)
}

/// Numbers whose squares overflow, or underflow, and what brings them back.
const HUGE: f64 = power_of_two(511);
const TINY: f64 = power_of_two(-459);
const SCALE: f64 = power_of_two(600);

/// sqrt(x² + y²) without overflow and underflow on the way.
#[inline]
#[must_use]
pub fn hypotenuse(x: f64, y: f64) -> f64 {
    let (x, y) = (x.abs(), y.abs());
    let (long, short) = if x < y { (y, x) } else { (x, y) };
    // As the standard wants it, an infinite side counts more than one that is not a number.
    if !(long < f64::INFINITY && short < f64::INFINITY) {
        return if x.is_infinite() || y.is_infinite() { f64::INFINITY } else { x + y };
    }
    if short <= long * NOTHING {
        long + short
    } else if long > HUGE {
        corrected(long / SCALE, short / SCALE) * SCALE
    } else if short < TINY {
        corrected(long * SCALE, short * SCALE) / SCALE
    } else {
        corrected(long, short)
    }
}

/// The same where squares are normal numbers.
#[inline]
fn corrected(long: f64, short: f64) -> f64 {
    let root = (long * long + short * short).sqrt();
    // The rest root² - long² - short², from differences that are exact.
    let rest = if root <= 2.0 * short {
        let beyond = root - short;
        long * (2.0 * beyond - long) + (beyond - 2.0 * (long - short)) * beyond
    } else {
        let beyond = root - long;
        2.0 * beyond * (long - 2.0 * short) + ((4.0 * beyond - short) * short + beyond * beyond)
    };
    root - rest / (2.0 * root)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pseudo-random numbers of all sizes within `decades` powers of ten of 1.
    fn numbers(decades: f64) -> impl Iterator<Item = f64> {
        let mut state = 88_172_645_463_325_252_u64;
        std::iter::from_fn(move || {
            let mut share = || {
                state ^= state << 13;
                state ^= state >> 7;
                state ^= state << 17;
                (state >> 11) as f64 / (1_u64 << 53) as f64
            };
            Some((share() - 0.5) * 10_f64.powf(decades * (2.0 * share() - 1.0)))
        })
    }

    #[test]
    fn it_is_that_of_the_standard_library_to_the_last_place() {
        for decades in [0.5, 3.0, 150.0, 300.0] {
            let pairs = numbers(decades).zip(numbers(decades).skip(1));
            for (x, y) in pairs.take(200_000) {
                let (own, other) = (hypotenuse(x, y), x.hypot(y));
                let apart = own.to_bits().abs_diff(other.to_bits());
                assert!(apart <= 1, "{x:e} {y:e}: {own:e} is not {other:e}");
                if cfg!(all(target_os = "linux", target_env = "gnu", target_arch = "x86_64")) {
                    assert_eq!(apart, 0, "{x:e} {y:e}: glibc 2.35 or later has other bits");
                }
            }
        }
    }

    #[test]
    fn sides_that_are_nothing_infinite_or_no_numbers_are_as_the_standard_has_them() {
        let nan = f64::NAN;
        for (x, y) in [(0.0, 0.0), (-0.0, 3.0), (1e300, -1e300), (5e-324, 5e-324), (3e-200, 4e-200)]
        {
            assert_eq!(hypotenuse(x, y).to_bits(), x.hypot(y).to_bits(), "{x:e} {y:e}");
        }
        assert!(hypotenuse(nan, 1.0).is_nan() && hypotenuse(0.0, nan).is_nan());
        assert!(hypotenuse(nan, f64::NEG_INFINITY).is_infinite());
        assert!(hypotenuse(f64::INFINITY, nan).is_infinite());
        assert!(hypotenuse(1e308, 1.7e308).is_infinite());
    }
}
