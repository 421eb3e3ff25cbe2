//! From inputs to outputs.

use std::path::PathBuf;

use super::derivatives::DerivativeMemory;
use super::flattened::FlatContact;
use super::foundation::{Foundation, FoundationModel, TrackState};
use super::models::Models;
use super::output::REPORTED_PATCHES;
use super::parameters::{Placement, RAILS, Side, VerticalMode, WearModel};
use super::rail_contact::RailContact;
use super::rail_friction::RailFriction;
use super::start::StartWarning;
use super::uneven::{deviations, rail_deviations};
use super::wear_sums::WearSums;
use super::{Input, Output, Parameters};
use crate::error::ContactError;
use crate::geometry::placed_rail::PlacedRail;
use crate::geometry::profile::{Profile, ProfileError, ProfileKind, ProfileRemark};
use crate::geometry::slices::Slices;
use crate::geometry::varying_wheel::VaryingWheel;
use crate::io::{load_profile, load_slices};

/// Work done and skipped since the element was made; tests assert it and benchmarks show what it saves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Evaluations asked for.
    pub evaluations: u64,
    /// Rails for which a bound showed that the wheel is lifted.
    pub lifted: u64,
    /// Contact searches.
    pub searches: u64,
    /// Points of a contact line whose distance from a rail was computed.
    pub distances: u64,
    /// Loaded zones with pressure.
    pub zones: u64,
    /// Zones marched through by the tangential model.
    pub marches: u64,
    /// Newton steps of the strip model.
    pub strip_steps: u64,
    /// The most of them for one rail in one evaluation.
    pub most_strip_steps: u64,
}

/// A wheel and the rails under it, ready to be evaluated.
///
/// The result of an evaluation depends on its input alone, not on earlier ones; with rails that have a mass also on where [`Element::move_rails`] has
/// brought them.
#[derive(Clone, Debug)]
pub struct Element {
    pub(super) side: Side,
    pub(super) vertical_mode: VerticalMode,
    pub(super) foundation: Foundation,
    /// Where rails with a mass are, from their first step on.
    pub(super) track: Option<TrackState>,
    /// The last input under which rails without mass rested at a given height, where that was, and what was left of the way to it: asked for
    /// derivatives at an input, they are not to be sought again.
    pub(super) rested: Option<(Input, [f64; 2], f64)>,
    pub(super) nominal_radius: f64,
    pub(super) models: Models,
    pub(super) rails: [Option<RailContact>; RAILS],
    nominal_wheel_z: f64,
    pub(super) start_warning: Option<StartWarning>,
    pub(super) fallbacks: u64,
    pub(super) work: Work,
    /// How deep the wheel of the last evaluation was in a rail, where that was too deep for a force [m].
    sunk: Option<f64>,
    /// What was found and mended in the files of the profiles, with the parameter that names each.
    remarks: Vec<(String, ProfileRemark)>,
    /// Memory for derivatives, once they have been asked for.
    pub(super) memory: Option<Box<DerivativeMemory>>,
}

impl Element {
    /// Loads the profiles (a relative file name is looked for in `profile_folders`, in order), checks the
    /// parameters and sizes all scratch memory. `start` is the input from which `nominal.wheel_z` follows.
    ///
    /// # Errors
    /// The parameter or profile at fault, by its FMU name.
    pub fn new(
        parameters: &Parameters,
        start: &Input,
        profile_folders: &[PathBuf],
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
        let (mut rails, mut slices) = ([const { None }; RAILS], [const { None }; RAILS]);
        for (k, rail) in parameters.rails.iter().enumerate() {
            if rail.enabled {
                let (parameter, kind) = (format!("rail[{}].profile", k + 1), ProfileKind::Rail);
                slices[k] =
                    load_slices(&parameter, &rail.profile, kind, smoothing, profile_folders)?;
                rails[k] = Some(match &slices[k] {
                    Some(slices) => slices.first_profile(),
                    None => load(&parameter, &rail.profile, kind)?,
                });
            }
        }
        let wheel = (&wheel, around.as_ref());
        Self::build(parameters, start, wheel, &rails, &slices, profile_folders)
    }

