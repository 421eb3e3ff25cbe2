//! Rigid slip of the strips of a zone: what makes tractions grow where the surfaces adhere.

use super::Creepage;
use super::flexibility::ZoneFlexibility;
use crate::math::real::Real;
use crate::normal::{Strips, Zone};

/// How fast the traction on the wheel grows along one strip, by the distance s from its leading
/// edge, as long as it adheres:
///
/// ```text
/// dp_x/ds = -longitudinal,  dp_y/ds = -(lateral + twist · t),  t along x from the strip's centre
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Growth<T = f64> {
    /// [Pa/m].
    pub longitudinal: T,
    /// At the centre of the strip [Pa/m].
    pub lateral: T,
    /// [Pa/m²].
    pub twist: T,
}

impl<T: Real> Growth<T> {
    /// Of a strip with the creepage `own` at its centre in a zone with the mean creepage `mean`:
    /// what it deviates by acts through L3, as spin does.
    #[inline]
    pub fn of_strip(
        own: &Creepage<T>,
        mean: &Creepage<T>,
        flexibility: &ZoneFlexibility<T>,
    ) -> Self {
        Self {
            longitudinal: mean.longitudinal / flexibility.longitudinal
                + (own.longitudinal - mean.longitudinal) / flexibility.spin,
            lateral: mean.lateral / flexibility.lateral
                + (own.lateral - mean.lateral) / flexibility.spin,
            twist: own.spin / flexibility.spin,
        }
    }
}

/// Rigid slip over the reference speed on all strips of a zone.
pub trait RigidSlip<T = f64>: Copy {
    /// The creepage of the zone as a whole: its longitudinal and lateral part act through the
    /// flexibilities L1 and L2, what the strips deviate from it and spin through L3.
    fn mean(&self) -> Creepage<T>;

    /// Growth of the traction on strip `j`.
    fn growth(&self, j: usize, flexibility: &ZoneFlexibility<T>) -> Growth<T>;

    /// Creepage at the centre of strip `j`; a flat one is carried on where the strip belongs to
    /// another zone.
    fn creepage(&self, j: usize) -> Creepage<T>;
}

/// One triple of creepages at the centroid of the load for the whole zone: w_x = ξ - φ y, w_y = η +
/// φ x.
#[derive(Clone, Copy, Debug)]
pub struct FlatSlip<'a, T = f64> {
    /// The zone.
    pub zone: &'a Zone<T>,
    /// Its strips, and maybe others.
    pub strips: &'a Strips<T>,
    /// Creepage at the centroid of the load.
    pub creepage: Creepage<T>,
}

impl<T: Real> RigidSlip<T> for FlatSlip<'_, T> {
    fn mean(&self) -> Creepage<T> {
        self.creepage
    }

    #[inline]
    fn growth(&self, j: usize, flexibility: &ZoneFlexibility<T>) -> Growth<T> {
        let Creepage { longitudinal, lateral, spin } = self.creepage;
        let (x, y) = (self.strips.x[j] - self.zone.x, self.strips.y[j] - self.zone.y);
        Growth {
            longitudinal: longitudinal / flexibility.longitudinal - spin * y / flexibility.spin,
            lateral: lateral / flexibility.lateral + spin * x / flexibility.spin,
            twist: spin / flexibility.spin,
        }
    }

    fn creepage(&self, j: usize) -> Creepage<T> {
        let Creepage { longitudinal, lateral, spin } = self.creepage;
        let (x, y) = (self.strips.x[j] - self.zone.x, self.strips.y[j] - self.zone.y);
        Creepage { longitudinal: longitudinal - spin * y, lateral: lateral + spin * x, spin }
    }
}

/// A creepage of its own for each strip, at its centre and in its own tangent plane.
#[derive(Clone, Copy, Debug)]
pub struct StripSlip<'a, T = f64> {
    /// Creepage of each strip.
    pub creepages: &'a [Creepage<T>],
    /// Mean of those of the zone, weighted by load.
    pub mean: Creepage<T>,
}

impl<T: Real> RigidSlip<T> for StripSlip<'_, T> {
    fn mean(&self) -> Creepage<T> {
        self.mean
    }

    #[inline]
    fn growth(&self, j: usize, flexibility: &ZoneFlexibility<T>) -> Growth<T> {
        Growth::of_strip(&self.creepages[j], &self.mean, flexibility)
    }

    fn creepage(&self, j: usize) -> Creepage<T> {
        self.creepages[j]
    }
}
