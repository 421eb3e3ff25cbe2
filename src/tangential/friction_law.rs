//! Friction that falls with the slip velocity, and creep forces that grow more slowly on
//! contaminated rails.
//!
//! Falling friction: the coefficient goes from μ₀ without slip to μ_∞ at infinite slip velocity,
//! A = μ_∞/μ₀ [-], at a rate B [s/m]. The slip velocity s [m/s] is the root mean square of the
//! rigid slip over the pressure of an ellipse of the zone's length L and width W [m], so that spin
//! counts too (the sources have no spin in it):
//!
//! ```text
//! μ = μ₀ ((1 - A) f(B s) + A),      s² = V² (ξ² + η² + φ² (L² + W²)/20)
//!
//! exponential   f(x) = exp(-x)          Polach, Wear 258 (2005) 992-1000
//! rational      f(x) = 1/(1 + x)        Kalker, Three-dimensional elastic bodies in rolling contact (1990)
//! linear        f(x) = max(1 - x, 0)
//! ```
//!
//! All begin with the slope dμ/ds = -μ₀ (1 - A) B. V is the reference speed of the creepages.
//!
//! Reduced initial slope (Spiryagin, Polach and Cole, Vehicle System Dynamics 51 (2013) 1653-1671),
//! here of all models: a layer between the bodies makes them seem softer in shear, G k for G,
//!
//! ```text
//! k = k₀ (α + (1 - α)/(1 + β ε)),      ε = G π a b k₀ c11 sqrt(ξ² + η²)/(4 μ N)
//! ```
//!
//! with k₀ the reduction at vanishing creepage, α the share of it that stays at large creepage, β
//! its decay [-], and the ellipse of the zone's length to width and area. Departure: the source
//! puts η + φ a for η where that is greater; spin is left out.
//!
//! Kalker's reduction is α = 1: the slope is k₀ times that of clean bodies, whatever the creepage.
//!
//! Both are one number for each zone and law; a strip between tread and gauge face has a share of
//! each. A = 1 or B = 0 is constant friction, k₀ = α = 1 clean rails, and neither costs anything
//! then.

use std::f64::consts::PI;

use super::RollingState;
use super::kalker_coefficients::kalker_coefficients;
use crate::defaults::with_defaults;
use crate::leaves;
use crate::material::MaterialPair;
use crate::math::real::Real;
use crate::normal::Zone;

/// How friction falls with the slip velocity.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum FallingLaw {
    /// exp(-x) is left of what falls, x = decay · speed.
    #[default]
    Exponential,
    /// 1/(1 + x).
    Rational,
    /// 1 - x, down to 0.
    Linear,
}

with_defaults! {
    /// How friction and initial slope depend on the creepage.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct FrictionLaw<P = f64> {
        /// How friction falls.
        pub falling_law: FallingLaw = FallingLaw::Exponential,
        /// A: friction at infinite slip velocity over that without sliding, 0 to 1 [-].
        pub falling_share: P = 1.0,
        /// B: decay with the slip velocity, ≥ 0 [s/m].
        pub falling_decay: P = 0.0,
        /// k₀: initial slope over that of clean bodies, above 0 to 1 [-].
        pub reduction: P = 1.0,
        /// α: what is left of k₀ at great creepages, 0 to 1 [-].
        pub reduction_share: P = 1.0,
        /// β: decay from the one to the other with the creepage over that of saturation, ≥ 0 [-].
        pub reduction_decay: P = 0.0,
    }
}

/// Least shear modulus over that of the bodies: creepages stay finite.
const MIN_REDUCTION: f64 = 1e-9;

impl FrictionLaw {
    /// The same in other numbers, as that of the tread (0) or of the gauge face (1).
    pub(super) fn known<T: Real>(&self, which: usize) -> FrictionLaw<T> {
        let number = |value: f64, n: u32| T::known(value, leaves::of_law(which, n));
        FrictionLaw {
            falling_law: self.falling_law,
            falling_share: number(self.falling_share, 0),
            falling_decay: number(self.falling_decay, 1),
            reduction: number(self.reduction, 2),
            reduction_share: number(self.reduction_share, 3),
            reduction_decay: number(self.reduction_decay, 4),
        }
    }
}

impl<P: Real> FrictionLaw<P> {
    fn falls(&self) -> bool {
        self.falling_share < 1.0 && self.falling_decay > 0.0
    }

    pub(super) fn reduces(&self) -> bool {
        self.reduction < 1.0 || (self.reduction_share < 1.0 && self.reduction_decay > 0.0)
    }

