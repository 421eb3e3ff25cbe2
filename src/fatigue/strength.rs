//! What the material of a body withstands.

use crate::error::ContactError;

/// Strength of a material against rolling contact fatigue. All numbers are the user's: they differ
/// by grade and by source.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Strength {
    /// Yield stress in shear k, > 0 [Pa]. Start value 300 MPa: ordinary pearlitic rail steel has 250
    /// to 350, hardened 400 to 500.
    pub shear_yield: f64,
    /// Weight of the hydrostatic stress in that of Dang Van, ≥ 0 [-]. Start value 1/3: sources have
    /// 0.3 to 0.4.
    pub dang_van: f64,
    /// Residual hydrostatic stress, tension positive [Pa]. Start value 0.
    pub residual: f64,
    /// Equivalent stress of Dang Van that is endured for ever, > 0 [Pa]; none: not known.
    pub endurance: Option<f64>,
}

impl Default for Strength {
    fn default() -> Self {
        Self { shear_yield: 3e8, dang_van: 1.0 / 3.0, residual: 0.0, endurance: None }
    }
}

impl Strength {
    /// Whether all numbers are admitted.
    ///
    /// # Errors
    /// The first one that is not.
    pub fn check(&self) -> Result<(), ContactError> {
        let positive = |value: f64| value.is_finite() && value > 0.0;
        let refuse = |name, value, allowed| Err(ContactError::bad_value(name, value, allowed));
        if !positive(self.shear_yield) {
            return refuse("shear_yield", self.shear_yield, "a stress in Pa, greater than 0");
        }
        if !(self.dang_van.is_finite() && self.dang_van >= 0.0) {
            return refuse("dang_van", self.dang_van, "a weight, 0 or greater");
        }
        if !self.residual.is_finite() {
            return refuse("residual", self.residual, "a stress in Pa");
        }
        match self.endurance {
            Some(stress) if !positive(stress) => {
                refuse("endurance", stress, "a stress in Pa, greater than 0")
            }
            _ => Ok(()),
        }
    }
}
