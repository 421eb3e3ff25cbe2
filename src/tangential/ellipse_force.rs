//! Forces that a zone gets from the ellipse that stands for it: those of the table, and the correction of FASTSIM.

use super::equivalent_ellipse::LoadedPart;
use super::rigid_slip::RigidSlip;
use super::tables::CreepForceTable;
use super::waist::Waist;
use super::{CreepForce, CreepNumber, Rolling, RollingState, StripForce, Tangential};
use crate::material::MaterialPair;
use crate::math::real::Real;
use crate::normal::{Strips, Zone};

impl Tangential {
    /// The force of the ellipse that stands for `zone`, or of those for its lobes where it has a waist; where FASTSIM marches through the
    /// zone, what corrects that. `state.creepage` is the mean creepage.
    pub(super) fn ellipse_force<T: CreepNumber>(
        &self,
        zone: &Zone<T>,
        strips: &Strips<T>,
        material: &MaterialPair<T>,
        slip: &impl RigidSlip<T>,
        state: &RollingState<T>,
    ) -> Option<CreepForce<T>> {
        let table = self.table?;
        (state.friction * zone.load * state.load_factor > 0.0).then_some(())?;
        let mut total = CreepForce::<T>::default();
        let mut add = |part: &LoadedPart<T>, weight: T| {
            self.add_part(&mut total, table, material, zone, part, state, weight);
        };
        let waist = Waist::of(zone, strips);
        let lobes = waist.map_or(T::from(0.0), |waist| waist.share);
        if lobes < 1.0 {
            add(&LoadedPart::whole(zone, strips, state.creepage), -lobes + 1.0);
        }
        if let Some(waist) = waist {
            for part in waist.lobes(zone, strips, slip).iter().flatten() {
                add(part, lobes);
            }
        }
        if self.is_corrected() {
            // What slips is what slips on the zone.
            total.slip_area = T::from(0.0);
        }
        Some(total)
    }

    /// Adds `weight` times the tabulated force of one part, about the centroid of the zone; where FASTSIM marches through the zone, less
    /// what FASTSIM has on the ellipse of the part.
    #[allow(clippy::too_many_arguments)] // what the part is and how it moves
    fn add_part<T: CreepNumber>(
        &self,
        total: &mut CreepForce<T>,
        table: &CreepForceTable,
        material: &MaterialPair<T>,
        zone: &Zone<T>,
        part: &LoadedPart<T>,
        state: &RollingState<T>,
        weight: T,
    ) {
        let LoadedPart { share, centre, ellipse, creepage } = *part;
        let limit = share * state.friction * zone.load * state.load_factor;
        let directions = [
            (Rolling::Forward, state.forward_share),
            (Rolling::Backward, -state.forward_share + 1.0),
        ];
        for (rolling, direction) in directions {
            let weight = weight * direction;
            if weight <= 0.0 {
                continue;
            }
            let area = share * zone.area;
            let mut force =
                ellipse.tabulated_force(table, material, &creepage, rolling, limit, area);
            if let Some(circle) = &self.ellipse_strips {
                let (fastsim, flexibilities) = (&self.fastsim, self.flexibilities);
                let approximate = circle.force(
                    fastsim,
                    &ellipse,
                    flexibilities,
                    material,
                    &creepage,
                    rolling,
                    limit,
                );
                force.add_share(&approximate, T::from(-1.0));
            }
            force.spin_moment += centre[0] * force.lateral - centre[1] * force.longitudinal;
            total.add_share(&force, weight);
        }
    }
}

impl<T: Real> CreepForce<T> {
    fn add_share(&mut self, other: &Self, share: T) {
        self.longitudinal += share * other.longitudinal;
        self.lateral += share * other.lateral;
        self.spin_moment += share * other.spin_moment;
        self.slip_area += share * other.slip_area;
    }

    /// Changes this correction so that with it the force `marched` is not greater than `limit` [N].
    pub(super) fn keep_within(&mut self, limit: T, marched: &Self) {
        let whole = [marched.longitudinal + self.longitudinal, marched.lateral + self.lateral];
        let magnitude = whole[0].hypot(whole[1]);
        if magnitude > limit {
            let ratio = limit / magnitude;
            self.longitudinal = ratio * whole[0] - marched.longitudinal;
            self.lateral = ratio * whole[1] - marched.lateral;
        }
    }
}

/// Hands `force` to `each` in parts that go with the load of the strips.
pub(super) fn spread_by_load<T: Real>(
    zone: &Zone<T>,
    strips: &Strips<T>,
    force: &CreepForce<T>,
    mut each: impl FnMut(usize, StripForce<T>),
) {
    let range = zone.first..zone.first + zone.count;
    let load = |j: usize| strips.half_length[j] * strips.width[j] * strips.pressure[j];
    let total: T = range.clone().map(load).sum();
    let whole = StripForce {
        longitudinal: force.longitudinal,
        lateral: force.lateral,
        moment: force.spin_moment,
        slip_area: force.slip_area,
    };
    for j in range {
        each(j, whole.times(load(j) / total));
    }
}
