//! Tractions of a zone that do not follow from the zone alone.

use nalgebra::Vector3;

use super::tractions::Tractions;
use crate::kinematics::creepage::Creepage;
use crate::math::real::Real;
use crate::tangential::Convergence;

/// Tractions of a zone that were found together with those of the others of its rail.
#[derive(Clone, Debug)]
pub struct GivenTractions<T = f64> {
    /// Creepage, its mean weighted by load.
    pub creepage: Creepage<T>,
    /// The tractions, their moment about the origin of the track frame at the x of the wheel
    /// marker.
    pub tractions: Tractions<T>,
    /// How they converged.
    pub convergence: Convergence,
    /// Dissipation over the reference speed [J/m] and area that slips [m²] of each strip.
    pub strips: Vec<[T; 2]>,
}

impl<T: Real> GivenTractions<T> {
    /// The tractions with their moment about `position`.
    pub fn about(&self, position: Vector3<T>) -> Tractions<T> {
        let Tractions { force, moment, .. } = self.tractions;
        Tractions { moment: moment - position.cross(&force), ..self.tractions }
    }
}
