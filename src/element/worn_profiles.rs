//! Profiles that wear while the element is in use.
//!
//! [`Element::evaluate`] never wears anything off: whoever knows that time has passed says so with
//! [`Element::advance`]. New profiles come at the ends of intervals, see [`crate::wear::update`].

use super::parameters::{FoundationModel, RAILS, VerticalMode};
use super::steps::check_duration;
use super::wear_sums::WearState;
use super::{Element, Input, Output};
use crate::error::ContactError;
use crate::geometry::curves::curve::Curve;
use crate::geometry::profiles::profile::Profile;

impl Element {
    /// Evaluates the forces and wears off what their patches wear off in a time of `duration` ≥ 0
    /// [s]; where an interval between updates ends with it, the profiles are updated and the forces
    /// evaluated anew, on the new ones. With `tangential_history` = transient it is a step from what
    /// contacts remember, which they remember then. Without either it is
    /// [`evaluate`](Self::evaluate).
    ///
    /// # Errors
    /// The input at fault, by its FMU name, or a duration that is negative or not finite; nothing
    /// is worn off then, and the history stays.
    pub fn advance(
        &mut self,
        input: &Input,
        output: &mut Output,
        duration: f64,
    ) -> Result<(), ContactError> {
        check_duration(duration)?;
        if self.remembers() {
            return self.step(input, output, duration);
        }
        self.accumulate(input, output, duration)?;
        let Some(wear) = &mut self.models.wear else { return Ok(()) };
        let interval = wear.parameters.update_interval;
        wear.clock += duration;
        // Steps counted in floating point may end just before the interval does.
        if wear.clock < interval * (1.0 - 1e-9) {
            return Ok(());
        }
        wear.clock = (wear.clock - interval).max(0.0) % interval;
        self.update_profiles();
        self.evaluate(input, output)
    }

    /// As [`advance`](Self::advance), without updates: [`update_profiles`](Self::update_profiles)
    /// makes them.
    ///
    /// # Errors
    /// The input at fault, by its FMU name; nothing is worn off then.
    pub fn accumulate(
        &mut self,
        input: &Input,
        output: &mut Output,
        duration: f64,
    ) -> Result<(), ContactError> {
        if self.models.wear.is_none() || duration <= 0.0 {
            return self.evaluate(input, output);
        }
        // Where height or rails are searched for, wear belongs to where they were found.
        let is_search = self.vertical_mode == VerticalMode::Load
            || self.foundation.model == FoundationModel::Massless;
        if is_search {
            let found = self.evaluate_at(input, output)?;
            self.record_for(duration);
            self.forces(&found, &mut Output::default());
        } else {
            self.record_for(duration);
            let evaluated = self.evaluate(input, output);
            self.record_for(0.0);
            evaluated?;
        }
        self.record_for(0.0);
        self.report_wear(output);
        Ok(())
    }

    /// Makes room for worn profiles, so that updates allocate nothing.
    pub(super) fn reserve_for_wear(&mut self) {
        let Some(wear) = &mut self.models.wear else { return };
        let wheel_knots = wear.wheel.knot_count();
        wear.wheel_curve.reserve(wheel_knots);
        for (contact, rail) in self.rails.iter_mut().zip(&wear.rails) {
            if let (Some(contact), Some(rail)) = (contact, rail) {
                contact.reserve_for_wear(wheel_knots, rail.knot_count());
            }
        }
    }

    fn record_for(&mut self, duration: f64) {
        if let Some(wear) = &mut self.models.wear {
            wear.record_for(duration);
        }
    }

    /// Fills in what was worn off so far.
    pub(super) fn report_wear(&self, output: &mut Output) {
        if let Some(wear) = &self.models.wear {
            (output.wheel_wear, output.rail_wear) = wear.output();
        }
    }

    /// Makes new profiles of what was worn off so far. Where a profile is worn through, which
    /// counts as a fallback, the rest of the wear there is not taken off.
    pub fn update_profiles(&mut self) {
        if let Some(wear) = &mut self.models.wear {
            wear.wheel.take_pending();
            for rail in wear.rails.iter_mut().flatten() {
                rail.take_pending();
            }
            self.put_worn_profiles();
        }
    }

    /// Puts the profiles that the totals of wear leave under the contact search.
    fn put_worn_profiles(&mut self) {
        self.rested = None;
        let Some(wear) = &mut self.models.wear else { return };
        let smoothing = wear.parameters.smoothing;
        let report = wear.wheel.put_worn_curve(smoothing, &mut wear.wheel_curve);
        self.fallbacks += u64::from(report.is_worn_through);
        for (contact, rail) in self.rails.iter_mut().zip(&mut wear.rails) {
            let (Some(contact), Some(rail)) = (contact, rail) else { continue };
            let put = |curve: &mut Curve| rail.put_worn_curve(smoothing, curve);
            let report = contact.put_curves(&wear.wheel_curve, put);
            self.fallbacks += u64::from(report.is_worn_through);
        }
    }

