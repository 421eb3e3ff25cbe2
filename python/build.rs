//! Puts what a wheel carries where maturin takes it from: FMUs, profiles and licences, in `OUT_DIR`.
//!
//! The FMUs are packed by the crate's own release build, in a target directory of its own; `WHEELRAIL_PLATFORMS` asks it for other
//! platforms. `WHEELRAIL_UNITS` names a folder that has them already.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

/// The units that a wheel carries.
const UNITS: [&str; 4] = ["WheelRail.fmu", "WheelSet.fmu", "WheelRail3.fmu", "WheelSet3.fmu"];
/// What the units are made from.
const SOURCES: [&str; 8] = [
    "src",
    "modelDescription",
    "build",
    "build.rs",
    "fmu",
    "Cargo.toml",
    "LICENSE-MIT",
    "LICENSE-APACHE",
];

fn main() {
    println!("cargo::rerun-if-env-changed=WHEELRAIL_UNITS");
    println!("cargo::rerun-if-env-changed=WHEELRAIL_PLATFORMS");
    let root = folder("CARGO_MANIFEST_DIR").join("..");
    let out = folder("OUT_DIR");
    copy(&root.join("fmu/resources/profiles"), &out.join("profiles"));
    copy(&root.join("fmu/documentation/licenses"), &out.join("licenses"));
    // maturin sets it: other builds make no wheel.
    println!("cargo::rerun-if-env-changed=PYO3_BUILD_EXTENSION_MODULE");
    if env::var_os("PYO3_BUILD_EXTENSION_MODULE").is_none() {
        return;
    }
    let packed = match env::var_os("WHEELRAIL_UNITS") {
        Some(ready) => PathBuf::from(ready),
        None => pack(&root, &out.join("packing")),
    };
    let units = out.join("units");
    let made = fs::create_dir_all(&units);
    made.unwrap_or_else(|e| panic!("cannot make {}: {e}", units.display()));
    for unit in UNITS {
        let from = packed.join(unit);
        println!("cargo::rerun-if-changed={}", from.display());
        let copied = fs::copy(&from, units.join(unit));
        copied.unwrap_or_else(|e| {
            panic!(
                "cannot take {}: {e}; WHEELRAIL_UNITS names a folder with all units",
                from.display()
            )
        });
    }
}

/// Puts the files of a folder of the crate beside them.
fn copy(from: &Path, to: &Path) {
    println!("cargo::rerun-if-changed={}", from.display());
    let copied = fs::create_dir_all(to).and_then(|()| {
        for file in fs::read_dir(from)? {
            let file = file?;
            fs::copy(file.path(), to.join(file.file_name()))?;
        }
        Ok(())
    });
    copied.unwrap_or_else(|e| panic!("cannot copy {}: {e}", from.display()));
}

fn folder(variable: &str) -> PathBuf {
    env::var_os(variable).unwrap_or_else(|| panic!("cargo sets {variable}")).into()
}

/// Packs the units from the crate around this one; returns their folder.
fn pack(root: &Path, target: &Path) -> PathBuf {
    for source in SOURCES {
        println!("cargo::rerun-if-changed={}", root.join(source).display());
    }
    let cargo = env::var_os("CARGO").expect("cargo sets CARGO");
    let mut command = Command::new(cargo);
    command
        .current_dir(root)
        .args(["check", "--release", "--no-default-features", "--features", "package"])
        .arg("--target-dir")
        .arg(target);
    // What describes this build would change that one.
    for (name, _) in env::vars_os() {
        let of_this_build = name.to_str().is_some_and(|name| {
            ["CARGO_BUILD_TARGET", "CARGO_ENCODED_RUSTFLAGS", "CARGO_TARGET_DIR", "RUSTFLAGS"]
                .contains(&name)
                || ["CARGO_CFG_", "CARGO_FEATURE_", "CARGO_PROFILE_", "PYO3_"]
                    .iter()
                    .any(|p| name.starts_with(p))
        });
        if of_this_build {
            command.env_remove(name);
        }
    }
    let output = command.output().unwrap_or_else(|e| panic!("cannot start cargo: {e}"));
    assert!(
        output.status.success(),
        "the FMUs could not be packed ({}):\n{}\nWHEELRAIL_UNITS can name a folder that has them",
        output.status,
        String::from_utf8_lossy(&output.stderr),
    );
    target.join("release")
}
