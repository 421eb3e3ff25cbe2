//! Linear theory on the true patch: full adhesion, no bound.
//!
//! Piotrowski and Kik 2008, eqs 19 to 22, integrated over the strips with one flexibility for each
//! creepage. It is what FASTSIM gives as friction goes to infinity. **There is no saturation**: the
//! force grows with the creepage without end, whatever the coefficient of friction is. It is for
//! stability analyses around small creepages and for checks, not for wheels that slip: with half
//! the linear force at the friction limit it is a fifth too large already.
//!
//! With t along x from the centre of a strip of half length a, forward rolling
//!
//! ```text
//! p_x = -(a - t) A,  p_y = -((a - t) B + (a² - t²) C/2)           A, B, C: longitudinal, lateral, twist of the growth
//! F_x = -2 a² A,  F_y = -2 a² B - (2/3) a³ C,  M = ∫ t p_y dt = (2/3) a³ B      for each width
//! ```

use super::flexibility::ZoneFlexibility;
use super::rule::Rule;
use super::{LoadedZone, Rolling, StripForce};
use crate::math::real::Real;

/// Full adhesion, without friction.
#[derive(Clone, Copy, Debug)]
pub struct Linear;

impl<T: Real> Rule<T> for Linear {
    const IS_BOUNDED: bool = false;

    fn strip_forces(
        &self,
        loaded: &LoadedZone<'_, T>,
        rolling: Rolling,
        three: &ZoneFlexibility<T>,
        _: &ZoneFlexibility<T>,
        mut each: impl FnMut(usize, StripForce<T>),
    ) {
        let &LoadedZone { zone, strips, slip, .. } = loaded;
        for j in zone.range() {
            let a = strips.half_length[j];
            let growth = slip.growth(j, three);
            let square = strips.width[j] * 2.0 * a * a;
            // Backwards the strip is the same seen in a mirror along x.
            let cube = square * rolling.direction() * a / 3.0;
            each(
                j,
                StripForce {
                    longitudinal: -square * growth.longitudinal,
                    lateral: -square * growth.lateral - cube * growth.twist,
                    moment: cube * growth.lateral,
                    slip_area: T::from(0.0),
                },
            );
        }
    }
}
