//! Planar contact problems: a separation of profiles and a wheel radius instead of a placed wheel
//! and rail.
//!
//! The undeformed distance is f(y) + x²/(2R). Forces are those on the wheel, creepages those of the
//! wheel against the rail at the origin of the separation: w_x = ξ - φ y, w_y = η + φ x. Each problem
//! is one of steady rolling; a [`TransientContact`] is followed through a series of them.

mod case;
mod line;
mod pressed_contact;
mod transient;
mod unlike;

pub use case::{Indentation, PlanarCase};
pub use pressed_contact::{LAW_PARAMETERS, PressedContact};
pub use transient::{History, StepMotion, TransientContact, TransientField, TransientResult};

pub use crate::friction::StripFriction;
pub use crate::normal::{NormalModel, ShapeFit};
pub use crate::tangential::fastsim::TractionBound;
pub use crate::tangential::field::{Adherence, ContactField};
pub use crate::tangential::flash_temperature::FlashTemperature;
pub use crate::tangential::friction_law::FrictionLaw;
pub use crate::tangential::{Flexibilities, TangentialModel};

use crate::boundary_element::grid::Grid;
use crate::boundary_element::unlike::UnlikeSolution;
use crate::error::ContactError;
use crate::kinematics::creepage::bounded;
use crate::material::MaterialPair;
use crate::math::quadrature::GaussLegendre;
use crate::math::root::bracketed;
use crate::normal::least_energy::{MIN_STRIPS, StripSolver, solve_in_frame};
use crate::normal::{self, NormalProblem, Strips, strips_of_rule};
use crate::tangential::{CreepForce, Creepage, RollingState, RollingZone, Settings, Tangential};
use case::MAX_APPROACH;
use line::PlanarLine;

/// Solution of a planar contact problem; forces on the wheel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct PlanarResult {
    /// Normal force [N].
    pub normal_force: f64,
    /// Greatest pressure [Pa].
    pub max_pressure: f64,
    /// Area of all zones [m²].
    pub area: f64,
    /// Greatest length of a zone along x [m].
    pub length: f64,
    /// Distance from the leftmost to the rightmost edge [m].
    pub width: f64,
    /// Longitudinal creep force [N].
    pub fx: f64,
    /// Lateral creep force [N].
    pub fy: f64,
    /// Moment about the normal through the origin of the separation [N m].
    pub mz: f64,
    /// Number of separate zones.
    pub patches: usize,
    /// Whether a solver fell back to a simpler model.
    pub fallback: bool,
}

/// Most zones of one problem.
const MAX_ZONES: usize = 64;

/// Solves a planar contact problem.
///
/// # Errors
/// A value of the case that is not admitted, or a load that no approach up to 20 mm carries.
pub fn solve(case: &PlanarCase) -> Result<PlanarResult, ContactError> {
    let pressed = press_together(case)?;
    let mut result = summarise(case, &pressed);
    result.fallback |= pressed.left_out > 0;
    Ok(result)
}

/// Pressure and tractions element by element on the wheel, one field for each zone, or for all of
/// them where the normal model has boundary elements; y from the origin of the separation. See
/// [`ContactField`].
///
/// # Errors
/// As [`solve`].
pub fn fields(case: &PlanarCase) -> Result<Vec<ContactField>, ContactError> {
    let Pressed { strips, material, contact_y, coupled, .. } = press_together(case)?;
    if let Some((grid, solution)) = coupled {
        let grid = Grid { left_y: grid.left_y + contact_y, ..grid };
        return Ok(vec![unlike::field(&grid, solution)]);
    }
    let mut tangential = tangential_of(case);
    let zones = if strips.elements.is_some() { 1 } else { strips.zones.len() };
    let fields = strips.zones.iter().take(zones).map(|zone| {
        let state = rolling_state(case, contact_y + zone.y);
        let mut field = tangential.field(zone, &strips, &material, &state);
        field.grid.left_y += contact_y;
        field
    });
    Ok(fields.collect())
}

/// The normal solution of a case.
struct Pressed {
    strips: Strips,
    material: MaterialPair,
    /// y of the contact point [m].
    contact_y: f64,
    /// Zones that found no room, or solutions that fell back.
    left_out: usize,
    /// Elements, pressure and tractions of bodies of unlike materials, where these are found together.
    coupled: Option<(Grid, UnlikeSolution)>,
}

fn press_together(case: &PlanarCase) -> Result<Pressed, ContactError> {
    case.check()?;
    let mut line = PlanarLine::new(case.separation);
    let rule = GaussLegendre::new(strips_of_rule(case.strips));
    let material = MaterialPair::new(case.wheel_material, case.rail_material);
    let mut strips =
        Strips::with_capacity(MAX_ZONES, MAX_ZONES * strips_of_rule(case.strips).max(MIN_STRIPS));
    let mut solver =
        (case.normal_model == NormalModel::Strips).then(|| StripSolver::new(case.strips));
    let (least, mut left_out) = (line.least, 0);
    // `approach` counts from first touch.
    let (contact_u, curvature) = (line.contact, line.curve.at(line.contact).second[1]);
    let problem_at = |approach: f64| NormalProblem {
        approach,
        radius: case.radius,
        contact_modulus: material.contact_modulus,
        contact_u,
        lateral_curvature: curvature,
        rule: &rule,
        elements: case.elements,
    };
    let mut press = |approach: f64| {
        strips.clear();
        if approach > 0.0 {
            let problem = problem_at(approach);
            let probes = std::mem::take(&mut line.probes);
            let (model, epsilon) = (case.normal_model, case.virtual_penetration);
            let fit = case.shape_fit;
            left_out = match &mut solver {
                Some(solver) => solve_in_frame(solver, &problem, &mut line, &probes, &mut strips),
                None => {
                    normal::solve(model, epsilon, fit, &problem, &mut line, &probes, &mut strips)
                }
            };
            line.probes = probes;
        }
        strips.load()
    };
    let approach = match case.indentation {
        Indentation::Approach(approach) => approach - least,
        Indentation::Load(load) if load > 0.0 => {
            // Between elements the load is not smooth to rounding.
            let boundary = case.normal_model == NormalModel::BoundaryElement;
            let found = if boundary { ELEMENT_APPROACH } else { 1e-16 };
            approach_for(load, found, &mut press)?
        }
        Indentation::Load(_) => 0.0,
    };
    press(approach);
    let give_friction = |strips: &mut Strips| {
        let Strips { y, friction, .. } = strips;
        friction.extend(y.iter().map_while(|y| friction_at(case, contact_u + y)));
    };
    give_friction(&mut strips);
    let mut coupled = None;
    if unlike::is_coupled(case, &material) {
        let problem = problem_at(approach);
        coupled = unlike::couple(case, &problem, &mut line, &material, &mut strips);
        give_friction(&mut strips);
        left_out += coupled.iter().filter(|(_, own)| !own.converged).count();
    }
    Ok(Pressed { contact_y: contact_u, strips, material, left_out, coupled })
}

