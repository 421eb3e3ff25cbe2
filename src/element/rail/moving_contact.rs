//! The contact of one wheel with one rail with derivatives: what the search finds, as it moves.

use super::local_line::MIN_CURVATURE_SHARE;
use super::moving_strips;
use super::rail_contact::RailContact;
use super::strip_contact::{self, MAX_STRIP_DEPTH};
use super::strip_damping::StripDamping;
use super::taken_zone::TakenZone;
use crate::element::contact::contact_setup::{ContactSetup, Damped, rail_speeds, relative_motion};
use crate::element::contact::models::Models;
use crate::element::contact::number::ElementNumber;
use crate::element::contact::rail_frame::RailFrame;
use crate::element::input::{Input, RailMotion};
use crate::element::output::Output;
use crate::element::work::Work;
use crate::geometry::contacts::contact::Contact;
use crate::geometry::contacts::line_separation::LineSeparation;
use crate::geometry::contacts::moving_separation::MovingSeparation;
use crate::geometry::rail::placed_rail::PlacedRail;
use crate::geometry::rail::rail_outline::RailOutline;
use crate::geometry::rail::varying_rail::MovingOutline;
use crate::geometry::wheel::contact_line::ContactLine;
use crate::math::dual::Dual;
use crate::math::real::Real;
use crate::math::tape::Taped;
use crate::normal::least_energy::StripNumber;
use crate::normal::{self, NormalProblem};

/// Numbers with derivatives, and the separation that goes with them.
pub trait MovingNumber:
    for<'a> ElementNumber<Separation<'a> = MovingSeparation<'a, Self>> + StripNumber
{
}

impl<const N: usize> MovingNumber for Dual<N> {}

impl MovingNumber for Taped {}

/// The frame of a `rail` that has moved by `motion`, along its rows as `laid` has them.
fn frame_of<T: Real>(
    rail: &PlacedRail,
    motion: &RailMotion<T>,
    laid: Option<&MovingOutline<T>>,
) -> RailFrame<T> {
    let course = laid.filter(|_| rail.variation().is_some()).and_then(MovingOutline::course);
    RailFrame::new(rail, motion).along_rows(course)
}

/// Why there is no derivative.
pub type Kink = &'static str;

/// A wheel that is so deep that other strips take the place of those of the model.
pub const TOO_DEEP: Kink = "the wheel is too deep for the model strips";

/// Strips whose equations have no derivatives.
pub const UNSETTLED: Kink = "the equations of the strips are singular";

/// A contact that the search has put at the end of a body.
pub const BODY_ENDS: Kink = "wheel or rail ends within a contact, where forces have a kink";

impl RailContact {
    /// As [`evaluate`](Self::evaluate) with derivatives.
    ///
    /// # Errors
    /// What has no derivative; `output` and `models` then hold a part.
    pub fn move_along<T: MovingNumber>(
        &mut self,
        k: usize,
        input: &Input<T>,
        found: &mut Models,
        models: &mut Models<T>,
        output: &mut Output<T>,
    ) -> Result<(), Kink> {
        if !self.search_contacts(k, &input.value()) {
            return Ok(());
        }
        if self.search.contacts.iter().any(|contact| contact.penetration > MAX_STRIP_DEPTH)
            && found.strip_solver.is_some()
        {
            return Err(TOO_DEEP);
        }
        let mut laid = models.outline.take();
        self.lay_moving(k, input, laid.as_deref_mut());
        let moved = self.move_contacts(k, input, found, models, output, laid.as_deref());
        models.outline = laid;
        moved
    }

    /// Lays the outline of rail number `k`, if that varies, as it moves with `input`.
    fn lay_moving<T: MovingNumber>(
        &self,
        k: usize,
        input: &Input<T>,
        laid: Option<&mut MovingOutline<T>>,
    ) {
        let Some((laid, varying)) = laid.zip(self.rail.variation()) else { return };
        let frame = RailFrame::new(&self.rail, &input.rails[k]);
        let station = varying.station(input.track_s, input.wheel.position[0]);
        let level = frame.pose(&input.wheel);
        laid.follow_rows(varying, &level, station);
        let pose = frame.along_rows(laid.course()).pose(&input.wheel);
        let turned = laid.course().map_or(T::from(0.0), |course| course.pitch(&level, &pose));
        let pitch = input.wheel.pitch - turned;
        let line = ContactLine::new(&self.wheel.curve, self.nominal_radius, &pose);
        varying.move_with(&line, &pose, [station, pitch], laid);
    }

