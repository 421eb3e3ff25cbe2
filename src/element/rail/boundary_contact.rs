//! Boundary elements on a wheel and a rail: all overlaps are one problem on the curved surface of
//! the rail.
//!
//! The elements lie on the arc of the rail, each with its own normal, tangent and rigid slip; see
//! [`rail_elements`](crate::normal::rail_elements). Loaded zones get their frames from their own
//! resultants.

use super::boundary_tractions::{RailRolling, ZoneState};
use super::overlapping::for_each_element;
use crate::element::contact::contact_setup::{ContactSetup, Damped};
use crate::element::contact::models::Models;
use crate::element::output::Output;
use crate::element::work::Work;
use crate::geometry::contacts::contact::Contact;
use crate::geometry::contacts::contact_search::ContactSearch;
use crate::geometry::contacts::line_separation::LineSeparation;
use crate::geometry::rail::placed_rail::PlacedRail;
use crate::math::real::Real;
use crate::normal::rail_elements::{self, RailElements};
use crate::normal::{LoadedStrip, Zone};

/// Elements that the grid of like bodies gets more on each side: room for what tractions do.
const ROOM: usize = 2;

/// Solves for all that the wheel overlaps of `rail` where `search` has found them in contact and
/// adds the forces to `output`; returns how many zones found no room or fell back to a simpler
/// model, and nothing where there is no solution. `forces` brings a contact to forces, with the
/// load and penetration that share its stiffness.
pub fn add<'a>(
    rail: &PlacedRail,
    search: &ContactSearch,
    forces: &impl Fn(Contact, Damped<f64>) -> ContactSetup<'a>,
    models: &mut Models,
    output: &mut Output,
    work: &mut Work,
) -> Option<u64> {
    let ContactSetup { line, k, .. } = forces(*search.contacts.first()?, Damped::Alone);
    let modulus = models.material.contact_modulus;
    let is_coupled = models.is_coupled();
    let room = if is_coupled { ROOM } else { 0 };
    let memory = models.memory.as_deref();
    let sized = |wanted| memory.map_or(wanted, |memory| memory.before(k).size_for(wanted));
    let counts = models.elements;
    let mut elements = rail_elements::solve(&line, rail, search, counts, modulus, room, sized)?;
    models.rail_strips.clear();
    let mut left_out = elements.fill(&mut models.rail_strips) as u64;
    let mut zones = rolling_zones(&elements, rail, forces, models);
    let found = if let Some(zone) = zones.first() {
        let setup = forces(zone.contact, zone.damped);
        let rolling = RailRolling::of(&setup);
        let mut coupled = None;
        if is_coupled && rolling.has_friction(&elements, &zones, models) {
            coupled = rolling.coupled(&elements, &zones, models);
            models.is_uncoupled |= coupled.is_none();
            left_out += u64::from(coupled.is_none());
        }
        match coupled {
            None => match models.memory.take() {
                None => rolling.tractions(&elements, &zones, models),
                Some(mut memory) => {
                    let found = rolling.remembered(&elements, &zones, models, &mut memory);
                    models.memory = Some(memory);
                    found
                }
            },
            Some(coupled) => {
                let alone = std::mem::replace(&mut elements.pressure, coupled.pressure);
                elements.residual = coupled.residual;
                models.rail_strips.clear();
                left_out = elements.fill(&mut models.rail_strips) as u64;
                zones = rolling_zones(&elements, rail, forces, models);
                Some(rolling.sums(&elements, &zones, models, &coupled.tractions, &alone))
            }
        }
    } else {
        None
    };
    output.normal_residual = output.normal_residual.max(elements.residual);
    models.turn_of_normals = models.turn_of_normals.max(elements.turn_of_normals());
    let mut given = found.unwrap_or_default();
    given.reverse();
    for (index, ZoneState { contact, resultant_share, damped, .. }) in zones.into_iter().enumerate()
    {
        take_zone(&elements, rail, index, models);
        models.given = given.pop();
        let forces = ContactSetup { resultant_share, ..forces(contact, damped) };
        let mut separation = LineSeparation::new(&forces.line, rail, contact);
        left_out += forces.add_forces(&mut separation, models, output, work);
    }
    Some(left_out)
}

