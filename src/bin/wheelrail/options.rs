//! Options that several commands share.

use std::fmt;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use clap::{Args, ValueEnum};
use wheelrail::element::Parameters;
use wheelrail::subsurface::Body;
use wheelrail::variables::{Causality, Values, find};

/// Where the commands on tables read and write; its help is shown with theirs.
#[derive(Args, Debug)]
pub struct TableFiles {
    /// Table of cases, CSV
    #[arg(value_name = "CASES.csv")]
    pub cases: PathBuf,
    /// File for the results, CSV; without it standard output
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// The body asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Of {
    Rail,
    Wheel,
}

impl Of {
    /// The same of stresses.
    pub fn body(self) -> Body {
        match self {
            Self::Rail => Body::Rail,
            Self::Wheel => Body::Wheel,
        }
    }
}

/// What touches what; its help is shown with that of the commands that run a wheelset.
#[derive(Args, Debug)]
pub struct ContactOptions {
    /// Profile of both wheels: built-in name or file; without it S1002, or what a unit was packed
    /// with
    #[arg(long, value_name = "PROFILE", help_heading = "Contact")]
    wheel_profile: Option<String>,
    /// Profile of both rails: built-in name or file; without it 60E1, or what a unit was packed with
    #[arg(long, value_name = "PROFILE", help_heading = "Contact")]
    rail_profile: Option<String>,
    /// Inclination of the rails: 0.025 is 1:40; without it 0.025, or what a unit was packed with
    #[arg(long, value_name = "TANGENT", help_heading = "Contact")]
    inclination: Option<f64>,
    /// Set any other parameter of both wheels (for simulate any input too), such as track.gauge;
    /// may be repeated
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = assignment, help_heading = "Contact")]
    pub settings: Vec<(String, String)>,
}

impl ContactOptions {
    /// Names and values of all variables that are set, in order.
    pub fn all_settings(&self) -> Vec<(String, String)> {
        let named = [
            ("wheel.profile", self.wheel_profile.clone()),
            ("rail[1].profile", self.rail_profile.clone()),
            ("rail[1].inclination", self.inclination.map(|inclination| inclination.to_string())),
        ];
        let named = named.into_iter().filter_map(|(name, value)| Some((name.into(), value?)));
        named.chain(self.settings.iter().cloned()).collect()
    }

    /// Parameters of both wheels as the options set them.
    pub fn shared_values(&self) -> Result<Values> {
        let mut values = Values::default();
        for (name, value) in self.all_settings() {
            let variable = find(&name).with_context(|| format!("--set {name}"))?;
            if variable.causality != Causality::Parameter || name == "side" {
                bail!("--set {name}: only parameters that both wheels share can be set");
            }
            values.set_from_text(variable, &value)?;
        }
        Ok(values)
    }
}

/// What touches what, for titles.
#[derive(Clone, Debug)]
pub struct Pair {
    pub wheel_profile: String,
    pub rail_profile: String,
    /// Tangent of the inclination of the rail [-].
    pub inclination: f64,
}

impl Pair {
    /// That of these parameters.
    pub fn of(parameters: &Parameters) -> Self {
        let rail = &parameters.rails[0];
        Self {
            wheel_profile: parameters.wheel.profile.clone(),
            rail_profile: rail.profile.clone(),
            inclination: rail.inclination,
        }
    }

    /// The files or built-in profiles.
    pub fn profiles(&self) -> [&Path; 2] {
        [&self.wheel_profile, &self.rail_profile].map(Path::new)
    }
}

impl fmt::Display for Pair {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} on {}", self.wheel_profile, self.rail_profile)
    }
}

/// Refuses options that are no finite numbers above 0.
pub fn check_positive(options: &[(&str, f64)]) -> Result<()> {
    match options.iter().find(|(_, value)| !(value.is_finite() && *value > 0.0)) {
        Some((name, value)) => {
            bail!("--{name} {value} is not admitted: it must be a finite number above 0")
        }
        None => Ok(()),
    }
}

/// Reads NAME=VALUE.
pub fn assignment(text: &str) -> std::result::Result<(String, String), String> {
    match text.split_once('=') {
        Some((name, value)) if !name.trim().is_empty() => {
            Ok((name.trim().into(), value.trim().into()))
        }
        _ => Err("write NAME=VALUE, such as friction.coefficient=0.4".into()),
    }
}
