//! Friction over the surface of a rail: between tread and gauge face, or by a table.

use std::path::PathBuf;

use super::rail_walk::RailPlace;
use crate::element::input::Input;
use crate::element::parameters::{FrictionDistribution, Parameters};
use crate::error::ContactError;
use crate::friction::{Across, FrictionProfile, FrictionTables, StripFriction, Table, direction};
use crate::geometry::curves::arc_length::ArcLength;
use crate::geometry::rail::placed_rail::PlacedRail;
use crate::io::load_friction;
use crate::math::real::Real;

/// Friction over the surface of one rail.
#[derive(Clone, Debug)]
pub struct RailFriction {
    /// The table, and what its argument across the rail is: the direction of the rail's tangent, or
    /// the parameter of its curve, growing from its gauge face. Without it both regions have the
    /// coefficients of the input.
    coefficient: Option<(Across, FrictionTables)>,
    /// Share of the gauge face over the direction of the rail's tangent, where the two regions are
    /// not alike.
    gauge_face_share: Option<Table>,
}

/// Where the tables were looked up last: strips lie beside each other. Without influence on what is
/// found.
#[derive(Clone, Copy, Debug, Default)]
pub struct LastPlace {
    coefficient: usize,
    share: usize,
}

impl RailFriction {
    /// That of rail number `k`, from 0, where `parameters` put it; nothing where friction is the
    /// same all over it. Files are looked for in `folders`.
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
        let coefficient = match parameters.friction_distribution {
            FrictionDistribution::Uniform => return Ok(None),
            FrictionDistribution::Regions => None,
            FrictionDistribution::Profile => {
                let mut profile = load_friction("friction.profile", name, k + 1, folders)?;
                if profile.across == Across::Place {
                    on_curve(&mut profile, rail);
                }
                Some((profile.across, profile.tables()))
            }
        };
        let is_divided =
            coefficient.is_none() || parameters.friction_law != parameters.gauge_face_law;
        let gauge_face_share =
            is_divided.then(|| parameters.friction_changeover.gauge_face_share());
        Ok(Some(Self { coefficient, gauge_face_share }))
    }

    /// Whether friction changes along the track.
    pub fn has_stations(&self) -> bool {
        self.coefficient.as_ref().is_some_and(|(_, tables)| tables.has_stations())
    }

    /// Whether the coefficients are those of tread and gauge face in the input.
    pub fn has_regions(&self) -> bool {
        self.coefficient.is_none()
    }

    /// Friction at a `place` of a rail of that `hand` and at `station` along the track [m]; `last`
    /// is where it was asked for last.
    #[inline(always)]
    pub fn at<T: Real>(
        &self,
        place: &RailPlace<T>,
        hand: f64,
        station: T,
        input: &Input<T>,
        last: &mut LastPlace,
    ) -> StripFriction<T> {
        let direction = direction([place.tangent[0], place.tangent[1] * hand]);
        let gauge_face_share = match &self.gauge_face_share {
            Some(share) => share.at(direction, &mut last.share),
            None => T::from(0.0),
        };
        let [tread, gauge_face] = match &self.coefficient {
            Some((across, tables)) => {
                let across = match across {
                    Across::Place => place.s * hand,
                    Across::Inclination => direction,
                };
                [tables.at(across, station, &mut last.coefficient); 2]
            }
            None => [input.tread_friction, input.gauge_face_friction],
        };
        StripFriction { tread, gauge_face, gauge_face_share }
    }
}

/// Last Newton step towards the highest point [m].
const NEAREST: f64 = 1e-12;

/// Puts the places of `profile`, arcs from the highest point of `rail`, on the parameter of its
/// curve.
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
