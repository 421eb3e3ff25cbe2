//! Files that the rows of a table name, and that no result may replace.

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use anyhow::Result;
use wheelrail::element::Parameters;

use crate::output;

/// The names so far, each looked at once, and the results that may not go there.
#[derive(Clone, Debug)]
pub struct NamedFiles<'a> {
    folder: PathBuf,
    results: Vec<Option<&'a Path>>,
    names: HashSet<String>,
}

impl<'a> NamedFiles<'a> {
    /// Names are relative to `folder`.
    pub fn new(folder: PathBuf, results: &[Option<&'a Path>]) -> Self {
        Self { folder, results: results.to_vec(), names: HashSet::new() }
    }

    /// Checks that no result has the name of a file that an element of `parameters` reads.
    pub fn check(&mut self, parameters: &Parameters) -> Result<()> {
        let rails = parameters.rails.iter().flat_map(|r| [&r.profile, &r.corrugation.file]);
        let wheel = [&parameters.wheel.profile, &parameters.wheel.out_of_round.file];
        let friction = [&parameters.friction_profile];
        for name in wheel.into_iter().chain(rails).chain(friction) {
            if self.names.contains(name) {
                continue;
            }
            self.names.insert(name.clone());
            let file = self.folder.join(name);
            // Built-in profiles have names too.
            if file.is_file() {
                output::check_names([file.as_path()], self.results.iter().copied())?;
            }
        }
        Ok(())
    }
}
