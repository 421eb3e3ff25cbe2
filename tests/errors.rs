//! The tables of docs/errors.md: every row is provoked, its words compared, and what was asked is as usable afterwards as before.
//!
//! `UPDATE_DOCS=1 cargo test --test errors` writes the words that are found into the tables.
#![allow(unsafe_code)]

mod host;

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::ptr::null_mut;

use host::{Arguments, Host, reference};
use tempfile::TempDir;
use wheelrail::fmi::abi::*;
use wheelrail::fmi::types::{FALSE, FmuState, Status, TRUE};
use wheelrail::geometry::profile::ProfileKind;
use wheelrail::io::load_profile;
use wheelrail::variables::{Kind, VARIABLES, find};

/// What stands for anything.
const ANYTHING: &str = "…";

fn page() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/errors.md")
}

/// The rows of the table below a heading, as cells without their backquotes' meaning taken away.
fn rows(heading: &str) -> Vec<Vec<String>> {
    let text = fs::read_to_string(page()).unwrap();
    let lines = text.lines().skip_while(|line| *line != format!("## {heading}"));
    let table = lines.skip_while(|line| !line.starts_with("|---")).skip(1);
    let rows: Vec<Vec<String>> = table
        .take_while(|line| line.starts_with('|'))
        .map(|line| line.trim().trim_matches('|').split('|').map(|c| c.trim().into()).collect())
        .collect();
    assert!(!rows.is_empty(), "{heading}");
    rows
}

/// What stands between backquotes in a cell.
fn code(cell: &str) -> Vec<&str> {
    cell.split('`').skip(1).step_by(2).collect()
}

/// Whether `message` is `pattern`, in which [`ANYTHING`] stands for anything.
fn fits(message: &str, pattern: &str) -> bool {
    let parts: Vec<&str> = pattern.split(ANYTHING).collect();
    let [first, middle @ .., last] = parts.as_slice() else { return message == pattern };
    let Some(rest) = message.strip_prefix(first).and_then(|rest| rest.strip_suffix(last)) else {
        return false;
    };
    let found = |rest: &str, part: &str| rest.find(part).map(|at| at + part.len());
    let mut at = 0;
    middle.iter().all(|part| {
        found(&rest[at..], part).is_some_and(|end| {
            at += end;
            true
        })
    })
}

/// A message on one line, with what differs from run to run left out, as a cell of a table.
fn as_cell(message: &str, folder: &Path) -> String {
    let here = std::env::current_dir().unwrap();
    let mut cell = message.trim().replace('\n', " ");
    for path in [folder, Path::new(env!("CARGO_MANIFEST_DIR")), &here] {
        cell = cell.replace(&path.display().to_string(), ANYTHING);
    }
    cell.replace('|', "/")
}

/// Cells as a line of a table.
fn line(cells: &[String]) -> String {
    let cells = cells.iter().map(|c| if c.is_empty() { String::new() } else { format!(" {c}") });
    format!("|{} |", cells.collect::<Vec<_>>().join(" |"))
}

/// Compares what a row says with what was said; collects what differs, or writes the row anew.
fn compare(heading: &str, said: &[(Vec<String>, String)]) {
    let update = std::env::var_os("UPDATE_DOCS").is_some();
    let mut differences = String::new();
    for (row, message) in said {
        let (pattern, provocation) = row.split_last().unwrap();
        assert!(!message.is_empty(), "{heading}: {provocation:?} is not refused");
        if update && !fits(message, pattern) {
            let text = fs::read_to_string(page()).unwrap();
            let old = line(row);
            let new = line(&[provocation, std::slice::from_ref(message)].concat());
            assert!(text.contains(&old), "{old}");
            fs::write(page(), text.replace(&old, &new)).unwrap();
        } else if !fits(message, pattern) {
            writeln!(differences, "{provocation:?} says\n  {message}\nand not\n  {pattern}")
                .unwrap();
        }
    }
    assert!(differences.is_empty(), "{heading}\n{differences}");
}

