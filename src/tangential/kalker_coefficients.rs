//! Kalker's creepage coefficients c_ij of an ellipse.
//!
//! Source: Kalker's linear theory (On the Rolling Contact of Two Elastic Bodies in the Presence of
//! Dry Friction, Delft 1967; Three-Dimensional Elastic Bodies in Rolling Contact, 1990): full
//! adhesion in steady rolling, the limit of vanishing creepage. Force [N] and moment [N m] on the
//! wheel are
//!
//! ```text
//! Fx = -G c² c11 ξ,  Fy = -G c² (c22 η + c c23 φ),  Mz = -G c³ (c32 η + c c33 φ),  c = sqrt(a b), c32 = -c23
//! ```
//!
//! with the combined shear modulus G [Pa], the semi-axes a along rolling and b across [m], the
//! creepages ξ and η [-] and the spin φ [1/m]. The c_ij have no unit; they depend on a/b and on the
//! combined Poisson ratio ν.
//!
//! Instead of Kalker's printed table a polynomial of ln c_ij in t = ln(a/b) and ν, fitted to
//! coefficients computed from first principles (Galin polynomials of degree 16 to 20) for 0 ≤ ν ≤
//! 0.5 and 0.05 ≤ a/b ≤ 20; greatest error 0.21, 0.13, 0.48, 1.4 % of c11, c22, c23, c33 (0.10,
//! 0.08, 0.18, 0.19 % at ν = 0.28). Beyond, it is carried smoothly into the asymptotes of the strip
//! and of the slender ellipse (Kalker 1990, table E.3).

use std::f64::consts::PI;

use crate::math::dual::Dual;
use crate::math::real::Real;

/// The coefficients of longitudinal and lateral creepage and of spin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KalkerCoefficients<T = f64> {
    /// Longitudinal force for longitudinal creepage [-].
    pub c11: T,
    /// Lateral force for lateral creepage [-].
    pub c22: T,
    /// Lateral force for spin, and with the other sign moment for lateral creepage [-].
    pub c23: T,
    /// Moment for spin [-].
    pub c33: T,
}

/// The coefficients of an ellipse with semi-axis ratio a/b > 0 (a along rolling) and 0 ≤ ν ≤ 0.5.
pub fn kalker_coefficients<T: Real>(axis_ratio: T, poisson_ratio: T) -> KalkerCoefficients<T> {
    let (t, nu) = (axis_ratio.ln(), poisson_ratio.value());
    let [c11, c22, c23, c33] = if T::IS_BACKWARD {
        logarithms(t.value(), Dual::<1>::variable(nu, 0)).map(|[c, by_t]| {
            let by = [(&t, by_t.value), (&poisson_ratio, c.slopes[0])];
            T::combined(c.value, by.into_iter()).exp()
        })
    } else {
        // Poisson's ratio does not move.
        logarithms(t.value(), nu).map(|[c, by_t]| t.chain(c, || by_t).exp())
    };
    KalkerCoefficients { c11, c22, c23, c33 }
}

/// ln c11, ln c22, ln c23, ln c33 at t = ln(a/b), each with its derivative by t.
pub fn logarithms<N: Real>(t: f64, poisson_ratio: N) -> [[N; 2]; 4] {
    // Logarithms far beyond any contact patch keep the asymptotes finite.
    let inside = t.clamp(-MAX_LOG_RATIO, MAX_LOG_RATIO);
    let x = (inside.abs() - FIT_END) / (BLEND_END - FIT_END);
    let share = smooth_step(x);
    if share <= 0.0 {
        return fitted(inside, poisson_ratio);
    }
    let limit =
        if inside < 0.0 { wide(inside, poisson_ratio) } else { slender(inside, poisson_ratio) };
    if share >= 1.0 {
        let slope = if inside.abs() < MAX_LOG_RATIO { 1.0 } else { 0.0 };
        return limit.map(|[c, by_t]| [c, by_t * slope]);
    }
    let share_slope = inside.signum() * smooth_step_slope(x) / (BLEND_END - FIT_END);
    let fit = fitted(inside, poisson_ratio);
    let blend = |k: usize| {
        let ([f, f_slope], [l, l_slope]) = (fit[k], limit[k]);
        [(l - f) * share + f, (l_slope - f_slope) * share + f_slope + (l - f) * share_slope]
    };
    [blend(0), blend(1), blend(2), blend(3)]
}

