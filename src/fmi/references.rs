//! Variables by their references, and why one is refused.

use super::error::FmiError;
use super::interface::Interface;
use super::types::ValueReference;
use crate::variables::{Kind, Unit, Value, Variable, check};

#[inline]
pub(super) fn variable(
    unit: &'static Unit,
    reference: ValueReference,
) -> Result<&'static Variable, FmiError> {
    let last = unit.variables.len() - 1;
    unit.variables.get(reference as usize).ok_or(FmiError::UnknownReference { reference, last })
}

/// Why a variable is not read: there is none, or it has another type.
#[cold]
pub(super) fn unreadable(
    interface: Interface,
    unit: &'static Unit,
    reference: ValueReference,
) -> FmiError {
    variable(unit, reference).map_or_else(|error| error, |v| wrong_type(interface, v))
}

/// Why a value is not accepted; after initialization, if there is nothing else against it.
#[cold]
pub(super) fn refusal(
    interface: Interface,
    unit: &'static Unit,
    reference: ValueReference,
    value: Value,
) -> FmiError {
    let variable = match variable(unit, reference) {
        Ok(variable) => variable,
        Err(error) => return error,
    };
    let belongs = match value {
        Value::Real(_) => is_real(variable.kind),
        Value::Integer(_) => is_integer(variable.kind),
        Value::Boolean(_) => is_boolean(variable.kind),
        Value::Text(_) => is_text(variable.kind),
    };
    if !belongs {
        return wrong_type(interface, variable);
    }
    let fixed = |()| FmiError::Fixed { name: variable.name, interface };
    check(variable, value).map_or_else(FmiError::from, fixed)
}

pub(super) fn is_real(kind: Kind) -> bool {
    matches!(kind, Kind::Real)
}

pub(super) fn is_integer(kind: Kind) -> bool {
    matches!(kind, Kind::Integer | Kind::Enumeration(_))
}

pub(super) fn is_boolean(kind: Kind) -> bool {
    matches!(kind, Kind::Boolean)
}

pub(super) fn is_text(kind: Kind) -> bool {
    matches!(kind, Kind::Text)
}

#[cold]
pub(super) fn wrong_type(interface: Interface, variable: &Variable) -> FmiError {
    let kind = interface.type_name(variable.kind);
    FmiError::WrongType { name: interface.name(variable), kind }
}
