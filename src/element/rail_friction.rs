//! Friction over the surface of a rail: between tread and gauge face, or by a table.

use std::path::PathBuf;

use super::input::Input;
use super::parameters::{FrictionDistribution, Parameters};
use crate::error::ContactError;
use crate::friction::{Across, Changeover, FrictionProfile, StripFriction};
use crate::geometry::arc_length::ArcLength;
use crate::geometry::placed_rail::PlacedRail;
use crate::io::load_friction;
use crate::math::real::Real;

/// Friction over the surface of one rail.
#[derive(Clone, Debug)]
pub struct RailFriction {
    changeover: Changeover,
    /// Whether tread and gauge face have laws of their own.
    has_two_laws: bool,
    /// The table; a place across is the parameter of the rail's curve, growing from its gauge face. Without it both regions have the
    /// coefficients of the input.
    profile: Option<FrictionProfile>,
}

impl RailFriction {
    /// That of rail number `k`, from 0, where `parameters` put it; nothing where friction is the same all over it. Files are looked for in
    /// `folders`.
    ///
    /// # Errors
    /// A file that cannot be used.
    pub fn new(
        k: usize,
        rail: &PlacedRail,
        parameters: &Parameters,
        folders: &[PathBuf],
    ) -> Result<Option<Self>, ContactError> {
        let name = &parameters.friction_profile;
        let profile = match parameters.friction_distribution {
            FrictionDistribution::Uniform => return Ok(None),
            FrictionDistribution::Regions => None,
            FrictionDistribution::Profile => {
                let mut profile = load_friction("friction.profile", name, k + 1, folders)?;
                if profile.across == Across::Place {
                    on_curve(&mut profile, rail);
                }
                Some(profile)
            }
        };
        Ok(Some(Self {
            changeover: parameters.friction_changeover,
            has_two_laws: parameters.friction_law != parameters.gauge_face_law,
            profile,
        }))
    }

    /// Whether friction changes along the track.
    pub fn has_stations(&self) -> bool {
        self.profile.as_ref().is_some_and(FrictionProfile::has_stations)
    }

    /// Whether the coefficients are those of tread and gauge face in the input.
    pub fn has_regions(&self) -> bool {
        self.profile.is_none()
    }

    /// Friction of a strip at the parameter `s` of the curve of `rail` and at `station` along the track [m].
    pub fn at<T: Real>(
        &self,
        rail: &PlacedRail,
        s: T,
        station: T,
        input: &Input<T>,
    ) -> StripFriction<T> {
        let inclination = || {
            let [y, z] = rail.curve().at(s).first;
            (z * rail.hand()).atan2(y)
        };
        let Some(profile) = &self.profile else {
            return StripFriction {
                tread: input.tread_friction,
                gauge_face: input.gauge_face_friction,
                gauge_face_share: self.changeover.gauge_face_share(inclination()),
            };
        };
        match profile.across {
            Across::Place => {
                let own = StripFriction::of(profile.coefficient(s * rail.hand(), station));
                if self.has_two_laws { self.divided(own, inclination()) } else { own }
            }
            Across::Inclination => {
                let inclination = inclination();
                let own = StripFriction::of(profile.coefficient(inclination, station));
                self.divided(own, inclination)
            }
        }
    }

    fn divided<T: Real>(&self, own: StripFriction<T>, inclination: T) -> StripFriction<T> {
        StripFriction { gauge_face_share: self.changeover.gauge_face_share(inclination), ..own }
    }
}

/// Last Newton step towards the highest point [m].
const NEAREST: f64 = 1e-12;

/// Puts the places of `profile`, arcs from the highest point of `rail`, on the parameter of its curve.
fn on_curve(profile: &mut FrictionProfile, rail: &PlacedRail) {
    // The marker is the highest point.
    let top = rail.nearest([0.0; 2], rail.coarse_nearest([0.0; 2]), NEAREST).s;
    let arcs = ArcLength::new(rail.curve());
    let (curve, middle, length) = (rail.curve(), arcs.arc(top), arcs.length());
    for point in profile.sections.iter_mut().flat_map(|section| &mut section.points) {
        let arc = middle + rail.hand() * point[0];
        // Beyond the ends of the curve there is nothing to touch.
        let beyond = || if arc <= 0.0 { curve.start() + arc } else { curve.end() + arc - length };
        point[0] = rail.hand() * arcs.parameter(arc).unwrap_or_else(beyond);
    }
}