/// Everything that an instance remembers, as bytes.
fn state_of(host: &Host) -> Vec<u8> {
    let mut state: FmuState = null_mut();
    let mut size = 0;
    // SAFETY: FMI 2.0, 2.1.8: one state, one size, and as many bytes as it says.
    unsafe {
        assert_eq!(fmi2GetFMUstate(host.component, &raw mut state), Status::Ok, "{}", host.last());
        assert_eq!(fmi2SerializedFMUstateSize(host.component, state, &raw mut size), Status::Ok);
        let mut bytes = vec![0u8; size];
        let start = bytes.as_mut_ptr().cast();
        assert_eq!(fmi2SerializeFMUstate(host.component, state, start, size), Status::Ok);
        assert_eq!(fmi2FreeFMUstate(host.component, &raw mut state), Status::Ok);
        bytes
    }
}

/// Runs `call`, which has to be refused, and asserts that the state stays; gives the message.
fn refusal(host: &Host, call: impl FnOnce(&Host) -> Status) -> String {
    let before = state_of(host);
    host.messages.lock().unwrap().clear();
    let status = call(host);
    let message = host.last();
    assert_eq!(status, Status::Error, "{message}");
    assert!(state_of(host) == before, "the state has changed: {message}");
    message
}

/// Vertical force of a wheel that is pressed on the rail, wherever in its life the instance is; it steps afterwards.
fn force(host: &Host) -> f64 {
    assert_eq!(fmi2Reset(host.component), Status::Ok);
    assert_eq!(fmi2SetupExperiment(host.component, FALSE, 0.0, 0.0, FALSE, 0.0), Status::Ok);
    assert_eq!(fmi2EnterInitializationMode(host.component), Status::Ok);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
    let z = host.get_real("nominal.wheel_z") + 1e-4;
    assert_eq!(host.set_reals(&[("wheel.z", z), ("wheel.vx", 20.0)]), Status::Ok);
    host.get_real("wheel.force.z")
}

fn assert_usable(host: &Host, what: &str) {
    let fresh = force(&Host::new());
    assert!(fresh < -1e4);
    assert_eq!(force(host).to_bits(), fresh.to_bits(), "{what}");
}

/// Sets a variable of any type from text.
fn set(host: &Host, name: &str, value: &str) -> Status {
    match find(name).unwrap().kind {
        Kind::Real => host.set_reals(&[(name, value.parse().unwrap())]),
        Kind::Integer | Kind::Enumeration(_) => host.set_integer(name, value.parse().unwrap()),
        Kind::Text => host.set_text(name, value),
        Kind::Boolean => panic!("{name}: a truth cannot be wrong"),
    }
}

/// What is said to settings such as `wheel.y = NaN`, when they are set or when initialization mode is left.
fn refused_settings(settings: &[&str], folder: Option<&Path>) -> String {
    let location = folder.map(|f| format!("file://{}", f.display()));
    let arguments = match location {
        Some(location) => {
            let location = Some(std::ffi::CString::new(location).unwrap());
            Arguments { location, ..Arguments::default() }
        }
        None => Arguments::default(),
    };
    let host = Host::instantiate(&arguments);
    assert_eq!(fmi2SetupExperiment(host.component, FALSE, 0.0, 0.0, FALSE, 0.0), Status::Ok);
    assert_eq!(fmi2EnterInitializationMode(host.component), Status::Ok);
    let mut message = String::new();
    for setting in settings {
        let (name, value) = setting.split_once('=').unwrap();
        let (name, value) = (name.trim(), value.trim());
        let before = state_of(&host);
        if set(&host, name, value) != Status::Ok {
            message = host.last();
            assert!(state_of(&host) == before, "the state has changed: {message}");
            assert!(message.contains(name) && message.contains(value), "{message}");
        }
    }
    if message.is_empty() {
        message = refusal(&host, |host| fmi2ExitInitializationMode(host.component));
        let named = settings.iter().any(|s| message.contains(s.split_once(" =").unwrap().0));
        assert!(named, "{message}");
    }
    assert_usable(&host, &message);
    message
}

#[test]
fn variables() {
    let folder = TempDir::new().unwrap();
    let said = rows("Variables").into_iter().map(|row| {
        let message = refused_settings(&code(&row[0]), None);
        (row, as_cell(&message, folder.path()))
    });
    compare("Variables", &said.collect::<Vec<_>>());
}

