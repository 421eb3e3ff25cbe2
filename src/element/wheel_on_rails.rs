//! A wheel on its rails: what an element consists of.

use super::balance::{Carried, Expected};
use super::contact::models::Models;
use super::derivative_memory::{AdjointMemory, DerivativeMemory};
use super::free_rolling::FreeRolling;
use super::gradient::Wanted;
use super::last_step::PoseForces;
use super::parameters::foundation::{Foundation, TrackState};
use super::parameters::{RAILS, Side, VerticalMode};
use super::rail::rail_contact::RailContact;
use super::rested::Rested;
use super::start_warning::StartWarning;
use super::work::Work;
use crate::geometry::profiles::profile::ProfileRemark;

/// A wheel and the rails under it, ready to be evaluated.
///
/// The result of an evaluation depends on its input alone, not on earlier ones; with rails that
/// have a mass also on where [`Element::move_rails`] has brought them, and with contacts that
/// remember on the steps of [`Element::advance`].
#[derive(Clone, Debug)]
pub struct Element {
    pub(super) side: Side,
    pub(super) vertical_mode: VerticalMode,
    /// What turns the wheel, if not its input.
    pub(super) rolling: Option<FreeRolling>,
    pub(super) foundation: Foundation,
    /// Where rails with a mass are, from their first step on.
    pub(super) track: Option<TrackState>,
    /// How rails without mass rested last: asked for derivatives at an input, they are not to be
    /// sought again.
    pub(super) rested: Option<Rested>,
    /// How the load of the next evaluation is carried, if that is known.
    pub(super) expected: Option<Expected>,
    /// How that of the last one was carried, if its balance led there.
    pub(super) carried: Option<Carried>,
    /// Forces of the last pose of a search for it.
    pub(super) pose_forces: PoseForces,
    pub(super) nominal_radius: f64,
    pub(super) models: Models,
    pub(super) rails: [Option<RailContact>; RAILS],
    pub(super) nominal_wheel_z: f64,
    pub(super) start_warning: Option<StartWarning>,
    pub(super) fallbacks: u64,
    pub(super) work: Work,
    /// How deep the wheel of the last evaluation was in a rail, where that was too deep for a force
    /// [m].
    pub(super) sunk: Option<f64>,
    /// What was found and mended in the files of the profiles, with the parameter that names each.
    pub(super) remarks: Vec<(String, ProfileRemark)>,
    /// Memory for derivatives, once they have been asked for.
    pub(super) memory: Option<Box<DerivativeMemory>>,
    /// The same for derivatives backwards.
    pub(super) backwards: Option<Box<AdjointMemory>>,
    /// What parameters are wanted for by those.
    pub(super) wanted: Wanted,
}

impl Element {
    /// Height of the wheel marker at which the wheel at its starting y, roll and yaw just touches;
    /// its starting height where it stands beside the rails [m].
    pub fn nominal_wheel_z(&self) -> f64 {
        self.nominal_wheel_z
    }

    /// What was found and mended in the files of the profiles, with the parameter that names each
    /// file.
    pub fn profile_remarks(&self) -> &[(String, ProfileRemark)] {
        &self.remarks
    }

    /// Greatest angle between the normals within the contact of one rail at the last evaluation
    /// [rad]; 0 but for boundary elements, which are the only ones that lie on the curved surface
    /// each by itself.
    pub fn turn_of_normals(&self) -> f64 {
        self.models.turn_of_normals
    }

    /// Work done and skipped so far.
    pub fn work(&self) -> Work {
        let strips = self.models.strip_solver.as_ref().map(|solver| solver.work);
        let strips = strips.unwrap_or_default();
        Work { strip_steps: strips.steps, most_strip_steps: strips.most_steps, ..self.work }
    }

    /// Contacts and zones that found no room so far.
    pub fn fallbacks(&self) -> u64 {
        self.fallbacks
    }

    /// How deep the wheel of the last evaluation was below the top of a rail, where that was too
    /// deep for the outlines to tell a force: the rail then carries nothing, which is no lifted
    /// wheel [m].
    pub fn sunk(&self) -> Option<f64> {
        self.sunk
    }

    /// Goes back to an earlier count of [`fallbacks`](Self::fallbacks).
    pub fn set_fallbacks(&mut self, fallbacks: u64) {
        self.fallbacks = fallbacks;
    }

    /// The count as it is reported in [`Output::fallback_count`](super::Output::fallback_count).
    pub fn fallback_count(&self) -> i32 {
        i32::try_from(self.fallbacks).unwrap_or(i32::MAX)
    }
}
