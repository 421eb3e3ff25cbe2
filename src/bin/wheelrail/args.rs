//! What can be asked on the command line.

use anyhow::Result;
use clap::{Parser, Subcommand};

/// Wheel-rail contact: forces, patches and a running wheelset
///
/// Inside and in all options: SI units, angles in radians, x forward, y to the right, z down;
/// forces are those on the wheel. Millimetres only where a column or a figure says so.
#[derive(Debug, Parser)]
#[command(version, propagate_version = true, verbatim_doc_comment)]
pub struct Arguments {
    /// What to do
    #[command(subcommand)]
    pub command: Command,
}

/// The subcommands, each with its module, whose `Arguments` its `run` takes.
macro_rules! commands {
    ($($name:ident: $module:ident,)*) => {
        /// The subcommands; their help stands with their arguments.
        #[derive(Debug, Subcommand)]
        pub enum Command {
            $($name(Box<crate::$module::Arguments>),)*
        }

        impl Command {
            /// Does what was asked.
            pub fn run(&self) -> Result<()> {
                match self { $(Self::$name(arguments) => crate::$module::run(arguments),)* }
            }
        }
    };
}

commands! {
    Simulate: simulate,
    Evaluate: evaluate,
    Patch: patch,
    Conicity: conicity,
    Linearize: linearize,
    Compare: compare,
    Plot: plot,
    Stress: stress,
    Fatigue: fatigue,
    Transient: transient,
    Sweep: sweep,
    Fit: fit,
    Pack: pack,
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;

    #[test]
    fn the_declaration_of_all_options_is_sound() {
        Arguments::command().debug_assert();
    }

    #[test]
    fn lists_and_assignments_are_read_and_refused() {
        let parse = |options: &[&str]| {
            Arguments::try_parse_from(["wheelrail", "simulate"].iter().chain(options))
        };
        let parsed =
            parse(&["--stiffness", "1,2e3,3", "--set", "friction.coefficient = 0.4"]).unwrap();
        let Command::Simulate(simulate) = parsed.command else { panic!("not simulate") };
        assert_eq!(simulate.wheelset.stiffness.map(|value| value as i32), [1, 2000, 3]);
        assert_eq!(simulate.contact.settings, [("friction.coefficient".into(), "0.4".into())]);
        assert!(simulate.check().is_ok());
        for wrong in [["--stiffness", "1,2"], ["--damping", "a,b,c"], ["--set", "friction"]] {
            let message = parse(&wrong).unwrap_err().to_string();
            assert!(message.contains("write "), "{message}");
        }
    }
}
