//! Writes the Rust side of the declarations: the variable tables and typed access to the fields.

use std::fmt::Write;

use crate::declaration::{Causality, Declaration, Kind, Variable};

/// A declaration and what it becomes in Rust.
pub struct Target<'a> {
    pub declaration: &'a Declaration,
    /// Name of the static with the unit.
    pub unit: &'a str,
    /// Name of the static with its variables.
    pub table: &'a str,
    /// Type that implements the access.
    pub subject: &'a str,
}

/// The text of `variables.rs`, included by `src/variables/table.rs`; what the declarations have in
/// common is taken from the first one.
pub fn generate(targets: &[Target]) -> String {
    let mut code = String::new();
    let out = &mut code;
    let common = targets[0].declaration;
    line(out, "/// Categories of log messages, name and description.");
    line(out, "pub const LOG_CATEGORIES: &[(&str, &str)] = &[");
    for category in &common.log_categories {
        line(out, &format!("({:?}, {:?}),", category.name, category.description));
    }
    line(out, "];");
    for repeat in targets.iter().flat_map(|target| &target.declaration.repeats) {
        line(out, &format!("const _: () = assert!({} == {});", repeat.constant, repeat.count));
    }
    enumerations(out, common);
    for target in targets {
        let Target { declaration, unit, table: name, subject } = target;
        let identifier = &declaration.model.name;
        line(out, &format!("/// The unit `{identifier}`."));
        line(
            out,
            &format!(
                "pub static {unit}: Unit = Unit {{ identifier: {identifier:?}, guid: {:?}, variables: {name} }};",
                declaration.guid
            ),
        );
        table(out, declaration, name);
        line(
            out,
            &format!("impl Described for {subject} {{\nconst UNIT: &'static Unit = &{unit};"),
        );
        access(out, declaration);
        line(out, "}");
    }
    code
}

/// The text of `ranges.rs`, included by `src/element/parameters/ranges.rs`: the numbers among the parameters
/// of a wheel and what is admitted of them.
pub fn ranges(declaration: &Declaration) -> String {
    let mut rows = String::new();
    let mut count = 0;
    for v in &declaration.variables {
        let value = match v.kind {
            Kind::Real(_) => v.field.clone(),
            Kind::Integer(_) => format!("{} as f64", v.field),
            _ => continue,
        };
        if v.causality != Causality::Parameter || !v.field.starts_with("parameters.") {
            continue;
        }
        let least = v.min.map_or("f64::MIN".into(), number);
        let most = v.max.map_or("f64::MAX".into(), number);
        let allowed = allowed(declaration, v);
        line(&mut rows, &format!("({:?}, {value}, [{least}, {most}], {allowed:?}),", v.name));
        count += 1;
    }
    format!(
        "/// Name, value, range and what is admitted in words.\n\
         #[allow(clippy::too_many_lines)] // one for each number\n\
         fn ranges(parameters: &Parameters) -> [(&'static str, f64, [f64; 2], &'static str); {count}] {{ [{rows}] }}\n"
    )
}

fn line(out: &mut String, text: &str) {
    writeln!(out, "{text}").expect("writing to a string cannot fail");
}

fn enumerations(out: &mut String, declaration: &Declaration) {
    line(out, "static ENUMERATIONS: &[Enumeration] = &[");
    for e in &declaration.enumerations {
        let mut items = String::new();
        for i in &e.items {
            line(
                &mut items,
                &format!(
                    "Item {{ name: {:?}, value: {}, description: {:?} }},",
                    i.name, i.value, i.description
                ),
            );
        }
        line(
            out,
            &format!(
                "Enumeration {{ name: {:?}, description: {:?}, items: &[{items}] }},",
                e.name, e.description
            ),
        );
    }
    line(out, "];");
    for e in &declaration.enumerations {
        let (mut get, mut set) = (String::new(), String::new());
        for i in &e.items {
            line(&mut get, &format!("Self::{} => {},", i.rust, i.value));
            line(&mut set, &format!("{} => *self = Self::{},", i.value, i.rust));
        }
        line(
            out,
            &format!(
                "#[allow(clippy::single_match)]\nimpl IntegerField for {} {{\n\
                 fn get(&self) -> i32 {{ match self {{ {get} }} }}\n\
                 fn set(&mut self, value: i32) {{ match value {{ {set} _ => {{}} }} }}\n}}",
                e.name
            ),
        );
    }
}

