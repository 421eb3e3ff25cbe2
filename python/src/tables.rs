//! The variables of both units for Python.

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use wheelrail::variables::{Causality, Kind, Value, WHEEL, WHEELSET};

/// The variables of "WheelRail" or "WheelSet": a list of dicts, places are FMI references.
#[pyfunction]
pub fn variables<'py>(py: Python<'py>, unit: &str) -> PyResult<Bound<'py, PyList>> {
    let unit = if unit == WHEELSET.identifier { &WHEELSET } else { &WHEEL };
    let list = PyList::empty(py);
    for variable in unit.variables {
        let row = PyDict::new(py);
        row.set_item("name", variable.name)?;
        row.set_item("description", variable.description)?;
        row.set_item("unit", variable.unit)?;
        let (kind, items) = match variable.kind {
            Kind::Real => ("real", None),
            Kind::Integer => ("integer", None),
            Kind::Boolean => ("boolean", None),
            Kind::Text => ("text", None),
            Kind::Enumeration(e) => {
                ("enumeration", Some(e.items.iter().map(|item| item.name).collect::<Vec<_>>()))
            }
        };
        row.set_item("kind", kind)?;
        row.set_item("items", items)?;
        let causality = match variable.causality {
            Causality::Input => "input",
            Causality::Parameter => "parameter",
            Causality::CalculatedParameter => "calculated",
            Causality::Output => "output",
        };
        row.set_item("causality", causality)?;
        row.set_item("min", variable.min)?;
        row.set_item("max", variable.max)?;
        match (variable.start, variable.kind) {
            (Some(Value::Integer(value)), Kind::Enumeration(e)) => {
                row.set_item("start", e.item(value).map(|item| item.name))?;
            }
            (Some(Value::Real(value)), _) => row.set_item("start", value)?,
            (Some(Value::Integer(value)), _) => row.set_item("start", value)?,
            (Some(Value::Boolean(value)), _) => row.set_item("start", value)?,
            (Some(Value::Text(value)), _) => row.set_item("start", value)?,
            (None, _) => row.set_item("start", py.None())?,
        }
        row.set_item("on_request", variable.on_request)?;
        list.append(row)?;
    }
    Ok(list)
}
