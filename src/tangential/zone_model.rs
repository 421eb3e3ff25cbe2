//! What every tangential model does: from a loaded zone that rolls to forces on its strips.

use super::convergence::Convergence;
use super::forces::StripForce;
use super::loaded_zone::LoadedZone;
use super::rigid_slip::RigidSlip;
use super::rolling::{Rolling, RollingState};
use crate::math::real::Real;

/// A tangential contact model with its settings and its memory.
pub trait ZoneModel<T: Real> {
    /// Hands the force on the wheel of each strip of `zone` to `each`, which adds them up: a strip
    /// may come twice. Allocates nothing but in the half-space solution on rectangles.
    fn strip_forces(
        &self,
        zone: &RollingZone<'_, impl RigidSlip<T>, T>,
        each: &mut dyn FnMut(usize, StripForce<T>),
    ) -> Convergence;
}

/// A loaded zone and how it rolls, under the laws of friction.
#[derive(Debug)]
pub struct RollingZone<'a, S, T = f64> {
    /// The zone, its strips and how its surfaces slip.
    pub loaded: LoadedZone<'a, S, T>,
    /// How it rolls; the creepage is the mean one.
    pub state: RollingState<T>,
    /// Its friction limit, above 0 but for the linear model [N].
    pub limit: T,
}

impl<S, T: Real> RollingZone<'_, S, T> {
    /// The directions in which the zone rolls, each with its share in the force, above 0. There
    /// are two between forward and backward rolling, which only the floor of the reference speed
    /// and wheels that spin against their motion leave room for: so the force has no jump.
    pub fn directions(&self) -> impl Iterator<Item = (Rolling, T)> {
        let forward = self.state.forward_share;
        let both = [(Rolling::Forward, forward), (Rolling::Backward, -forward + 1.0)];
        both.into_iter().filter(|(_, share)| *share > 0.0)
    }
}
