//! Profiles by name: built in, or from a file of one of several formats.

use std::path::{Path, PathBuf};

use super::draft::{Draft, write as write_whole};
use super::named_file::{self, content, text};
use super::stated::Stated;
use super::{miniprof, simpack, two_column};
use crate::error::ContactError;
use crate::geometry::profiles::point_noise::{ADMITTED_SMOOTHING, SMOOTHING_ALLOWED};
use crate::geometry::profiles::profile::{Profile, ProfileError, ProfileKind};
use crate::geometry::profiles::profile_points::ProfilePoints;
use crate::geometry::profiles::standard_profiles::{built_in, built_in_names};

/// A format that files have by their extension or their content.
struct Format {
    name: &'static str,
    /// Of wheels and of rails, in lower case.
    extensions: [&'static str; 2],
    is_recognised: fn(content: &str) -> bool,
    read: fn(
        file: &str,
        content: &str,
        kind: ProfileKind,
        stated: &Stated,
    ) -> Result<ProfilePoints, ProfileError>,
}

/// All formats but that of two columns, which is what has none of these.
const FORMATS: [Format; 2] = [
    Format {
        name: "SIMPACK",
        extensions: ["prw", "prr"],
        is_recognised: simpack::is_recognised,
        read: |file, content, kind, _| simpack::read(file, content, kind),
    },
    Format {
        name: "MiniProf",
        extensions: ["whl", "ban"],
        is_recognised: miniprof::is_recognised,
        read: miniprof::read,
    },
];

/// The profile that a parameter names: a built-in or analytic one, else a file.
///
/// * `parameter`: FMU name of the parameter, such as `wheel.profile`, for messages.
/// * `name`: a built-in name ([`built_in_names`]), an absolute path, or a relative one, which is
///   looked for in `folders` in their order.
/// * `smoothing` [m], 0 to 0.05: wavelength at which a wave along the profile keeps half its
///   amplitude; a negative number (-1, the start value of the parameter) leaves it to the noise of
///   the points, 0 passes through every point. Only profiles from files are smoothed. What 4 mm do:
///   a wave of 2 mm keeps 6 %, one of 8 mm 94 %; lines and arcs stay; where the curvature steps by
///   Δκ the profile moves by 0.16 Δκ (L/2π)², on S1002 0.3 µm on the tread and 6 µm on the flange.
///
/// What was found in the file and mended stands in [`Profile::remarks`].
///
/// The format follows from the extension: SIMPACK `.prw` and `.prr`, `MiniProf` `.whl` and `.ban`;
/// the content decides for others and where it is evidently another format, and what is neither is
/// read as two columns, `y_mm` and `z_mm`.
///
/// # Errors
/// [`ContactError::Profile`] with the file, the line and what to do; [`ContactError::BadValue`] for
/// a smoothing outside its range.
pub fn load_profile(
    parameter: &str,
    name: &str,
    kind: ProfileKind,
    smoothing: f64,
    folders: &[PathBuf],
) -> Result<Profile, ContactError> {
    if !ADMITTED_SMOOTHING.contains(&smoothing) {
        return Err(ContactError::bad_value("profile.smoothing", smoothing, SMOOTHING_ALLOWED));
    }
    let profile = match built_in(name, kind) {
        Ok(Some(profile)) => Ok(profile),
        Ok(None) => find(name, kind, folders).and_then(|path| from_file(&path, kind, smoothing)),
        Err(error) => Err(error),
    };
    profile.map_err(|problem| ContactError::Profile { name: parameter.into(), problem })
}

/// Writes a profile as a file of two columns that [`load_profile`] reads back as it is: no
/// smoothing is applied to it. What had that name before stays until the new one is complete.
///
/// * `parameter`: FMU name of the parameter that names the file, for messages.
///
/// # Errors
/// [`ContactError::Profile`] with the file and what the operating system says.
pub fn save_profile(parameter: &str, path: &Path, profile: &Profile) -> Result<(), ContactError> {
    let written = write_whole(path, two_column::text(profile).as_bytes());
    written.map_err(|e| unwritable(parameter, path, &e))
}

/// Whether a profile could be written to `path`; leaves nothing behind.
///
/// # Errors
/// As [`save_profile`].
pub(crate) fn can_be_written(parameter: &str, path: &Path) -> Result<(), ContactError> {
    Draft::new(path).map(drop).map_err(|e| unwritable(parameter, path, &e))
}

fn unwritable(parameter: &str, path: &Path, error: &std::io::Error) -> ContactError {
    let (file, reason) = (path.display().to_string(), error.to_string());
    let problem = ProfileError::Unwritable { file, reason };
    ContactError::Profile { name: parameter.into(), problem }
}

/// The file that `name` stands for in [`load_profile`], unless it is the name of a built-in profile
/// or there is no such file.
pub(crate) fn profile_file(name: &str, kind: ProfileKind, folders: &[PathBuf]) -> Option<PathBuf> {
    match built_in(name, kind) {
        Ok(None) => find(name, kind, folders).ok(),
        _ => None,
    }
}

/// The file of that name: an absolute path, or the first of the folders that has it.
pub(super) fn find(
    name: &str,
    kind: ProfileKind,
    folders: &[PathBuf],
) -> Result<PathBuf, ProfileError> {
    named_file::find(name, folders).map_err(|looked_for| ProfileError::Unknown {
        name: name.into(),
        kind,
        built_in: built_in_names(kind),
        looked_for,
    })
}

fn from_file(path: &Path, kind: ProfileKind, smoothing: f64) -> Result<Profile, ProfileError> {
    let bytes = bytes_of(path)?;
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or_default();
    read(&path.display().to_string(), extension, &bytes, kind)?.into_profile(kind, smoothing)
}

/// The content of a file.
pub(super) fn bytes_of(path: &Path) -> Result<Vec<u8>, ProfileError> {
    content(path)
        .map_err(|reason| ProfileError::Unreadable { file: path.display().to_string(), reason })
}

/// Points of a file by its extension and content.
fn read(
    file: &str,
    extension: &str,
    bytes: &[u8],
    kind: ProfileKind,
) -> Result<ProfilePoints, ProfileError> {
    read_known(file, extension, bytes, kind).map_err(|error| match error {
        ProfileError::UnknownFormat { file, line, what } => {
            let known = FORMATS.map(|Format { name, extensions: [wheel, rail], .. }| {
                format!("a {name} file (.{wheel}, .{rail})")
            });
            let known = known.join(", ");
            let what = format!("{what}; give {known} or text with the two columns y_mm z_mm");
            ProfileError::UnknownFormat { file, line, what }
        }
        other => other,
    })
}

fn read_known(
    file: &str,
    extension: &str,
    bytes: &[u8],
    kind: ProfileKind,
) -> Result<ProfilePoints, ProfileError> {
    if let Some(at) = bytes.iter().position(|&b| b == 0) {
        let line = bytes[..at].split(|&b| b == b'\n').count();
        let what = "it is not text".into();
        return Err(ProfileError::UnknownFormat { file: file.into(), line, what });
    }
    let content = &text(bytes);
    let extension = extension.to_ascii_lowercase();
    if let ("whl", ProfileKind::Rail) | ("ban", ProfileKind::Wheel) = (extension.as_str(), kind) {
        return Err(ProfileError::WrongKind { file: file.into(), line: 1, kind });
    }
    if let "slcs" | "slcw" = extension.as_str() {
        let what = "slices make a rail that varies along the track (.slcs, as rail[k].profile) or a wheel that varies around (.slcw, as wheel.profile); give one profile here";
        let (file, what) = (file.into(), what.into());
        return Err(ProfileError::BadSlices { file, line: 1, what });
    }
    let stated = Stated::of(file, content)?;
    // The extension decides unless the content is that of other formats alone.
    let named = FORMATS.iter().find(|format| format.extensions.contains(&extension.as_str()));
    let mut recognised = named.into_iter().chain(&FORMATS).filter(|f| (f.is_recognised)(content));
    let points = match recognised.next().or(named) {
        Some(format) => (format.read)(file, content, kind, &stated),
        None => two_column::read(file, content, &stated),
    };
    points.map(|points| stated.apply(points))
}

#[cfg(test)]
mod tests {
    use std::fmt::Write;
    use std::fs;