#[test]
fn every_real_variable_refuses_what_is_out_of_its_range() {
    let host = Host::initializing();
    let mut count = 0;
    for variable in VARIABLES.iter().filter(|v| v.kind == Kind::Real && v.is_settable()) {
        let beyond = [variable.min.map(|m| m - 1.0), variable.max.map(|m| 2.0 * m.abs() + 1.0)];
        let bad = [Some(f64::NAN), Some(f64::INFINITY), Some(f64::NEG_INFINITY)];
        for value in bad.into_iter().chain(beyond).flatten() {
            let message = refusal(&host, |host| host.set_reals(&[(variable.name, value)]));
            let words =
                format!("{} = {value} is not admitted: {}", variable.name, variable.allowed);
            assert_eq!(message, format!("fmi2SetReal: {words}"));
            count += 1;
        }
    }
    assert!(count > 300, "{count}");
    assert_usable(&host, "ranges");
}

/// Points of a standard profile [mm].
fn points(name: &str, kind: ProfileKind) -> Vec<[f64; 2]> {
    let curve = load_profile("profile", name, kind, 0.0, &[]).unwrap().curve;
    let at = |i: i32| curve.start() + f64::from(i) / 300.0 * (curve.end() - curve.start());
    (0..=300).map(|i| curve.at(at(i)).point.map(|x| 1e3 * x)).collect()
}

/// A file by the words that describe it.
fn described(words: &str) -> String {
    let (rail, wheel) = (points("60E1", ProfileKind::Rail), points("S1002", ProfileKind::Wheel));
    let changed = |points: &[[f64; 2]], change: fn([f64; 2]) -> [f64; 2]| -> Vec<[f64; 2]> {
        points.iter().map(|p| change(*p)).collect()
    };
    let points = match words {
        "60E1 in metres" => changed(&rail, |p| p.map(|x| 1e-3 * x)),
        "60E1 with z up" => changed(&rail, |[y, z]| [y, -z]),
        "S1002 with z up" => changed(&wheel, |[y, z]| [y, -z]),
        "S1002 with its flange on the field side" => changed(&wheel, |[y, z]| [-y, z]),
        "S1002 a metre off its running circle" => changed(&wheel, |[y, z]| [y - 1000.0, z]),
        "60E1 without its sides" => rail.into_iter().filter(|[_, z]| *z < 8.0).collect(),
        "60E1 with two points exchanged" => {
            let mut points = rail;
            points.swap(150, 155);
            points
        }
        "S1002 with a loop" => {
            let mut points = wheel;
            let [y, z] = points[200];
            let ring = (0..24).map(|i| {
                let angle = 0.25 * f64::from(i);
                [y + 4.0 * angle.sin(), z + 4.0 - 4.0 * angle.cos()]
            });
            points.splice(201..=201, ring);
            points
        }
        _ => panic!("{words}: unknown"),
    };
    points.iter().fold(String::new(), |text, [y, z]| text + &format!("{y:.5} {z:.5}\n"))
}

/// The content of a file from its cell: code, lines parted by slashes, or words that describe it.
fn content(cell: &str) -> String {
    code(cell).first().map_or_else(
        || described(cell),
        |code| code.replace(" / ", "\n").replace("\n/ ", "\n\n") + "\n",
    )
}

fn files(heading: &str) {
    let folder = TempDir::new().unwrap();
    // Profiles are looked for there.
    let profiles = folder.path().join("profiles");
    fs::create_dir(&profiles).unwrap();
    let said = rows(heading).into_iter().map(|row| {
        let setting = code(&row[0])[0];
        let (parameter, name) = setting.split_once(" = ").unwrap();
        fs::write(profiles.join(name), content(&row[1])).unwrap();
        let message = refused_settings(&[setting], Some(folder.path()));
        assert!(message.contains(parameter) && message.contains(name), "{message}");
        (row, as_cell(&message, &profiles))
    });
    compare(heading, &said.collect::<Vec<_>>());
}

#[test]
fn profile_files() {
    files("Profile files");
}

#[test]
fn files_of_deviations() {
    files("Files of deviations");
}

/// The message of an instance that is not made.
fn not_made(change: impl FnOnce(&mut Arguments)) -> String {
    let mut arguments = Arguments::default();
    change(&mut arguments);
    let host = Host::instantiate(&arguments);
    assert!(host.component.is_null());
    host.last()
}

