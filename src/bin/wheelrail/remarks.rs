//! What is suspect about profile files, starting places and depths, told on standard error.

use std::collections::HashSet;
use std::mem::{Discriminant, discriminant};

use wheelrail::element::{Element, StartWarning, sunk_message};
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
    start: Option<StartWarning>,
    sunk: Option<f64>,
}

impl Found {
    /// What is odd about the place in which an element was evaluated last.
    pub fn about_depth(element: &Element) -> Self {
        Self { sunk: element.sunk(), ..Self::default() }
    }

    /// The same and what is odd about that in which it starts.
    pub fn about_places(element: &Element) -> Self {
        Self { start: element.start_warning(), ..Self::about_depth(element) }
    }

    /// The same and what was found in the files of its profiles.
    pub fn all(element: &Element) -> Self {
        Self::about_places(element).with_profiles(element.profile_remarks().to_vec())
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
        self.profiles.is_empty() && self.start.is_none() && self.sunk.is_none()
    }
}

/// What has been told: each remark on a file once, however many elements read it, and each kind of
/// odd place once, however many rows of a table are in it.
#[derive(Debug, Default)]
pub struct Remarks {
    files: HashSet<String>,
    starts: HashSet<Discriminant<StartWarning>>,
    sunk: bool,
}

impl Remarks {
    /// Tells what is a warning and has not been told: one line each, files with the parameter that
    /// names them, places with the row.
    pub fn tell(&mut self, found: &Found) {
        for (parameter, remark) in found.profiles.iter().filter(|(_, r)| r.is_warning()) {
            let text = remark.to_string();
            if !self.files.contains(&text) {
                eprintln!("warning: {parameter}: {text}");
                self.files.insert(text);
            }
        }
        let place = |text: String| match found.place.as_str() {
            "" => eprintln!("warning: {text}"),
            place => eprintln!("warning: {place}: {text}"),
        };
        if let Some(start) = found.start.filter(|start| self.starts.insert(discriminant(start))) {
            place(start.message(""));
        }
        if let Some(depth) = found.sunk.filter(|_| !std::mem::replace(&mut self.sunk, true)) {
            place(sunk_message(depth, "").to_string());
        }
    }
}
