//! A zone of a whole rail in a frame of its own: through the centroid of its load, its normal along
//! the resultant.

use super::local_place::LocalPlace;
use super::strip_damping::StripDamping;
use crate::element::contact::laid_zones::LaidZone;
use crate::element::contact::models::Models;
use crate::geometry::contacts::contact::Contact;
use crate::geometry::contacts::contact_search::ContactSearch;
use crate::math::real::Real;
use crate::normal::{LoadedStrip, Strips};

/// A zone in a frame of its own.
#[derive(Clone, Copy, Debug)]
pub struct TakenZone<T = f64> {
    /// The frame, and how deep the zone is.
    pub contact: Contact<T>,
    /// Its load with damping over that without [-].
    pub load_factor: T,
    /// See [`ContactSetup::resultant_share`](crate::element::contact::contact_setup::ContactSetup::resultant_share).
    pub resultant_share: T,
    /// How far its load is ahead of the contact line of a round wheel, where bodies vary along the
    /// track [m].
    pub ahead: T,
}

impl<T: Copy> TakenZone<T> {
    /// That of a zone that was laid.
    pub fn of(laid: &LaidZone<T>) -> Self {
        let &LaidZone { contact, resultant_share, rolling, surface, .. } = laid;
        let (load_factor, ahead) = (rolling.load_factor, surface.ahead);
        Self { contact, load_factor, resultant_share, ahead }
    }
}

/// The deepest contact between the outermost strips of a zone, which have the parameters `u`, if
/// there is one.
pub(in crate::element) fn deepest_within<'a, T: Real>(
    search: &'a ContactSearch,
    u: &[T],
) -> Option<&'a Contact> {
    let ends = [u.first()?.value(), u.last()?.value()];
    let inside = search.contacts.iter().filter(|c| c.u >= ends[0] && c.u <= ends[1]);
    inside.max_by(|a, b| a.penetration.total_cmp(&b.penetration))
}

/// Parameters of the strips of the last zone.
pub(in crate::element) fn of_last_zone<T>(strips: &Strips<T>) -> &[T] {
    strips.zones.last().map_or(&[], |zone| &strips.u[zone.range()])
}

/// Adds zone number `index` of the rail to `models.strips`, with its `damping`, in a frame of its
/// own, with derivatives where the numbers have them; `place` is that of a
/// strip at a parameter of the line and one of the rail.
pub(in crate::element) fn zone_in_frame<T: Real>(
    index: usize,
    damping: &StripDamping<T>,
    models: &mut Models<T>,
    place: impl Fn([T; 2]) -> LocalPlace<T>,
) -> TakenZone<T> {
    let Models { strips, rail_strips: all, damping: coefficient, .. } = models;
    let mut zone = all.zones[index];
    let first = strips.y.len();
    let zero = T::from(0.0);
    let (mut sum, mut tangent, mut origin) = (zero, [zero; 2], [zero; 2]);
    let (mut penetration, mut ahead) = (zero, zero);
    for j in zone.range() {
        let own = place([all.u[j], all.y[j]]);
        let LocalPlace { point, tangent: direction, overlap, .. } = own;
        let factor = damping.factor(*coefficient, [all.x[j], all.u[j]], &own);
        let pressure = all.pressure[j] * factor;
        let load = all.half_length[j] * all.width[j] * pressure;
        sum += load;
        ahead += load * own.ahead;
        for axis in 0..2 {
            tangent[axis] += load * direction[axis];
            origin[axis] += load * point[axis];
        }
        penetration = penetration.max(overlap);
        strips.push(LoadedStrip { pressure, ..all.strip(j) });
    }
    let (area, load) = (zone.area, zone.load);
    zone.first = first;
    strips.summarise(&mut zone);
    let load_factor = if load > 0.0 { zone.load / load } else { T::from(1.0) };
    (zone.area, zone.load) = (area, load);
    let resultant = tangent[0].hypotenuse(tangent[1]);
    let center = zone.y;
    // Normals that diverge carry less together.
    let resultant_share = if sum > 0.0 { resultant / sum } else { zero };
    for (y, pressure) in strips.y.iter_mut().zip(strips.pressure.iter_mut()).skip(first) {
        *y -= center;
        *pressure /= load_factor;
    }
    zone.y = zero;
    strips.zones.push(zone);
    let contact = Contact {
        u: zone.u,
        rail_s: center,
        penetration,
        origin: origin.map(|o| o / sum.at_least(f64::MIN_POSITIVE)),
        tangent: tangent.map(|t| t / resultant.at_least(f64::MIN_POSITIVE)),
        probes: [0, 0],
    };
    ahead /= sum.at_least(f64::MIN_POSITIVE);
    TakenZone { contact, load_factor, resultant_share, ahead }
}
