//! The files of worn profiles: checked when a run begins, written when it ends.

use std::path::{Path, PathBuf};

use super::error::FmiError;
use super::instance::Instance;
use super::life_cycle::Purpose;
use crate::element::Parameters;
use crate::element::parameters::WearModel;
use crate::geometry::profiles::profile::ProfileKind;
use crate::io::{can_be_written, full_name, profile_file, save_profile};
use crate::variables::{Described, shortened};

/// Names of the parameters of one wheel that name a file for a rail, and of those that name the
/// profile it starts with.
const RAIL_FILES: [(&str, &str); 2] =
    [("wear.rail[1].file", "rail[1].profile"), ("wear.rail[2].file", "rail[2].profile")];

/// A parameter and the file that it names.
type Named<F> = (String, F);

impl<S: Described> Instance<S> {
    /// Asks the system whether the files of worn profiles can be written, and sees to it that each
    /// has a name of its own, other than those of the profiles that are read.
    pub(super) fn check_worn_files(&self) -> Result<(), FmiError> {
        if self.purpose == Purpose::ModelExchange {
            return Ok(());
        }
        let identity = |path: &Path| full_name(path).unwrap_or_else(|| path.into());
        let (written, read) = self.worn_files();
        let mut known: Vec<Named<PathBuf>> =
            read.into_iter().map(|(name, path)| (name, identity(&path))).collect();
        for (name, file) in written {
            let path = Path::new(&file);
            let own = identity(path);
            if let Some((other, _)) = known.iter().find(|(_, path)| *path == own) {
                let allowed = format!("a file of its own: {other} names this one too");
                return Err(FmiError::unfit(&name, &shortened(&file), &allowed));
            }
            can_be_written(&name, path)?;
            known.push((name, own));
        }
        Ok(())
    }

    /// Parameters and files: of worn profiles that the run is to write, and of profiles that it has
    /// read.
    fn worn_files(&self) -> (Vec<Named<String>>, Vec<Named<PathBuf>>) {
        let (mut written, mut read) = (Vec::new(), Vec::new());
        let all = S::parameters_of_elements(&self.values.parameters);
        for (prefix, parameters) in S::PREFIXES.iter().zip(all) {
            let mut add = |(file_name, file): (&str, &String), (name, profile), kind| {
                if parameters.wear.model != WearModel::Off && !file.is_empty() {
                    written.push((format!("{prefix}{file_name}"), file.clone()));
                }
                let found = profile_file(profile, kind, &self.profile_folders);
                read.extend(found.map(|path| (format!("{prefix}{name}"), path)));
            };
            let Parameters { wheel, rails, .. } = parameters;
            add(
                ("wear.wheel.file", &wheel.worn_file),
                ("wheel.profile", &wheel.profile),
                ProfileKind::Wheel,
            );
            for (rail, (file_name, name)) in
                rails.iter().zip(RAIL_FILES).filter(|(rail, _)| rail.enabled)
            {
                add((file_name, &rail.worn_file), (name, &rail.profile), ProfileKind::Rail);
            }
        }
        (written, read)
    }

    /// Writes the worn profiles that the parameters ask for, where bodies wear.
    pub(super) fn write_worn_profiles(&self) -> Result<(), FmiError> {
        let Some(element) = &self.element else { return Ok(()) };
        let all = S::parameters_of_elements(&self.values.parameters);
        for ((prefix, parameters), element) in S::PREFIXES.iter().zip(all).zip(element.elements()) {
            if parameters.wear.model == WearModel::Off {
                continue;
            }
            let worn_wheel = ("wear.wheel.file", &parameters.wheel.worn_file, element.worn_wheel());
            let worn_rails = RAIL_FILES.iter().enumerate().map(|(k, (name, _))| {
                (*name, &parameters.rails[k].worn_file, element.worn_rail(k))
            });
            for (name, file, profile) in std::iter::once(worn_wheel).chain(worn_rails) {
                if let (false, Some(profile)) = (file.is_empty(), profile) {
                    save_profile(&format!("{prefix}{name}"), Path::new(file), &profile)?;
                }
            }
        }
        Ok(())
    }
}
