//! The list in docs/validation.md of what falls short of its target: figures that were measured,
//! and tolerances that are wider.

use std::fmt::Write as _;
use std::path::Path;

use crate::common::document;
use crate::tolerance::{self, Target, Tolerance};

const TABLE: [&str; 2] = ["<!-- short of target -->\n", "<!-- end of short of target -->"];

/// Targets of the default element for docs/scoreboard.csv and its page: family, row, and target
/// of median, 95 % and worst. Tables of docs/validation.md have a column of their own for them.
#[rustfmt::skip]
const SCOREBOARD: [(&str, &str, &str); 14] = [
    ("Planar problems of wheel and rail, normal", "N [%], by default", "0.1 / - / 0.8"),
    ("Planar problems of wheel and rail, normal", "p_max [%], by default", "0.5 / - / 6"),
    ("Planar problems of wheel and rail, normal", "area [%], by default", "0.5 / - / 2.5"),
    ("Random poses of a rolling wheel", "creep force [% of the limit], by default", "- / 2.2 / 4"),
    ("Wing rail that runs off along the track", "height of the wheel [um], by default", "1"),
    ("Wing rail that runs off along the track", "creep force [% of the limit], by default", "- / 3 / -"),
    ("Nose of a crossing that rises along the track", "height of the wheel [um], by default", "1"),
    ("Nose of a crossing that rises along the track", "creep force [% of the limit], by default", "- / 3 / -"),
    ("Crossing of an artificial nose between wing rails", "height of the wheel [um], by default", "1"),
    ("Crossing of an artificial nose between wing rails", "creep force [% of the limit], by default", "- / 3 / -"),
    ("UK crossing 56E1-R245-1:9.25", "height of the wheel [um], by default", "1"),
    ("UK crossing 56E1-R245-1:9.25", "share of the load [% of all], by default", "1 / - / -"),
    ("UK crossing 56E1-R245-1:9.25", "creep force [% of the limit], by default", "- / 3 / -"),
    ("Times", "by default", "5 / - / -"),
];

/// A row of a table of errors.
struct Row {
    /// Heading of the section.
    heading: String,
    /// Its cells before the number of cases.
    name: String,
    /// Median, 95 % and worst, as far as the table has them; as they are written.
    figures: [String; 3],
    /// What stands in the column of aims.
    aim: String,
}

/// The rows of all tables of a page that count cases.
fn rows(page: &str) -> Vec<Row> {
    let (mut heading, mut columns, mut rows) = ("", Vec::new(), Vec::new());
    let mut lines = page.lines().peekable();
    while let Some(line) = lines.next() {
        if line.starts_with('#') {
            heading = line.trim_start_matches('#').trim();
        }
        let Some(cells) = line.strip_prefix("| ") else { continue };
        let cells: Vec<&str> = cells.trim_end_matches('|').split('|').map(str::trim).collect();
        if lines.peek().is_some_and(|next| next.starts_with("|--")) {
            columns = cells;
            continue;
        }
        let is_count = |column: &&str| ["cases", "poses"].contains(column);
        let Some(keys) = columns.iter().position(is_count) else { continue };
        let cell = |name: &str| cells.get(columns.iter().position(|column| *column == name)?);
        let text = |name: &str| (*cell(name).unwrap_or(&"-")).to_owned();
        rows.push(Row {
            heading: heading.into(),
            name: cells[..keys].join(", "),
            figures: ["median", "95 %", "worst"].map(text),
            aim: text("aim"),
        });
    }
    rows
}

/// The rows of docs/scoreboard.csv.
fn scoreboard_rows(path: &Path) -> Vec<Row> {
    let mut reader = csv::Reader::from_path(path).expect("docs/scoreboard.csv");
    let records = reader.records().map(|record| record.expect("docs/scoreboard.csv is a table"));
    let row = |record: csv::StringRecord| Row {
        heading: record[0].into(),
        name: format!("{}, {}", &record[1], &record[2]),
        figures: [4, 5, 6].map(|column| record[column].into()),
        aim: "-".into(),
    };
    records.map(row).collect()
}

/// Target of median, 95 % and worst: `0.1 / - / 0.8`, or the worst alone. An aim in words is none.
fn aims(text: &str) -> [Option<f64>; 3] {
    let parts: Vec<_> = text.split('/').map(|part| part.trim().parse().ok()).collect();
    match parts[..] {
        [worst] => [None, None, worst],
        [median, most, worst] => [median, most, worst],
        _ => panic!("{text}: an aim of median, 95 % and worst, or of the worst"),
    }
}

/// The line of a row of a page, if any of its figures is beyond `aim`.
fn line(row: &Row, aim: &str) -> Option<String> {
    let mut any = false;
    let figures = row.figures.iter().zip(aims(aim)).map(|(figure, aim)| {
        let is_beyond = aim.is_some_and(|aim| figure.parse().is_ok_and(|figure: f64| figure > aim));
        any |= is_beyond;
        if is_beyond { format!("**{figure}**") } else { figure.clone() }
    });
    let figures = figures.collect::<Vec<String>>().join(" / ");
    any.then(|| format!("| {} | {} | {aim} | {figures} |\n", row.heading, row.name))
}

fn table(validation: &str, scoreboard: &str) -> String {
    let mut text = String::from("\n| table | quantity | target | measured |\n|---|---|---|---|\n");
    let mut found = scoreboard_rows(&document::path("docs/scoreboard.csv"));
    found.extend(rows(scoreboard));
    for (heading, name, aim) in SCOREBOARD {
        let row = found.iter().find(|row| row.heading == heading && row.name == name);
        let row = row.unwrap_or_else(|| panic!("docs/scoreboard: no {name} in {heading}"));
        text.extend(line(row, aim));
    }
    text.extend(rows(validation).iter().filter_map(|row| line(row, &row.aim)));
    text += "\n| test: quantity | target | allowed |\n|---|---|---|\n";
    for tolerance in tolerance::all() {
        let Tolerance { name, bound, target: Target::Less(target), .. } = tolerance else {
            continue;
        };
        let [bound, target] = [bound, target].map(|text| text.replace('\n', " "));
        let quantity = tolerance.quantity();
        writeln!(text, "| `{name}`: {quantity} | {target} | {bound} |").unwrap();
    }
    text + "\n"
}

#[test]
fn what_falls_short_of_its_target_is_listed() {
    let [validation, scoreboard] = ["docs/validation.md", "docs/scoreboard.md"]
        .map(|name| std::fs::read_to_string(document::path(name)).unwrap());
    document::assert_holds("docs/validation.md", &[(TABLE, table(&validation, &scoreboard))]);
}

#[test]
fn figures_beyond_their_target_are_found() {
    let page = "## Rails\n\n| quantity | by | cases | median | 95 % | worst |\n|---|---|---:|---|---|---|\n\
        | N [%] | us | 3 | 0.2 | 0.3 | 2.0e-1 |\n";
    let row = &rows(page)[0];
    assert_eq!(line(row, "- / 0.3 / 0.2"), None);
    let expected = "| Rails | N [%], us | 0.1 / - / 0.3 | **0.2** / 0.3 / 2.0e-1 |\n";
    assert_eq!(line(row, "0.1 / - / 0.3").as_deref(), Some(expected));
    assert_eq!(line(row, "no worse than before"), None);
}
