//! The declaration of the wheelset: that of a wheel on both sides, with what
//! `modelDescription/wheelset.toml` adds and takes away.

use serde::Deserialize;

use crate::declaration::{
    Array, Causality, Declaration, File, Group, Kind, Model, Variable, dependencies, expand, guid,
    start,
};

/// The file, as written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Wheelset {
    model: Model,
    sides: Sides,
    start: Vec<Start>,
    group: Vec<Group>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Sides {
    names: Vec<String>,
    once: Vec<String>,
    of_centre: Vec<String>,
    placed_by: String,
    moved_by: Vec<String>,
    side_moved_by: Vec<String>,
    left_out: Vec<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Start {
    name: String,
    value: toml::Value,
}

const PATH: &str = "modelDescription/wheelset.toml";
const ORDER: [Causality; 4] =
    [Causality::Input, Causality::Parameter, Causality::CalculatedParameter, Causality::Output];

/// The declaration that `text` makes of the one of a wheel.
///
/// # Panics
/// With a message that names the entry at fault.
pub fn derive(file: &File, wheel: &Declaration, text: &str) -> Declaration {
    let wheelset: Wheelset = toml::from_str(text).unwrap_or_else(|e| panic!("{PATH}: {e}"));
    let Wheelset { model, sides, start: starts, group: groups } = wheelset;
    sides.check(wheel);
    let mut variables = Vec::new();
    // Of each variable, the names of what it depends on.
    let mut depends: Vec<Vec<String>> = Vec::new();
    for causality in ORDER {
        for group in groups.iter().filter(|g| g.causality == causality) {
            for template in &group.variables {
                variables.push(expand(file, group, template, 0));
                let set = template.depends.as_deref();
                let places = dependencies(file, &wheel.variables, usize::MAX, set);
                let all = sides.names.iter().flat_map(|side| sides.depends(wheel, &places, side));
                depends.push(all.collect());
            }
        }
        let of_wheel = || wheel.variables.iter().filter(|v| v.causality == causality);
        for v in of_wheel().filter(|v| sides.is_once(&v.name)) {
            variables.push(sides.common(v));
            let all = sides.names.iter();
            depends
                .push(all.flat_map(|side| sides.depends(wheel, &v.dependencies, side)).collect());
        }
        for (place, side) in sides.names.iter().enumerate() {
            for v in of_wheel().filter(|v| sides.is_of_side(&v.name)) {
                variables.push(on_side(v, side, place));
                // Where loads are given, what one side carries rolls the axle and so the other
                // wheel.
                let is_output = causality == Causality::Output;
                let felt = sides.names.iter().filter(|other| is_output || *other == side);
                let all = felt.flat_map(|other| sides.depends(wheel, &v.dependencies, other));
                depends.push(all.collect());
            }
        }
    }
    for Start { name, value } in &starts {
        let found = variables.iter_mut().find(|v| &v.name == name);
        let v = found.unwrap_or_else(|| panic!("{PATH}: start of {name}, which does not exist"));
        v.kind = start(file, name, &kind_name(wheel, &v.kind), Some(value));
    }
    for (place, names) in depends.iter().enumerate() {
        let place_of = |name: &String| {
            let found = variables.iter().position(|v| &v.name == name);
            found.unwrap_or_else(|| panic!("{PATH}: dependency on unknown variable {name}"))
        };
        let mut places: Vec<usize> = names.iter().map(place_of).collect();
        places.sort_unstable();
        places.dedup();
        variables[place].dependencies = places;
    }
    // What this file makes of both texts belongs to the identity too.
    let names: Vec<String> = variables.iter().map(|v| format!("{} {}", v.name, v.field)).collect();
    Declaration {
        guid: guid(&[&*wheel.guid, text, &*names.join("\n")].concat()),
        model,
        experiment: wheel.experiment.clone(),
        units: wheel.units.clone(),
        log_categories: wheel.log_categories.clone(),
        enumerations: wheel.enumerations.clone(),
        variables,
        repeats: Vec::new(),
    }
}

impl Sides {
    /// That every entry stands for something.
    fn check(&self, wheel: &Declaration) {
        let named = self.of_centre.iter().chain(&self.left_out).chain(&self.once);
        for entry in named {
            let found = wheel.variables.iter().any(|v| stands_for(entry, &v.name));
            assert!(found, "{PATH}: no variable of a wheel is meant by \"{entry}\"");
        }
    }

    fn is_once(&self, name: &str) -> bool {
        let is_there = !self.left_out.iter().any(|entry| entry == name);
        is_there && self.once.iter().any(|entry| stands_for(entry, name))
    }

    fn is_of_side(&self, name: &str) -> bool {
        let elsewhere = self.left_out.iter().chain(&self.of_centre).any(|entry| entry == name);
        !(elsewhere || self.is_once(name))
    }

    /// A variable that is there once: a parameter of elements is that of all sides.
    fn common(&self, v: &Variable) -> Variable {
        let mut common = v.clone();
        if v.field.starts_with("parameters.") {
            let mut fields = (0..self.names.len()).map(|place| field_on_side(&v.field, place));
            common.field = fields.next().unwrap_or_default();
            common.also = fields.collect();
        }
        common
    }

    /// What something on one side depends on, from what it depends on for a wheel.
    fn depends(&self, wheel: &Declaration, places: &[usize], side: &str) -> Vec<String> {
        let mut names = Vec::new();
        for &place in places {
            let name = &wheel.variables[place].name;
            if self.of_centre.contains(name) {
                names.push(name.replacen("wheel.", "wheelset.", 1));
                names.push(self.placed_by.clone());
                names.extend(self.moved_by.iter().cloned());
                names.extend(self.side_moved_by.iter().map(|name| format!("{side}.{name}")));
            } else if self.is_once(name) {
                names.push(name.clone());
            } else if self.is_of_side(name) {
                names.push(format!("{side}.{name}"));
            }
        }
        names
    }
}

/// Whether an entry is that name, or its beginning.
fn stands_for(entry: &str, name: &str) -> bool {
    entry == name || (entry.ends_with('.') && name.starts_with(entry))
}

fn on_side(v: &Variable, side: &str, place: usize) -> Variable {
    let mut initial = side.chars();
    let capital: String = initial.next().into_iter().flat_map(char::to_uppercase).collect();
    let of_side = |description: &str| format!("{capital}{} side: {description}", initial.as_str());
    Variable {
        name: format!("{side}.{}", v.name),
        field: field_on_side(&v.field, place),
        description: of_side(&v.description),
        array: v.array.as_ref().map(|array| Array {
            name: format!("{side}.{}", array.name),
            description: of_side(&array.description),
        }),
        dependencies: Vec::new(),
        ..v.clone()
    }
}

/// The field of a side behind that of a wheel.
fn field_on_side(field: &str, place: usize) -> String {
    match field.split_once('.') {
        // A pair from the start.
        Some(("coupling", _)) => field.replace("[0]", &format!("[{place}]")),
        Some((root, rest)) => format!("{root}.sides[{place}].{rest}"),
        None => format!("{field}.wheel_z[{place}]"),
    }
}

fn kind_name(wheel: &Declaration, kind: &Kind) -> String {
    match kind {
        Kind::Real(_) => "Real".into(),
        Kind::Integer(_) => "Integer".into(),
        Kind::Boolean(_) => "Boolean".into(),
        Kind::Text(_) => "String".into(),
        Kind::Enumeration(place, _) => wheel.enumerations[*place].name.clone(),
    }
}
