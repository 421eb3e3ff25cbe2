//! The half-space solution on strips as a tangential model.
//!
//! A zone with a [neck](super::neck) is mixed of the solution for the whole and of those for both
//! lobes, as two zones that join do not feel each other before.

use super::StripForce;
use super::boundary_element::LoadedElements;
use super::convergence::Convergence;
use super::creep_number::CreepNumber;
use super::fastsim::Fastsim;
use super::field::ContactField;
use super::march::March;
use super::neck::{Neck, Side};
use super::rigid_slip::RigidSlip;
use super::strips::{Scratch, Span};
use super::zone_model::{RollingZone, ZoneModel};

/// A few points along a few strips of the zone.
#[derive(Clone, Debug)]
pub struct OnStrips {
    /// The solver.
    pub solver: Scratch,
    /// What takes its place where there is no solution, on the whole zone.
    pub otherwise: March<Fastsim>,
}

/// Depth of a [neck](super::neck) from which on a zone is one: lobes of a zone feel each other.
const WHOLE: f64 = 0.2;

impl<T: CreepNumber> ZoneModel<T> for OnStrips {
    fn strip_forces(
        &self,
        zone: &RollingZone<'_, impl RigidSlip<T>, T>,
        each: &mut dyn FnMut(usize, StripForce<T>),
    ) -> Convergence {
        let RollingZone { loaded, .. } = zone;
        let neck = Neck::below(WHOLE, loaded.zone, loaded.strips);
        let mut convergence = Convergence::default();
        let mut solver = self.solver.lend();
        for (rolling, share) in zone.directions() {
            let mut part = |of_part: T, side: Option<Side>| {
                if of_part <= 0.0 {
                    return;
                }
                let lobe = neck.zip(side);
                let weight = |j: usize| {
                    let member =
                        |(neck, side): (Neck<T>, Side)| neck.member(side, loaded.strips.y[j]);
                    of_part * lobe.map_or(T::from(1.0), member)
                };
                let span = Span::of(loaded.zone, loaded.strips, lobe);
                let add = |j, force: StripForce<T>| each(j, force.times(weight(j)));
                let settled = T::on_strips(&mut solver, loaded, &span, rolling, add);
                if settled.is_none() {
                    let of_zone = (rolling, T::from(1.0));
                    let mut add = |j, force: StripForce<T>| each(j, force.times(weight(j)));
                    self.otherwise.in_direction(zone, None, of_zone, &mut add);
                }
                let own = settled.map_or(Convergence::failed(), |settled| settled.convergence());
                convergence = convergence.and(own);
            };
            let apart = neck.map_or(T::from(0.0), |neck| neck.share);
            part(share * (-apart + 1.0), None);
            part(share * apart, Some(Side::Left));
            part(share * apart, Some(Side::Right));
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
