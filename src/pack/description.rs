//! `modelDescription.xml` with another name and other start values, for FMI 2.0 and 3.0.

use std::collections::BTreeSet;

use quick_xml::events::{BytesStart, Event};
use quick_xml::{Reader, Writer, XmlVersion};

use super::dummy_state::DummyState;
use super::error::PackError;
use crate::variables::{Described, Kind, Unit, Value, ValuesOf, Variable, WITH_STATE};

/// What is to be other than in the source.
pub struct Changes<'a> {
    /// Name of the model.
    pub name: Option<&'a str>,
    /// Its description.
    pub description: Option<&'a str>,
    /// Whose variables they are.
    pub unit: &'static Unit,
    /// Start value of a variable that can be set, as FMI writes it.
    pub start: &'a dyn Fn(&Variable) -> String,
    /// Whether it gets a dummy state.
    pub adds_state: bool,
}

/// Which unit a description is of.
pub struct Identity {
    /// `guid` or `instantiationToken`.
    pub token: String,
    /// `modelName`.
    pub model_name: String,
}

/// The start value of a variable as FMI writes it.
pub fn start<S: Described>(values: &ValuesOf<S>, variable: &Variable) -> String {
    match values.get(variable) {
        Value::Real(value) => format!("{value:?}"),
        Value::Integer(value) => value.to_string(),
        Value::Boolean(value) => value.to_string(),
        Value::Text(value) => value.into(),
    }
}

/// The attribute of an element, without its escapes.
pub fn attribute(element: &BytesStart<'_>, name: &str) -> Result<Option<String>, String> {
    let Some(found) = element.try_get_attribute(name).map_err(|e| e.to_string())? else {
        return Ok(None);
    };
    let value = found.normalized_value(XmlVersion::Implicit1_0).map_err(|e| e.to_string())?;
    Ok(Some(value.into_owned()))
}

/// Which unit a description is of.
pub fn identity(xml: &str) -> Result<Identity, String> {
    let mut reader = Reader::from_str(xml);
    loop {
        match reader.read_event().map_err(|e| e.to_string())? {
            Event::Start(element) if element.name().as_ref() == "fmiModelDescription" => {
                let given = |name| attribute(&element, name);
                let token = given("guid")?.or(given("instantiationToken")?);
                return Ok(Identity {
                    token: token.unwrap_or_default(),
                    model_name: given("modelName")?.unwrap_or_default(),
                });
            }
            Event::Eof => return Err("modelDescription.xml has no fmiModelDescription".into()),
            _ => {}
        }
    }
}

/// What stands at a place of a description, as variables are found.
#[derive(Default)]
pub struct Walk {
    is_within: bool,
    /// The variable whose element is open.
    pub variable: Option<String>,
}

impl Walk {
    /// Takes over the beginning of an element; gives the variable whose start value it may have.
    pub fn begin(&mut self, element: &BytesStart<'_>) -> Result<Option<String>, String> {
        match element.name().as_ref() {
            "ModelVariables" => self.is_within = true,
            _ if !self.is_within => {}
            // FMI 2.0: the type is an element of its own within it; 3.0: it is the type.
            "ScalarVariable" => self.variable = attribute(element, "name")?,
            "Start" | "Real" | "Integer" => return Ok(self.variable.clone()),
            "Boolean" | "String" | "Enumeration" | "Float64" | "Int32" => {
                if let Some(name) = attribute(element, "name")? {
                    self.variable = Some(name);
                }
                return Ok(self.variable.clone());
            }
            _ => {}
        }
        Ok(None)
    }

    /// Takes over the end of an element.
    pub fn end(&mut self, name: &str) {
        if name == "ModelVariables" {
            self.is_within = false;
        }
    }
}