    /// Whether friction is anything but one coefficient on clean bodies.
    pub fn is_on(&self) -> bool {
        self.falls() || self.reduces()
    }

    /// Friction of `zone` in `state` over that without sliding [-].
    pub fn factor<T: Real>(&self, zone: &Zone<T>, state: &RollingState<T>) -> T
    where
        P: Into<T>,
    {
        if !self.falls() {
            return T::from(1.0);
        }
        let speed = slip_velocity(zone, state);
        let (share, decay): (T, T) = (self.falling_share.into(), self.falling_decay.into());
        let left = match self.falling_law {
            FallingLaw::Exponential => (speed * -decay).exp(),
            FallingLaw::Rational => T::from(1.0) / (speed * decay + 1.0),
            FallingLaw::Linear => (speed * -decay + 1.0).at_least(0.0),
        };
        left * (-share + 1.0) + share
    }

    /// Shear modulus over that of clean bodies for `zone` in `state`, whose friction is that of its
    /// slip [-].
    pub fn reduced<T: Real>(
        &self,
        zone: &Zone<T>,
        material: &MaterialPair<T>,
        state: &RollingState<T>,
    ) -> T
    where
        P: Into<T>,
    {
        if !self.reduces() {
            return T::from(1.0);
        }
        let slip = state.creepage.longitudinal.hypotenuse(state.creepage.lateral);
        let (k0, share, decay): (T, T, T) =
            (self.reduction.into(), self.reduction_share.into(), self.reduction_decay.into());
        let c11 = kalker_coefficients(zone.length / zone.width, material.poisson_ratio).c11;
        let ab = zone.area / PI;
        let stiffness = material.shear_modulus * PI * ab * k0 * c11;
        let limit = state.friction * 4.0 * zone.load * state.load_factor;
        // Without friction any creepage is great.
        let over = if slip > 0.0 { stiffness * slip / limit } else { T::from(0.0) };
        let left = (-share + 1.0) / (over * decay + 1.0);
        let k = (left + share) * k0;
        k.at_least(MIN_REDUCTION)
    }
}

/// Slip velocity s of the rigid slip of `zone` in `state` [m/s].
pub(super) fn slip_velocity<T: Real>(zone: &Zone<T>, state: &RollingState<T>) -> T {
    let slip = state.creepage.longitudinal.hypotenuse(state.creepage.lateral);
    let spin = state.creepage.spin * 0.05f64.sqrt() * zone.length.hypotenuse(zone.width);
    state.speed * slip.hypotenuse(spin)
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
        let friction = |creepage: f64| 0.36 * law.factor(&zone(), &state(creepage));
        assert_relative_eq!(friction(0.0), 0.36);
        // Half of what falls is gone at s = ln 2/B.
        assert_relative_eq!(friction(0.1 * 2f64.ln() / 0.7), 0.36 * 0.69, max_relative = 1e-12);
        assert_relative_eq!(friction(100.0), 0.36 * 0.38, max_relative = 1e-12);
    }

    #[test]
    fn all_laws_begin_with_the_same_slope_and_end_at_their_share() {
        for falling_law in [FallingLaw::Exponential, FallingLaw::Rational, FallingLaw::Linear] {
            let law = FrictionLaw {
                falling_law,
                falling_share: 0.4,
                falling_decay: 0.5,
                ..FrictionLaw::default()
            };
            let factor = |creepage: f64| law.factor(&zone(), &state(creepage));
            let step = 1e-8;
            let slope = (factor(step) - 1.0) / (10.0 * step);
            assert_relative_eq!(slope, -0.6 * 0.5, max_relative = 1e-6);
            assert_relative_eq!(factor(1e9), 0.4, max_relative = 1e-9);
        }
        let linear = FrictionLaw {
            falling_law: FallingLaw::Linear,
            falling_share: 0.4,
            falling_decay: 0.5,
            ..FrictionLaw::default()
        };
        // At 2 m/s nothing is left of what falls.
        assert_relative_eq!(linear.factor(&zone(), &state(0.1)), 0.7, max_relative = 1e-12);
        assert_relative_eq!(linear.factor(&zone(), &state(0.2)), 0.4, max_relative = 1e-12);
    }

    #[test]
    fn the_slope_falls_from_its_initial_value() {
        let law = FrictionLaw {
            reduction: 0.54,
            reduction_share: 0.02,
            reduction_decay: 0.64,
            ..FrictionLaw::default()
        };
        let share = |creepage: f64| law.reduced(&zone(), &steel(), &state(creepage));
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
