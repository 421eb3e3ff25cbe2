//! Whether parameters are in their ranges and go with each other, and the models with the bodies.

use std::f64::consts::TAU;

use super::ranges;
use super::uneven::{Corrugation, OutOfRound, WheelFlat};
use crate::element::parameters::{
    FlatShape, FoundationModel, FrictionDistribution, NormalModel, Parameters, TangentialHistory,
    TangentialModel, VerticalMode, WearModel,
};
use crate::error::ContactError;
use crate::geometry::sections::slices::Slices;
use crate::material::MaterialPair;

/// Steepest waves that are admitted [-].
const MAX_SLOPE: f64 = 0.3;
/// Least radius of a roller [m]: that of models of rigs in a fifth of the size.
const MIN_ROLLER: f64 = 0.1;
/// Share of a wave that may be missing or left over around a roller: what rounding the wavelength
/// to five digits leaves of a hundred waves [-].
const MAX_GAP: f64 = 0.01;

impl Parameters {
    /// Whether every number is in its declared range, and goes with the others.
    ///
    /// # Errors
    /// The first parameter at fault, by its FMU name.
    pub fn check(&self) -> Result<(), ContactError> {
        ranges::check(self)?;
        self.check_deviations()?;
        self.check_friction()?;
        self.check_foundation()?;
        self.check_rollers()?;
        self.check_wear()?;
        self.check_history()
    }

    /// Whether models and bodies go with contact with memory.
    fn check_history(&self) -> Result<(), ContactError> {
        if self.tangential_history == TangentialHistory::Steady {
            return Ok(());
        }
        let [wheel, rail] = self.materials();
        let laws = [&self.friction_law, &self.gauge_face_law];
        let why = if self.tangential_model != TangentialModel::BoundaryElement {
            "with tangential.model boundary_element"
        } else if self.normal_model != NormalModel::BoundaryElement {
            "with normal.model boundary_element"
        } else if self.foundation.model != FoundationModel::Rigid {
            "with track.foundation.model rigid"
        } else if self.wear.model != WearModel::Off {
            "with wear.model off"
        } else if laws.iter().any(|law| law.is_on()) {
            "with friction that does not fall with slip and bodies that are not softened: \
             friction.falling and friction.reduction, those of the gauge face too, at 1"
        } else if self.flash_temperature.is_on() {
            "with friction that does not fall with heat: friction.temperature.share at 1"
        } else if MaterialPair::new(wheel, rail).is_unlike() {
            "with wheel and rail of like materials, |K| of 0.002 at most"
        } else {
            return Ok(());
        };
        Err(ContactError::BadText {
            name: "tangential.history".into(),
            value: "transient".into(),
            allowed: format!("{why}; else steady"),
        })
    }

    /// Whether rails that move are under a wheel that moves.
    fn check_foundation(&self) -> Result<(), ContactError> {
        let is_moving = self.foundation.model == FoundationModel::Mass;
        if is_moving && self.vertical_mode == VerticalMode::Load {
            return Err(ContactError::BadText {
                name: "track.foundation.model".into(),
                value: "mass".into(),
                allowed: "with vertical.mode load rigid or massless: a given load is that of a wheel at rest on its rails".into(),
            });
        }
        Ok(())
    }

    /// Whether there is a table of friction where one is asked for, and none that nobody looks at.
    fn check_friction(&self) -> Result<(), ContactError> {
        let file = &self.friction_profile;
        let asked = self.friction_distribution == FrictionDistribution::Profile;
        let allowed = match (asked, file.is_empty()) {
            (true, true) => "the name of a file, as friction.distribution is profile",
            (false, false) => "empty, or set friction.distribution to profile",
            _ => return Ok(()),
        };
        let (name, value, allowed) = ("friction.profile".into(), file.clone(), allowed.into());
        Err(ContactError::BadText { name, value, allowed })
    }

