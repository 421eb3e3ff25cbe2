//! Start values beside a packed unit: a host that reads its description sets none of them again, so
//! that the library has to know them too.

use std::fs;
use std::path::Path;

use super::error::FmiError;
use crate::variables::{Described, START_FILE, ValuesOf};

/// Largest file that is read [bytes].
const LARGEST: u64 = 1 << 20;

/// The start file of a unit, if it has one.
#[derive(Debug, Default)]
pub struct Starts {
    file: String,
    text: String,
}

impl Starts {
    /// That in the folder of resources.
    pub fn beside(resources: Option<&Path>) -> Result<Self, FmiError> {
        let Some(path) = resources.map(|folder| folder.join(START_FILE)).filter(|p| p.exists())
        else {
            return Ok(Self::default());
        };
        let file = path.display().to_string();
        let bad = |problem: String| FmiError::BadStarts { file: file.clone(), problem };
        let length = fs::metadata(&path).map_err(|e| bad(e.to_string()))?.len();
        if length > LARGEST {
            return Err(bad(format!("{length} bytes are too many for start values")));
        }
        let text = fs::read_to_string(&path).map_err(|e| bad(e.to_string()))?;
        Ok(Self { file, text })
    }

    /// The values of a unit.
    pub fn values<S: Described>(&self) -> Result<ValuesOf<S>, FmiError> {
        ValuesOf::from_start_file(&self.text).map_err(|problem| FmiError::BadStarts {
            file: self.file.clone(),
            problem: problem.to_string(),
        })
    }
}
