//! What several integration tests share: reading data, judging sets, leaving reports.

#![allow(dead_code)] // each test crate uses its own part

pub mod contact_plane;
pub mod document;
pub mod kinked_heads;
pub mod planar;
pub mod random;
pub mod roller;
pub mod summary;
pub mod transient;
pub mod varying;
pub mod vectors;
pub mod walk;
pub mod wheel;

use std::path::{Path, PathBuf};

/// A CSV file of tests/data with its `#` lines left out.
pub struct Table {
    pub headings: csv::StringRecord,
    pub rows: Vec<csv::StringRecord>,
}

/// Reads a file below tests/data.
pub fn read_table(name: &str) -> Table {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name);
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(path).unwrap();
    let headings = reader.headers().unwrap().clone();
    Table { headings, rows: reader.records().map(Result::unwrap).collect() }
}

/// Index of a column by its heading.
pub fn column(table: &Table, name: &str) -> usize {
    table.headings.iter().position(|h| h == name).unwrap_or_else(|| panic!("no column {name}"))
}

/// The number in a row under a heading.
pub fn value(table: &Table, row: &csv::StringRecord, name: &str) -> f64 {
    let text = &row[column(table, name)];
    text.parse().unwrap_or_else(|_| panic!("{name}: {text:?} is not a number"))
}

/// Mean, 95 % quantile and greatest of a set of errors.
pub fn quantiles(mut errors: Vec<f64>) -> [f64; 3] {
    errors.sort_by(f64::total_cmp);
    let mean = errors.iter().sum::<f64>() / errors.len() as f64;
    let p95 = errors[(0.95 * (errors.len() - 1) as f64).round() as usize];
    [mean, p95, errors[errors.len() - 1]]
}

/// Median, 95 % and greatest of a set of numbers.
pub fn spread(mut numbers: Vec<f64>) -> [f64; 3] {
    numbers.sort_by(f64::total_cmp);
    let most = numbers[(0.95 * (numbers.len() - 1) as f64).round() as usize];
    let [median, worst] = median_and_worst(numbers);
    [median, most, worst]
}

/// Median and greatest of a set of errors.
pub fn median_and_worst(mut errors: Vec<f64>) -> [f64; 2] {
    errors.sort_by(f64::total_cmp);
    let n = errors.len();
    [0.5 * (errors[(n - 1) / 2] + errors[n / 2]), errors[n - 1]]
}

/// Leaves a table under target/reports, for reading and plotting.
pub fn write_report(name: &str, text: &str) {
    std::fs::write(report_path(name), text).unwrap();
}

/// Path of a table under target/reports.
pub fn report_path(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("target/reports");
    std::fs::create_dir_all(&folder).unwrap();
    folder.join(name)
}
