//! The libraries that go into the archive: one for the platform of the build and, if
//! `WHEELRAIL_PLATFORMS` asks for them, others, as far as there are tools for them.
//!
//! `linux64` asks for a library that runs on the glibc of old distributions too: cargo-zigbuild
//! links it against 2.17. `aarch64-linux` is made in the same way, for which FMI 2.0 has no name of
//! its own: it has that of FMI 3.0 there too (FMI 2.0.4, 2.3). `win64` needs the standard library
//! for [`WINDOWS`] and the linker of MinGW-w64. A library that is there already can be packed
//! instead (`WHEELRAIL_LIBRARY`).

use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, thread};

/// Target of `linux64`.
const LINUX: &str = "x86_64-unknown-linux-gnu";
/// Oldest glibc on which the library of cargo-zigbuild runs: that of 2012.
const GLIBC: &str = "2.17";
/// Name of the platform of 64-bit Arm.
const ARM_NAME: &str = "aarch64-linux";
/// Its target.
const ARM: &str = "aarch64-unknown-linux-gnu";
/// Target of `win64`.
const WINDOWS: &str = "x86_64-pc-windows-gnu";
/// The linker for it.
const WINDOWS_LINKER: &str = "x86_64-w64-mingw32-gcc";
/// Name of the variable that asks for platforms.
const VARIABLE: &str = "WHEELRAIL_PLATFORMS";
/// Name of the variable that gives a library for this platform, which is packed as it is.
const LIBRARY: &str = "WHEELRAIL_LIBRARY";

/// A library to be built.
struct Job {
    platform: &'static str,
    file: &'static str,
    target: String,
    zigbuild: bool,
    /// What it runs on, for the message.
    runs_on: String,
}

/// A library as it is packed.
pub struct Library {
    /// Folder in `binaries`, as FMI 2.0 names it.
    pub platform: &'static str,
    /// The same as FMI 3.0 names it: processor and system.
    pub tuple: String,
    /// Extension of libraries there.
    pub extension: &'static str,
    /// Where it is; nowhere in an archive that gets it later.
    pub path: Option<PathBuf>,
}

/// That of this platform, which is not built.
pub fn without_file(target: &str) -> Vec<Library> {
    vec![own(target).library(None)]
}

/// The library that the user gives, or those that are built here; says which there are.
///
/// # Panics
/// As [`build`], or with a message for the user if there is no such file.
pub fn libraries(root: &Path, out: &Path, target: &str) -> Vec<Library> {
    println!("cargo::rerun-if-env-changed={LIBRARY}");
    let Some(path) = env::var_os(LIBRARY).filter(|path| !path.is_empty()).map(PathBuf::from) else {
        return build(root, out, target);
    };
    let shown = path.display();
    assert!(path.is_file(), "{LIBRARY}: there is no file {shown}");
    println!("cargo::rerun-if-changed={shown}");
    println!("cargo::warning=WheelRail.fmu, WheelSet.fmu and their kin hold {shown}");
    vec![own(target).library(Some(path))]
}

/// Builds the libraries, each in a target directory of its own, and says which there are.
///
/// # Panics
/// With a message for the user if a platform is not known, or a build fails though its tools are
/// there.
fn build(root: &Path, out: &Path, target: &str) -> Vec<Library> {
    println!("cargo::rerun-if-env-changed={VARIABLE}");
    let asked = env::var(VARIABLE).unwrap_or_default();
    let asked: Vec<&str> =
        asked.split([',', ' ']).map(str::trim).filter(|name| !name.is_empty()).collect();
    if let Some(name) = asked.iter().find(|name| !["linux64", ARM_NAME, "win64"].contains(name)) {
        panic!("{VARIABLE} names {name}: linux64, {ARM_NAME} and win64 can be asked for");
    }
    if !asked.is_empty() {
        // Tools may be installed after they were missed.
        println!("cargo::rerun-if-env-changed=PATH");
    }
    let (jobs, missing) = plan(target, &asked);
    let libraries = thread::scope(|scope| {
        let builds: Vec<_> =
            jobs.iter().map(|job| scope.spawn(|| inner_build(root, out, job))).collect();
        let done = |build: thread::ScopedJoinHandle<'_, PathBuf>| {
            build.join().unwrap_or_else(|message| std::panic::resume_unwind(message))
        };
        builds.into_iter().map(done).collect::<Vec<_>>()
    });
    let packed: Vec<String> =
        jobs.iter().map(|job| format!("{} ({})", job.platform, job.runs_on)).collect();
    println!("cargo::warning=WheelRail.fmu, WheelSet.fmu and their kin hold {}", packed.join(", "));
    for missing in missing {
        println!("cargo::warning={missing}");
    }
    jobs.iter().zip(libraries).map(|(job, path)| job.library(Some(path))).collect()
}

