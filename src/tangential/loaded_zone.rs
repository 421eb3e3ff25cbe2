//! A loaded zone with all that its tractions follow from, but for the way in which it rolls.

use super::own_friction::OwnFriction;
use super::rigid_slip::RigidSlip;
use super::under_law::UnderLaw;
use crate::material::MaterialPair;
use crate::math::real::Real;
use crate::normal::{Strips, Zone};

/// What is marched through, from either end: a zone, its strips and how its surfaces slip.
#[derive(Clone, Copy, Debug)]
pub struct LoadedZone<'a, T = f64> {
    /// The zone.
    pub zone: &'a Zone<T>,
    /// Its strips, and maybe others.
    pub strips: &'a Strips<T>,
    /// Elastic constants of both bodies.
    pub material: &'a MaterialPair<T>,
    /// Rigid slip of the strips.
    pub slip: RigidSlip<'a, T>,
    /// Coefficient of friction of the zone, ≥ 0 [-].
    pub friction: T,
    /// Of strips that have their own.
    pub own_friction: OwnFriction<'a, T>,
    /// Factor of the pressure where damping forces act on top of the elastic load, ≥ 0 [-].
    pub load_factor: T,
}

impl<'a, T: Real> LoadedZone<'a, T> {
    /// With the friction and the damping of `law`.
    pub fn new(
        zone: &'a Zone<T>,
        strips: &'a Strips<T>,
        slip: RigidSlip<'a, T>,
        law: &'a UnderLaw<T>,
    ) -> Self {
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

    /// Coefficient of friction μ of strip `j`, ≥ 0 [-]: its own or that of the zone. It refers to
    /// the pressure without damping, so that the load factor is in it.
    #[inline]
    pub fn friction_coefficient(&self, j: usize) -> T {
        self.own_friction.coefficient(j).unwrap_or(self.friction) * self.load_factor
    }
}
