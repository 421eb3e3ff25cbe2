//! What can be asked on the command line.

use clap::{Parser, Subcommand};

use crate::{evaluate, patch, simulate};

/// Wheel-rail contact: forces, patches and a running wheelset
///
/// Inside and in all options: SI units, angles in radians, x forward, y to the right, z down; forces are those on the
/// wheel. Millimetres only where a column or a figure says so.
#[derive(Debug, Parser)]
#[command(version, propagate_version = true, max_term_width = 110)]
pub struct Arguments {
    /// What to do
    #[command(subcommand)]
    pub command: Command,
}

/// The subcommands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Let a wheelset run over a lateral ramp, by way of the packaged FMU
    Simulate(Box<simulate::Arguments>),
    /// Evaluate the contact element for every row of a table
    Evaluate(evaluate::Arguments),
    /// Solve planar contact problems, one for every row of a table
    Patch(patch::Arguments),
}
