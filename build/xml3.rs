//! Writes `modelDescription.xml` of FMI 3.0 (section 2.4) from the declaration.
//!
//! Variables have the references of FMI 2.0, arrays that of their first element. Two variables that
//! FMI 3.0 asks for come behind all others: the independent one, and that of the event indicator;
//! `src/fmi/arrays.rs` answers for them.

use std::io::{Result, Write};

use quick_xml::writer::Writer;

use crate::declaration::{Causality, Declaration, Enumeration, Kind, Variable};
use crate::xml::{list, log_and_experiment, optional, root, unit};

/// The text of the file; `version` is that of the crate.
pub fn generate(declaration: &Declaration, version: &str) -> Result<Vec<u8>> {
    let mut text = b"<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n".to_vec();
    let mut writer = Writer::new_with_indent(&mut text, b' ', 2);
    let identifier = &*declaration.model.name;
    let root = root(&mut writer, declaration, version, ["3.0", "instantiationToken"]);
    root.write_inner_content(|w| {
        // Only what the library can do; what is left out is false.
        let capabilities = [
            ("modelIdentifier", identifier),
            ("canGetAndSetFMUState", "true"),
            ("canSerializeFMUState", "true"),
            ("providesDirectionalDerivatives", "true"),
            ("providesAdjointDerivatives", "true"),
        ];
        w.create_element("ModelExchange").with_attributes(capabilities).write_empty()?;
        w.create_element("CoSimulation")
            .with_attributes(capabilities)
            .with_attribute(("canHandleVariableCommunicationStepSize", "true"))
            .write_empty()?;
        list(w, "UnitDefinitions", &declaration.units, unit)?;
        list(w, "TypeDefinitions", &declaration.enumerations, enumeration)?;
        log_and_experiment(w, declaration)?;
        let all = described(declaration);
        w.create_element("ModelVariables").write_inner_content(|w| {
            all.iter().try_for_each(|place| variable(w, declaration, *place))?;
            own_variables(w, declaration)
        })?;
        structure(w, declaration, &all)
    })?;
    text.push(b'\n');
    Ok(text)
}

/// Places of the variables that stand for themselves, and of the first elements of arrays.
fn described(declaration: &Declaration) -> Vec<usize> {
    (0..declaration.variables.len())
        .filter(|place| !declaration.elements(*place).is_empty())
        .collect()
}

fn enumeration<W: Write>(writer: &mut Writer<W>, enumeration: &Enumeration) -> Result<()> {
    let element = writer
        .create_element("EnumerationType")
        .with_attribute(("name", &*enumeration.name))
        .with_attribute(("description", &*enumeration.description));
    element.write_inner_content(|w| {
        for item in &enumeration.items {
            w.create_element("Item")
                .with_attribute(("name", &*item.name))
                .with_attribute(("value", &*item.value.to_string()))
                .with_attribute(("description", &*item.description))
                .write_empty()?;
        }
        Ok(())
    })?;
    Ok(())
}

