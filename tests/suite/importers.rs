//! The packed FMU in importers and masters of others, which the tests install for themselves. They
//! are heavy: `cargo test --test suite importers:: -- --ignored`.
//!
//! Needs Python 3.10 or later with venv, the package indexes of Python and Rust for the first run,
//! and for ecos the library libtbb12 (`apt install libtbb12`).

use crate::common;
use crate::packaged;
use crate::python;
use crate::tolerance;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use crate::python::run;
use wheelrail::element::Element;
use wheelrail::variables::{Value, Values, find};

const POSITIONS: &str = "tests/importers/positions.csv";

/// Rows of a table by the names of its columns.
struct Table {
    names: Vec<String>,
    rows: Vec<Vec<f64>>,
}

impl Table {
    fn read(path: &Path) -> Self {
        let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(path).unwrap();
        let names = reader.headers().unwrap().iter().map(str::to_owned).collect();
        let rows = reader.deserialize().map(Result::unwrap).collect();
        Self { names, rows }
    }

    /// Bits of all values; zero has one sign.
    fn bits(&self) -> Vec<Vec<u64>> {
        let bits = |row: &Vec<f64>| row.iter().map(|value| (value + 0.0).to_bits()).collect();
        self.rows.iter().map(bits).collect()
    }
}

fn in_tree(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// The Python that has the clients.
fn clients() -> PathBuf {
    static PYTHON: OnceLock<PathBuf> = OnceLock::new();
    let requirements = "tests/importers/requirements.txt";
    PYTHON.get_or_init(|| python::environment("importers-venv", requirements)).clone()
}

/// What a client written in Python answers.
fn answers(client: &str) -> Table {
    answers_of(client, &packaged::fmu())
}

/// The same for a unit.
fn answers_of(client: &str, unit: &Path) -> Table {
    let file = unit.file_stem().unwrap().to_string_lossy();
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{client}-{file}.csv"));
    let script = in_tree("tests/importers").join(format!("client_{client}.py"));
    let mut command = Command::new(clients());
    command.arg(script).arg(unit).arg(in_tree(POSITIONS)).arg(&file);
    run(&mut command, client);
    Table::read(&file)
}

/// The answers in FMPy, to which those of all others must be equal bit for bit.
fn in_fmpy() -> &'static Table {
    static ANSWERS: OnceLock<Table> = OnceLock::new();
    ANSWERS.get_or_init(|| answers("fmpy"))
}

fn same_as_in_fmpy(other: &Table) {
    assert_eq!(other.names, in_fmpy().names);
    assert_eq!(other.rows.len(), Table::read(&in_tree(POSITIONS)).rows.len());
    assert_eq!(other.bits(), in_fmpy().bits());
}

#[test]
#[ignore = "installs its client"]
fn fmpy_gets_the_forces_of_the_element() {
    let positions = Table::read(&in_tree(POSITIONS));
    let answers = in_fmpy();
    let mut values = Values::default();
    let mut element = Element::new(&values.parameters, &values.input, &[]).unwrap();
    let mut touching = 0;
    for (position, answers_of_row) in positions.rows.iter().zip(&answers.rows) {
        for (name, &value) in positions.names.iter().zip(position) {
            values.set(find(name).unwrap(), Value::Real(value)).unwrap();
        }
        element.evaluate(&values.input, &mut values.output).unwrap();
        touching += values.output.patch_count.min(1);
        for (name, answer) in answers.names.iter().zip(answers_of_row) {
            let Value::Real(own) = values.get(find(name).unwrap()) else { panic!("{name}") };
            let miss = (answer - own).abs();
            assert!(miss <= tolerance::OTHER_BUILD * own.abs(), "{name}: {answer}, here {own}");
        }
    }
    assert_eq!(positions.rows.len(), answers.rows.len());
    assert_eq!(touching, 7, "all wheels but the lifted one touch");
}

#[test]
#[ignore = "installs its client"]
fn libcosim_gets_the_same_bits() {
    same_as_in_fmpy(&answers("libcosim"));
}

#[test]
#[ignore = "installs its client"]
fn ecos_gets_the_same_bits() {
    same_as_in_fmpy(&answers("ecos"));
}

