//! Writes `modelDescription.xml` (FMI 2.0.4, section 2.2) from the declaration.

use std::io::{Result, Write};

use quick_xml::writer::{ElementWriter, Writer};

use crate::declaration::{Causality, Declaration, Enumeration, Kind, Unit, Variable};

/// How much of a declaration is described, and how.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Style {
    /// Everything.
    Full,
    /// For importers that know no enumerations and for people who look at the list: choices as
    /// integers, and the heaviest [`PLAIN_PATCHES`] patches alone, without [`PLAIN_LACKS`] and
    /// [`PLAIN_LACKS_ALL_OF`]. References are the same, and so is the library.
    Plain,
}

/// Patches of a wheel that a plain description has: more than tread and flange touch at once is
/// rare.
const PLAIN_PATCHES: usize = 4;
/// What of a patch it has not: what only laws of friction by place and heat tell.
const PLAIN_LACKS: [&str; 2] = [".friction_coefficient", ".temperature"];

/// What it has nothing of: elastically supported rails, rollers, longest steps.
const PLAIN_LACKS_ALL_OF: [&str; 9] = [
    "foundation.",
    ".roller_radius",
    "].pitch_rate",
    "coupling.mass",
    "inertia",
    "coupling.lever",
    "coupling.longest_step",
    "coupling.normal_limit",
    "coupling.creep_limit",
];

impl Style {
    fn describes(self, v: &Variable) -> bool {
        let is_detail = PLAIN_LACKS.iter().any(|end| v.name.ends_with(end));
        let is_lesser = v.name.contains("patch[") && (v.number > PLAIN_PATCHES || is_detail);
        let is_left_out = PLAIN_LACKS_ALL_OF.iter().any(|part| v.name.contains(part));
        self == Self::Full || !(is_lesser || is_left_out)
    }
}

/// The text of the file; `version` is that of the crate.
pub fn generate(declaration: &Declaration, version: &str, style: Style) -> Result<Vec<u8>> {
    let mut text = b"<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n".to_vec();
    let mut writer = Writer::new_with_indent(&mut text, b' ', 2);
    let identifier = &*declaration.model.name;
    // Of model exchange: one for all outputs that are whole numbers.
    let root = root(&mut writer, declaration, version, ["2.0", "guid"])
        .with_attribute(("numberOfEventIndicators", "1"));
    root.write_inner_content(|w| {
        // Only what the library can do; what is left out is false.
        w.create_element("ModelExchange")
            .with_attributes([
                ("modelIdentifier", identifier),
                ("completedIntegratorStepNotNeeded", "true"),
                ("canNotUseMemoryManagementFunctions", "true"),
                ("canGetAndSetFMUstate", "true"),
                ("canSerializeFMUstate", "true"),
                ("providesDirectionalDerivative", "true"),
            ])
            .write_empty()?;
        w.create_element("CoSimulation")
            .with_attributes([
                ("modelIdentifier", identifier),
                ("canHandleVariableCommunicationStepSize", "true"),
                ("canInterpolateInputs", "true"),
                ("canNotUseMemoryManagementFunctions", "true"),
                ("canGetAndSetFMUstate", "true"),
                ("canSerializeFMUstate", "true"),
                ("providesDirectionalDerivative", "true"),
            ])
            .write_empty()?;
        list(w, "UnitDefinitions", &declaration.units, unit)?;
        if style == Style::Full {
            list(w, "TypeDefinitions", &declaration.enumerations, enumeration)?;
        }
        log_and_experiment(w, declaration)?;
        let all = declaration.variables.iter().enumerate();
        let all: Vec<(usize, &Variable)> = all.filter(|(_, v)| style.describes(v)).collect();
        list(w, "ModelVariables", &all, |w, (reference, v)| {
            variable(w, declaration, *reference, v, style)
        })?;
        structure(w, declaration, &all)
    })?;
    text.push(b'\n');
    Ok(text)
}

