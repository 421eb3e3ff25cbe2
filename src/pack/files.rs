//! Files that go into the resources, and what they are called there.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Component, Path, PathBuf};

use super::error::PackError;
use crate::error::ContactError;
use crate::geometry::profiles::profile::ProfileKind;
use crate::geometry::profiles::standard_profiles::built_in;
use crate::io::named_file::{content, text};
use crate::io::number;
use crate::variables::Variable;

/// Where a unit looks for its files, in the archive.
pub const FOLDER: &str = "resources/profiles/";

/// The files of a unit by their paths below [`FOLDER`].
pub struct Files {
    all: BTreeMap<String, Vec<u8>>,
    /// Which of them the user has brought.
    taken: BTreeSet<String>,
}

/// What a variable names.
enum Named {
    /// A profile, or a list of sections.
    Profile(ProfileKind),
    /// A wave, friction, irregularities.
    Table,
    /// No file that is read.
    Nothing,
}

impl Named {
    fn by(variable: &Variable) -> Self {
        let name = variable.name;
        let last = name.rsplit('.').next().unwrap_or_default();
        // Worn profiles are written.
        if name.contains("wear.") {
            Self::Nothing
        } else if name.ends_with("wheel.profile") {
            Self::Profile(ProfileKind::Wheel)
        } else if name.contains("rail[") && last == "profile" {
            Self::Profile(ProfileKind::Rail)
        } else if last == "file" || name.ends_with("friction.profile") {
            Self::Table
        } else {
            Self::Nothing
        }
    }
}

impl Files {
    /// Those that the source has.
    pub fn new(all: BTreeMap<String, Vec<u8>>) -> Self {
        Self { all, taken: BTreeSet::new() }
    }

    /// Those that the user has brought, with their contents.
    pub fn taken(&self) -> impl Iterator<Item = (&str, &[u8])> + Clone {
        self.taken.iter().map(|name| (name.as_str(), self.all[name].as_slice()))
    }

    /// The entries that files of the user make in the archive.
    pub fn entries(&self) -> BTreeMap<String, Vec<u8>> {
        self.taken().map(|(name, bytes)| (format!("{FOLDER}{name}"), bytes.to_vec())).collect()
    }

    /// All of them in a folder of their own.
    pub fn unpacked(&self) -> std::io::Result<tempfile::TempDir> {
        let folder = tempfile::tempdir()?;
        for (name, bytes) in &self.all {
            let path = folder.path().join(name);
            fs::create_dir_all(path.parent().unwrap_or(folder.path()))?;
            fs::write(path, bytes)?;
        }
        Ok(folder)
    }

    /// Takes what a variable names, if that is a file; gives what it is to be set to.
    pub fn take(&mut self, variable: &Variable, value: &str) -> Result<String, PackError> {
        let is_list = match Named::by(variable) {
            Named::Nothing => return Ok(value.into()),
            Named::Table if value.is_empty() => return Ok(value.into()),
            Named::Table => false,
            Named::Profile(kind) => match built_in(value, kind) {
                Ok(Some(_)) => return Ok(value.into()),
                Ok(None) => true,
                Err(problem) => {
                    let name = variable.name.into();
                    return Err(ContactError::Profile { name, problem }.into());
                }
            },
        };
        let path = Path::new(value);
        if !path.exists() {
            if self.all.contains_key(value) {
                return Ok(value.into());
            }
            return Err(PackError::NoFile {
                name: variable.name,
                value: value.into(),
                looked_for: looked_for(path),
            });
        }
        let unreadable = |reason: String| PackError::Unreadable {
            name: variable.name,
            value: value.into(),
            reason,
        };
        let bytes = content(path).map_err(unreadable)?;
        let file_name = path.file_name().map(|name| name.to_string_lossy().into_owned());
        let file_name = file_name.ok_or_else(|| unreadable("it has no name".into()))?;
        let sections = if is_list { sections(path, &bytes) } else { Vec::new() };
        if sections.is_empty() {
            return Ok(self.put("", &file_name, bytes));
        }
        // A list has a folder of its own, in which its sections lie as they do beside it.
        let folder = self.free_folder(path, &bytes);
        let mut text = String::from_utf8_lossy(&bytes).into_owned();
        for section in sections {
            let from = path.parent().unwrap_or(Path::new("")).join(&section);
            let bytes =
                content(&from).map_err(|e| unreadable(format!("section {section}: {e}")))?;
            if lies_beside(&section) {
                self.insert(format!("{folder}/{section}"), bytes);
            } else {
                let name = from.file_name().map(|name| name.to_string_lossy().into_owned());
                let placed = self.put(&format!("{folder}/"), &name.unwrap_or_default(), bytes);
                let within = placed.strip_prefix(&format!("{folder}/")).unwrap_or(&placed);
                text = text.replace(&section, within);
            }
        }
        let name = format!("{folder}/{file_name}");
        self.insert(name.clone(), text.into_bytes());
        Ok(name)
    }

