//! The documents do not go stale: docs/variables.csv and the keywords of the
//! Python package are those of wheel and wheelset, every variable that a document names exists, and
//! what falls short of its target is listed.
//! `UPDATE_DOCS=1 cargo test --test suite docs::` writes the tables.

mod short_of_target;

use wheelrail::variables::{
    Causality, Enumeration, Kind, VARIABLES, Value, Variable, WHEELSET, find,
};

use crate::common::document;

#[test]
fn the_tables_of_variables_are_those_of_wheel_and_wheelset() {
    document::assert_is("docs/variables.csv", &variables());
    document::assert_is("docs/enumerations.csv", &enumerations());
}

/// Lines of a table in CSV.
fn csv(rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        writer.write_record(&row).expect("memory");
    }
    String::from_utf8(writer.into_inner().expect("memory")).expect("UTF-8")
}

/// The variables of a wheel, and what a wheelset has besides what its sides have, and what is not a
/// wheel's.
fn variables() -> String {
    let heading = ["unit", "causality", "name", "unit or type", "start", "admitted", "meaning"];
    let row = |unit: &str, v: &Variable| {
        let texts = [unit, causality(v), v.name, &kind(v), &start(v), &range(v), v.description];
        texts.map(str::to_owned).to_vec()
    };
    let causalities =
        [Causality::Input, Causality::Parameter, Causality::CalculatedParameter, Causality::Output];
    let mut rows = vec![heading.map(str::to_owned).to_vec()];
    // The patches are alike: the first one stands for all.
    for causality in causalities {
        let all = VARIABLES.iter().filter(|v| v.causality == causality && !is_later_patch(v));
        rows.extend(all.map(|v| row("WheelRail", v)));
    }
    let on_side = |name: &str| name.starts_with("right.") || name.starts_with("left.");
    let is_own = |v: &&Variable| !(on_side(v.name) || v.is_settable() && find(v.name).is_ok());
    rows.extend(WHEELSET.variables.iter().filter(is_own).map(|v| row("WheelSet", v)));
    csv(rows)
}

fn causality(v: &Variable) -> &'static str {
    match v.causality {
        Causality::Input => "input",
        Causality::Parameter => "parameter",
        Causality::CalculatedParameter => "calculated",
        Causality::Output => "output",
    }
}

/// The items of all enumerations.
fn enumerations() -> String {
    let mut rows = vec![["type", "number", "item", "meaning"].map(str::to_owned).to_vec()];
    let mut seen: Vec<&Enumeration> = Vec::new();
    for v in VARIABLES {
        let Kind::Enumeration(e) = v.kind else { continue };
        if seen.iter().any(|other| other.name == e.name) {
            continue;
        }
        seen.push(e);
        for item in e.items {
            let number = item.value.to_string();
            let texts = [e.name, &number, item.name, item.description];
            rows.push(texts.map(str::to_owned).to_vec());
        }
    }
    csv(rows)
}

fn is_later_patch(v: &Variable) -> bool {
    v.name.starts_with("patch[") && !v.name.starts_with("patch[1]")
}

fn kind(v: &Variable) -> String {
    match v.kind {
        Kind::Real if v.unit.is_empty() => "1".into(),
        Kind::Real => v.unit.into(),
        Kind::Integer => "Integer".into(),
        Kind::Boolean => "Boolean".into(),
        Kind::Text => "String".into(),
        Kind::Enumeration(e) => e.name.into(),
    }
}

fn start(v: &Variable) -> String {
    match (v.start, v.kind) {
        (Some(Value::Real(value)), _) => format!("{value:?}"),
        (Some(Value::Integer(value)), Kind::Enumeration(e)) => {
            e.item(value).map_or_else(String::new, |item| format!("{} ({value})", item.name))
        }
        (Some(Value::Integer(value)), _) => value.to_string(),
        (Some(Value::Boolean(value)), _) => value.to_string(),
        (Some(Value::Text(value)), _) => value.into(),
        (None, _) => String::new(),
    }
}

