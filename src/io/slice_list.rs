//! The slices that a file names, before their profiles are read.

use crate::geometry::profiles::profile::{ProfileError, ProfileKind};

/// Most slices of a body.
pub(super) const MAX_SLICES: usize = 20_000;

/// Least distance of two slices, in units of their file.
pub(super) const MIN_DISTANCE: f64 = 1e-3;

/// How the places of slices are given.
pub(super) struct Places {
    /// What the name of a file of slices ends with.
    pub extension: &'static str,
    /// What the names of its values begin with.
    pub name: &'static str,
    /// Unit of places in it, and the same in m or rad.
    pub unit: &'static str,
    pub size: f64,
    /// Heading of their column in a table, and its unit in m or rad.
    pub heading: &'static str,
    pub heading_size: f64,
}

impl Places {
    pub fn of(kind: ProfileKind) -> Self {
        match kind {
            ProfileKind::Rail => Self {
                extension: "slcs",
                name: "U",
                unit: "mm",
                size: 1e-3,
                heading: "station_m",
                heading_size: 1.0,
            },
            ProfileKind::Wheel => Self {
                extension: "slcw",
                name: "TH",
                unit: "rad",
                size: 1.0,
                heading: "angle_deg",
                heading_size: 1_f64.to_radians(),
            },
        }
    }
}

/// A slice as it is named.
#[derive(Debug)]
pub(super) struct Entry {
    pub line: usize,
    /// Station [m]; of a wheel the angle [rad].
    pub place: f64,
    pub name: String,
    /// Lengths along the slice to its features [m]; nothing for what is not there.
    pub features: Vec<Option<f64>>,
}

#[derive(Debug)]
pub(super) struct Listed {
    pub entries: Vec<Entry>,
    pub passes_near: bool,
}

impl Listed {
    pub fn check(&self, file: &str, places: &Places) -> Result<(), ProfileError> {
        let Places { unit, size, .. } = places;
        let bad =
            |line, what: String| Err(ProfileError::BadSlices { file: file.into(), line, what });
        let last = self.entries.last().map_or(1, |entry| entry.line);
        if self.entries.len() < 2 {
            return bad(last, "there is one slice or none; give two or more".into());
        }
        for pair in self.entries.windows(2) {
            let [before, entry] = [&pair[0], &pair[1]];
            // Less what rounding leaves of it.
            if entry.place - before.place < MIN_DISTANCE * size * (1.0 - 1e-9) {
                let [own, other] = [entry.place, before.place].map(|x| x / size);
                let what = format!(
                    "the slice at {own} {unit} does not lie behind the one before, at {other} {unit}; put the slices in the order of their places, at least {MIN_DISTANCE} {unit} apart"
                );
                return bad(entry.line, what);
            }
        }
        Ok(())
    }
}
