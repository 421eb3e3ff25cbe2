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
    fn of_strip(own: &Creepage<T>, mean: &Creepage<T>, flexibility: &ZoneFlexibility<T>) -> Self {
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
#[derive(Clone, Copy, Debug)]
pub struct RigidSlip<'a, T = f64> {
    of: Creepages<'a, T>,
    /// Mean creepage of the part of the zone that is marched through by itself.
    part: Option<Creepage<T>>,
}

/// Creepages of the strips of a zone.
#[derive(Clone, Copy, Debug)]
enum Creepages<'a, T> {
    /// One at the centroid of the load.
    Flat { zone: &'a Zone<T>, strips: &'a Strips<T>, creepage: Creepage<T> },
    /// One of each strip, and their mean.
    Own(&'a [Creepage<T>], Creepage<T>),
}

impl<'a, T: Real> RigidSlip<'a, T> {
    /// With one `creepage` at the centroid of the load of `zone`: w_x = ξ - φ y, w_y = η + φ x.
    pub fn flat(zone: &'a Zone<T>, strips: &'a Strips<T>, creepage: Creepage<T>) -> Self {
        Self { of: Creepages::Flat { zone, strips, creepage }, part: None }
    }

    /// With a creepage of its own for each strip, at its centre and in its own tangent plane; `mean`
    /// is that of the zone, weighted by load.
    pub fn of_strips(creepages: &'a [Creepage<T>], mean: Creepage<T>) -> Self {
        Self { of: Creepages::Own(creepages, mean), part: None }
    }

    /// The same for a part of the zone, whose mean creepage acts through the flexibilities L1 and
    /// L2.
    #[must_use]
    pub fn of_part(self, mean: Creepage<T>) -> Self {
        Self { part: Some(mean), ..self }
    }

    /// The creepage of the zone, or of the part, as a whole: its longitudinal and lateral part act
    /// through the flexibilities L1 and L2, what the strips deviate from it and spin through L3.
    pub fn mean(&self) -> Creepage<T> {
        self.part.unwrap_or(match self.of {
            Creepages::Flat { creepage, .. } => creepage,
            Creepages::Own(_, mean) => mean,
        })
    }

    /// Growth of the traction on strip `j`.
    #[inline(always)]
    pub fn growth(&self, j: usize, flexibility: &ZoneFlexibility<T>) -> Growth<T> {
        if let (None, Creepages::Flat { zone, strips, creepage }) = (self.part, &self.of) {
            let &Creepage { longitudinal, lateral, spin } = creepage;
            let (x, y) = (strips.x[j] - zone.x, strips.y[j] - zone.y);
            return Growth {
                longitudinal: longitudinal / flexibility.longitudinal - spin * y / flexibility.spin,
                lateral: lateral / flexibility.lateral + spin * x / flexibility.spin,
                twist: spin / flexibility.spin,
            };
        }
        Growth::of_strip(&self.creepage(j), &self.mean(), flexibility)
    }

    /// Creepage at the centre of strip `j`; a flat one is carried on where the strip belongs to
    /// another zone.
    #[inline]
    pub fn creepage(&self, j: usize) -> Creepage<T> {
        match self.of {
            Creepages::Flat {
                zone,
                strips,
                creepage: Creepage { longitudinal, lateral, spin },
            } => {
                let (x, y) = (strips.x[j] - zone.x, strips.y[j] - zone.y);
                Creepage {
                    longitudinal: longitudinal - spin * y,
                    lateral: lateral + spin * x,
                    spin,
                }
            }
            Creepages::Own(creepages, _) => creepages[j],
        }
    }
}
