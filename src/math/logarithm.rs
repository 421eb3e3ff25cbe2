//! A natural logarithm that vectorises.
//!
//! The one of the standard library is a call for each number; this one is plain arithmetic, so that
//! a loop over strips is compiled to vector instructions.

/// Bits of 2^52: an integer put into its low bits makes a float that much larger.
const INTEGER: u64 = 0x4330_0000_0000_0000;
const TWO_TO_52: f64 = 4_503_599_627_370_496.0;
/// Bits of 1/√2, at which a mantissa is taken to the next exponent, and from there to those of 1.
const SPLIT: u64 = 0x3fe6_a09e_667f_3bcd;
const BELOW_ONE: u64 = 0x3ff0_0000_0000_0000 - SPLIT;

/// ln x for finite, normal x > 0, to within 3e-16 (1 + |ln x|).
///
/// x = 2^e m with m between 1/√2 and √2, and ln m = 2 artanh((m - 1)/(m + 1)) by its series.
#[inline]
pub fn ln(x: f64) -> f64 {
    debug_assert!(x.is_normal() && x > 0.0);
    let shifted = x.to_bits() + BELOW_ONE;
    let exponent = f64::from_bits(INTEGER | (shifted >> 52)) - (TWO_TO_52 + 1023.0);
    let m = f64::from_bits((shifted & 0x000f_ffff_ffff_ffff) + SPLIT);
    let f = (m - 1.0) / (m + 1.0);
    let s = f * f;
    let mut series = 1.0 / 19.0;
    for divisor in [17.0, 15.0, 13.0, 11.0, 9.0, 7.0, 5.0, 3.0] {
        series = series * s + 1.0 / divisor;
    }
    exponent * std::f64::consts::LN_2 + 2.0 * f * (1.0 + s * series)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_that_of_the_standard_library_over_all_sizes() {
        for i in -30_000..=30_000 {
            let x = 10f64.powf(f64::from(i) / 100.0) * 1.000_123;
            let error = (ln(x) - x.ln()).abs();
            assert!(error <= 3e-16 * (1.0 + x.ln().abs()), "ln({x}) is off by {error}");
        }
        for x in [1.0, 0.5, 2.0, f64::MIN_POSITIVE, f64::MAX, 0.5f64.sqrt(), 2f64.sqrt()] {
            assert!((ln(x) - x.ln()).abs() <= 3e-16 * (1.0 + x.ln().abs()), "ln({x})");
        }
    }
}
