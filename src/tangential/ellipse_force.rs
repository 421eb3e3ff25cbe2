//! Forces that a zone gets from the ellipse that stands for it: those of the table, and the correction of FASTSIM.

use super::equivalent_ellipse::LoadedPart;
use super::fastsim_correction::EllipseStrips;
use super::rigid_slip::RigidSlip;
use super::tables::CreepForceTable;
use super::waist::Waist;
use super::{CreepForce, Rolling, RollingState, StripForce, Tangential};
use crate::material::MaterialPair;
use crate::normal::{Strips, Zone};

impl Tangential {
    /// The force of the ellipse that stands for `zone`, or of those for its lobes; where FASTSIM gave the zone the force `marched`, what corrects
    /// that. `state.creepage` is the mean creepage.
    pub(super) fn ellipse_force(
        &self,
        zone: &Zone,
        strips: &Strips,
        material: &MaterialPair,
        slip: &impl RigidSlip,
        state: &RollingState,
        marched: Option<&CreepForce>,
    ) -> Option<CreepForce> {
        let table = self.table?;
        (state.friction * zone.load * state.load_factor > 0.0).then_some(())?;
        let mut total = CreepForce::default();
        let waist = Waist::of(zone, strips);
        let lobes = waist.map_or(0.0, |waist| waist.share);
        let whole = LoadedPart::whole(zone, strips, state.creepage);
        if lobes < 1.0 {
            add_part(&mut total, table, material, zone, &whole, state, 1.0 - lobes);
        }
        if let Some(waist) = waist {
            let left = LoadedPart::of(zone, strips, slip, |y| waist.left(y));
            let right = LoadedPart::of(zone, strips, slip, |y| 1.0 - waist.left(y));
            for part in [left, right].iter().flatten() {
                add_part(&mut total, table, material, zone, part, state, lobes);
            }
        }
        if let Some((circle, marched)) = self.ellipse_strips.as_ref().zip(marched) {
            let approximate = self.marched_on(circle, material, zone, &whole, state);
            total.add_share(&approximate, -(1.0 - lobes));
            // FASTSIM gives a zone with a waist the flexibilities of one ellipse, which is no likeness of it: lobes have the force of the table.
            total.add_share(marched, -lobes);
            // What slips is what slips on the zone.
            total.slip_area = 0.0;
        }
        Some(total)
    }

    /// The force of FASTSIM on the ellipse of the whole zone.
    fn marched_on(
        &self,
        circle: &EllipseStrips,
        material: &MaterialPair,
        zone: &Zone,
        whole: &LoadedPart,
        state: &RollingState,
    ) -> CreepForce {
        let LoadedPart { ellipse, creepage, .. } = whole;
        let limit = state.friction * zone.load * state.load_factor;
        let mut total = CreepForce::default();
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

fn directions(state: &RollingState) -> [(Rolling, f64); 2] {
    [(Rolling::Forward, state.forward_share), (Rolling::Backward, 1.0 - state.forward_share)]
}

/// Adds `weight` times the tabulated force of one part, about the centroid of the zone.
fn add_part(
    total: &mut CreepForce,
    table: &CreepForceTable,
    material: &MaterialPair,
    zone: &Zone,
    part: &LoadedPart,
    state: &RollingState,
    weight: f64,
) {
    let LoadedPart { share, centre, ellipse, creepage } = part;
    let limit = share * state.friction * zone.load * state.load_factor;
    for (rolling, direction) in directions(state) {
        let weight = weight * direction;
        if weight <= 0.0 {
            continue;
        }
        let area = share * zone.area;
        let mut force = ellipse.tabulated_force(table, material, creepage, rolling, limit, area);
        force.spin_moment += centre[0] * force.lateral - centre[1] * force.longitudinal;
        total.add_share(&force, weight);
    }
}

impl CreepForce {
    fn add_share(&mut self, other: &Self, share: f64) {
        self.longitudinal += share * other.longitudinal;
        self.lateral += share * other.lateral;
        self.spin_moment += share * other.spin_moment;
        self.slip_area += share * other.slip_area;
    }

    /// Changes this correction so that with it the force `marched` is not greater than `limit` [N].
    pub(super) fn keep_within(&mut self, limit: f64, marched: &Self) {
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
pub(super) fn spread_by_load(
    zone: &Zone,
    strips: &Strips,
    force: &CreepForce,
    mut each: impl FnMut(usize, StripForce),
) {
    let range = zone.first..zone.first + zone.count;
    let load = |j: usize| strips.half_length[j] * strips.width[j] * strips.pressure[j];
    let total: f64 = range.clone().map(load).sum();
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
