//! The two sides of a wheelset and the names that variables have there.

use crate::error::ContactError;

/// Place of the right side in all pairs.
pub const RIGHT: usize = 0;
/// Place of the left side in all pairs.
pub const LEFT: usize = 1;
/// Names of the sides, in the order of all pairs.
pub const SIDES: [&str; 2] = ["right", "left"];

/// The error of an element as one of the wheelset.
pub(super) fn on_side(error: ContactError, side: &str) -> ContactError {
    error.renamed(|name| name_on_side(name, side))
}

/// The name in `WheelSet.fmu` of what `WheelRail.fmu` calls `name`: what belongs to one wheel or
/// one rail has the side before it, models and materials are those of both.
pub fn name_on_side(name: &str, side: &str) -> String {
    let is_common = ["wheel.young_modulus", "wheel.poisson_ratio", "rail.", "wear.model"]
        .iter()
        .any(|common| name.starts_with(common));
    let friction = [
        "friction.coefficient",
        "friction.tread.coefficient",
        "friction.gauge_face.coefficient",
        "friction.profile",
    ];
    let is_of_side = ["wheel.", "rail[", "wear.wheel.file", "wear.rail["]
        .iter()
        .chain(&friction)
        .any(|start| name.starts_with(start));
    if is_of_side && !is_common { format!("{side}.{name}") } else { name.into() }
}
