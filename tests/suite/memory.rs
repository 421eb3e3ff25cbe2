//! The library in hosts written in C: under Valgrind no memory is read or written that should not
//! be, and none is lost; nothing stays when the library is unloaded; and a host that has unmasked
//! floating point exceptions lives on.
//!
//! Valgrind's part is left out, with a word, where there is none (`apt install valgrind`).

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::packaged;
use wheelrail::variables::{GUID, find};

/// A program made from a file in `tests/memory`.
fn compiled(source: &str) -> PathBuf {
    let host = Path::new(env!("CARGO_TARGET_TMPDIR")).join(source).with_extension("host");
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/memory").join(source);
    let mut command = Command::new("cc");
    command.arg("-g").arg("-o").args([&host, &source]).args(["-ldl", "-lm"]);
    let made = command.output().expect("a C compiler");
    assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
    host
}

fn reference(name: &str) -> String {
    find(name).unwrap().reference.to_string()
}

/// Bytes that a library leaves behind each time it is loaded, run and unloaded.
///
/// # Panics
/// If it gets into the way of the floating point settings of its host, or the host does not live on
/// to its end.
pub fn left_behind(library: &Path) -> f64 {
    let run = Command::new(compiled("coming_host.c"))
        .arg(library)
        .arg(GUID)
        .args(["wheel.z", "wheel.force.z"].map(reference))
        .arg("20")
        .output()
        .unwrap();
    let told = String::from_utf8_lossy(&run.stderr);
    assert!(run.status.success(), "{}: {told}", run.status);
    String::from_utf8(run.stdout).unwrap().trim().parse().unwrap()
}

#[test]
#[cfg(all(target_os = "linux", target_env = "gnu"))]
fn a_library_that_is_unloaded_leaves_nothing_and_a_host_its_exceptions() {
    let left = left_behind(&packaged::library());
    // The tables of creep forces alone have 1.5 MB.
    assert!(left < 10e3, "{left} bytes stay behind each time");
}

#[test]
#[cfg(target_os = "linux")]
fn a_host_in_c_finds_no_memory_error_and_no_leak() {
    if Command::new("valgrind").arg("--version").output().is_err() {
        println!("left out: there is no valgrind");
        return;
    }
    let host = compiled("host.c");
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