impl Job {
    /// What lies at `path`, for its platform.
    fn library(&self, path: Option<PathBuf>) -> Library {
        Library {
            platform: self.platform,
            tuple: tuple(&self.target),
            extension: self.file.rsplit('.').next().unwrap_or_default(),
            path,
        }
    }
}

/// What is built, and what was asked for and is not.
fn plan(target: &str, asked: &[&str]) -> (Vec<Job>, Vec<String>) {
    let own = own(target);
    let (mut jobs, mut missing) = (Vec::new(), Vec::new());
    for (platform, wanted) in [("linux64", LINUX), (ARM_NAME, ARM), ("win64", WINDOWS)] {
        if !asked.contains(&platform) || (platform == "win64" && own.platform == "win64") {
            continue;
        }
        let zigbuild = platform != "win64";
        let own_target = platform == own.platform;
        let wanted = if own_target { target } else { wanted };
        let tools = if zigbuild { zigbuild_is_there() } else { linker_is_there() };
        match tools.and_then(|()| if own_target { Ok(()) } else { standard_library(wanted) }) {
            Ok(()) => {
                let (file, runs_on) = if zigbuild {
                    ("libwheelrail.so", format!("glibc {GLIBC} or later"))
                } else {
                    ("wheelrail.dll", "Windows 10 or later".into())
                };
                jobs.push(Job { platform, file, target: wanted.into(), zigbuild, runs_on });
            }
            Err(reason) => missing.push(format!("{platform}, {}: {reason}", what(platform))),
        }
    }
    if !jobs.iter().any(|job| job.platform == own.platform) {
        jobs.insert(0, own);
    }
    (jobs, missing)
}

fn what(platform: &str) -> String {
    match platform {
        "linux64" | ARM_NAME => format!("for glibc {GLIBC}, could not be built"),
        _ => "could not be built".into(),
    }
}

/// The library for the platform of the build.
///
/// # Panics
/// For a target that FMI 2.0 has no name for.
fn own(target: &str) -> Job {
    let bits_64 = ["x86_64", "aarch64"].iter().any(|cpu| target.starts_with(cpu));
    let (platforms, file, runs_on) = if target.contains("windows") {
        (["win32", "win64"], "wheelrail.dll", "Windows 10 or later")
    } else if target.contains("apple-darwin") {
        (["darwin32", "darwin64"], "libwheelrail.dylib", "macOS of this machine or later")
    } else if target.contains("linux") {
        (["linux32", "linux64"], "libwheelrail.so", "glibc of this machine or later")
    } else {
        panic!(
            "FMI 2.0 has no platform name for {target}; build the library alone with \
             `cargo build --release --no-default-features --features cli`"
        )
    };
    Job {
        platform: platforms[usize::from(bits_64)],
        file,
        target: target.into(),
        zigbuild: false,
        runs_on: runs_on.into(),
    }
}

/// The platform tuple of FMI 3.0 (2.5.1.4.2) for a target that [`own`] has a name for.
fn tuple(target: &str) -> String {
    let processor = match target.split('-').next().unwrap_or_default() {
        "i586" | "i686" => "x86",
        other => other,
    };
    let system = if target.contains("windows") {
        "windows"
    } else if target.contains("apple-darwin") {
        "darwin"
    } else {
        "linux"
    };
    format!("{processor}-{system}")
}

fn zigbuild_is_there() -> Result<(), String> {
    let works = Command::new("cargo-zigbuild").args(["zig", "cc", "--", "--version"]).output();
    if works.is_ok_and(|output| output.status.success()) {
        return Ok(());
    }
    Err("cargo-zigbuild or zig is missing: pip install cargo-zigbuild ziglang".into())
}

fn linker_is_there() -> Result<(), String> {
    let works = Command::new(WINDOWS_LINKER).arg("--version").output();
    if works.is_ok_and(|output| output.status.success()) {
        return Ok(());
    }
    Err(format!("{WINDOWS_LINKER} is missing: apt install gcc-mingw-w64-x86-64"))
}

