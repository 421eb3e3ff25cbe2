//! The FMU for several platforms, `WHEELRAIL_PLATFORMS=linux64,aarch64-linux,win64`: what it
//! holds, on what it runs, and that Windows and Arm get the forces of Linux. Needs the tools that
//! `fmu/build_portable` installs, wine, qemu-user and the C library of Arm (`apt install wine64
//! qemu-user libc6-arm64-cross`): `fmu/build_portable cargo test --test suite portable:: -- --ignored`.
#![cfg(feature = "package")]

use crate::memory;
use crate::packaged;
use crate::tolerance;
use std::fs::{self, File};
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::OnceLock;

use wheelrail::variables::{GUID, find};

const PLATFORMS: &str = "linux64,aarch64-linux,win64";
const OUTPUTS: [&str; 8] = [
    "wheel.force.x",
    "wheel.force.y",
    "wheel.force.z",
    "wheel.moment.x",
    "wheel.moment.y",
    "wheel.moment.z",
    "patch[1].max_pressure",
    "wear_number",
];

/// The folder into which the archive for both platforms is unpacked.
fn unpacked() -> &'static Path {
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    FOLDER.get_or_init(|| {
        let archive = packaged::for_platforms(PLATFORMS);
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("portable-unpacked");
        let _ = fs::remove_dir_all(&folder);
        zip::ZipArchive::new(File::open(archive).unwrap()).unwrap().extract(&folder).unwrap();
        folder
    })
}

/// Versions of glibc that a library names.
fn glibc_versions(library: &[u8]) -> Vec<(u32, u32)> {
    let name = b"GLIBC_";
    let places = (0..library.len()).filter(|&i| library[i..].starts_with(name));
    let version = |place: usize| {
        let rest = &library[place + name.len()..];
        let end = rest.iter().position(|&byte| byte == 0)?;
        let mut numbers = std::str::from_utf8(&rest[..end]).ok()?.split('.').map(str::parse);
        Some((numbers.next()?.ok()?, numbers.next()?.ok()?))
    };
    places.filter_map(version).collect()
}

#[test]
#[ignore = "needs tools of other platforms"]
fn the_libraries_for_linux_run_on_an_old_glibc() {
    for platform in ["linux64", "aarch64-linux"] {
        let library = format!("binaries/{platform}/WheelRail.so");
        let versions = glibc_versions(&fs::read(unpacked().join(library)).unwrap());
        assert!(!versions.is_empty());
        assert!(versions.iter().all(|&version| version <= (2, 17)), "{platform}: {versions:?}");
    }
}

#[test]
#[ignore = "needs tools of other platforms"]
fn the_unit_of_fmi_3_holds_the_same_libraries_in_folders_of_its_own() {
    let archive = packaged::for_platforms(PLATFORMS).with_file_name("WheelRail3.fmu");
    let mut archive = zip::ZipArchive::new(File::open(archive).unwrap()).unwrap();
    for (old, new) in [
        ("binaries/linux64/WheelRail.so", "binaries/x86_64-linux/WheelRail.so"),
        ("binaries/aarch64-linux/WheelRail.so", "binaries/aarch64-linux/WheelRail.so"),
        ("binaries/win64/WheelRail.dll", "binaries/x86_64-windows/WheelRail.dll"),
    ] {
        let mut bytes = Vec::new();
        archive.by_name(new).unwrap().read_to_end(&mut bytes).unwrap();
        assert!(bytes == fs::read(unpacked().join(old)).unwrap(), "{new}");
        assert!(old == new || archive.by_name(old).is_err());
    }
}

/// What a library asks the system to call at its end is another thing in each tool chain.
#[test]
#[ignore = "needs tools of other platforms"]
fn the_library_for_linux_leaves_nothing_behind_when_it_is_unloaded() {
    let left = memory::left_behind(&unpacked().join("binaries/linux64/WheelRail.so"));
    assert!(left < 10e3, "{left} bytes stay behind each time");
}

#[test]
#[ignore = "needs tools of other platforms"]
fn no_path_of_this_machine_is_in_a_library() {
    let home = std::env::var("HOME").unwrap_or_default();
    for library in [
        "binaries/linux64/WheelRail.so",
        "binaries/aarch64-linux/WheelRail.so",
        "binaries/win64/WheelRail.dll",
    ] {
        let bytes = fs::read(unpacked().join(library)).unwrap();
        for path in [env!("CARGO_MANIFEST_DIR"), &format!("{home}/.")] {
            let found = bytes.windows(path.len()).any(|window| window == path.as_bytes());
            assert!(!found, "{path} in {library}");
        }
    }
}

/// A program or library for a platform, made by its compiler from a file beside.
fn compiled(compiler: &[&str], source: &str, name: &str, options: &[&str]) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("portable-host");
    fs::create_dir_all(&folder).unwrap();
    let file = folder.join(name);
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/portable").join(source);
    let mut command = Command::new(compiler[0]);
    command.args(&compiler[1..]).arg("-O1").arg("-o").arg(&file).arg(source).args(options);
    let output = command.output().unwrap_or_else(|e| panic!("{compiler:?}: {e}"));
    assert!(output.status.success(), "{compiler:?}: {}", String::from_utf8_lossy(&output.stderr));
    file
}

