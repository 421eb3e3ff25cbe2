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
    let real = |v: &Variable| matches!(v.kind, Kind::Real(_));
    let integer = |v: &Variable| matches!(v.kind, Kind::Integer(_) | Kind::Enumeration(..));
    let boolean = |v: &Variable| matches!(v.kind, Kind::Boolean(_));
    let text = |v: &Variable| matches!(v.kind, Kind::Text(_));
    let is_set = |v: &Variable| matches!(v.causality, Causality::Input | Causality::Parameter);
    let is_output = |v: &Variable| v.causality == Causality::Output;
    // Alone in its field, and not computed from inputs.
    let is_slot = |v: &Variable| {
        v.also.is_empty() && (is_set(v) || v.causality == Causality::CalculatedParameter)
    };
    // What is done with the field of a variable; with all of them, where it is set.
    let field = |done: fn(&str) -> String| move |v: &Variable| done(&v.field);
    let fields = |done: fn(&str) -> String| {
        move |v: &Variable| {
            let all = std::iter::once(&v.field).chain(&v.also);
            let all: Vec<String> = all.map(|field| done(field)).collect();
            format!("{{ {}; }}", all.join("; "))
        }
    };
    let mut function = |head: String,
                        of: &dyn Fn(&Variable) -> bool,
                        arm: &dyn Fn(&Variable) -> String| {
        let mut arms = String::new();
        for (reference, v) in declaration.variables.iter().enumerate().filter(|(_, v)| of(v)) {
            line(&mut arms, &format!("{reference} => {},", arm(v)));
        }
        // Without an arm nothing is used.
        let unused =
            if arms.is_empty() { ", unused_variables, clippy::match_single_binding" } else { "" };
        let rest = if head.contains("->") { "None" } else { "()" };
        line(
            out,
            &format!(
                "#[allow(clippy::single_match, clippy::too_many_lines{unused})]\n#[inline]\nfn {head} {{ match reference {{ {arms} _ => {rest} }} }}"
            ),
        );
    };
    let get = "values: &ValuesOf<Self>, reference: usize";
    let set = "values: &mut ValuesOf<Self>, reference: usize";
    let read = field(|f| format!("Some(values.{f})"));
    let lent = field(|f| format!("Some(&mut values.{f})"));
    function(format!("real({get}) -> Option<f64>"), &real, &read);
    function(
        format!("integer({get}) -> Option<i32>"),
        &integer,
        &field(|f| format!("Some(IntegerField::get(&values.{f}))")),
    );
    function(format!("boolean({get}) -> Option<bool>"), &boolean, &read);
    function(
        format!("text({get}) -> Option<&str>"),
        &text,
        &field(|f| format!("Some(&values.{f})")),
    );
    function(format!("real_slot({set}) -> Option<&mut f64>"), &|v| real(v) && is_slot(v), &lent);
    function(
        format!("output_slot({set}) -> Option<&mut f64>"),
        &|v| real(v) && is_output(v),
        &lent,
    );
    let write = fields(|f| format!("values.{f} = value"));
    function(
        format!("set_real({set}, value: f64)"),
        &|v| real(v) && is_set(v) && !is_slot(v),
        &write,
    );
    // Whole outputs too, which bytes of a state hold.
    function(
        format!("set_integer({set}, value: i32)"),
        &|v| integer(v) && (is_set(v) || is_output(v)),
        &fields(|f| format!("IntegerField::set(&mut values.{f}, value)")),
    );
    function(format!("set_boolean({set}, value: bool)"), &|v| boolean(v) && is_set(v), &write);
    function(
        format!("set_text({set}, value: &str)"),
        &|v| text(v) && is_set(v),
        &fields(|f| format!("value.clone_into(&mut values.{f})")),
    );
}