/// Whether the compiler has a standard library for a target.
fn standard_library(target: &str) -> Result<(), String> {
    let rustc = env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let output =
        Command::new(rustc).args(["--print", "target-libdir", "--target", target]).output();
    let folder = output.ok().and_then(|output| String::from_utf8(output.stdout).ok());
    if folder.is_some_and(|folder| Path::new(folder.trim()).is_dir()) {
        return Ok(());
    }
    Err(format!("Rust's standard library for it is missing: rustup target add {target}"))
}

/// Builds the library without packaging and command line; returns its file.
fn inner_build(root: &Path, out: &Path, job: &Job) -> PathBuf {
    // Builds run at the same time: one directory would make them wait for each other. One with
    // another linker has its own too: cargo would take the library of the first for that of the
    // second.
    let linker = if job.zigbuild { "-zigbuild" } else { "" };
    let inner = out.join("inner").join(format!("{}{linker}", job.platform));
    let cargo = env::var_os("CARGO").expect("cargo sets CARGO");
    let (program, target): (&OsStr, _) = if job.zigbuild {
        ("cargo-zigbuild".as_ref(), format!("{}.{GLIBC}", job.target))
    } else {
        (&cargo, job.target.clone())
    };
    let mut command = Command::new(program);
    command
        .current_dir(root)
        .args(["rustc", "--lib", "--release", "--crate-type", "cdylib", "--no-default-features"])
        .args(["--target", &target, "--target-dir"])
        .arg(&inner);
    for (name, _) in env::vars_os().filter(|(name, _)| is_of_outer_build(name)) {
        command.env_remove(name);
    }
    command.env("CARGO_ENCODED_RUSTFLAGS", remapping(root, out));
    let output =
        command.output().unwrap_or_else(|e| panic!("cannot start {}: {e}", program.display()));
    assert!(
        output.status.success(),
        "the library of the FMUs for {} could not be built ({}):\n{}\nTo build without the FMU: \
         cargo build --release --no-default-features --features cli",
        job.platform,
        output.status,
        String::from_utf8_lossy(&output.stderr),
    );
    inner.join(&job.target).join("release").join(job.file)
}

/// Whether a variable describes the outer build, or would change the inner one.
fn is_of_outer_build(name: &OsString) -> bool {
    const NAMES: [&str; 17] = [
        "CARGO_BUILD_TARGET",
        "CARGO_BUILD_TARGET_DIR",
        "CARGO_BUILD_RUSTFLAGS",
        "CARGO_ENCODED_RUSTFLAGS",
        "CARGO_MAKEFLAGS",
        "CARGO_PRIMARY_PACKAGE",
        "CARGO_TARGET_DIR",
        "DEBUG",
        "HOST",
        "NUM_JOBS",
        "OPT_LEVEL",
        "OUT_DIR",
        "PROFILE",
        "RUSTC_WORKSPACE_WRAPPER",
        "RUSTFLAGS",
        "RUST_BACKTRACE",
        "TARGET",
    ];
    const PREFIXES: [&str; 6] =
        ["CARGO_CFG_", "CARGO_FEATURE_", "CARGO_MANIFEST_", "CARGO_PKG_", "CARGO_PROFILE_", "DEP_"];
    name.to_str().is_some_and(|name| {
        NAMES.contains(&name) || PREFIXES.iter().any(|prefix| name.starts_with(prefix))
    })
}

/// Flags that replace the paths of this machine, in cargo's encoding.
fn remapping(root: &Path, out: &Path) -> OsString {
    let cargo_home = env::var_os("CARGO_HOME").map(PathBuf::from);
    let home = env::var_os(if cfg!(windows) { "USERPROFILE" } else { "HOME" });
    let cargo_home = cargo_home.or_else(|| home.map(|home| PathBuf::from(home).join(".cargo")));
    let mut flags = OsString::new();
    // The last prefix that fits counts: OUT_DIR lies within the root as a rule.
    let prefixes = [
        cargo_home.as_deref().map(|home| (home, "/cargo")),
        Some((root, "/wheelrail")),
        Some((out, "/out")),
    ];
    for (from, to) in prefixes.into_iter().flatten() {
        if !flags.is_empty() {
            flags.push("\x1f");
        }
        flags.push("--remap-path-prefix=");
        flags.push(from);
        flags.push("=");
        flags.push(to);
    }
    flags
}