fn variable<W: Write>(
    writer: &mut Writer<W>,
    declaration: &Declaration,
    place: usize,
) -> Result<()> {
    let v = &declaration.variables[place];
    // Initial values follow from causality and variability by the standard's defaults.
    let (causality, variability) = match (v.causality, &v.kind) {
        (Causality::Input, Kind::Real(_)) => ("input", "continuous"),
        (Causality::Input, _) => ("input", "discrete"),
        (Causality::Parameter, _) => ("parameter", "fixed"),
        (Causality::CalculatedParameter, _) => ("calculatedParameter", "fixed"),
        (Causality::Output, Kind::Real(_)) => ("output", "continuous"),
        (Causality::Output, _) => ("output", "discrete"),
    };
    let (r#type, start, declared) = match &v.kind {
        Kind::Real(start) => ("Float64", start.map(|s| s.to_string()), None),
        Kind::Integer(start) => ("Int32", start.map(|s| s.to_string()), None),
        Kind::Boolean(start) => ("Boolean", start.map(|s| s.to_string()), None),
        // An element of its own.
        Kind::Text(_) => ("String", None, None),
        Kind::Enumeration(place, start) => (
            "Enumeration",
            start.map(|s| s.to_string()),
            Some(declaration.enumerations[*place].name.clone()),
        ),
    };
    let (name, description) =
        v.array.as_ref().map_or((&v.name, &v.description), |a| (&a.name, &a.description));
    let mut element = writer
        .create_element(r#type)
        .with_attribute(("name", &**name))
        .with_attribute(("valueReference", &*place.to_string()))
        // Functions that a description names have the same names but for the number.
        .with_attribute(("description", &*description.replace("fmi2", "fmi3")))
        .with_attribute(("causality", causality))
        .with_attribute(("variability", variability));
    element = optional(element, "declaredType", declared);
    let of_unit =
        v.unit.as_ref().and_then(|name| declaration.units.iter().find(|unit| &unit.name == name));
    element = optional(element, "quantity", of_unit.and_then(|unit| unit.quantity.clone()));
    element = optional(element, "unit", v.unit.clone());
    element = optional(element, "displayUnit", v.display.clone());
    element = optional(element, "min", v.min.map(|m| m.to_string()));
    element = optional(element, "max", v.max.map(|m| m.to_string()));
    if matches!(v.kind, Kind::Real(_)) {
        element = optional(element, "nominal", v.nominal.map(|n| n.to_string()));
    }
    element = optional(element, "start", start);
    let elements = declaration.elements(place).len();
    match &v.kind {
        Kind::Text(Some(start)) => {
            let start = start.clone();
            element.write_inner_content(|w| {
                w.create_element("Start").with_attribute(("value", &*start)).write_empty().map(drop)
            })?;
        }
        _ if v.array.is_some() => {
            element.write_inner_content(|w| {
                let count = elements.to_string();
                w.create_element("Dimension")
                    .with_attribute(("start", &*count))
                    .write_empty()
                    .map(drop)
            })?;
        }
        _ => {
            element.write_empty()?;
        }
    }
    Ok(())
}

/// Time and event indicator.
fn own_variables<W: Write>(writer: &mut Writer<W>, declaration: &Declaration) -> Result<()> {
    let beyond = declaration.variables.len();
    writer
        .create_element("Float64")
        .with_attribute(("name", "time"))
        .with_attribute(("valueReference", &*beyond.to_string()))
        .with_attribute(("description", "Time: end of the last step, or where the host has set it"))
        .with_attribute(("causality", "independent"))
        .with_attribute(("variability", "continuous"))
        .with_attribute(("unit", "s"))
        .write_empty()?;
    writer
        .create_element("Float64")
        .with_attribute(("name", "event_indicator"))
        .with_attribute(("valueReference", &*(beyond + 1).to_string()))
        .with_attribute((
            "description",
            "In model exchange 1 while outputs that are whole numbers are those of the last event, -1 where the inputs give others; else 1",
        ))
        .with_attribute(("causality", "local"))
        .with_attribute(("variability", "continuous"))
        .write_empty()?;
    Ok(())
}

fn structure<W: Write>(
    writer: &mut Writer<W>,
    declaration: &Declaration,
    all: &[usize],
) -> Result<()> {
    let of = |place: usize| &declaration.variables[place];
    // During the run outputs depend on inputs; at initialization on parameters too.
    let is_input = |place: &usize| of(*place).causality == Causality::Input;
    let beyond = declaration.variables.len();
    writer.create_element("ModelStructure").write_inner_content(|w| {
        for &place in all.iter().filter(|p| of(**p).causality == Causality::Output) {
            unknown(w, "Output", place, &depends(declaration, place, is_input))?;
        }
        let initial = |v: &Variable| {
            matches!(v.causality, Causality::Output | Causality::CalculatedParameter)
        };
        for &place in all.iter().filter(|p| initial(of(**p))) {
            unknown(w, "InitialUnknown", place, &depends(declaration, place, |_| true))?;
        }
        // On all inputs: any of them may move a wheel off a rail.
        let inputs: Vec<usize> = (0..beyond).filter(|p| is_input(p)).collect();
        unknown(w, "EventIndicator", beyond + 1, &inputs)
    })?;
    Ok(())
}

/// Places of the variables on which the elements of a variable depend.
fn depends(declaration: &Declaration, place: usize, counts: impl Fn(&usize) -> bool) -> Vec<usize> {
    let elements = declaration.elements(place).into_iter();
    let mut all: Vec<usize> =
        elements.flat_map(|p| declaration.variables[p].dependencies.clone()).collect();
    all.sort_unstable();
    all.dedup();
    all.retain(counts);
    all
}

fn unknown<W: Write>(
    writer: &mut Writer<W>,
    element: &str,
    reference: usize,
    dependencies: &[usize],
) -> Result<()> {
    let dependencies: Vec<String> = dependencies.iter().map(ToString::to_string).collect();
    writer
        .create_element(element)
        .with_attribute(("valueReference", &*reference.to_string()))
        .with_attribute(("dependencies", &*dependencies.join(" ")))
        .write_empty()
        .map(drop)
}