/// The message of a call on a stepping instance, which goes on as before.
fn stepping(call: impl FnOnce(&Host) -> Status) -> String {
    refused_on(&Host::stepping(), call)
}

fn refused_on(host: &Host, call: impl FnOnce(&Host) -> Status) -> String {
    let message = refusal(host, call);
    if host.step(0.0, 1e-3) != Status::Ok {
        assert_usable(host, &message);
    }
    message
}

fn derivatives(host: &Host, name: &str, value: f64) -> Status {
    // SAFETY: FMI 2.0, 2.1.7: arrays of one element.
    unsafe {
        fmi2SetRealInputDerivatives(host.component, &reference(name), 1, &1, &raw const value)
    }
}

/// Derivative of the variable `unknown` by the variable `known` along `seed`.
fn directional(host: &Host, unknown: &str, known: &str, seed: f64) -> Status {
    let mut found = 0.0;
    // SAFETY: FMI 2.0, 2.1.9: arrays of one element.
    unsafe {
        fmi2GetDirectionalDerivative(
            host.component,
            &reference(unknown),
            1,
            &reference(known),
            1,
            &raw const seed,
            &raw mut found,
        )
    }
}

fn called(words: &str) -> String {
    match words {
        "`fmi2Instantiate` without a name" => not_made(|a| a.name = None),
        "`fmi2Instantiate` with another GUID" => not_made(|a| a.guid = Some(c"{1-2-3}".into())),
        "`fmi2Instantiate` with type 2" => not_made(|a| a.fmu_type = 2),
        "`fmi2DoStep` before initialization" => refused_on(&Host::new(), |h| h.step(0.0, 1e-3)),
        "`fmi2GetReal` before initialization" => {
            refused_on(&Host::new(), |h| h.get_reals(&["wheel.force.z"]).unwrap_err())
        }
        "`fmi2SetReal` of a parameter after initialization" => {
            stepping(|h| h.set_reals(&[("track.gauge", 1.5)]))
        }
        "`fmi2SetReal` with a reference that no variable has" => {
            // SAFETY: FMI 2.0, 2.1.7: arrays of one element, or null, which is refused.
            stepping(|h| unsafe { fmi2SetReal(h.component, &99_999, 1, &1.0) })
        }
        "`fmi2SetReal` of an integer" => {
            let integer = reference("normal.strips");
            // SAFETY: as above.
            stepping(|h| unsafe { fmi2SetReal(h.component, &raw const integer, 1, &1.0) })
        }
        "`fmi2SetReal` without values" => {
            let real = reference("wheel.y");
            // SAFETY: as above.
            stepping(|h| unsafe { fmi2SetReal(h.component, &raw const real, 1, std::ptr::null()) })
        }
        "`fmi2SetRealInputDerivatives` that are no number" => {
            stepping(|h| derivatives(h, "wheel.y", f64::NAN))
        }
        "`fmi2SetRealInputDerivatives` of an output" => {
            stepping(|h| derivatives(h, "wheel.force.z", 1.0))
        }
        "`fmi2GetDirectionalDerivative` of an input" => {
            stepping(|h| directional(h, "wheel.y", "wheel.z", 1.0))
        }
        "`fmi2GetDirectionalDerivative` by a parameter" => {
            stepping(|h| directional(h, "wheel.force.z", "track.gauge", 1.0))
        }
        "`fmi2GetDirectionalDerivative` along what is no number" => {
            stepping(|h| directional(h, "wheel.force.z", "wheel.z", f64::NAN))
        }
        "`fmi2GetRealOutputDerivatives`" => stepping(|h| {
            let (output, order, mut value) = (reference("wheel.force.z"), 1, 0.0);
            let order = &raw const order;
            fmi2GetRealOutputDerivatives(h.component, &raw const output, 1, order, &raw mut value)
        }),
        "`fmi2SetString` to what is not UTF-8" => refused_on(&Host::initializing(), |h| {
            let (text, variable) = (c"\xff".as_ptr(), reference("wheel.profile"));
            // SAFETY: FMI 2.0, 2.1.2 and 2.1.7: arrays of one element, a null-terminated text.
            unsafe { fmi2SetString(h.component, &raw const variable, 1, &raw const text) }
        }),
        "`fmi2DoStep` over a negative step" => stepping(|h| h.step(0.0, -1e-3)),
        "`fmi2DoStep` from a time that is no number" => stepping(|h| h.step(f64::NAN, 1e-3)),
        "`fmi2DoStep` beyond the stop time" => {
            let host = Host::new();
            let component = host.component;
            assert_eq!(fmi2SetupExperiment(component, FALSE, 0.0, 0.0, TRUE, 1.0), Status::Ok);
            assert_eq!(fmi2EnterInitializationMode(component), Status::Ok);
            assert_eq!(fmi2ExitInitializationMode(component), Status::Ok);
            refused_on(&host, |h| h.step(2.0, 1e-3))
        }
        "`fmi2SetupExperiment` that stops before it starts" => refused_on(&Host::new(), |h| {
            fmi2SetupExperiment(h.component, FALSE, 0.0, 1.0, TRUE, 0.5)
        }),
        "`fmi2EnterEventMode` for co-simulation" => stepping(|h| fmi2EnterEventMode(h.component)),
        "`fmi2DoStep` for model exchange" => {
            refused_on(&Host::in_event_mode(), |h| h.step(0.0, 1e-3))
        }
        "`fmi2SetFMUstate` to a state that is none" => {
            stepping(|h| fmi2SetFMUstate(h.component, null_mut()))
        }
        "`fmi2DeSerializeFMUstate` of other bytes" => stepping(|h| {
            let (bytes, mut state) = ([7; 64], null_mut());
            // SAFETY: FMI 2.0, 2.1.8: as many bytes as the count says, one state.
            unsafe { fmi2DeSerializeFMUstate(h.component, bytes.as_ptr(), 64, &raw mut state) }
        }),
        "`fmi2SetDebugLogging` of a category that is none" => stepping(|h| {
            let name = c"logEverything".as_ptr();
            // SAFETY: FMI 2.0, 2.1.5: an array of one null-terminated text.
            unsafe { fmi2SetDebugLogging(h.component, TRUE, 1, &raw const name) }
        }),
        _ => panic!("{words}: unknown"),
    }
}

