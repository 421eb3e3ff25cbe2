//! Units with the user's files and values inside.

use std::path::PathBuf;

use pyo3::prelude::*;
use wheelrail::pack::{Pack, PackError};

use crate::errors::{bad_value, refused, unknown};

/// Packs `source` as `target` with profiles of wheel and rail, start values, name and description.
#[pyfunction]
#[allow(clippy::too_many_arguments, reason = "Python names them")]
pub fn pack(
    py: Python<'_>,
    source: PathBuf,
    target: PathBuf,
    profiles: [Option<String>; 2],
    settings: Vec<(String, String)>,
    name: &str,
    description: &str,
    dummy_state: bool,
) -> PyResult<()> {
    let packed = || -> Result<(), PackError> {
        let mut pack = Pack::open(&source)?;
        let [wheel, rail] = &profiles;
        if let Some(wheel) = wheel {
            pack.set_wheel(wheel)?;
        }
        if let Some(rail) = rail {
            pack.set_rail(rail)?;
        }
        for (name, value) in &settings {
            pack.set(name, value)?;
        }
        pack.set_name(name)?;
        pack.set_description(description);
        if dummy_state {
            pack.add_dummy_state();
        }
        pack.write(&target)
    };
    py.detach(packed).map_err(|error| match &error {
        PackError::Contact(problem) => refused(py, problem, None),
        PackError::Unknown(problem) => unknown(py, problem),
        PackError::NoFile { name, .. }
        | PackError::Unreadable { name, .. }
        | PackError::Lines { name }
        | PackError::NotDescribed { name } => bad_value(py, name, &error.to_string()),
        PackError::BadName { .. } => bad_value(py, "name", &error.to_string()),
        PackError::Source { .. } | PackError::Foreign { .. } | PackError::StartFile { .. } => {
            bad_value(py, "source", &error.to_string())
        }
        _ => pyo3::exceptions::PyOSError::new_err(error.to_string()),
    })
}
