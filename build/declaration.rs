//! Reads `modelDescription/variables.toml` and expands it to a flat list of variables, those of a
//! wheel.

use std::collections::BTreeMap;

use serde::Deserialize;

/// The whole declaration, as written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct File {
    model: Model,
    experiment: Experiment,
    unit: Vec<Unit>,
    log_category: Vec<Described>,
    enumeration: Vec<Enumeration>,
    dependency: Vec<Dependency>,
    group: Vec<Group>,
}

#[derive(Clone, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(not(feature = "package"), allow(dead_code))]
pub struct Model {
    pub name: String,
    pub description: String,
    pub license: String,
    pub author: String,
    pub copyright: String,
    /// When the declaration was last changed, as `generationDateAndTime`.
    pub date: String,
}

#[derive(Clone, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(not(feature = "package"), allow(dead_code))]
pub struct Experiment {
    pub start: f64,
    pub stop: f64,
    pub step: f64,
    pub tolerance: f64,
}

#[derive(Clone, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(not(feature = "package"), allow(dead_code))]
pub struct Unit {
    pub name: String,
    /// The word of the field for what is measured, as Modelica's library has it.
    pub quantity: Option<String>,
    /// Size of a change that matters.
    pub nominal: f64,
    pub exponents: BTreeMap<String, i32>,
    #[serde(default)]
    pub display: Vec<DisplayUnit>,
}

#[derive(Clone, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(not(feature = "package"), allow(dead_code))]
pub struct DisplayUnit {
    pub name: String,
    pub factor: f64,
}

#[derive(Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Described {
    pub name: String,
    pub description: String,
}

#[derive(Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Enumeration {
    pub name: String,
    pub description: String,
    pub items: Vec<Item>,
}

#[derive(Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Item {
    pub name: String,
    pub value: i32,
    pub rust: String,
    pub description: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Dependency {
    name: String,
    extends: Option<String>,
    inputs: Vec<String>,
    #[serde(default)]
    parameters: Vec<String>,
}

#[derive(Clone, Copy, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "camelCase")]
pub enum Causality {
    Input,
    Parameter,
    CalculatedParameter,
    Output,
}

