//! What is fixed about wear over a run.

use super::laws::{LawCoefficients, WearModel};
use crate::defaults::with_defaults;
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

with_defaults! {
    /// Everything about wear that is fixed; one field for each FMU parameter.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct WearParameters {
        /// Wear law, the same for wheel and rail.
        pub model: WearModel = WearModel::Off,
        /// How the wear of a patch is spread across it.
        pub distribution: WearDistribution = WearDistribution::Interpenetration,
        /// Every worn volume is multiplied by it, ≥ 0 [-].
        pub acceleration_factor: f64 = 1.0,
        /// Time after which the sums become new profiles, > 0 [s].
        pub update_interval: f64 = 0.01,
        /// Wavelength along the profile of which the smoothing of the wear depth keeps half the
        /// amplitude, 0 to 0.02 [m]; 0 for none.
        pub smoothing: f64 = 2e-3,
        /// Running distance of the wheel over which the volume worn off a rail is spread, > 0 [m].
        pub rail_distance: f64 = 1e3,
        /// Coefficients of the law for the wheel.
        pub wheel: LawCoefficients = LawCoefficients::default(),
        /// Coefficients of the law for the rails.
        pub rail: LawCoefficients = LawCoefficients::default(),
    }
}

impl WearParameters {
    /// Whether the second of two limits is not below the first; their ranges are those declared.
    ///
    /// # Errors
    /// The first parameter at fault, by its FMU name.
    pub(crate) fn check(&self) -> Result<(), ContactError> {
        for (body, law) in [("wheel", &self.wheel), ("rail", &self.rail)] {
            for (name, [first, second]) in [
                ("usfd.limit[2]", law.usfd.limits),
                ("british_rail.limit[2]", law.british_rail.limits),
                ("archard.speed[2]", law.archard.speeds),
            ] {
                if second < first {
                    let name = format!("wear.{body}.{name}");
                    let allowed = "a finite number, not below the first one";
                    return Err(ContactError::bad_value(name, second, allowed));
                }
            }
        }
        Ok(())
    }
}
