//! Forces that a zone gets from the ellipse that stands for it: those of the table, and the correction of FASTSIM.

use super::equivalent_ellipse::{LoadedPart, RollingEllipse};
use super::rigid_slip::RigidSlip;
use super::tables::CreepForceTable;
use super::waist::Lobes;
use super::{CreepForce, CreepNumber, LoadedZone, Rolling, RollingState, Tangential};

impl Tangential {
    /// The force of the ellipse that stands for the zone of `loaded`, or of those for its `lobes` where it has a waist; where FASTSIM
    /// marches through the zone, what corrects that. `state.creepage` is the mean creepage. Nothing without friction.
    pub(super) fn ellipse_force<T: CreepNumber>(
        &self,
        loaded: &LoadedZone<'_, impl RigidSlip<T>, T>,
        lobes: Option<&Lobes<T>>,
        state: &RollingState<T>,
    ) -> Option<CreepForce<T>> {
        let table = self.table?;
        let &LoadedZone { zone, strips, .. } = loaded;
        (state.friction_limit(zone) > 0.0).then_some(())?;
        let mut total = CreepForce::<T>::default();
        let mut add = |part: &LoadedPart<T>, weight: T| {
            self.add_part(&mut total, table, loaded, part, state, weight);
        };
        let share = lobes.map_or(T::from(0.0), |lobes| lobes.waist.share);
        if share < 1.0 {
            add(&LoadedPart::whole(zone, strips, state.creepage), -share + 1.0);
        }
        for part in lobes.iter().flat_map(|lobes| lobes.parts.iter().flatten()) {
            add(part, share);
        }
        if self.is_corrected() {
            // What slips is what slips on the zone.
            total.slip_area = T::from(0.0);
        }
        Some(total)
    }

    /// Adds `weight` times the tabulated force of one part, about the centroid of the zone; where FASTSIM marches through the zone, less
    /// what FASTSIM has on the ellipse of the part.
    fn add_part<T: CreepNumber>(
        &self,
        total: &mut CreepForce<T>,
        table: &CreepForceTable,
        loaded: &LoadedZone<'_, impl RigidSlip<T>, T>,
        part: &LoadedPart<T>,
        state: &RollingState<T>,
        weight: T,
    ) {
        let &LoadedZone { zone, material, .. } = loaded;
        let LoadedPart { share, centre, ellipse, creepage, friction } = *part;
        let limit = share * friction * state.friction * zone.load * state.load_factor;
        if limit <= 0.0 {
            return;
        }
        let directions = [
            (Rolling::Forward, state.forward_share),
            (Rolling::Backward, -state.forward_share + 1.0),
        ];
        for (rolling, direction) in directions {
            let weight = weight * direction;
            if weight <= 0.0 {
                continue;
            }
            let rolling = RollingEllipse { ellipse, material, creepage, rolling, limit };
            let mut force = rolling.tabulated_force(table, share * zone.area);
            if let Some(circle) = &self.ellipse_strips {
                let approximate = circle.force(&self.fastsim, self.flexibilities, &rolling);
                force.add_share(&approximate, T::from(-1.0));
            }
            force.spin_moment += centre[0] * force.lateral - centre[1] * force.longitudinal;
            total.add_share(&force, weight);
        }
    }
}
