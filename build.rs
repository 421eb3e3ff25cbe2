//! Makes from `modelDescription/variables.toml` the variable table of the library, and in release
//! builds with the feature `package` the archive `WheelRail.fmu` beside the binaries.

use std::path::PathBuf;
use std::{env, fs};

#[path = "build/code.rs"]
mod code;
#[path = "build/declaration.rs"]
mod declaration;
#[cfg(feature = "package")]
#[path = "build/package.rs"]
mod package;
#[cfg(feature = "package")]
#[path = "build/platforms.rs"]
mod platforms;
#[cfg(feature = "package")]
#[path = "build/xml.rs"]
mod xml;

fn main() {
    println!("cargo::rerun-if-changed=modelDescription");
    let path = "modelDescription/variables.toml";
    let text = fs::read_to_string(path).unwrap_or_else(|e| panic!("{path}: {e}"));
    let declaration = declaration::Declaration::read(&text);
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo sets OUT_DIR"));
    fs::write(out.join("variables.rs"), code::generate(&declaration))
        .unwrap_or_else(|e| panic!("cannot write variables.rs to {}: {e}", out.display()));
    #[cfg(feature = "package")]
    if env::var("PROFILE").is_ok_and(|profile| profile == "release") {
        package::pack(&declaration);
    }
}
