//! Complete elliptic integrals of parameter m = k².

use super::real::Real;

/// The complete integrals and two differences of them that would cancel if formed from K and E.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Complete<T = f64> {
    /// First kind, K(m).
    pub first: T,
    /// Second kind, E(m).
    pub second: T,
    /// K(m) - E(m), without cancellation as m goes to zero.
    pub first_minus_second: T,
    /// E(m) - (1 - m) K(m), without cancellation as m goes to zero.
    pub second_minus_reduced_first: T,
}

/// K, E and their differences by the arithmetic-geometric mean, to rounding; 0 ≤ m < 1.
///
/// `complement` is 1 - m, handed over separately so that m close to one loses nothing.
pub fn complete<T: Real>(complement: T) -> Complete<T> {
    debug_assert!(complement > 0.0 && complement <= 1.0);
    let m = -complement + 1.0;
    let (mut a, mut g) = (T::from(1.0), complement.sqrt());
    // E = K (1 - sum), sum = Σ 2^(n-1) c_n², c_0² = m; the terms after the first are kept apart for
    // the difference m - sum.
    let (mut tail, mut power) = (T::from(0.0), 1.0);
    // Quadratic convergence: six steps reach rounding down to complements of 1e-30.
    for _ in 0..8 {
        let c = (a - g) * 0.5;
        let mean = (a + g) * 0.5;
        g = (a * g).sqrt();
        a = mean;
        tail += c * power * c;
        power *= 2.0;
        if c.value().abs() < 1e-9 * a.value() {
            break;
        }
    }
    let first = T::from(std::f64::consts::FRAC_PI_2) / a;
    let sum = m * 0.5 + tail;
    Complete {
        first,
        second: first * (-sum + 1.0),
        first_minus_second: first * sum,
        second_minus_reduced_first: first * (m * 0.5 - tail),
    }
}

/// K(m) - E(m) = regular - ln(1 - m) · logarithmic, split at its logarithmic singularity at m = 1.
///
/// Returns (regular, logarithmic) of the polynomial approximation of Hastings (Abramowitz and
/// Stegun 17.3.34 and 17.3.36), absolute error below 4e-8 for 0 ≤ m ≤ 1; `complement` is 1 - m.
#[inline]
pub fn first_minus_second_split<T: Real>(complement: T) -> (T, T) {
    let c = complement;
    let poly = |p: &[f64; 5]| c * (c * (c * (c * p[4] + p[3]) + p[2]) + p[1]) + p[0];
    (poly(&REGULAR), poly(&LOGARITHMIC))
}

/// Coefficients of K less those of E, regular part.
const REGULAR: [f64; 5] = [
    1.386_294_361_12 - 1.0,
    0.096_663_442_59 - 0.443_251_414_63,
    0.035_900_923_83 - 0.062_606_012_20,
    0.037_425_637_13 - 0.047_573_835_46,
    0.014_511_962_12 - 0.017_365_064_51,
];

/// Coefficients of K less those of E, factor of -ln(1 - m).
const LOGARITHMIC: [f64; 5] = [
    0.5,
    0.124_985_935_97 - 0.249_983_683_10,
    0.068_802_485_76 - 0.092_001_800_37,
    0.033_283_553_46 - 0.040_696_975_26,
    0.004_417_870_12 - 0.005_264_496_39,
];

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn integrals_meet_tabulated_values() {
        // Abramowitz and Stegun, table 17.1, m = 0.5 and 0.9.
        let half = complete(0.5);
        assert_relative_eq!(half.first, 1.854_074_677_301_372, max_relative = 1e-14);
        assert_relative_eq!(half.second, 1.350_643_881_047_675, max_relative = 1e-14);
        let most = complete(0.1);
        assert_relative_eq!(most.first, 2.578_092_113_348_173, max_relative = 1e-13);
        assert_relative_eq!(most.second, 1.104_774_732_704_073, max_relative = 1e-13);
    }

    #[test]
    fn differences_keep_their_digits_as_the_parameter_vanishes() {
        // K - E -> π m / 4 and E - (1 - m) K -> π m / 4.
        let m = 1e-9;
        let c = complete(1.0 - m);
        let limit = std::f64::consts::FRAC_PI_4 * (1.0 - (1.0 - m));
        assert_relative_eq!(c.first_minus_second, limit, max_relative = 1e-8);
        assert_relative_eq!(c.second_minus_reduced_first, limit, max_relative = 1e-8);
    }

    #[test]
    fn split_form_is_within_its_stated_error() {
        for i in 1..=1000 {
            let complement = f64::from(i) / 1000.0;
            let (regular, logarithmic) = first_minus_second_split(complement);
            let exact = complete(complement).first_minus_second;
            assert!((regular - complement.ln() * logarithmic - exact).abs() < 4e-8);
        }
    }
}
