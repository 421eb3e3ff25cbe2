//! Planar contact problems, stub.
use crate::element::parameters::{Flexibilities, NormalModel, TangentialModel, TractionBound};
use crate::error::ContactError;
use crate::material::Material;

/// How deep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Indentation {
    /// Approach [m].
    Approach(f64),
    /// Load [N].
    Load(f64),
}

/// A case.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct PlanarCase<'a> {
    pub separation: &'a [[f64; 2]],
    pub radius: f64,
    pub indentation: Indentation,
    pub creepage: [f64; 3],
    pub friction: f64,
    pub wheel_material: Material,
    pub rail_material: Material,
    pub normal_model: NormalModel,
    pub virtual_penetration: f64,
    pub tangential_model: TangentialModel,
    pub strips: usize,
    pub elements_along: usize,
    pub bound: TractionBound,
    pub flexibilities: Flexibilities,
}

/// A result.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[allow(missing_docs)]
pub struct PlanarResult {
    pub normal_force: f64,
    pub max_pressure: f64,
    pub area: f64,
    pub length: f64,
    pub width: f64,
    pub fx: f64,
    pub fy: f64,
    pub mz: f64,
    pub patches: usize,
    pub fallback: bool,
}

/// Solves.
///
/// # Errors
/// Never.
pub fn solve(_case: &PlanarCase) -> Result<PlanarResult, ContactError> {
    Ok(PlanarResult::default())
}