/// A profile, and a choice, which libcosim and ecos cannot set: both are in the unit, with a state for
/// model exchange and without.
#[test]
#[ignore = "installs its client"]
#[cfg(feature = "cli")]
fn a_packed_unit_is_the_same_in_all_of_them() {
    let mut forces = Vec::new();
    for has_state in [false, true] {
        let name = if has_state { "PackedWithState.fmu" } else { "Packed.fmu" };
        let unit = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        let mut pack = wheelrail::pack::Pack::open(&packaged::fmu()).unwrap();
        let profile = in_tree("fmu/resources/profiles/S1002_worn.txt");
        pack.set_wheel(profile.to_str().unwrap()).unwrap();
        pack.set("normal.model", "hertz").unwrap();
        if has_state {
            pack.add_dummy_state();
        }
        pack.write(&unit).unwrap();
        let first = answers_of("fmpy", &unit);
        assert_ne!(first.bits(), in_fmpy().bits());
        for client in ["libcosim", "ecos"] {
            assert_eq!(answers_of(client, &unit).bits(), first.bits(), "{client}, {name}");
        }
        assert_eq!(in_fmi_crate(&unit).bits(), first.bits(), "the fmi crate, {name}");
        forces.push(first.bits());
    }
    assert_eq!(forces[0], forces[1], "a state for model exchange changes no force");
}

#[test]
#[ignore = "installs its client"]
fn the_fmi_crate_gets_the_same_bits() {
    same_as_in_fmpy(&in_fmi_crate(&packaged::fmu()));
}

/// What the client of the fmi crate answers of a unit.
fn in_fmi_crate(unit: &Path) -> Table {
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join("fmi-crate");
    let file = target.join(unit.with_extension("csv").file_name().unwrap());
    let script = "import clang, pathlib; print(pathlib.Path(clang.__file__).parent / 'native')";
    let printed = |mut command: Command, what: &str| {
        let output = run(&mut command, what);
        String::from_utf8(output.stdout).unwrap().trim().to_owned()
    };
    let mut command = Command::new(clients());
    command.args(["-c", script]);
    let libclang = printed(command, "looking for libclang");
    // libclang from the package index comes without the compiler's own headers.
    let mut command = Command::new("cc");
    command.arg("-print-file-name=include");
    let headers = printed(command, "looking for the headers of the C compiler");
    let mut command = Command::new(env!("CARGO"));
    command
        .current_dir(in_tree("tests/importers/fmi_crate"))
        .args(["run", "--quiet", "--locked", "--target-dir"])
        .arg(&target)
        .arg("--")
        .arg(unit)
        .arg(in_tree(POSITIONS))
        .arg(&file)
        .arg(in_fmpy().names.join(","))
        .env("LIBCLANG_PATH", libclang)
        .env("BINDGEN_EXTRA_CLANG_ARGS", format!("-I{headers}"))
        .env_remove("CARGO_BUILD_TARGET");
    run(&mut command, "the client of the fmi crate");
    Table::read(&file)
}

#[test]
#[ignore = "installs its client"]
fn a_wheelset_in_exudyn_hunts_from_the_same_speed_on_as_in_rust() {
    let file = common::report_path("hunting.csv");
    let mut command = Command::new(clients());
    command
        .arg(in_tree("tests/importers/hunting.py"))
        .arg(&file)
        .env("WHEELRAIL_FMU", packaged::fmu())
        .env("WHEELRAIL", env!("CARGO_BIN_EXE_wheelrail"));
    let output = run(&mut command, "the wheelset in exudyn");
    print!("{}", String::from_utf8_lossy(&output.stdout));
    let table = Table::read(&file);
    let column = |name: &str| -> Vec<f64> {
        let place = table.names.iter().position(|n| n == name).unwrap();
        table.rows.iter().map(|row| row[place]).collect()
    };
    let speeds = column("speed_m_s");
    let [exudyn, rust] = ["growth_exudyn_1_s", "growth_rust_1_s"].map(column);
    assert!(exudyn.windows(2).all(|pair| pair[0] < pair[1]), "growth with speed: {exudyn:?}");
    let [in_exudyn, in_rust] = [exudyn, rust].map(|growth| critical_speed(&speeds, &growth));
    let miss = (in_exudyn - in_rust).abs() / in_rust;
    assert!(miss < tolerance::HUNTING_SPEED, "{in_exudyn} m/s in exudyn, {in_rust} m/s in Rust");
    for (speed, difference) in speeds.iter().zip(column("difference_of_y")) {
        assert!(
            difference < tolerance::HUNTING_MOTION,
            "{difference} of the amplitude at {speed} m/s"
        );
    }
}

/// Speed at which the growth rate crosses zero, once and from below.
fn critical_speed(speeds: &[f64], growth: &[f64]) -> f64 {
    let crossings: Vec<usize> =
        (1..growth.len()).filter(|&i| (growth[i - 1] < 0.0) != (growth[i] < 0.0)).collect();
    assert_eq!(crossings.len(), 1, "no single critical speed: {growth:?} at {speeds:?}");
    let i = crossings[0];
    let share = growth[i - 1] / (growth[i - 1] - growth[i]);
    speeds[i - 1] + share * (speeds[i] - speeds[i - 1])
}
