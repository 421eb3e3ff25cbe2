//! The half-space solution on strips as a tangential model.

use super::StripForce;
use super::boundary_element::LoadedElements;
use super::convergence::Convergence;
use super::creep_number::CreepNumber;
use super::fastsim::Fastsim;
use super::field::ContactField;
use super::march::March;
use super::rigid_slip::RigidSlip;
use super::strips::Scratch;
use super::zone_model::{RollingZone, ZoneModel};

/// A few points along a few strips of the zone.
#[derive(Clone, Debug)]
pub struct OnStrips {
    /// The solver.
    pub solver: Scratch,
    /// What takes its place where there is no solution: on the whole zone, as strips know no lobes.
    pub otherwise: March<Fastsim>,
}

impl<T: CreepNumber> ZoneModel<T> for OnStrips {
    fn strip_forces(
        &self,
        zone: &RollingZone<'_, impl RigidSlip<T>, T>,
        each: &mut dyn FnMut(usize, StripForce<T>),
    ) -> Convergence {
        let mut convergence = Convergence::default();
        for (rolling, share) in zone.directions() {
            let add = |j, force: StripForce<T>| each(j, force.times(share));
            let settled = T::on_strips(&mut self.solver.lend(), &zone.loaded, rolling, add);
            if settled.is_none() {
                self.otherwise.in_direction(zone, None, (rolling, share), each);
            }
            let own = settled.map_or(Convergence::failed(), |settled| settled.convergence());
            convergence = convergence.and(own);
        }
        convergence
    }
}

impl OnStrips {
    /// Enters the tractions of a zone that rolls forward into `field`, whose grid is that of
    /// `elements`.
    pub(super) fn draw(
        &self,
        RollingZone { loaded, .. }: &RollingZone<'_, impl RigidSlip>,
        elements: &LoadedElements,
        field: &mut ContactField,
    ) {
        let strips = loaded.strips;
        let mut solver = self.solver.lend();
        let Some(tractions) = solver.tractions(loaded) else { return };
        for (row, strip) in elements.rows_of(loaded.zone) {
            for i in 0..field.grid.along {
                let pressure = field.pressure[row * field.grid.along + i];
                if pressure <= 0.0 {
                    continue;
                }
                let t = (field.grid.x(i) - strips.x[strip]) / strips.half_length[strip];
                let (share, slips) = tractions(strip - loaded.zone.first, t);
                let bound = loaded.friction_coefficient(strip) * pressure;
                field.enter(row, i, share.map(|share| share * bound), slips);
            }
        }
    }
}