fn table(out: &mut String, declaration: &Declaration, name: &str) {
    let identifier = &declaration.model.name;
    line(
        out,
        &format!("/// Every variable of `{identifier}`; its place is its FMI value reference."),
    );
    line(out, &format!("pub static {name}: &[Variable] = &["));
    for (reference, v) in declaration.variables.iter().enumerate() {
        let (kind, start) = match &v.kind {
            Kind::Real(s) => {
                ("Kind::Real".into(), s.map(|s| format!("Value::Real({})", number(s))))
            }
            Kind::Integer(s) => ("Kind::Integer".into(), s.map(|s| format!("Value::Integer({s})"))),
            Kind::Boolean(s) => ("Kind::Boolean".into(), s.map(|s| format!("Value::Boolean({s})"))),
            Kind::Text(s) => {
                ("Kind::Text".into(), s.as_ref().map(|s| format!("Value::Text({s:?})")))
            }
            Kind::Enumeration(place, s) => (
                format!("Kind::Enumeration(&ENUMERATIONS[{place}])"),
                s.map(|s| format!("Value::Integer({s})")),
            ),
        };
        let start = start.map_or("None".into(), |s| format!("Some({s})"));
        let causality = match v.causality {
            Causality::Input => "Input",
            Causality::Parameter => "Parameter",
            Causality::CalculatedParameter => "CalculatedParameter",
            Causality::Output => "Output",
        };
        let bound = |b: Option<f64>| b.map_or("None".into(), |b| format!("Some({})", number(b)));
        line(
            out,
            &format!(
                "Variable {{ name: {:?}, description: {:?}, reference: {reference}, kind: {kind}, \
                 causality: Causality::{causality}, unit: {:?}, min: {}, max: {}, nominal: {}, start: {start}, \
                 dependencies: &{:?}, on_request: {}, is_counter: {}, allowed: {:?}, array: {:?}, \
                 elements: &{:?} }},",
                v.name,
                v.description,
                v.unit.as_deref().unwrap_or(""),
                bound(v.min),
                bound(v.max),
                number(v.nominal.unwrap_or(1.0)),
                v.dependencies,
                v.on_request,
                v.is_counter,
                allowed(declaration, v),
                v.array.as_ref().map(|array| &array.name),
                declaration.elements(reference),
            ),
        );
    }
    line(out, "];");
}

/// A number as a Rust literal.
fn number(value: f64) -> String {
    if value.abs() < 1e4 { format!("{value:?}") } else { format!("{value:e}") }
}

/// A number for people to read.
fn plain(value: f64) -> String {
    if value.abs() < 1e4 { value.to_string() } else { format!("{value:e}") }
}

/// What a variable admits, in words, for messages.
fn allowed(declaration: &Declaration, v: &Variable) -> String {
    let unit = v.unit.as_deref().map_or(String::new(), |u| format!(" {u}"));
    let sort = if matches!(v.kind, Kind::Integer(_)) { "an integer" } else { "a finite number" };
    match &v.kind {
        Kind::Real(_) | Kind::Integer(_) => match (v.min, v.max) {
            (Some(min), Some(max)) => {
                format!("{sort} from {} to {}{unit}", plain(min), plain(max))
            }
            (Some(min), None) => format!("{sort} of at least {}{unit}", plain(min)),
            (None, Some(max)) => format!("{sort} of at most {}{unit}", plain(max)),
            (None, None) if unit.is_empty() => sort.into(),
            (None, None) => format!("{sort}, in{unit}"),
        },
        Kind::Boolean(_) => "true or false".into(),
        Kind::Text(_) => "a text of up to 4096 bytes without null characters".into(),
        Kind::Enumeration(place, _) => {
            let items = declaration.enumerations[*place].items.iter();
            let items: Vec<String> = items.map(|i| format!("{} ({})", i.name, i.value)).collect();
            format!("one of {}", items.join(", "))
        }
    }
}

