//! The library in a host written in C under Valgrind: no memory is read or written that should not
//! be, and none is lost.
//!
//! Left out, with a word, where there is no Valgrind (`apt install valgrind`).

use std::path::Path;
use std::process::Command;

use crate::packaged;
use wheelrail::variables::{GUID, find};

#[test]
#[cfg(target_os = "linux")]
fn a_host_in_c_finds_no_memory_error_and_no_leak() {
    if Command::new("valgrind").arg("--version").output().is_err() {
        println!("left out: there is no valgrind");
        return;
    }
    let host = Path::new(env!("CARGO_TARGET_TMPDIR")).join("memory-host");
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/memory/host.c");
    let made = Command::new("cc").arg("-g").arg("-o").args([&host, &source]).arg("-ldl").output();
    let made = made.expect("a C compiler");
    assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
    let reference = |name: &str| find(name).unwrap().reference.to_string();
    let checked = Command::new("valgrind")
        .args(["--leak-check=full", "--errors-for-leak-kinds=definite,indirect"])
        .args(["--error-exitcode=99", "--quiet"])
        .arg(&host)
        .arg(packaged::library())
        .arg(GUID)
        .args(["wheel.z", "wheel.force.z", "wheel.profile"].map(reference))
        .output()
        .unwrap();
    let told = String::from_utf8_lossy(&checked.stderr);
    assert!(checked.status.success(), "{}: {told}", checked.status);
    assert!(told.trim().is_empty(), "{told}");
}
