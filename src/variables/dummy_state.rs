//! The variant of a unit with a dummy state, for importers that cannot integrate a unit without
//! states: der(x) = 0. Nothing depends on it.

use super::variable::Unit;

/// Behind the GUID of a description that has it.
pub const WITH_STATE: &str = "+state";
/// Its name.
pub const STATE_NAME: &str = "dummy_state";
/// The name of its derivative.
pub const DERIVATIVE_NAME: &str = "der(dummy_state)";

/// References of the state and of its derivative: behind those of time and event indicator, which
/// FMI 3.0 has.
pub fn state_references(unit: &Unit) -> [usize; 2] {
    [2, 3].map(|place| unit.variables.len() + place)
}

/// The unit of a GUID or instantiation token, and whether it is with a dummy state.
pub fn unit_of<'u>(identity: &str, units: &[&'u Unit]) -> Option<(&'u Unit, bool)> {
    let (guid, has_state) = match identity.strip_suffix(WITH_STATE) {
        Some(guid) => (guid, true),
        None => (identity, false),
    };
    units.iter().find(|unit| unit.guid == guid).map(|unit| (*unit, has_state))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::variables::{WHEEL, WHEELSET};

    #[test]
    fn the_identity_tells_unit_and_variant() {
        let found = |identity: &str| {
            unit_of(identity, &[&WHEEL, &WHEELSET]).map(|(unit, has_state)| (unit.guid, has_state))
        };
        assert_eq!(found(WHEELSET.guid), Some((WHEELSET.guid, false)));
        assert_eq!(found(&format!("{}{WITH_STATE}", WHEEL.guid)), Some((WHEEL.guid, true)));
        assert_eq!((found(""), found(WITH_STATE)), (None, None));
    }
}
