//! Rails whose section varies along the track and wheels whose section varies around: files of
//! slices (.slcs, .slcw) and tables of sections.
//!
//! A file of slices holds numbers and names in a fixed order, several on a line, `%` before a
//! comment:
//!
//! ```text
//! U_OFFSET  U_SCALE           place [mm] = U_SCALE (U_OFFSET + U_SLC)
//! NSLC                        number of slices
//! NFEAT  NKINK  NACCEL        numbers of features, kinks and accelerations
//! U_INTPOL                    1: through the slices, 2: near them
//! U_SLC  'file'               NSLC times
//! ...                         part numbers of kinks and accelerations, without effect
//! U_SLC  S_1 .. S_NFEAT       NSLC times, if NFEAT > 1: lengths [mm] along the slice to its features, -1 for none
//! ```
//!
//! That of a wheel has TH for U, and angles in rad in the place of places in mm.
//!
//! A table of sections has the heading `station_m,profile`, of a wheel `angle_deg,profile`, and a
//! line for each section. Names of profiles are built-in ones or files, relative to the folder of
//! the file.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use super::named_file::text;
use super::profile_file::{bytes_of, find, load_profile};
use super::section_table::{is_table, read_table};
use super::slice_list::{Entry, Listed, MAX_SLICES, MIN_DISTANCE, Places};
use super::slice_tokens::{Token, Tokens};
use crate::error::ContactError;
use crate::geometry::profiles::profile::{Profile, ProfileError, ProfileKind, ProfileRemark};
use crate::geometry::profiles::standard_profiles::built_in;
use crate::geometry::sections::slices::{Slice, Slices};

/// Most features of a slice.
const MAX_FEATURES: usize = 1000;
/// Distance up to which the place in a line of features is that of its slice, over the least
/// distance of slices.
const SAME: f64 = 0.5;

/// The slices that a parameter names, or nothing where it names no file of slices and no table of
/// sections.
///
/// * `parameter`, `name`, `kind`, `smoothing`, `folders`: as of [`load_profile`]
///
/// # Errors
/// [`ContactError::Profile`] with the file, the line and what to do.
pub fn load_slices(
    parameter: &str,
    name: &str,
    kind: ProfileKind,
    smoothing: f64,
    folders: &[PathBuf],
) -> Result<Option<Slices>, ContactError> {
    let refuse = |problem| ContactError::Profile { name: parameter.into(), problem };
    if !matches!(built_in(name, kind), Ok(None)) {
        return Ok(None);
    }
    let extension = Path::new(name).extension().and_then(|e| e.to_str()).unwrap_or_default();
    let places = Places::of(kind);
    let is_of_slices = extension.eq_ignore_ascii_case(places.extension);
    // What has to be said of a missing file the reader of profiles says.
    let Ok(path) = find(name, kind, folders) else { return Ok(None) };
    if !is_of_slices && !path.is_file() {
        return Ok(None);
    }
    let file = path.display().to_string();
    let text = &text(&bytes_of(&path).map_err(refuse)?);
    let listed = if is_of_slices {
        read_slices(&file, text, &places).map_err(refuse)?
    } else if is_table(text) {
        read_table(&file, text, &places).map_err(refuse)?
    } else {
        return Ok(None);
    };
    listed.check(&file, &places).map_err(refuse)?;
    let folder = path.parent().map(Path::to_path_buf).unwrap_or_default();
    let own_folders = [folder];
    let mut known: HashMap<String, Profile> = HashMap::new();
    let mut slices = Vec::with_capacity(listed.entries.len());
    // A section without a mark whether it stands upright is judged by its own shape, which does not
    // tell for one with a groove.
    let mut turned: Option<(String, bool)> = None;
    for Entry { line, place, name, features } in listed.entries {
        if !known.contains_key(&name) {
            let read = load_profile(parameter, &name, kind, smoothing, &own_folders);
            let read = read.map_err(|error| match error {
                ContactError::Profile { problem, .. } => {
                    let (file, what) = (file.clone(), problem.to_string());
                    refuse(ProfileError::BadSlices { file, line, what })
                }
                other => other,
            })?;
            let is_turned =
                read.remarks.iter().any(|r| matches!(r, ProfileRemark::MirroredZ { .. }));
            let is_file = matches!(built_in(&name, kind), Ok(None));
            match &turned {
                Some((other, of_other)) if is_file && *of_other != is_turned => {
                    let [up, down] = if is_turned { [other, &name] } else { [&name, other] };
                    let what = format!(
                        "\"{down}\" looks upside down and is turned over, \"{up}\" is not; write # mirror_z 0 (as it stands) or # mirror_z 1 into each"
                    );
                    return Err(refuse(ProfileError::BadSlices { file, line, what }));
                }
                None if is_file => turned = Some((name.clone(), is_turned)),
                _ => {}
            }
            known.insert(name.clone(), read);
        }
        let Some(profile) = known.get(&name).cloned() else { continue };
        slices.push(Slice { place, profile, features });
    }
    Slices::new(&file, slices, listed.passes_near)
        .map(Some)
        .map_err(|what| refuse(ProfileError::BadSlices { file, line: 1, what }))
}

