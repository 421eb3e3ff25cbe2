//! The command line of the wheel-rail contact element.

mod args;
mod batch;
mod cases;
mod compare;
mod conicity;
mod element_rows;
mod evaluate;
mod fatigue;
mod figures;
mod fit;
mod importer;
mod linearize;
mod models;
mod named_files;
mod options;
mod output;
mod pack;
mod patch;
mod planar_cases;
mod plot;
mod remarks;
mod simulate;
mod stress;
mod sweep;
mod transient;
mod wheelset;

use std::io::ErrorKind;
use std::process::ExitCode;

use clap::Parser;

use args::Arguments;

fn main() -> ExitCode {
    match Arguments::parse().command.run() {
        Ok(()) => ExitCode::SUCCESS,
        // Whoever read the output has had enough, as `head` does.
        Err(error) if is_broken_pipe(&error) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn is_broken_pipe(error: &anyhow::Error) -> bool {
    error.chain().any(|cause| {
        let io = cause.downcast_ref::<std::io::Error>();
        let csv = cause.downcast_ref::<csv::Error>().and_then(|error| match error.kind() {
            csv::ErrorKind::Io(error) => Some(error),
            _ => None,
        });
        io.or(csv).is_some_and(|error| error.kind() == ErrorKind::BrokenPipe)
    })
}
