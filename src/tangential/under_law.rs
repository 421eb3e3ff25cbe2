//! A zone under the laws of friction: what slip and heat make of its coefficients, and slip of the stiffness of the bodies.

use super::flash_temperature::FlashTemperature;
use super::friction_law::FrictionLaw;
use super::own_friction::mean;
use super::{RollingState, Tangential};
use crate::material::MaterialPair;
use crate::math::real::Real;
use crate::normal::{Strips, Zone};

/// State and elastic constants of a zone as the laws of friction have them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UnderLaw<T = f64> {
    /// Its friction is that of the zone as it slips; of strips that have their own the mean over the load.
    pub state: RollingState<T>,
    /// As soft in shear as what lies between the bodies makes them seem.
    pub material: MaterialPair<T>,
    /// By what slip and heat change the coefficients of tread and gauge face [-].
    pub factors: [T; 2],
}

/// Friction of a zone that slip and heat leave.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrictionLeft<T = f64> {
    /// Coefficient; of strips that have their own the mean over the load [-].
    pub coefficient: T,
    /// By what slip and heat change the coefficients of tread and gauge face [-].
    pub factors: [T; 2],
    /// Mean rise of temperature over the pressure as if all of the zone slid, where friction depends on it; otherwise 0 [K].
    pub temperature: T,
}

impl Tangential {
    /// `zone` of `strips` in `state` under the laws of friction.
    #[must_use]
    pub fn under_law<T: Real>(
        &self,
        zone: &Zone<T>,
        strips: &Strips<T>,
        material: &MaterialPair<T>,
        state: &RollingState<T>,
    ) -> UnderLaw<T> {
        let heat = self.flash_temperature.as_ref();
        UnderLaw::of(self.laws.as_ref(), heat, zone, strips, material, state)
    }

    /// The friction that `zone` of `strips` in `state` has under the laws of friction.
    #[must_use]
    pub fn friction_left<T: Real>(
        &self,
        zone: &Zone<T>,
        strips: &Strips<T>,
        state: &RollingState<T>,
    ) -> FrictionLeft<T> {
        let heat = self.flash_temperature.as_ref();
        FrictionLeft::of(self.laws.as_ref(), heat, zone, strips, state)
    }
}

/// What `of` gives for the laws of tread and gauge face.
fn of_both<P: Real, T: Real>(
    laws: &[FrictionLaw<P>; 2],
    strips: &Strips<T>,
    of: impl Fn(&FrictionLaw<P>) -> T,
) -> [T; 2] {
    let first = of(&laws[0]);
    // Without strips of the gauge face there is one law, and laws that are alike are evaluated once.
    let has_two = !strips.friction.is_empty() && laws[1] != laws[0];
    [first, if has_two { of(&laws[1]) } else { first }]
}

impl<T: Real> FrictionLeft<T> {
    fn of<P: Real + Into<T>>(
        laws: Option<&[FrictionLaw<P>; 2]>,
        heat: Option<&FlashTemperature>,
        zone: &Zone<T>,
        strips: &Strips<T>,
        state: &RollingState<T>,
    ) -> Self {
        let mut factors = [T::from(1.0); 2];
        if let Some(laws) = laws {
            factors = of_both(laws, strips, |law| law.factor(zone, state));
        }
        let coefficient =
            mean(zone, strips, |own| own.under(&factors)).unwrap_or(state.friction * factors[0]);
        let Some(heat) = heat else {
            return Self { coefficient, factors, temperature: T::from(0.0) };
        };
        let rise = heat.rise(zone, strips, state);
        let hot = heat.factor(coefficient, rise);
        let coefficient = coefficient * hot;
        Self { coefficient, factors: factors.map(|f| f * hot), temperature: coefficient * rise }
    }
}

impl<T: Real> UnderLaw<T> {
    /// `zone` of `strips` in `state` under the `laws` of tread and gauge face and with the friction that `heat` leaves, where there are any.
    #[must_use]
    pub fn of<P: Real + Into<T>>(
        laws: Option<&[FrictionLaw<P>; 2]>,
        heat: Option<&FlashTemperature>,
        zone: &Zone<T>,
        strips: &Strips<T>,
        material: &MaterialPair<T>,
        state: &RollingState<T>,
    ) -> Self {
        let left = FrictionLeft::of(laws, heat, zone, strips, state);
        let FrictionLeft { coefficient, factors, .. } = left;
        let state = RollingState { friction: coefficient, ..*state };
        let mut found = Self { state, material: *material, factors };
        if let Some(laws) = laws.filter(|laws| laws.iter().any(FrictionLaw::reduces)) {
            let [first, second] = of_both(laws, strips, |law| law.reduced(zone, material, &state));
            let share = mean(zone, strips, |own| own.gauge_face_share);
            let share = share.unwrap_or(T::from(0.0));
            found.material.shear_modulus *= first + share * (second - first);
        }
        found
    }
}
