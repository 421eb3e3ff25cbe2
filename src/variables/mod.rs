//! The variables of wheel and wheelset by name: what the FMI interface and the command line have in
//! common.
//!
//! `modelDescription/variables.toml` is the only declaration of what a wheel has, and
//! `wheelset.toml` beside it says what of that a wheelset has on each side and what only once. From
//! them come the tables [`WHEEL`] and [`WHEELSET`], the typed access of [`ValuesOf`], the GUIDs and
//! the model descriptions of the FMUs, so that they cannot disagree.

mod dummy_state;
mod spelling;
mod start_file;
mod table;
mod text;
mod values;
mod variable;

use crate::element::Element;
use crate::wheelset::Wheelset;

pub use dummy_state::{DERIVATIVE_NAME, STATE_NAME, WITH_STATE, state_references, unit_of};
pub use start_file::{START_FILE, StartFileError};
pub use table::{LOG_CATEGORIES, VARIABLES, WHEEL, WHEELSET};
pub use values::{Coupling, Described, StepLimits, ValuesOf, check};
pub(crate) use values::{admits, shortened};
pub use variable::{Causality, Enumeration, Item, Kind, Unit, UnknownVariable, Value, Variable};

/// The values of a wheel.
pub type Values = ValuesOf<Element>;
/// The values of a wheelset.
pub type WheelsetValues = ValuesOf<Wheelset>;
/// Identifies the description of the wheel unit.
pub const GUID: &str = WHEEL.guid;

/// The variable of that name of a wheel.
///
/// # Errors
/// With the nearest name if there is none.
pub fn find(name: &str) -> Result<&'static Variable, UnknownVariable> {
    WHEEL.find(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNITS: [&Unit; 2] = [&WHEEL, &WHEELSET];

    fn all() -> impl Iterator<Item = &'static Variable> {
        UNITS.into_iter().flat_map(|unit| unit.variables)
    }

    #[test]
    fn names_are_unique_and_references_are_places() {
        for unit in UNITS {
            for (place, v) in unit.variables.iter().enumerate() {
                assert_eq!(v.reference, place);
                assert_eq!(unit.find(v.name).unwrap(), v);
            }
        }
        assert_ne!(WHEEL.guid, WHEELSET.guid);
    }

    #[test]
    fn each_variable_is_an_element_of_one_variable_of_fmi_3() {
        for unit in UNITS {
            let mut places: Vec<u32> =
                unit.variables.iter().flat_map(|v| v.elements).copied().collect();
            places.sort_unstable();
            assert!(places.into_iter().eq(0..unit.variables.len() as u32));
            for first in unit.variables.iter().filter(|v| !v.elements.is_empty()) {
                assert_eq!(first.elements[0] as usize, first.reference);
                for (number, &place) in first.elements.iter().enumerate() {
                    let element = &unit.variables[place as usize];
                    let Some(array) = first.array else {
                        assert_eq!(first.elements.len(), 1, "{}", first.name);
                        continue;
                    };
                    assert_eq!(element.array, Some(array));
                    assert_eq!(element.name.replace(&format!("[{}]", number + 1), ""), array);
                    assert_eq!((element.kind, element.unit), (first.kind, first.unit));
                    // Arrays are read alone.
                    assert_eq!(element.causality, Causality::Output, "{array}");
                }
            }
        }
        let arrays = |unit: &Unit| {
            unit.variables
                .iter()
                .filter(|v| v.elements.len() > 1)
                .map(|v| v.array.unwrap())
                .collect()
        };
        let (wheel, wheelset): (Vec<&str>, Vec<&str>) = (arrays(&WHEEL), arrays(&WHEELSET));
        assert!(wheel.contains(&"patch.normal_force") && wheel.contains(&"patch.rail"));
        assert_eq!(wheelset.len(), 2 * wheel.len());
        assert!(wheelset.contains(&"left.patch.creepage.spin"));
    }

    #[test]
    fn start_values_lie_in_their_range_and_outputs_have_none() {
        for v in all() {
            assert_eq!(v.start.is_some(), v.is_settable(), "{}", v.name);
            let start = match v.start {
                Some(Value::Real(start)) => start,
                Some(Value::Integer(start)) => f64::from(start),
                _ => continue,
            };
            assert!(v.min.is_none_or(|m| m <= start), "{}", v.name);
            assert!(v.max.is_none_or(|m| m >= start), "{}", v.name);
            assert!(v.min.zip(v.max).is_none_or(|(min, max)| min < max), "{}", v.name);
            if let Kind::Enumeration(e) = v.kind {
                assert!(e.item(start as i32).is_some(), "{}", v.name);
            }
        }
    }

    #[test]
    fn outputs_depend_on_inputs_and_parameters_only() {
        for unit in UNITS {
            for v in unit.variables {
                assert_eq!(v.dependencies.is_empty(), v.is_settable(), "{}", v.name);
                let settable = |&d: &usize| unit.variables[d].is_settable();
                assert!(v.dependencies.iter().all(settable), "{}", v.name);
                assert!(v.dependencies.windows(2).all(|d| d[0] < d[1]), "{}", v.name);
            }
        }
    }

    /// Messages of the elements name variables of a wheel; those of a wheelset must be ones that it
    /// has.
    #[test]
    fn a_wheelset_has_on_each_side_or_once_what_a_wheel_has() {
        // What a wheelset has in its own way: the motion of its centre, two sides, where they are.
        let own = |name: &str| {
            let coordinate = name.strip_prefix("wheel.").is_some_and(|c| {
                WHEELSET.variables.iter().any(|v| v.name == format!("wheelset.{c}"))
            }) && find(name).unwrap().causality == Causality::Input;
            coordinate || ["side", "coupling.lever"].contains(&name)
        };
        for v in VARIABLES.iter().filter(|v| !own(v.name)) {
            for side in crate::wheelset::SIDES {
                let name = if v.is_settable() || v.name.starts_with("coupling.") {
                    crate::wheelset::name_on_side(v.name, side)
                } else {
                    format!("{side}.{}", v.name)
                };
                let of_wheelset = WHEELSET.find(&name).unwrap_or_else(|e| panic!("{e}"));
                assert_eq!((of_wheelset.kind, of_wheelset.unit), (v.kind, v.unit), "{name}");
                assert_eq!((of_wheelset.min, of_wheelset.max), (v.min, v.max), "{name}");
            }
        }
    }

    #[test]
    fn an_unknown_name_is_answered_with_the_nearest_one() {
        let error = find("wheel.forcez").unwrap_err();
        assert_eq!(error.nearest, "wheel.force.z");
        for (name, nearest) in
            [("Wheel.Y", "wheel.y"), ("WHEEL.LOAD", "wheel.load"), ("WheelYaw", "wheel.yaw")]
        {
            assert_eq!(find(name).unwrap_err().nearest, nearest);
        }
        assert!(find("patch[9].area").unwrap_err().nearest.ends_with("].area"));
        assert_eq!(WHEELSET.find("left.wheel.profil").unwrap_err().nearest, "left.wheel.profile");
    }
}
