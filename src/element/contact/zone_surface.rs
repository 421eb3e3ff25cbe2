//! Place and direction of a patch on bodies that are not even along the track.

use crate::geometry::rail::varying_rail::Along;
use crate::math::real::Real;
use crate::normal::{Strips, Zone};

/// Where the surface of an uneven wheel lies in a zone, and how it leans.
#[derive(Clone, Copy, Debug)]
pub struct ZoneSurface<T = f64> {
    /// How much deeper along the normal than the even contact line the wheel is at the centroid of
    /// the load [m].
    pub depth: T,
    /// Deviation of the radius there [m].
    pub radius: T,
    /// Tangent of the angle by which the normal of the patch leans forward, against the track's x
    /// axis [-].
    pub lean: T,
    /// How far the centroid of the load is ahead of the contact line of a round wheel, where the
    /// rail varies along the track or the wheel around [m].
    pub ahead: T,
}

impl<T: Real> ZoneSurface<T> {
    /// That of an even wheel on an even rail.
    pub fn even() -> Self {
        let zero = T::from(0.0);
        Self { depth: zero, radius: zero, lean: zero, ahead: zero }
    }

    /// The surface of a wheel whose section varies around at a centroid of load `ahead` of the
    /// contact line of the round wheel in its place [m]: its normals do not lean, and act where
    /// they are.
    pub fn beside_round(ahead: T) -> Self {
        Self { ahead, ..Self::even() }
    }

    /// The surface of a wheel at a centroid of load `ahead` of the contact line of a round wheel
    /// [m] on a rail that meets it `along` the track: it leans as the circle of the `radius` does
    /// there, so that the normal force of a round wheel has no moment about the axle, and less by
    /// as much as it passes ahead of the axle. The contact line itself lies `line_ahead` of that of
    /// a round wheel. `share` is the component of a unit of height along the normal.
    pub fn met(share: T, radius: T, along: &Along<T>, line_ahead: T, ahead: T) -> Self {
        let Along { raised, lever, .. } = *along;
        let to = ahead - line_ahead;
        let height = (radius * radius - to * to).at_least(0.0).sqrt();
        let lean = if height > 0.0 { share * (to - lever) / height } else { T::from(0.0) };
        Self { depth: share * (height - radius + raised), radius: raised, lean, ahead }
    }
}

/// How far the load of `zone` is ahead of the contact line, of which `centre` is the place at the
/// parameter of a strip [m].
pub fn ahead<T: Real>(zone: &Zone<T>, strips: &Strips<T>, centre: impl Fn(T) -> T) -> T {
    // Strips of a yawed wheel each have their own place on the line.
    let zero = T::from(0.0);
    let (mut ahead, mut load) = (zero, zero);
    for j in zone.range() {
        let weight = strips.weight(j);
        ahead += weight * (strips.x[j] - centre(strips.u[j]));
        load += weight;
    }
    // The pressure leans with the surfaces where they are nearest, not with its own middle.
    if load > 0.0 { ahead / load - zone.off } else { zero }
}
