//! Writes the figures that tests have left in target/reports into docs: between `<!-- summary NAME -->` and `<!-- end of summary -->` stands the
//! table `summary_NAME.csv`.
//!
//! `docs/make_tables` runs the tests with their whole sets first.

use std::fmt::Write;
use std::path::Path;
use std::process::ExitCode;
use std::{fs, io};

/// At the beginning of a line: prose may speak of marks.
const BEGIN: &str = "\n<!-- summary ";
const END: &str = "<!-- end of summary -->";

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

fn main() -> ExitCode {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut missing = Vec::new();
    let pages = fs::read_dir(root.join("docs")).expect("docs can be read");
    for page in pages.map(|entry| entry.expect("docs can be read").path()) {
        if page.extension().is_none_or(|extension| extension != "md") {
            continue;
        }
        let before = fs::read_to_string(&page).expect("pages are text");
        let after = match filled(&before, &root.join("target/reports"), &mut missing) {
            Ok(after) => after,
            Err(error) => {
                eprintln!("{}: {error}", page.display());
                return ExitCode::FAILURE;
            }
        };
        if after != before {
            fs::write(&page, after).expect("pages can be written");
            println!("{} written", page.display());
        }
    }
    for name in missing {
        println!("summary {name} is not in target/reports: its table stays as it is; run its test");
    }
    ExitCode::SUCCESS
}
