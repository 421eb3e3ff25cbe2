//! Options of the commands that run a wheelset.

use anyhow::{Result, bail};
use clap::Args;
use wheelrail::element::Inertia;

use super::GRAVITY;
use super::body::Body;
use super::suspension::Suspension;
use crate::options::check_positive;

/// The wheelset and its suspension; their help is shown with that of the commands.
#[derive(Args, Debug)]
pub struct WheelsetOptions {
    /// Mass of the wheelset [kg]
    #[arg(long, value_name = "KG", default_value_t = Inertia::default().mass, help_heading = "Wheelset")]
    pub mass: f64,
    /// Moment of inertia about the roll and yaw axes [kg m²]
    #[arg(long, value_name = "KG_M2", default_value_t = Inertia::default().transverse, help_heading = "Wheelset")]
    pub inertia: f64,
    /// Moment of inertia about the axle [kg m²]
    #[arg(long, value_name = "KG_M2", default_value_t = Inertia::default().axle, help_heading = "Wheelset")]
    pub axle_inertia: f64,
    /// Force of the wheelset on the track, its own weight included [N]
    #[arg(long, value_name = "N", default_value_t = 100e3, help_heading = "Wheelset")]
    pub axle_load: f64,
    /// Distance of the nominal rolling circles [m]
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

fn three(text: &str) -> std::result::Result<[f64; 3], String> {
    let numbers: Vec<f64> = text
        .split(',')
        .map(|part| part.trim().parse())
        .collect::<Result<_, _>>()
        .unwrap_or_default();
    numbers.try_into().map_err(|_| "write three numbers, for x, y and z: 1e6,5e5,1e6".into())
}

impl WheelsetOptions {
    /// Refuses what no wheelset has, by the option's name.
    pub fn check(&self) -> Result<()> {
        check_positive(&[
            ("mass", self.mass),
            ("inertia", self.inertia),
            ("axle-inertia", self.axle_inertia),
            ("running-circles", self.running_circles),
            ("axle-boxes", self.axle_boxes),
        ])?;
        let not_negative = [("stiffness", self.stiffness), ("damping", self.damping)];
        for (name, values) in not_negative {
            if let Some(value) = values.iter().find(|v| !(v.is_finite() && **v >= 0.0)) {
                bail!(
                    "--{name}: {value} is not admitted: it must be a finite number of at least 0"
                );
            }
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
}