    /// All that wear has to remember, if there is any; profiles follow from it.
    pub fn wear_state(&self) -> Option<WearState> {
        let wear = self.models.wear.as_ref()?;
        Some(WearState {
            clock: wear.clock,
            wheel: wear.wheel.state().clone(),
            rails: [0, 1].map(|k| wear.rails[k].as_ref().map(|rail| rail.state().clone())),
        })
    }

    /// Copies that over `state`, without allocating if it is of such an element.
    pub fn copy_wear_state(&self, state: &mut Option<WearState>) {
        let (Some(wear), Some(state)) = (&self.models.wear, state.as_mut()) else {
            *state = self.wear_state();
            return;
        };
        state.clock = wear.clock;
        state.wheel.copy_from(wear.wheel.state());
        for (saved, rail) in state.rails.iter_mut().zip(&wear.rails) {
            match (saved, rail) {
                (Some(saved), Some(rail)) => saved.copy_from(rail.state()),
                (saved, rail) => *saved = rail.as_ref().map(|rail| rail.state().clone()),
            }
        }
    }

    /// Goes back to an earlier [`wear_state`](Self::wear_state) of an element with the same
    /// parameters and profiles; whether `state` is one. Profiles are made anew only if they differ.
    pub fn set_wear_state(&mut self, state: &WearState) -> bool {
        let Some(wear) = &mut self.models.wear else { return false };
        let fits = wear.wheel.fits(&state.wheel)
            && wear.rails.iter().zip(&state.rails).all(|(rail, state)| match (rail, state) {
                (Some(rail), Some(state)) => rail.fits(state),
                (None, None) => true,
                _ => false,
            });
        if !fits {
            return false;
        }
        wear.clock = state.clock;
        let mut is_same = wear.wheel.set_state(&state.wheel);
        for (rail, state) in wear.rails.iter_mut().zip(&state.rails) {
            if let (Some(rail), Some(state)) = (rail, state) {
                is_same &= rail.set_state(state);
            }
        }
        if !is_same {
            let fallbacks = self.fallbacks;
            self.put_worn_profiles();
            self.fallbacks = fallbacks;
        }
        true
    }

    /// Adds what the wheel of another element has lost since its last update to this one's: for one
    /// wheel that runs in several simulations at once. Both update their profiles afterwards, and
    /// the other one gets this one's in the same way before.
    ///
    /// `wear` is the other's [`wear_state`](Self::wear_state); false, with nothing changed, where
    /// the wheels are not the same.
    pub fn share_wheel_wear(&mut self, wear: &WearState) -> bool {
        let Some(own) = &mut self.models.wear else { return false };
        let fits = own.wheel.fits(&wear.wheel);
        if fits {
            own.wheel.add_pending(&wear.wheel);
        }
        fits
    }

    /// The wheel's profile with all wear so far, what is not yet in use included.
    pub fn worn_wheel(&self) -> Option<Profile> {
        let contact = self.rails.iter().flatten().next()?;
        let mut profile = contact.wheel_profile().clone();
        if let Some(wear) = &self.models.wear {
            let mut arc = wear.wheel.clone();
            arc.take_pending();
            profile.curve = arc.worn_curve(wear.parameters.smoothing).0;
        }
        Some(profile)
    }

    /// The profile of rail number `k`, from 0, as [`worn_wheel`](Self::worn_wheel); in the frame of
    /// its profile, neither inclined nor mirrored.
    pub fn worn_rail(&self, k: usize) -> Option<Profile> {
        let contact = self.rails.get(k)?.as_ref()?;
        let curve = self.models.wear.as_ref().and_then(|wear| {
            let mut arc = wear.rails[k].as_ref()?.clone();
            arc.take_pending();
            Some(arc.worn_curve(wear.parameters.smoothing).0)
        });
        Some(contact.rail_profile(curve.as_ref()))
    }

    /// Wear depth over the lateral coordinate of the unworn profile [m]: of the wheel, or of rail
    /// number `k` from 0; as the profile in use has it.
    pub fn wear_depth(&self, body: WornBody) -> Vec<[f64; 2]> {
        let Some(wear) = &self.models.wear else { return Vec::new() };
        let smoothing = wear.parameters.smoothing;
        match body {
            WornBody::Wheel => wear
                .wheel
                .depth_over_arc(smoothing)
                .iter()
                .map(|[s, depth]| [wear.wheel.base().at(*s).point[0], *depth])
                .collect(),
            WornBody::Rail(k) => {
                let arc = wear.rails.get(k).and_then(Option::as_ref);
                let contact = self.rails.get(k).and_then(Option::as_ref);
                let (Some(arc), Some(contact)) = (arc, contact) else { return Vec::new() };
                let place = |s: f64| contact.profile_point(arc.base().at(s).point)[0];
                let depths = arc.depth_over_arc(smoothing);
                depths.iter().map(|[s, depth]| [place(*s), *depth]).collect()
            }
        }
    }
}

/// A body that wears.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum WornBody {
    /// The wheel.
    Wheel,
    /// A rail by its number, from 0.
    Rail(usize),
}

const _: () = assert!(RAILS == 2);
