//! A table of cases as `wheelrail evaluate` reads it, of any content.

use std::fs;

use wheelrail::element::Element;
use wheelrail::variables::{Values, find};

use super::cases::Cases;
use super::values::{evaluate, is_slow};

/// The bytes are the file.
pub fn check(data: &[u8]) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("cases.csv");
    fs::write(&path, data).expect("a file");
    let Ok(cases) = Cases::read(&path) else { return };
    for row in cases.rows().iter().take(4) {
        let mut values = Values::default();
        for (_, name, text) in row.cells() {
            let before = values.clone();
            let Ok(variable) = find(name) else { return };
            if let Err(refusal) = values.set_from_text(variable, text) {
                assert!(refusal.to_string().contains(name), "{refusal}");
                assert_eq!(values, before, "a refusal changes nothing");
            }
        }
        if is_slow(&values.parameters) {
            return;
        }
        if let Ok(mut element) = Element::new(&values.parameters, &values.input, &[]) {
            evaluate(&mut element, &values.parameters, &values.input);
        }
    }
}