fn range(v: &Variable) -> String {
    let number = |x: f64| match v.kind {
        Kind::Real => format!("{x:?}"),
        _ => x.to_string(),
    };
    match (v.min.map(number), v.max.map(number)) {
        (Some(min), Some(max)) => format!("{min} to {max}"),
        (Some(min), None) => format!("from {min}"),
        (None, Some(max)) => format!("to {max}"),
        (None, None) => String::new(),
    }
}

/// The keywords of the Python package are written by `python/make_keywords.py`, with the package
/// installed.
#[test]
fn the_keywords_of_python_are_those_of_the_variables() {
    let folder = document::path("python");
    if !folder.is_dir() {
        // The crate as it is packed comes without the Python package.
        return;
    }
    let text = std::fs::read_to_string(folder.join("package/wheelrail/_keywords.py")).unwrap();
    let stale = "_keywords.py is stale: run python python/make_keywords.py";
    let mut count = 0;
    for v in VARIABLES.iter().chain(WHEELSET.variables).filter(|v| v.is_settable()) {
        let unit = match (v.kind, v.unit) {
            (Kind::Real, "") => " [-]".into(),
            (Kind::Real, unit) => format!(" [{unit}]"),
            _ => String::new(),
        };
        let described = format!("    \"\"\"{}{unit}.\"\"\"\n", v.description);
        assert!(text.contains(&described), "{}: {stale}", v.name);
        if let Kind::Enumeration(e) = v.kind {
            let items: Vec<String> = e.items.iter().map(|i| format!("\"{}\"", i.name)).collect();
            let items = format!(": Literal[{}]\n{described}", items.join(", "));
            assert!(text.contains(&items), "{}: {stale}", v.name);
        }
        // Inputs are keywords of a call, and of the element that keeps them.
        count += if v.causality == Causality::Input { 2 } else { 1 };
    }
    let keywords = text.lines().filter(|line| line.starts_with("    \"\"\""));
    let outputs = text.lines().filter(|line| line.starts_with("    ") && line.ends_with(": Any"));
    // Six classes have a line of their own.
    assert_eq!(keywords.count(), count + outputs.count() + 6, "{stale}");
}

/// Names in backquotes that begin like a variable are variables; `wheel.x|y|z` stands for three.
#[test]
fn every_variable_that_a_document_names_exists() {
    let all = VARIABLES.iter().chain(WHEELSET.variables);
    let roots: Vec<&str> = all.filter_map(|v| v.name.split_once(['.', '[']).map(|n| n.0)).collect();
    let mut count = 0;
    for file in [
        "README.md",
        "docs/index.md",
        "docs/models.md",
        "docs/python.md",
        "docs/command_line.md",
        "docs/rust.md",
        "docs/fmi.md",
        "docs/theory.md",
        "docs/profiles.md",
        "docs/wear.md",
        "docs/wheel.md",
        "docs/fatigue.md",
        "docs/validation.md",
        "docs/benchmarks.md",
        "CHANGELOG.md",
    ] {
        let text = std::fs::read_to_string(document::path(file)).unwrap();
        // In tables a bar is written \\|.
        for name in text.replace("\\|", "|").split('`').skip(1).step_by(2) {
            let is_name = name.split_once(['.', '[']).is_some_and(|n| roots.contains(&n.0))
                && name.contains('.')
                && name.chars().all(|c| c.is_ascii_alphanumeric() || "._[]|".contains(c));
            if !is_name {
                continue;
            }
            for name in alternatives(name) {
                count += 1;
                let is_array =
                    WHEELSET.variables.iter().chain(VARIABLES).any(|v| v.array == Some(&name));
                let exists = is_array || find(&name).is_ok() || WHEELSET.find(&name).is_ok();
                assert!(exists, "{file}: there is no variable \"{name}\"");
            }
        }
    }
    assert!(count > 100, "only {count} names were found");
}

/// `a.x|y.b` as `a.x.b` and `a.y.b`.
fn alternatives(name: &str) -> Vec<String> {
    let mut names = vec![String::new()];
    for (i, part) in name.split('.').enumerate() {
        let dot = if i > 0 { "." } else { "" };
        names = names
            .iter()
            .flat_map(|name| part.split('|').map(move |choice| format!("{name}{dot}{choice}")))
            .collect();
    }
    names
}