/// The element around a description, with the attributes that both versions of FMI have; `fmi` is
/// the version and its name for the token by which library and description know each other.
pub fn root<'a, W: Write>(
    writer: &'a mut Writer<W>,
    declaration: &Declaration,
    version: &str,
    fmi: [&str; 2],
) -> ElementWriter<'a, W> {
    let model = &declaration.model;
    let [fmi_version, token] = fmi;
    let tool = format!("wheelrail {version}");
    writer.create_element("fmiModelDescription").with_attributes([
        ("fmiVersion", fmi_version),
        ("modelName", &*model.name),
        (token, &*declaration.guid),
        ("description", &*model.description),
        ("version", version),
        ("author", &*model.author),
        ("copyright", &*model.copyright),
        ("license", &*model.license),
        ("generationDateAndTime", &*model.date),
        ("generationTool", &*tool),
        ("variableNamingConvention", "structured"),
    ])
}

/// What both versions say of logging and of a run to begin with.
pub fn log_and_experiment<W: Write>(w: &mut Writer<W>, declaration: &Declaration) -> Result<()> {
    list(w, "LogCategories", &declaration.log_categories, |w, category| {
        let attributes = [("name", &*category.name), ("description", &*category.description)];
        w.create_element("Category").with_attributes(attributes).write_empty().map(drop)
    })?;
    let experiment = &declaration.experiment;
    w.create_element("DefaultExperiment")
        .with_attribute(("startTime", &*experiment.start.to_string()))
        .with_attribute(("stopTime", &*experiment.stop.to_string()))
        .with_attribute(("tolerance", &*experiment.tolerance.to_string()))
        .with_attribute(("stepSize", &*experiment.step.to_string()))
        .write_empty()
        .map(drop)
}

pub fn list<W: Write, T>(
    writer: &mut Writer<W>,
    name: &str,
    entries: &[T],
    write: impl Fn(&mut Writer<W>, &T) -> Result<()>,
) -> Result<()> {
    let element = writer.create_element(name);
    element.write_inner_content(|w| entries.iter().try_for_each(|entry| write(w, entry)))?;
    Ok(())
}

pub fn unit<W: Write>(writer: &mut Writer<W>, unit: &Unit) -> Result<()> {
    let element = writer.create_element("Unit").with_attribute(("name", &*unit.name));
    element.write_inner_content(|w| {
        // The standard fixes the order of neither attributes nor exponents.
        let exponents: Vec<(&str, String)> =
            unit.exponents.iter().map(|(base, power)| (&**base, power.to_string())).collect();
        let attributes = exponents.iter().map(|(base, power)| (*base, &**power));
        w.create_element("BaseUnit").with_attributes(attributes).write_empty()?;
        for display in &unit.display {
            w.create_element("DisplayUnit")
                .with_attribute(("name", &*display.name))
                .with_attribute(("factor", &*display.factor.to_string()))
                .write_empty()?;
        }
        Ok(())
    })?;
    Ok(())
}

fn enumeration<W: Write>(writer: &mut Writer<W>, enumeration: &Enumeration) -> Result<()> {
    let element = writer
        .create_element("SimpleType")
        .with_attribute(("name", &*enumeration.name))
        .with_attribute(("description", &*enumeration.description));
    element.write_inner_content(|w| {
        list(w, "Enumeration", &enumeration.items, |w, item| {
            w.create_element("Item")
                .with_attribute(("name", &*item.name))
                .with_attribute(("value", &*item.value.to_string()))
                .with_attribute(("description", &*item.description))
                .write_empty()
                .map(drop)
        })
    })?;
    Ok(())
}

