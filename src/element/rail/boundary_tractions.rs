//! Tractions of all zones of a rail together, on boundary elements; of bodies of unlike materials
//! with the pressure that goes with them.
//!
//! Each element slips rigidly by the motion of the wheel against the rail at its own place. Where
//! bodies are of unlike materials ([`unlike`](crate::boundary_element::unlike)) an element may come
//! into contact that had no pressure, so that slip and friction are those of all that overlap, a
//! row between zones as the nearest of them.
//!
//! **Moment.** Tractions move the load of such bodies ahead of where the normals of a round wheel
//! meet the axle, or behind it. As the normal force has no part along an even rail, it has a moment
//! about the axle there: that of the pressures over those of like bodies, element by element. It
//! takes up the power that friction loses and creep forces do not bring. Rails and wheels that
//! vary have it from where their load acts.

mod remembered;

use nalgebra::Vector3;

use super::overlapping::{Overlapping, for_each_element};
use crate::boundary_element::friction::Tractions as ElementTractions;
use crate::boundary_element::unlike::{Press, UnlikeProblem};
use crate::element::contact::contact_setup::{ContactSetup, Damped};
use crate::element::contact::given_tractions::GivenTractions;
use crate::element::contact::models::Models;
use crate::element::contact::rail_walk::RailPlace;
use crate::element::contact::tractions::Tractions;
use crate::element::parameters::CreepageModel;
use crate::geometry::contacts::contact::Contact;
use crate::kinematics::creepage::{ContactAxes, Creepage, RelativeMotion};
use crate::math::real::Real;
use crate::normal::Strips;
use crate::normal::rail_elements::RailElements;
use crate::tangential::boundary_element::{rolling_tractions, rolling_unlike};
use crate::tangential::{Convergence, Rolling, TangentialModel, UnderLaw};

/// How a zone of the rail rolls: its frame, creepage and state, for the tractions of all.
#[derive(Clone, Copy, Debug)]
pub(super) struct ZoneState {
    pub contact: Contact,
    /// See [`ContactSetup::resultant_share`].
    pub resultant_share: f64,
    pub damped: Damped<f64>,
    /// Creepage at the centroid of the load, friction, damping and speed, under the laws of
    /// friction.
    pub law: UnderLaw,
    /// Centroid of the load along the track and on the arc [m].
    pub centre: [f64; 2],
}

/// What the slip of elements is taken from.
#[derive(Clone, Copy)]
enum Slipped<'a> {
    /// Rigid slip: what the deformation of like bodies adds to it takes no power in all.
    Rigid,
    /// All of it, of bodies of unlike materials, whose pressure alone would be that [Pa].
    Whole(&'a [f64]),
    /// The work of friction on each element in a step over the distance that creepages refer to
    /// [J/m].
    Step(&'a [f64]),
}

/// Tractions under way with the share of the direction in which they roll.
type Shared = (f64, ElementTractions);

/// Pressure and tractions of bodies of unlike materials.
pub(super) struct Coupled {
    /// Pressure of each element [Pa].
    pub pressure: Vec<f64>,
    /// See [`RailElements::residual`].
    pub residual: f64,
    pub tractions: Vec<Shared>,
}

/// Friction and rigid slip of elements.
struct Slipping {
    /// Coefficient of friction, with that by which damping raises the load [-].
    friction: Vec<f64>,
    creepage: Vec<Creepage>,
}

impl Slipping {
    fn rigid(&self) -> Vec<[f64; 2]> {
        self.creepage.iter().map(|own| [own.longitudinal, own.lateral]).collect()
    }
}

/// How a wheel rolls on a rail, for its tractions.
pub(super) struct RailRolling<'a> {
    /// Of any of the zones.
    forces: &'a ContactSetup<'a>,
    motion: RelativeMotion,
}

impl<'a> RailRolling<'a> {
    pub fn of(forces: &'a ContactSetup<'a>) -> Self {
        Self { forces, motion: forces.motion() }
    }

    /// Point of the wheel opposite to an element, in the track frame.
    fn in_track(&self, element: &Overlapping) -> Vector3<f64> {
        let point = element.row.wheel_point(element.x, element.overlap);
        self.forces.frame.point(point, element.x)
    }

    /// Axes of the wheel opposite: where a rail rises, the bodies close along the track, which is
    /// no slip across.
    fn axes(&self, element: &Overlapping) -> ContactAxes {
        let frame = &self.forces.frame;
        let [_, y, z] = element.growth;
        let size = y.hypotenuse(z);
        let [tangent, normal] = [[z, -y], [y, z]].map(|v| frame.direction(v.map(|c| c / size)));
        ContactAxes::along(frame.along(), tangent, normal).leaning(element.row.course.lean)
    }

