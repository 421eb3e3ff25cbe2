//! A loaded zone with all that its tractions follow from, but for the way in which it rolls.

use super::own_friction::OwnFriction;
use super::rigid_slip::RigidSlip;
use super::under_law::UnderLaw;
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
    pub slip: S,
    /// Coefficient of friction of the zone, ≥ 0 [-].
    pub friction: T,
    /// Of strips that have their own.
    pub own_friction: OwnFriction<'a, T>,
    /// Factor of the pressure where damping forces act on top of the elastic load, ≥ 0 [-].
    pub load_factor: T,
}

impl<S: Copy, T: Copy, L> Copy for LoadedZone<'_, S, T, L> {}

impl<S: Clone, T: Clone, L> Clone for LoadedZone<'_, S, T, L> {
    fn clone(&self) -> Self {
        let Self { slip, friction, own_friction, load_factor, .. } = self;
        Self {
            slip: slip.clone(),
            friction: friction.clone(),
            own_friction: own_friction.clone(),
            load_factor: load_factor.clone(),
            ..*self
        }
    }
}

impl<'a, S: RigidSlip<T>, T: Real> LoadedZone<'a, S, T> {
    /// With the friction and the damping of `law`.
    pub fn new(zone: &'a Zone<T>, strips: &'a Strips<T>, slip: S, law: &'a UnderLaw<T>) -> Self {
        Self {
            zone,
            strips,
            material: &law.material,
            slip,
            friction: law.state.friction,
            own_friction: OwnFriction { strips: &strips.friction, factors: law.factors },
            load_factor: law.state.load_factor,
        }
    }
}

impl<'a, S: RigidSlip<T>, T: Real, L> LoadedZone<'a, S, T, L> {
    /// The same zone with another rigid slip.
    pub fn with_slip<O: RigidSlip<T>>(&self, slip: O) -> LoadedZone<'a, O, T, L> {
        let &Self { zone, strips, material, friction, own_friction, load_factor, .. } = self;
        LoadedZone { zone, strips, material, slip, friction, own_friction, load_factor }
    }

    /// Coefficient of friction μ of strip `j`, ≥ 0 [-]: its own or that of the zone. It refers to
    /// the pressure without damping, so that the load factor is in it.
    #[inline]
    pub fn friction_coefficient(&self, j: usize) -> T {
        self.own_friction.coefficient(j).unwrap_or(self.friction) * self.load_factor
    }
}
