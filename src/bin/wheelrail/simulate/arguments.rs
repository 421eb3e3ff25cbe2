//! Options of `wheelrail simulate`.

use std::path::PathBuf;

use anyhow::{Result, bail};
use clap::Args;

use super::fmu_wheel::is_driven;
use crate::args::ContactOptions;
use crate::wheelset::options::WheelsetOptions;
use crate::wheelset::track::{RampShape, Track};

/// Let a wheelset run over a lateral ramp, by way of the packaged FMU
///
/// One instance of WheelRail.fmu stands for each wheel, loaded as any importer would load it. The wheelset is a
/// rigid body (y, z, roll, yaw, pitch; its speed along the track is held) on linear primary springs and dampers against a
/// frame that runs straight ahead on the track's centre line. It starts rolling freely in the middle of the track
/// and meets a lateral ramp of both rails. Left in the output folder: history.csv, motion.svg, patches.svg.
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
    /// Lateral displacement of the track by the ramp, to the right [m]
    #[arg(long, value_name = "M", default_value_t = 0.005, help_heading = "Run")]
    pub ramp: f64,
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
        let positive = [
            ("speed", self.speed),
            ("length", self.length),
            ("ramp-length", self.ramp_length),
            ("record-every", self.record_every),
            ("step", self.step.unwrap_or(1.0)),
        ];
        for (name, value) in positive {
            if !(value.is_finite() && value > 0.0) {
                bail!("--{name} {value} is not admitted: it must be a finite number above 0");
            }
        }
        self.wheelset.check()?;
        for (name, value) in [("ramp", self.ramp), ("ramp-start", self.ramp_start)] {
            if !value.is_finite() {
                bail!("--{name} {value} is not admitted: it must be a finite number");
            }
        }
        if let Some((name, _)) = self.contact.settings.iter().find(|(name, _)| is_driven(name)) {
            bail!("--set {name}: the run itself sets it, for each wheel and at every step");
        }
        Ok(())
    }

    /// The track.
    pub fn track(&self) -> Track {
        Track {
            ramp_start: self.ramp_start,
            ramp_length: self.ramp_length,
            ramp: self.ramp,
            shape: self.ramp_shape,
        }
    }
}
