//! Friction that falls with the temperature of the patch.
//!
//! What slides is a source of heat, μ p s for each area, that passes fast over both bodies, which
//! share it alike. Strip by strip, along rolling, with the distance u from the leading edge in
//! units of the half length a and the pressure q sqrt(u (2 - u)) (Ertz and Knothe, Wear 253 (2002)
//! 498-508; the heat does not spread ahead or sideways in the time of the passage)
//!
//! ```text
//! ϑ(u) = μ q s sqrt(a) J(u)/(2 β sqrt(π V)),   J(u) = ∫ sqrt(v (2 - v))/sqrt(u - v) dv from 0 to u,   β = sqrt(λ c)
//! ```
//!
//! λ the conductivity, c the heat capacity for each volume. Its greatest value is 1.235 μ q s
//! sqrt(a/V)/(2 β), where J is greatest; what friction falls with is its mean over the pressure of
//! the strips, with J = 1.572. s is the slip velocity of the laws of slip, one number for each
//! zone. Friction falls linearly from the rise ϑ₁ on over Δϑ, to the share σ:
//!
//! ```text
//! μ = μ₀ h,   h = 1 - (1 - σ) (ϑ - ϑ₁)/Δϑ within σ and 1
//! ```
//!
//! As the rise goes with friction itself, h is the solution of a linear equation.

use std::f64::consts::PI;

use super::RollingState;
use super::friction_law::slip_velocity;
use crate::defaults::with_defaults;
use crate::math::real::Real;
use crate::normal::{Strips, Zone};

/// Mean of J over a semi-elliptical pressure.
const MEAN: f64 = 1.572_023_357;

with_defaults! {
    /// How friction falls with the temperature that sliding makes. By default it is off, and the
    /// bodies are of steel with 7850 kg/m³, 450 J/(kg K) and 50 W/(m K).
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct FlashTemperature {
        /// σ: friction of a hot patch over that of a cold one, 0 to 1; 1 is off [-].
        pub share: f64 = 1.0,
        /// ϑ₁: rise above the temperature of the bodies from which on friction falls, ≥ 0 [K].
        pub onset: f64 = 0.0,
        /// Δϑ: further rise over which it does, > 0 [K].
        pub range: f64 = 400.0,
        /// λ: conductivity of both bodies, > 0 [W/(m K)].
        pub conductivity: f64 = 50.0,
        /// c: heat capacity for each volume of both bodies, > 0 [J/(m³ K)].
        pub heat_capacity: f64 = 3.5325e6,
    }
}

impl FlashTemperature {
    /// Whether friction depends on temperature.
    pub fn is_on(&self) -> bool {
        self.share < 1.0
    }

    /// Mean rise of temperature over the pressure of `zone` in `state`, for a coefficient of
    /// friction of one [K].
    pub fn rise<T: Real>(&self, zone: &Zone<T>, strips: &Strips<T>, state: &RollingState<T>) -> T {
        let speed = slip_velocity(zone, state);
        if speed <= 0.0 || zone.load <= 0.0 {
            return T::from(0.0);
        }
        let (mut load, mut sum) = (T::from(0.0), T::from(0.0));
        for j in zone.range() {
            let (pressure, half_length) = (strips.pressure[j], strips.half_length[j]);
            let weight = strips.weight(j);
            load += weight;
            sum += weight * pressure * half_length.sqrt();
        }
        let spread = 2.0 * (self.conductivity * self.heat_capacity * PI).sqrt();
        state.load_factor * speed * (sum / load) * MEAN / (state.speed.sqrt() * spread)
    }

    /// Friction over that of a cold patch, h, for a cold coefficient of `friction` and the `rise`
    /// of one [-].
    pub fn factor<T: Real>(&self, friction: T, rise: T) -> T {
        let slope = (1.0 - self.share) / self.range;
        let linear = T::from(1.0 + slope * self.onset) / (friction * rise * slope + 1.0);
        linear.within(self.share, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::normal::LoadedStrip;
    use crate::tangential::Creepage;
    use approx::assert_relative_eq;

    const HOT: FlashTemperature = FlashTemperature {
        share: 0.4,
        onset: 50.0,
        range: 300.0,
        conductivity: 50.0,
        heat_capacity: 3.5325e6,
    };

    /// One strip of 1 GPa and 5 mm half length that slides by a tenth at 20 m/s.
    fn strip() -> (Zone, Strips, RollingState) {
        let mut strips = Strips::with_capacity(1, 1);
        let (width, half_length, pressure) = (1e-3, 5e-3, 1e9);
        strips.push(LoadedStrip { width, half_length, pressure, ..LoadedStrip::default() });
        let state = RollingState {
            creepage: Creepage { longitudinal: 0.1, lateral: 0.0, spin: 0.0 },
            forward_share: 1.0,
            friction: 0.3,
            load_factor: 1.0,
            speed: 20.0,
        };
        (Zone { count: 1, load: 1.0, ..Zone::default() }, strips, state)
    }

    #[test]
    fn the_mean_rise_is_that_of_a_source_that_passes_over_the_bodies() {
        // Sums over the passage: with v = u sin² the integrand has no pole.
        let rise = |u: f64| {
            let n = 400;
            let step = 0.5 * PI / f64::from(n);
            let sum = (0..n).map(|i| {
                let (sine, _) = ((f64::from(i) + 0.5) * step).sin_cos();
                2.0 * u * sine * sine * (2.0 - u * sine * sine).sqrt()
            });
            sum.sum::<f64>() * step
        };
        let n = 400;
        let (mut mean, mut weights, mut greatest) = (0.0, 0.0, 0.0_f64);
        for i in 0..n {
            let (sine, cosine) = ((f64::from(i) + 0.5) * PI / f64::from(n)).sin_cos();
            mean += sine * sine * rise(1.0 - cosine);
            weights += sine * sine;
            greatest = greatest.max(rise(1.0 - cosine));
        }
        assert_relative_eq!(mean / weights, MEAN, max_relative = 1e-5);
        assert_relative_eq!(greatest / PI.sqrt(), 1.235, max_relative = 1e-3);
        let (zone, strips, state) = strip();
        let effusivity = (50.0_f64 * 3.5325e6).sqrt();
        let expected = 1e9 * 2.0 * 5e-3_f64.sqrt() * MEAN / (2.0 * effusivity * (PI * 20.0).sqrt());
        assert_relative_eq!(HOT.rise(&zone, &strips, &state), expected, max_relative = 1e-12);
    }

    #[test]
    fn friction_falls_with_the_temperature_that_is_left() {
        let (zone, strips, state) = strip();
        let rise = HOT.rise(&zone, &strips, &state);
        for (friction, share) in [(1e-4, 1.0), (100.0, 0.4)] {
            assert_relative_eq!(HOT.factor(friction, rise), share);
        }
        let friction = 150.0 / rise;
        let found = HOT.factor(friction, rise);
        let left = found * friction * rise;
        assert_relative_eq!(found, 1.0 - 0.6 * (left - 50.0) / 300.0, max_relative = 1e-12);
        assert!(found > 0.4 && found < 1.0);
    }

    #[test]
    fn what_does_not_slide_stays_cold() {
        let (zone, strips, state) = strip();
        let still = RollingState { creepage: Creepage::default(), speed: 0.0, ..state };
        assert_relative_eq!(HOT.factor(0.3, HOT.rise(&zone, &strips, &still)), 1.0);
        assert!(!FlashTemperature::default().is_on());
    }
}
