//! Boundary elements on a wheel and a rail: all overlaps are one problem on the curved surface of
//! the rail.
//!
//! The elements lie on the arc of the rail, each with its own normal, tangent and rigid slip; see
//! [`rail_elements`](crate::normal::rail_elements). Loaded zones get their frames from their own
//! resultants.

use crate::element::contact::contact_setup::{ContactSetup, Damped};
use crate::element::contact::given_tractions::GivenTractions;
use crate::element::contact::models::Models;
use crate::element::contact::rail_walk::RailPlace;
use crate::element::contact::tractions::Tractions;
use crate::element::output::Output;
use crate::element::parameters::CreepageModel;
use crate::element::work::Work;
use crate::geometry::contacts::contact::Contact;
use crate::geometry::contacts::contact_search::ContactSearch;
use crate::geometry::contacts::line_separation::LineSeparation;
use crate::geometry::rail::placed_rail::PlacedRail;
use crate::kinematics::creepage::{ContactAxes, Creepage, RelativeMotion};
use crate::math::real::Real;
use crate::normal::Zone;
use crate::normal::rail_elements::{self, RailElements, Row};
use crate::tangential::boundary_element::rolling_tractions;
use crate::tangential::{Convergence, Rolling, TangentialModel, UnderLaw};

/// Solves for all that the wheel overlaps of `rail` where `search` has found them in contact and
/// adds the forces to `output`; returns how many zones found no room or fell back to a simpler
/// model, and nothing where there is no solution. `forces` brings a contact to forces, with its
/// slopes along the track and the load and penetration that share its stiffness.
pub fn add<'a>(
    rail: &PlacedRail,
    search: &ContactSearch,
    forces: &impl Fn(Contact, [f64; 2], Damped<f64>) -> ContactSetup<'a>,
    models: &mut Models,
    output: &mut Output,
    work: &mut Work,
) -> Option<u64> {
    let line = forces(*search.contacts.first()?, [0.0; 2], Damped::Alone).line;
    let modulus = models.material.contact_modulus;
    let elements = &rail_elements::solve(&line, rail, search, models.elements, modulus)?;
    models.rail_strips.clear();
    let mut left_out = elements.fill(&mut models.rail_strips) as u64;
    output.normal_residual = output.normal_residual.max(elements.residual);
    models.turn_of_normals = models.turn_of_normals.max(elements.turn_of_normals());
    let whole = Damped::Together([models.rail_strips.load(), elements.approach]);
    let (mut contacts, mut states) = (Vec::new(), Vec::new());
    for index in 0..models.rail_strips.zones.len() {
        let (contact, share) = take_zone(elements, rail, index, models);
        let Zone { x, y, .. } = models.rail_strips.zones[index];
        let forces = forces(contact, [0.0; 2], whole);
        let separation = LineSeparation::new(&forces.line, rail, contact);
        forces.fill_friction(&separation, &mut models.strips);
        let state = forces.rolling_state(models);
        let strips = &models.strips;
        let law = models.tangential.under_law(&strips.zones[0], strips, &models.material, &state);
        contacts.push((contact, share));
        states.push(ZoneState { law, centre: [x, y] });
    }
    let found = contacts.first().and_then(|(contact, _)| {
        let forces = forces(*contact, [0.0; 2], whole);
        tractions(elements, &forces, &forces.motion(), &states, models)
    });
    let mut given = found.unwrap_or_default();
    given.reverse();
    for (index, (contact, resultant_share)) in contacts.into_iter().enumerate() {
        take_zone(elements, rail, index, models);
        models.given = given.pop();
        let forces = ContactSetup { resultant_share, ..forces(contact, [0.0; 2], whole) };
        let mut separation = LineSeparation::new(&forces.line, rail, contact);
        left_out += forces.add_forces(&mut separation, models, output, work);
    }
    Some(left_out)
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
    let range = zone.first..zone.first + zone.count;
    let (mut load, mut force, mut moment, mut forward) = (0.0, [0.0; 2], 0.0, 0.0);
    let (mut centre, mut penetration) = ([0.0; 2], 0.0_f64);
    for_each_element(elements, all.elements.as_deref().map(|e| &*e.strip_of_row), |element| {
        if !range.contains(&element.strip) {
            return;
        }
        let [gx, gy, gz] = element.growth;
        let ([y, z], own) = (element.point, element.load);
        load += own;
        forward += own * gx;
        force = [force[0] + own * gy, force[1] + own * gz];
        moment += own * (y * gz - z * gy);
        centre = [centre[0] + own * y, centre[1] + own * z];
        penetration = penetration.max(element.overlap);
    });
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
        strips.y.push(all.y[j] - middle);
        strips.width.push(all.width[j]);
        strips.x.push(all.x[j]);
        strips.half_length.push(all.half_length[j]);
        strips.pressure.push(all.pressure[j]);
        strips.u.push(all.u[j]);
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

/// A loaded element.
struct Loaded<'a> {
    /// Its number.
    k: usize,
    strip: usize,
    row: &'a Row,
    /// Place along the track [m].
    x: f64,
    /// Point (y, z) of the wheel opposite to it [m].
    point: [f64; 2],
    overlap: f64,
    growth: [f64; 3],
    /// [N].
    load: f64,
}

