//! Rails and wheels that are not even along the track: from parameters to deviations, and what they do to the place and the
//! direction of a patch.

use std::f64::consts::TAU;
use std::path::PathBuf;

use super::parameters::{FrictionDistribution, NormalModel, Parameters, WearModel};
use crate::error::ContactError;
use crate::geometry::line_separation::Lifting;
use crate::geometry::longitudinal::Longitudinal;
use crate::geometry::slices::Slices;
use crate::geometry::waviness::{Flat, FlatShape, Harmonic, Waviness};
use crate::io::{Deviations, load_deviations};
use crate::math::real::Real;
use crate::normal::{Strips, Zone};

/// Corrugation of a rail: its height over the station, a cosine and what a file holds on top.
#[derive(Clone, Debug, PartialEq)]
pub struct Corrugation {
    /// Half the height from trough to crest, 0 for none [m].
    pub amplitude: f64,
    /// Wavelength, > 0 [m].
    pub wavelength: f64,
    /// Phase at station 0, where a wave of phase 0 has a crest [rad].
    pub phase: f64,
    /// File with the columns `station_m` and `height_mm`, up positive; empty for none.
    pub file: String,
}

impl Default for Corrugation {
    fn default() -> Self {
        Self { amplitude: 0.0, wavelength: 0.033, phase: 0.0, file: String::new() }
    }
}

/// Deviation of a wheel from a circle: one harmonic of its radius, and what a file holds on top.
#[derive(Clone, Debug, PartialEq)]
pub struct OutOfRound {
    /// Half the difference from least to greatest radius, 0 for none [m].
    pub amplitude: f64,
    /// Number of waves around the wheel, ≥ 1.
    pub order: usize,
    /// Phase of the wave at the point that is lowest at pitch 0 [rad].
    pub phase: f64,
    /// File with the columns `angle_deg` and `radius_mm`, the deviation of the radius; empty for none.
    pub file: String,
}

impl Default for OutOfRound {
    fn default() -> Self {
        Self { amplitude: 0.0, order: 1, phase: 0.0, file: String::new() }
    }
}

/// A flat of a wheel.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WheelFlat {
    /// Length along the running circle, 0 for none [m].
    pub length: f64,
    /// Place of its middle: the angle by which the wheel has to roll forward from pitch 0 until it stands on it [rad].
    pub angle: f64,
    /// Greatest depth of a worn flat, 0 for L²/(16 R); that of a fresh one is L²/(8 R) [m].
    pub depth: f64,
    /// Fresh or worn.
    pub shape: FlatShape,
}

impl Parameters {
    /// Whether anything is uneven along the track.
    #[must_use]
    pub fn is_uneven(&self) -> bool {
        self.wheel_is_uneven() || (0..self.rails.len()).any(|k| self.is_corrugated(k))
    }

    /// Whether the wheel is not round.
    fn wheel_is_uneven(&self) -> bool {
        let OutOfRound { amplitude, file, .. } = &self.wheel.out_of_round;
        *amplitude != 0.0 || !file.is_empty() || self.wheel.flat.length != 0.0
    }

    /// Whether rail number `k` is there and has a height over the station.
    fn is_corrugated(&self, k: usize) -> bool {
        let Corrugation { amplitude, file, .. } = &self.rails[k].corrugation;
        self.rails[k].enabled && (*amplitude != 0.0 || !file.is_empty())
    }