    /// As [`Element::new`], with profiles at hand instead of their names; `None` stands for a rail that is not there.
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
            parameters.check_around(around, slices.iter().any(Option::is_some))?;
        }
        let radius = parameters.wheel.nominal_radius;
        let sections = around.iter().flat_map(|slices| slices.slices()).map(|s| &s.profile);
        for section in sections.chain([wheel]) {
            let [least, greatest] = section.bounds().z;
            // All of the wheel is on one side of its axle, and none of it further out than twice the nominal radius.
            if radius + least <= 0.1 * radius || greatest > radius {
                let allowed = "a radius in metres that goes with the heights of the wheel profile";
                return Err(ContactError::bad_value("wheel.nominal_radius", radius, allowed));
            }
        }
        let around = around.map(|slices| VaryingWheel::new(slices, radius));
        let mut contacts = [const { None }; RAILS];
        for (k, profile) in rails.iter().enumerate() {
            let Some(profile) = profile else { continue };
            let placed = placed(k, profile, parameters)?;
            let roller = parameters.rails[k].roller_radius;
            let placed = match &slices[k] {
                // Its corrugation is part of its surface.
                Some(slices) => {
                    let corrugation = rail_deviations(parameters, k, folders)?;
                    placed.varying(slices, corrugation, &wheel.curve, radius)
                }
                None if roller > 0.0 => placed.on_roller(profile, &wheel.curve, radius, roller),
                None => placed,
            };
            let deviations = match &slices[k] {
                Some(_) => None,
                None => deviations(parameters, k, folders)?,
            };
            let friction = RailFriction::new(k, &placed, parameters, folders)?;
            let name = &profile.name;
            let contact = RailContact::new(wheel, name, parameters, placed, deviations, friction);
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
            let most_strips = parameters.strips.max(parameters.normal_elements[1]);
            models.wear = Some(Box::new(WearSums::new(
                &parameters.wear,
                most_strips,
                radius,
                &wheel.curve,
                [curve(0), curve(1)],
            )));
        }
        let mut element = Self {
            side: parameters.side,
            vertical_mode: parameters.vertical_mode,
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
        };
        element.reserve_for_wear();
        if parameters.foundation.model != FoundationModel::Rigid {
            element.reserve_derivatives();
        }
        element.set_start(start);
        Ok(element)
    }

    /// Takes `start` as the place in which the wheel starts: [`nominal_wheel_z`](Self::nominal_wheel_z) and
    /// [`start_warning`](Self::start_warning) are then those of it.
    pub fn set_start(&mut self, start: &Input) {
        let touching = self.touch(start);
        self.nominal_wheel_z = touching.unwrap_or(start.wheel.position[2]);
        self.look_at_start(start, touching);
    }

    /// Height of the wheel marker at which the wheel at its starting y, roll and yaw just touches; its starting height where
    /// it stands beside the rails [m].
    #[must_use]
    pub fn nominal_wheel_z(&self) -> f64 {
        self.nominal_wheel_z
    }

    /// What was found and mended in the files of the profiles, with the parameter that names each file.
    #[must_use]
    pub fn profile_remarks(&self) -> &[(String, ProfileRemark)] {
        &self.remarks
    }

    /// Greatest angle between the normals within the contact of one rail at the last evaluation [rad]; 0 but for boundary elements, which are the only ones that
    /// lie on the curved surface each by itself.
    #[must_use]
    pub fn turn_of_normals(&self) -> f64 {
        self.models.turn_of_normals
    }

    /// Work done and skipped so far.
    #[must_use]
    pub fn work(&self) -> Work {
        let strips = self.models.strip_solver.as_ref().map(|solver| solver.work);
        let strips = strips.unwrap_or_default();
        Work { strip_steps: strips.steps, most_strip_steps: strips.most_steps, ..self.work }
    }

    /// Contacts and zones that found no room so far: the only thing an element remembers.
    #[must_use]
    pub fn fallbacks(&self) -> u64 {
        self.fallbacks
    }

    /// How deep the wheel of the last evaluation was below the top of a rail, where that was too deep for the outlines to tell a force: the
    /// rail then carries nothing, which is no lifted wheel [m].
    #[must_use]
    pub fn sunk(&self) -> Option<f64> {
        self.sunk
    }

    /// Goes back to an earlier count of [`fallbacks`](Self::fallbacks).
    pub fn set_fallbacks(&mut self, fallbacks: u64) {
        self.fallbacks = fallbacks;
    }

    /// The count as it is reported in [`Output::fallback_count`].
    #[must_use]
    pub fn fallback_count(&self) -> i32 {
        i32::try_from(self.fallbacks).unwrap_or(i32::MAX)
    }

    /// The contacts for `input` as planar problems, as a right wheel has them; allocates. In load mode the height has to be that found.
    ///
    /// # Errors
    /// The input at fault, by its FMU name.
    pub fn flat_contacts(&mut self, input: &Input) -> Result<Vec<FlatContact>, ContactError> {
        input.check()?;
        let mut input = if self.side == Side::Left { input.mirrored() } else { *input };
        if self.foundation.model != FoundationModel::Rigid {
            let work = self.work;
            self.respond(&mut input, &mut Output::default());
            self.work = work;
        }
        let speed = self.models.minimum_speed;
        let rails = self.rails.iter_mut().enumerate();
        Ok(rails
            .filter_map(|(k, rail)| Some(rail.as_mut()?.flattened(k, &input, speed)))
            .flatten()
            .collect())
    }

    /// Evaluates the forces; allocates nothing.
    ///
    /// # Errors
    /// The input at fault, by its FMU name; `output` is then as before.
    pub fn evaluate(&mut self, input: &Input, output: &mut Output) -> Result<(), ContactError> {
        let admitted = input.admitted()?;
        self.work.evaluations += 1;
        let mirrored = self.side == Side::Left;
        let mut input = if mirrored { admitted.mirrored() } else { admitted };
        // Nothing can fail from here on.
        self.fallbacks += self.respond(&mut input, output);
        output.wheel_z = input.wheel.position[2];
        output.load_carried = 0.0 - output.wheel.force[2];
        let patches = &mut self.models.patches;
        patches.sort_unstable_by(|a, b| b.normal_force.total_cmp(&a.normal_force));
        for (slot, patch) in output.patches.iter_mut().zip(patches.iter()).take(REPORTED_PATCHES) {
            *slot = *patch;
        }
        output.patch_count = patches.len() as i32;
        output.fallback_count = self.fallback_count();
        if mirrored {
            *output = output.mirrored();
        }
        self.report_wear(output);
        Ok(())
    }

    /// Sums the forces of all rails for the `input` of a right side; returns how many contacts or zones found no room.
    pub(super) fn forces(&mut self, input: &Input, output: &mut Output) -> u64 {
        self.models.turn_of_normals = 0.0;
        output.clear();
        self.models.patches.clear();
        self.sunk = None;
        let mut left_out = 0;
        for (k, rail) in self.rails.iter_mut().enumerate() {
            if let Some(rail) = rail {
                left_out += rail.evaluate(
                    k,
                    input,
                    &mut self.models,
                    output,
                    &mut self.work,
                    &mut self.sunk,
                );
            }
        }
        left_out
    }

    /// The marker height at which the first contact appears when the wheel comes down from above, at the y, roll and
    /// yaw of `start`; its own height where it stands beside the rails [m].
    pub fn touching_height(&mut self, start: &Input) -> f64 {
        self.touch(start).unwrap_or(start.wheel.position[2])
    }

    /// As [`touching_height`](Self::touching_height); nothing where the wheel stands beside the rails.
    pub fn touch(&mut self, start: &Input) -> Option<f64> {
        let input = if self.side == Side::Left { start.mirrored() } else { *start };
        self.first_touch(&input)
    }

    /// As [`touching_height`](Self::touching_height) for the input of a right side; nothing where the wheel stands beside the rails.
    pub(super) fn first_touch(&mut self, input: &Input) -> Option<f64> {
        first_touch(&mut self.rails, input)
    }
}

