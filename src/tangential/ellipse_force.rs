//! Forces that a zone gets from the ellipse that stands for it: those of the table, and the correction of FASTSIM.

use super::equivalent_ellipse::LoadedPart;
use super::fastsim_correction::EllipseStrips;
use super::rigid_slip::RigidSlip;
use super::tables::CreepForceTable;
use super::waist::Waist;
use super::{CreepForce, CreepNumber, Rolling, RollingState, StripForce, Tangential};
use crate::material::MaterialPair;
use crate::math::real::Real;
use crate::normal::{Strips, Zone};

impl Tangential {
    /// The force of the ellipse that stands for `zone`, or of those for its lobes; where FASTSIM gave the zone the force `marched`, what corrects
    /// that. `state.creepage` is the mean creepage.
    pub(super) fn ellipse_force<T: CreepNumber>(
        &self,
        zone: &Zone<T>,
        strips: &Strips<T>,
        material: &MaterialPair<T>,
        slip: &impl RigidSlip<T>,
        state: &RollingState<T>,
        marched: Option<&CreepForce<T>>,
    ) -> Option<CreepForce<T>> {
        let table = self.table?;
        (state.friction * zone.load * state.load_factor > 0.0).then_some(())?;
        let mut total = CreepForce::<T>::default();
        let waist = Waist::of(zone, strips);
        let lobes = waist.map_or(T::from(0.0), |waist| waist.share);
        let whole = LoadedPart::whole(zone, strips, state.creepage);
        if lobes < 1.0 {
            add_part(&mut total, table, material, zone, &whole, state, -lobes + 1.0);
        }
        if let Some(waist) = waist {
            let left = LoadedPart::of(zone, strips, slip, |y| waist.left(y));
            let right = LoadedPart::of(zone, strips, slip, |y| -waist.left(y) + 1.0);
            for part in [left, right].iter().flatten() {
                add_part(&mut total, table, material, zone, part, state, lobes);
            }
        }
        if let Some((circle, marched)) = self.ellipse_strips.as_ref().zip(marched) {
            let approximate = self.marched_on(circle, material, zone, &whole, state);
            total.add_share(&approximate, -(-lobes + 1.0));
            // FASTSIM gives a zone with a waist the flexibilities of one ellipse, which is no likeness of it: lobes have the force of the table.
            total.add_share(marched, -lobes);
            // What slips is what slips on the zone.
            total.slip_area = T::from(0.0);
        }
        Some(total)
    }

    /// The force of FASTSIM on the ellipse of the whole zone.
    fn marched_on<T: CreepNumber>(
        &self,
        circle: &EllipseStrips,
        material: &MaterialPair<T>,
        zone: &Zone<T>,
        whole: &LoadedPart<T>,
        state: &RollingState<T>,
    ) -> CreepForce<T> {
        let LoadedPart { ellipse, creepage, .. } = whole;
        let limit = state.friction * zone.load * state.load_factor;
        let mut total = CreepForce::<T>::default();
        for (rolling, weight) in directions(state) {
            if weight > 0.0 {
                let (fastsim, flexibilities) = (&self.fastsim, self.flexibilities);
                let force = circle.force(
                    fastsim,
                    ellipse,
                    flexibilities,
                    material,
                    creepage,
                    rolling,
                    limit,
                );
                total.add_share(&force, weight);
            }
        }
        total
    }
}

fn directions<T: Real>(state: &RollingState<T>) -> [(Rolling, T); 2] {
    [(Rolling::Forward, state.forward_share), (Rolling::Backward, -state.forward_share + 1.0)]
}

/// Adds `weight` times the tabulated force of one part, about the centroid of the zone.
fn add_part<T: CreepNumber>(
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
    for (rolling, direction) in directions(state) {
        let weight = weight * direction;
        if weight <= 0.0 {
            continue;
        }
        let area = share * zone.area;
        let mut force = ellipse.tabulated_force(table, material, &creepage, rolling, limit, area);
        force.spin_moment += centre[0] * force.lateral - centre[1] * force.longitudinal;
        total.add_share(&force, weight);
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