    /// Friction and rigid slip of the elements `asked` for, which are in the zones of `zone_of_row`.
    fn slipping(
        &self,
        elements: &RailElements,
        zones: &[ZoneState],
        zone_of_row: &[Option<usize>],
        is_curved: bool,
        asked: impl Fn(usize, usize) -> bool,
    ) -> Slipping {
        let (forces, grid) = (self.forces, &elements.grid);
        let mut slipping = Slipping {
            friction: vec![0.0; grid.len()],
            creepage: vec![Creepage::default(); grid.len()],
        };
        for_each_element(elements, asked, |element| {
            let Some(z) = zone_of_row[element.j] else { return };
            let ZoneState { law, centre, .. } = &zones[z];
            let state = &law.state;
            // Of a row of elements, each of which has a place on the arc of its own.
            let place = || RailPlace::at(&forces.rail, grid.y(element.j));
            let own = forces.friction.and_then(|_| forces.strip_friction(&place(), element.x));
            let friction = own.map_or(state.friction, |own| own.under(&law.factors));
            slipping.friction[element.k] = friction * state.load_factor;
            slipping.creepage[element.k] = if is_curved {
                let axes = self.axes(&element);
                // As if the wheel were laid flat along the track, as its contact is: the point of
                // its outline at the place of the element.
                let at = element.row.wheel_point(element.x, element.row.overlap);
                let at = forces.frame.point(at, element.x);
                self.motion.creepage(at, &axes, state.speed)
            } else {
                let Creepage { longitudinal, lateral, spin } = state.creepage;
                let (x, y) = (element.x - centre[0], grid.y(element.j) - centre[1]);
                let longitudinal = longitudinal - spin * y;
                Creepage { longitudinal, lateral: lateral + spin * x, spin }
            };
        });
        slipping
    }

    /// Friction and rigid slip of the elements that carry pressure.
    fn loaded(&self, elements: &RailElements, zones: &[ZoneState], models: &Models) -> Slipping {
        let zone_of_row = zone_of_row(&models.rail_strips);
        let is_curved = models.creepage == CreepageModel::Curved;
        let asked = |_, k: usize| elements.pressure[k] > 0.0;
        self.slipping(elements, zones, &zone_of_row, is_curved, asked)
    }

    /// Tractions of all zones together, one for each of `zones`; nothing where there is nothing to
    /// compute or no solution was found.
    pub fn tractions(
        &self,
        elements: &RailElements,
        zones: &[ZoneState],
        models: &Models,
    ) -> Option<Vec<GivenTractions>> {
        if models.tangential.model() != TangentialModel::BoundaryElement {
            return None;
        }
        let heaviest = heaviest(zones, models)?;
        let slipping = self.loaded(elements, zones, models);
        let (bound, rigid) = (bound(&slipping, elements), slipping.rigid());
        if bound.iter().all(|&g| g <= 0.0) || rigid.iter().flatten().all(|w| *w == 0.0) {
            return None;
        }
        let mut found = Vec::new();
        for (rolling, share) in directions(heaviest) {
            let material = &heaviest.law.material;
            let solution = rolling_tractions(&elements.grid, material, &bound, &rigid, rolling);
            if !solution.converged {
                return None;
            }
            found.push((share, solution));
        }
        Some(self.sums_of(&slipping, elements, zones, models, &found, Slipped::Rigid))
    }

    /// Whether there is friction where the bodies press on each other.
    pub fn has_friction(
        &self,
        elements: &RailElements,
        zones: &[ZoneState],
        models: &Models,
    ) -> bool {
        let slipping = self.loaded(elements, zones, models);
        bound(&slipping, elements).iter().any(|&g| g > 0.0)
    }

    /// Pressure and tractions of bodies of unlike materials; nothing where these do not settle, or
    /// not on the elements there are.
    pub fn coupled(
        &self,
        elements: &RailElements,
        zones: &[ZoneState],
        models: &Models,
    ) -> Option<Coupled> {
        let heaviest = heaviest(zones, models)?;
        let mut zone_of_row = zone_of_row(&models.rail_strips);
        for (j, zone) in zone_of_row.iter_mut().enumerate() {
            *zone = zone.or_else(|| nearest_zone(elements.grid.y(j), &models.rail_strips));
        }
        let is_curved = models.creepage == CreepageModel::Curved;
        let slipping = self.slipping(elements, zones, &zone_of_row, is_curved, |_, _| true);
        let problem = UnlikeProblem {
            grid: &elements.grid,
            material: &models.material,
            shearing: &heaviest.law.material,
            separation: &elements.distances(),
            press: Press::Approach(elements.approach),
            friction: &slipping.friction,
            rigid: &slipping.rigid(),
        };
        let mut found = Coupled {
            pressure: vec![0.0; elements.grid.len()],
            residual: 0.0,
            tractions: Vec::new(),
        };
        for (rolling, share) in directions(heaviest) {
            let own = rolling_unlike(&problem, rolling);
            if !own.converged {
                return None;
            }
            for (sum, p) in found.pressure.iter_mut().zip(&own.pressure.pressure) {
                *sum += share * p;
            }
            found.residual = found.residual.max(own.residual);
            found.tractions.push((share, own.tractions));
        }
        (!elements.grid.is_loaded_at_the_border(&found.pressure)).then_some(found)
    }

