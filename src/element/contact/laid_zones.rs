//! The loaded zones of a rail, or of one contact frame, as they are laid to roll together.

use nalgebra::Vector3;

use super::curved_strips::CurvedStrips;
use super::tractions::Tractions;
use super::zone_surface::ZoneSurface;
use crate::geometry::contacts::contact::Contact;
use crate::kinematics::creepage::{ContactAxes, RollingSpeed};
use crate::math::fixed_vec::FixedVec;
use crate::math::real::Real;
use crate::normal::{Strips, Zone};
use crate::tangential::rigid_slip::RigidSlip;
use crate::tangential::{CreepForce, RollingZone, UnderLaw};

/// A loaded zone and how it rolls.
#[derive(Clone, Copy, Debug)]
pub struct ZoneRolling<T> {
    pub zone: Zone<T>,
    /// Centroid of its load, x from the wheel marker [m].
    pub position: Vector3<T>,
    pub axes: ContactAxes<T>,
    pub rolling_radius: T,
    /// Velocity of the wheel along the rail's surface [m/s].
    pub forward: T,
    pub speed: RollingSpeed<T>,
    /// Normal force with damping over that without [-].
    pub load_factor: T,
    /// How much deeper than the even contact line the wheel is along the normal [m].
    pub surface_depth: T,
    /// Lean of the strips of a rail that varies along the track [-].
    pub lean: T,
}

/// A loaded zone in its frame, and how it rolls.
#[derive(Clone, Copy, Debug)]
pub struct LaidZone<T = f64> {
    /// Its number among the zones of the strips.
    pub index: usize,
    /// Its frame.
    pub contact: Contact<T>,
    /// See [`ContactSetup::resultant_share`](super::contact_setup::ContactSetup::resultant_share).
    pub resultant_share: T,
    /// Where the y of its strips count from, among the zones that feel each other [m].
    pub origin: T,
    pub rolling: ZoneRolling<T>,
    pub surface: ZoneSurface<T>,
    /// How it rolls under the laws of friction.
    pub law: UnderLaw<T>,
}

impl<T: Real> LaidZone<T> {
    /// Its rigid slip: of `curved` patches, else with one creepage on `strips`.
    pub fn slip<'a>(
        &'a self,
        strips: &'a Strips<T>,
        curved: Option<&'a CurvedStrips<T>>,
    ) -> RigidSlip<'a, T> {
        let mean = self.law.state.creepage;
        curved.map_or_else(
            || RigidSlip::flat(&self.rolling.zone, strips, mean),
            |curved| curved.slip(mean),
        )
    }

    /// The zone of `strips` with that slip.
    pub fn rolling<'a>(
        &'a self,
        strips: &'a Strips<T>,
        curved: Option<&'a CurvedStrips<T>>,
    ) -> RollingZone<'a, T> {
        let slip = self.slip(strips, curved);
        let zone = RollingZone::new(&self.rolling.zone, strips, slip, &self.law);
        RollingZone { origin: self.origin, ..zone }
    }
}

/// Zones that are under way together, in the order of their places across.
#[derive(Clone, Debug)]
pub struct RollingZones<T = f64> {
    pub zones: FixedVec<LaidZone<T>>,
    /// The strips on the wheel's surface, if creepage is that of curved patches.
    pub strips: CurvedStrips<T>,
    /// Resultants of each zone: in its frame, if creepage is flat, and in that of the track.
    pub flat: FixedVec<CreepForce<T>>,
    pub tractions: FixedVec<Tractions<T>>,
}

impl<T: Real> RollingZones<T> {
    /// Room for that many zones and strips.
    pub fn with_capacity(zones: usize, strips: usize) -> Self {
        Self {
            zones: FixedVec::new(zones),
            strips: CurvedStrips::with_capacity(strips),
            flat: FixedVec::new(zones),
            tractions: FixedVec::new(zones),
        }
    }

    /// Most zones and strips without allocating.
    pub fn capacity(&self) -> [usize; 2] {
        [self.zones.capacity(), self.strips.capacity()]
    }

    /// Forgets all zones.
    pub fn clear(&mut self) {
        self.zones.clear();
        self.strips.clear();
        self.tractions.clear();
    }
}
