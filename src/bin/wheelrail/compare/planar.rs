//! A planar case by its own models and by boundary elements.

use anyhow::Result;
use wheelrail::element::parameters::NormalModel;
use wheelrail::planar::PlanarCase;

use super::compared::{Compared, Solved};
use super::reference::{half, reference_tangential};
use crate::models::is_slow;
use crate::planar_cases::timed;

/// Both solutions of a planar case.
pub fn compare(case: &PlanarCase<'_>) -> Result<Compared> {
    let reference_case = PlanarCase {
        normal_model: NormalModel::BoundaryElement,
        tangential_model: reference_tangential(case.tangential_model),
        ..*case
    };
    let solve = |case: &PlanarCase<'_>, slow: bool| -> Result<Solved> {
        let (result, time) = timed(case, slow)?;
        Ok(Solved {
            normal_force: result.normal_force,
            max_pressure: result.max_pressure,
            area: result.area,
            creep_force: [result.fx, result.fy, 0.0],
            spin_moment: result.mz,
            patches: result.patches,
            fallback: result.fallback,
            time,
        })
    };
    let slow = is_slow(case.normal_model, case.tangential_model);
    let coarse_case = PlanarCase { elements: half(reference_case.elements), ..reference_case };
    Ok(Compared {
        own: solve(case, slow)?,
        reference: solve(&reference_case, true)?,
        coarse: solve(&coarse_case, true)?,
        turn: None,
        residuals: None,
        friction: case.friction,
    })
}
