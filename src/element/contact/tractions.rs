//! What the tractions of a zone add up to on the wheel.

use nalgebra::Vector3;

use crate::kinematics::creepage::{ContactAxes, Creepage};
use crate::math::real::Real;
use crate::tangential::CreepForce;

/// Resultant of the tractions of one zone on the wheel, in the track frame.
#[derive(Clone, Copy, Debug)]
pub struct Tractions<T = f64> {
    /// Force [N].
    pub force: Vector3<T>,
    /// Moment about the position of the patch [N m].
    pub moment: Vector3<T>,
    /// Power turned into heat over the reference speed [J/m].
    pub dissipation: T,
    /// Area that slips [m²].
    pub slip_area: T,
}

impl<T: Real> Default for Tractions<T> {
    fn default() -> Self {
        Self {
            force: Vector3::zeros(),
            moment: Vector3::zeros(),
            dissipation: T::from(0.0),
            slip_area: T::from(0.0),
        }
    }
}

impl<T: Real> Tractions<T> {
    /// Those of a flat zone with one creepage.
    pub fn flat(force: &CreepForce<T>, creepage: &Creepage<T>, axes: &ContactAxes<T>) -> Self {
        Self {
            force: axes.longitudinal * force.longitudinal + axes.lateral * force.lateral,
            moment: axes.normal * force.spin_moment,
            dissipation: -(force.longitudinal * creepage.longitudinal
                + force.lateral * creepage.lateral
                + force.spin_moment * creepage.spin),
            slip_area: force.slip_area,
        }
    }
}
