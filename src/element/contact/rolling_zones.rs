//! The loaded zones of a rail, or of one contact frame, as they roll: their tractions are found
//! together.

use super::curved_strips::CurvedStrips;
use super::models::Models;
use super::number::ElementNumber;
use super::tractions::Tractions;
use super::zone_rolling::ZoneRolling;
use super::zone_surface::ZoneSurface;
use crate::element::output::Output;
use crate::element::parameters::CreepageModel;
use crate::element::work::Work;
use crate::geometry::contacts::contact::Contact;
use crate::math::fixed_vec::FixedVec;
use crate::math::real::Real;
use crate::normal::Strips;
use crate::tangential::rigid_slip::RigidSlip;
use crate::tangential::{CreepForce, RollingZone, UnderLaw};

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
    fn slip<'a>(
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
    fn rolling<'a>(
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
    flat: FixedVec<CreepForce<T>>,
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

impl<T: ElementNumber> Models<T> {
    /// Finds the tractions of all zones that were laid; returns how many zones fell back to a simpler
    /// tangential model.
    pub(in crate::element) fn roll(&mut self, output: &mut Output<T>, work: &mut Work) -> u64 {
        let Self { rolling, strips, tangential, wear, given, creepage, .. } = self;
        let RollingZones { zones, strips: curved, flat, tractions } = rolling;
        work.zones += zones.len() as u64;
        tractions.clear();
        tractions.resize(zones.len(), Tractions::default());
        let mut wear = wear.as_deref_mut().filter(|wear| wear.is_recording());
        if let Some(wear) = &mut wear {
            wear.begin_strips(strips.y.len());
        }
        if let (Some(given), [zone, ..]) = (given.take(), &zones[..]) {
            if let Some(wear) = wear {
                let first = zone.rolling.zone.first;
                for (j, [dissipation, slip_area]) in given.strips.iter().enumerate() {
                    wear.add_strip(first + j, dissipation.value(), slip_area.value());
                }
            }
            tractions[0] = given.about(zone.rolling.position);
            work.marches += 1;
            output.tangential_residual =
                output.tangential_residual.at_least(given.convergence.residual);
            return given.convergence.fallbacks;
        }
        let mut add_wear = |j: usize, dissipation: T, slip_area: T| {
            if let Some(wear) = &mut wear {
                wear.add_strip(j, dissipation.value(), slip_area.value());
            }
        };
        let is_curved = *creepage == CreepageModel::Curved;
        let is_still = |zone: &LaidZone<T>| zone.law.state.creepage.is_zero();
        if if is_curved { curved.is_still() } else { zones.iter().all(is_still) } {
            return 0;
        }
        let acts =
            zones.iter().filter(|zone| tangential.acts_on(&zone.rolling.zone, &zone.law)).count();
        flat.clear();
        if !is_curved {
            flat.resize(zones.len(), CreepForce::default());
        }
        let curved = is_curved.then_some(&*curved);
        let rolling = zones.iter().map(|zone| zone.rolling(strips, curved));
        let convergence = tangential.roll(rolling, |n, j, force| {
            let zone = &zones[n];
            let dissipation = if let Some(curved) = curved {
                curved.add(&mut tractions[n], zone.rolling.position, j, &force)
            } else {
                flat[n].add(&zone.rolling.zone, strips, j, &force);
                force.dissipation(&zone.slip(strips, None).creepage(j))
            };
            add_wear(j, dissipation, force.slip_area);
        });
        if curved.is_none() {
            for ((tractions, zone), flat) in tractions.iter_mut().zip(zones.iter()).zip(flat.iter())
            {
                *tractions = Tractions::flat(flat, &zone.law.state.creepage, &zone.rolling.axes);
            }
        }
        if tangential.is_corrected() {
            // Parts of the correction against those of the march in other tangent planes may add up
            // to more than friction can hold.
            for (tractions, zone) in tractions.iter_mut().zip(zones.iter()) {
                let force = tractions.force;
                let limit = zone.law.state.friction_limit(&zone.rolling.zone);
                tractions.force *= (limit / force.dot(&force).sqrt()).at_most(1.0);
            }
        }
        work.marches += acts as u64;
        output.tangential_residual = output.tangential_residual.at_least(convergence.residual);
        convergence.fallbacks
    }
}
