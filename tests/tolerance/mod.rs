//! Every tolerance of the integration tests: what it bounds, against what, and why it is as large as it is.

#![allow(dead_code)] // each test crate uses its own part

/// Exact within rounding of a few operations.
pub const ROUNDING: f64 = 1e-12;

/// Hertz model against the closed form: the model is the closed form, its quadrature is not.
pub const HERTZ: f64 = 1e-6;

/// Piotrowski-Kik on a sphere against its closed form sqrt(2 ε) Hertz: quadrature across the zone, polynomials of
/// the elliptic integrals.
pub const PIOTROWSKI_KIK_SPHERE: f64 = 1e-4;

/// Linear limit of FASTSIM against Kalker's coefficients at 20 elements: middle rule along the strips.
pub const FASTSIM_LINEAR: f64 = 5e-3;

/// Full sliding against friction times normal force.
pub const FULL_SLIDING: f64 = 1e-3;

/// Share of the friction limit by which FASTSIM (elliptic bound, blended flexibilities, 20x20) misses CONTACT on 300
/// ellipses, mean and 95 %: the error of the simplified theory itself.
pub const FASTSIM_ELLIPSES: [f64; 2] = [0.022, 0.055];

/// The fits of Kalker's coefficients against the exact ones inside a/b 0.05 to 20, for c11, c22, c23.
pub const KALKER_FIT: [f64; 3] = [2.1e-3, 1.4e-3, 5.0e-3];

/// Piotrowski-Kik on an ellipse of a/b = 5 against Hertz at the same approach: the published differences are given to a
/// tenth of a per cent.
pub const PIOTROWSKI_KIK_SLENDER: f64 = 1e-3;

/// Laws of similarity: the same problem in other units. Roots of zone edges end at 1e-7 m, so that a scaled problem is not
/// solved bit for bit alike.
pub const SIMILARITY: f64 = 1e-9;

/// The same beyond, a/b 0.03 to 0.05 and 20 to 33, where the fits are carried into asymptotes that are themselves a few per cent off.
pub const KALKER_ENDS: [f64; 3] = [2.2e-2, 1.6e-2, 2.1e-2];
