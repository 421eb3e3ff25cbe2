//! Whether an archive holds what it is to hold: read as an importer reads it.

use std::collections::BTreeMap;
use std::path::Path;

use quick_xml::Reader;
use quick_xml::events::Event;

use super::description::{Walk, attribute, is_same, start, start_attribute};
use super::error::PackError;
use super::files::{FOLDER, Files};
use super::source::contents;
use crate::variables::{Described, START_FILE, ValuesOf, Variable};

/// Checks an archive of these values: every entry can be read, description and start file have the
/// values, files are named by relative paths, and the element can be made of what is in the
/// resources.
pub fn archive<S: Described>(bytes: &[u8], values: &ValuesOf<S>) -> Result<(), PackError> {
    let unsound = |reason: String| PackError::Unsound { reason };
    let (entries, libraries) = contents(bytes).map_err(unsound)?;
    if libraries.is_empty() {
        return Err(unsound("it has no library".into()));
    }
    let text = |name: &str| {
        let bytes = entries.get(name).ok_or_else(|| unsound(format!("{name} is missing")))?;
        String::from_utf8(bytes.clone()).map_err(|e| unsound(format!("{name}: {e}")))
    };
    let starts = starts(&text("modelDescription.xml")?).map_err(unsound)?;
    let variable_at = |name: &String| S::UNIT.find(name).ok();
    for (variable, given) in starts.iter().filter_map(|(n, s)| Some((variable_at(n)?, s))) {
        let wanted = start(values, variable);
        if !is_same(variable, given, &wanted) {
            let name = variable.name;
            return Err(unsound(format!("{name} starts at {given} and not at {wanted}")));
        }
        check_path(variable, given).map_err(unsound)?;
    }
    let of_file = ValuesOf::<S>::from_start_file(&text(&format!("resources/{START_FILE}"))?);
    let of_file = of_file.map_err(|e| unsound(format!("{START_FILE}, {e}")))?;
    if of_file.parameters != values.parameters || of_file.input != values.input {
        return Err(unsound(format!("{START_FILE} has other values")));
    }
    let within = |name: &str| name.strip_prefix(FOLDER).map(str::to_owned);
    let files = entries.iter().filter_map(|(name, c)| Some((within(name)?, c.clone()))).collect();
    let folder = Files::new(files).unpacked().map_err(|e| unsound(e.to_string()))?;
    S::prepare(&values.parameters, &values.input, &[folder.path().to_path_buf()])?;
    Ok(())
}

/// Files that a unit reads are its own: what is absolute would not be there on another machine.
fn check_path(variable: &Variable, given: &str) -> Result<(), String> {
    let is_read = !variable.name.contains("wear.") && Path::new(given).is_absolute();
    if is_read { Err(format!("{} = \"{given}\" is absolute", variable.name)) } else { Ok(()) }
}

/// Start values by the names of their variables.
fn starts(xml: &str) -> Result<BTreeMap<String, String>, String> {
    let mut reader = Reader::from_str(xml);
    let (mut walk, mut starts) = (Walk::default(), BTreeMap::new());
    loop {
        match reader.read_event().map_err(|e| e.to_string())? {
            Event::Start(element) | Event::Empty(element) => {
                let variable = walk.begin(&element)?;
                let start = attribute(&element, start_attribute(&element))?;
                starts.extend(variable.zip(start));
            }
            Event::End(element) => walk.end(element.name().as_ref()),
            Event::Eof => return Ok(starts),
            _ => {}
        }
    }
}
