//! The FMUs as the build script packs them. Tests of a release build have the units that users get, from a
//! target directory of their own. Others complete the archives of their own build with the library that cargo
//! made beside them, which has the checks of debug builds in it and takes no second build.

use std::env::consts::{DLL_PREFIX, DLL_SUFFIX};
use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipArchive, ZipWriter};

/// Path of `WheelRail.fmu`, packed from the sources as they are for this platform.
///
/// # Panics
/// With cargo's messages if it cannot be built.
pub fn fmu() -> PathBuf {
    static FMU: OnceLock<PathBuf> = OnceLock::new();
    let unit = || if cfg!(debug_assertions) { completed() } else { build("fmu", "") };
    FMU.get_or_init(unit).clone()
}

/// Path of `WheelSet.fmu`, packed with it.
///
/// # Panics
/// As [`fmu`].
pub fn wheelset() -> PathBuf {
    let path = fmu().with_file_name("WheelSet.fmu");
    assert!(path.is_file(), "{} was not packed", path.display());
    path
}

/// The same for other platforms too, or for an old system: what `WHEELRAIL_PLATFORMS` can name.
///
/// # Panics
/// With cargo's messages if it cannot be built.
pub fn for_platforms(platforms: &str) -> PathBuf {
    build("portable", platforms)
}

/// The library that cargo made beside this test.
pub fn library() -> PathBuf {
    let name = format!("{DLL_PREFIX}wheelrail{DLL_SUFFIX}");
    std::env::current_exe().expect("a test has a path").with_file_name(name)
}

/// The archives that the build script left without a library, with it.
fn completed() -> PathBuf {
    let library = fs::read(library()).expect("cargo made the library beside this test");
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("units");
    fs::create_dir_all(&folder).expect("the folder of the units can be made");
    let entries = fs::read_dir(env!("OUT_DIR")).expect("the build script left its folder");
    for path in entries.map(|entry| entry.expect("the folder can be read").path()) {
        if path.extension().is_some_and(|extension| extension == "fmu") {
            let name = path.file_name().expect("an archive has a name");
            complete(&path, &folder.join(name), &library).unwrap_or_else(|e| {
                panic!("{} cannot be completed: {e}", path.display());
            });
        }
    }
    let fmu = folder.join("WheelRail.fmu");
    assert!(fmu.is_file(), "{} was not packed: build with the feature package", fmu.display());
    fmu
}

/// Copies the archive `from` to `to`, with `library` in its empty place. It is stored as it is:
/// deflating a library with the checks of debug builds takes seconds.
fn complete(from: &Path, to: &Path, library: &[u8]) -> zip::result::ZipResult<()> {
    let mut archive = ZipArchive::new(File::open(from)?)?;
    let mut writer = ZipWriter::new(File::create(to)?);
    for index in 0..archive.len() {
        let entry = archive.by_index_raw(index)?;
        let name = entry.name()?.into_owned();
        if !name.starts_with("binaries/") {
            writer.raw_copy_file(entry)?;
            continue;
        }
        assert_eq!(entry.size(), 0, "{name} is filled already");
        let options = SimpleFileOptions::default().compression_method(CompressionMethod::Stored);
        writer.start_file(name, options)?;
        writer.write_all(library)?;
    }
    writer.finish()?;
    Ok(())
}

/// The archives of a release build in a target directory of its own: cargo may hold the lock of the
/// outer one while the tests run.
fn build(folder: &str, platforms: &str) -> PathBuf {
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join(folder);
    let output = Command::new(env!("CARGO"))
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .args(["build", "--release", "--no-default-features", "--features", "package"])
        .arg("--target-dir")
        .arg(&target)
        .env_remove("CARGO_BUILD_TARGET")
        .env("WHEELRAIL_PLATFORMS", platforms)
        .output()
        .expect("cargo that builds the tests can be started");
    let messages = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{messages}");
    assert!(!messages.contains("could not be built"), "{messages}");
    let fmu = target.join("release/WheelRail.fmu");
    assert!(fmu.is_file(), "{} was not packed", fmu.display());
    fmu
}
