//! Gradient of displacement beside a strip, in closed form.
//!
//! A band of the surface from its strip's line to the lateral distance e, with tractions constant across it, has at the distance x ahead the kernels
//!
//! ```text
//! F₁ = e/(x r),  F₂ = x e/r³,  F₃ = e²/r³        r² = x² + e²
//! ```
//!
//! of which 1/x - F₁, F₂ and F₃ are smooth functions of x/e over e. They are sums of Lorentz curves, fitted by least squares over 0 ≤ x/e ≤ 200 with the weight 1 + x/e:
//!
//! ```text
//! 1/x - F₁ = Σ A x/(x² + s² e²),  F₂ = Σ B x/(x² + s² e²),  F₃ = Σ D s e/(x² + s² e²),      Σ A = 1, Σ B = 0
//! ```
//!
//! Each of these is the real or the imaginary part of 1/(x + i s e), whose integrals with Chebyshev's weights are exact: for ζ outside of -1 to 1
//!
//! ```text
//! ∫ sqrt(1 - t²) U_k(t)/(ζ - t) dt = π w^(k+1),   w = ζ - sqrt(ζ² - 1),  |w| < 1
//! ```

use crate::math::real::Real;

/// Lorentz curves.
pub(super) const POLES: usize = 5;
/// Their widths s, and the shares A, B and D; errors below 5e-4, 1.4e-4 and 1.3e-4 of one over e.
pub(super) const WIDTHS: [f64; POLES] =
    [0.93101543, 1.42648046, 4.1042894, 16.50500174, 113.66979447];
pub(super) const FIRST: [f64; POLES] = [0.20182817, 0.52584398, 0.19678837, 0.06089513, 0.01464436];
pub(super) const SECOND: [f64; POLES] =
    [1.31754604, -1.03231803, -0.20953971, -0.06102546, -0.01466283];
pub(super) const THIRD: [f64; POLES] =
    [1.41524394, -0.723773878, -0.0510205860, -0.00370781553, -0.000126154472];

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