/// |ln(a/b)| up to which the fit holds: a/b = 20.
const FIT_END: f64 = 2.995_732_273_553_991;
/// |ln(a/b)| from which the asymptotes hold alone: a/b = 45.
const BLEND_END: f64 = 3.806_662_489_770_32;
/// Larger |ln(a/b)| are taken as this one: a/b = 1e6.
const MAX_LOG_RATIO: f64 = 13.815_510_557_964_274;

/// Logarithms of the coefficients by the joint fit, with their derivatives by t.
fn fitted<N: Real>(t: f64, nu: N) -> [[N; 2]; 4] {
    [&FIT_C11, &FIT_C22, &FIT_C23, &FIT_C33].map(|p| {
        let mut value = [N::from(0.0); 2];
        for i in (0..7).rev() {
            let c = nu * (nu * p[2][i] + p[1][i]) + p[0][i];
            value = [value[0] * t + c, value[1] * t + value[0]];
        }
        value
    })
}

/// a/b = g → 0: every strip rolls like a cylinder. Logarithms with their derivatives by t = ln g.
fn wide<N: Real>(t: f64, nu: N) -> [[N; 2]; 4] {
    let spin = nu * (16f64.ln() - t - 5.0) + 1.0;
    let over = |number: f64, times: f64| (N::from(number) / ((-nu + 1.0) * times)).ln();
    [
        [over(PI * PI, 4.0), 0.0.into()],
        [(PI * PI / 4.0).ln().into(), 0.0.into()],
        [over(PI, 3.0) + 0.5 * t + spin.ln(), -(nu / spin) + 0.5],
        [over(PI * PI, 16.0) - t, (-1.0).into()],
    ]
}

/// b/a = g → 0. Logarithms with their derivatives by t = -ln g. For c33 the value where the fit
/// ends: it falls by 5 % up to a/b = 33.
fn slender<N: Real>(t: f64, nu: N) -> [[N; 2]; 4] {
    let log = 16f64.ln() + 2.0 * t;
    let rest = 3.0 - 4f64.ln();
    // ln(2 π e^t/l (1 + r/l)) for l that grows by `rate`
    let force = |l: N, r: N, rate: N| {
        let value = (N::from(2.0 * PI) / l).ln() + t + (r / l + 1.0).ln();
        [value, -(rate / l) + 1.0 - rate * r / (l * (l + r))]
    };
    let plane = -nu + 1.0;
    let spin = plane * log - 2.0 + nu * 4.0;
    [
        force(-(nu * 2.0) + log, rest.into(), 2.0.into()),
        force(plane * log + nu * 2.0, plane * rest, plane * 2.0),
        [(N::from(2.0 * PI) / (spin * 3.0)).ln() + 1.5 * t, -(plane * 2.0 / spin) + 1.5],
        [fitted(FIT_END, nu)[3][0], 0.0.into()],
    ]
}

/// 0 below 0, 1 above 1, twice continuously differentiable.
fn smooth_step(x: f64) -> f64 {
    let x = x.clamp(0.0, 1.0);
    x * x * x * (10.0 + x * (6.0 * x - 15.0))
}

/// Derivative of [`smooth_step`].
fn smooth_step_slope(x: f64) -> f64 {
    let x = x.clamp(0.0, 1.0);
    30.0 * (x * (1.0 - x)).powi(2)
}

