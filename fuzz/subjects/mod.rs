//! What is done with the bytes of a fuzzer, and what must hold then.
//!
//! Each `check` panics where something is wrong. The fuzz targets call them with new bytes,
//! `tests/suite/fuzz_corpus.rs` with those kept in `fuzz/corpus`, on a stable compiler.

#![allow(dead_code)] // each target uses its own part

pub mod case_table;
#[path = "../../src/bin/wheelrail/cases.rs"]
mod cases;
pub mod deviation_file;
pub mod element;
pub mod fmi_calls;
pub mod planar;
pub mod profile_file;
pub mod values;

/// The name of a corpus and what is done with its bytes.
pub type Subject = (&'static str, fn(&[u8]));

/// All of them.
pub const ALL: [Subject; 7] = [
    ("profile_file", profile_file::check),
    ("deviation_file", deviation_file::check),
    ("case_table", case_table::check),
    ("element", element::check),
    ("planar", planar::check),
    ("fmi_calls", fmi_calls::check),
    ("fmi_wheelset", fmi_calls::check_wheelset),
];