fn for_each_element<'a>(
    elements: &'a RailElements,
    strip_of_row: Option<&[Option<usize>]>,
    mut each: impl FnMut(Loaded<'a>),
) {
    let (grid, area) = (&elements.grid, elements.grid.element_area());
    let Some(strip_of_row) = strip_of_row else { return };
    for (j, (row, strip)) in elements.rows.iter().zip(strip_of_row).enumerate() {
        let (Some(row), Some(strip)) = (row, *strip) else { continue };
        let normal = row.normal();
        for i in 0..grid.along {
            let k = j * grid.along + i;
            let (Some(opposite), p) = (&elements.opposite[k], elements.pressure[k]) else {
                continue;
            };
            if p <= 0.0 {
                continue;
            }
            each(Loaded {
                k,
                strip,
                row,
                x: grid.x(i),
                point: [0, 1].map(|c| row.point[c] + opposite.overlap * normal[c]),
                overlap: opposite.overlap,
                growth: opposite.growth,
                load: area * p,
            });
        }
    }
}

/// How a zone of the rail rolls: its creepage and state, for the tractions of all.
#[derive(Clone, Copy, Debug)]
struct ZoneState {
    /// Creepage at the centroid of the load, friction, damping and speed, under the laws of
    /// friction.
    law: UnderLaw,
    /// Centroid of the load along the track and on the arc [m].
    centre: [f64; 2],
}

