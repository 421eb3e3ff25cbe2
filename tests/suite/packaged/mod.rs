//! The FMU as a release build packs it, in a target directory of its own. Tests of a release build have
//! the library that users get. Others have the one that cargo made beside them, with the checks of
//! debug builds in it, which takes no second build.

use std::env::consts::{DLL_PREFIX, DLL_SUFFIX};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

/// Path of `WheelRail.fmu`, packed from the sources as they are for this platform.
///
/// # Panics
/// With cargo's messages if it cannot be built.
pub fn fmu() -> PathBuf {
    static FMU: OnceLock<PathBuf> = OnceLock::new();
    FMU.get_or_init(|| build("fmu", "")).clone()
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

fn build(folder: &str, platforms: &str) -> PathBuf {
    // Not the outer target directory: cargo may hold its lock while the tests run.
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join(folder);
    let mut command = Command::new(env!("CARGO"));
    if cfg!(debug_assertions) && platforms.is_empty() {
        // The build script packs: of the rest a check is enough.
        command.arg("check").env("WHEELRAIL_LIBRARY", library());
    } else {
        command.arg("build");
    }
    let output = command
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .args(["--release", "--no-default-features", "--features", "package"])
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