    use approx::assert_relative_eq;
    use tempfile::TempDir;

    use super::*;
    use crate::geometry::profiles::profile_points::tests::sampled;

    const RAIL: ProfileKind = ProfileKind::Rail;

    fn two_columns(points: &[[f64; 2]]) -> String {
        let mut text = String::from("y_mm,z_mm\n");
        for [y, z] in points {
            writeln!(text, "{:.7},{:.7}", y * 1e3, z * 1e3).unwrap();
        }
        text
    }

    /// What loading a file with this content says.
    fn refused(file: &str, content: &[u8]) -> String {
        let folder = TempDir::new().unwrap();
        fs::write(folder.path().join(file), content).unwrap();
        let folders = [folder.path().to_path_buf()];
        load_profile("rail[1].profile", file, RAIL, 0.002, &folders).unwrap_err().to_string()
    }

    #[test]
    fn built_in_names_come_first_and_are_not_smoothed() {
        let rail = load_profile("rail[1].profile", "60e1", RAIL, 0.05, &[]).unwrap();
        assert_relative_eq!(rail.bounds().y[1], 0.037_052_3, epsilon = 1e-4);
        assert!(
            load_profile("wheel.profile", "conical:0.05", ProfileKind::Wheel, 0.0, &[]).is_ok()
        );
    }

