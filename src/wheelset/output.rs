//! What an evaluation of a wheelset gives.

use super::guiding::Guiding;
use crate::element;
use crate::element::output::Wrench;

/// All outputs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Output {
    /// Force of all contacts on the wheelset, and their moment about its centre, in the track
    /// frame.
    pub wheelset: Wrench,
    /// Each side, right first; values are those of the real side in the track frame.
    pub sides: [element::Output; 2],
    /// Height of the centre: the one found if the loads are given, else that of the input [m].
    pub wheelset_z: f64,
    /// Roll of the axle: the one found if the loads are given, else that of the input [rad].
    pub roll: f64,
    /// Number of loaded zones found on both sides.
    pub patch_count: i32,
    /// How often a solver fell back to a simpler model on either side since initialisation.
    pub fallback_count: i32,
    /// Dissipated energy per distance, spin included [J/m].
    pub wear_number: f64,
    /// Power turned into heat [W].
    pub frictional_power: f64,
    /// Guiding forces and wheel loads.
    pub guiding: Guiding,
}
