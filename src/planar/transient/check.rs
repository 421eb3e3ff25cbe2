//! Which steps are admitted.

use super::history::History;
use super::step::StepMotion;
use crate::error::ContactError;
use crate::material::MaterialPair;
use crate::normal::NormalModel;
use crate::planar::PlanarCase;
use crate::tangential::TangentialModel;

/// Farthest that is rolled in a step [m].
const MAX_ROLLED: f64 = 1e6;

/// Whether a step is one that can be solved.
pub fn check(
    case: &PlanarCase,
    motion: &StepMotion,
    history: &History,
) -> Result<(), ContactError> {
    case.check()?;
    let text = |name: &str, value: String| {
        let allowed = "BoundaryElement in contact with memory".into();
        Err(ContactError::BadText { name: name.into(), value, allowed })
    };
    if case.normal_model != NormalModel::BoundaryElement {
        return text("normal_model", format!("{:?}", case.normal_model));
    }
    if case.tangential_model != TangentialModel::BoundaryElement {
        return text("tangential_model", format!("{:?}", case.tangential_model));
    }
    for (law, name) in [(&case.friction_law, ""), (&case.gauge_face_law, " of the gauge face")] {
        if !law.is_on() {
            continue;
        }
        let (number, value) = if law.falling_share < 1.0 {
            ("falling share", law.falling_share)
        } else if law.reduction < 1.0 {
            ("reduction", law.reduction)
        } else {
            ("reduction share", law.reduction_share)
        };
        let allowed = "1 in contact with memory: one coefficient on clean bodies";
        return Err(ContactError::bad_value(format!("{number}{name}"), value, allowed));
    }
    if case.flash_temperature.is_on() {
        let allowed = "1 in contact with memory: friction that does not fall";
        let share = case.flash_temperature.share;
        return Err(ContactError::bad_value("flash share", share, allowed));
    }
    let require = |name: &str, value: f64, fits: bool, allowed: &'static str| {
        if value.is_finite() && fits {
            Ok(())
        } else {
            Err(ContactError::bad_value(name, value, allowed))
        }
    };
    let rolled = motion.rolled;
    let fits = rolled.abs() <= MAX_ROLLED;
    require("rolled", rolled, fits, "a distance in metres, -1e6 to 1e6")?;
    for (name, value) in ["shift_x", "shift_y", "turn"].into_iter().zip(motion.shift) {
        require(name, value, value.abs() <= MAX_ROLLED, "a finite number, -1e6 to 1e6")?;
    }
    for (name, value) in FORCES.into_iter().zip(motion.force) {
        require(name, value.unwrap_or(0.0), true, "a finite number")?;
    }
    for ((body, own), before) in [("wheel", case.wheel_material), ("rail", case.rail_material)]
        .into_iter()
        .zip(history.materials.unwrap_or([case.wheel_material, case.rail_material]))
    {
        for (name, value, before) in [
            ("young_modulus", own.young_modulus, before.young_modulus),
            ("poisson_ratio", own.poisson_ratio, before.poisson_ratio),
        ] {
            let same = value.to_bits() == before.to_bits();
            require(&format!("{body} {name}"), value, same, "what it was in the first state")?;
        }
    }
    let material = MaterialPair::new(case.wheel_material, case.rail_material);
    let (coupling, are_like) = (material.coupling, !material.is_unlike());
    let allowed = "at most 0.002 either way in contact with memory: bodies of like materials";
    require("K of the materials", coupling, are_like, allowed)
}

/// Names of given forces.
pub const FORCES: [&str; 2] = ["force_longitudinal", "force_lateral"];

/// The first force that is given and not zero.
pub fn first_force(motion: &StepMotion) -> Option<(&'static str, f64)> {
    let forces = FORCES.into_iter().zip(motion.force);
    forces.filter_map(|(name, force)| Some((name, force?))).find(|(_, force)| force.abs() > 0.0)
}
