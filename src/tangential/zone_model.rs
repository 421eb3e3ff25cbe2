//! What every tangential model does: from a loaded zone that rolls to forces on its strips.

use super::convergence::Convergence;
use super::forces::StripForce;
use super::loaded_zone::LoadedZone;
use super::rigid_slip::RigidSlip;
use super::rolling::{Rolling, RollingState};
use super::under_law::UnderLaw;
use crate::math::real::Real;
use crate::normal::{Strips, Zone};

/// A tangential contact model with its settings and its memory.
pub trait ZoneModel<T: Real> {
    /// Hands the force on the wheel of each strip of `zone` to `each`, which adds them up: a strip
    /// may come twice. Allocates nothing but in the half-space solution on rectangles.
    fn strip_forces(
        &self,
        zone: &RollingZone<'_, T>,
        each: &mut dyn FnMut(usize, StripForce<T>),
    ) -> Convergence;
}

/// A loaded zone and how it rolls, under the laws of friction.
#[derive(Clone, Copy, Debug)]
pub struct RollingZone<'a, T = f64> {
    /// The zone, its strips and how its surfaces slip.
    pub loaded: LoadedZone<'a, T>,
    /// How it rolls; the creepage is the mean one.
    pub state: RollingState<T>,
    /// Its friction limit [N].
    pub limit: T,
    /// Where the origin of its y is among the zones that feel each other [m].
    pub origin: T,
}

impl<'a, T: Real> RollingZone<'a, T> {
    /// A `zone` of `strips` with the rigid slip `slip` under `law`, which is that of the mean
    /// creepage of `slip`; its y counts from where others have theirs.
    pub fn new(
        zone: &'a Zone<T>,
        strips: &'a Strips<T>,
        slip: RigidSlip<'a, T>,
        law: &'a UnderLaw<T>,
    ) -> Self {
        let (loaded, state) = (LoadedZone::new(zone, strips, slip, law), law.state);
        Self { loaded, state, limit: state.friction_limit(zone), origin: T::from(0.0) }
    }

    /// A `zone` of `strips` under `law` with one creepage, which is that of the law.
    pub fn flat(zone: &'a Zone<T>, strips: &'a Strips<T>, law: &'a UnderLaw<T>) -> Self {
        Self::new(zone, strips, RigidSlip::flat(zone, strips, law.state.creepage), law)
    }

    /// Share in the force of the direction `rolling`, 0 to 1.
    pub(super) fn share(&self, rolling: Rolling) -> T {
        match rolling {
            Rolling::Forward => self.state.forward_share,
            Rolling::Backward => -self.state.forward_share + 1.0,
        }
    }

    /// The directions in which the zone rolls, each with its share in the force, above 0. There
    /// are two between forward and backward rolling, which only the floor of the reference speed
    /// and wheels that spin against their motion leave room for: so the force has no jump.
    pub fn directions(&self) -> impl Iterator<Item = (Rolling, T)> {
        let both =
            [Rolling::Forward, Rolling::Backward].map(|rolling| (rolling, self.share(rolling)));
        both.into_iter().filter(|(_, share)| *share > 0.0)
    }
}
