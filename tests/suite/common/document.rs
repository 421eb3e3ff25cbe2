//! Documents with tables that tests write.

use std::path::{Path, PathBuf};

/// A file of the crate.
pub fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

/// Whether the document `name` has each of the tables between its marks. With the variable
/// `UPDATE_DOCS` they are written.
pub fn assert_holds(name: &str, tables: &[([&str; 2], String)]) {
    let old = std::fs::read_to_string(path(name)).unwrap();
    let mut text = old.clone();
    for (marks, table) in tables {
        let start = text.find(marks[0]).expect("a line that starts the table") + marks[0].len();
        let end = text.find(marks[1]).expect("a line that ends the table");
        text.replace_range(start..end, table);
    }
    if text == old {
        return;
    }
    if std::env::var_os("UPDATE_DOCS").is_some() {
        std::fs::write(path(name), text).unwrap();
        return;
    }
    panic!("{name} is stale: run UPDATE_DOCS=1 cargo test --test suite docs::");
}

/// Whether the file `name` is `text`. With the variable `UPDATE_DOCS` it is written.
pub fn assert_is(name: &str, text: &str) {
    if std::fs::read_to_string(path(name)).is_ok_and(|old| old == text) {
        return;
    }
    if std::env::var_os("UPDATE_DOCS").is_some() {
        std::fs::write(path(name), text).unwrap();
        return;
    }
    panic!("{name} is stale: run UPDATE_DOCS=1 cargo test --test suite docs::");
}
