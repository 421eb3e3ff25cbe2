//! Packs `WheelRail.fmu` and `WheelSet.fmu`, `WheelRailPlain.fmu` and `WheelSetPlain.fmu` with a
//! shorter description of the same, and `WheelRail3.fmu` and `WheelSet3.fmu` for FMI 3.0: builds
//! the library once more without the packaging, and puts it into an archive for each description,
//! with profiles, documentation, icon and licences.
//!
//! Other builds than release ones build no library: it is an empty file in their archives, which
//! lie in `OUT_DIR`. The tests put the one that was made beside them in its place.
//!
//! The library of this very build does not exist yet when its build script runs, hence the inner
//! build. It has a target directory of its own, or it would wait for the lock of the outer one for
//! ever. The same sources give the same bytes wherever they lie: paths are remapped, entries
//! sorted, dates fixed.

use std::io::{Cursor, Write};
use std::path::{Path, PathBuf};
use std::time::SystemTime;
use std::{env, fs};

use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

use crate::declaration::Declaration;
use crate::platforms::{self, Library};
use crate::xml::{self, Style};
use crate::{terminals, xml3};

/// What the archives are made of, beside the library.
const SOURCES: [&str; 4] = ["modelDescription", "build", "build.rs", "fmu"];
/// What the library is made of besides.
const SOURCES_OF_LIBRARY: [&str; 3] = ["src", "Cargo.toml", "Cargo.lock"];

/// Builds the library, if this is a release build, and writes an archive for each declaration.
///
/// # Panics
/// With a message for the user if the inner build fails or a file cannot be read or written.
pub fn pack(declarations: &[&Declaration]) {
    let root = folder("CARGO_MANIFEST_DIR");
    let out = folder("OUT_DIR");
    let target = env::var("TARGET").expect("cargo sets TARGET");
    let version = env::var("CARGO_PKG_VERSION").expect("cargo sets CARGO_PKG_VERSION");
    let is_release = env::var("PROFILE").is_ok_and(|profile| profile == "release");
    let mut sources: Vec<&str> = SOURCES.into_iter().chain(LICENSES).collect();
    if is_release {
        sources.extend(SOURCES_OF_LIBRARY);
    }
    for source in &sources {
        println!("cargo::rerun-if-changed={source}");
    }
    let (libraries, folder_of_archives) = if is_release {
        (platforms::libraries(&root, &out, &target), profile_folder(&out))
    } else {
        (platforms::without_file(&target), out)
    };
    let mut shared = Vec::new();
    collect(&root.join("fmu/resources"), "resources", &mut shared);
    collect(&root.join("fmu/documentation"), "documentation", &mut shared);
    for license in LICENSES {
        shared.push((format!("documentation/licenses/{license}"), read(&root.join(license))));
    }
    let icon = read(&root.join("fmu/model.png"));
    let forms =
        [(Form::Fmi2(Style::Full), ""), (Form::Fmi2(Style::Plain), "Plain"), (Form::Fmi3, "3")];
    for (declaration, (form, suffix)) in
        declarations.iter().flat_map(|d| forms.map(|form| (d, form)))
    {
        // `modelIdentifier`: name of the library in the archive.
        let identifier = &declaration.model.name;
        let archive = folder_of_archives.join(format!("{identifier}{suffix}.fmu"));
        // An archive that somebody deleted is made again.
        println!("cargo::rerun-if-changed={}", archive.display());
        let mut entries = shared.clone();
        let described = match form {
            Form::Fmi2(style) => {
                entries.push(("model.png".into(), icon.clone()));
                xml::generate(declaration, &version, style)
            }
            Form::Fmi3 => {
                let terminals = terminals::generate(declaration)
                    .unwrap_or_else(|e| panic!("terminalsAndIcons.xml: {e}"));
                entries.push(("terminalsAndIcons/terminalsAndIcons.xml".into(), terminals));
                entries.push(("terminalsAndIcons/icon.png".into(), icon.clone()));
                xml3::generate(declaration, &version)
            }
        };
        let description = described.unwrap_or_else(|e| panic!("modelDescription.xml: {e}"));
        entries.push(("modelDescription.xml".into(), description));
        for Library { platform, tuple, extension, path } in &libraries {
            let folder = if form == Form::Fmi3 { tuple } else { *platform };
            let library = path.as_deref().map(read).unwrap_or_default();
            entries.push((format!("binaries/{folder}/{identifier}.{extension}"), library));
        }
        let bytes = zip(entries).unwrap_or_else(|e| panic!("packing {}: {e}", archive.display()));
        write(&archive, &bytes, newest(&root, &sources));
    }
}

/// What an archive is for.
#[derive(Clone, Copy, PartialEq)]
enum Form {
    Fmi2(Style),
    Fmi3,
}

/// Licences of the crate; those of what is linked into the library are in `fmu/documentation`.
const LICENSES: [&str; 2] = ["LICENSE-APACHE", "LICENSE-MIT"];

fn folder(variable: &str) -> PathBuf {
    env::var_os(variable).unwrap_or_else(|| panic!("cargo sets {variable}")).into()
}

/// The folder of the binaries: above the `build` folder that holds `OUT_DIR`.
fn profile_folder(out: &Path) -> PathBuf {
    let build = out.ancestors().find(|a| a.file_name().is_some_and(|name| name == "build"));
    let parent = build.and_then(Path::parent);
    parent.unwrap_or_else(|| panic!("no build folder above {}", out.display())).into()
}

fn read(path: &Path) -> Vec<u8> {
    fs::read(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// Every file below a folder, with its name in the archive.
fn collect(folder: &Path, name: &str, entries: &mut Vec<(String, Vec<u8>)>) {
    let files = fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    for file in files {
        let path = file.unwrap_or_else(|e| panic!("{}: {e}", folder.display())).path();
        let name = format!("{name}/{}", path.file_name().unwrap_or_default().to_string_lossy());
        if path.is_dir() {
            collect(&path, &name, entries);
        } else {
            entries.push((name, read(&path)));
        }
    }
}

fn zip(mut entries: Vec<(String, Vec<u8>)>) -> zip::result::ZipResult<Vec<u8>> {
    entries.sort();
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Deflated)
        .last_modified_time(DateTime::DEFAULT)
        .unix_permissions(0o644);
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in &entries {
        writer.start_file(name.as_str(), options)?;
        writer.write_all(bytes)?;
    }
    Ok(writer.finish()?.into_inner())
}

/// Writes the archive, first beside its place: nobody finds half of one.
///
/// It is dated back to the newest source, or cargo would take it for a source changed by this run
/// and run the script at every build.
fn write(archive: &Path, bytes: &[u8], date: SystemTime) {
    let part = archive.with_extension("fmu.part");
    let written = fs::write(&part, bytes)
        .and_then(|()| fs::File::options().write(true).open(&part)?.set_modified(date))
        .and_then(|()| fs::rename(&part, archive));
    written.unwrap_or_else(|e| panic!("cannot write {}: {e}", archive.display()));
}

/// When the newest of `sources` was last changed.
fn newest(root: &Path, sources: &[&str]) -> SystemTime {
    fn of(path: &Path) -> SystemTime {
        let modified = |path: &Path| fs::metadata(path).and_then(|m| m.modified());
        let own = modified(path).unwrap_or(SystemTime::UNIX_EPOCH);
        let Ok(files) = fs::read_dir(path) else { return own };
        files.flatten().map(|file| of(&file.path())).fold(own, SystemTime::max)
    }
    sources
        .iter()
        .map(|source| of(&root.join(source)))
        .fold(SystemTime::UNIX_EPOCH, SystemTime::max)
}
