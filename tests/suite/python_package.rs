//! The Python package as a user gets it: a wheel, built from the tree, in an empty virtual
//! environment, without Rust there.
//!
//! Needs Python 3.10 or later with venv and the package index: `cargo test --test suite
//! python_package:: -- --ignored --skip long`. The long test runs the notebooks, and a million
//! cases on a cluster that loses a worker.

use crate::packaged;
use crate::python;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use crate::python::run;

fn package() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("python")
}

/// The wheel, built without optimisations that take long; with the units of the other tests.
fn wheel() -> &'static Path {
    static WHEEL: OnceLock<PathBuf> = OnceLock::new();
    WHEEL.get_or_init(|| {
        let temporary = Path::new(env!("CARGO_TARGET_TMPDIR"));
        let tools = python::environment("maturin-venv", "python/tests/build_requirements.txt");
        let out = temporary.join("python-wheel");
        let _ = fs::remove_dir_all(&out);
        let mut command = Command::new(tools);
        command
            .args(["-m", "maturin", "build", "--locked", "--profile", "quick", "--out"])
            .arg(&out);
        command.current_dir(package()).env("CARGO_TARGET_DIR", temporary.join("python-build"));
        command.env("WHEELRAIL_UNITS", packaged::fmu().parent().expect("a folder"));
        // Those of the outer cargo would have all built anew.
        for name in ["CARGO_MANIFEST_DIR", "CARGO_PROFILE_DEV_DEBUG", "CARGO_PROFILE_TEST_DEBUG"] {
            command.env_remove(name);
        }
        run(&mut command, "building the Python package");
        let files = fs::read_dir(&out).expect("maturin makes the folder").flatten();
        let mut wheels = files
            .map(|file| file.path())
            .filter(|path| path.extension().is_some_and(|e| e == "whl"));
        wheels.next().expect("maturin makes a wheel")
    })
}

/// Installs the wheel in an environment, without what it requires.
fn install_wheel(python: &Path) {
    let mut command = Command::new(python);
    command.args([
        "-m",
        "pip",
        "install",
        "--quiet",
        "--disable-pip-version-check",
        "--force-reinstall",
        "--no-deps",
    ]);
    run(command.arg(wheel()), "installing the wheel");
}

/// Runs pytest in an environment with the requirements and the wheel, and no Rust in its path.
fn pytest(name: &str, requirements: &str, arguments: &[&str]) {
    let python = python::environment(name, requirements);
    install_wheel(&python);
    let mut command = Command::new(&python);
    run(command.args(["-m", "twine", "check", "--strict"]).arg(wheel()), "twine check");
    let mut command = Command::new(&python);
    command
        .args(["-m", "pytest", "-q", "-p", "no:cacheprovider", "-c"])
        .arg(package().join("pyproject.toml"));
    command.arg(package().join("tests")).args(arguments).current_dir(env!("CARGO_TARGET_TMPDIR"));
    let output = run(command.env("PATH", "/usr/bin:/bin"), "pytest");
    println!("{}", String::from_utf8_lossy(&output.stdout));
}

#[test]
#[ignore = "builds the Python package"]
fn the_wheel_works_where_there_is_nothing_but_numpy() {
    let python = python::environment("bare-venv", "python/tests/bare_requirements.txt");
    install_wheel(&python);
    let mut command = Command::new(python);
    command.args(["-c", "import wheelrail; print(wheelrail.Element().evaluate()['patch_count'])"]);
    let output = run(command.env("PATH", "/usr/bin:/bin"), "the wheel with numpy alone");
    assert_eq!(String::from_utf8_lossy(&output.stdout).trim(), "1", "a wheel starts on its rail");
}

#[test]
#[ignore = "builds the Python package"]
fn the_wheel_passes_its_tests() {
    pytest("package-venv", "python/tests/requirements.txt", &[]);
}

#[test]
#[ignore = "takes minutes"]
fn long_tests_of_the_package_pass() {
    pytest("package-long-venv", "python/tests/long_requirements.txt", &["-m", "long or not long"]);
}
