//! What `documentation/index.html` says of the user's unit.

use std::fmt::Write;

use quick_xml::escape::escape;

/// Where the user's part begins and ends, so that another one can take its place.
const MARKS: [&str; 2] = ["<!-- packed -->", "<!-- end of packed -->"];

/// What is told.
pub struct About<'a, F> {
    /// Name of the model.
    pub name: &'a str,
    /// Its description; may be empty.
    pub description: &'a str,
    /// The start file.
    pub starts: &'a str,
    /// Files that the user has brought.
    pub files: F,
    /// Whether there is a figure.
    pub has_figure: bool,
}

/// The page with the user's part at its beginning.
pub fn with<'f, F: Iterator<Item = (&'f str, &'f [u8])> + Clone>(
    page: &str,
    about: &About<'_, F>,
) -> String {
    let mut part = format!("{}\n<h1>{}</h1>\n", MARKS[0], escape(about.name));
    // A String takes everything.
    let _ = writeln!(part, "<p>{}</p>", escape(about.description));
    if about.has_figure {
        part += "<p><img src=\"contact.svg\" alt=\"Profiles, pressure and tractions of the contact at the start values, by the models of this unit and by boundary elements\"></p>\n";
    }
    part += "<table>\n<tr><th>start value</th><th></th></tr>\n";
    for line in about.starts.lines().filter(|line| !line.starts_with('#')) {
        let (name, value) = line.split_once(" = ").unwrap_or((line, ""));
        let cells = format!("<code>{}</code></td><td><code>{}</code>", escape(name), escape(value));
        let _ = writeln!(part, "<tr><td>{cells}</td></tr>");
    }
    part += "</table>\n<p>All others are those of the table of variables. Files in <code>resources/profiles</code>:</p>\n<ul>\n";
    for (name, bytes) in about.files.clone() {
        let sum = crc32fast::hash(bytes);
        let about = format!("{} bytes, CRC-32 {sum:08x}", bytes.len());
        let _ = writeln!(part, "<li><code>{}</code>, {about}</li>", escape(name));
    }
    part += "</ul>\n";
    part += MARKS[1];
    let old = page.find(MARKS[0]).zip(page.find(MARKS[1]));
    if let Some((from, to)) = old {
        return format!("{}{part}{}", &page[..from], &page[to + MARKS[1].len()..]);
    }
    match page.split_once("<body>") {
        Some((head, body)) => format!("{head}<body>\n{part}{body}"),
        None => format!("<!DOCTYPE html>\n<html>\n<body>\n{part}\n</body>\n</html>\n"),
    }
}
