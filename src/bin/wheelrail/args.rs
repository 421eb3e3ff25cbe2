//! What can be asked on the command line.

use clap::{Parser, Subcommand};

use crate::{evaluate, patch, simulate};

/// Wheel-rail contact: forces, patches and a running wheelset
///
/// Inside and in all options: SI units, angles in radians, x forward, y to the right, z down; forces are those on the
/// wheel. Millimetres only where a column or a figure says so.
#[derive(Debug, Parser)]
#[command(version, propagate_version = true, verbatim_doc_comment)]
pub struct Arguments {
    /// What to do
    #[command(subcommand)]
    pub command: Command,
}

/// The subcommands; their help stands with their arguments.
#[derive(Debug, Subcommand)]
pub enum Command {
    Simulate(Box<simulate::Arguments>),
    Evaluate(evaluate::Arguments),
    Patch(patch::Arguments),
}
