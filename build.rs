//! Makes from `modelDescription` the variable tables of the library, and with the feature `package` the archives
//! `WheelRail.fmu`, `WheelSet.fmu` and their kin: in release builds beside the binaries, in others without the
//! library in `OUT_DIR`, for the tests.

use std::path::PathBuf;
use std::{env, fs};

#[path = "build/code.rs"]
mod code;
#[path = "build/declaration.rs"]
mod declaration;
#[path = "build/header.rs"]
mod header;
#[cfg(feature = "package")]
#[path = "build/package.rs"]
mod package;
#[cfg(feature = "package")]
#[path = "build/platforms.rs"]
mod platforms;
#[cfg(feature = "package")]
#[path = "build/terminals.rs"]
mod terminals;
#[path = "build/wheelset.rs"]
mod wheelset;
#[cfg(feature = "package")]
#[path = "build/xml.rs"]
mod xml;
#[cfg(feature = "package")]
#[path = "build/xml3.rs"]
mod xml3;

fn main() {
    println!("cargo::rerun-if-changed=modelDescription");
    let read = |path: &str| fs::read_to_string(path).unwrap_or_else(|e| panic!("{path}: {e}"));
    let text = read("modelDescription/variables.toml");
    let file = declaration::File::read(&text);
    let wheel = declaration::Declaration::of_wheel(&file, &text);
    let wheelset = wheelset::derive(&file, &wheel, &read("modelDescription/wheelset.toml"));
    let targets = [
        code::Target { declaration: &wheel, unit: "WHEEL", table: "VARIABLES", subject: "Element" },
        code::Target {
            declaration: &wheelset,
            unit: "WHEELSET",
            table: "WHEELSET_VARIABLES",
            subject: "Wheelset",
        },
    ];
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo sets OUT_DIR"));
    for (name, text) in
        [("variables.rs", code::generate(&targets)), ("ranges.rs", code::ranges(&wheel))]
    {
        fs::write(out.join(name), text)
            .unwrap_or_else(|e| panic!("cannot write {name} to {}: {e}", out.display()));
    }
    // A header in C, where a build for programs that link the library asks for it.
    println!("cargo::rerun-if-env-changed=WHEELRAIL_HEADER");
    if let Some(path) = env::var_os("WHEELRAIL_HEADER").map(PathBuf::from) {
        fs::write(&path, header::generate(&[&wheel, &wheelset]))
            .unwrap_or_else(|e| panic!("WHEELRAIL_HEADER: cannot write {}: {e}", path.display()));
    }
    #[cfg(feature = "package")]
    package::pack(&[&wheel, &wheelset]);
}
