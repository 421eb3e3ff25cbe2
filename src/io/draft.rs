//! A file under way: written beside its place and renamed when it is complete.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use tempfile::{Builder, NamedTempFile};

/// A file under way. Dropped before it is finished it leaves nothing behind, and what had its name
/// stays.
#[derive(Debug)]
pub struct Draft {
    /// The name that was asked for.
    asked: PathBuf,
    target: Target,
}

#[derive(Debug)]
enum Target {
    /// A file, its length, and the name that it will get.
    Beside(NamedTempFile, u64, PathBuf),
    /// A device or a pipe: there is nothing to rename.
    Direct(File),
}

impl Draft {
    /// Prepares to write `path`.
    ///
    /// # Errors
    /// If a file of that name cannot be written, or none beside it.
    pub fn new(path: &Path) -> io::Result<Self> {
        // A link stays and what it leads to is replaced.
        let full = path.canonicalize().unwrap_or_else(|_| path.into());
        let existing = match OpenOptions::new().write(true).open(&full) {
            Ok(file) => Some(file),
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => return Err(error),
        };
        let about = existing.as_ref().map(File::metadata).transpose()?;
        let target = match (existing, about) {
            (Some(file), Some(about)) if !about.is_file() => Target::Direct(file),
            (_, about) => {
                let file = beside(&full)?;
                if let Some(about) = about {
                    fs::set_permissions(file.path(), about.permissions())?;
                }
                Target::Beside(file, 0, full)
            }
        };
        Ok(Self { asked: path.into(), target })
    }

    /// Appends `content`.
    ///
    /// # Errors
    /// If it cannot be written; a file is then as it was before.
    pub fn write(&mut self, content: &[u8]) -> io::Result<()> {
        match &mut self.target {
            Target::Beside(file, length, _) => match file.write_all(content) {
                Ok(()) => {
                    *length += content.len() as u64;
                    Ok(())
                }
                // No half line stays where the disk is full.
                Err(error) => file.as_file().set_len(*length).and(Err(error)),
            },
            Target::Direct(file) => file.write_all(content),
        }
    }

    /// Gives the file its name.
    ///
    /// # Errors
    /// If it cannot be renamed.
    pub fn finish(self) -> io::Result<()> {
        if let Target::Beside(file, _, full) = self.target {
            file.persist(full)?;
        }
        Ok(())
    }

    /// The name that was asked for.
    pub fn path(&self) -> &Path {
        &self.asked
    }

    /// Whether there is a file that can be kept before it is complete.
    pub fn can_be_kept(&self) -> bool {
        matches!(self.target, Target::Beside(..))
    }

    /// Leaves what is written so far beside its place, under the name that it returns.
    ///
    /// # Errors
    /// If it cannot be renamed.
    pub fn keep(self) -> io::Result<PathBuf> {
        let Target::Beside(file, _, full) = self.target else { return Ok(self.asked) };
        let part = |path: &Path| {
            let mut name = path.file_name().unwrap_or_default().to_owned();
            name.push(".partial");
            path.with_file_name(name)
        };
        file.persist(part(&full))?;
        Ok(part(&self.asked))
    }
}

/// Writes the file `path` as a whole: what had that name before stays until the new one is
/// complete.
///
/// # Errors
/// If it cannot be written; what had that name stays then.
pub fn write(path: &Path, content: &[u8]) -> io::Result<()> {
    let mut draft = Draft::new(path)?;
    draft.write(content)?;
    draft.finish()
}

/// A file beside `path` that is removed when it is dropped; if the program is killed it stays,
/// under a name that tells what it is.
fn beside(path: &Path) -> io::Result<NamedTempFile> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    let mut prefix = path.file_name().unwrap_or_default().to_owned();
    prefix.push(".");
    let mut builder = Builder::new();
    builder.prefix(&prefix).suffix(".partial");
    // As for any new file, less what the user's mask takes away.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let folder = folder.unwrap_or(Path::new("."));
    // Of a folder that is missing the system is to say so, not of a file with a random name in it.
    fs::metadata(folder)?;
    builder.tempfile_in(folder)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        let files = fs::read_dir(folder).unwrap();
        let mut names: Vec<String> =
            files.map(|file| file.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    #[test]
    fn what_was_there_stays_until_the_draft_is_finished() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("result.csv");
        fs::write(&path, "old").unwrap();
        let mut draft = Draft::new(&path).unwrap();
        draft.write(b"new").unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "old");
        let both = names(folder.path());
        assert!(both[1].starts_with("result.csv.") && both[1].ends_with(".partial"), "{both:?}");
        drop(draft);
        assert_eq!(names(folder.path()), ["result.csv"]);
        let mut draft = Draft::new(&path).unwrap();
        draft.write(b"new").unwrap();
        draft.finish().unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "new");
        assert_eq!(names(folder.path()), ["result.csv"]);
    }

    #[test]
    fn what_is_kept_says_that_it_is_a_part() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("result.csv");
        let mut draft = Draft::new(&path).unwrap();
        draft.write(b"a\n").unwrap();
        let kept = draft.keep().unwrap();
        assert_eq!(kept, folder.path().join("result.csv.partial"));
        assert_eq!(fs::read_to_string(kept).unwrap(), "a\n");
        assert!(!path.exists());
    }

    #[test]
    fn what_cannot_be_written_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        for (path, words) in [
            (folder.path().to_owned(), "directory"),
            (folder.path().join("none").join("result.csv"), "(os error 2)"),
        ] {
            let error = Draft::new(&path).unwrap_err().to_string();
            assert!(error.contains(words) && !error.contains("partial"), "{error}");
        }
    }

    #[cfg(unix)]
    #[test]
    fn permissions_and_links_stay() {
        use std::os::unix::fs::{PermissionsExt, symlink};

        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        let mode = |name: &str| fs::metadata(path(name)).unwrap().permissions().mode() & 0o777;
        fs::write(path("plain"), "").unwrap();
        fs::write(path("old"), "").unwrap();
        fs::set_permissions(path("old"), fs::Permissions::from_mode(0o640)).unwrap();
        symlink(path("old"), path("link")).unwrap();
        for name in ["new", "link"] {
            let mut draft = Draft::new(&path(name)).unwrap();
            draft.write(b"new").unwrap();
            draft.finish().unwrap();
        }
        assert_eq!(mode("new"), mode("plain"));
        assert_eq!(mode("old"), 0o640);
        assert!(fs::symlink_metadata(path("link")).unwrap().is_symlink());
        assert_eq!(fs::read_to_string(path("old")).unwrap(), "new");
    }
}
