//! The packed FMU in a real importer, `FMPy`, in a virtual environment that the test makes.
//!
//! Needs Python 3.10 or later with venv, and the package index for the first run.

use crate::packaged;
use crate::python;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use crate::python::run;

#[test]
fn fmpy_finds_the_unit_valid_and_well_behaved() {
    check("check_interface.py");
}

#[test]
fn fmpy_gets_the_forces_of_a_wheel_on_a_rail() {
    check("check_mechanics.py");
}

#[test]
fn a_wheel_with_mass_is_given_back_no_more_energy_than_it_gave() {
    check("check_energy.py");
}

#[test]
fn fmpy_gets_from_a_wheelset_what_two_wheels_give() {
    check("check_wheelset.py");
}

#[test]
fn fmpy_gets_through_fmi_3_what_it_gets_through_fmi_2() {
    check("check_fmi3.py");
}

/// Needs the command line besides.
#[test]
#[cfg(feature = "cli")]
fn fmpy_gets_from_packed_units_what_their_users_put_in() {
    check("check_packed.py");
}

#[test]
fn a_bogie_hunts_from_its_published_speed_on() {
    check("check_vehicles.py");
}

/// Needs a C compiler, `cc`, besides.
#[test]
fn fmpy_runs_a_system_of_a_wheelset_and_a_mass() {
    check("check_structure.py");
}

#[test]
fn the_example_for_fmpy_runs() {
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/fmpy_drop.py");
    run(Command::new(fmpy()).arg(example).arg(packaged::fmu()), "examples/fmpy_drop.py");
}

/// Runs one file of checks on the packed FMU.
fn check(file: &str) {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fmpy").join(file);
    let reports = Path::new(env!("CARGO_MANIFEST_DIR")).join("target/reports");
    std::fs::create_dir_all(&reports).expect("target/reports can be made");
    let report = reports.join(Path::new(file).with_extension("csv"));
    let mut command = Command::new(fmpy());
    let command = command.arg(script).env("WHEELRAIL_FMU", packaged::fmu());
    let command = command.env("WHEELRAIL_WHEELSET", packaged::wheelset());
    let command = command
        .env("WHEELRAIL_PROGRAM", option_env!("CARGO_BIN_EXE_wheelrail").unwrap_or_default());
    run(command.env("WHEELRAIL_REPORT", report), file);
}

/// The Python that has `FMPy`.
fn fmpy() -> PathBuf {
    static PYTHON: OnceLock<PathBuf> = OnceLock::new();
    PYTHON.get_or_init(|| python::environment("fmpy-venv", "tests/fmpy/requirements.txt")).clone()
}
