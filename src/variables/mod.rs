//! The variables of wheel and wheelset by name: what the FMI interface and the command line have in common.
//!
//! `modelDescription/variables.toml` is the only declaration of what a wheel has, and `wheelset.toml` beside it says what of that a
//! wheelset has on each side and what only once. From them come the tables [`WHEEL`] and [`WHEELSET`], the typed access of
//! [`ValuesOf`], the GUIDs and the model descriptions of the FMUs, so that they cannot disagree.

mod spelling;
mod table;
mod text;
mod values;

use crate::element::Element;
use crate::wheelset::Wheelset;

pub use table::{LOG_CATEGORIES, VARIABLES, WHEEL, WHEELSET};
pub use values::{Coupling, Described, ValuesOf, check};
pub(crate) use values::{admits, shortened};

/// The values of a wheel.
pub type Values = ValuesOf<Element>;
/// The values of a wheelset.
pub type WheelsetValues = ValuesOf<Wheelset>;
/// Identifies the description of the wheel unit.
pub const GUID: &str = WHEEL.guid;

/// Who sets a variable, and when.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Causality {
    /// Set by the host at any time.
    Input,
    /// Set by the host before the element is initialized, then fixed.
    Parameter,
    /// Follows from parameters and starting inputs at initialization.
    CalculatedParameter,
    /// Computed by the element.
    Output,
}

/// Type of a variable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// A number.
    Real,
    /// A whole number.
    Integer,
    /// True or false.
    Boolean,
    /// A text, such as a profile name.
    Text,
    /// A choice; its value is that of the item.
    Enumeration(&'static Enumeration),
}

/// A set of choices.
#[derive(Debug, PartialEq)]
pub struct Enumeration {
    /// Name of the type.
    pub name: &'static str,
    /// What is chosen.
    pub description: &'static str,
    /// The choices.
    pub items: &'static [Item],
}

impl Enumeration {
    /// The item of that value.
    #[must_use]
    pub fn item(&self, value: i32) -> Option<&'static Item> {
        self.items.iter().find(|i| i.value == value)
    }
}

/// One choice.
#[derive(Debug, PartialEq, Eq)]
pub struct Item {
    /// Name, as used in text files.
    pub name: &'static str,
    /// Value, as used by FMI; fixed for good.
    pub value: i32,
    /// What is chosen with it.
    pub description: &'static str,
}

/// A value of any type; enumerations are integers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value<'a> {
    /// Of a real variable, in its unit.
    Real(f64),
    /// Of an integer variable or an enumeration.
    Integer(i32),
    /// Of a boolean variable.
    Boolean(bool),
    /// Of a text variable.
    Text(&'a str),
}

/// What is known about a variable.
#[derive(Debug, PartialEq)]
pub struct Variable {
    /// Name, such as `wheel.force.z`.
    pub name: &'static str,
    /// The quantity, its frame and sign.
    pub description: &'static str,
    /// Place in the table of its unit, which is also the FMI value reference.
    pub reference: usize,
    /// Type.
    pub kind: Kind,
    /// Who sets it.
    pub causality: Causality,
    /// Unit; empty for pure numbers and for what is not a number.
    pub unit: &'static str,
    /// Smallest admitted value.
    pub min: Option<f64>,
    /// Largest admitted value.
    pub max: Option<f64>,
    /// Size of a change that matters; 1 where none is declared.
    pub nominal: f64,
    /// Start value of inputs and parameters.
    pub start: Option<Value<'static>>,
    /// References of the inputs and parameters on which an output depends.
    pub dependencies: &'static [usize],
    /// Whether it is computed only when it is read.
    pub on_request: bool,
    /// Whether it counts what evaluations met with, whatever the time.
    pub is_counter: bool,
    /// What is admitted, in words.
    pub allowed: &'static str,
    /// Name of the array of FMI 3.0 of which it is an element.
    pub array: Option<&'static str>,
    /// Of the variable of FMI 3.0 with this reference the places of its elements: itself alone, or all of the array that it begins; none
    /// within an array.
    pub elements: &'static [u32],
}

impl Variable {
    /// Whether it is an input or a parameter.
    #[must_use]
    pub fn is_settable(&self) -> bool {
        matches!(self.causality, Causality::Input | Causality::Parameter)
    }
}

/// A unit: what one archive stands for.
#[derive(Debug)]
pub struct Unit {
    /// `modelIdentifier`: name of the archive and of the library in it.
    pub identifier: &'static str,
    /// Identifies the description from which library and XML were made: its hash.
    pub guid: &'static str,
    /// Every variable; its place is its FMI value reference.
    pub variables: &'static [Variable],
}

impl Unit {
    /// The variable of that name.
    ///
    /// # Errors
    /// With the nearest name if there is none.
    pub fn find(&self, name: &str) -> Result<&'static Variable, UnknownVariable> {
        self.variables.iter().find(|v| v.name == name).ok_or_else(|| {
            let names = self.variables.iter().map(|v| v.name);
            // No two names differ by capitals alone.
            let small = name.to_lowercase();
            let nearest = names.min_by_key(|n| spelling::distance(&small, n));
            UnknownVariable { name: name.into(), nearest: nearest.unwrap_or_default() }
        })
    }
}

/// A name that no variable has.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there is no variable \"{name}\"; the nearest name is {nearest}")]
#[non_exhaustive]
pub struct UnknownVariable {
    /// The name asked for.
    pub name: String,
    /// The name of a variable that differs least from it, whether letters are large or small.
    pub nearest: &'static str,
}

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

    /// Messages of the elements name variables of a wheel; those of a wheelset must be ones that it has.
    #[test]
    fn a_wheelset_has_on_each_side_or_once_what_a_wheel_has() {
        // What a wheelset has in its own way: the motion of its centre, two sides.
        let own = |name: &str| {
            let coordinate = name.strip_prefix("wheel.").is_some_and(|c| {
                WHEELSET.variables.iter().any(|v| v.name == format!("wheelset.{c}"))
            }) && find(name).unwrap().causality == Causality::Input;
            coordinate || name == "side"
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
