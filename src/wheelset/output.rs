//! What an evaluation of a wheelset gives.

use super::guiding::Guiding;
use crate::element;
use crate::element::output::Wrench;
use crate::math::numbers::numbers;

/// All outputs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Output<T = f64> {
    /// Force of all contacts on the wheelset, and their moment about its centre, in the track
    /// frame.
    pub wheelset: Wrench<T>,
    /// Each side, right first; values are those of the real side in the track frame.
    pub sides: [element::Output<T>; 2],
    /// Height of the centre: the one found if the loads are given, else that of the input [m].
    pub wheelset_z: T,
    /// Roll of the axle: the one found if the loads are given, else that of the input [rad].
    pub roll: T,
    /// Number of loaded zones found on both sides.
    pub patch_count: i32,
    /// How often a solver fell back to a simpler model on either side since initialisation.
    pub fallback_count: i32,
    /// Dissipated energy per distance, spin included [J/m].
    pub wear_number: T,
    /// Power turned into heat [W].
    pub frictional_power: T,
    /// Guiding forces and wheel loads.
    pub guiding: Guiding<T>,
}

numbers!(
    Output: wheelset, sides, wheelset_z, roll, wear_number, frictional_power, guiding;
    ..Output::default()
);
