//! Text of a file that a parameter names.

use std::path::{Path, PathBuf};

use crate::error::ContactError;

/// Largest file that is read [bytes].
const LARGEST_FILE: u64 = 64 << 20;

/// The text of the file that the parameter `parameter` names `name`: an absolute path or one that
/// is looked for in `folders`.
///
/// # Errors
/// The parameter, the file and what is wrong with it.
pub(crate) fn named_text(
    parameter: &str,
    name: &str,
    folders: &[PathBuf],
) -> Result<String, ContactError> {
    let refuse = |allowed: String| ContactError::BadText {
        name: parameter.into(),
        value: name.into(),
        allowed,
    };
    let path = Path::new(name);
    let candidates: Vec<PathBuf> = if path.is_absolute() {
        vec![path.into()]
    } else {
        folders.iter().map(|folder| folder.join(path)).collect()
    };
    let found = candidates.iter().find(|p| p.exists()).ok_or_else(|| {
        let looked: Vec<String> = candidates.iter().map(|c| c.display().to_string()).collect();
        refuse(format!("a file that exists (looked for {})", looked.join(", ")))
    })?;
    if !found.is_file() {
        let what = if found.is_dir() { "a folder" } else { "none" };
        return Err(refuse(format!("a file; {} is {what}", found.display())));
    }
    let too_large = std::fs::metadata(found).is_ok_and(|about| about.len() > LARGEST_FILE);
    if too_large {
        return Err(refuse(format!("a file of up to {LARGEST_FILE} bytes")));
    }
    let bytes = std::fs::read(found).map_err(|e| refuse(format!("a readable file: {e}")))?;
    let content = String::from_utf8_lossy(&bytes);
    Ok(content.trim_start_matches('\u{feff}').to_owned())
}