/// The attribute in which an element holds a start value.
pub fn start_attribute(element: &BytesStart<'_>) -> &'static str {
    if element.name().as_ref() == "Start" { "value" } else { "start" }
}

/// The description with the changes.
///
/// # Errors
/// Another value of a variable that the description leaves out.
pub fn rewritten(xml: &str, changes: &Changes<'_>) -> Result<String, PackError> {
    let unsound = |reason: String| PackError::Unsound { reason };
    let mut reader = Reader::from_str(xml);
    let mut writer = Writer::new(Vec::new());
    let mut walk = Walk::default();
    let mut described = BTreeSet::new();
    let is_fmi_3 = xml.contains("instantiationToken=");
    let mut state = changes.adds_state.then(|| DummyState::new(changes.unit, is_fmi_3));
    loop {
        let event = reader.read_event().map_err(|e| unsound(e.to_string()))?;
        let mut behind = String::new();
        if let Some(state) = &mut state {
            let before = match &event {
                Event::Start(element) | Event::Empty(element) => {
                    state.before(element.name().as_ref())
                }
                Event::End(element) => {
                    behind = state.behind(element.name().as_ref());
                    state.before_end(element.name().as_ref())
                }
                _ => String::new(),
            };
            writer.get_mut().extend(before.into_bytes());
        }
        let event = match event {
            Event::Eof => break,
            Event::Start(element) => {
                let new = changed(&element, changes, &mut walk, &mut described);
                Event::Start(new.map_err(unsound)?)
            }
            Event::Empty(element) => {
                let new = changed(&element, changes, &mut walk, &mut described);
                Event::Empty(new.map_err(unsound)?)
            }
            Event::End(element) => {
                walk.end(element.name().as_ref());
                Event::End(element)
            }
            other => other,
        };
        writer.write_event(event).map_err(|e| unsound(e.to_string()))?;
        writer.get_mut().extend(behind.into_bytes());
    }
    for variable in changes.unit.variables.iter().filter(|v| v.is_settable()) {
        let declared = variable.start.map(declared);
        let is_changed = declared.as_deref() != Some(&*(changes.start)(variable));
        if is_changed && !described.contains(variable.name) {
            return Err(PackError::NotDescribed { name: variable.name });
        }
    }
    String::from_utf8(writer.into_inner()).map_err(|e| unsound(e.to_string()))
}

/// A start value of the declaration as FMI writes it.
fn declared(value: Value<'_>) -> String {
    match value {
        Value::Real(value) => format!("{value:?}"),
        Value::Integer(value) => value.to_string(),
        Value::Boolean(value) => value.to_string(),
        Value::Text(value) => value.into(),
    }
}

/// An element with what changes of its attributes.
fn changed(
    element: &BytesStart<'_>,
    changes: &Changes<'_>,
    walk: &mut Walk,
    described: &mut BTreeSet<&'static str>,
) -> Result<BytesStart<'static>, String> {
    if element.name().as_ref() == "fmiModelDescription" {
        let token = match attribute(element, "guid")? {
            Some(_) => "guid",
            None => "instantiationToken",
        };
        let identity = attribute(element, token)?.unwrap_or_default() + WITH_STATE;
        let identity = Some(&*identity).filter(|_| changes.adds_state);
        let (name, description) = (changes.name, changes.description);
        return with(
            element,
            &[("modelName", name), ("description", description), (token, identity)],
        );
    }
    let Some(name) = walk.begin(element)? else { return Ok(element.to_owned()) };
    let Ok(variable) = changes.unit.find(&name) else { return Ok(element.to_owned()) };
    let key = start_attribute(element);
    let Some(old) = attribute(element, key)?.filter(|_| variable.is_settable()) else {
        return Ok(element.to_owned());
    };
    described.insert(variable.name);
    let new = (changes.start)(variable);
    if is_same(variable, &old, &new) {
        return Ok(element.to_owned());
    }
    with(element, &[(key, Some(&new))])
}

/// Whether two texts are the same value: numbers are written in more than one way.
pub fn is_same(variable: &Variable, one: &str, other: &str) -> bool {
    let bits = |text: &str| text.parse().map(f64::to_bits).ok();
    one == other || (variable.kind == Kind::Real && bits(one).is_some() && bits(one) == bits(other))
}

/// An element with new values of attributes that it has.
fn with(
    element: &BytesStart<'_>,
    new: &[(&str, Option<&str>)],
) -> Result<BytesStart<'static>, String> {
    let mut copy = BytesStart::new(element.name().as_ref().to_owned());
    for found in element.attributes() {
        let found = found.map_err(|e| e.to_string())?;
        let key = found.key.as_ref().to_owned();
        match new.iter().find_map(|(name, value)| value.filter(|_| *name == key)) {
            Some(value) => copy.push_attribute((key.as_str(), value)),
            // As it stands, with its escapes.
            None => copy.push_attribute(found),
        }
    }
    Ok(copy.into_owned())
}