#[derive(Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Repeat {
    pub count: usize,
    /// The Rust constant that must have the same value.
    pub constant: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Group {
    pub causality: Causality,
    r#type: String,
    repeat: Option<Repeat>,
    pub variables: Vec<Template>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Template {
    name: String,
    field: String,
    unit: Option<String>,
    min: Option<f64>,
    max: Option<f64>,
    /// In place of that of the unit.
    nominal: Option<f64>,
    /// Unit in which it is shown, in place of the first display unit.
    display: Option<String>,
    start: Option<toml::Value>,
    pub depends: Option<String>,
    #[serde(default)]
    on_request: bool,
    /// Whether it counts what evaluations met with, whatever the time.
    #[serde(default)]
    counter: bool,
    description: String,
}

/// Type of a variable with the start value that goes with it; outputs have none.
#[derive(Clone)]
pub enum Kind {
    Real(Option<f64>),
    Integer(Option<i32>),
    Boolean(Option<bool>),
    Text(Option<String>),
    /// Index of the enumeration and value of the starting item.
    Enumeration(usize, Option<i32>),
}

/// Variables that are one in FMI 3.0.
#[derive(Clone)]
#[cfg_attr(not(feature = "package"), allow(dead_code))]
pub struct Array {
    pub name: String,
    /// That of an element with k for its number.
    pub description: String,
}

/// One variable; its value reference is its place in the list.
#[derive(Clone)]
#[cfg_attr(not(feature = "package"), allow(dead_code))]
pub struct Variable {
    pub name: String,
    pub field: String,
    /// Other fields that are set with it.
    pub also: Vec<String>,
    pub description: String,
    pub causality: Causality,
    pub kind: Kind,
    pub unit: Option<String>,
    pub min: Option<f64>,
    pub max: Option<f64>,
    /// Size of a change that matters, of a number.
    pub nominal: Option<f64>,
    /// Unit in which a number is shown, if it is another one.
    pub display: Option<String>,
    /// Whether it is computed only when it is read.
    pub on_request: bool,
    /// Whether it counts what evaluations met with, whatever the time.
    pub is_counter: bool,
    /// Its number among those that are there several times, counted from 1; 0 for others.
    pub number: usize,
    /// The array of FMI 3.0 of which it is an element.
    pub array: Option<Array>,
    /// Places in the list of the variables on which an unknown depends at initialization.
    pub dependencies: Vec<usize>,
}

/// The declaration, expanded and checked.
#[cfg_attr(not(feature = "package"), allow(dead_code))]
pub struct Declaration {
    pub guid: String,
    pub model: Model,
    pub experiment: Experiment,
    pub units: Vec<Unit>,
    pub log_categories: Vec<Described>,
    pub enumerations: Vec<Enumeration>,
    pub variables: Vec<Variable>,
    pub repeats: Vec<Repeat>,
}

impl Declaration {
    /// Of the variable of FMI 3.0 with the reference `place` the places of its elements: itself
    /// alone, or all of the array that it begins; none within an array.
    pub fn elements(&self, place: usize) -> Vec<usize> {
        let Some(array) = &self.variables[place].array else { return vec![place] };
        let all = self.variables.iter().enumerate();
        let is_element =
            |v: &Variable| v.array.as_ref().is_some_and(|other| other.name == array.name);
        let places: Vec<usize> =
            all.filter(|(_, v)| is_element(v)).map(|(place, _)| place).collect();
        if places[0] == place { places } else { Vec::new() }
    }
}

impl File {
    /// Parses the text of the declaration.
    ///
    /// # Panics
    /// With a message that names the entry at fault: a faulty declaration must stop the build.
    pub fn read(text: &str) -> Self {
        toml::from_str(text).unwrap_or_else(|e| panic!("modelDescription/variables.toml: {e}"))
    }
}

impl Declaration {
    /// Expands the declaration of a wheel, whose text is `text`.
    ///
    /// # Panics
    /// As [`File::read`].
    pub fn of_wheel(file: &File, text: &str) -> Self {
        let mut variables = Vec::new();
        let mut depends = Vec::new();
        let mut repeats = Vec::new();
        for group in &file.group {
            let count = group.repeat.as_ref().map_or(1, |r| r.count);
            repeats.extend(group.repeat.clone());
            for index in 0..count {
                for template in &group.variables {
                    variables.push(expand(file, group, template, index));
                    depends.push(template.depends.clone());
                }
            }
        }
        for (place, depends) in depends.iter().enumerate() {
            variables[place].dependencies =
                dependencies(file, &variables, place, depends.as_deref());
        }
        Self {
            guid: guid(text),
            model: file.model.clone(),
            experiment: file.experiment.clone(),
            units: file.unit.clone(),
            log_categories: file.log_category.clone(),
            enumerations: file.enumeration.clone(),
            variables,
            repeats,
        }
    }
}

/// What is there this many times is an array in FMI 3.0. The two rails are not: each is a body with
/// connections of its own.
const ARRAYED: &str = "REPORTED_PATCHES";

/// One variable of a group; `index` is its number in a repeated one.
pub fn expand(file: &File, group: &Group, template: &Template, index: usize) -> Variable {
    let name = template.name.replace('#', &(index + 1).to_string());
    let wrong = |what: &str| -> ! { panic!("modelDescription: {name}: {what}") };
    let kind = start(file, &name, &group.r#type, template.start.as_ref());
    let settable = matches!(group.causality, Causality::Input | Causality::Parameter);
    if settable != template.start.is_some() {
        wrong("inputs and parameters have a start value, and nothing else has");
    }
    if settable == template.depends.is_some() {
        wrong("outputs and calculated parameters say what they depend on, and nothing else does");
    }
    let unit = template.unit.as_ref().map(|unit| {
        let declared = file.unit.iter().find(|u| &u.name == unit);
        declared.unwrap_or_else(|| wrong("its unit is not declared"))
    });
    let shown = template.display.as_ref();
    if let Some(shown) = shown.filter(|shown| {
        !unit.is_some_and(|u| *shown == &u.name || u.display.iter().any(|d| *shown == &d.name))
    }) {
        wrong(&format!("its unit has no display unit {shown}"));
    }
    let first = unit.and_then(|u| u.display.first()).map(|display| &display.name);
    Variable {
        field: template.field.replace('#', &index.to_string()),
        also: Vec::new(),
        description: template.description.replace('#', &(index + 1).to_string()),
        causality: group.causality,
        kind,
        unit: template.unit.clone(),
        min: template.min,
        max: template.max,
        nominal: template.nominal.or(unit.map(|u| u.nominal)),
        display: shown.or(first).filter(|shown| template.unit.as_ref() != Some(*shown)).cloned(),
        on_request: template.on_request,
        is_counter: template.counter,
        number: group.repeat.as_ref().map_or(0, |_| index + 1),
        array: group.repeat.as_ref().filter(|repeat| repeat.constant == ARRAYED).map(|_| Array {
            name: template.name.replace("[#]", ""),
            description: template.description.replace('#', "k"),
        }),
        dependencies: Vec::new(),
        name,
    }
}

/// The type of that name with a start value, if there is one, for the variable `name`.
pub fn start(file: &File, name: &str, kind: &str, start: Option<&toml::Value>) -> Kind {
    let wrong = |what: &str| -> ! { panic!("modelDescription: {name}: {what}") };
    let number = |v: &toml::Value| v.as_float().unwrap_or_else(|| wrong("start is not a real"));
    let whole = |v: &toml::Value| {
        let integer = v.as_integer().unwrap_or_else(|| wrong("start is not an integer"));
        i32::try_from(integer).unwrap_or_else(|_| wrong("start is too large"))
    };
    match kind {
        "Real" => Kind::Real(start.map(number)),
        "Integer" => Kind::Integer(start.map(whole)),
        "Boolean" => Kind::Boolean(
            start.map(|v| v.as_bool().unwrap_or_else(|| wrong("start is not a boolean"))),
        ),
        "String" => Kind::Text(
            start.map(|v| v.as_str().map_or_else(|| wrong("start is not a text"), str::to_owned)),
        ),
        other => {
            let place = file.enumeration.iter().position(|e| e.name == other);
            let place = place.unwrap_or_else(|| wrong("its type is not declared"));
            let item = |v: &toml::Value| {
                let items = &file.enumeration[place].items;
                let found = items.iter().find(|i| Some(i.name.as_str()) == v.as_str());
                found.unwrap_or_else(|| wrong("start is not an item of its type")).value
            };
            Kind::Enumeration(place, start.map(item))
        }
    }
}

/// Places of the variables a set names; a set that names no parameters depends on all of them.
pub fn dependencies(
    file: &File,
    variables: &[Variable],
    place: usize,
    set: Option<&str>,
) -> Vec<usize> {
    let mut places = Vec::new();
    let mut every_parameter = true;
    let mut next = set;
    while let Some(set) = next {
        let set = file.dependency.iter().find(|d| d.name == set).unwrap_or_else(|| {
            panic!(
                "{} depends on \"{set}\", which is not declared",
                variables.get(place).map_or("it", |v| &v.name)
            )
        });
        every_parameter &= set.parameters.is_empty();
        for name in set.inputs.iter().chain(&set.parameters) {
            let found = variables.iter().position(|v| &v.name == name);
            places.push(found.unwrap_or_else(|| panic!("dependency on unknown variable {name}")));
        }
        next = set.extends.as_deref();
    }
    if set.is_some() && every_parameter {
        let all = variables.iter().enumerate();
        places.extend(
            all.filter(|(_, v)| v.causality == Causality::Parameter).map(|(place, _)| place),
        );
    }
    places.sort_unstable();
    places
}

/// The 128-bit FNV-1a hash of the declaration in the usual form of a GUID.
pub fn guid(text: &str) -> String {
    let mut hash: u128 = 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d;
    for byte in text.bytes() {
        hash ^= u128::from(byte);
        hash = hash.wrapping_mul(0x0000_0000_0100_0000_0000_0000_0000_013b);
    }
    let hex = format!("{hash:032x}");
    format!("{{{}-{}-{}-{}-{}}}", &hex[..8], &hex[8..12], &hex[12..16], &hex[16..20], &hex[20..])
}
