//! Friction over the surface of a rail: between tread and gauge face, or by a table.

use std::path::PathBuf;

use super::input::Input;
use super::parameters::{FrictionDistribution, Parameters};
use super::rail_walk::RailPlace;
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
    inclinations: Inclinations,
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
        let changeover = parameters.friction_changeover;
        let has_two_laws = parameters.friction_law != parameters.gauge_face_law;
        let is_divided = has_two_laws || profile.is_none();
        let inclinations = Inclinations::new(is_divided.then_some(&changeover), profile.as_ref());
        Ok(Some(Self { changeover, has_two_laws, profile, inclinations }))
    }

    /// Whether friction changes along the track.
    pub fn has_stations(&self) -> bool {
        self.profile.as_ref().is_some_and(FrictionProfile::has_stations)
    }

    /// Whether the coefficients are those of tread and gauge face in the input.
    pub fn has_regions(&self) -> bool {
        self.profile.is_none()
    }

    /// Friction at a `place` of a rail of that `hand` and at `station` along the track [m].
    #[inline]
    pub fn at<T: Real>(
        &self,
        place: &RailPlace<T>,
        hand: f64,
        station: T,
        input: &Input<T>,
    ) -> StripFriction<T> {
        let inclination = || self.inclinations.of(place.tangent, hand);
        let Some(profile) = &self.profile else {
            return StripFriction {
                tread: input.tread_friction,
                gauge_face: input.gauge_face_friction,
                gauge_face_share: self.changeover.gauge_face_share(inclination()),
            };
        };
        let inclination =
            (self.has_two_laws || profile.across == Across::Inclination).then(inclination);
        let across = match profile.across {
            Across::Place => place.s * hand,
            Across::Inclination => inclination.unwrap_or_default(),
        };
        let own = StripFriction::of(profile.coefficient(across, station));
        match inclination {
            Some(inclination) if self.has_two_laws => StripFriction {
                gauge_face_share: self.changeover.gauge_face_share(inclination),
                ..own
            },
            _ => own,
        }
    }
}

/// Inclinations between which friction changes.
#[derive(Clone, Copy, Debug)]
struct Inclinations {
    /// [rad]
    ends: [f64; 2],
    /// Their tangents, if both are less than a right angle.
    slopes: Option<[f64; 2]>,
}

/// Margin by which an inclination is beyond the ends [rad].
const BEYOND: f64 = 1e-9;

impl Inclinations {
    fn new(changeover: Option<&Changeover>, profile: Option<&FrictionProfile>) -> Self {
        let mut ends = [f64::INFINITY, f64::NEG_INFINITY];
        let mut widen = |inclination: f64| {
            ends = [ends[0].min(inclination - BEYOND), ends[1].max(inclination + BEYOND)];
        };
        if let Some(Changeover { inclination, width }) = changeover {
            widen(inclination - 0.5 * width);
            widen(inclination + 0.5 * width);
        }
        let profile = profile.filter(|profile| profile.across == Across::Inclination);
        for point in profile.iter().flat_map(|p| &p.sections).flat_map(|section| &section.points) {
            widen(point[0]);
        }
        let slopes = ends.map(f64::tan);
        Self { ends, slopes: ends.iter().all(|end| end.abs() < 1.57).then_some(slopes) }
    }

    /// Inclination of a rail of that `hand` with this `tangent`, or the end that it is beyond [rad]: there friction does not change, and an angle
    /// takes longer than a comparison.
    #[inline]
    fn of<T: Real>(&self, tangent: [T; 2], hand: f64) -> T {
        let (y, z) = (tangent[0], tangent[1] * hand);
        let Some([least, greatest]) = self.slopes.filter(|_| y > 0.0) else { return z.atan2(y) };
        let slope = z / y;
        if slope < least {
            return self.ends[0].into();
        }
        if slope > greatest {
            return self.ends[1].into();
        }
        let value = slope.value();
        slope.chain(value.atan(), || 1.0 / (1.0 + value * value))
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