/// The marker height at which a wheel coming down from above first touches one of the first `rails`, for the input of a right side; nothing
/// where it stands beside them [m].
pub(super) fn first_touch(rails: &mut [Option<RailContact>], input: &Input) -> Option<f64> {
    let highest = (rails.iter().enumerate())
        .filter_map(|(k, rail)| Some(rail.as_ref()?.clear_height(k, input)))
        .fold(f64::INFINITY, f64::min);
    if !highest.is_finite() {
        return None;
    }
    let mut lift = |z: f64| {
        let mut at = *input;
        at.wheel.position[2] = z;
        (rails.iter_mut().enumerate())
            .filter_map(|(k, rail)| rail.as_mut()?.lift(k, &at))
            .reduce(f64::max)
    };
    // A counted descent ends, whatever the numbers: no rail, or a start so far away that a step is lost in rounding.
    let height = |step: usize| highest + step as f64 * DESCENT_STEP;
    let (step, mut to_lift) =
        (1..=MOST_DESCENT_STEPS).find_map(|step| Some((step, lift(height(step))?)))?;
    let (mut clear, mut touching) = (height(step - 1), height(step));
    // Down to neighbouring numbers.
    for trial in 1..=MOST_TRIALS {
        let guess = touching - to_lift;
        let aside = LOOK_BESIDE * (touching - clear);
        // The farther end is brought to just beyond the guess.
        let beside = if guess - clear > touching - guess { guess - aside } else { guess + aside };
        let is_inside = |z: f64| z > clear && z < touching;
        let z = if trial % BISECT_EVERY != 0 && is_inside(beside) {
            beside
        } else {
            0.5 * (clear + touching)
        };
        if !is_inside(z) {
            break;
        }
        match lift(z) {
            Some(found) => (touching, to_lift) = (z, found),
            None => clear = z,
        }
    }
    Some(touching)
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

/// Step of the descent onto the rail: no wheel passes through a rail in it [m].
const DESCENT_STEP: f64 = 2e-4;
/// Steps after which the wheel stands beside the rail: 0.15 m, more than any flange is high.
const MOST_DESCENT_STEPS: usize = 750;
/// How far beside a guess of first touch the wheel is tried, as a share of what the height is known to.
const LOOK_BESIDE: f64 = 1.0 / 256.0;
/// Every so many trials the middle is taken, should the guesses be none.
const BISECT_EVERY: usize = 4;
/// From the step of the descent to rounding it takes 45 bisections; a dozen trials are the rule.
const MOST_TRIALS: usize = BISECT_EVERY * 45;
