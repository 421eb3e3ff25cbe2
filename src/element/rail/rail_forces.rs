//! From the contacts that the search has found on one rail to forces: normal and tangential models,
//! one contact after the other or all together.

use super::boundary_contact;
use super::flattened::FlatContact;
use super::local_line::MIN_CURVATURE_SHARE;
use super::rail_contact::{RailContact, STEEPEST, varying};
use super::strip_contact::{self, MAX_STRIP_DEPTH};
use crate::element::contact::contact_setup::{ContactSetup, ContactWaves, Damped};
use crate::element::contact::models::Models;
use crate::element::input::Input;
use crate::element::output::Output;
use crate::element::work::Work;
use crate::geometry::contacts::contact::Contact;
use crate::geometry::contacts::contact_search::ContactSearch;
use crate::geometry::contacts::line_separation::LineSeparation;
use crate::geometry::contacts::waves_along::WavesAlong;
use crate::geometry::rail::placed_rail::PlacedRail;
use crate::geometry::rail::rail_outline::RailOutline;
use crate::geometry::wheel::contact_line::ContactLine;
use crate::normal::{self, Descent, NormalModel, NormalProblem, Slope};

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
        let frame = self.frame(k, input);
        let line =
            ContactLine::new(&self.wheel.curve, self.nominal_radius, &frame.pose(&input.wheel));
        let line = varying(line, self.around.as_deref());
        // An overlap belongs to the deepest of the contacts that reach it.
        let mut order: Vec<usize> = (0..self.search.contacts.len()).collect();
        let depth = |i: usize| self.search.contacts[i].penetration;
        order.sort_by(|&a, &b| depth(b).total_cmp(&depth(a)));
        let mut taken = Vec::<[f64; 2]>::new();
        let mut flat = vec![None; order.len()];
        for i in order {
            let contact = self.search.contacts[i];
            if taken.iter().any(|&[from, to]| contact.u >= from && contact.u <= to) {
                continue;
            }
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
                waves: None,
                damped: Damped::Alone,
                resultant_share: 1.0,
                ahead: None,
                friction: self.friction.as_ref(),
                is_on_arc: false,
            };
            let found = forces.flattened(&mut separation, radius, minimum_speed, &mut taken);
            flat[i] = Some(found);
        }
        flat.into_iter().flatten().collect()
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
        // What the search has found at a pose stays.
        let is_same = models.descent.is_some_and(|descent| descent.pose.is_same());
        if is_same && self.search.contacts.is_empty() {
            return 0;
        }
        if !is_same && !self.search_contacts(k, input) {
            work.lifted += 1;
            return 0;
        }
        work.searches += u64::from(!is_same);
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

    /// How far the wheel of `input` has to go down for the contacts with rail number `k` to have
    /// about the vertical force `load`, if friction bore nothing: where strips are pressed by the
    /// overlap as it is, else by contacts by themselves, of the normal model or of Piotrowski and Kik
    /// where that solves for a whole rail. Where the way is not longer than `longest` the forces of
    /// contacts by themselves at its end are added to `output`.
    ///
    /// # Errors
    /// How far the wheel has to be lifted off, where that is more than `most_lift`; where nothing
    /// touches about how far it is from touching, negative [m].
    pub fn way_down(
        &mut self,
        k: usize,
        input: &Input,
        [load, most_lift, longest]: [f64; 3],
        models: &mut Models,
        output: &mut Output,
        work: &mut Work,
    ) -> Result<Descent, f64> {
        let lift = self.lift(k, input).map_err(|apart| -apart)?;
        work.searches += 1;
        if lift > most_lift {
            return Err(lift);
        }
        let frame = self.frame(k, input);
        let line =
            ContactLine::new(&self.wheel.curve, self.nominal_radius, &frame.pose(&input.wheel));
        let line = varying(line, self.around.as_deref());
        let normal = match models.normal {
            NormalModel::Strips | NormalModel::BoundaryElement => NormalModel::PiotrowskiKik,
            by_contacts => by_contacts,
        };
        let (rail, search) = (&self.rail, &mut self.search);
        let mut descent = Descent { down: frame.down(), ..Descent::to(load) };
        let mut last = None;
        if models.strip_solver.is_some() {
            strip_contact::guess(&line, rail, search, &mut self.probes, models, &mut descent);
        } else {
            descent.run(|descent, _| {
                let (mut reached, mut deepest) = (0.0, 0.0_f64);
                for index in 0..search.contacts.len() {
                    let cosine = descent.cosine(search.contacts[index].tangent);
                    let deeper = descent.way * cosine;
                    let pressed =
                        press(&line, rail, search, index, (normal, Rule::Coarse), deeper, models);
                    reached += models.strips.load() * cosine;
                    deepest =
                        deepest.max((pressed.contact.penetration + deeper) / cosine.max(STEEPEST));
                    last = Some(pressed);
                }
                (reached, Slope::Depth(deepest))
            });
        }
        if descent.way.abs() > longest {
            return Ok(descent);
        }
        // The zones of a single contact may be there.
        let mut there = last.filter(|_| search.contacts.len() == 1);
        for index in 0..search.contacts.len() {
            let deeper = descent.way * descent.cosine(search.contacts[index].tangent);
            let pressed = there.take().unwrap_or_else(|| {
                press(&line, rail, search, index, (normal, Rule::Coarse), deeper, models)
            });
            let forces = ContactSetup {
                k,
                input,
                frame,
                line,
                rail: RailOutline::at_rest(rail),
                contact: pressed.contact,
                waves: pressed.waves,
                damped: Damped::Alone,
                resultant_share: 1.0,
                ahead: None,
                friction: self.friction.as_ref(),
                is_on_arc: false,
            };
            let mut separation = pressed.separation;
            models.swap_guessed();
            forces.add_forces(&mut separation, models, output, work);
            models.swap_guessed();
        }
        Ok(descent)
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
        let frame = self.frame(k, input);
        let line =
            ContactLine::new(&self.wheel.curve, self.nominal_radius, &frame.pose(&input.wheel));
        let line = varying(line, self.around.as_deref());
        let mut left_out = 0;
        let forces = |contact, damped| ContactSetup {
            k,
            input,
            frame,
            line,
            rail: RailOutline::at_rest(&self.rail),
            contact,
            waves: None,
            damped,
            resultant_share: 1.0,
            ahead: None,
            friction: self.friction.as_ref(),
            // What shares its damping lies on the arc of the rail.
            is_on_arc: !matches!(damped, Damped::Alone),
        };
        let is_deep = self.search.contacts.iter().any(|c| c.penetration > MAX_STRIP_DEPTH);
        if models.strip_solver.is_some() && !is_deep {
            let (search, probes) = (&self.search, &mut self.probes);
            return strip_contact::add(search, probes, &forces, models, output, work);
        }
        let is_boundary = models.normal == NormalModel::BoundaryElement;
        if is_boundary && !self.search.contacts.is_empty() {
            let search = &self.search;
            let added = boundary_contact::add(&self.rail, search, &forces, models, output, work);
            if let Some(fallbacks) = added {
                return left_out + fallbacks;
            }
            left_out += 1;
            models.is_uncoupled |= models.is_coupled();
            if let Some(memory) = &mut models.memory {
                memory.stay(k);
            }
        }
        for index in 0..self.search.contacts.len() {
            let (rail, search) = (&self.rail, &mut self.search);
            let pressed =
                press(&line, rail, search, index, (models.normal, Rule::Asked), 0.0, models);
            let Pressed { contact, mut separation, waves, no_room } = pressed;
            left_out += no_room as u64;
            let forces = ContactSetup { waves, ..forces(contact, Damped::Alone) };
            left_out += forces.add_forces(&mut separation, models, output, work);
        }
        left_out
    }
}

