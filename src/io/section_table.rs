//! A table of sections: `station_m,profile`, of a wheel `angle_deg,profile`, and a line for each
//! section.

use super::slice_list::{Entry, Listed, MAX_SLICES, Places};
use super::slice_tokens::COMMENT;
use super::table::{lines, number};
use crate::geometry::profiles::profile::ProfileError;

/// Whether a text is a table of sections.
pub(super) fn is_table(text: &str) -> bool {
    heading(text).is_some_and(|(_, columns)| columns.len() == 2 && columns[1] == "profile")
}

/// The number of the first line that is no comment, and its columns.
fn heading(text: &str) -> Option<(usize, Vec<String>)> {
    let line = lines(text).find(|line| !line.text.is_empty() && !line.text.starts_with(COMMENT))?;
    Some((line.number, cells(line.text)))
}

fn cells(text: &str) -> Vec<String> {
    text.split([',', ';', '\t'])
        .map(|cell| cell.trim().trim_matches(['\'', '"']).to_owned())
        .collect()
}

pub(super) fn read_table(file: &str, text: &str, places: &Places) -> Result<Listed, ProfileError> {
    let bad = |line, what: String| Err(ProfileError::BadSlices { file: file.into(), line, what });
    let (first, columns) = heading(text).unwrap_or_default();
    let wanted = places.heading;
    if columns[0] != wanted {
        let what = format!(
            "the heading of a table of sections is \"{wanted},profile\", not \"{},profile\"",
            columns[0]
        );
        return bad(first, what);
    }
    let mut entries = Vec::new();
    for line in lines(text).filter(|line| line.number > first) {
        if line.text.is_empty() || line.text.starts_with(COMMENT) {
            continue;
        }
        let cells = cells(line.text);
        let place = cells.first().and_then(|cell| number(cell)).filter(|x| x.is_finite());
        let (Some(place), [_, name]) = (place, cells.as_slice()) else {
            return bad(
                line.number,
                format!("\"{}\" is no section; give {wanted} and a profile", line.shown()),
            );
        };
        if entries.len() == MAX_SLICES {
            return bad(line.number, format!("there are more than {MAX_SLICES} sections"));
        }
        let (name, place) = (name.clone(), places.heading_size * place);
        entries.push(Entry { line: line.number, place, name, features: Vec::new() });
    }
    Ok(Listed { entries, passes_near: false })
}
