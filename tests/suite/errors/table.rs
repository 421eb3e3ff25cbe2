//! The tables of the page: their rows, and what was said against what they say.

use super::*;
use std::fmt::Write;
use std::path::PathBuf;

/// What stands for anything.
const ANYTHING: &str = "…";

fn page() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/suite/errors/refusals.md")
}

/// The rows of the table below a heading, as cells without their backquotes' meaning taken away.
pub fn rows(heading: &str) -> Vec<Vec<String>> {
    let text = fs::read_to_string(page()).unwrap();
    let lines = text.lines().skip_while(|line| *line != format!("## {heading}"));
    let table = lines.skip_while(|line| !line.starts_with("|---")).skip(1);
    let rows: Vec<Vec<String>> = table
        .take_while(|line| line.starts_with('|'))
        .map(|line| line.trim().trim_matches('|').split('|').map(|c| c.trim().into()).collect())
        .collect();
    assert!(!rows.is_empty(), "{heading}");
    rows
}

/// What stands between backquotes in a cell.
pub fn code(cell: &str) -> Vec<&str> {
    cell.split('`').skip(1).step_by(2).collect()
}

/// Whether `message` is `pattern`, in which [`ANYTHING`] stands for anything.
fn fits(message: &str, pattern: &str) -> bool {
    let parts: Vec<&str> = pattern.split(ANYTHING).collect();
    let [first, middle @ .., last] = parts.as_slice() else { return message == pattern };
    let Some(rest) = message.strip_prefix(first).and_then(|rest| rest.strip_suffix(last)) else {
        return false;
    };
    let found = |rest: &str, part: &str| rest.find(part).map(|at| at + part.len());
    let mut at = 0;
    middle.iter().all(|part| {
        found(&rest[at..], part).is_some_and(|end| {
            at += end;
            true
        })
    })
}

/// A message on one line, with what differs from run to run left out, as a cell of a table.
pub fn as_cell(message: &str, folder: &Path) -> String {
    let here = std::env::current_dir().unwrap();
    let mut cell = message.trim().replace('\n', " ");
    for path in [folder, Path::new(env!("CARGO_MANIFEST_DIR")), &here] {
        cell = cell.replace(&path.display().to_string(), ANYTHING);
    }
    cell.replace('|', "/")
}

/// Cells as a line of a table.
fn line(cells: &[String]) -> String {
    let cells = cells.iter().map(|c| if c.is_empty() { String::new() } else { format!(" {c}") });
    format!("|{} |", cells.collect::<Vec<_>>().join(" |"))
}

/// Compares what a row says with what was said; collects what differs, or writes the row anew.
pub fn compare(heading: &str, said: &[(Vec<String>, String)]) {
    let update = std::env::var_os("UPDATE_DOCS").is_some();
    let mut differences = String::new();
    for (row, message) in said {
        let (pattern, provocation) = row.split_last().unwrap();
        assert!(!message.is_empty(), "{heading}: {provocation:?} is not refused");
        if update && !fits(message, pattern) {
            let text = fs::read_to_string(page()).unwrap();
            let old = line(row);
            let new = line(&[provocation, std::slice::from_ref(message)].concat());
            assert!(text.contains(&old), "{old}");
            fs::write(page(), text.replace(&old, &new)).unwrap();
        } else if !fits(message, pattern) {
            writeln!(differences, "{provocation:?} says\n  {message}\nand not\n  {pattern}")
                .unwrap();
        }
    }
    assert!(differences.is_empty(), "{heading}\n{differences}");
}

#[test]
fn patterns_fit_as_they_say() {
    for (message, pattern, wanted) in [
        ("a is b", "a is b", true),
        ("a is b", "a … b", true),
        ("a is b", "a is", false),
        ("a is b", "…b", true),
        ("a is b, b", "…b", true),
        ("a is b c", "…b", false),
        ("a is b", "b", false),
        ("a is b or c", "a … b … c", true),
        ("a is c or b", "a … b … c", false),
    ] {
        assert_eq!(fits(message, pattern), wanted, "{message:?} {pattern:?}");
    }
}
