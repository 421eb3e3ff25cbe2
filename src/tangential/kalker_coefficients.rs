//! Kalker's linear creep coefficients of an ellipse.
//!
//! ```text
//! Fx = -G c² c11 ξ,  Fy = -G c² (c22 η + c c23 φ),  Mz = -G c³ (c32 η + c c33 φ),  c = sqrt(a b), c32 = -c23
//! ```
//!
//! Instead of Kalker's printed table a polynomial of ln c in t = ln(a/b) and ν, fitted to coefficients computed from
//! first principles (Galin polynomials of degree 16 to 20) for 0 ≤ ν ≤ 0.5 and 0.05 ≤ a/b ≤ 20; greatest error
//! 0.21, 0.13, 0.48 % of c11, c22, c23 (0.10, 0.08, 0.18 % at ν = 0.28). Beyond, it is carried smoothly into the asymptotes
//! of the strip and of the slender ellipse (Kalker 1990, table E.3).

use std::f64::consts::PI;

/// The coefficients of longitudinal and lateral creepage and of spin on lateral force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KalkerCoefficients {
    /// Longitudinal force for longitudinal creepage.
    pub c11: f64,
    /// Lateral force for lateral creepage.
    pub c22: f64,
    /// Lateral force for spin.
    pub c23: f64,
}

/// The coefficients of an ellipse with semi-axis ratio a/b > 0 (a along rolling) and 0 ≤ ν ≤ 0.5.
#[must_use]
pub fn kalker_coefficients(axis_ratio: f64, poisson_ratio: f64) -> KalkerCoefficients {
    // Logarithms far beyond any contact patch keep the asymptotes finite.
    let t = axis_ratio.ln().clamp(-MOST_LOG_RATIO, MOST_LOG_RATIO);
    let share = smooth_step((t.abs() - FIT_END) / (BLEND_END - FIT_END));
    if share <= 0.0 {
        return fitted(t, poisson_ratio).map_coefficients(f64::exp);
    }
    let asymptote =
        if t < 0.0 { wide(t.exp(), poisson_ratio) } else { slender((-t).exp(), poisson_ratio) };
    if share >= 1.0 {
        return asymptote;
    }
    let fit = fitted(t, poisson_ratio);
    let blend = |fit: f64, limit: f64| ((1.0 - share) * fit + share * limit.ln()).exp();
    KalkerCoefficients {
        c11: blend(fit.c11, asymptote.c11),
        c22: blend(fit.c22, asymptote.c22),
        c23: blend(fit.c23, asymptote.c23),
    }
}

/// |ln(a/b)| up to which the fit holds: a/b = 20.
const FIT_END: f64 = 2.995_732_273_553_991;
/// |ln(a/b)| from which the asymptotes hold alone: a/b = 45.
const BLEND_END: f64 = 3.806_662_489_770_32;
/// Larger |ln(a/b)| are taken as this one: a/b = 1e6.
const MOST_LOG_RATIO: f64 = 13.815_510_557_964_274;

impl KalkerCoefficients {
    fn map_coefficients(self, f: impl Fn(f64) -> f64) -> Self {
        Self { c11: f(self.c11), c22: f(self.c22), c23: f(self.c23) }
    }
}

/// Logarithms of the coefficients by the joint fit.
fn fitted(t: f64, nu: f64) -> KalkerCoefficients {
    let row = |p: &[f64; 7]| p.iter().rev().fold(0.0, |sum, c| sum * t + c);
    let value = |p: &[[f64; 7]; 3]| row(&p[0]) + nu * (row(&p[1]) + nu * row(&p[2]));
    KalkerCoefficients { c11: value(&FIT_C11), c22: value(&FIT_C22), c23: value(&FIT_C23) }
}

/// a/b = g → 0: every strip rolls like a cylinder.
fn wide(g: f64, nu: f64) -> KalkerCoefficients {
    KalkerCoefficients {
        c11: PI * PI / (4.0 * (1.0 - nu)),
        c22: PI * PI / 4.0,
        c23: PI * g.sqrt() / (3.0 * (1.0 - nu)) * (1.0 + nu * ((16.0 / g).ln() - 5.0)),
    }
}

