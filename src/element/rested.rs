//! How rails without mass have come to rest.

use super::balance::Carried;
use super::input::Input;

/// How rails without mass rest under an input.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rested {
    /// The input, without its height where a load is given.
    pub under: Input,
    pub deflection: [f64; 2],
    /// What is left of the way to the deflection [m].
    pub left: f64,
    /// About how the load is carried there, if that is given and known.
    pub carried: Option<Carried>,
}

/// The input with a height that is the same for all.
pub(super) fn without_height(given: &Input) -> Input {
    let mut key = *given;
    key.wheel.position[2] = 0.0;
    key
}
