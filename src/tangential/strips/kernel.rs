//! Gradient of displacement beside a strip, in closed form.
//!
//! A band of the surface from its strip's line to the lateral distance e, with tractions constant
//! across it, has at the distance x ahead the kernels
//!
//! ```text
//! F₁ = e/(x r),  F₂ = x e/r³,  F₃ = e²/r³        r² = x² + e²
//! ```
//!
//! of which 1/x - F₁, F₂ and F₃ are smooth functions of x/e over e. They are sums of Lorentz
//! curves, fitted by least squares over 0 ≤ x/e ≤ 200 with the weight 1 + x/e:
//!
//! ```text
//! 1/x - F₁ = Σ A x/(x² + s² e²),  F₂ = Σ B x/(x² + s² e²),  F₃ = Σ D s e/(x² + s² e²),      Σ A = 1, Σ B = 0
//! ```
//!
//! Each of these is the real or the imaginary part of 1/(x + i s e), whose integrals with
//! Chebyshev's weights are exact: for ζ outside of -1 to 1
//!
//! ```text
//! ∫ sqrt(1 - t²) U_k(t)/(ζ - t) dt = π w^(k+1),   w = ζ - sqrt(ζ² - 1),  |w| < 1
//! ```

use crate::math::real::Real;

/// Lorentz curves.
pub(super) const POLES: usize = 5;
/// Their widths s, and the shares A, B and D; errors below 5e-4, 1.4e-4 and 1.3e-4 of one over e.
pub(super) const WIDTHS: [f64; POLES] =
    [0.931_015_43, 1.426_480_46, 4.104_289_4, 16.505_001_74, 113.669_794_47];
pub(super) const FIRST: [f64; POLES] =
    [0.201_828_17, 0.525_843_98, 0.196_788_37, 0.060_895_13, 0.014_644_35];
pub(super) const SECOND: [f64; POLES] =
    [1.317_546_04, -1.032_318_03, -0.209_539_71, -0.061_025_46, -0.014_662_84];
pub(super) const THIRD: [f64; POLES] =
    [1.415_243_94, -0.723_773_88, -0.051_020_59, -0.003_707_82, -0.000_126_15];

/// w of ζ = x + i y, y ≥ 0.
#[allow(clippy::inline_always)]
#[inline(always)]
pub(super) fn inside<T: Real>(x: T, y: T) -> [T; 2] {
    let (p, q) = (x * x - y * y - 1.0, x * y * 2.0);
    let larger = (((p * p + q * q).sqrt() + p.abs()) * 0.5).sqrt().at_least(f64::MIN_POSITIVE);
    let other = q.abs() * 0.5 / larger;
    let (real, imaginary) = if p >= 0.0 { (larger, other) } else { (other, larger) };
    let real = if x >= 0.0 { real } else { -real };
    // ζ - sqrt(ζ² - 1) = 1/(ζ + sqrt(ζ² - 1)), without cancellation far away.
    let (a, b) = (x + real, y + imaginary);
    let inverse = T::from(1.0) / (a * a + b * b);
    [a * inverse, -(b * inverse)]
}