/// Rows of outputs of a client for the positions of the importers' tests.
fn answers(command: &mut Command, library: &str, resources: &str) -> Vec<Vec<f64>> {
    let positions = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/importers/positions.csv");
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(positions).unwrap();
    let references = |names: &[&str]| {
        let list: Vec<String> =
            names.iter().map(|name| find(name).unwrap().reference.to_string()).collect();
        format!("{} {}\n", names.len(), list.join(" "))
    };
    let names = reader.headers().unwrap().clone();
    let mut input = references(&names.iter().collect::<Vec<_>>()) + &references(&OUTPUTS);
    for row in reader.deserialize::<Vec<f64>>() {
        let bits: Vec<String> =
            row.unwrap().iter().map(|value| format!("{:x}", value.to_bits())).collect();
        input += &(bits.join(" ") + "\n");
    }
    let command = command.arg(unpacked().join(library)).arg(GUID).arg(resources);
    let piped = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = piped.spawn().unwrap_or_else(|e| {
        panic!(
            "{} cannot be started ({e}); apt install wine64 qemu-user",
            command.get_program().display()
        )
    });
    child.stdin.take().unwrap().write_all(input.as_bytes()).unwrap();
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success(), "{library}: {}", String::from_utf8_lossy(&output.stderr));
    let number = |word: &str| f64::from_bits(u64::from_str_radix(word, 16).unwrap());
    let text = String::from_utf8(output.stdout).unwrap();
    text.lines().map(|line| line.split_whitespace().map(number).collect()).collect()
}

/// The loader of Windows programs: Debian's package keeps it out of the path.
fn wine() -> PathBuf {
    let places = ["/usr/bin/wine64", "/usr/bin/wine", "/usr/lib/wine/wine64"].map(PathBuf::from);
    let found = places.into_iter().find(|place| place.is_file());
    found.expect("wine is not installed: apt install wine64")
}

/// Answers of the library for this machine.
fn on_linux() -> Vec<Vec<f64>> {
    let here = compiled(&["cc"], "client.c", "client", &["-ldl"]);
    let resources = format!("file://{}", unpacked().join("resources").display());
    answers(&mut Command::new(here), "binaries/linux64/WheelRail.so", &resources)
}

/// The greatest difference of another platform from this one, over the value, is below `tolerance`.
fn compared(linux: &[Vec<f64>], other: &[Vec<f64>], platform: &str, tolerance: f64) {
    assert_eq!((linux.len(), other.len()), (8, 8));
    let mut worst: f64 = 0.0;
    for (here, there) in linux.iter().zip(other) {
        assert_eq!((here.len(), there.len()), (OUTPUTS.len(), OUTPUTS.len()));
        for ((name, here), there) in OUTPUTS.iter().zip(here).zip(there) {
            let miss = (here - there).abs() / here.abs().max(f64::MIN_POSITIVE);
            assert!(miss < tolerance, "{name}: {here} on Linux, {there} on {platform}");
            worst = worst.max(miss);
        }
    }
    let touching = linux.iter().filter(|row| row[2] < -1e3).count();
    assert_eq!(touching, 7, "all wheels but the lifted one touch");
    println!("greatest difference of {platform} from linux64: {worst:.1e}");
}

#[test]
#[ignore = "needs tools of other platforms"]
fn arm_gets_the_forces_of_linux() {
    let linux = on_linux();
    let zig = ["cargo-zigbuild", "zig", "cc", "--", "-target", "aarch64-linux-gnu"];
    let there = compiled(&zig, "client.c", "client-arm", &["-ldl"]);
    let resources = format!("file://{}", unpacked().join("resources").display());
    let mut emulated = Command::new("qemu-aarch64");
    emulated.args(["-L", "/usr/aarch64-linux-gnu"]).arg(there);
    let arm = answers(&mut emulated, "binaries/aarch64-linux/WheelRail.so", &resources);
    compared(&linux, &arm, "aarch64-linux", tolerance::OTHER_PROCESSOR);
}

#[test]
#[ignore = "needs tools of other platforms"]
fn windows_gets_the_forces_of_linux() {
    let resources = unpacked().join("resources").display().to_string();
    let linux = on_linux();
    let compiler = &["x86_64-w64-mingw32-gcc"];
    // Prints 64-bit numbers as C99 does, not as the old Windows library.
    let there = compiled(compiler, "client.c", "client.exe", &["-D__USE_MINGW_ANSI_STDIO=1"]);
    // Found beside the program; wine 8 has none of its own.
    let stub = ["-shared", "-ladvapi32"];
    compiled(compiler, "bcryptprimitives.c", "bcryptprimitives.dll", &stub);
    let prefix = Path::new(env!("CARGO_TARGET_TMPDIR")).join("wine");
    let windows = answers(
        Command::new(wine()).arg(there).env("WINEPREFIX", prefix).env("WINEDEBUG", "-all"),
        "binaries/win64/WheelRail.dll",
        // Drive Z is the root of the file system.
        &format!("file:///Z:{resources}"),
    );
    compared(&linux, &windows, "win64", tolerance::OTHER_BUILD);
}
