//! `wheelrail linearize`: a table over the speed, the critical speed, and what is refused.

use super::*;

#[test]
fn a_wheelset_hunts_from_its_critical_speed_on() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name).display().to_string();
    let [table, figure, matrix] = ["roots.csv", "roots.svg", "matrix.csv"].map(file);
    let output = wheelrail(&[
        "linearize",
        "--from",
        "40",
        "--to",
        "70",
        "--speeds",
        "4",
        "-o",
        &table,
        "--figure",
        &figure,
        "--matrix",
        &matrix,
    ]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let said = String::from_utf8(output.stdout).unwrap();
    let critical: f64 = said.split_whitespace().nth(2).unwrap().parse().unwrap();
    let mut rows = csv::Reader::from_path(&table).unwrap();
    let mut greatest = std::collections::BTreeMap::new();
    for row in rows.records() {
        let row = row.unwrap();
        let number = |i: usize| row[i].parse::<f64>().unwrap();
        if &row[1] == "1" {
            greatest.insert(row[0].to_string(), number(2));
        }
        assert!((-1.0..=1.0).contains(&number(4)) && number(3) >= 0.0);
    }
    assert_eq!(greatest.len(), 4);
    for (speed, growth) in greatest {
        assert_eq!(growth > 0.0, speed.parse::<f64>().unwrap() > critical, "{speed} {growth}");
    }
    assert!(std::fs::read_to_string(figure).unwrap().contains("growth rate [1/s]"));
    let matrix = csv::Reader::from_path(&matrix).unwrap().records().count();
    assert_eq!(matrix, 9);
}

#[test]
fn what_cannot_be_linearized_is_refused_by_name() {
    for (options, message) in [
        (vec!["--from", "0"], "--from 0 is not admitted"),
        (vec!["--from", "20", "--to", "10"], "--to 10 is not admitted: it is below --from 20"),
        (vec!["--speeds", "0"], "--speeds 0 is not admitted"),
        (vec!["--friction", "0"], "--friction 0 is not admitted"),
        (vec!["--axle-load", "100"], "--axle-load 100 is not admitted"),
        (vec!["--set", "normal.model=boundary_element"], "boundary_element"),
        (vec!["--set", "wheel.y=1"], "--set wheel.y: only parameters"),
    ] {
        let output = wheelrail(&[&["linearize"], options.as_slice()].concat());
        assert!(!output.status.success(), "{options:?}");
        let error = String::from_utf8_lossy(&output.stderr);
        assert!(error.contains(message), "{error}");
    }
}