fn read_slices(file: &str, text: &str, places: &Places) -> Result<Listed, ProfileError> {
    let mut tokens = Tokens::new(file, text);
    let name = places.name;
    let (offset, _) = tokens.number(&format!("{name}_OFFSET"))?;
    let (scale, line) = tokens.number(&format!("{name}_SCALE"))?;
    if scale <= 0.0 {
        let what = format!("{name}_SCALE is {scale}; give a number greater than 0");
        return tokens.bad(line, what);
    }
    let count = tokens.count("the number of slices NSLC", MAX_SLICES)?;
    let feature_count = tokens.count("the number of features NFEAT", MAX_FEATURES)?;
    let kinks = tokens.count("the number of kinks NKINK", MAX_FEATURES)?;
    let accelerations = tokens.count("the number of accelerations NACCEL", MAX_FEATURES)?;
    let (interpolation, line) = tokens.number(&format!("{name}_INTPOL"))?;
    let passes_near = match interpolation.to_string().as_str() {
        "1" => false,
        "2" => true,
        shown => {
            let what = format!(
                "{name}_INTPOL is {shown}; give 1 for a surface through the slices or 2 for one near them"
            );
            return tokens.bad(line, what);
        }
    };
    tokens.end_line();
    let scale = places.size * scale;
    let place_of = |u: f64| scale * (offset + u);
    let mut entries = Vec::with_capacity(count);
    for i in 1..=count {
        let (u, _) = tokens.number(&format!("the place of slice {i} of {count}"))?;
        let (name, line) = tokens.name(&format!("the file of slice {i} of {count}"))?;
        entries.push(Entry { line, place: place_of(u), name, features: Vec::new() });
    }
    for (count, what) in [(kinks, "kink"), (accelerations, "acceleration")] {
        for i in 1..=count {
            tokens.number(&format!("the part number of {what} {i}"))?;
        }
    }
    if feature_count > 1 {
        for (i, entry) in entries.iter_mut().enumerate() {
            let (u, line) =
                tokens.number(&format!("the place in line {} of the features", i + 1))?;
            if (place_of(u) - entry.place).abs() > SAME * MIN_DISTANCE * places.size {
                let what = format!(
                    "the line of features is for the place {u}, slice {} is another; give the features in the order of the slices",
                    i + 1
                );
                return tokens.bad(line, what);
            }
            let mut before = f64::NEG_INFINITY;
            for f in 1..=feature_count {
                let (length, line) = tokens.number(&format!("feature {f} of slice {}", i + 1))?;
                if length < 0.0 {
                    entry.features.push(None);
                    continue;
                }
                if length <= before {
                    let what = format!(
                        "feature {f} at {length} mm does not lie behind the one before, at {before} mm; features may not cross"
                    );
                    return tokens.bad(line, what);
                }
                before = length;
                entry.features.push(Some(1e-3 * length));
            }
            if entry.features.iter().flatten().count() < 2 {
                let what = format!(
                    "slice {} has fewer than two features; at least one part has to be there",
                    i + 1
                );
                return tokens.bad(line, what);
            }
        }
    }
    if let Some((token, line)) = tokens.all.get(tokens.next) {
        let shown = match token {
            Token::Number(x) => x.to_string(),
            Token::Name(name) => format!("'{name}'"),
        };
        let what = format!(
            "{shown} is left over behind {count} slices and {feature_count} features; check NSLC and NFEAT"
        );
        return tokens.bad(*line, what);
    }
    Ok(Listed { entries, passes_near })
}