#[test]
fn calls_of_the_interface() {
    let said = rows("Calls of the interface").into_iter().map(|row| {
        let message = called(&row[0]);
        (row, as_cell(&message, Path::new("/nowhere")))
    });
    compare("Calls of the interface", &said.collect::<Vec<_>>());
}

#[test]
fn command_line() {
    let said = rows("Command line").into_iter().map(|row| {
        let folder = TempDir::new().unwrap();
        let file = folder.path().join("cases.csv");
        if let Some(code) = code(&row[1]).first() {
            let text = code.replace(" / ", "\n").replace("FILE", "cases.csv");
            fs::write(&file, text + "\n").unwrap();
        }
        let arguments = code(&row[0])[0].split(' ');
        let arguments = arguments.map(|a| a.replace("FILE", &file.display().to_string()));
        let output = Command::new(env!("CARGO_BIN_EXE_wheelrail"))
            .args(arguments)
            .current_dir(folder.path())
            .stdin(Stdio::null())
            .output()
            .unwrap();
        assert_eq!(output.status.code(), Some(1), "{row:?}: {output:?}");
        let message = String::from_utf8(output.stderr).unwrap();
        let message = message.strip_prefix("error: ").unwrap_or_else(|| panic!("{message}"));
        let message = message.replace("\n  caused by: ", ": ");
        (row, as_cell(&message, folder.path()))
    });
    compare("Command line", &said.collect::<Vec<_>>());
}

#[test]
fn patterns_fit_as_they_say() {
    for (message, pattern, wanted) in [
        ("a is b", "a is b", true),
        ("a is b", "a … b", true),
        ("a is b", "a is", false),
        ("a is b", "…b", true),
        ("a is b, b", "…b", true),
        ("a is b c", "…b", false),
        ("a is b", "b", false),
        ("a is b or c", "a … b … c", true),
        ("a is c or b", "a … b … c", false),
    ] {
        assert_eq!(fits(message, pattern), wanted, "{message:?} {pattern:?}");
    }
}
