//! The FMU as users get it: from a release build.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

/// `WheelRail.fmu` of a release build in a target directory of its own, which the build that runs the tests does
/// not hold locked. Several tests may ask at once; cargo builds once.
pub fn unit() -> &'static Path {
    static UNIT: OnceLock<PathBuf> = OnceLock::new();
    UNIT.get_or_init(|| {
        let target = Path::new(env!("CARGO_MANIFEST_DIR")).join("target/packaged");
        let status = Command::new(env!("CARGO"))
            .args(["build", "--release", "--target-dir"])
            .arg(&target)
            .current_dir(env!("CARGO_MANIFEST_DIR"))
            .status()
            .unwrap();
        assert!(status.success(), "the release build that packs the FMU failed");
        target.join("release/WheelRail.fmu")
    })
}