/// b/a = g → 0.
fn slender(g: f64, nu: f64) -> KalkerCoefficients {
    let log = (16.0 / (g * g)).ln();
    let rest = 3.0 - 4f64.ln();
    let lateral = (1.0 - nu) * log + 2.0 * nu;
    KalkerCoefficients {
        c11: 2.0 * PI / ((log - 2.0 * nu) * g) * (1.0 + rest / (log - 2.0 * nu)),
        c22: 2.0 * PI / (g * lateral) * (1.0 + (1.0 - nu) * rest / lateral),
        c23: 2.0 * PI / (3.0 * g.powf(1.5) * ((1.0 - nu) * log - 2.0 + 4.0 * nu)),
    }
}

/// 0 below 0, 1 above 1, twice continuously differentiable.
fn smooth_step(x: f64) -> f64 {
    let x = x.clamp(0.0, 1.0);
    x * x * x * (10.0 + x * (6.0 * x - 15.0))
}

/// Rows: powers 0, 1, 2 of ν; columns: powers 0 to 6 of ln(a/b).
const FIT_C11: [[f64; 7]; 3] = [
    [
        1.222_562_86,
        3.000_190_48e-1,
        9.521_109_96e-2,
        3.479_282_25e-3,
        -3.254_741_74e-3,
        -6.586_192_55e-5,
        9.814_983_23e-5,
    ],
    [
        6.767_764_86e-1,
        -1.673_483_11e-1,
        -1.704_117_29e-2,
        1.131_532_45e-2,
        1.089_031_58e-3,
        -4.822_812_40e-4,
        -3.382_261_39e-5,
    ],
    [
        3.544_268_39e-1,
        -2.344_640_54e-1,
        4.043_161_51e-2,
        1.440_085_00e-2,
        -4.890_560_75e-3,
        -5.102_234_60e-4,
        2.194_859_36e-4,
    ],
];
const FIT_C22: [[f64; 7]; 3] = [
    [
        1.222_537_55,
        3.000_493_13e-1,
        9.520_459_73e-2,
        3.478_535_91e-3,
        -3.253_790_99e-3,
        -6.586_973_04e-5,
        9.810_548_90e-5,
    ],
    [
        3.005_621_96e-1,
        1.847_109_21e-1,
        8.279_404_22e-3,
        -1.252_207_66e-2,
        -2.605_401_00e-4,
        5.220_923_12e-4,
        1.309_953_32e-7,
    ],
    [
        3.600_382_71e-2,
        8.959_739_99e-2,
        2.956_839_55e-2,
        -2.654_552_91e-3,
        -1.845_462_08e-3,
        6.052_553_80e-5,
        5.784_392_08e-5,
    ],
];
const FIT_C23: [[f64; 7]; 3] = [
    [
        2.877_998_15e-1,
        7.507_738_72e-1,
        9.293_143_14e-2,
        6.864_138_65e-3,
        -3.197_522_96e-3,
        -2.074_645_13e-4,
        9.907_981_75e-5,
    ],
    [
        3.563_132_29e-1,
        2.466_557_80e-2,
        1.140_336_71e-1,
        -3.535_750_85e-2,
        -1.908_726_21e-3,
        1.447_422_16e-3,
        -2.114_402_59e-5,
    ],
    [
        9.541_447_28e-2,
        -1.065_070_97e-1,
        1.557_918_01e-1,
        -3.962_493_83e-3,
        -1.845_970_93e-2,
        1.322_910_91e-3,
        6.778_079_05e-4,
    ],
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_fits_meet_the_exact_coefficients_at_a_circle() {
        // ../../tests/data/kalker_coefficients.csv holds the whole set: tests/literature.rs.
        let c = kalker_coefficients(1.0, 0.25);
        approx::assert_relative_eq!(c.c11, 4.1128, max_relative = 2.1e-3);
        approx::assert_relative_eq!(c.c22, 3.6683, max_relative = 1.3e-3);
        approx::assert_relative_eq!(c.c23, 1.4661, max_relative = 4.8e-3);
    }

    #[test]
    fn coefficients_are_positive_and_continuous_over_all_ratios() {
        for nu in [0.0, 0.28, 0.5] {
            let mut before = kalker_coefficients(1e-7, nu);
            for i in 1..=14_000 {
                let now = kalker_coefficients(1e-7 * 10f64.powf(f64::from(i) / 1000.0), nu);
                for (b, n) in [(before.c11, now.c11), (before.c22, now.c22), (before.c23, now.c23)]
                {
                    assert!(n > 0.0 && (n / b - 1.0).abs() < 0.01, "ratio step {i}, {b} to {n}");
                }
                before = now;
            }
        }
    }
}
