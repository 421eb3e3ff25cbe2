//! Options of `wheelrail simulate`.

use std::path::PathBuf;

use anyhow::{Result, bail};
use clap::Args;

use super::fmu_wheel::is_driven;
use crate::options::{ContactOptions, Pair, assignment, check_positive};
use crate::wheelset::options::WheelsetOptions;
use crate::wheelset::track::{RampShape, Track};

/// Let a wheelset run over a lateral ramp, by way of the packaged FMU
///
/// One instance of WheelRail.fmu stands for each wheel, loaded as any importer would load it. The
/// wheelset is a rigid body (y, z, roll, yaw, pitch; its speed along the track is held) on linear
/// primary springs and dampers against a frame that runs straight ahead on the track's centre line.
/// It starts rolling freely in the middle of the track and meets a lateral ramp of both rails, or
/// with --rail what lies in the right rail: a crossing, a switch, a dip. Left in the output folder:
/// history.csv, motion.svg, patches.svg, with --rail along_rail.svg too.
#[derive(Args, Debug)]
#[command(verbatim_doc_comment, allow_negative_numbers = true)]
pub struct Arguments {
    /// The unit to run; without it WheelRail.fmu beside this program
    #[arg(long, value_name = "FILE")]
    pub fmu: Option<PathBuf>,
    /// Folder for what is written
    #[arg(long, short, value_name = "FOLDER", default_value = "wheelrail-simulation")]
    pub output: PathBuf,

    /// Profiles and what else is set.
    #[command(flatten)]
    pub contact: ContactOptions,

    /// Speed along the track [m/s]
    #[arg(long, value_name = "M/S", default_value_t = 15.0, help_heading = "Run")]
    pub speed: f64,
    /// Distance run [m]
    #[arg(long, value_name = "M", default_value_t = 60.0, help_heading = "Run")]
    pub length: f64,
    /// Rail on the right alone, such as the slices or the table of sections of a crossing; the
    /// other one stays that of --rail-profile
    #[arg(long, value_name = "FILE", help_heading = "Run")]
    pub rail: Option<String>,
    /// Set a parameter of the right wheel alone, such as rail[1].placement or rail[2].profile; may
    /// be repeated
    #[arg(long = "rail-set", value_name = "NAME=VALUE", value_parser = assignment, requires = "rail", help_heading = "Run")]
    pub rail_settings: Vec<(String, String)>,
    /// Station at which the run starts [m]
    #[arg(long, value_name = "M", default_value_t = 0.0, help_heading = "Run")]
    pub station: f64,
    /// Lateral displacement of the track by the ramp, to the right; without it 0.005, with --rail 0
    /// [m]
    #[arg(long, value_name = "M", help_heading = "Run")]
    pub ramp: Option<f64>,
    /// Length of the ramp [m]
    #[arg(long, value_name = "M", default_value_t = 1.0, help_heading = "Run")]
    pub ramp_length: f64,
    /// Where the ramp begins [m]
    #[arg(long, value_name = "M", default_value_t = 5.0, help_heading = "Run")]
    pub ramp_start: f64,
    /// Shape of the ramp
    #[arg(long, value_name = "SHAPE", default_value = "linear", help_heading = "Run")]
    pub ramp_shape: RampShape,
    /// Fixed step [s]; without it a round one of at most half the limit of stability
    #[arg(long, value_name = "S", help_heading = "Run")]
    pub step: Option<f64>,
    /// Distance between two rows of history.csv [m]
    #[arg(long, value_name = "M", default_value_t = 0.02, help_heading = "Run")]
    pub record_every: f64,

    /// The wheelset and its suspension.
    #[command(flatten)]
    pub wheelset: WheelsetOptions,
}

impl Arguments {
    /// Refuses what cannot be run, by the option's name.
    pub fn check(&self) -> Result<()> {
        check_positive(&[
            ("speed", self.speed),
            ("length", self.length),
            ("ramp-length", self.ramp_length),
            ("record-every", self.record_every),
            ("step", self.step.unwrap_or(1.0)),
        ])?;
        self.wheelset.check()?;
        for (name, value) in
            [("ramp", self.ramp()), ("ramp-start", self.ramp_start), ("station", self.station)]
        {
            if !value.is_finite() {
                bail!("--{name} {value} is not admitted: it must be a finite number");
            }
        }
        let set = self.contact.settings.iter().map(|setting| ("set", setting));
        let right = self.rail_settings.iter().map(|setting| ("rail-set", setting));
        if let Some((option, (name, _))) = set.chain(right).find(|(_, (name, _))| is_driven(name)) {
            bail!("--{option} {name}: the run itself sets it, for each wheel and at every step");
        }
        Ok(())
    }

    /// Lateral displacement by the ramp [m].
    pub fn ramp(&self) -> f64 {
        self.ramp.unwrap_or(if self.rail.is_some() { 0.0 } else { 0.005 })
    }

    /// Names and values of what is set for the right wheel alone, in order.
    pub fn right_settings(&self) -> Vec<(String, String)> {
        let profile = self.rail.iter().map(|rail| ("rail[1].profile".to_owned(), rail.clone()));
        profile.chain(self.rail_settings.iter().cloned()).collect()
    }

    /// The pairs that touch, of which the left one is this, for titles.
    pub fn profiles(&self, left: &Pair) -> String {
        let right = self.rail.as_ref().map_or_else(String::new, |rail| format!(", right {rail}"));
        left.to_string() + &right
    }

    /// The track.
    pub fn track(&self) -> Track {
        Track {
            ramp_start: self.ramp_start,
            ramp_length: self.ramp_length,
            ramp: self.ramp(),
            shape: self.ramp_shape,
        }
    }
}