    /// Sums of `tractions` over each of `zones`, of bodies of unlike materials, whose pressure alone
    /// would be `alone`.
    pub fn sums(
        &self,
        elements: &RailElements,
        zones: &[ZoneState],
        models: &Models,
        tractions: &[Shared],
        alone: &[f64],
    ) -> Vec<GivenTractions> {
        let slipping = self.loaded(elements, zones, models);
        self.sums_of(&slipping, elements, zones, models, tractions, Slipped::Whole(alone))
    }

    fn sums_of(
        &self,
        slipping: &Slipping,
        elements: &RailElements,
        zones: &[ZoneState],
        models: &Models,
        tractions: &[Shared],
        slipped: Slipped<'_>,
    ) -> Vec<GivenTractions> {
        let (all, area) = (&models.rail_strips, elements.grid.element_area());
        let zone_of_row = zone_of_row(all);
        let strip_of_row = all.elements.as_deref().map_or(&[][..], |field| &field.strip_of_row);
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
        let is_loaded = |_, k: usize| elements.pressure[k] > 0.0;
        for_each_element(elements, is_loaded, |element| {
            let Some(z) = zone_of_row[element.j] else { return };
            let (own, mean) = (&slipping.creepage[element.k], &mut found[z].creepage);
            let weight = element.load / all.zones[z].load;
            mean.longitudinal += weight * own.longitudinal;
            mean.lateral += weight * own.lateral;
            mean.spin += weight * own.spin;
        });
        for (share, solution) in tractions {
            let convergence = Convergence::to(solution.residual);
            for GivenTractions { convergence: own, .. } in &mut found {
                *own = own.and(convergence);
            }
            for_each_element(elements, is_loaded, |element| {
                let j = element.j;
                let (Some(z), Some(strip)) = (zone_of_row[j], strip_of_row[j]) else { return };
                let k = element.k;
                let [px, py] = [solution.x[k], solution.y[k]].map(|p| share * area * p);
                let axes = self.axes(&element);
                let force = axes.longitudinal * px + axes.lateral * py;
                let dissipation = match slipped {
                    Slipped::Step(work) => work[k],
                    Slipped::Whole(_) => -(px * solution.slip_x[k] + py * solution.slip_y[k]),
                    Slipped::Rigid => {
                        let own = &slipping.creepage[k];
                        -(px * own.longitudinal + py * own.lateral)
                    }
                };
                let slip_area = if solution.slips[k] { share * area } else { 0.0 };
                let GivenTractions { tractions, strips, .. } = &mut found[z];
                tractions.force += force;
                tractions.moment += self.in_track(&element).cross(&force);
                tractions.dissipation += dissipation;
                tractions.slip_area += slip_area;
                let strip = &mut strips[strip - all.zones[z].first];
                *strip = [strip[0] + dissipation, strip[1] + slip_area];
            });
        }
        let is_round = !self.forces.rail.varies() && !self.forces.line.varies_around();
        if let (Slipped::Whole(alone), true) = (slipped, is_round) {
            let frame = &self.forces.frame;
            for_each_element(
                elements,
                |_, _| true,
                |element| {
                    let Some(z) = zone_of_row[element.j] else { return };
                    let more = area * (elements.pressure[element.k] - alone[element.k]);
                    let force = frame.direction(element.row.normal())
                        * (-more * zones[z].law.state.load_factor);
                    let arm = frame.along() * (element.x - element.row.x);
                    found[z].tractions.moment += arm.cross(&force);
                },
            );
        }
        found
    }
}

/// Greatest traction of each element [Pa].
fn bound(slipping: &Slipping, elements: &RailElements) -> Vec<f64> {
    slipping.friction.iter().zip(&elements.pressure).map(|(f, p)| f * p).collect()
}

fn heaviest<'a>(zones: &'a [ZoneState], models: &Models) -> Option<&'a ZoneState> {
    let load = |z: usize| models.rail_strips.zones[z].load;
    (0..zones.len()).max_by(|&a, &b| load(a).total_cmp(&load(b))).map(|z| &zones[z])
}

/// The directions in which the wheel rolls, with their shares.
fn directions(zone: &ZoneState) -> impl Iterator<Item = (Rolling, f64)> {
    let forward = zone.law.state.forward_share;
    let both = [(Rolling::Forward, forward), (Rolling::Backward, 1.0 - forward)];
    both.into_iter().filter(|&(_, share)| share > 0.0)
}

/// The zone to which each row of elements belongs, of those that carry pressure.
fn zone_of_row(all: &Strips) -> Vec<Option<usize>> {
    let of_strip = |j: usize| all.zones.iter().position(|zone| zone.range().contains(&j));
    let strip_of_row = all.elements.as_deref().map_or(&[][..], |field| &field.strip_of_row);
    strip_of_row.iter().map(|strip| strip.and_then(of_strip)).collect()
}

/// The zone nearest to the place `y` of the arc.
fn nearest_zone(y: f64, all: &Strips) -> Option<usize> {
    let away = |z: usize| {
        let zone = &all.zones[z];
        let [first, last] = [zone.first, zone.first + zone.count - 1].map(|j| all.y[j]);
        (first - y).max(y - last)
    };
    (0..all.zones.len()).min_by(|&a, &b| away(a).total_cmp(&away(b)))
}
