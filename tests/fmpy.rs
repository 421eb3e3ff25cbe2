//! The packed FMU in a real importer, `FMPy`, in a virtual environment that the test makes.
//!
//! Needs Python 3.10 or later with venv, and the package index for the first run.

mod packaged;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

#[test]
fn fmpy_finds_the_unit_valid_and_well_behaved() {
    check("check_interface.py");
}

#[test]
fn fmpy_gets_the_forces_of_a_wheel_on_a_rail() {
    check("check_mechanics.py");
}

#[test]
fn the_example_for_fmpy_runs() {
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/fmpy_drop.py");
    run(Command::new(python()).arg(example).arg(packaged::fmu()), "examples/fmpy_drop.py");
}

/// Runs one file of checks on the packed FMU.
fn check(file: &str) {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fmpy").join(file);
    let mut command = Command::new(python());
    run(command.arg(script).env("WHEELRAIL_FMU", packaged::fmu()), file);
}

/// The Python of a virtual environment with the requirements installed.
fn python() -> PathBuf {
    static PYTHON: OnceLock<PathBuf> = OnceLock::new();
    PYTHON.get_or_init(environment).clone()
}

fn environment() -> PathBuf {
    let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join("fmpy-venv");
    let python = root.join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" });
    let requirements = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fmpy/requirements.txt");
    let wanted = fs::read_to_string(&requirements).expect("the requirements are in the tree");
    // Written last: an installation that was interrupted is made anew.
    let stamp = root.join("installed.txt");
    if fs::read_to_string(&stamp).is_ok_and(|installed| installed == wanted) {
        return python;
    }
    let _ = fs::remove_dir_all(&root);
    let system = if cfg!(windows) { "python" } else { "python3" };
    let mut command = Command::new(system);
    run(command.args(["-m", "venv"]).arg(&root), "making a virtual environment");
    let mut command = Command::new(&python);
    command.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "-r"]);
    run(command.arg(&requirements), "installing tests/fmpy/requirements.txt");
    fs::write(&stamp, wanted).expect("the virtual environment can be written");
    python
}

fn run(command: &mut Command, what: &str) -> Output {
    let output = command.env("PYTHONDONTWRITEBYTECODE", "1").output().unwrap_or_else(|e| {
        panic!(
            "{what}: {} cannot be started ({e}). The FMPy tests need Python 3.10 or later with venv \
             and pip; on Debian and Ubuntu: apt install python3 python3-venv",
            command.get_program().display()
        )
    });
    assert!(
        output.status.success(),
        "{what} failed ({}). If venv or pip is missing, on Debian and Ubuntu: apt install python3-venv\n{}{}",
        output.status,
        String::from_utf8_lossy(&output.stdout),
        String::from_utf8_lossy(&output.stderr),
    );
    output
}
