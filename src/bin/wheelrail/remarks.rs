//! What is odd about profile files and evaluations, told on standard error.

use std::collections::{BTreeMap, HashSet};

use wheelrail::element::{Element, Input, Output, Parameters, Remark, remarks, without_effect};
use wheelrail::geometry::profile::ProfileRemark;

/// What was found in the files of profiles, with the parameter that names each.
pub type ProfileRemarks = Vec<(String, ProfileRemark)>;

/// What was found where an element was made or evaluated.
#[derive(Debug, Default)]
pub struct Found {
    /// Where in the table that is; empty where there is one place alone.
    place: String,
    /// What was found in the files of its profiles.
    profiles: ProfileRemarks,
    remarks: Vec<Remark>,
}

impl Found {
    /// What is odd about the evaluation of `input` that gave `output`.
    pub fn evaluated(
        element: &Element,
        parameters: &Parameters,
        input: &Input,
        output: &Output,
    ) -> Self {
        let mut found = Self::default();
        remarks(element, parameters, input, output, |_, remark| found.remarks.push(remark));
        found
    }

    /// The same and what is odd about the place in which the element starts.
    pub fn with_start(mut self, element: &Element) -> Self {
        self.remarks.extend(element.start_warning().map(Remark::Place));
        self
    }

    /// The same and which of the inputs that are given by name have no effect.
    pub fn with_inputs<'a>(
        mut self,
        parameters: &Parameters,
        names: impl Iterator<Item = &'a str>,
    ) -> Self {
        self.remarks.extend(names.filter_map(|name| without_effect(parameters, name)));
        self
    }

    /// The same with what was found in the files of profiles.
    pub fn with_profiles(self, profiles: ProfileRemarks) -> Self {
        Self { profiles, ..self }
    }

    /// The same with the place in the table, which is asked for only where there is anything to
    /// tell.
    pub fn at(self, place: impl FnOnce() -> String) -> Self {
        if self.is_empty() { self } else { Self { place: place(), ..self } }
    }

    /// Whether there is nothing to tell.
    pub fn is_empty(&self) -> bool {
        self.profiles.is_empty() && self.remarks.is_empty()
    }
}

/// What has been told: each remark on a file once, however many elements read it, and each kind of
/// remark once, with the first row that has it; how many rows have it is told at the end.
#[derive(Debug, Default)]
pub struct Remarks {
    files: HashSet<String>,
    /// Titles and rows by kind, and where inputs have no effect by input.
    rows: BTreeMap<(usize, &'static str), usize>,
}

impl Remarks {
    /// Tells what is a warning and has not been told: one line each, files with the parameter that
    /// names them, evaluations with the row.
    pub fn tell(&mut self, found: &Found) {
        for (parameter, remark) in found.profiles.iter().filter(|(_, r)| r.is_warning()) {
            let text = remark.to_string();
            if !self.files.contains(&text) {
                eprintln!("warning: {parameter}: {text}");
                self.files.insert(text);
            }
        }
        for remark in &found.remarks {
            let about = match remark {
                Remark::NoEffect { input, .. } => input,
                other => other.title(),
            };
            let rows = self.rows.entry((remark.kind(), about)).or_default();
            *rows += 1;
            if *rows > 1 {
                continue;
            }
            let text = remark.message("");
            match found.place.as_str() {
                "" => eprintln!("warning: {text}"),
                place => eprintln!("warning: {place}: {text}"),
            }
        }
    }

    /// Tells in how many rows what was told of one of them is found.
    pub fn count(&self) {
        let no_effect = Remark::NoEffect { input: "", parameter: "", chosen: "", with: "" };
        for ((kind, about), rows) in self.rows.iter().filter(|(_, rows)| **rows > 1) {
            let effect = if *kind == no_effect.kind() { " without effect" } else { "" };
            eprintln!("warning: {rows} rows: {about}{effect}");
        }
    }
}