    /// Whether rollers are large enough for a wheel to stand on, and waves close around them.
    fn check_rollers(&self) -> Result<(), ContactError> {
        for (k, rail) in self.rails.iter().enumerate() {
            let radius = rail.roller_radius;
            if radius != 0.0 && radius < MIN_ROLLER {
                let name = format!("rail[{}].roller_radius", k + 1);
                return Err(ContactError::bad_value(
                    name,
                    radius,
                    "0 for a straight rail, or from 0.1 m on",
                ));
            }
            let Corrugation { amplitude, wavelength, .. } = rail.corrugation;
            let waves = TAU * radius / wavelength;
            let whole = waves.round().max(1.0);
            if radius != 0.0 && amplitude > 0.0 && (waves - whole).abs() > MAX_GAP {
                let closed = TAU * radius / whole;
                return Err(ContactError::BadText {
                    name: format!("rail[{}].corrugation.wavelength", k + 1),
                    value: wavelength.to_string(),
                    allowed: format!(
                        "such that a whole number of waves goes around the roller: {whole} of them are {closed:.9} m long"
                    ),
                });
            }
        }
        Ok(())
    }

    /// Whether wear is admitted, and together with the models.
    fn check_wear(&self) -> Result<(), ContactError> {
        self.wear.check()?;
        let refused = |allowed: &str| {
            let value = self.wear.model.name().into();
            let (name, allowed) = ("wear.model".into(), allowed.into());
            Err(ContactError::BadText { name, value, allowed })
        };
        match self.wear.model {
            WearModel::Off => Ok(()),
            _ if self.is_uneven() => refused(
                "corrugated rails, out-of-round wheels and flats go with off: what wears is a profile that is even along the track",
            ),
            WearModel::Archard if self.tangential_model == TangentialModel::Linear => {
                refused("with tangential.model linear nothing slides")
            }
            _ => Ok(()),
        }
    }

    /// Whether deviations along the track go with each other and with the models.
    fn check_deviations(&self) -> Result<(), ContactError> {
        let require = |name: String, value: f64, fits: bool, allowed: &'static str| {
            if fits { Ok(()) } else { Err(ContactError::bad_value(name, value, allowed)) }
        };
        let steep = "such that waves are no steeper than 0.3";
        let radius = self.wheel.nominal_radius;
        for (k, rail) in self.rails.iter().enumerate() {
            let Corrugation { amplitude, wavelength, .. } = rail.corrugation;
            let slope = TAU * amplitude / wavelength;
            let name = format!("rail[{}].corrugation.wavelength", k + 1);
            require(name, wavelength, slope <= MAX_SLOPE, steep)?;
        }
        let OutOfRound { amplitude, order, .. } = self.wheel.out_of_round;
        let slope = amplitude * order as f64 / radius;
        let name = "wheel.out_of_round.amplitude".into();
        require(name, amplitude, slope <= MAX_SLOPE, steep)?;
        let WheelFlat { length, depth, shape, .. } = self.wheel.flat;
        let name = |part: &str| format!("wheel.flat.{part}");
        // What is shorter than a micrometre is rounding of the radius.
        let fits = length == 0.0 || (1e-6..=0.5 * radius).contains(&length);
        require(name("length"), length, fits, "0, or from 1e-6 m to half the nominal radius")?;
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

    /// Whether the models go with rail number `k`, should that be a roller or its section vary as
    /// `slices` say.
    pub(in crate::element) fn check_variation(
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
        if self.wear.model != WearModel::Off {
            return refuse(
                "as wear.model is not off: what wears is a profile that is the same all along a straight rail",
            );
        }
        if self.friction_distribution == FrictionDistribution::Profile {
            return refuse("where friction.distribution is profile");
        }
        if self.tangential_history != TangentialHistory::Steady {
            return refuse("as tangential.history is not steady");
        }
        Ok(())
    }

    /// Whether the models go with a wheel whose section varies around as `slices` say.
    pub(in crate::element) fn check_around(&self, slices: &Slices) -> Result<(), ContactError> {
        let refuse = |why: &str| {
            let (name, value) = ("wheel.profile".to_owned(), slices.name.clone());
            let allowed = format!("one profile for all the circle {why}");
            Err(ContactError::BadText { name, value, allowed })
        };
        if self.wheel_is_uneven() {
            return refuse("where there is wheel.flat or wheel.out_of_round");
        }
        if self.friction_distribution == FrictionDistribution::Profile
            && (0..self.rails.len()).any(|k| self.is_corrugated(k))
        {
            return refuse(
                "where there is rail[k].corrugation and friction.distribution is profile",
            );
        }
        if self.wear.model != WearModel::Off {
            return refuse("as wear.model is not off: what wears is one profile");
        }
        if self.tangential_history != TangentialHistory::Steady {
            return refuse("as tangential.history is not steady");
        }
        Ok(())
    }
}
