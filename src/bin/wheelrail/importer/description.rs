//! Which unit an archive is of.

use anyhow::{Context, Result, bail};
use quick_xml::events::{BytesStart, Event};
use quick_xml::{Reader, XmlVersion};
use wheelrail::variables::{GUID, WHEEL, unit_of};

/// What `modelDescription.xml` says beside the variables, which are those of this crate.
#[derive(Clone, Debug, Default)]
pub struct ModelDescription {
    /// Identification that the library checks.
    pub guid: String,
    /// File name of the library, without extension.
    pub model_identifier: String,
}

impl ModelDescription {
    /// Reads the text of a `modelDescription.xml`, which has to be of a wheel of this version.
    pub fn parse(text: &str) -> Result<Self> {
        let mut reader = Reader::from_str(text);
        let mut found = Self::default();
        loop {
            let event = reader.read_event().context("modelDescription.xml is not valid XML")?;
            let (Event::Start(element) | Event::Empty(element)) = event else {
                if matches!(event, Event::Eof) {
                    break;
                }
                continue;
            };
            match element.name().as_ref() {
                "fmiModelDescription" => {
                    let version = required(&element, "fmiVersion")?;
                    if version != "2.0" {
                        bail!("the unit is of FMI version {version}; only 2.0 is run");
                    }
                    found.guid = required(&element, "guid")?;
                }
                "CoSimulation" => found.model_identifier = required(&element, "modelIdentifier")?,
                _ => {}
            }
        }
        if unit_of(&found.guid, &[&WHEEL]).is_none() {
            bail!(
                "its guid is \"{}\", not the {GUID} of the wheels that this program knows",
                found.guid
            );
        }
        if found.model_identifier.is_empty() {
            bail!("it has no CoSimulation part: only co-simulation is run");
        }
        Ok(found)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_of_another_version_or_model_are_refused() {
        let text = |version: &str, guid: &str, part: &str| {
            format!(
                "<fmiModelDescription fmiVersion=\"{version}\" guid=\"{guid}\"><CoSimulation modelIdentifier=\"{part}\"/></fmiModelDescription>"
            )
        };
        let found = ModelDescription::parse(&text("2.0", GUID, "Ab")).unwrap();
        assert_eq!((found.guid.as_str(), found.model_identifier.as_str()), (GUID, "Ab"));
        for (text, words) in [
            (text("3.0", GUID, "Ab"), "the unit is of FMI version 3.0; only 2.0 is run"),
            (text("2.0", "{1}", "Ab"), "its guid is \"{1}\", not the "),
            (text("2.0", GUID, ""), "only co-simulation is run"),
        ] {
            let message = ModelDescription::parse(&text).unwrap_err().to_string();
            assert!(message.contains(words), "{message}");
        }
    }
}