/// How many strips a zone has.
#[derive(Clone, Copy, Debug)]
enum Rule {
    /// As many as the model is asked for.
    Asked,
    /// Enough for a guess.
    Coarse,
}

/// One contact with its loaded zones in `models.strips`.
struct Pressed<'a> {
    contact: Contact,
    separation: LineSeparation<'a>,
    /// See [`ContactSetup::waves`].
    waves: Option<ContactWaves<'a>>,
    /// Zones that found no room.
    no_room: usize,
}

/// Solves for the zones of contact number `index` of `search` into `models.strips` by the model
/// `normal` with the strips of `rule`, and so much more approach than its penetration, `deeper` [m].
fn press<'a>(
    line: &'a ContactLine,
    rail: &'a PlacedRail,
    search: &mut ContactSearch,
    index: usize,
    (normal, rule): (NormalModel, Rule),
    deeper: f64,
    models: &mut Models,
) -> Pressed<'a> {
    let contact = search.contacts[index];
    let mut separation = LineSeparation::new(line, rail, contact);
    search.refine_probes(&contact, &mut separation);
    models.strips.clear();
    let even_radius = line.wheel_point(contact.u).section_radius;
    let outline = RailOutline::at_rest(rail);
    let radius = outline.radius_along(even_radius, contact.rail_s, MIN_CURVATURE_SHARE);
    let problem = NormalProblem {
        approach: contact.penetration + deeper,
        radius,
        contact_modulus: models.material.contact_modulus,
        contact_u: contact.u,
        lateral_curvature: line.curvature(contact.u) + rail.curvature(contact.rail_s),
        rule: match rule {
            Rule::Asked => &models.rule,
            Rule::Coarse => &models.coarse,
        },
        elements: models.elements,
    };
    let probes = &search.probes[contact.probes[0]..contact.probes[1]];
    let uneven = models.uneven.as_mut().filter(|_| normal != NormalModel::Hertz);
    let waves = uneven.zip(WavesAlong::of(line, rail, &contact, MIN_CURVATURE_SHARE));
    let depth = models.virtual_penetration;
    let strips = &mut models.strips;
    let (no_room, waves) = if let Some((uneven, waves)) = waves {
        let (no_room, steeper) =
            uneven.solve(&problem, depth, &mut separation, &waves, probes, strips);
        (no_room, Some(ContactWaves { section: waves.section, steeper }))
    } else {
        let fit = models.shape_fit;
        (normal::solve(normal, depth, fit, &problem, &mut separation, probes, strips), None)
    };
    Pressed { contact, separation, waves, no_room }
}