/// How the zones of the rail, which are in `models.rail_strips`, roll.
fn rolling_zones<'a>(
    elements: &RailElements,
    rail: &PlacedRail,
    forces: &impl Fn(Contact, Damped<f64>) -> ContactSetup<'a>,
    models: &mut Models,
) -> Vec<ZoneState> {
    let damped = Damped::Together([models.rail_strips.load(), elements.approach]);
    let mut zones = Vec::new();
    for index in 0..models.rail_strips.zones.len() {
        let (contact, resultant_share) = take_zone(elements, rail, index, models);
        let Zone { x, y, .. } = models.rail_strips.zones[index];
        let forces = forces(contact, damped);
        let separation = LineSeparation::new(&forces.line, rail, contact);
        forces.fill_friction(&separation, &mut models.strips);
        let state = forces.rolling_state(models);
        let strips = &models.strips;
        let law = models.tangential.under_law(&strips.zones[0], strips, &models.material, &state);
        zones.push(ZoneState { contact, resultant_share, damped, law, centre: [x, y] });
    }
    zones
}

/// Moves zone number `index` of the rail to `models.strips`, in a frame of its own: the normal
/// along the resultant of its pressures, the origin where the line of action of that passes through
/// the contact; and the share of [`ContactSetup::resultant_share`].
fn take_zone(
    elements: &RailElements,
    rail: &PlacedRail,
    index: usize,
    models: &mut Models,
) -> (Contact, f64) {
    let Models { strips, rail_strips: all, .. } = models;
    strips.clear();
    let mut zone = all.zones[index];
    let range = zone.range();
    let (mut load, mut force, mut moment, mut forward) = (0.0, [0.0; 2], 0.0, 0.0);
    let (mut centre, mut penetration) = ([0.0; 2], 0.0_f64);
    let strip_of_row = all.elements.as_deref().map_or(&[][..], |field| &field.strip_of_row);
    let strip = |j: usize| strip_of_row.get(j).copied().flatten();
    let is_own = |j: usize| strip(j).is_some_and(|strip| range.contains(&strip));
    for_each_element(
        elements,
        |j, k| is_own(j) && elements.pressure[k] > 0.0,
        |element| {
            let [gx, gy, gz] = element.growth;
            let ([y, z], own) = (element.point, element.load);
            load += own;
            forward += own * gx;
            force = [force[0] + own * gy, force[1] + own * gz];
            moment += own * (y * gz - z * gy);
            centre = [centre[0] + own * y, centre[1] + own * z];
            penetration = penetration.max(element.overlap);
        },
    );
    let size = force[0].hypotenuse(force[1]).max(f64::MIN_POSITIVE);
    let normal = force.map(|f| f / size);
    let tangent = [normal[1], -normal[0]];
    let centre = centre.map(|c| c / load.max(f64::MIN_POSITIVE));
    let arm = moment / size - (centre[0] * normal[1] - centre[1] * normal[0]);
    let middle = zone.y;
    // An even frame does not lean along the track.
    let forward = if rail.variation().is_some() { forward } else { 0.0 };
    let share = size.hypotenuse(forward) / load.max(f64::MIN_POSITIVE);
    for j in range {
        strips.push(LoadedStrip { y: all.y[j] - middle, ..all.strip(j) });
    }
    let contact = Contact {
        u: zone.u,
        rail_s: rail.arcs().parameter(middle).unwrap_or(middle),
        penetration,
        origin: [0, 1].map(|i| centre[i] + arm * tangent[i]),
        tangent,
        probes: [0, 0],
    };
    (zone.first, zone.y) = (0, 0.0);
    strips.zones.push(zone);
    (contact, share)
}