/// Friction of a strip at `y` [m], where strips have their own.
fn friction_at(case: &PlanarCase, y: f64) -> Option<StripFriction> {
    let all = case.friction_across;
    let next = all.partition_point(|(at, _)| *at <= y);
    let Some((end, after)) = all.get(next) else { return all.last().map(|(_, own)| *own) };
    let Some((start, before)) = next.checked_sub(1).map(|k| &all[k]) else { return Some(*after) };
    Some(before.towards(after, (y - start) / (end - start)))
}

/// Bracket of the approach of boundary elements under a given load [m].
const ELEMENT_APPROACH: f64 = 1e-11;

/// The approach from first touch, to `found` [m], at which `press` gives `load`; where the load
/// jumps past it, the place of the jump.
fn approach_for(
    load: f64,
    found: f64,
    press: &mut impl FnMut(f64) -> f64,
) -> Result<f64, ContactError> {
    let (mut low, mut low_load, mut high) = (0.0, 0.0, 1e-6);
    let mut high_load = press(high);
    while high_load < load {
        if high >= MAX_APPROACH {
            return Err(ContactError::bad_value(
                "load",
                load,
                "at most what the profiles carry 20 mm below first touch",
            ));
        }
        (low, low_load) = (high, high_load);
        high = (2.0 * high).min(MAX_APPROACH);
        high_load = press(high);
    }
    Ok(bracketed((low, low_load - load), (high, high_load - load), found, |a| press(a) - load))
}

fn summarise(case: &PlanarCase, pressed: &Pressed) -> PlanarResult {
    let &Pressed { ref strips, ref material, contact_y, ref coupled, .. } = pressed;
    let mut result = without_creep_forces(strips);
    let mut tangential = tangential_of(case);
    if let Some((grid, solution)) = coupled {
        [result.fx, result.fy, result.mz] = unlike::forces(grid, solution, contact_y);
        return result;
    }
    let laws = strips.zones.iter().map(|zone| {
        let state = rolling_state(case, contact_y + zone.y);
        tangential.under_law(zone, strips, material, &state)
    });
    let laws: Vec<_> = laws.collect();
    if laws.iter().any(|law| !law.state.creepage.is_zero()) {
        let zones = strips.zones.iter().zip(&laws);
        let zones = zones.map(|(zone, law)| RollingZone::flat(zone, strips, law));
        let mut forces = vec![CreepForce::default(); laws.len()];
        let convergence = tangential.roll(zones, |n, j, force| {
            forces[n].add(&strips.zones[n], strips, j, &force);
        });
        result.fallback |= convergence.fallbacks > 0;
        for (zone, force) in strips.zones.iter().zip(forces) {
            result.fx += force.longitudinal;
            result.fy += force.lateral;
            result.mz += force.spin_moment - (contact_y + zone.y) * force.longitudinal;
        }
    }
    result
}

/// What the zones of `strips` add up to, without creep forces.
fn without_creep_forces(strips: &Strips) -> PlanarResult {
    let mut result = PlanarResult { patches: strips.zones.len(), ..PlanarResult::default() };
    let (mut left, mut right) = (f64::INFINITY, f64::NEG_INFINITY);
    for zone in strips.zones.iter() {
        result.normal_force += zone.load;
        result.max_pressure = result.max_pressure.max(zone.max_pressure);
        result.area += zone.area;
        result.length = result.length.max(zone.length);
        let edges = strips.edges(zone);
        left = left.min(edges[0]);
        right = right.max(edges[1]);
    }
    result.width = (right - left).max(0.0);
    result
}

fn tangential_of(case: &PlanarCase) -> Tangential {
    let settings = Settings {
        flexibilities: case.flexibilities,
        bound: case.bound,
        elements_along: case.elements_along,
        elements: case.elements,
        strips: strips_of_rule(case.strips),
    };
    Tangential::new(case.tangential_model, &settings)
        .with_laws([case.friction_law, case.gauge_face_law])
        .with_flash_temperature(case.flash_temperature)
}

/// How a zone with its centroid at `y` rolls.
fn rolling_state(case: &PlanarCase, y: f64) -> RollingState {
    let [longitudinal, lateral, spin] = case.creepage.map(bounded);
    RollingState {
        creepage: Creepage { longitudinal: bounded(longitudinal - spin * y), lateral, spin },
        forward_share: 1.0,
        friction: case.friction,
        load_factor: 1.0,
        speed: case.speed,
    }
}
