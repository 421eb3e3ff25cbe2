//! What is fixed about wear over a run.

use super::laws::{LawCoefficients, WearModel};
use crate::error::ContactError;

/// How the wear of a patch is spread across it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum WearDistribution {
    /// In proportion to the interpenetration function less what is already worn.
    #[default]
    Interpenetration,
    /// Each strip wears where it lies: plain summing, which digs holes if the profiles are updated
    /// rarely.
    Strips,
}

/// Everything about wear that is fixed; one field for each FMU parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WearParameters {
    /// Wear law, the same for wheel and rail.
    pub model: WearModel,
    /// How the wear of a patch is spread across it.
    pub distribution: WearDistribution,
    /// Every worn volume is multiplied by it, ≥ 0 [-].
    pub acceleration_factor: f64,
    /// Time after which the sums become new profiles, > 0 [s].
    pub update_interval: f64,
    /// Wavelength along the profile of which the smoothing of the wear depth keeps half the
    /// amplitude, 0 to 0.02 [m]; 0 for none.
    pub smoothing: f64,
    /// Running distance of the wheel over which the volume worn off a rail is spread, > 0 [m].
    pub rail_distance: f64,
    /// Coefficients of the law for the wheel.
    pub wheel: LawCoefficients,
    /// Coefficients of the law for the rails.
    pub rail: LawCoefficients,
}

impl Default for WearParameters {
    fn default() -> Self {
        Self {
            model: WearModel::default(),
            distribution: WearDistribution::default(),
            acceleration_factor: 1.0,
            update_interval: 0.01,
            smoothing: 2e-3,
            rail_distance: 1e3,
            wheel: LawCoefficients::default(),
            rail: LawCoefficients::default(),
        }
    }
}

impl WearParameters {
    /// Whether every number is in its admitted range.
    ///
    /// # Errors
    /// The first parameter at fault, by its FMU name.
    pub fn check(&self) -> Result<(), ContactError> {
        let positive = "a finite number greater than 0";
        let not_negative = "a finite number, at least 0";
        for (name, value, allowed, fits) in [
            (
                "wear.acceleration_factor",
                self.acceleration_factor,
                not_negative,
                self.acceleration_factor >= 0.0,
            ),
            ("wear.update_interval", self.update_interval, positive, self.update_interval > 0.0),
            (
                "wear.smoothing",
                self.smoothing,
                "a wavelength from 0 (none) to 0.02 m",
                (0.0..=0.02).contains(&self.smoothing),
            ),
            ("wear.rail_distance", self.rail_distance, positive, self.rail_distance > 0.0),
        ] {
            if !(value.is_finite() && fits) {
                return Err(ContactError::bad_value(name, value, allowed));
            }
        }
        check_law("wheel", &self.wheel)?;
        check_law("rail", &self.rail)
    }
}

/// Whether the coefficients of one body are admitted.
fn check_law(body: &str, law: &LawCoefficients) -> Result<(), ContactError> {
    let LawCoefficients { frictional_work, usfd, british_rail, zobory, archard, .. } = law;
    let refused = |name: &str, value: f64, allowed| {
        Err(ContactError::bad_value(format!("wear.{body}.{name}"), value, allowed))
    };
    for (name, value) in [
        ("density", law.density),
        ("archard.hardness", archard.hardness),
        ("archard.pressure_share", archard.pressure_share),
    ] {
        if !(value.is_finite() && value > 0.0) {
            return refused(name, value, "a finite number greater than 0");
        }
    }
    for (name, value) in [
        ("frictional_work.coefficient", frictional_work.coefficient),
        ("usfd.mild", usfd.mild),
        ("usfd.severe", usfd.severe),
        ("usfd.catastrophic", usfd.catastrophic),
        ("usfd.limit[1]", usfd.limits[0]),
        ("british_rail.mild", british_rail.mild),
        ("british_rail.severe", british_rail.severe),
        ("british_rail.catastrophic", british_rail.catastrophic),
        ("british_rail.offset", british_rail.offset),
        ("british_rail.limit[1]", british_rail.limits[0]),
        ("zobory.mild", zobory.mild),
        ("zobory.severe", zobory.severe),
        ("zobory.limit", zobory.limit),
        ("archard.mild", archard.mild),
        ("archard.severe", archard.severe),
        ("archard.seizure", archard.seizure),
        ("archard.speed[1]", archard.speeds[0]),
    ] {
        if !(value.is_finite() && value >= 0.0) {
            return refused(name, value, "a finite number, at least 0");
        }
    }
    for (name, [first, second]) in [
        ("usfd.limit[2]", usfd.limits),
        ("british_rail.limit[2]", british_rail.limits),
        ("archard.speed[2]", archard.speeds),
    ] {
        if !(second.is_finite() && second >= first) {
            return refused(name, second, "a finite number, not below the first one");
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_refused_is_named() {
        let good = WearParameters::default();
        assert_eq!(good.check(), Ok(()));
        let mut bad = good;
        bad.update_interval = 0.0;
        assert!(bad.check().unwrap_err().to_string().starts_with("wear.update_interval = 0"));
        let mut bad = good;
        bad.rail.archard.hardness = f64::NAN;
        assert!(bad.check().unwrap_err().to_string().starts_with("wear.rail.archard.hardness"));
        let mut bad = good;
        bad.wheel.usfd.limits = [2.0, 1.0];
        assert!(bad.check().unwrap_err().to_string().starts_with("wear.wheel.usfd.limit[2] = 1"));
    }
}
