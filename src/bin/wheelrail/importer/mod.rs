//! A small FMI 2.0 co-simulation importer: enough to run the packaged element as any host would.
//!
//! An archive is unpacked into a temporary folder, its description read, its library loaded; from
//! then on only the C interface of the standard is used.

mod archive;
mod description;
mod functions;
mod instance;
mod logger;

pub use archive::Fmu;
pub use instance::{Instance, references};
