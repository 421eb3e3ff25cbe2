//! The tractions of loaded zones, which are found together.

use super::laid_zones::{LaidZone, RollingZones};
use super::models::Models;
use super::number::ElementNumber;
use super::tractions::Tractions;
use crate::element::output::Output;
use crate::element::parameters::CreepageModel;
use crate::element::work::Work;
use crate::tangential::CreepForce;

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
