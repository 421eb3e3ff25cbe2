//! Writes the figures that tests have left in target/reports into docs: between
//! `<!-- summary NAME -->` and `<!-- end of summary -->` stands the table `summary_NAME.csv`. Then
//! into all pages and README.md the figures that they take from these tables: between
//! `<!-- figure NAME; ROW; COLUMN -->` and `<!-- -->` stands the cell of that table. A cell of
//! docs/scoreboard.csv is named by `<!-- figure FAMILY; QUANTITY; BY; COLUMN -->`. Between
//! `<!-- block NAME -->` and `<!-- end of block -->` stands docs/blocks/NAME.md with these names in
//! braces: one pair of marks a table.
//!
//! `docs/make_tables` runs the tests with their whole sets first.

use std::collections::HashMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{fs, io};

/// At the beginning of a line: prose may speak of marks.
const BEGIN: &str = "\n<!-- summary ";
const END: &str = "<!-- end of summary -->";
const FIGURE: &str = "<!-- figure ";
const FIGURE_END: &str = "<!-- -->";
const BLOCK: &str = "\n<!-- block ";
const BLOCK_END: &str = "<!-- end of block -->";

/// Cells of the tables in the pages, by "NAME; ROW; COLUMN".
type Cells = HashMap<String, String>;

/// A CSV table as one of Markdown.
fn table(path: &Path) -> io::Result<String> {
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_path(path)?;
    let mut text = String::new();
    for (number, row) in reader.records().enumerate() {
        let row = row?;
        let cells: Vec<&str> = row.iter().collect();
        writeln!(text, "| {} |", cells.join(" | ")).expect("a string takes all");
        if number == 0 {
            writeln!(text, "|{}", "---|".repeat(cells.len())).expect("a string takes all");
        }
    }
    Ok(text)
}

/// The page with all tables that there are; those that are missing are told and stay.
fn filled(page: &str, reports: &Path, missing: &mut Vec<String>) -> Result<String, String> {
    let mut text = String::new();
    let mut rest = page;
    while let Some(place) = rest.find(BEGIN) {
        let name_at = place + BEGIN.len();
        let name_end = name_at + rest[name_at..].find(" -->").ok_or("a mark without its end")?;
        let name = &rest[name_at..name_end];
        let body_at = name_end + " -->".len();
        let body_end = body_at
            + rest[body_at..].find(END).ok_or_else(|| format!("summary {name} has no end"))?;
        text += &rest[..body_at];
        if let Ok(table) = table(&reports.join(format!("summary_{name}.csv"))) {
            write!(text, "\n\n{table}\n").expect("a string takes all");
        } else {
            missing.push(name.to_owned());
            text += &rest[body_at..body_end];
        }
        rest = &rest[body_end..];
    }
    Ok(text + rest)
}

/// Adds the cells of all tables of `page` that a command writes to `cells`.
fn collect(page: &str, cells: &mut Cells) {
    let (mut name, mut columns, mut lines) = (None, Vec::new(), page.lines().peekable());
    while let Some(line) = lines.next() {
        let mark = line.strip_prefix("<!-- ").and_then(|line| line.strip_suffix(" -->"));
        if let Some(mark) = mark {
            let benchmark = mark.strip_suffix(": written by the benchmark");
            name = mark.strip_prefix("summary ").or(benchmark);
        }
        let (Some(name), Some(row)) = (name, line.strip_prefix("| ")) else { continue };
        let row: Vec<&str> = row.trim_end_matches('|').split('|').map(str::trim).collect();
        if lines.peek().is_some_and(|next| next.starts_with("|--")) {
            columns = row;
            continue;
        }
        for (column, cell) in columns.iter().zip(&row).skip(1) {
            let title = row[0].trim_matches('*');
            cells.insert(format!("{name}; {title}; {column}"), (*cell).to_owned());
        }
    }
}

/// Adds the figures of docs/scoreboard.csv to `cells`, and the table of times of the page.
fn collect_scoreboard(page: &str, table: &Path, cells: &mut Cells) -> Result<(), String> {
    let told = |error: csv::Error| format!("{}: {error}", table.display());
    let mut reader = csv::Reader::from_path(table).map_err(told)?;
    let columns = reader.headers().map_err(told)?.clone();
    for record in reader.records() {
        let record = record.map_err(told)?;
        let name = record.iter().take(3).collect::<Vec<&str>>().join("; ");
        for (column, cell) in columns.iter().zip(&record).skip(3) {
            cells.insert(format!("{name}; {column}"), cell.to_owned());
        }
    }
    let mut columns = Vec::new();
    for line in page.lines() {
        let Some(row) = line.strip_prefix("| ") else { continue };
        let row: Vec<&str> = row.trim_end_matches('|').split(" | ").map(str::trim).collect();
        if columns.get(1) != Some(&"poses") {
            columns = row;
            continue;
        }
        for (column, cell) in columns.iter().zip(&row).skip(1) {
            cells.insert(format!("Times; {}; {column}", row[0]), (*cell).to_owned());
        }
    }
    Ok(())
}