    /// Puts a file below `folder`, under another name where another file has its own; gives its path.
    fn put(&mut self, folder: &str, name: &str, bytes: Vec<u8>) -> String {
        let names = (1..).map(|n| match n {
            1 => format!("{folder}{name}"),
            n => format!("{folder}{n}-{name}"),
        });
        let is_free = |name: &String| self.all.get(name).is_none_or(|other| *other == bytes);
        // Endless, so that one is found.
        let name = names.into_iter().find(is_free).unwrap_or_default();
        self.insert(name.clone(), bytes);
        name
    }

    fn insert(&mut self, name: String, bytes: Vec<u8>) {
        self.taken.insert(name.clone());
        self.all.insert(name, bytes);
    }

    /// A folder for a list: that of the same list, or one that is not there.
    fn free_folder(&self, path: &Path, bytes: &[u8]) -> String {
        let text = |part: Option<&std::ffi::OsStr>| {
            part.map(|part| part.to_string_lossy().into_owned()).unwrap_or_default()
        };
        let (stem, name) = (text(path.file_stem()), text(path.file_name()));
        let is_used = |folder: &str| self.all.keys().any(|k| k.starts_with(&format!("{folder}/")));
        let same = |folder: &str| {
            self.all.get(&format!("{folder}/{name}")).is_some_and(|other| other == bytes)
        };
        let mut names = (1..).map(|n| if n == 1 { stem.clone() } else { format!("{n}-{stem}") });
        names.find(|folder| !is_used(folder) || same(folder)).unwrap_or_default()
    }
}

fn looked_for(path: &Path) -> String {
    let here = std::env::current_dir().unwrap_or_default();
    format!("{}, and {FOLDER}{} of the source", here.join(path).display(), path.display())
}

/// Whether a section lies in the folder of its list or below.
fn lies_beside(section: &str) -> bool {
    let mut parts = Path::new(section).components();
    parts.all(|part| matches!(part, Component::Normal(_) | Component::CurDir))
}

/// The files that a list of sections names, in their order: slices, or a table with a heading. What a
/// file names that cannot be found is for the reader of lists to refuse.
fn sections(path: &Path, bytes: &[u8]) -> Vec<String> {
    let text = text(bytes);
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or_default().to_lowercase();
    let mut lines = text.lines().map(str::trim).filter(|l| !l.is_empty() && !l.starts_with('#'));
    let heading = lines.next().unwrap_or_default().to_lowercase();
    let has_heading = heading.contains("profile")
        && (heading.contains("station_m") || heading.contains("angle_deg"));
    if !(has_heading || ["slcs", "slcw"].contains(&&*extension)) {
        return Vec::new();
    }
    let folder: PathBuf = path.parent().map(Path::to_path_buf).unwrap_or_default();
    let mut found: Vec<String> = Vec::new();
    for word in text.lines().flat_map(words) {
        let is_file = number(&word).is_none() && folder.join(&word).is_file();
        if is_file && !found.contains(&word) {
            found.push(word);
        }
    }
    found
}

/// The words of a line, parted by blanks and commas or in quotes.
fn words(line: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut quote = None;
    for letter in line.chars() {
        if quote == Some(letter) {
            quote = None;
        } else if quote.is_none() && (letter == '\'' || letter == '"') {
            quote = Some(letter);
        } else if quote.is_none() && (letter.is_whitespace() || ",;".contains(letter)) {
            words.push(String::new());
        } else if let Some(word) = words.last_mut() {
            word.push(letter);
        }
    }
    // A table may have blanks in a name without quotes.
    words.extend(line.split([',', ';', '\t']).skip(1).map(|cell| cell.trim().to_owned()));
    words.retain(|word| !word.is_empty());
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_in_quotes_and_cells_are_words() {
        assert_eq!(words("0.5 'my file.prr' % first"), ["0.5", "my file.prr", "%", "first"]);
        assert!(words("0.5, my file.prr").contains(&"my file.prr".to_owned()));
    }

    #[test]
    fn a_section_beside_its_list_stays_there() {
        for (name, beside) in [("a.prr", true), ("b/a.prr", true), ("../a.prr", false)] {
            assert_eq!(lies_beside(name), beside, "{name}");
        }
    }
}
