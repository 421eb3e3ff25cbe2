//! One contact on the shakedown map, and the fatigue indices of its passage.

use super::dang_van::{DangVan, Equivalent};
use super::strength::Strength;
use crate::error::ContactError;
use crate::planar::{PlanarCase, solve};
use crate::subsurface::{Body, Measure, SurfaceLoad};
use crate::wear::rcf::surface_fatigue_index;

/// What a passage does to a material without residual stresses to begin with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Response {
    /// Nowhere does it yield.
    Elastic,
    /// It yields at first; residual stresses may keep it from that later on.
    Shakedown,
    /// It yields in every passage: it ratchets or flows to and fro.
    Plastic,
}

impl Response {
    /// Its name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Elastic => "elastic",
            Self::Shakedown => "shakedown",
            Self::Plastic => "plastic",
        }
    }
}

/// Fatigue of one body by the passage of one contact.
///
/// Both limits come from the stresses of this contact with its own tractions. First yield:
/// σ_vM = √3 k somewhere. Shakedown: below line contact the residual stresses of a passage have no
/// shear on planes parallel to the surface, so that the shear there must stay below k (Melan's
/// theorem; Johnson 1985, section 9.2: p0/k = 4 without friction, 1/f in full slip from f = 0.367 on).
/// For other contacts that is an estimate: residual shear σ_yz may help, and is left out. Circles
/// without friction have the known 4.7.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ContactFatigue {
    /// Greatest pressure p0 [Pa].
    pub max_pressure: f64,
    /// p0/k [-].
    pub load_factor: f64,
    /// Used friction f, creep force over normal force [-].
    pub used_friction: f64,
    /// p0/k at which the material yields first, were all stresses in proportion [-].
    pub elastic_limit: f64,
    /// p0/k up to which it shakes down [-].
    pub shakedown_limit: f64,
    /// Where p0/k lies between them.
    pub response: Response,
    /// Index of the surface, f - 2 A k/(3 N) [-]: above 0 the surface ratchets (Ekberg, Kabo and
    /// Andersson 2002).
    pub surface_index: f64,
    /// Index of what is below, N (1 + f²)/(4 A) + c σ_h,res [Pa]: their estimate of the equivalent
    /// stress of Dang Van below an ellipse.
    pub subsurface_index: f64,
    /// The greatest equivalent stress of Dang Van below the surface layer ([`DangVan::greatest`]).
    pub dang_van: Equivalent,
}

impl ContactFatigue {
    /// That of `body` by the contact of `case`, and the load it is computed from; nothing without
    /// contact.
    ///
    /// # Errors
    /// As [`solve`]; a strength that is not admitted; a tangential model that has creep forces but no
    /// tractions: linear theory and FaStrip.
    pub fn of(
        case: &PlanarCase,
        body: Body,
        strength: &Strength,
    ) -> Result<Option<(Self, SurfaceLoad)>, ContactError> {
        strength.check()?;
        if !case.tangential_model.has_tractions() {
            return Err(ContactError::BadText {
                name: "tangential.model".into(),
                value: format!("{:?}", case.tangential_model).to_lowercase(),
                allowed: "for stresses a model with tractions: marches, fastsim, \
                          fastsim_corrected, tables, boundary_element, or none without friction"
                    .into(),
            });
        }
        let load = SurfaceLoad::below(case, body)?;
        let result = solve(case)?;
        let force = [result.fx, result.fy, result.normal_force];
        Ok(Self::below(&load, force, result.area, strength)?.map(|own| (own, load)))
    }

    /// That of the body below `load`, whose force (along x, along y, normal) is `force` [N] and which
    /// lies on an `area` [m²]; nothing without load.
    ///
    /// # Errors
    /// A strength that is not admitted.
    pub fn below(
        load: &SurfaceLoad,
        [fx, fy, normal]: [f64; 3],
        area: f64,
        strength: &Strength,
    ) -> Result<Option<Self>, ContactError> {
        strength.check()?;
        let [yields, shears] =
            [Measure::VonMises, Measure::OrthogonalShear].map(|measure| load.greatest(measure));
        let dang_van = DangVan::new(load, strength).and_then(|own| own.greatest());
        let (Some(yields), Some(shears), Some(dang_van)) = (yields, shears, dang_van) else {
            return Ok(None);
        };
        let Strength { shear_yield, .. } = *strength;
        let max_pressure = load.max_pressure();
        let load_factor = max_pressure / shear_yield;
        let elastic_limit = 3f64.sqrt() * max_pressure / yields.value;
        let shakedown_limit = max_pressure / shears.value;
        let used_friction = (fx * fx + fy * fy).sqrt() / normal;
        Ok(Some(Self {
            max_pressure,
            load_factor,
            used_friction,
            elastic_limit,
            shakedown_limit,
            response: match load_factor {
                low if low <= elastic_limit => Response::Elastic,
                high if high > shakedown_limit => Response::Plastic,
                _ => Response::Shakedown,
            },
            surface_index: surface_fatigue_index(normal, [fx, fy], area, shear_yield),
            subsurface_index: normal * (1.0 + used_friction * used_friction) / (4.0 * area)
                + strength.dang_van * strength.residual,
            dang_van,
        }))
    }
}
