//! The contact of one wheel with one rail: pose, search, normal and tangential models, forces on both bodies.

use super::contact_forces::ContactForces;
use super::evaluate::Work;
use super::input::Input;
use super::models::Models;
use super::output::Output;
use super::parameters::Parameters;
use super::rail_frame::RailFrame;
use super::strip_contact;
use crate::geometry::clearance::Clearance;
use crate::geometry::contact_line::ContactLine;
use crate::geometry::contact_search::{ContactSearch, MOST_PROBES};
use crate::geometry::line_separation::LineSeparation;
use crate::geometry::placed_rail::PlacedRail;
use crate::geometry::profile::Profile;
use crate::geometry::separation::Probe;
use crate::math::room::Room;
use crate::normal::{self, NormalProblem};

/// One rail and what is prepared for its contact with the wheel.
#[derive(Clone, Debug)]
pub struct RailContact {
    wheel: Profile,
    nominal_radius: f64,
    rail: PlacedRail,
    clearance: Clearance,
    /// Stretches of the contact line that may touch.
    ranges: Room<[f64; 2]>,
    search: ContactSearch,
    /// Distance of the contact line from the rail over all contacts.
    probes: Room<Probe>,
}

/// Most stretches of a contact line that are searched apart from each other.
const MOST_RANGES: usize = 32;

impl RailContact {
    /// Prepares the contact of the wheel with profile `wheel` and a placed rail.
    #[must_use]
    pub fn new(wheel: &Profile, parameters: &Parameters, rail: PlacedRail) -> Self {
        let nominal_radius = parameters.wheel.nominal_radius;
        Self {
            clearance: Clearance::new(&wheel.curve, nominal_radius, rail.curve()),
            ranges: Room::new(MOST_RANGES),
            search: ContactSearch::new(&wheel.curve),
            probes: Room::new(MOST_PROBES),
            wheel: wheel.clone(),
            nominal_radius,
            rail,
        }
    }

    /// Whether any contact appears for `input` (right side) with rail number `k`.
    pub fn touches(&mut self, k: usize, input: &Input) -> bool {
        let pose = RailFrame::new(&self.rail, &input.rails[k]).pose(&input.wheel);
        self.clearance.ranges(&pose, &mut self.ranges);
        let line = ContactLine::new(&self.wheel.curve, self.nominal_radius, &pose);
        self.search.search(&line, &self.rail, &self.ranges);
        !self.search.contacts.is_empty()
    }

    /// A marker height from which a wheel with the roll of `input` (right side) is surely clear of rail number `k` [m].
    pub fn clear_height(&self, k: usize, input: &Input) -> f64 {
        let frame = RailFrame::new(&self.rail, &input.rails[k]);
        let pose = frame.pose(&input.wheel);
        // A rolled rail turns the height about its marker.
        frame.marker.z + self.clearance.clear_height(pose.roll)
            - pose.marker[1].abs() * frame.roll.abs()
    }

    /// Adds the forces of rail number `k` to `output`; returns how many contacts or zones found no room.
    pub fn evaluate(
        &mut self,
        k: usize,
        input: &Input,
        models: &mut Models,
        output: &mut Output,
        work: &mut Work,
    ) -> u64 {
        let frame = RailFrame::new(&self.rail, &input.rails[k]);
        let pose = frame.pose(&input.wheel);
        self.clearance.ranges(&pose, &mut self.ranges);
        if self.ranges.is_empty() {
            work.lifted += 1;
            return 0;
        }
        let line = ContactLine::new(&self.wheel.curve, self.nominal_radius, &pose);
        let before = (self.search.evaluations, self.search.left_out);
        self.search.search(&line, &self.rail, &self.ranges);
        work.searches += 1;
        work.distances += self.search.evaluations - before.0;
        let mut left_out = self.search.left_out - before.1;
        let forces = |contact, damped_with| ContactForces {
            k,
            input,
            frame,
            line,
            rail: &self.rail,
            contact,
            damped_with,
        };
        if models.strip_solver.is_some() && !self.search.contacts.is_empty() {
            if strip_contact::solve(&line, &self.rail, &self.search, &mut self.probes, models) {
                let whole = strip_contact::whole(models, &self.search);
                for zone in 0..models.rail_strips.zones.len() {
                    let contact = strip_contact::take_zone(&line, &self.rail, zone, models);
                    let mut separation = LineSeparation::new(&line, &self.rail, contact);
                    forces(contact, Some(whole)).add(&mut separation, models, output, work);
                }
                return left_out;
            }
            left_out += 1;
        }
        for index in 0..self.search.contacts.len() {
            let contact = self.search.contacts[index];
            let mut separation = LineSeparation::new(&line, &self.rail, contact);
            self.search.refine_probes(&contact, &mut separation);
            models.strips.clear();
            let problem = NormalProblem {
                approach: contact.penetration,
                radius: line.wheel_point(contact.u).section_radius,
                contact_modulus: models.material.contact_modulus,
                contact_u: contact.u,
                lateral_curvature: line.curvature(contact.u) + self.rail.curvature(contact.rail_s),
                rule: &models.rule,
            };
            left_out += normal::solve(
                models.normal,
                models.virtual_penetration,
                models.shape_fit,
                &problem,
                &mut separation,
                &self.search.probes[contact.probes[0]..contact.probes[1]],
                &mut models.strips,
            ) as u64;
            forces(contact, None).add(&mut separation, models, output, work);
        }
        left_out
    }
}
