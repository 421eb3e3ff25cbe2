//! Options of `wheelrail simulate`.

use std::path::PathBuf;

use anyhow::{Result, bail};
use clap::Args;

use super::fmu_wheel::is_driven;
use crate::args::ContactOptions;
use crate::wheelset::GRAVITY;
use crate::wheelset::body::Body;
use crate::wheelset::suspension::Suspension;
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

    /// Mass of the wheelset [kg]
    #[arg(long, value_name = "KG", default_value_t = 1500.0, help_heading = "Wheelset")]
    pub mass: f64,
    /// Moment of inertia about the roll and yaw axes [kg m²]
    #[arg(long, value_name = "KG_M2", default_value_t = 900.0, help_heading = "Wheelset")]
    pub inertia: f64,
    /// Moment of inertia about the axle [kg m²]
    #[arg(long, value_name = "KG_M2", default_value_t = 100.0, help_heading = "Wheelset")]
    pub axle_inertia: f64,
    /// Force of the wheelset on the track, its own weight included [N]
    #[arg(long, value_name = "N", default_value_t = 100e3, help_heading = "Wheelset")]
    pub axle_load: f64,
    /// Distance of the running circles [m]
    #[arg(long, value_name = "M", default_value_t = 1.5, help_heading = "Wheelset")]
    pub running_circles: f64,

    /// Distance of the axle boxes [m]
    #[arg(
        long,
        value_name = "M",
        default_value_t = 2.0,
        help_heading = "Primary suspension, one axle box"
    )]
    pub axle_boxes: f64,
    /// Stiffness along x, y and z [N/m]
    #[arg(
        long,
        value_name = "CX,CY,CZ",
        default_value = "1e6,5e5,1e6",
        value_parser = three,
        help_heading = "Primary suspension, one axle box"
    )]
    pub stiffness: [f64; 3],
    /// Damping along x, y and z [N s/m]
    #[arg(
        long,
        value_name = "DX,DY,DZ",
        default_value = "0,0,2e4",
        value_parser = three,
        help_heading = "Primary suspension, one axle box"
    )]
    pub damping: [f64; 3],
}

fn three(text: &str) -> Result<[f64; 3], String> {
    let numbers: Vec<f64> = text
        .split(',')
        .map(|part| part.trim().parse())
        .collect::<Result<_, _>>()
        .unwrap_or_default();
    numbers.try_into().map_err(|_| "write three numbers, for x, y and z: 1e6,5e5,1e6".into())
}

impl Arguments {
    /// Refuses what cannot be run, by the option's name.
    pub fn check(&self) -> Result<()> {
        let positive = [
            ("speed", self.speed),
            ("length", self.length),
            ("ramp-length", self.ramp_length),
            ("record-every", self.record_every),
            ("mass", self.mass),
            ("inertia", self.inertia),
            ("axle-inertia", self.axle_inertia),
            ("running-circles", self.running_circles),
            ("axle-boxes", self.axle_boxes),
            ("step", self.step.unwrap_or(1.0)),
        ];
        for (name, value) in positive {
            if !(value.is_finite() && value > 0.0) {
                bail!("--{name} {value} is not admitted: it must be a finite number above 0");
            }
        }
        let not_negative = [("stiffness", self.stiffness), ("damping", self.damping)];
        for (name, values) in not_negative {
            if let Some(value) = values.iter().find(|v| !(v.is_finite() && **v >= 0.0)) {
                bail!(
                    "--{name}: {value} is not admitted: it must be a finite number of at least 0"
                );
            }
        }
        for (name, value) in [("ramp", self.ramp), ("ramp-start", self.ramp_start)] {
            if !value.is_finite() {
                bail!("--{name} {value} is not admitted: it must be a finite number");
            }
        }
        if let Some((name, _)) = self.contact.settings.iter().find(|(name, _)| is_driven(name)) {
            bail!("--set {name}: the run itself sets it, for each wheel and at every step");
        }
        let weight = self.mass * GRAVITY;
        if !(self.axle_load.is_finite() && self.axle_load >= weight) {
            bail!(
                "--axle-load {} is not admitted: the wheelset alone weighs {weight:.0} N",
                self.axle_load
            );
        }
        Ok(())
    }

    /// The rigid body.
    pub fn body(&self) -> Body {
        Body {
            mass: self.mass,
            inertia: self.inertia,
            axle_inertia: self.axle_inertia,
            half_marker_distance: 0.5 * self.running_circles,
        }
    }

    /// The suspension, its resting height not yet known.
    pub fn suspension(&self) -> Suspension {
        Suspension {
            half_distance: 0.5 * self.axle_boxes,
            stiffness: self.stiffness,
            damping: self.damping,
            load: self.axle_load - self.mass * GRAVITY,
            resting_z: 0.0,
        }
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