    /// Whether deviations along the track are in their range and go with the models.
    pub(super) fn check_deviations(&self) -> Result<(), ContactError> {
        let require = |name: String, value: f64, fits: bool, allowed: &'static str| {
            if value.is_finite() && fits {
                Ok(())
            } else {
                Err(ContactError::bad_value(name, value, allowed))
            }
        };
        let steep = "such that waves are no steeper than 0.3";
        let radius = self.wheel.nominal_radius;
        let finite = "a finite number";
        for (k, rail) in self.rails.iter().enumerate() {
            let Corrugation { amplitude, wavelength, phase, .. } = rail.corrugation;
            let name = |part: &str| format!("rail[{}].corrugation.{part}", k + 1);
            require(name("amplitude"), amplitude, amplitude >= 0.0, "a finite number, at least 0")?;
            let positive = "a finite number greater than 0";
            require(name("wavelength"), wavelength, wavelength > 0.0, positive)?;
            let slope = TAU * amplitude / wavelength;
            require(name("wavelength"), wavelength, slope <= MOST_SLOPE, steep)?;
            require(name("phase"), phase, true, finite)?;
        }
        let OutOfRound { amplitude, order, phase, .. } = self.wheel.out_of_round;
        let name = |part: &str| format!("wheel.out_of_round.{part}");
        require(name("amplitude"), amplitude, amplitude >= 0.0, "a finite number, at least 0")?;
        require(name("order"), order as f64, (1..=200).contains(&order), "1 to 200")?;
        let slope = amplitude * order as f64 / radius;
        require(name("amplitude"), amplitude, slope <= MOST_SLOPE, steep)?;
        require(name("phase"), phase, true, finite)?;
        let WheelFlat { length, angle, depth, shape } = self.wheel.flat;
        let name = |part: &str| format!("wheel.flat.{part}");
        // What is shorter than a micrometre is rounding of the radius.
        let fits = length == 0.0 || (1e-6..=0.5 * radius).contains(&length);
        require(name("length"), length, fits, "0, or from 1e-6 m to half the nominal radius")?;
        require(name("angle"), angle, true, finite)?;
        let fits = (0.0..=0.05 * length.max(1e-9)).contains(&depth);
        require(name("depth"), depth, fits, "from 0 to a twentieth of its length, in m")?;
        let fits = shape == FlatShape::Worn || depth == 0.0;
        let chord = "0 for a fresh flat, which is as deep as a chord of its length";
        require(name("depth"), depth, fits, chord)?;
        if !self.is_uneven() {
            return Ok(());
        }
        let value = match self.normal_model {
            NormalModel::Hertz | NormalModel::PiotrowskiKik | NormalModel::Strips => return Ok(()),
            NormalModel::PiotrowskiKikCorrected => "piotrowski_kik_corrected",
            NormalModel::BoundaryElement => "boundary_element",
        };
        let why = "with wheel.flat, wheel.out_of_round or rail[k].corrugation";
        Err(ContactError::BadText {
            name: "normal.model".into(),
            value: value.into(),
            allowed: format!("{why} it has to be hertz, piotrowski_kik or strips"),
        })
    }
}

impl Parameters {
    /// Whether the models go with rail number `k`, should that be a roller or its section vary as `slices` say.
    pub(super) fn check_variation(
        &self,
        k: usize,
        slices: Option<&Slices>,
    ) -> Result<(), ContactError> {
        let radius = self.rails[k].roller_radius;
        let (part, value, even) = match slices {
            Some(slices) => ("profile", slices.name.clone(), "one profile for all the track"),
            None if radius != 0.0 => ("roller_radius", radius.to_string(), "0, a straight rail,"),
            None => return Ok(()),
        };
        let refuse = |why: &str| {
            let name = format!("rail[{}].{part}", k + 1);
            let (value, allowed) = (value.clone(), format!("{even} {why}"));
            Err(ContactError::BadText { name, value, allowed })
        };
        if slices.is_some() && radius != 0.0 {
            return refuse(
                "where there is rail[k].roller_radius: a roller has one profile all around",
            );
        }
        if self.wheel_is_uneven() {
            return refuse("where there is wheel.flat or wheel.out_of_round");
        }
        if radius != 0.0 && self.is_corrugated(k) {
            return refuse("where there is rail[k].corrugation");
        }
        if self.wear.model != WearModel::Off {
            return refuse(
                "as wear.model is not off: what wears is a profile that is the same all along a straight rail",
            );
        }
        if self.friction_distribution == FrictionDistribution::Profile {
            return refuse("where friction.distribution is profile");
        }
        Ok(())
    }

    /// Whether the models go with a wheel whose section varies around as `slices` say; `rail_varies` if the section of a rail varies too.
    pub(super) fn check_around(
        &self,
        slices: &Slices,
        rail_varies: bool,
    ) -> Result<(), ContactError> {
        let refuse = |why: &str| {
            let (name, value) = ("wheel.profile".to_owned(), slices.name.clone());
            let allowed = format!("one profile for all the circle {why}");
            Err(ContactError::BadText { name, value, allowed })
        };
        if rail_varies || self.rails.iter().any(|r| r.enabled && r.roller_radius != 0.0) {
            return refuse("on rails whose section varies and on rollers");
        }
        if self.is_uneven() {
            return refuse("where there is wheel.flat, wheel.out_of_round or rail[k].corrugation");
        }
        if self.wear.model != WearModel::Off {
            return refuse("as wear.model is not off: what wears is one profile");
        }
        if self.normal_model == NormalModel::BoundaryElement {
            return refuse(
                "where normal.model is boundary_element; sections around go with strips, hertz and piotrowski_kik",
            );
        }
        Ok(())
    }
}

/// Steepest waves that are admitted [-].
const MOST_SLOPE: f64 = 0.3;

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
    let Corrugation { amplitude, wavelength, phase, file } = &parameters.rails[k].corrugation;
    let mut waviness = Waviness::new(None);
    if *amplitude > 0.0 {
        let (amplitude, wavelength) = (*amplitude, *wavelength);
        waviness.add_harmonic(Harmonic { amplitude, wavelength, phase: *phase });
    }
    if !file.is_empty() {
        let name = format!("rail[{}].corrugation.file", k + 1);
        waviness.set_table(&load_deviations(&name, file, Deviations::Rail, folders)?);
    }
    Ok(waviness)
}

