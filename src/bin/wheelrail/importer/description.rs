//! What an importer needs of `modelDescription.xml`.

use std::collections::HashMap;

use anyhow::{Context, Result, bail};
use quick_xml::events::{BytesStart, Event};
use quick_xml::{Reader, XmlVersion};

/// Type of a variable.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Kind {
    /// `fmi2Real`.
    Real,
    /// `fmi2Integer`.
    Integer,
    /// `fmi2Boolean`.
    Boolean,
    /// `fmi2String`.
    String,
    /// `fmi2Integer` whose values have names, listed under this type.
    Enumeration(String),
}

/// One scalar variable.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Variable {
    /// Key of the variable in the C interface.
    pub value_reference: u32,
    /// Type.
    pub kind: Kind,
}

/// The parts of a model description that an importer works with.
#[derive(Clone, Debug, Default)]
pub struct ModelDescription {
    /// Name of the model.
    pub model_name: String,
    /// Identification that the library checks.
    pub guid: String,
    /// File name of the library, without extension.
    pub model_identifier: String,
    variables: HashMap<String, Variable>,
    /// Names and values of the items of each enumeration type.
    enumerations: HashMap<String, Vec<(String, i32)>>,
}

impl ModelDescription {
    /// Reads the text of a `modelDescription.xml`.
    pub fn parse(text: &str) -> Result<Self> {
        let mut reader = Reader::from_str(text);
        let mut description = Self::default();
        let mut simple_type = String::new();
        let mut variable = None;
        loop {
            let event = reader.read_event().context("modelDescription.xml is not valid XML")?;
            match event {
                Event::Start(element) | Event::Empty(element) => {
                    description.element(&element, &mut simple_type, &mut variable)?;
                }
                Event::Eof => break,
                _ => {}
            }
        }
        if description.guid.is_empty() {
            bail!("modelDescription.xml has no fmiModelDescription with a guid");
        }
        if description.model_identifier.is_empty() {
            bail!("{} has no CoSimulation part: only co-simulation is run", description.model_name);
        }
        Ok(description)
    }

    /// The variable called `name`.
    pub fn variable(&self, name: &str) -> Result<&Variable> {
        self.variables.get(name).with_context(|| {
            format!(
                "the model {} has no variable \"{name}\": its modelDescription.xml lists them",
                self.model_name
            )
        })
    }

    /// Value of the item called `item` of the enumeration type `type_name`.
    pub fn item(&self, type_name: &str, item: &str) -> Result<i32> {
        let items = self.enumerations.get(type_name).map_or(&[][..], Vec::as_slice);
        items.iter().find(|(name, _)| name == item).map(|&(_, value)| value).with_context(|| {
            let names: Vec<&str> = items.iter().map(|(name, _)| name.as_str()).collect();
            format!("\"{item}\" is not one of {}", names.join(", "))
        })
    }

    fn element(
        &mut self,
        element: &BytesStart<'_>,
        simple_type: &mut String,
        variable: &mut Option<(String, u32)>,
    ) -> Result<()> {
        let name = element.name();
        match name.as_ref() {
            "fmiModelDescription" => {
                let version = required(element, "fmiVersion")?;
                if version != "2.0" {
                    bail!("the unit is of FMI version {version}; only 2.0 is run");
                }
                self.guid = required(element, "guid")?;
                self.model_name = required(element, "modelName")?;
            }
            "CoSimulation" => self.model_identifier = required(element, "modelIdentifier")?,
            "SimpleType" => *simple_type = required(element, "name")?,
            "Item" => {
                let item = (required(element, "name")?, number(element, "value")?);
                self.enumerations.entry(simple_type.clone()).or_default().push(item);
            }
            "ScalarVariable" => {
                *variable = Some((required(element, "name")?, number(element, "valueReference")?));
            }
            // The same element names also occur in type definitions, where no variable is open.
            type_element @ ("Real" | "Integer" | "Boolean" | "String" | "Enumeration") => {
                if let Some((name, value_reference)) = variable.take() {
                    let kind = match type_element {
                        "Real" => Kind::Real,
                        "Integer" => Kind::Integer,
                        "Boolean" => Kind::Boolean,
                        "String" => Kind::String,
                        _ => Kind::Enumeration(required(element, "declaredType")?),
                    };
                    self.variables.insert(name, Variable { value_reference, kind });
                }
            }
            _ => {}
        }
        Ok(())
    }
}

fn required(element: &BytesStart<'_>, attribute: &str) -> Result<String> {
    let place = || {
        let name = element.name();
        format!("attribute {attribute} of {} in modelDescription.xml", name.as_ref())
    };
    let found = element.try_get_attribute(attribute).with_context(place)?;
    let found = found.with_context(|| format!("missing {}", place()))?;
    Ok(found.normalized_value(XmlVersion::Implicit1_0).with_context(place)?.into_owned())
}

fn number<T: std::str::FromStr>(element: &BytesStart<'_>, attribute: &str) -> Result<T> {
    let text = required(element, attribute)?;
    text.parse()
        .ok()
        .with_context(|| format!("{attribute}=\"{text}\" in modelDescription.xml is not a number"))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
        <fmiModelDescription fmiVersion="2.0" modelName="A &amp; B" guid="{1}">
          <CoSimulation modelIdentifier="Ab"/>
          <TypeDefinitions>
            <SimpleType name="Length"><Real unit="m"/></SimpleType>
            <SimpleType name="Side"><Enumeration><Item name="right" value="1"/><Item name="left" value="2"/></Enumeration></SimpleType>
          </TypeDefinitions>
          <ModelVariables>
            <ScalarVariable name="side" valueReference="7"><Enumeration declaredType="Side"/></ScalarVariable>
            <ScalarVariable name="wheel.y" valueReference="8"><Real start="0.75"/></ScalarVariable>
          </ModelVariables>
        </fmiModelDescription>"#;

    #[test]
    fn names_references_types_and_items_are_read() {
        let description = ModelDescription::parse(TEXT).unwrap();
        assert_eq!(description.model_name, "A & B");
        assert_eq!(description.guid, "{1}");
        assert_eq!(description.model_identifier, "Ab");
        let side = description.variable("side").unwrap();
        assert_eq!(side, &Variable { value_reference: 7, kind: Kind::Enumeration("Side".into()) });
        assert_eq!(description.variable("wheel.y").unwrap().kind, Kind::Real);
        assert_eq!(description.item("Side", "left").unwrap(), 2);
    }

    #[test]
    fn what_does_not_exist_is_named() {
        let description = ModelDescription::parse(TEXT).unwrap();
        let message = description.variable("wheel.q").unwrap_err().to_string();
        assert_eq!(
            message,
            "the model A & B has no variable \"wheel.q\": its modelDescription.xml lists them"
        );
        let message = description.item("Side", "up").unwrap_err().to_string();
        assert_eq!(message, "\"up\" is not one of right, left");
    }

    #[test]
    fn another_version_is_refused() {
        let message = ModelDescription::parse(&TEXT.replace("2.0", "3.0")).unwrap_err().to_string();
        assert_eq!(message, "the unit is of FMI version 3.0; only 2.0 is run");
    }
}