/// Tractions of all zones of a rail together, one for each of `zones`; nothing where there is
/// nothing to compute or no solution was found. `forces` is of any of the zones.
fn tractions(
    elements: &RailElements,
    forces: &ContactSetup,
    motion: &RelativeMotion,
    zones: &[ZoneState],
    models: &Models,
) -> Option<Vec<GivenTractions>> {
    if models.tangential.model() != TangentialModel::BoundaryElement {
        return None;
    }
    let all = &models.rail_strips;
    let strip_of_row = all.elements.as_deref().map(|field| &*field.strip_of_row);
    let zone_of_strip = |j: usize| {
        all.zones.iter().position(|zone| (zone.first..zone.first + zone.count).contains(&j))
    };
    let heaviest =
        (0..zones.len()).max_by(|&a, &b| all.zones[a].load.total_cmp(&all.zones[b].load))?;
    let (grid, area) = (&elements.grid, elements.grid.element_area());
    let mut bound = vec![0.0; grid.len()];
    let mut rigid = vec![[0.0; 2]; grid.len()];
    let mut found: Vec<GivenTractions> = zones
        .iter()
        .zip(all.zones.iter())
        .map(|(_, zone)| GivenTractions {
            creepage: Creepage::default(),
            tractions: Tractions::default(),
            convergence: Convergence::default(),
            strips: vec![[0.0; 2]; zone.count],
        })
        .collect();
    let in_track = |element: &Loaded| {
        let point = element.row.wheel_point(element.x, element.overlap);
        forces.frame.point(point, element.x)
    };
    // Of the wheel opposite: where a rail rises, the bodies close along the track, which is no slip
    // across.
    let axes_of = |element: &Loaded| {
        let [_, y, z] = element.growth;
        let size = y.hypotenuse(z);
        let [tangent, normal] =
            [[z, -y], [y, z]].map(|v| forces.frame.direction(v.map(|c| c / size)));
        ContactAxes::along(forces.frame.along(), tangent, normal).leaning(element.row.course.lean)
    };
    // Of a row of elements, each of which has a place on the arc of its own.
    let own_friction =
        |row: usize, x: f64| forces.strip_friction(&RailPlace::at(&forces.rail, grid.y(row)), x);
    for_each_element(elements, strip_of_row, |element| {
        let Some(z) = zone_of_strip(element.strip) else { return };
        let ZoneState { law, centre } = &zones[z];
        let state = &law.state;
        let own = own_friction(element.k / grid.along, element.x);
        let friction = own.map_or(state.friction, |own| own.under(&law.factors));
        bound[element.k] = friction * state.load_factor * elements.pressure[element.k];
        let own = if models.creepage == CreepageModel::Curved {
            let axes = axes_of(&element);
            // As if the wheel were laid flat along the track, as its contact is: the point of its
            // outline at the place of the element.
            let at = element.row.wheel_point(element.x, element.row.overlap);
            let at = forces.frame.point(at, element.x);
            motion.creepage(at, &axes, state.speed)
        } else {
            let Creepage { longitudinal, lateral, spin } = state.creepage;
            let (x, y) = (element.x - centre[0], grid.y(element.k / grid.along) - centre[1]);
            Creepage { longitudinal: longitudinal - spin * y, lateral: lateral + spin * x, spin }
        };
        rigid[element.k] = [own.longitudinal, own.lateral];
        let mean = &mut found[z].creepage;
        let weight = element.load / all.zones[z].load;
        mean.longitudinal += weight * own.longitudinal;
        mean.lateral += weight * own.lateral;
        mean.spin += weight * own.spin;
    });
    if bound.iter().all(|&g| g <= 0.0) || rigid.iter().flatten().all(|w| *w == 0.0) {
        return None;
    }
    let material = zones[heaviest].law.material;
    let forward = zones[heaviest].law.state.forward_share;
    for (rolling, share) in [(Rolling::Forward, forward), (Rolling::Backward, 1.0 - forward)] {
        if share <= 0.0 {
            continue;
        }
        let solution = rolling_tractions(grid, &material, &bound, &rigid, rolling);
        if !solution.converged {
            return None;
        }
        let convergence = Convergence::to(solution.residual);
        for GivenTractions { convergence: own, .. } in &mut found {
            *own = own.and(convergence);
        }
        for_each_element(elements, strip_of_row, |element| {
            let Some(z) = zone_of_strip(element.strip) else { return };
            let k = element.k;
            let [px, py] = [solution.x[k], solution.y[k]].map(|p| share * area * p);
            let axes = axes_of(&element);
            let force = axes.longitudinal * px + axes.lateral * py;
            let dissipation = -(px * rigid[k][0] + py * rigid[k][1]);
            let slip_area = if solution.slips[k] { share * area } else { 0.0 };
            let GivenTractions { tractions, strips, .. } = &mut found[z];
            tractions.force += force;
            tractions.moment += in_track(&element).cross(&force);
            tractions.dissipation += dissipation;
            tractions.slip_area += slip_area;
            let strip = &mut strips[element.strip - all.zones[z].first];
            *strip = [strip[0] + dissipation, strip[1] + slip_area];
        });
    }
    Some(found)
}
