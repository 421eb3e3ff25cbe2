//! The FMU as a release build packs it, in a target directory of its own.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

/// Path of `WheelRail.fmu`, packed from the sources as they are.
///
/// # Panics
/// With cargo's messages if it cannot be built.
pub fn fmu() -> PathBuf {
    static FMU: OnceLock<PathBuf> = OnceLock::new();
    FMU.get_or_init(build).clone()
}

fn build() -> PathBuf {
    // Not the outer target directory: cargo may hold its lock while the tests run.
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join("fmu");
    let output = Command::new(env!("CARGO"))
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .args(["build", "--release", "--no-default-features", "--features", "package"])
        .arg("--target-dir")
        .arg(&target)
        .env_remove("CARGO_BUILD_TARGET")
        .output()
        .expect("cargo that builds the tests can be started");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let fmu = target.join("release/WheelRail.fmu");
    assert!(fmu.is_file(), "{} was not packed", fmu.display());
    fmu
}
