//! What was mended in profile files or is suspect, told on standard error.

use std::collections::HashSet;

use wheelrail::geometry::profile::ProfileRemark;

/// What was found in the files of profiles, with the parameter that names each.
pub type Found = Vec<(String, ProfileRemark)>;

/// Remarks that have been told: each is told once, however many elements read the file.
#[derive(Debug, Default)]
pub struct Remarks(HashSet<String>);

impl Remarks {
    /// Tells those that are warnings and have not been told: one line each, with the parameter that names the file.
    pub fn tell(&mut self, remarks: &[(String, ProfileRemark)]) {
        for (parameter, remark) in remarks.iter().filter(|(_, remark)| remark.is_warning()) {
            let text = remark.to_string();
            if !self.0.contains(&text) {
                eprintln!("warning: {parameter}: {text}");
                self.0.insert(text);
            }
        }
    }
}
