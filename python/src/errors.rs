//! What the crate refuses, as exceptions of the package.

use pyo3::prelude::*;
use pyo3::types::PyDict;
use wheelrail::error::ContactError;
use wheelrail::variables::UnknownVariable;

/// The exception for a refusal; `row` is that of the arrays, if it is about one.
pub fn refused(py: Python<'_>, error: &ContactError, row: Option<usize>) -> PyErr {
    let (class, name) = match error {
        ContactError::BadValue { name, .. } | ContactError::BadText { name, .. } => {
            ("BadValueError", Some(name.as_str()))
        }
        ContactError::Profile { name, .. } => ("ProfileError", Some(name.as_str())),
        ContactError::NoDerivative { name, .. } => ("NoDerivativeError", *name),
        _ => ("ContactError", None),
    };
    raised(py, class, &error.to_string(), name, row)
}

/// The exception for a name that there is not.
pub fn unknown(py: Python<'_>, error: &UnknownVariable) -> PyErr {
    raised(py, "UnknownVariableError", &error.to_string(), Some(&error.name), None)
}

/// A value that is refused before it reaches the crate.
pub fn bad_value(py: Python<'_>, variable: &str, message: &str) -> PyErr {
    raised(py, "BadValueError", message, Some(variable), None)
}

fn raised(
    py: Python<'_>,
    class: &str,
    message: &str,
    variable: Option<&str>,
    row: Option<usize>,
) -> PyErr {
    let made = || {
        let keywords = PyDict::new(py);
        keywords.set_item("variable", variable)?;
        keywords.set_item("row", row)?;
        py.import("wheelrail.errors")?.getattr(class)?.call((message,), Some(&keywords))
    };
    match made() {
        Ok(exception) => PyErr::from_value(exception),
        Err(error) => error,
    }
}