    /// As [`move_along`](Self::move_along), after the search.
    fn move_contacts<T: MovingNumber>(
        &mut self,
        k: usize,
        input: &Input<T>,
        found: &mut Models,
        models: &mut Models<T>,
        output: &mut Output<T>,
        laid: Option<&MovingOutline<T>>,
    ) -> Result<(), Kink> {
        let Self { rail, search, probes, friction, .. } = self;
        let frame = frame_of(rail, &input.rails[k], laid);
        let radius = self.nominal_radius;
        let moving = ContactLine::new(&self.wheel.curve, radius, &frame.pose(&input.wheel));
        let line = moving.value();
        let outline = RailOutline::moving(rail, laid);
        let mut work = Work::default();
        let in_frame = |contact, damped, resultant_share, ahead| ContactSetup {
            k,
            input,
            frame,
            line: moving,
            rail: outline,
            contact,
            waves: None,
            damped,
            resultant_share,
            ahead,
            friction: friction.as_ref(),
            is_on_arc: !matches!(damped, Damped::Alone),
        };
        if found.strip_solver.is_some() && !search.contacts.is_empty() {
            strip_contact::solve(&line, rail, search, probes, found);
            output.normal_residual = output.normal_residual.at_least(found.normal_residual());
            if !moving_strips::follow(&moving, &outline, search, found, models) {
                return Err(UNSETTLED);
            }
            let deepest = search.contacts.iter().try_fold(T::from(0.0), |deepest, contact| {
                Some(deepest.max(contact.moving(&moving, &outline)?.penetration))
            });
            let deepest = deepest.ok_or(BODY_ENDS)?;
            let damping = StripDamping {
                motion: &relative_motion(input, k, &frame),
                frame: &frame,
                whole: [models.rail_strips.load(), deepest],
                speeds: rail_speeds(input, k, rail, &frame),
                around: None,
            };
            models.strips.clear();
            models.rolling.clear();
            let setup = |TakenZone { contact, load_factor, resultant_share, ahead }| {
                in_frame(contact, Damped::By(load_factor), resultant_share, Some(ahead))
            };
            let separation = |contact: Contact<T>| {
                let values = LineSeparation::new(&line, rail, contact.value());
                MovingSeparation::new(values, &moving, outline, contact)
            };
            for zone in 0..models.rail_strips.zones.len() {
                let taken =
                    moving_strips::take_zone(&moving, &outline, search, zone, &damping, models);
                setup(taken).lay(&separation(taken.contact), models, zone);
            }
            models.roll(output, &mut work);
            for n in 0..models.rolling.zones.len() {
                let taken = TakenZone::of(&models.rolling.zones[n]);
                let mut separation = separation(taken.contact);
                setup(taken).add_laid(n..n + 1, &mut separation, models, output);
            }
            return Ok(());
        }
        for index in 0..search.contacts.len() {
            let found = search.contacts[index];
            let contact = found.moving(&moving, &outline).ok_or(BODY_ENDS)?;
            let mut values = LineSeparation::new(&line, rail, found);
            search.refine_probes(&found, &mut values);
            let probes = &search.probes[found.probes[0]..found.probes[1]];
            let mut separation = MovingSeparation::new(values, &moving, outline, contact);
            models.strips.clear();
            let problem = NormalProblem {
                approach: contact.penetration,
                radius: outline.radius_along(
                    moving.wheel_point(contact.u).section_radius,
                    contact.rail_s,
                    MIN_CURVATURE_SHARE,
                ),
                contact_modulus: models.material.contact_modulus,
                contact_u: contact.u,
                lateral_curvature: moving.curvature(contact.u)
                    + outline.at(contact.rail_s).curvature(),
                rule: &models.rule,
                elements: models.elements,
            };
            normal::solve_in_frame(
                models.normal,
                models.virtual_penetration,
                models.shape_fit,
                &problem,
                &mut separation,
                probes,
                &mut models.strips,
            );
            let forces = in_frame(contact, Damped::Alone, T::from(1.0), None);
            forces.add_forces(&mut separation, models, output, &mut work);
            if separation.has_kink {
                return Err(BODY_ENDS);
            }
        }
        Ok(())
    }

    /// Deepest penetration of the contacts of rail number `k`, if there are any.
    ///
    /// # Errors
    /// As [`move_along`](Self::move_along).
    pub fn moving_penetration<T: MovingNumber>(
        &mut self,
        k: usize,
        input: &Input<T>,
        models: &mut Models<T>,
    ) -> Result<Option<T>, Kink> {
        if !self.search_contacts(k, &input.value()) {
            return Ok(None);
        }
        self.lay_moving(k, input, models.outline.as_deref_mut());
        let outline = RailOutline::moving(&self.rail, models.outline.as_deref());
        let frame = frame_of(&self.rail, &input.rails[k], models.outline.as_deref());
        let radius = self.nominal_radius;
        let moving = ContactLine::new(&self.wheel.curve, radius, &frame.pose(&input.wheel));
        let contacts = self.search.contacts.iter();
        let deepest = contacts.max_by(|c, d| c.penetration.total_cmp(&d.penetration));
        let Some(deepest) = deepest else { return Ok(None) };
        let contact = deepest.moving(&moving, &outline).ok_or(BODY_ENDS)?;
        Ok(Some(contact.penetration))
    }
}