/// Functions that read and write the field behind a variable, one for each type.
fn access(out: &mut String, declaration: &Declaration) {
    let of = |wanted: fn(&Kind) -> bool| {
        let all = declaration.variables.iter().enumerate();
        all.filter(move |(_, v)| wanted(&v.kind))
    };
    let arms = |wanted: fn(&Kind) -> bool, get: &dyn Fn(&str) -> String| {
        let mut arms = String::new();
        for (reference, v) in of(wanted) {
            line(&mut arms, &format!("{reference} => {},", get(&v.field)));
        }
        arms
    };
    let is_set = |v: &Variable| matches!(v.causality, Causality::Input | Causality::Parameter);
    let written = |wanted: fn(&Kind) -> bool,
                   set: &dyn Fn(&str) -> String,
                   is_written: &dyn Fn(&Variable) -> bool| {
        let mut arms = String::new();
        for (reference, v) in of(wanted).filter(|(_, v)| is_written(v)) {
            let all: Vec<String> =
                std::iter::once(&v.field).chain(&v.also).map(|field| set(field)).collect();
            line(&mut arms, &format!("{reference} => {{ {}; }}", all.join("; ")));
        }
        arms
    };
    // Whole outputs too, which bytes of a state hold.
    let is_whole = |v: &Variable| is_set(v) || v.causality == Causality::Output;
    // Alone in its field, and not computed from inputs.
    let is_slot = |v: &Variable| {
        v.also.is_empty() && (is_set(v) || v.causality == Causality::CalculatedParameter)
    };
    let mut slots = String::new();
    let mut shared = String::new();
    for (reference, v) in of(|k| matches!(k, Kind::Real(_))) {
        if is_slot(v) {
            line(&mut slots, &format!("{reference} => Some(&mut values.{}),", v.field));
        } else if is_set(v) {
            let all = std::iter::once(&v.field).chain(&v.also);
            let all: Vec<String> = all.map(|field| format!("values.{field} = value")).collect();
            line(&mut shared, &format!("{reference} => {{ {}; }}", all.join("; ")));
        }
    }
    let mut outputs = String::new();
    for (reference, v) in of(|k| matches!(k, Kind::Real(_))) {
        if v.causality == Causality::Output {
            line(&mut outputs, &format!("{reference} => Some(&mut values.{}),", v.field));
        }
    }
    let integer: fn(&Kind) -> bool = |k| matches!(k, Kind::Integer(_) | Kind::Enumeration(..));
    let boolean: fn(&Kind) -> bool = |k| matches!(k, Kind::Boolean(_));
    let text: fn(&Kind) -> bool = |k| matches!(k, Kind::Text(_));
    let real: fn(&Kind) -> bool = |k| matches!(k, Kind::Real(_));
    let function = |head: &str, arms: String, rest: &str| {
        // Without an arm nothing is used.
        let unused =
            if arms.is_empty() { ", unused_variables, clippy::match_single_binding" } else { "" };
        format!(
            "#[allow(clippy::single_match, clippy::too_many_lines{unused})]\n#[inline]\nfn {head} {{ match reference {{ {arms} _ => {rest} }} }}"
        )
    };
    let read = |f: &str| format!("Some(values.{f})");
    let whole = |f: &str| format!("Some(IntegerField::get(&values.{f}))");
    let letters = |f: &str| format!("Some(&values.{f})");
    let write = |f: &str| format!("values.{f} = value");
    let convert = |f: &str| format!("IntegerField::set(&mut values.{f}, value)");
    let copy = |f: &str| format!("value.clone_into(&mut values.{f})");
    let get = "values: &ValuesOf<Self>, reference: usize";
    let set = "values: &mut ValuesOf<Self>, reference: usize";
    for text in [
        function(&format!("real({get}) -> Option<f64>"), arms(real, &read), "None"),
        function(&format!("integer({get}) -> Option<i32>"), arms(integer, &whole), "None"),
        function(&format!("boolean({get}) -> Option<bool>"), arms(boolean, &read), "None"),
        function(&format!("text({get}) -> Option<&str>"), arms(text, &letters), "None"),
        function(&format!("real_slot({set}) -> Option<&mut f64>"), slots, "None"),
        function(&format!("output_slot({set}) -> Option<&mut f64>"), outputs, "None"),
        function(&format!("set_real({set}, value: f64)"), shared, "()"),
        function(
            &format!("set_integer({set}, value: i32)"),
            written(integer, &convert, &is_whole),
            "()",
        ),
        function(
            &format!("set_boolean({set}, value: bool)"),
            written(boolean, &write, &is_set),
            "()",
        ),
        function(&format!("set_text({set}, value: &str)"), written(text, &copy, &is_set), "()"),
    ] {
        line(out, &text);
    }
}