/// Where the surface of an uneven wheel lies in a zone, and how it leans.
#[derive(Clone, Copy, Debug)]
pub struct ZoneSurface<T = f64> {
    /// How much deeper along the normal than the even contact line the wheel is at the centroid of the load [m].
    pub depth: T,
    /// Deviation of the radius there [m].
    pub radius: T,
    /// Tangent of the angle by which the normal of the patch leans forward, against the track's x axis [-].
    pub lean: T,
    /// How far the centroid of the load is ahead of the contact line of a round wheel, where the rail varies along the track or the wheel around [m].
    pub ahead: T,
}

impl<T: Real> ZoneSurface<T> {
    /// That of an even wheel on an even rail.
    #[must_use]
    pub fn even() -> Self {
        let zero = T::from(0.0);
        Self { depth: zero, radius: zero, lean: zero, ahead: zero }
    }

    /// The surface of a wheel whose section varies around at the centroid of load of `zone`: its normals do not lean, and act where they are. `centre` as of [`new`](Self::new),
    /// of the round wheel in its place.
    #[must_use]
    pub fn beside_round(zone: &Zone<T>, strips: &Strips<T>, centre: impl Fn(T) -> T) -> Self {
        Self { ahead: ahead(zone, strips, centre), ..Self::even() }
    }

    /// The surface of a round wheel at the centroid of load of `zone` on a rail that meets it ahead of the contact line or behind: it leans as the
    /// circle of the `radius` does there, so that the normal force has no moment about the axle. `share` is the component of a unit of
    /// height along the normal, `centre` as of [`new`](Self::new).
    #[must_use]
    pub fn met(
        share: T,
        radius: T,
        zone: &Zone<T>,
        strips: &Strips<T>,
        centre: impl Fn(T) -> T,
    ) -> Self {
        let zero = T::from(0.0);
        let to = ahead(zone, strips, centre);
        let height = (radius * radius - to * to).at_least(0.0).sqrt();
        let lean = if height > 0.0 { share * to / height } else { zero };
        Self { depth: share * (height - radius), radius: zero, lean, ahead: to }
    }
}

impl ZoneSurface {
    /// The surface at the centroid of load of `zone`; `centre` is the place of the contact line to which the strip with a parameter
    /// belongs [m].
    ///
    /// The normal force follows the rail's surface where the rail alone could push along the track: on an even rail it has no part
    /// along x, and on a round wheel it has no moment about the axle. Both are exact for frictionless bodies. A round wheel
    /// on a corrugated rail leans as its own radius at the centroid does.
    #[must_use]
    pub fn new(
        lifting: &Lifting,
        zone: &Zone,
        strips: &Strips,
        centre: impl Fn(f64) -> f64,
    ) -> Self {
        let Lifting { deviations, radius, share } = *lifting;
        let to = ahead(zone, strips, centre);
        let [deviation, slope] = deviations.wheel_deviation(zone.x);
        let lean = if deviations.has_uneven_rail() { share * (to / radius - slope) } else { 0.0 };
        let depth = share * (deviation - 0.5 * to * to / radius);
        Self { depth, radius: deviation, lean, ahead: 0.0 }
    }
}

/// How far the load of `zone` is ahead of the contact line, of which `centre` is the place at the parameter of a strip [m].
fn ahead<T: Real>(zone: &Zone<T>, strips: &Strips<T>, centre: impl Fn(T) -> T) -> T {
    // Strips of a yawed wheel each have their own place on the line.
    let zero = T::from(0.0);
    let (mut ahead, mut load) = (zero, zero);
    for j in zone.first..zone.first + zone.count {
        let weight = strips.width[j] * strips.half_length[j] * strips.pressure[j];
        ahead += weight * (strips.x[j] - centre(strips.u[j]));
        load += weight;
    }
    if load > 0.0 { ahead / load } else { zero }
}

/// Speed at which surfaces with the given slopes of rail and wheel close because the wheel moves on and turns on over their
/// deviations: with the forward `velocity` [m/s] and the `pitch_rate` [rad/s] of a wheel of `nominal_radius` [m].
#[must_use]
pub fn closing_speed<T: Real>(
    lifting: &Lifting,
    [rail, wheel]: [f64; 2],
    velocity: T,
    pitch_rate: T,
    nominal_radius: f64,
) -> T {
    (velocity * rail - pitch_rate * wheel * nominal_radius) * lifting.share
}

/// Deviations of wheel and rail number `k` together, if there are any.
///
/// # Errors
/// A file that cannot be used.
pub fn deviations(
    parameters: &Parameters,
    k: usize,
    folders: &[PathBuf],
) -> Result<Option<Longitudinal>, ContactError> {
    let radius = parameters.wheel.nominal_radius;
    let wheel = wheel_deviations(parameters, folders)?;
    let rail = rail_deviations(parameters, k, folders)?;
    Ok(Longitudinal::new(wheel, rail, radius))
}
