//! The bytes that fuzzing kept, on any compiler: what they do must hold (see `fuzz/subjects`).

#[path = "../fuzz/subjects/mod.rs"]
mod subjects;

use std::fs;
use std::path::Path;

#[test]
fn what_fuzzing_kept_is_still_good() {
    for (name, check) in subjects::ALL {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus").join(name);
        let mut files: Vec<_> = fs::read_dir(&folder)
            .unwrap_or_else(|e| panic!("{}: {e}", folder.display()))
            .map(|entry| entry.expect("a file").path())
            .collect();
        files.sort();
        assert!(!files.is_empty(), "{} is empty", folder.display());
        for file in files {
            // Seen where one of them fails.
            println!("{}", file.display());
            check(&fs::read(&file).expect("a file"));
        }
    }
}
