//! A place of the contact line where a strip is, and the surfaces there.

use crate::geometry::rail::rail_outline::StripOverWaves;
use crate::geometry::rail::varying_rail::Along;
use crate::geometry::wheel::contact_line::LinePoint;
use crate::math::real::Real;
use crate::normal::least_energy::LinePlace;

/// A place of the contact line and the surfaces there.
pub(in crate::element) struct LocalPlace<T = f64> {
    /// Point of the line and unit tangent of the rail across (y, z) [m, -].
    pub point: [T; 2],
    pub tangent: [T; 2],
    /// Overlap [m].
    pub overlap: T,
    /// How far the middle of the strip is ahead of the contact line [m].
    pub ahead: T,
    /// Where the wheel meets a rail that varies along the track, with slopes of waves in the mean
    /// over the strip.
    pub along: Option<Along<T>>,
    /// How a corrugated roller [rises](crate::geometry::rail::rail_outline::RailOutline::rise), in the
    /// mean over the strip [-].
    pub rise: T,
}

impl<T: Real> LocalPlace<T> {
    /// That of the `strip` `at` a place of the contact line, which may lie `over_waves` and else
    /// meets the rail `along` the track.
    pub fn of(
        at: &LinePoint<T>,
        strip: &LinePlace<T>,
        over_waves: Option<&StripOverWaves<T>>,
        along: Option<Along<T>>,
    ) -> Self {
        let middle = over_waves.map_or(strip.x, |own| own.middle);
        Self {
            point: at.point,
            tangent: strip.tangent,
            overlap: strip.overlap,
            ahead: middle - at.x,
            along: over_waves.map(|own| own.along).or(along),
            rise: over_waves.map_or(T::from(0.0), |own| own.rise),
        }
    }
}
