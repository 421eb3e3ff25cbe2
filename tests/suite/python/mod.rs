//! Virtual environments of Python that the tests make for themselves.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// The Python of the virtual environment `name` with the requirements of a file of the tree
/// installed.
///
/// # Panics
/// With what is missing if it cannot be made.
pub fn environment(name: &str, requirements: &str) -> PathBuf {
    let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let python = root.join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" });
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(requirements);
    let wanted = fs::read_to_string(&path).expect("the requirements are in the tree");
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
    run(command.arg(&path), &format!("installing {requirements}"));
    fs::write(&stamp, wanted).expect("the virtual environment can be written");
    python
}

/// Runs a command to its end.
///
/// # Panics
/// With its output if it fails.
pub fn run(command: &mut Command, what: &str) -> Output {
    let output = command.env("PYTHONDONTWRITEBYTECODE", "1").output().unwrap_or_else(|e| {
        panic!(
            "{what}: {} cannot be started ({e}). Tests with importers need Python 3.10 or later with \
             venv and pip; on Debian and Ubuntu: apt install python3 python3-venv",
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