/// Rows: powers 0, 1, 2 of ν; columns: powers 0 to 6 of ln(a/b).
#[rustfmt::skip]
const FIT_C11: [[f64; 7]; 3] = [
    [1.222_562_86, 3.000_190_48e-1, 9.521_109_96e-2, 3.479_282_25e-3, -3.254_741_74e-3, -6.586_192_55e-5, 9.814_983_23e-5],
    [6.767_764_86e-1, -1.673_483_11e-1, -1.704_117_29e-2, 1.131_532_45e-2, 1.089_031_58e-3, -4.822_812_40e-4, -3.382_261_39e-5],
    [3.544_268_39e-1, -2.344_640_54e-1, 4.043_161_51e-2, 1.440_085_00e-2, -4.890_560_75e-3, -5.102_234_60e-4, 2.194_859_36e-4],
];
#[rustfmt::skip]
const FIT_C22: [[f64; 7]; 3] = [
    [1.222_537_55, 3.000_493_13e-1, 9.520_459_73e-2, 3.478_535_91e-3, -3.253_790_99e-3, -6.586_973_04e-5, 9.810_548_90e-5],
    [3.005_621_96e-1, 1.847_109_21e-1, 8.279_404_22e-3, -1.252_207_66e-2, -2.605_401_00e-4, 5.220_923_12e-4, 1.309_953_32e-7],
    [3.600_382_71e-2, 8.959_739_99e-2, 2.956_839_55e-2, -2.654_552_91e-3, -1.845_462_08e-3, 6.052_553_80e-5, 5.784_392_08e-5],
];
#[rustfmt::skip]
const FIT_C23: [[f64; 7]; 3] = [
    [2.877_998_15e-1, 7.507_738_72e-1, 9.293_143_14e-2, 6.864_138_65e-3, -3.197_522_96e-3, -2.074_645_13e-4, 9.907_981_75e-5],
    [3.563_132_29e-1, 2.466_557_80e-2, 1.140_336_71e-1, -3.535_750_85e-2, -1.908_726_21e-3, 1.447_422_16e-3, -2.114_402_59e-5],
    [9.541_447_28e-2, -1.065_070_97e-1, 1.557_918_01e-1, -3.962_493_83e-3, -1.845_970_93e-2, 1.322_910_91e-3, 6.778_079_05e-4],
];
#[rustfmt::skip]
const FIT_C33: [[f64; 7]; 3] = [
    [1.886_689_35e-1, -4.295_499_29e-1, 1.472_096_71e-1, -5.745_669_97e-3, -6.280_417_88e-3, 2.471_553_81e-4, 1.974_118_96e-4],
    [-7.283_110_85e-2, -6.153_818_98e-1, 1.350_141_96e-2, 6.715_909_32e-2, 2.504_679_75e-3, -2.875_819_87e-3, -1.326_428_61e-4],
    [-1.974_891_27e-2, -6.245_408_56e-1, -3.005_277_20e-1, -7.886_027_72e-2, 8.348_760_99e-3, 4.132_074_18e-3, -1.477_226_72e-4],
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_fits_meet_the_exact_coefficients_at_a_circle() {
        // ../../tests/data/kalker_coefficients.csv holds the whole set: tests/suite/literature.rs.
        let c = kalker_coefficients(1.0, 0.25);
        approx::assert_relative_eq!(c.c11, 4.1128, max_relative = 2.1e-3);
        approx::assert_relative_eq!(c.c22, 3.6683, max_relative = 1.3e-3);
        approx::assert_relative_eq!(c.c23, 1.4661, max_relative = 4.8e-3);
        approx::assert_relative_eq!(c.c33, 1.1842, max_relative = 1.4e-2);
    }

    #[test]
    fn coefficients_are_positive_and_continuous_over_all_ratios() {
        for nu in [0.0, 0.28, 0.5] {
            let mut before = kalker_coefficients(1e-7, nu);
            for i in 1..=14_000 {
                let now = kalker_coefficients(1e-7 * 10f64.powf(f64::from(i) / 1000.0), nu);
                for (b, n) in [
                    (before.c11, now.c11),
                    (before.c22, now.c22),
                    (before.c23, now.c23),
                    (before.c33, now.c33),
                ] {
                    assert!(n > 0.0 && (n / b - 1.0).abs() < 0.01, "ratio step {i}, {b} to {n}");
                }
                before = now;
            }
        }
    }
    #[test]
    fn slopes_of_the_logarithms_are_those_of_differences() {
        for nu in [0.0, 0.28, 0.5] {
            for t in [-14.5, -6.0, -3.4, -3.1, -2.0, 0.0, 1.3, 3.05, 3.5, 5.0, 14.5] {
                let h = 1e-5;
                let [before, now, after] = [t - h, t, t + h].map(|t| logarithms(t, nu));
                for k in 0..4 {
                    let slope = (after[k][0] - before[k][0]) / (2.0 * h);
                    approx::assert_abs_diff_eq!(now[k][1], slope, epsilon = 1e-8);
                }
            }
        }
    }

    #[test]
    fn slopes_by_poisson_s_ratio_are_those_of_differences() {
        let h = 2e-6;
        for nu in [1e-4, 0.28, 0.4999] {
            for t in [-14.5, -6.0, -3.4, -3.1, -2.0, 0.0, 1.3, 3.05, 3.5, 5.0, 14.5] {
                let now = logarithms(t, Dual::<1>::variable(nu, 0));
                let [before, plain, after] = [nu - h, nu, nu + h].map(|nu| logarithms(t, nu));
                for k in 0..4 {
                    let slope = (after[k][0] - before[k][0]) / (2.0 * h);
                    approx::assert_abs_diff_eq!(now[k][0].slopes[0], slope, epsilon = 1e-8);
                    assert_eq!(now[k].map(|c| c.value.to_bits()), plain[k].map(f64::to_bits));
                }
            }
        }
    }
}
