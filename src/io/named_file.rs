//! Files that parameters name: where they lie, what they hold, and by what they are known.

use std::fs;
use std::path::{Path, PathBuf};

use crate::error::ContactError;

/// Largest file that is read [bytes]; a million points stay below it.
const LARGEST_FILE: u64 = 64 << 20;

/// The file called `name`: an absolute path, or the first of `folders` that has it; else where it
/// was looked for.
pub(super) fn find(name: &str, folders: &[PathBuf]) -> Result<PathBuf, String> {
    let path = Path::new(name);
    let candidates: Vec<PathBuf> = if name.trim().is_empty() {
        Vec::new()
    } else if path.is_absolute() {
        vec![path.into()]
    } else {
        folders.iter().map(|folder| folder.join(path)).collect()
    };
    candidates.iter().find(|candidate| candidate.exists()).cloned().ok_or_else(|| {
        let looked: Vec<String> = candidates.iter().map(|c| c.display().to_string()).collect();
        if looked.is_empty() { "nothing".into() } else { looked.join(", ") }
    })
}

/// The content of a file, or why it is not read.
pub(crate) fn content(path: &Path) -> Result<Vec<u8>, String> {
    let about = fs::metadata(path).map_err(|e| e.to_string())?;
    if !about.is_file() {
        return Err("it is not a file".into());
    }
    if about.len() > LARGEST_FILE {
        return Err(format!("{} bytes are too many, more than {LARGEST_FILE}", about.len()));
    }
    fs::read(path).map_err(|e| e.to_string())
}

/// The text of a file. Comments may hold letters of any encoding; numbers do not.
pub(crate) fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).trim_start_matches('\u{feff}').to_owned()
}

/// What `parse` makes of the text of the file that the parameter `parameter` names `name`: an
/// absolute path or one that is looked for in `folders`.
///
/// # Errors
/// The parameter, the file and what is wrong with it.
pub(super) fn parsed<T>(
    parameter: &str,
    name: &str,
    folders: &[PathBuf],
    parse: impl FnOnce(&str) -> Result<T, String>,
) -> Result<T, ContactError> {
    let read = || {
        let found = find(name, folders)
            .map_err(|looked| format!("a file that exists (looked for {looked})"))?;
        if found.is_dir() {
            return Err(format!("a file; {} is a folder", found.display()));
        }
        let bytes = content(&found).map_err(|e| format!("a readable file: {e}"))?;
        parse(&text(&bytes))
    };
    read().map_err(|allowed| ContactError::BadText {
        name: parameter.into(),
        value: name.into(),
        allowed,
    })
}

/// The one full name by which a file is known, whatever links and dots lead to it and whether or not
/// it exists; none where its folder does not.
pub fn full_name(path: &Path) -> Option<PathBuf> {
    path.canonicalize().ok().or_else(|| {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
        let folder = folder.unwrap_or(Path::new(".")).canonicalize().ok()?;
        Some(folder.join(path.file_name()?))
    })
}
