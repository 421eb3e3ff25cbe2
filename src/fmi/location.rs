//! The folder of resources from what the host hands over.

use std::path::{Path, PathBuf};

/// The folder that a `file:` URI in any of its forms, or a plain absolute path, names.
///
/// Hosts write `file:///path`, `file:/path`, `file://localhost/path` and `file:////path`, with or
/// without a slash at the end, percent-encoded or not. A folder whose name holds `%20` and that was
/// not encoded is known by its being there while the decoded one is not. `None` for anything else.
pub fn of_uri(uri: &str) -> Option<PathBuf> {
    if !is_uri(uri) {
        return folder(uri);
    }
    let rest = &uri[5..];
    let rest = rest.strip_prefix("//localhost").unwrap_or(rest);
    let decoded = decoded(rest).and_then(|path| folder(&path));
    if decoded.as_ref().is_some_and(|folder| folder.exists()) {
        return decoded;
    }
    folder(rest).filter(|as_it_stands| as_it_stands.exists()).or(decoded)
}

/// Whether this is a `file:` URI.
pub fn is_uri(location: &str) -> bool {
    location.get(..5).is_some_and(|scheme| scheme.eq_ignore_ascii_case("file:"))
}

/// The folder of a path behind the scheme, with any number of slashes at its beginning.
fn folder(path: &str) -> Option<PathBuf> {
    let path = path.strip_prefix("//").map_or(path, |rest| {
        // Two slashes are an empty host; more of them are slips of hosts that mean one.
        let rest = rest.trim_start_matches('/');
        &path[path.len() - rest.len() - 1..]
    });
    if !path.starts_with('/') {
        return None;
    }
    // A drive letter stands behind the slash: /C:/folder.
    let bytes = path.as_bytes();
    let has_drive = bytes.len() > 2 && bytes[1].is_ascii_alphabetic() && bytes[2] == b':';
    let path = if has_drive { &path[1..] } else { path };
    let trimmed = path.trim_end_matches('/');
    Some(PathBuf::from(if trimmed.is_empty() { "/" } else { trimmed }))
}

/// The folder that a path of this system names (FMI 3.0, 2.3.1); `None` if it is not absolute.
pub fn of_path(path: &str) -> Option<PathBuf> {
    Some(PathBuf::from(path)).filter(|path| Path::is_absolute(path))
}

/// Replaces `%20` and the like; a percent sign that starts no code stays. `None` if not UTF-8.
fn decoded(text: &str) -> Option<String> {
    let digit = |byte: Option<&u8>| byte.and_then(|&b| char::from(b).to_digit(16));
    let bytes = text.as_bytes();
    let mut out = Vec::with_capacity(bytes.len());
    let mut i = 0;
    while i < bytes.len() {
        match (bytes[i], digit(bytes.get(i + 1)), digit(bytes.get(i + 2))) {
            (b'%', Some(high), Some(low)) => {
                out.push((16 * high + low) as u8);
                i += 3;
            }
            (byte, ..) => {
                out.push(byte);
                i += 1;
            }
        }
    }
    String::from_utf8(out).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_form_that_hosts_use_names_the_same_folder() {
        for uri in [
            "file:///srv/my fmu/resources",
            "file:///srv/my%20fmu/resources",
            "file:///srv/my%20fmu/resources/",
            "file:////srv/my%20fmu/resources",
            "file:/srv/my%20fmu/resources",
            "file://localhost/srv/my%20fmu/resources",
            "FILE:///srv/my%20fmu/resources",
            "/srv/my fmu/resources",
        ] {
            assert_eq!(of_uri(uri), Some("/srv/my fmu/resources".into()), "{uri}");
        }
    }

    #[test]
    fn drive_letters_umlauts_and_odd_percents_survive() {
        assert_eq!(of_uri("file:///C:/fmu/resources"), Some("C:/fmu/resources".into()));
        assert_eq!(of_uri("file:///r%C3%A4der"), Some("/räder".into()));
        assert_eq!(of_uri("file:///100%/x"), Some("/100%/x".into()));
        assert_eq!(of_uri("file:///"), Some("/".into()));
    }

    #[test]
    fn what_is_no_file_is_refused() {
        for uri in ["http://host/x", "relative/x", "file:relative", "file:///%ff", "fil", "ä"] {
            assert_eq!(of_uri(uri), None, "{uri}");
        }
    }

    #[test]
    fn a_folder_with_a_percent_sign_is_found_encoded_or_not() {
        let root = tempfile::tempdir().unwrap();
        for name in ["run%20a", "{34f75fd6}", "%7B34f75fd6%7D", "a b", "%ff"] {
            let path = root.path().join(name);
            std::fs::create_dir(&path).unwrap();
            let text = path.to_str().unwrap();
            let encoded = text.replace('%', "%25").replace(' ', "%20").replace('{', "%7B");
            for given in [text, &encoded] {
                assert_eq!(of_uri(&format!("file://{given}")), Some(path.clone()), "{given}");
            }
            std::fs::remove_dir(&path).unwrap();
        }
    }

    #[test]
    fn a_path_is_taken_as_it_stands() {
        let root = std::env::current_dir().unwrap();
        let path = root.join("100%20 räder/resources/");
        assert_eq!(of_path(path.to_str().unwrap()), Some(path));
        for path in ["resources", "", "file:///srv/resources"] {
            assert_eq!(of_path(path), None, "{path}");
        }
    }
}
