//! From parameters and profiles to an element that is ready to be evaluated.

use std::path::PathBuf;

use super::contact::models::Models;
use super::contact::rail_friction::RailFriction;
use super::free_rolling::FreeRolling;
use super::gradient::Wanted;
use super::input::Input;
use super::last_step::PoseForces;
use super::parameters::deviations::{rail_deviations, wheel_deviations};
use super::parameters::{FoundationModel, Parameters, Placement, RAILS, Side, WearModel};
use super::rail::rail_contact::RailContact;
use super::wear_sums::WearSums;
use super::wheel_on_rails::Element;
use super::work::Work;
use crate::error::ContactError;
use crate::geometry::profiles::profile::{Profile, ProfileError, ProfileKind};
use crate::geometry::rail::placed_rail::PlacedRail;
use crate::geometry::rail::varying_rail::WheelAbove;
use crate::geometry::sections::slices::Slices;
use crate::geometry::wheel::varying_wheel::VaryingWheel;
use crate::io::{load_profile, load_slices};

/// Stations between which a rail is given that is the same all along: beyond them it goes on [m].
const EVEN_STRETCH: [f64; 2] = [-1.0, 1.0];

impl Element {
    /// Loads the profiles (a relative file name is looked for in `profile_folders`, in order),
    /// checks the parameters and sizes all scratch memory. `start` is the input from which
    /// `nominal.wheel_z` follows.
    ///
    /// # Errors
    /// The parameter or profile at fault, by its FMU name.
    pub fn new(
        parameters: &Parameters,
        start: &Input,
        profile_folders: &[PathBuf],
    ) -> Result<Self, ContactError> {
        Self::displaced(parameters, start, profile_folders, &[], &[&[]; RAILS])
    }

    /// As [`Element::new`], with the points of the profiles of wheel and rails displaced, out of the
    /// bodies, as [`Profile::displaced`] has it [m]; where none are given they stay.
    ///
    /// # Errors
    /// As there; displacements that are not finite, not as many as points, or of a profile that has
    /// none, as it varies.
    pub fn displaced(
        parameters: &Parameters,
        start: &Input,
        profile_folders: &[PathBuf],
        wheel_points: &[f64],
        rail_points: &[&[f64]; RAILS],
    ) -> Result<Self, ContactError> {
        parameters.check()?;
        let load = |parameter: &str, name: &str, kind| {
            load_profile(parameter, name, kind, parameters.profile_smoothing, profile_folders)
        };
        let smoothing = parameters.profile_smoothing;
        let (name, kind) = ("wheel.profile", ProfileKind::Wheel);
        let own = &parameters.wheel.profile;
        let around = load_slices(name, own, kind, smoothing, profile_folders)?;
        let wheel = match &around {
            Some(slices) => slices.first_profile(),
            None => load(name, own, kind)?,
        };
        let wheel = moved(name, wheel, around.is_some(), wheel_points)?;
        let (mut rails, mut slices) = ([const { None }; RAILS], [const { None }; RAILS]);
        for (k, rail) in parameters.rails.iter().enumerate() {
            if rail.enabled {
                let (parameter, kind) = (format!("rail[{}].profile", k + 1), ProfileKind::Rail);
                slices[k] =
                    load_slices(&parameter, &rail.profile, kind, smoothing, profile_folders)?;
                let profile = match &slices[k] {
                    Some(slices) => slices.first_profile(),
                    None => load(&parameter, &rail.profile, kind)?,
                };
                rails[k] = Some(moved(&parameter, profile, slices[k].is_some(), rail_points[k])?);
            }
        }
        let wheel = (&wheel, around.as_ref());
        Self::build(parameters, start, wheel, &rails, &slices, profile_folders)
    }

    /// As [`Element::new`], with profiles at hand instead of their names; `None` stands for a rail
    /// that is not there.
    ///
    /// # Errors
    /// The parameter or profile at fault, by its FMU name.
    pub fn with_profiles(
        parameters: &Parameters,
        start: &Input,
        wheel: &Profile,
        rails: &[Option<Profile>; RAILS],
    ) -> Result<Self, ContactError> {
        parameters.check()?;
        Self::build(parameters, start, (wheel, None), rails, &[const { None }; RAILS], &[])
    }

