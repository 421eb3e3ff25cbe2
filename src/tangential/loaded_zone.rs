//! A loaded zone with all that its tractions follow from, but for the way in which it rolls.

use super::RollingState;
use super::rigid_slip::RigidSlip;
use crate::material::MaterialPair;
use crate::math::real::Real;
use crate::normal::{Strips, Zone};

/// What is marched through, from either end: a zone, its strips and how its surfaces slip.
#[derive(Debug)]
pub struct LoadedZone<'a, S, T = f64, L = Strips<T>> {
    /// The zone.
    pub zone: &'a Zone<T>,
    /// Its strips, and maybe others.
    pub strips: &'a L,
    /// Elastic constants of both bodies.
    pub material: &'a MaterialPair<T>,
    /// Rigid slip of the strips.
    pub slip: &'a S,
    /// Coefficient of friction, times the factor of the pressure where damping forces act on top of the elastic load, ≥ 0 [-].
    pub friction: T,
}

impl<'a, S: RigidSlip<T>, T: Real, L> LoadedZone<'a, S, T, L> {
    /// With the friction and the damping of `state`.
    pub fn new(
        zone: &'a Zone<T>,
        strips: &'a L,
        material: &'a MaterialPair<T>,
        slip: &'a S,
        state: &RollingState<T>,
    ) -> Self {
        Self { zone, strips, material, slip, friction: state.friction * state.load_factor }
    }

    /// The same zone with another rigid slip.
    pub fn with_slip<O: RigidSlip<T>>(&self, slip: &'a O) -> LoadedZone<'a, O, T, L> {
        let &Self { zone, strips, material, friction, .. } = self;
        LoadedZone { zone, strips, material, slip, friction }
    }
}
