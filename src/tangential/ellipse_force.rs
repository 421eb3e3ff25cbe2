//! Forces that a zone gets from the ellipse that stands for it: those of the table, and the
//! correction of FASTSIM.

use super::equivalent_ellipse::{LoadedPart, RollingEllipse};
use super::neck::{Lobes, Side};
use super::rigid_slip::RigidSlip;
use super::tables::CreepForceTable;
use super::{CreepForce, CreepNumber, LoadedZone, Rolling, RollingState, StripForce, Tangential};

impl Tangential {
    /// Hands the force of the ellipse that stands for the zone of `loaded`, or of those for its
    /// `lobes` where it has a neck, to `each`, strip by strip in proportion to the load; where
    /// FASTSIM marches through the zone, what corrects the forces `marched` of the same parts,
    /// which holds the sum to the friction limit. `state.creepage` is the mean creepage. Nothing
    /// without friction or without a table.
    pub(super) fn ellipse_force<T: CreepNumber>(
        &self,
        loaded: &LoadedZone<'_, impl RigidSlip<T>, T>,
        lobes: Option<&Lobes<T>>,
        state: &RollingState<T>,
        marched: &[CreepForce<T>; 3],
        mut each: impl FnMut(usize, StripForce<T>),
    ) -> Option<()> {
        let table = self.table?;
        let &LoadedZone { zone, strips, .. } = loaded;
        let limit = state.friction_limit(zone);
        (limit > 0.0).then_some(())?;
        let mut add =
            |part: &LoadedPart<T>, weight: T, marched: &CreepForce<T>, member: &dyn Fn(T) -> T| {
                let mut force = CreepForce::default();
                self.add_part(&mut force, table, loaded, part, state, weight);
                if self.is_corrected() {
                    // What slips is what slips on the zone.
                    force.slip_area = T::from(0.0);
                    force.keep_within(limit * part.share * part.friction * weight, marched);
                }
                force.spread_by_load(zone, strips, member, &mut each);
            };
        let share = lobes.map_or(T::from(0.0), |lobes| lobes.neck.share);
        if share < 1.0 {
            let part = LoadedPart::whole(zone, strips, state.creepage);
            add(&part, -share + 1.0, &marched[0], &|_| T::from(1.0));
        }
        let Some(Lobes { neck, parts }) = lobes else { return Some(()) };
        for ((part, marched), side) in
            parts.iter().zip(&marched[1..]).zip([Side::Left, Side::Right])
        {
            if let Some(part) = part {
                add(part, share, marched, &|y| neck.member(side, y));
            }
        }
        Some(())
    }

    /// Adds `weight` times the tabulated force of one part, about its centroid; where FASTSIM
    /// marches through the zone, less what FASTSIM has on the ellipse of the part.
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
        let LoadedPart { share, ellipse, creepage, friction, .. } = *part;
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
            total.add_share(&force, weight);
        }
    }
}
