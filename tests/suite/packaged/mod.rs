//! The FMU as a release build packs it, in a target directory of its own. Tests that are not of a
//! release build themselves do without optimisation at link time, which takes minutes on one core.

#![allow(dead_code)] // each test crate uses its own part

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

fn build(folder: &str, platforms: &str) -> PathBuf {
    // Not the outer target directory: cargo may hold its lock while the tests run.
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join(folder);
    let mut command = Command::new(env!("CARGO"));
    if cfg!(debug_assertions) {
        // The build script packs, and builds the library for that by itself: of the rest a check is
        // enough.
        command
            .arg("check")
            .env("CARGO_PROFILE_RELEASE_LTO", "off")
            .env("CARGO_PROFILE_RELEASE_CODEGEN_UNITS", "16");
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
