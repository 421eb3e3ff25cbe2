//! Forces that a zone gets from the ellipse that stands for it: those of the table, and the
//! correction of FASTSIM.

use super::convergence::Convergence;
use super::equivalent_ellipse::{LoadedPart, RollingEllipse};
use super::fastsim::Fastsim;
use super::fastsim_correction::EllipseStrips;
use super::lobes::Lobes;
use super::march::March;
use super::neck::{Extent, Side};
use super::tables::CreepForceTable;
use super::zone_model::{RollingZone, ZoneModel};
use super::{CreepForce, CreepNumber, LoadedZone, StripForce};

/// The model that takes the force of a zone from the table.
#[derive(Clone, Debug)]
pub struct Tabulated {
    /// The table.
    pub table: &'static CreepForceTable,
    /// FASTSIM, whose tractions are shown: the table has none.
    pub shown: March<Fastsim>,
}

/// The model that marches through the zone by FASTSIM and corrects the force by the error of FASTSIM
/// on the ellipse of the zone.
#[derive(Clone, Debug)]
pub struct Corrected {
    /// The march, in the zone and in the ellipse.
    pub march: March<Fastsim>,
    /// What is right on the ellipse.
    pub table: &'static CreepForceTable,
    /// A circle to stretch to the ellipse.
    pub circle: Box<EllipseStrips>,
}

impl<T: CreepNumber> ZoneModel<T> for Tabulated {
    fn strip_forces(
        &self,
        zone: &RollingZone<'_, T>,
        each: &mut dyn FnMut(usize, StripForce<T>),
    ) -> Convergence {
        let lobes = Lobes::of(&zone.loaded);
        let force = |_: usize, part: &LoadedPart<T>, weight: T| {
            part_force(zone, part, weight, |ellipse, area| {
                ellipse.tabulated_force(self.table, area)
            })
        };
        spread_parts(zone, lobes.as_ref(), force, each);
        Convergence::default()
    }
}

impl<T: CreepNumber> ZoneModel<T> for Corrected {
    fn strip_forces(
        &self,
        zone: &RollingZone<'_, T>,
        each: &mut dyn FnMut(usize, StripForce<T>),
    ) -> Convergence {
        let &LoadedZone { zone: whole, strips, .. } = &zone.loaded;
        let lobes = Lobes::of(&zone.loaded);
        let mut marched = [CreepForce::<T>::default(); 3];
        self.march.part_forces(zone, lobes.as_ref(), |part, j, force| {
            marched[part].add(whole, strips, j, &force);
            each(j, force);
        });
        let March { rule: fastsim, flexibilities } = &self.march;
        let correction = |n: usize, part: &LoadedPart<T>, weight: T| {
            let mut force = part_force(zone, part, weight, |ellipse, area| {
                let mut force = ellipse.tabulated_force(self.table, area);
                let approximate = self.circle.force(fastsim, *flexibilities, ellipse);
                force.add_share(&approximate, T::from(-1.0));
                force
            });
            // What slips is what slips on the zone.
            force.slip_area = T::from(0.0);
            force.keep_within(zone.limit * part.share * part.friction * weight, &marched[n]);
            force
        };
        spread_parts(zone, lobes.as_ref(), correction, each);
        Convergence::default()
    }
}

/// Hands the force of the part that is the whole `zone`, or of those that are its `lobes` where it
/// has a neck, to `each`, strip by strip in proportion to the load. `force` tells that of a part
/// from its number (the whole, the left, the right), the part and its weight.
pub(super) fn spread_parts<T: CreepNumber>(
    zone: &RollingZone<'_, T>,
    lobes: Option<&Lobes<T>>,
    force: impl Fn(usize, &LoadedPart<T>, T) -> CreepForce<T>,
    each: &mut dyn FnMut(usize, StripForce<T>),
) {
    let &LoadedZone { zone: whole, strips, .. } = &zone.loaded;
    let share = lobes.map_or(T::from(0.0), |lobes| lobes.neck.share);
    if share < 1.0 {
        let part = LoadedPart::whole(whole, strips, zone.state.creepage);
        let force = force(0, &part, -share + 1.0);
        force.spread_by_load(whole, strips, &Extent::Whole, each);
    }
    let Some(Lobes { neck, parts }) = lobes else { return };
    for (n, (part, side)) in parts.iter().zip([Side::Left, Side::Right]).enumerate() {
        if let Some(part) = part {
            let force = force(1 + n, part, share);
            force.spread_by_load(whole, strips, &Extent::Lobe(*neck, side), each);
        }
    }
}

/// `weight` times the force of one part, about its centroid, of both directions in which `zone`
/// rolls; `of_ellipse` tells that of the ellipse of the part, whose zone has the given area [m²].
pub(super) fn part_force<T: CreepNumber>(
    zone: &RollingZone<'_, T>,
    part: &LoadedPart<T>,
    weight: T,
    of_ellipse: impl Fn(&RollingEllipse<'_, T>, T) -> CreepForce<T>,
) -> CreepForce<T> {
    let mut total = CreepForce::default();
    let RollingZone { loaded: LoadedZone { zone: whole, material, .. }, state, .. } = zone;
    let LoadedPart { share, ellipse, creepage, friction, .. } = *part;
    let limit = share * friction * state.friction * whole.load * state.load_factor;
    if limit <= 0.0 {
        return total;
    }
    for (rolling, direction) in zone.directions() {
        let ellipse = RollingEllipse { ellipse, material, creepage, rolling, limit };
        total.add_share(&of_ellipse(&ellipse, share * whole.area), weight * direction);
    }
    total
}