    #[test]
    fn relative_names_are_looked_for_in_the_folders_in_order_and_absolute_ones_as_they_are() {
        let (first, second) = (TempDir::new().unwrap(), TempDir::new().unwrap());
        let points = sampled("60E1", RAIL, 5e-4);
        let wide: Vec<_> = points.iter().map(|p| [p[0] * 1.1, p[1]]).collect();
        fs::write(second.path().join("rail.txt"), two_columns(&wide)).unwrap();
        let folders = [first.path().to_path_buf(), second.path().to_path_buf()];
        let width = |name: &str| {
            load_profile("rail[1].profile", name, RAIL, 0.002, &folders).unwrap().bounds().y[1]
        };
        assert_relative_eq!(width("rail.txt"), 1.1 * 0.037_052_3, epsilon = 1e-4);
        let absolute = second.path().join("rail.txt");
        fs::write(first.path().join("rail.txt"), two_columns(&points)).unwrap();
        assert_relative_eq!(width("rail.txt"), 0.037_052_3, epsilon = 1e-4);
        assert_relative_eq!(width(absolute.to_str().unwrap()), 1.1 * 0.037_052_3, epsilon = 1e-4);
    }

    #[test]
    fn a_name_that_is_nothing_lists_what_was_looked_for_and_what_there_is() {
        let folders = [PathBuf::from("here"), PathBuf::from("there")];
        let error = load_profile("wheel.profile", "S1003", ProfileKind::Wheel, 0.0, &folders);
        let text = error.unwrap_err().to_string();
        for part in ["wheel.profile", "S1003", "S1002", "conical", "here", "there", "full path"] {
            assert!(text.contains(part), "{part} is not in: {text}");
        }
        let error = load_profile("rail[1].profile", "", RAIL, 0.0, &folders).unwrap_err();
        assert!(error.to_string().contains("60E1"), "{error}");
    }

    #[test]
    fn the_content_decides_where_the_extension_does_not() {
        let folder = TempDir::new().unwrap();
        let points = sampled("60E1", RAIL, 5e-4);
        let body = two_columns(&points).replace(',', " ");
        let body = body.split_once('\n').unwrap().1;
        let simpack =
            format!("spline.begin\nunits.len.f=1000\npoint.begin\n{body}point.end\nspline.end\n");
        let up: Vec<_> = points.iter().map(|p| p.map(|x| -x)).collect();
        let up = two_columns(&up).replace(',', " ");
        let miniprof = format!("XYPoints=3\n\n{}", up.split_once('\n').unwrap().1);
        let files = [
            ("a.dat", simpack.as_str()),
            ("a.ban", simpack.as_str()),
            ("b.prr", miniprof.as_str()),
            ("b.BAN", miniprof.as_str()),
            ("c", body),
        ];
        for (file, content) in files {
            fs::write(folder.path().join(file), content).unwrap();
            let folders = [folder.path().to_path_buf()];
            let rail = load_profile("rail[1].profile", file, RAIL, 0.0, &folders).unwrap();
            assert_relative_eq!(rail.bounds().z[1], 0.039_335, epsilon = 1e-5);
        }
    }

