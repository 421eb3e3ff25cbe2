//! The half-space solution on rectangles as a tangential model.

use super::StripForce;
use super::boundary_element::LoadedElements;
use super::convergence::Convergence;
use super::creep_number::CreepNumber;
use super::fastsim::Fastsim;
use super::field::ContactField;
use super::lobes::Lobes;
use super::march::March;
use super::rolling::Rolling;
use super::zone_model::{RollingZone, ZoneModel};

/// Rectangles on a grid over the zone, or those of the normal problem.
#[derive(Clone, Debug)]
pub struct OnElements {
    /// Elements along and across a zone whose pressure is not yet on a grid.
    pub count: [usize; 2],
    /// What takes its place where there is no solution, and for numbers with derivatives.
    pub otherwise: March<Fastsim>,
}

impl<T: CreepNumber> ZoneModel<T> for OnElements {
    fn strip_forces(
        &self,
        zone: &RollingZone<'_, T>,
        each: &mut dyn FnMut(usize, StripForce<T>),
    ) -> Convergence {
        let loaded = &zone.loaded;
        let elements = T::elements(loaded.zone, loaded.strips, self.count);
        let mut convergence = Convergence::default();
        for (rolling, share) in zone.directions() {
            if let Some(elements) = &elements {
                let mut add = |j, force: StripForce<T>| each(j, force.times(share));
                if T::on_elements(elements, loaded, rolling, &mut add) {
                    continue;
                }
                convergence = convergence.and(Convergence::failed());
            }
            let lobes = Lobes::of(loaded);
            self.otherwise.in_direction(zone, lobes.as_ref(), (rolling, share), each);
        }
        convergence
    }
}

impl OnElements {
    /// Enters the tractions of a zone that rolls forward into `field`, whose grid is that of
    /// `elements`.
    pub(super) fn draw(
        RollingZone { loaded, .. }: &RollingZone<'_>,
        elements: &LoadedElements,
        field: &mut ContactField,
    ) {
        field.take(&elements.tractions(loaded, Rolling::Forward));
    }
}