    /// The element of checked `parameters`; `folders` is where files of deviations are looked for.
    fn build(
        parameters: &Parameters,
        start: &Input,
        (wheel, around): (&Profile, Option<&Slices>),
        rails: &[Option<Profile>; RAILS],
        slices: &[Option<Slices>; RAILS],
        folders: &[PathBuf],
    ) -> Result<Self, ContactError> {
        start.check()?;
        for (k, slices) in slices.iter().enumerate() {
            if rails[k].is_some() {
                parameters.check_variation(k, slices.as_ref())?;
            }
        }
        if let Some(around) = around {
            parameters.check_around(around)?;
        }
        let radius = parameters.wheel.nominal_radius;
        let sections = around.iter().flat_map(|slices| slices.slices()).map(|s| &s.profile);
        for section in sections.chain([wheel]) {
            let [least, greatest] = section.bounds().z;
            // All of the wheel is on one side of its axle, and none of it further out than twice
            // the nominal radius.
            if radius + least <= 0.1 * radius || greatest > radius {
                let allowed = "a radius in metres that goes with the heights of the wheel profile";
                return Err(ContactError::bad_value("wheel.nominal_radius", radius, allowed));
            }
        }
        let around = around.map(|slices| VaryingWheel::new(slices, radius));
        let above = WheelAbove {
            profile: &wheel.curve,
            nominal_radius: radius,
            waves: wheel_deviations(parameters, folders)?,
            around: around.as_ref(),
        };
        let mut contacts = [const { None }; RAILS];
        for (k, profile) in rails.iter().enumerate() {
            let Some(profile) = profile else { continue };
            let mut placed = placed(k, profile, parameters)?;
            placed.number = k as u32;
            let roller = parameters.rails[k].roller_radius;
            let corrugation = rail_deviations(parameters, k, folders)?;
            // A rail with waves, or under a wheel with waves, has the same section all along.
            let has_waves = !corrugation.is_empty() || !above.waves.is_empty();
            let even = (has_waves && roller <= 0.0).then(|| Slices::even(profile, EVEN_STRETCH));
            let placed = match slices[k].as_ref().or(even.as_ref()) {
                Some(slices) => placed.varying(slices, corrugation, &above),
                None if roller > 0.0 => placed.on_roller(profile, corrugation, &above, roller),
                None => placed,
            };
            let friction = RailFriction::new(k, &placed, parameters, folders)?;
            let name = &profile.name;
            let contact = RailContact::new(wheel, name, parameters, placed, friction);
            contacts[k] = Some(match &around {
                Some(around) => contact.with_wheel(around),
                None => contact,
            });
        }
        let named = std::iter::once(("wheel.profile".to_owned(), wheel)).chain(
            rails
                .iter()
                .enumerate()
                .filter_map(|(k, rail)| Some((format!("rail[{}].profile", k + 1), rail.as_ref()?))),
        );
        let remarks = named
            .flat_map(|(name, profile)| {
                profile.remarks.iter().map(move |r| (name.clone(), r.clone()))
            })
            .collect();
        let mut models = Models::new(parameters);
        if parameters.wear.model != WearModel::Off {
            let curve = |k: usize| contacts[k].as_ref().map(RailContact::rail_curve);
            let most_strips = models.strips.y.capacity().max(parameters.normal_elements[1]);
            models.wear = Some(Box::new(WearSums::new(
                &parameters.wear,
                most_strips,
                radius,
                &wheel.curve,
                [curve(0), curve(1)],
            )));
        }
        let mut element = Self {
            expected: None,
            carried: None,
            pose_forces: PoseForces::new(models.patches.capacity()),
            side: parameters.side,
            vertical_mode: parameters.vertical_mode,
            rolling: FreeRolling::of(parameters),
            foundation: parameters.foundation,
            track: None,
            rested: None,
            nominal_radius: radius,
            models,
            rails: contacts,
            nominal_wheel_z: start.wheel.position[2],
            start_warning: None,
            fallbacks: 0,
            work: Work::default(),
            sunk: None,
            remarks,
            memory: None,
            backwards: None,
            wanted: Wanted::of(parameters),
        };
        element.reserve_for_wear();
        if parameters.foundation.model != FoundationModel::Rigid {
            element.reserve_derivatives();
        }
        element.set_start(start);
        Ok(element)
    }
}

/// The `profile` of the parameter `name` with its points displaced by `ways`, if there are any [m].
fn moved(
    name: &str,
    profile: Profile,
    varies: bool,
    ways: &[f64],
) -> Result<Profile, ContactError> {
    if ways.is_empty() {
        return Ok(profile);
    }
    let count = if varies { 0 } else { profile.points().len() };
    if ways.len() != count {
        let allowed =
            "as many displacements in metres as the profile has points, none if it varies";
        let name = format!("number of displacements of {name}");
        return Err(ContactError::bad_value(name, ways.len() as f64, allowed));
    }
    if let Some(way) = ways.iter().find(|way| !way.is_finite()) {
        return Err(ContactError::bad_value("a displacement", *way, "a finite number in metres"));
    }
    Ok(profile.displaced(ways))
}

/// Rail number `k` where the parameters put it.
fn placed(
    k: usize,
    profile: &Profile,
    parameters: &Parameters,
) -> Result<PlacedRail, ContactError> {
    let rail = &parameters.rails[k];
    let (curve, inclination, mirrored) = (&profile.curve, rail.inclination, rail.mirrored);
    let [y, z] = rail.position;
    let place = [if parameters.side == Side::Left { -y } else { y }, z];
    match rail.placement {
        Placement::Position => Ok(PlacedRail::at_marker(curve, inclination, place, mirrored)),
        Placement::Origin => Ok(PlacedRail::at_origin(curve, inclination, place, mirrored)),
        Placement::Gauge => {
            let (gauge, depth) = (parameters.gauge, parameters.gauge_depth);
            PlacedRail::by_gauge(curve, inclination, gauge, depth, mirrored).map_err(|_| {
                ContactError::Profile {
                    name: format!("rail[{}].profile", k + 1),
                    problem: ProfileError::NoGaugeFace {
                        name: profile.name.clone(),
                        depth_mm: 1e3 * depth,
                        placement: format!("rail[{}].placement", k + 1),
                    },
                }
            })
        }
    }
}