    #[test]
    fn what_cannot_be_read_is_refused_with_parameter_file_and_advice() {
        let few = two_columns(&sampled("60E1", RAIL, 0.05));
        let cases: [(&str, &[u8], &[&str]); 5] = [
            ("few.txt", few.as_bytes(), &["few.txt:5", "too few points", "check that"]),
            ("binary.prr", b"a\nb\0c", &["binary.prr:2", "not text", "SIMPACK"]),
            ("empty.txt", b"", &["empty.txt:1", "too few points"]),
            ("empty.prr", b"", &["empty.prr:1", "point.begin", ".prr"]),
            ("letter.ban", b"Dear reader,\n\nhello\n", &["letter.ban:4", "MiniProf"]),
        ];
        for (file, content, parts) in cases {
            let text = refused(file, content);
            for part in parts.iter().chain(&["rail[1].profile"]) {
                assert!(text.contains(part), "{part} is not in: {text}");
            }
        }
    }

    proptest::proptest! {
        #[test]
        fn no_content_makes_a_reader_panic(
            body in "([-+0-9.eE]{1,4}[ ,;\t]{1,2}[-+0-9.]{1,4}\n|[!#=a-e\n0-9 .-]{0,9}\n){0,60}",
            wavelength in 0.0..0.05f64,
        ) {
            let texts = [
                ("a", body.clone()),
                ("ban", format!("Units=mm\n\n{body}")),
                ("prr", format!("spline.begin\nunits.len.f=1000\npoint.begin\n{body}\npoint.end")),
            ];
            for (extension, text) in texts {
                for smoothing in [0.0, -1.0, wavelength] {
                    if let Ok(points) = read("a", extension, text.as_bytes(), RAIL) {
                        _ = points.into_profile(RAIL, smoothing);
                    }
                }
            }
        }

        #[test]
        fn no_walk_of_points_makes_the_curve_panic(
            steps in proptest::collection::vec((-2e-3..6e-3f64, -2e-3..2e-3f64), 8..60),
            wavelength in 0.0..0.05f64,
        ) {
            let mut at = [-0.02, 0.0];
            let points: Vec<[f64; 2]> = steps
                .iter()
                .map(|step| {
                    at = [at[0] + step.0, at[1] + step.1];
                    at
                })
                .collect();
            for kind in [RAIL, ProfileKind::Wheel] {
                let points = crate::geometry::profiles::profile_points::tests::points_of(&points);
                _ = points.clone().into_profile(kind, -1.0);
                _ = points.into_profile(kind, wavelength);
            }
        }
    }

    #[cfg(unix)]
    #[test]
    fn a_saved_profile_takes_the_place_of_the_old_one_as_a_whole() {
        let folder = TempDir::new().unwrap();
        let path = |name: &str| folder.path().join(name);
        fs::write(path("worn.txt"), "older").unwrap();
        // A second name of the same file tells whether it was written into.
        fs::hard_link(path("worn.txt"), path("kept.txt")).unwrap();
        let rail = built_in("60E1", RAIL).unwrap().unwrap();
        save_profile("wear.rail[1].file", &path("worn.txt"), &rail).unwrap();
        assert_eq!(fs::read_to_string(path("kept.txt")).unwrap(), "older");
        let name = path("worn.txt");
        let read = load_profile("rail[1].profile", name.to_str().unwrap(), RAIL, 0.0, &[]).unwrap();
        assert_relative_eq!(read.bounds().y[1], rail.bounds().y[1], epsilon = 1e-6);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2);
        let error = save_profile("wear.rail[1].file", folder.path(), &rail).unwrap_err();
        assert!(error.to_string().starts_with("wear.rail[1].file: "), "{error}");
    }

    #[test]
    fn a_folder_is_not_a_profile() {
        let folder = TempDir::new().unwrap();
        let name = folder.path().to_str().unwrap();
        let error = load_profile("rail[1].profile", name, RAIL, 0.0, &[]).unwrap_err();
        assert!(error.to_string().contains("it is not a file; check the path"), "{error}");
    }

    #[test]
    fn smoothing_must_be_a_wavelength() {
        for smoothing in [-2.0, 2.0, f64::NAN, f64::INFINITY] {
            let error = load_profile("rail[1].profile", "60E1", RAIL, smoothing, &[]).unwrap_err();
            assert!(error.to_string().starts_with("profile.smoothing ="), "{error}");
        }
    }
}
