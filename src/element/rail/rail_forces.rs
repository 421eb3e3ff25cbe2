//! From the contacts that the search has found on one rail to forces: normal and tangential models,
//! one contact after the other or all together.

use super::boundary_contact;
use super::flattened::FlatContact;
use super::local_line::MIN_CURVATURE_SHARE;
use super::rail_contact::{RailContact, with};
use super::strip_contact::{self, MAX_STRIP_DEPTH};
use crate::element::contact::contact_setup::{ContactSetup, Damped};
use crate::element::contact::models::Models;
use crate::element::contact::rail_frame::RailFrame;
use crate::element::input::Input;
use crate::element::output::Output;
use crate::element::work::Work;
use crate::geometry::contacts::line_separation::{Lifting, LineSeparation};
use crate::geometry::contacts::separation::Separation;
use crate::geometry::rail::rail_outline::RailOutline;
use crate::geometry::wheel::contact_line::ContactLine;
use crate::normal::{self, NormalModel, NormalProblem};

/// Penetration from which on it is looked whether a wheel is inside the rail, and depth from which
/// on one without a force is [m].
const DEEP: f64 = 5e-3;

/// Depth down to which forces grow [m]: two thirds of a rail's head, below whose middle its
/// underside is as near as its top.
const MAX_DEPTH: f64 = 2.5e-2;

impl RailContact {
    /// The contacts with rail number `k` for `input` (right side), laid flat.
    pub fn flattened(&mut self, k: usize, input: &Input, minimum_speed: f64) -> Vec<FlatContact> {
        if !self.search_contacts(k, input) {
            return Vec::new();
        }
        let frame = RailFrame::new(&self.rail, &input.rails[k]);
        let line =
            ContactLine::new(&self.wheel.curve, self.nominal_radius, &frame.pose(&input.wheel));
        let line = with(line, self.deviations.as_ref(), self.around.as_deref());
        let contacts = self.search.contacts.iter().map(|&contact| {
            let mut separation = LineSeparation::new(&line, &self.rail, contact);
            let even_radius = line.wheel_point(contact.u).section_radius;
            let radius = RailOutline::at_rest(&self.rail).radius_along(
                even_radius,
                contact.rail_s,
                MIN_CURVATURE_SHARE,
            );
            let forces = ContactSetup {
                k,
                input,
                frame,
                line,
                rail: RailOutline::at_rest(&self.rail),
                contact,
                slopes: [0.0; 2],
                damped: Damped::Alone,
                resultant_share: 1.0,
                friction: self.friction.as_ref(),
                is_on_arc: false,
            };
            forces.flattened(&mut separation, radius, minimum_speed)
        });
        contacts.collect()
    }

    /// Adds the forces of rail number `k` to `output`; returns how many contacts or zones found no
    /// room or fell back to a simpler model. A wheel that is so deep in the rail that the outlines
    /// tell no force is one of them, and `sunk` is then how deep it is [m].
    pub fn evaluate(
        &mut self,
        k: usize,
        input: &Input,
        models: &mut Models,
        output: &mut Output,
        work: &mut Work,
        sunk: &mut Option<f64>,
    ) -> u64 {
        let before = (self.search.evaluations, self.search.left_out);
        if !self.search_contacts(k, input) {
            work.lifted += 1;
            return 0;
        }
        work.searches += 1;
        work.distances += self.search.evaluations - before.0;
        let left_out = self.search.left_out - before.1;
        let contacts = &self.search.contacts;
        // Deep, from below, or with nothing to touch where bounds do not rule it out.
        let looks_sunk = contacts.is_empty()
            || contacts.iter().any(|c| c.penetration > DEEP || c.tangent[0] < 0.0);
        let depth = if looks_sunk { self.depth(k, input) } else { 0.0 };
        let patches = models.patches.len();
        let mut fallbacks = 0;
        if depth <= MAX_DEPTH {
            fallbacks = self.add_forces(k, input, models, output, work);
        }
        if depth > DEEP && models.patches.len() == patches {
            *sunk = Some(sunk.map_or(depth, |deepest| deepest.max(depth)));
            return 1;
        }
        left_out + fallbacks
    }

