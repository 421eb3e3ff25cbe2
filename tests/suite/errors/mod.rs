//! The tables of tests/suite/errors/refusals.md: every row is provoked, its words compared, and what was asked is
//! as usable afterwards as before.
//!
//! `UPDATE_DOCS=1 cargo test --test suite errors::` writes the words that are found into the
//! tables.
#![allow(unsafe_code)]

mod calls;
mod calls3;
mod files;
mod table;

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::ptr::null_mut;

use crate::host::{Arguments, Host};
use table::{as_cell, code, compare, rows};
use tempfile::TempDir;
use wheelrail::fmi::v2::types::{FALSE, FmuState, Status};
use wheelrail::fmi::v2::*;
use wheelrail::variables::{Kind, VARIABLES, find};

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

/// Vertical force of a wheel that is pressed on the rail, wherever in its life the instance is; it
/// steps afterwards.
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

/// What is said to settings such as `wheel.y = NaN`, when they are set or when initialization mode
/// is left.
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

/// What is warned of in an instance that starts with the settings `start` and then gets `later`
/// ones.
fn warned(start: &[&str], later: &[&str]) -> String {
    let host = Host::initializing();
    let set = |settings: &[&str]| {
        for setting in settings {
            let (name, value) = setting.split_once(" = ").unwrap();
            let status = match find(name).unwrap().kind {
                Kind::Boolean => host.set_boolean(name, value == "1"),
                _ => set(&host, name, value),
            };
            assert_eq!(status, Status::Ok, "{}", host.last());
        }
    };
    set(start);
    let mut status = fmi2ExitInitializationMode(host.component);
    if !later.is_empty() {
        assert_eq!(status, Status::Ok, "{}", host.last());
        set(later);
        status = Status::Warning;
        assert!(host.get_reals(&["wheel.force.z"]).is_ok());
    }
    assert_eq!(status, Status::Warning);
    let messages = host.messages.lock().unwrap().clone();
    assert_eq!(messages.len(), 1, "{messages:?}");
    assert_eq!(messages[0].category, "logStatusWarning");
    host.last()
}

#[test]
fn warnings() {
    let said = rows("Warnings").into_iter().map(|row| {
        let message = warned(&code(&row[0]), &code(&row[1]));
        (row, message)
    });
    compare("Warnings", &said.collect::<Vec<_>>());
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
        // Warnings come before.
        let is_warning = |line: &&str| line.starts_with("warning: ");
        let message = message.split_inclusive('\n').skip_while(is_warning).collect::<String>();
        let message = message.strip_prefix("error: ").unwrap_or_else(|| panic!("{message}"));
        let message = message.replace("\n  caused by: ", ": ");
        (row, as_cell(&message, folder.path()))
    });
    compare("Command line", &said.collect::<Vec<_>>());
}
