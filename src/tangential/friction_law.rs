//! Friction that falls with the sliding speed, and creep forces that grow more slowly on contaminated rails.
//!
//! Falling friction (Polach, Wear 258 (2005) 992-1000), with the sliding speed s of the rigid slip, its root mean square over the pressure of
//! an ellipse of the zone's length L and width W, so that spin counts too (the source has no spin in it):
//!
//! ```text
//! μ = μ₀ ((1 - A) exp(-B s) + A),      s² = V² (ξ² + η² + φ² (L² + W²)/20)
//! ```
//!
//! Reduced initial slope (Spiryagin, Polach and Cole, Vehicle System Dynamics 51 (2013) 1653-1671), here of all models: a layer between the
//! bodies makes them seem softer in shear, G k for G,
//!
//! ```text
//! k = k₀ (α + (1 - α)/(1 + β ε)),      ε = G π a b k₀ c11 sqrt(ξ² + η²)/(4 μ N)
//! ```
//!
//! with the ellipse of the zone's length to width and area. Departure: the source puts η + φ a for η where that is greater; spin is left out.
//!
//! Both are one number for each zone. A = 1 or B = 0 is constant friction, k₀ = α = 1 clean rails, and neither costs anything then.

use std::f64::consts::PI;

use super::RollingState;
use super::kalker_coefficients::kalker_coefficients;
use crate::material::MaterialPair;
use crate::math::real::Real;
use crate::normal::Zone;

/// How friction and initial slope depend on the creepage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrictionLaw {
    /// A: friction at infinite sliding speed over that without sliding, 0 to 1 [-].
    pub falling_share: f64,
    /// B: decay with the sliding speed, ≥ 0 [s/m].
    pub falling_decay: f64,
    /// k₀: initial slope over that of clean bodies, above 0 to 1 [-].
    pub reduction: f64,
    /// α: what is left of k₀ at great creepages, 0 to 1 [-].
    pub reduction_share: f64,
    /// β: decay from the one to the other with the creepage over that of saturation, ≥ 0 [-].
    pub reduction_decay: f64,
}

impl Default for FrictionLaw {
    fn default() -> Self {
        Self {
            falling_share: 1.0,
            falling_decay: 0.0,
            reduction: 1.0,
            reduction_share: 1.0,
            reduction_decay: 0.0,
        }
    }
}

/// Least shear modulus over that of the bodies: creepages stay finite.
const LEAST_REDUCTION: f64 = 1e-9;

impl FrictionLaw {
    fn falls(&self) -> bool {
        self.falling_share < 1.0 && self.falling_decay > 0.0
    }

    fn reduces(&self) -> bool {
        self.reduction < 1.0 || (self.reduction_share < 1.0 && self.reduction_decay > 0.0)
    }

    /// Whether friction is anything but one coefficient on clean bodies.
    #[must_use]
    pub fn is_on(&self) -> bool {
        self.falls() || self.reduces()
    }

    /// Coefficient of friction and elastic constants for `zone` in `state`.
    #[must_use]
    pub fn applied<T: Real>(
        &self,
        zone: &Zone<T>,
        material: &MaterialPair<T>,
        state: &RollingState<T>,
    ) -> (T, MaterialPair<T>) {
        let slip = state.creepage.longitudinal.hypot(state.creepage.lateral);
        let mut friction = state.friction;
        if self.falls() {
            let spin = state.creepage.spin * 0.05f64.sqrt() * zone.length.hypot(zone.width);
            let speed = state.speed * slip.hypot(spin);
            let left = self.falling_share;
            friction *= (speed * -self.falling_decay).exp() * (1.0 - left) + left;
        }
        let mut material = *material;
        if self.reduces() {
            let share = self.reduction_share;
            let c11 = kalker_coefficients(zone.length / zone.width, material.poisson_ratio).c11;
            let ab = zone.area / PI;
            let stiffness = material.shear_modulus * PI * ab * self.reduction * c11;
            let limit = friction * 4.0 * zone.load * state.load_factor;
            // Without friction any creepage is great.
            let over = if slip > 0.0 { stiffness * slip / limit } else { T::from(0.0) };
            let left = T::from(1.0 - share) / (over * self.reduction_decay + 1.0);
            let k = (left + share) * self.reduction;
            material.shear_modulus *= k.at_least(LEAST_REDUCTION);
        }
        (friction, material)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::Material;
    use crate::tangential::Creepage;
    use approx::assert_relative_eq;

    fn zone() -> Zone {
        Zone { load: 1e5, length: 0.012, width: 0.01, area: 9.4e-5, ..Zone::default() }
    }

    fn state(longitudinal: f64) -> RollingState {
        RollingState {
            creepage: Creepage { longitudinal, lateral: 0.0, spin: 0.0 },
            forward_share: 1.0,
            friction: 0.36,
            load_factor: 1.0,
            speed: 10.0,
        }
    }

    fn steel() -> MaterialPair {
        let steel = Material { young_modulus: 2.1e11, poisson_ratio: 0.28 };
        MaterialPair::new(steel, steel)
    }

    #[test]
    fn friction_falls_from_its_static_value_to_its_share() {
        let law = FrictionLaw { falling_share: 0.38, falling_decay: 0.7, ..FrictionLaw::default() };
        let friction = |creepage: f64| law.applied(&zone(), &steel(), &state(creepage)).0;
        assert_relative_eq!(friction(0.0), 0.36);
        // Half of what falls is gone at s = ln 2/B.
        assert_relative_eq!(friction(0.1 * 2f64.ln() / 0.7), 0.36 * 0.69, max_relative = 1e-12);
        assert_relative_eq!(friction(100.0), 0.36 * 0.38, max_relative = 1e-12);
    }

    #[test]
    fn the_slope_falls_from_its_initial_value() {
        let law = FrictionLaw {
            reduction: 0.54,
            reduction_share: 0.02,
            reduction_decay: 0.64,
            ..FrictionLaw::default()
        };
        let share = |creepage: f64| {
            let material = law.applied(&zone(), &steel(), &state(creepage)).1;
            material.shear_modulus / steel().shear_modulus
        };
        assert_relative_eq!(share(0.0), 0.54, max_relative = 1e-12);
        assert!(share(1e-3) < 0.53 && share(1e-3) > 0.2);
        assert_relative_eq!(share(1e6), 0.54 * 0.02, max_relative = 1e-3);
    }

    #[test]
    fn constant_friction_on_clean_rails_is_off() {
        assert!(!FrictionLaw::default().is_on());
        let half = FrictionLaw { falling_share: 0.4, ..FrictionLaw::default() };
        assert!(!half.is_on(), "without decay nothing falls");
    }
}
