//! Forces of the tractions: of a strip, and of a zone.

use super::convergence::Convergence;
use super::neck::Extent;
use crate::kinematics::creepage::Creepage;
use crate::math::real::Real;
use crate::normal::{Strips, Zone};

/// Force of one strip on the wheel, along x and along the strip's tangent.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct StripForce<T = f64> {
    /// Longitudinal force [N].
    pub longitudinal: T,
    /// Lateral force [N].
    pub lateral: T,
    /// Moment about the normal through the strip's centre [N m].
    pub moment: T,
    /// Area that slips [m²].
    pub slip_area: T,
}

impl<T: Real> StripForce<T> {
    /// Power that friction turns into heat in a strip with the `creepage` at its centre, over the
    /// speed that creepages refer to [J/m].
    pub fn dissipation(&self, creepage: &Creepage<T>) -> T {
        -(self.longitudinal * creepage.longitudinal
            + self.lateral * creepage.lateral
            + self.moment * creepage.spin)
    }

    pub(super) fn times(self, share: T) -> Self {
        Self {
            longitudinal: share * self.longitudinal,
            lateral: share * self.lateral,
            moment: share * self.moment,
            slip_area: share * self.slip_area,
        }
    }
}

/// Creep force of one zone on the wheel, in the contact frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct CreepForce<T = f64> {
    /// Longitudinal force [N].
    pub longitudinal: T,
    /// Lateral force [N].
    pub lateral: T,
    /// Moment about the normal through the centroid of the load [N m].
    pub spin_moment: T,
    /// Area that slips [m²].
    pub slip_area: T,
    /// How the tractions converged.
    pub convergence: Convergence,
}

impl<T: Real> CreepForce<T> {
    /// Adds the force of strip `j` of `zone`, a flat one.
    #[inline]
    pub fn add(&mut self, zone: &Zone<T>, strips: &Strips<T>, j: usize, force: &StripForce<T>) {
        let (x, y) = (strips.x[j] - zone.x, strips.y[j] - zone.y);
        self.longitudinal += force.longitudinal;
        self.lateral += force.lateral;
        self.spin_moment += x * force.lateral + force.moment - y * force.longitudinal;
        self.slip_area += force.slip_area;
    }

    /// Adds `share` times `other`, about the same point.
    pub(super) fn add_share(&mut self, other: &Self, share: T) {
        self.longitudinal += share * other.longitudinal;
        self.lateral += share * other.lateral;
        self.spin_moment += share * other.spin_moment;
        self.slip_area += share * other.slip_area;
    }

    /// Changes this correction so that with it the force `marched` is not greater than `limit` [N].
    pub(super) fn keep_within(&mut self, limit: T, marched: &Self) {
        let whole = [marched.longitudinal + self.longitudinal, marched.lateral + self.lateral];
        let magnitude = whole[0].hypotenuse(whole[1]);
        if magnitude > limit {
            let ratio = limit / magnitude;
            self.longitudinal = ratio * whole[0] - marched.longitudinal;
            self.lateral = ratio * whole[1] - marched.lateral;
        }
    }

    /// Hands this force, of the part of a zone that belongs to `extent`, to `each` in parts that go
    /// with the load of the strips.
    pub(super) fn spread_by_load(
        &self,
        zone: &Zone<T>,
        strips: &Strips<T>,
        extent: &Extent<T>,
        each: &mut dyn FnMut(usize, StripForce<T>),
    ) {
        let range = zone.range();
        let load = |j: usize| strips.weight(j) * extent.member(strips.y[j]);
        let total: T = range.clone().map(load).sum();
        let whole = StripForce {
            longitudinal: self.longitudinal,
            lateral: self.lateral,
            moment: self.spin_moment,
            slip_area: self.slip_area,
        };
        for j in range {
            each(j, whole.times(load(j) / total));
        }
    }
}