/// The page with its figures as in `cells`.
fn with_figures(page: &str, cells: &Cells) -> Result<String, String> {
    let mut text = String::new();
    let mut rest = page;
    while let Some(place) = rest.find(FIGURE) {
        let name_at = place + FIGURE.len();
        let name_end = name_at + rest[name_at..].find(" -->").ok_or("a figure without its end")?;
        let name = &rest[name_at..name_end];
        let cell = cells.get(name).ok_or_else(|| format!("no table has the figure {name}"))?;
        let body_at = name_end + " -->".len();
        let body_end = rest[body_at..].find(FIGURE_END);
        let body_end = body_at + body_end.ok_or_else(|| format!("figure {name} has no end"))?;
        text += &rest[..body_at];
        text += cell;
        text += FIGURE_END;
        rest = &rest[body_end + FIGURE_END.len()..];
    }
    Ok(text + rest)
}

/// The page with its blocks, whose figures are as in `cells`.
fn with_blocks(page: &str, blocks: &Path, cells: &Cells) -> Result<String, String> {
    let mut text = String::new();
    let mut rest = page;
    while let Some(place) = rest.find(BLOCK) {
        let name_at = place + BLOCK.len();
        let name_end = name_at + rest[name_at..].find(" -->").ok_or("a block without its end")?;
        let name = &rest[name_at..name_end];
        let body_at = name_end + " -->".len();
        let body_end = rest[body_at..].find(BLOCK_END);
        let body_end = body_at + body_end.ok_or_else(|| format!("block {name} has no end"))?;
        let path = blocks.join(format!("{name}.md"));
        let pattern = fs::read_to_string(&path).map_err(|e| format!("{}: {e}", path.display()))?;
        text += &rest[..body_at];
        text.push('\n');
        let mut parts = pattern.split('{');
        text += parts.next().unwrap_or_default();
        for part in parts {
            let (name, after) = part.split_once('}').ok_or("a brace without its end")?;
            let cell = cells.get(name).ok_or_else(|| format!("no table has the figure {name}"))?;
            text += cell;
            text += after;
        }
        rest = &rest[body_end..];
    }
    Ok(text + rest)
}

/// Writes `page` with the text that `change` makes of it, if that is another one.
fn rewrite(page: &Path, change: impl FnOnce(&str) -> Result<String, String>) -> Result<(), String> {
    let told = |error: &dyn std::fmt::Display| format!("{}: {error}", page.display());
    let before = fs::read_to_string(page).map_err(|error| told(&error))?;
    let after = change(&before).map_err(|error| told(&error))?;
    if after != before {
        fs::write(page, after).map_err(|error| told(&error))?;
        println!("{} written", page.display());
    }
    Ok(())
}

fn write(root: &Path) -> Result<(), String> {
    let entries = fs::read_dir(root.join("docs")).map_err(|error| error.to_string())?;
    let paths = entries.flatten().map(|entry| entry.path());
    let mut pages: Vec<PathBuf> =
        paths.filter(|path| path.extension().is_some_and(|e| e == "md")).collect();
    pages.push(root.join("README.md"));
    let (mut missing, mut cells) = (Vec::new(), Cells::new());
    for page in &pages {
        rewrite(page, |text| filled(text, &root.join("target/reports"), &mut missing))?;
        let text = fs::read_to_string(page).map_err(|error| error.to_string())?;
        if page.ends_with("scoreboard.md") {
            collect_scoreboard(&text, &page.with_extension("csv"), &mut cells)?;
        } else {
            collect(&text, &mut cells);
        }
    }
    for page in &pages {
        rewrite(page, |text| {
            with_blocks(&with_figures(text, &cells)?, &root.join("docs/blocks"), &cells)
        })?;
    }
    for name in missing {
        println!("summary {name} is not in target/reports: its table stays as it is; run its test");
    }
    Ok(())
}

fn main() -> ExitCode {
    match write(Path::new(env!("CARGO_MANIFEST_DIR"))) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}
