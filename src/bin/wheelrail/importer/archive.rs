//! An unpacked and loaded unit.
#![allow(unsafe_code)]

use std::fmt::Write;
use std::fs::File;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use libloading::Library;
use tempfile::TempDir;
use zip::ZipArchive;

use super::description::ModelDescription;
use super::functions::Functions;

/// A unit whose library is loaded and from which instances can be made.
///
/// The fields are dropped in their order: the library is unloaded before its file is removed.
pub struct Fmu {
    /// What the unit says about itself.
    pub description: ModelDescription,
    pub(super) functions: Functions,
    /// Keeps `functions` valid.
    _library: Library,
    folder: TempDir,
}

impl Fmu {
    /// Unpacks `archive` into a temporary folder and loads its library.
    pub fn open(archive: &Path) -> Result<Self> {
        let file =
            File::open(archive).with_context(|| format!("cannot open {}", archive.display()))?;
        let folder = TempDir::with_prefix("wheelrail-")
            .context("cannot make a temporary folder to unpack the unit into")?;
        ZipArchive::new(file).and_then(|mut zip| zip.extract(folder.path())).with_context(
            || format!("{} is not an archive that can be unpacked", archive.display()),
        )?;
        let xml = std::fs::read_to_string(folder.path().join("modelDescription.xml"))
            .with_context(|| format!("no modelDescription.xml in {}", archive.display()))?;
        let description = ModelDescription::parse(&xml)
            .with_context(|| format!("{} cannot be used", archive.display()))?;
        let library = library_path(folder.path(), &description.model_identifier)?;
        // SAFETY: loading runs the initialisers of the library. The user names the unit and trusts
        // it as he trusts any program he runs.
        let library = unsafe { Library::new(&library) }
            .with_context(|| format!("cannot load {}", library.display()))?;
        let functions = Functions::of(&library)?;
        Ok(Self { description, functions, _library: library, folder })
    }

    /// `file:` address of the folder of resources.
    pub fn resource_location(&self) -> String {
        let path = self.folder.path().join("resources");
        let mut address = String::from("file://");
        let text = path.to_string_lossy().replace('\\', "/");
        if !text.starts_with('/') {
            address.push('/');
        }
        for byte in text.bytes() {
            if byte.is_ascii_alphanumeric() || b"/-._~:".contains(&byte) {
                address.push(char::from(byte));
            } else {
                // Writing to a string cannot fail.
                let _ = write!(address, "%{byte:02X}");
            }
        }
        address
    }
}

fn library_path(folder: &Path, model_identifier: &str) -> Result<PathBuf> {
    let bits = usize::BITS;
    let (system, extension) = match std::env::consts::OS {
        "windows" => ("win", "dll"),
        "macos" => ("darwin", "dylib"),
        _ => ("linux", "so"),
    };
    let platform = format!("{system}{bits}");
    let path =
        folder.join("binaries").join(&platform).join(format!("{model_identifier}.{extension}"));
    if !path.is_file() {
        bail!("the unit has no library for {platform}: build it on this machine");
    }
    Ok(path)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_an_archive_is_refused_by_name() {
        let folder = TempDir::new().unwrap();
        let path = folder.path().join("a.fmu");
        let message = |path: &Path| format!("{:#}", Fmu::open(path).err().unwrap());
        assert!(message(&path).starts_with("cannot open"), "{}", message(&path));
        std::fs::write(&path, "text").unwrap();
        assert!(message(&path).contains("is not an archive"), "{}", message(&path));
    }
}
