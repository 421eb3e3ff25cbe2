//! The library linked into a program in C, for other processors and another C library. Heavy, and
//! it needs compilers and an emulator: `apt install gcc-aarch64-linux-gnu libc6-dev-arm64-cross
//! qemu-user musl-tools`, then `cargo test --test suite static_library:: -- --ignored`.
#![allow(unsafe_code)]

use crate::tolerance;
use std::path::Path;
use std::process::Command;

use crate::host::Host;
use wheelrail::fmi::v2::types::Status;

/// Targets, the compiler for each, and what runs its programs here.
const TARGETS: [(&str, &str, Option<&str>); 2] = [
    ("x86_64-unknown-linux-musl", "musl-gcc", None),
    ("aarch64-unknown-linux-gnu", "aarch64-linux-gnu-gcc", Some("qemu-aarch64")),
];
const OUTPUTS: [&str; 4] =
    ["wheel.force.x", "wheel.force.y", "wheel.force.z", "patch[1].max_pressure"];

/// What a program is linked with besides. Compilers for musl made from one for glibc bring an
/// unwinder that wants glibc: that of Rust takes its place.
fn libraries(target: &str) -> Vec<String> {
    if !target.ends_with("musl") {
        return ["-lpthread", "-lm", "-ldl"].map(String::from).into();
    }
    let root = run(Command::new("rustc").args(["--print", "sysroot"]));
    let folder = format!("-L{}/lib/rustlib/{target}/lib/self-contained", root.trim());
    ["-nodefaultlibs", &folder, "-lunwind", "-lc", "-lgcc"].map(String::from).into()
}

fn run(command: &mut Command) -> String {
    let output = command.output().unwrap_or_else(|e| panic!("{command:?}: {e}"));
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command:?}: {errors}");
    String::from_utf8(output.stdout).unwrap()
}

/// What this process gets for the inputs of `tests/static/host.c`.
fn here() -> Vec<Vec<f64>> {
    let host = Host::stepping();
    (0..100)
        .map(|i| {
            let inputs = [
                ("wheel.y", 0.75 + f64::from(i - 50) / 8192.0),
                ("wheel.yaw", f64::from(i % 16 - 8) / 4096.0),
            ];
            assert_eq!(host.set_reals(&inputs), Status::Ok);
            host.get_reals(&OUTPUTS).unwrap()
        })
        .collect()
}

#[test]
#[ignore = "builds the library for two targets"]
fn programs_for_other_targets_get_the_same_forces() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    run(Command::new(root.join("fmu/build_static")).args(TARGETS.map(|(target, ..)| target)));
    let wanted = here();
    for (target, compiler, emulator) in TARGETS {
        let folder = root.join("target/static").join(target);
        let program = folder.join("host");
        run(Command::new(compiler)
            .args(["-static", "-Wall", "-Wextra", "-Werror", "-I"])
            .arg(&folder)
            .arg(root.join("tests/static/host.c"))
            .arg(folder.join("libwheelrail.a"))
            .args(libraries(target))
            .arg("-o")
            .arg(&program));
        let said = match emulator {
            Some(emulator) => run(Command::new(emulator).arg(&program)),
            None => run(&mut Command::new(&program)),
        };
        let found: Vec<Vec<f64>> = said
            .lines()
            .map(|line| line.split(' ').map(|number| number.parse().unwrap()).collect())
            .collect();
        assert_eq!(found.len(), wanted.len(), "{target}");
        let mut worst = 0.0_f64;
        for (found, wanted) in found.iter().zip(&wanted) {
            // Over the load, or the pressure itself.
            let scales = [wanted[2], wanted[2], wanted[2], wanted[3]];
            // Where the wheel is lifted all is zero.
            for ((found, wanted), scale) in found.iter().zip(wanted).zip(scales) {
                worst = worst.max((found - wanted).abs() / scale.abs().max(1.0));
            }
        }
        println!("{target}: greatest difference {worst:e}");
        assert!(worst < tolerance::OTHER_BUILD, "{target}: {worst:e}");
    }
}
