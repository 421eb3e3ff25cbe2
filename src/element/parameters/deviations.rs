//! Rails and wheels that are not even along the track: from parameters to deviations.

use std::f64::consts::TAU;
use std::path::PathBuf;

use super::uneven::{Corrugation, OutOfRound, WheelFlat};
use crate::element::parameters::Parameters;
use crate::error::ContactError;
use crate::geometry::uneven::waviness::{Flat, FlatShape, Harmonic, Waviness};
use crate::io::{Deviations, load_deviations};

/// The deviations of the wheel, if it has any.
///
/// # Errors
/// A file that cannot be used.
pub fn wheel_deviations(
    parameters: &Parameters,
    folders: &[PathBuf],
) -> Result<Waviness, ContactError> {
    let radius = parameters.wheel.nominal_radius;
    let mut waviness = Waviness::new(Some(TAU * radius));
    let OutOfRound { amplitude, order, phase, file } = &parameters.wheel.out_of_round;
    if *amplitude > 0.0 {
        let wavelength = TAU * radius / *order as f64;
        waviness.add_harmonic(Harmonic { amplitude: *amplitude, wavelength, phase: *phase });
    }
    if !file.is_empty() {
        let name = "wheel.out_of_round.file";
        waviness.set_table(&load_deviations(name, file, Deviations::Wheel { radius }, folders)?);
    }
    let WheelFlat { length, angle, depth, shape } = parameters.wheel.flat;
    if length > 0.0 {
        let chord = Flat::chord_depth(length, radius);
        let depth = match shape {
            FlatShape::Worn if depth > 0.0 => depth,
            FlatShape::Worn => 0.5 * chord,
            FlatShape::Fresh => chord,
        };
        waviness.add_flat(Flat { length, middle: angle * radius, depth, shape });
    }
    Ok(waviness)
}

/// The deviations of rail number `k`, if it has any.
///
/// # Errors
/// A file that cannot be used.
pub fn rail_deviations(
    parameters: &Parameters,
    k: usize,
    folders: &[PathBuf],
) -> Result<Waviness, ContactError> {
    let rail = &parameters.rails[k];
    let Corrugation { amplitude, wavelength, phase, file } = &rail.corrugation;
    // A roller comes again after a turn.
    let around = (rail.roller_radius > 0.0).then_some(TAU * rail.roller_radius);
    let mut waviness = Waviness::new(around);
    if *amplitude > 0.0 {
        let (amplitude, phase) = (*amplitude, *phase);
        // Checked to be a whole number of waves, but for the digits that are given.
        let closed = around.map(|around| around / (around / wavelength).round());
        let wavelength = closed.unwrap_or(*wavelength);
        waviness.add_harmonic(Harmonic { amplitude, wavelength, phase });
    }
    if !file.is_empty() {
        let name = format!("rail[{}].corrugation.file", k + 1);
        let body = match rail.roller_radius {
            radius if radius > 0.0 => Deviations::Roller { radius },
            _ => Deviations::Rail,
        };
        waviness.set_table(&load_deviations(&name, file, body, folders)?);
    }
    Ok(waviness)
}
