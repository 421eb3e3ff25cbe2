//! Writes `terminalsAndIcons.xml` of FMI 3.0 (section 2.4.9): a terminal for each body, with its
//! motion and the forces on it.

use std::collections::BTreeMap;
use std::io::{Result, Write};

use quick_xml::writer::Writer;

use crate::declaration::{Causality, Declaration, Kind};
use crate::xml::optional;

/// A terminal with its members, name and variable, and those within it.
#[derive(Default)]
struct Terminal {
    members: Vec<(String, String)>,
    within: BTreeMap<String, Terminal>,
}

/// The text of the file.
pub fn generate(declaration: &Declaration) -> Result<Vec<u8>> {
    let mut text = b"<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n".to_vec();
    let mut writer = Writer::new_with_indent(&mut text, b' ', 2);
    let root = writer.create_element("fmiTerminalsAndIcons").with_attribute(("fmiVersion", "3.0"));
    root.write_inner_content(|w| {
        w.create_element("GraphicalRepresentation").write_inner_content(|w| {
            let corners = [("x1", "-100"), ("y1", "-100"), ("x2", "100"), ("y2", "100")];
            w.create_element("CoordinateSystem")
                .with_attributes(corners)
                .with_attribute(("suggestedScalingFactorTo_mm", "0.1"))
                .write_empty()?;
            w.create_element("Icon").with_attributes(corners).write_empty().map(drop)
        })?;
        w.create_element("Terminals").write_inner_content(|w| {
            terminals(declaration).iter().try_for_each(|(name, one)| terminal(w, name, one))
        })?;
        Ok(())
    })?;
    text.push(b'\n');
    Ok(text)
}

/// Those of the bodies: what has inputs and a force behind its name, `wheel`, `rail[1]`, in a
/// wheelset `right.wheel`.
fn terminals(declaration: &Declaration) -> BTreeMap<String, Terminal> {
    let mut bodies: BTreeMap<&str, Vec<(Causality, &str, &str)>> = BTreeMap::new();
    for v in declaration.variables.iter().filter(|v| v.array.is_none()) {
        let is_signal = matches!(v.causality, Causality::Input | Causality::Output);
        let Some((body, member)) = body_and_member(&v.name) else { continue };
        if is_signal && matches!(v.kind, Kind::Real(_)) {
            bodies.entry(body).or_default().push((v.causality, member, &v.name));
        }
    }
    let mut all = BTreeMap::new();
    for (body, members) in bodies {
        let moves = members.iter().any(|(causality, ..)| *causality == Causality::Input);
        let is_loaded = members.iter().any(|(_, member, _)| member.starts_with("force."));
        if !(moves && is_loaded) {
            continue;
        }
        // A side with the bodies on it.
        let mut place = &mut all;
        let mut names = body.split('.').peekable();
        while let Some(name) = names.next() {
            let terminal: &mut Terminal = place.entry(name.to_owned()).or_default();
            if names.peek().is_none() {
                let members = members.iter();
                terminal.members =
                    members.map(|(_, m, name)| ((*m).into(), (*name).into())).collect();
                break;
            }
            place = &mut terminal.within;
        }
    }
    all
}

/// `rail[1]` and `force.x` of `rail[1].force.x`.
fn body_and_member(name: &str) -> Option<(&str, &str)> {
    let end = [".force.", ".moment."].iter().find_map(|part| name.find(part));
    let end = end.or_else(|| name.rfind('.'))?;
    Some((&name[..end], &name[end + 1..]))
}

fn terminal<W: Write>(writer: &mut Writer<W>, name: &str, terminal: &Terminal) -> Result<()> {
    // A host may connect some members alone, so that not a plug.
    let element = writer
        .create_element("Terminal")
        .with_attribute(("name", name))
        .with_attribute(("matchingRule", "bus"));
    let description = (!terminal.members.is_empty())
        .then(|| "Motion of the body, and the forces of all contacts on it".to_owned());
    optional(element, "description", description).write_inner_content(|w| {
        for (member, variable) in &terminal.members {
            w.create_element("TerminalMemberVariable")
                .with_attribute(("variableName", &**variable))
                .with_attribute(("memberName", &**member))
                .with_attribute(("variableKind", "signal"))
                .write_empty()?;
        }
        terminal.within.iter().try_for_each(|(name, one)| self::terminal(w, name, one))
    })?;
    Ok(())
}