fn variable<W: Write>(
    writer: &mut Writer<W>,
    declaration: &Declaration,
    reference: usize,
    v: &Variable,
    style: Style,
) -> Result<()> {
    // Initial values follow from causality and variability by the standard's defaults.
    let (causality, variability) = match (v.causality, &v.kind) {
        (Causality::Input, _) => ("input", "continuous"),
        (Causality::Parameter, _) => ("parameter", "fixed"),
        (Causality::CalculatedParameter, _) => ("calculatedParameter", "fixed"),
        (Causality::Output, Kind::Real(_)) => ("output", "continuous"),
        (Causality::Output, _) => ("output", "discrete"),
    };
    // A choice is set and read by the functions for integers in any case.
    let choices = match &v.kind {
        Kind::Enumeration(place, _) if style == Style::Plain => {
            Some(&declaration.enumerations[*place].items)
        }
        _ => None,
    };
    let mut description = v.description.clone();
    for (place, item) in choices.into_iter().flatten().enumerate() {
        let sign = if place == 0 { ": " } else { ", " };
        description += &format!("{sign}{} {}", item.value, item.name);
    }
    let element = writer
        .create_element("ScalarVariable")
        .with_attribute(("name", &*v.name))
        .with_attribute(("valueReference", &*reference.to_string()))
        .with_attribute(("description", &*description))
        .with_attribute(("causality", causality))
        .with_attribute(("variability", variability));
    element.write_inner_content(|w| {
        if let (Some(items), Kind::Enumeration(_, start)) = (choices, &v.kind) {
            let values = || items.iter().map(|item| item.value);
            let mut element = w.create_element("Integer");
            element = optional(element, "min", values().min().map(|m| m.to_string()));
            element = optional(element, "max", values().max().map(|m| m.to_string()));
            optional(element, "start", start.map(|s| s.to_string())).write_empty()?;
            return Ok(());
        }
        let (name, start, r#type) = match &v.kind {
            Kind::Real(start) => ("Real", start.map(|s| s.to_string()), None),
            Kind::Integer(start) => ("Integer", start.map(|s| s.to_string()), None),
            Kind::Boolean(start) => ("Boolean", start.map(|s| s.to_string()), None),
            Kind::Text(start) => ("String", start.clone(), None),
            Kind::Enumeration(place, start) => (
                "Enumeration",
                start.map(|s| s.to_string()),
                Some(&declaration.enumerations[*place].name),
            ),
        };
        let mut element = w.create_element(name);
        element = optional(element, "declaredType", r#type.cloned());
        let declared = v
            .unit
            .as_ref()
            .and_then(|name| declaration.units.iter().find(|unit| &unit.name == name));
        element = optional(element, "quantity", declared.and_then(|unit| unit.quantity.clone()));
        element = optional(element, "unit", v.unit.clone());
        element = optional(element, "displayUnit", v.display.clone());
        element = optional(element, "min", v.min.map(|m| m.to_string()));
        element = optional(element, "max", v.max.map(|m| m.to_string()));
        element = optional(element, "nominal", v.nominal.map(|n| n.to_string()));
        optional(element, "start", start).write_empty()?;
        Ok(())
    })?;
    Ok(())
}

pub fn optional<'a, W: Write>(
    element: ElementWriter<'a, W>,
    name: &str,
    value: Option<String>,
) -> ElementWriter<'a, W> {
    match value {
        Some(value) => element.with_attribute((name, &*value)),
        None => element,
    }
}

fn structure<W: Write>(
    writer: &mut Writer<W>,
    declaration: &Declaration,
    all: &[(usize, &Variable)],
) -> Result<()> {
    let unknowns = |wanted: &[Causality]| {
        let unknowns = all.iter().filter(|(_, v)| wanted.contains(&v.causality));
        unknowns.copied().collect::<Vec<_>>()
    };
    // Its place among those that are described, from 1 on.
    let index = |reference: usize| {
        all.iter().position(|(r, _)| *r == reference).map_or(0, |place| place + 1).to_string()
    };
    // During the run outputs depend on inputs; at initialization on parameters too.
    let is_input = |place: &usize| declaration.variables[*place].causality == Causality::Input;
    writer.create_element("ModelStructure").write_inner_content(|w| {
        list(w, "Outputs", &unknowns(&[Causality::Output]), |w, (reference, v)| {
            unknown(w, &index, *reference, v.dependencies.iter().filter(|place| is_input(place)))
        })?;
        let initial = unknowns(&[Causality::Output, Causality::CalculatedParameter]);
        let mut initial = initial;
        initial.sort_by_key(|(reference, _)| *reference);
        list(w, "InitialUnknowns", &initial, |w, (reference, v)| {
            unknown(w, &index, *reference, v.dependencies.iter())
        })
    })?;
    Ok(())
}

/// An unknown with what it depends on, by their indices.
fn unknown<'a, W: Write>(
    writer: &mut Writer<W>,
    index: &impl Fn(usize) -> String,
    reference: usize,
    dependencies: impl Iterator<Item = &'a usize>,
) -> Result<()> {
    let dependencies: Vec<String> = dependencies.map(|d| index(*d)).collect();
    writer
        .create_element("Unknown")
        .with_attribute(("index", &*index(reference)))
        .with_attribute(("dependencies", &*dependencies.join(" ")))
        .write_empty()
        .map(drop)
}
