//! One step of a contact with memory: how the bodies move, and what comes of it.

use crate::kinematics::creepage::bounded;
use crate::open::Open;
use crate::planar::{PlanarCase, PlanarResult};
use crate::tangential::field::ContactField;

/// How the bodies move in a step, besides the creepage of its state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepMotion {
    /// Distance rolled towards +x, -1e6 to 1e6; backward rolling has a negative one [m].
    pub rolled: f64,
    /// Displacement of the wheel against the rail along x and y [m] and turn about the normal
    /// through the origin of the separation [rad], on top of creepage times the distance rolled, either
    /// way positive.
    pub shift: [f64; 3],
    /// Longitudinal and lateral creep force on the wheel at the end of the step, where it is given
    /// [N]: that component of the displacement is found, and what creepage and shift say of it is
    /// where the search begins.
    pub force: [Option<f64>; 2],
    #[doc(hidden)]
    pub open: Open,
}

/// What a step leads to; forces on the wheel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct TransientResult {
    /// Forces and contact at the end of the step.
    pub contact: PlanarResult,
    /// Rigid displacement of the wheel against the rail in the step along x and y [m] and turn
    /// [rad]: as given, or as found for given forces.
    pub displacement: [f64; 3],
    /// Work that friction takes up in the step, ≥ 0 [J].
    pub work: f64,
    /// Steps that it was divided into; 0 where it is solved as steady rolling.
    pub substeps: usize,
    /// Sweeps of the tangential solver.
    pub sweeps: usize,
    /// Whether the tractions of all of them settled.
    pub converged: bool,
}

/// Pressure, tractions and slip element by element at the end of a step.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct TransientField {
    /// Pressure and tractions on the wheel; y from the origin of the separation. Slip is over the
    /// distance rolled, as the mean of the step; none in a shift.
    pub contact: ContactField,
    /// Slip of the wheel against the rail in the step [m].
    pub slip: Vec<[f64; 2]>,
    /// Work of friction in the step, ≥ 0 [J].
    pub work: Vec<f64>,
}

/// Rigid displacement of a step as its state and motion say.
pub(super) fn displacement(case: &PlanarCase, motion: &StepMotion) -> [f64; 3] {
    let mut whole = motion.shift;
    for (whole, creepage) in whole.iter_mut().zip(case.creepage) {
        *whole += motion.rolled.abs() * bounded(creepage);
    }
    whole
}