    /// Adds the forces of the contacts found; returns how many zones found no room or fell back to
    /// a simpler model.
    fn add_forces(
        &mut self,
        k: usize,
        input: &Input,
        models: &mut Models,
        output: &mut Output,
        work: &mut Work,
    ) -> u64 {
        let frame = RailFrame::new(&self.rail, &input.rails[k]);
        let line =
            ContactLine::new(&self.wheel.curve, self.nominal_radius, &frame.pose(&input.wheel));
        let line = with(line, self.deviations.as_ref(), self.around.as_deref());
        let mut left_out = 0;
        let forces = |contact, slopes, damped| ContactSetup {
            k,
            input,
            frame,
            line,
            rail: RailOutline::at_rest(&self.rail),
            contact,
            slopes,
            damped,
            resultant_share: 1.0,
            friction: self.friction.as_ref(),
            // What shares its damping lies on the arc of the rail.
            is_on_arc: !matches!(damped, Damped::Alone),
        };
        let is_deep = self.search.contacts.iter().any(|c| c.penetration > MAX_STRIP_DEPTH);
        if models.strip_solver.is_some() && !is_deep {
            let (search, probes) = (&self.search, &mut self.probes);
            let deviations = self.deviations.as_ref();
            return strip_contact::add(search, probes, deviations, &forces, models, output, work);
        }
        let is_boundary = models.normal == NormalModel::BoundaryElement && models.uneven.is_none();
        if is_boundary && !self.search.contacts.is_empty() {
            let search = &self.search;
            let added = boundary_contact::add(&self.rail, search, &forces, models, output, work);
            match added {
                Some(fallbacks) => return left_out + fallbacks,
                None => left_out += 1,
            }
        }
        for index in 0..self.search.contacts.len() {
            let contact = self.search.contacts[index];
            let mut separation = LineSeparation::new(&line, &self.rail, contact);
            self.search.refine_probes(&contact, &mut separation);
            models.strips.clear();
            let even_radius = line.wheel_point(contact.u).section_radius;
            let lifting = separation.lifting();
            let radius = lifting.map_or_else(
                || {
                    RailOutline::at_rest(&self.rail).radius_along(
                        even_radius,
                        contact.rail_s,
                        MIN_CURVATURE_SHARE,
                    )
                },
                |lifting| local_radius(even_radius, &lifting, separation.at(contact.u).x),
            );
            let problem = NormalProblem {
                approach: contact.penetration,
                radius,
                contact_modulus: models.material.contact_modulus,
                contact_u: contact.u,
                lateral_curvature: line.curvature(contact.u) + self.rail.curvature(contact.rail_s),
                rule: &models.rule,
                elements: models.elements,
            };
            let probes = &self.search.probes[contact.probes[0]..contact.probes[1]];
            let uneven = models.uneven.as_mut().filter(|_| models.normal != NormalModel::Hertz);
            let mut slopes = [0.0; 2];
            let no_room = if let (Some(uneven), Some(lifting)) = (uneven, &lifting) {
                let no_room = uneven.solve(
                    &problem,
                    models.virtual_penetration,
                    &mut separation,
                    lifting,
                    probes,
                    &mut models.strips,
                );
                slopes = uneven.slopes;
                no_room
            } else {
                if let Some(lifting) = &lifting {
                    slopes = lifting.deviations.slopes(separation.at(contact.u).x);
                }
                normal::solve(
                    models.normal,
                    models.virtual_penetration,
                    models.shape_fit,
                    &problem,
                    &mut separation,
                    probes,
                    &mut models.strips,
                )
            };
            left_out += no_room as u64;
            left_out += forces(contact, slopes, Damped::Alone).add_forces(
                &mut separation,
                models,
                output,
                work,
            );
        }
        left_out
    }
}

/// Radius of relative curvature along the track at the place `x` of first touch, for a wheel whose
/// even section has `radius` [m].
fn local_radius(radius: f64, lifting: &Lifting, x: f64) -> f64 {
    let [_, _, curvature] = lifting.deviations.nearness(x);
    let even = 1.0 / radius;
    1.0 / (even - lifting.share * curvature).max(MIN_CURVATURE_SHARE * even)
}
