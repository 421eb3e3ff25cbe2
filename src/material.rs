//! Elastic constants of one body and of a pair of bodies in contact.

use crate::leaves::{POISSON_RATIO, SHEAR_MODULUS};
use crate::math::real::Real;

/// An isotropic elastic material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Young's modulus, > 0 [Pa].
    pub young_modulus: f64,
    /// Poisson's ratio, 0 to 0.5 [-].
    pub poisson_ratio: f64,
}

impl Material {
    /// Shear modulus [Pa].
    pub fn shear_modulus(&self) -> f64 {
        self.young_modulus / (2.0 * (1.0 + self.poisson_ratio))
    }
}

/// Combined constants of two half-spaces (Kalker 1990, eq. 1.44).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaterialPair<T = f64> {
    /// Contact modulus E*, 1/E* = (1 - ν₁²)/E₁ + (1 - ν₂²)/E₂ [Pa].
    pub contact_modulus: f64,
    /// Shear modulus G, 2/G = 1/G₁ + 1/G₂ [Pa].
    pub shear_modulus: T,
    /// Poisson's ratio ν, 2 ν/G = ν₁/G₁ + ν₂/G₂ [-].
    pub poisson_ratio: T,
    /// What pressure and tractions do to each other, K, 4 K/G = (1 - 2 ν₁)/G₁ - (1 - 2 ν₂)/G₂, the
    /// wheel's first; 0 for like bodies [-].
    pub coupling: f64,
}

impl<T> MaterialPair<T> {
    /// K from which on materials count as unlike: it shifts the creepage of free rolling by a hundredth
    /// of that at which a wheel slides all over [-].
    pub const UNLIKE: f64 = 2e-3;

    /// Whether the bodies are so unlike that pressure and tractions act on each other.
    pub fn is_unlike(&self) -> bool {
        self.coupling.abs() > Self::UNLIKE
    }
}

impl MaterialPair {
    /// The same constants in other numbers, which do not move.
    pub fn fixed<T: Real>(&self) -> MaterialPair<T> {
        let Self { contact_modulus, shear_modulus, poisson_ratio, coupling } = *self;
        MaterialPair {
            contact_modulus,
            shear_modulus: T::known(shear_modulus, SHEAR_MODULUS),
            poisson_ratio: T::known(poisson_ratio, POISSON_RATIO),
            coupling,
        }
    }

    /// The constants of `wheel` on `rail`.
    pub fn new(wheel: Material, rail: Material) -> Self {
        let plane = |m: Material| (1.0 - m.poisson_ratio * m.poisson_ratio) / m.young_modulus;
        let (g1, g2) = (wheel.shear_modulus(), rail.shear_modulus());
        let shear_modulus = 2.0 / (1.0 / g1 + 1.0 / g2);
        Self {
            contact_modulus: 1.0 / (plane(wheel) + plane(rail)),
            shear_modulus,
            poisson_ratio: 0.5
                * shear_modulus
                * (wheel.poisson_ratio / g1 + rail.poisson_ratio / g2),
            coupling: 0.25
                * shear_modulus
                * ((1.0 - 2.0 * wheel.poisson_ratio) / g1 - (1.0 - 2.0 * rail.poisson_ratio) / g2),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn like_bodies_keep_their_constants() {
        let steel = Material { young_modulus: 2.1e11, poisson_ratio: 0.28 };
        let pair = MaterialPair::new(steel, steel);
        approx::assert_relative_eq!(pair.shear_modulus, 82.031_25e9, max_relative = 1e-12);
        approx::assert_relative_eq!(pair.poisson_ratio, 0.28, max_relative = 1e-12);
        approx::assert_relative_eq!(
            pair.contact_modulus,
            pair.shear_modulus / (1.0 - 0.28),
            max_relative = 1e-12
        );
    }
}
