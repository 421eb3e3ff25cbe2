//! A zone under the laws of friction: its coefficients as slip velocity and heat change them, and
//! the stiffness of the bodies as slip does.

use super::flash_temperature::FlashTemperature;
use super::friction_law::FrictionLaw;
use super::own_friction::mean;
use super::rolling::RollingState;
use crate::material::MaterialPair;
use crate::math::real::Real;
use crate::normal::{Strips, Zone};

/// State and elastic constants of a zone as the laws of friction have them.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct UnderLaw<T = f64> {
    /// Its friction is that of the zone as it slips; of strips that have their own the mean over
    /// the load.
    pub state: RollingState<T>,
    /// As soft in shear as what lies between the bodies makes them seem.
    pub material: MaterialPair<T>,
    /// By what slip and heat change the coefficients of tread and gauge face [-].
    pub factors: [T; 2],
    /// Mean rise of temperature over the pressure as if all of the zone slid, where friction
    /// depends on it; otherwise 0 [K].
    pub temperature: T,
}

/// What `of` gives for the laws of tread and gauge face.
fn of_both<P: Real, T: Real>(
    laws: &[FrictionLaw<P>; 2],
    strips: &Strips<T>,
    of: impl Fn(&FrictionLaw<P>) -> T,
) -> [T; 2] {
    let first = of(&laws[0]);
    // Without strips of the gauge face there is one law, and laws that are alike are evaluated
    // once.
    let has_two = !strips.friction.is_empty() && (P::IS_BACKWARD || laws[1] != laws[0]);
    [first, if has_two { of(&laws[1]) } else { first }]
}

impl<T: Real> UnderLaw<T> {
    /// `zone` of `strips` in `state` under the `laws` of tread and gauge face and with the friction
    /// that `heat` leaves, where there are any.
    pub fn of<P: Real + Into<T>>(
        laws: Option<&[FrictionLaw<P>; 2]>,
        heat: Option<&FlashTemperature>,
        zone: &Zone<T>,
        strips: &Strips<T>,
        material: &MaterialPair<T>,
        state: &RollingState<T>,
    ) -> Self {
        let mut factors = [T::from(1.0); 2];
        if let Some(laws) = laws {
            factors = of_both(laws, strips, |law| law.factor(zone, state));
        }
        let mut friction =
            mean(zone, strips, |own| own.under(&factors)).unwrap_or(state.friction * factors[0]);
        let mut temperature = T::from(0.0);
        if let Some(heat) = heat {
            let rise = heat.rise(zone, strips, state);
            let hot = heat.factor(friction, rise);
            friction *= hot;
            factors = factors.map(|f| f * hot);
            temperature = friction * rise;
        }
        let state = RollingState { friction, ..*state };
        let mut found = Self { state, material: *material, factors, temperature };
        if let Some(laws) = laws.filter(|laws| laws.iter().any(FrictionLaw::reduces)) {
            let [first, second] = of_both(laws, strips, |law| law.reduced(zone, material, &state));
            let share = mean(zone, strips, |own| own.gauge_face_share);
            let share = share.unwrap_or(T::from(0.0));
            found.material.shear_modulus *= first + share * (second - first);
        }
        found
    }
}
