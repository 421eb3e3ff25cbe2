//! A zone under the laws of friction: what slip and heat make of its coefficients, and slip of the stiffness of the bodies.

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
        let one = T::from(1.0);
        let mut found = UnderLaw { state: *state, material: *material, factors: [one; 2] };
        let has_own = !strips.friction.is_empty();
        let of_both = |laws: &[FrictionLaw; 2], of: &dyn Fn(&FrictionLaw) -> T| {
            let first = of(&laws[0]);
            // Laws that are alike are evaluated once.
            [first, if has_own && laws[1] != laws[0] { of(&laws[1]) } else { first }]
        };
        if let Some(laws) = &self.laws {
            found.factors = of_both(laws, &|law| law.factor(zone, state));
        } else if !has_own && self.flash_temperature.is_none() {
            return found;
        }
        found.state.friction = mean(zone, strips, |own| own.under(&found.factors))
            .unwrap_or(state.friction * found.factors[0]);
        if let Some(heat) = &self.flash_temperature {
            let hot = heat.factor(found.state.friction, heat.rise(zone, strips, state));
            found.factors = found.factors.map(|factor| factor * hot);
            found.state.friction *= hot;
        }
        if let Some(laws) = self.laws.as_ref().filter(|laws| laws.iter().any(FrictionLaw::reduces))
        {
            let [first, second] = of_both(laws, &|law| law.reduced(zone, material, &found.state));
            let share = mean(zone, strips, |own| own.gauge_face_share);
            let share = share.unwrap_or(T::from(0.0));
            found.material.shear_modulus *= first + share * (second - first);
        }
        found
    }
}
