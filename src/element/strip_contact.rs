//! The strip model on a wheel and a rail: all places where they overlap are one problem.
//!
//! The overlap is taken along the local normal, the distance of the contact line from the nearest point of the rail, and the
//! coordinate across is the arc along the rail. No contact frame is chosen beforehand, so that nothing changes over when another
//! place becomes the deepest, or when overlaps join or part. Each loaded zone then gets its frame from its own load.

use super::contact_forces::{ContactForces, Damped};
use super::models::Models;
use super::output::Output;
use super::strip_damping::StripDamping;
use super::work::Work;
use crate::geometry::contact::Contact;
use crate::geometry::contact_line::{ContactLine, LinePoint};
use crate::geometry::contact_search::ContactSearch;
use crate::geometry::line_separation::LineSeparation;
use crate::geometry::longitudinal::Longitudinal;
use crate::geometry::placed_rail::PlacedRail;
use crate::geometry::rail_outline::RailOutline;
use crate::geometry::separation::Probe;
use crate::geometry::varying_rail::{Along, VaryingRail};
use crate::math::dual::Dual;
use crate::math::real::Real;
use crate::normal::strips_on_grid::{
    Line, LinePlace, NEAR, OverlapLine, Place, STATION, walk_across,
};

/// Depth up to which strips are pressed [m]: beyond, at a hundred times the load of a wheel, normals of a gauge corner have crossed, and the strips of a
/// virtual penetration carry on.
pub(super) const MOST_STRIP_DEPTH: f64 = 1e-2;
/// Least curvature along the track over that of the even wheel: in a trough that is hollow even for the wheel there is no Hertzian
/// ellipse.
pub(super) const LEAST_CURVATURE_SHARE: f64 = 0.02;
/// Last Newton step towards a nearest point [m]: the error is of second order in it.
const NEAREST: f64 = 1e-8;

/// Overlap of a wheel's contact line with a rail along the local normals.
struct LocalLine<'a> {
    line: &'a ContactLine<'a>,
    rail: &'a PlacedRail,
    /// Parameter of the line and of the rail at the last place, and derivative of the one by the other.
    near: [f64; 3],
    /// Deepest penetration of all contacts [m].
    depth: f64,
}

impl<'a> LocalLine<'a> {
    fn new(line: &'a ContactLine<'a>, rail: &'a PlacedRail, contact: &Contact) -> Self {
        Self { line, rail, near: [contact.u, contact.rail_s, 1.0], depth: contact.penetration }
    }

    /// The line of all contacts of a `search`, of which there is at least one.
    fn of(line: &'a ContactLine<'a>, rail: &'a PlacedRail, search: &ContactSearch) -> Self {
        let depth = search.contacts.iter().map(|c| c.penetration).fold(0.0, f64::max);
        Self { depth, ..Self::new(line, rail, &search.contacts[0]) }
    }

    /// The point of the wheel at parameter `u` that is nearest to the rail along the track, and the derivative of its (y, z).
    fn point(&self, u: f64) -> (LinePoint, [f64; 2]) {
        match self.line.deviations() {
            None => self.line.even_with_derivative(u),
            Some(deviations) => {
                let (point, derivative, _) = self.line.lifted_with_derivative(u, deviations);
                (point, derivative)
            }
        }
    }

    /// Place along the track and cosine of the lean at parameter `s` of a rail that varies along it; the place `x` of the contact line on others.
    fn met(&self, s: f64, x: f64) -> [f64; 2] {
        let Some(varying) = self.rail.variation() else { return [x, 1.0] };
        let Along { ahead, lean, .. } = varying.along(s);
        [x + ahead, 1.0 / lean.hypot(1.0)]
    }

    /// Radius of the section of wheel and rail together at parameter `u`, along the rows of a rail that varies, whose corrugation is bridged as on an even rail [m].
    fn varying_radius(&mut self, u: f64, varying: &VaryingRail) -> f64 {
        let even = self.line.wheel_point(u).section_radius;
        let place = self.place(u);
        let along = varying.along(place.y);
        let bridged = varying.bridged(place.x, self.bridge(even));
        let [share, _] = place.tangent;
        radius_on_rows(even, &Along { curvature: along.curvature + share * bridged, ..along })
    }

    /// Distance to either side over which waves along the track are bridged by a wheel whose even section has the radius `even`: over the length that a ball of it touches
    /// along, to the station at which strips meet them [m].
    fn bridge(&self, even: f64) -> f64 {
        STATION * (even * self.depth).sqrt()
    }

    /// Radius of the section along x of wheel and rail together at parameter `u`, with their deviations over the length of the [`bridge`](Self::bridge) [m].
    #[cold]
    fn uneven_radius(&self, u: f64, deviations: &Longitudinal) -> f64 {
        let even = self.line.wheel_point(u).section_radius;
        let (at, _, radius) = self.line.lifted_with_derivative(u, deviations);
        let share = radius * deviations.mean_curvature(radius, at.x, self.bridge(even));
        even / share.max(LEAST_CURVATURE_SHARE)
    }
}

impl LocalLine<'_> {
    /// The place whose nearest point of the rail has the parameter `y`, and its point (y, z) [m]: where the line crosses the normal of the
    /// rail, looked for from the parameter `guess`. A little beyond its end the rail goes on as it does before. Nothing where the wheel ends, or a body is bent more than the other one is far.
    fn on_normal(&mut self, y: f64, guess: f64) -> Option<(LinePlace, [f64; 2])> {
        let [start, end] = self.line.range();
        let on = self.rail.curve().at(y);
        let along = |v: [f64; 2]| v[0] * on.first[0] + v[1] * on.first[1];
        let mut u = guess;
        for _ in 0..MOST_CROSSINGS {
            if !(u > start && u < end) {
                return None;
            }
            let (at, derivative) = self.point(u);
            let to = [at.point[0] - on.point[0], at.point[1] - on.point[1]];
            let rate = along(derivative);
            if rate < LEAST_RATE {
                return None;
            }
            let step = -along(to) / rate;
            if step.abs() <= NEAR {
                let speed = along(on.first);
                let bending = to[0] * on.second[0] + to[1] * on.second[1];
                let slowness = 1.0 / speed.sqrt();
                let tangent = on.first.map(|first| first * slowness);
                let away = [tangent[1], -tangent[0]];
                let up = |v: [f64; 2]| v[0] * away[0] + v[1] * away[1];
                let dy = rate / (speed - bending);
                if !(speed - bending > LEAST_STRAIGHTNESS * speed && dy > LEAST_RATE) {
                    return None;
                }
                let overlap_slope = -up(derivative);
                let point = [0, 1].map(|i| at.point[i] + step * derivative[i]);
                u += step;
                self.near = [u, y, dy];
                // The overlap along the normal that leans with the rail.
                let [x, cosine] = self.met(y, at.x);
                let overlap = cosine * (overlap_slope * step - up(to));
                let overlap_slope = cosine * overlap_slope;
                let place = LinePlace { u, y, dy, overlap, overlap_slope, x, tangent };
                return Some((place, point));
            }
            u += step;
        }
        None
    }
}

impl Line for LocalLine<'_> {
    fn place(&mut self, u: f64) -> LinePlace {
        let [start, end] = self.line.range();
        let u = u.clamp(start, end);
        let (at, derivative) = self.point(u);
        let [near_u, near_s, rate] = self.near;
        // Far from the last place the guess may be anywhere.
        let guess = if (u - near_u).abs() < FAR {
            near_s + rate * (u - near_u)
        } else {
            self.rail.coarse_nearest(at.point)
        };
        let nearest = self.rail.nearest(at.point, guess, NEAREST);
        let along = |v: [f64; 2]| v[0] * derivative[0] + v[1] * derivative[1];
        let tangent = nearest.tangent;
        let dy = (nearest.ratio * along(tangent)).max(LEAST_RATE);
        self.near = [u, nearest.s, dy];
        let away = [tangent[1], -tangent[0]];
        let [x, cosine] = self.met(nearest.s, at.x);
        LinePlace {
            u,
            y: nearest.s,
            dy,
            overlap: -cosine * nearest.distance,
            overlap_slope: -cosine * along(away),
            x,
            tangent,
        }
    }

    fn radius(&mut self, u: f64) -> f64 {
        if let Some(varying) = self.rail.variation() {
            return self.varying_radius(u, varying);
        }
        match self.line.deviations() {
            None => self.line.wheel_point(u).section_radius,
            Some(deviations) => self.uneven_radius(u, deviations),
        }
    }

    fn across(&mut self, y: f64, guess: f64) -> LinePlace {
        match self.on_normal(y, guess) {
            Some((place, _)) => place,
            None => walk_across(self, y, guess),
        }
    }
}

/// Radius of the section of wheel and rail together along the rows of a rail that varies, for a wheel whose even section has the radius `even` [m].
fn radius_on_rows<T: Real>(even: T, along: &Along<T>) -> T {
    // The wheel's circle is as round along the lean as it is along the track.
    let share = even * along.curvature * along.shortening() + 1.0;
    even / (share / (along.drift * along.drift + 1.0)).at_least(LEAST_CURVATURE_SHARE)
}

/// Distance along the contact line beyond which a nearest point is looked for anew [m].
const FAR: f64 = 8e-3;
/// Least rate at which the nearest point moves with the contact line: where bodies end it may stand still.
const LEAST_RATE: f64 = 0.05;
/// Most points tried to find the one on a normal.
const MOST_CROSSINGS: usize = 6;
/// Least share of the distance from the centre of curvature of the rail.
const LEAST_STRAIGHTNESS: f64 = 0.2;

/// Solves for all zones of one rail into `models.rail_strips`; returns how many found no room.
pub fn solve(
    line: &ContactLine,
    rail: &PlacedRail,
    search: &ContactSearch,
    probes: &mut Vec<Probe>,
    models: &mut Models,
) -> usize {
    probes.clear();
    for contact in search.contacts.iter() {
        let own = &search.probes[contact.probes[0]..contact.probes[1]];
        for probe in own {
            // Contacts that were split at a ridge share it.
            let known = probes.last().is_some_and(|last| last.u >= probe.u);
            if !known && probes.len() < probes.capacity() {
                probes.push(Probe { u: probe.u, f: probe.f - contact.penetration });
            }
        }
    }
    let Models { strip_solver, rail_strips, material, .. } = models;
    rail_strips.clear();
    let mut local = LocalLine::of(line, rail, search);
    let modulus = material.contact_modulus;
    strip_solver
        .as_mut()
        .map_or(0, |solver| solver.solve(&mut local, probes, 0.0, modulus, rail_strips))
}

/// Adds the forces of all zones of one rail to `output`, each as a contact of `forces`; returns how many zones found no room or fell back to a simpler model.
pub fn add<'a>(
    search: &ContactSearch,
    probes: &mut Vec<Probe>,
    deviations: Option<&Longitudinal>,
    forces: &impl Fn(Contact, [f64; 2], Damped<f64>) -> ContactForces<'a>,
    models: &mut Models,
    output: &mut Output,
    work: &mut Work,
) -> u64 {
    let Some(&first) = search.contacts.first() else { return 0 };
    let of_rail = forces(first, [0.0; 2], Damped::Alone);
    let ContactForces { input, line, rail, frame, .. } = &of_rail;
    let placed = rail.rail;
    let mut left_out = solve(line, placed, search, probes, models) as u64;
    output.normal_residual = output.normal_residual.max(models.normal_residual());
    let wheel = &input.wheel;
    let speeds = [wheel.velocity[0], wheel.pitch_rate * line.nominal_radius()];
    let damping = StripDamping {
        motion: &of_rail.motion(),
        frame,
        whole: whole(models, search),
        deviations: deviations.map(|deviations| (deviations, speeds)),
        rail: *rail,
        forward: speeds[0],
        around: Some(line).filter(|line| line.varies_around()),
    };
    for zone in 0..models.rail_strips.zones.len() {
        let TakenZone { contact, load_factor, resultant_share } =
            take_zone(line, placed, search, zone, &damping, models);
        let mut separation = LineSeparation::new(line, placed, contact);
        let forces = forces(contact, [0.0; 2], Damped::By(load_factor));
        let forces = ContactForces { resultant_share, ..forces };
        left_out += forces.add(&mut separation, models, output, work);
    }
    left_out
}

/// A zone in a frame of its own.
pub struct TakenZone<T = f64> {
    /// The frame, and how deep the zone is.
    pub contact: Contact<T>,
    /// Its load with damping over that without [-].
    pub load_factor: T,
    /// See [`ContactForces::resultant_share`].
    pub resultant_share: T,
}

/// Load of all zones and deepest penetration of all contacts [N, m].
fn whole(models: &Models, search: &ContactSearch) -> [f64; 2] {
    let deepest = search.contacts.iter().map(|c| c.penetration).fold(0.0, f64::max);
    [models.rail_strips.load(), deepest]
}

/// Moves zone number `index` of the rail to `models.strips`, with its `damping`, in a frame of its own: through the centroid of its load, its
/// normal along the resultant.
fn take_zone(
    line: &ContactLine,
    rail: &PlacedRail,
    search: &ContactSearch,
    index: usize,
    damping: &StripDamping,
    models: &mut Models,
) -> TakenZone {
    let zone = models.rail_strips.zones[index];
    let contact = Contact {
        u: models.rail_strips.u[zone.first],
        rail_s: models.rail_strips.y[zone.first],
        penetration: 0.0,
        origin: [0.0; 2],
        tangent: [0.0; 2],
        probes: [0, 0],
    };
    let mut local = LocalLine::new(line, rail, &contact);
    let place = |u, y| {
        if let Some((LinePlace { tangent, overlap, .. }, point)) = local.on_normal(y, u) {
            return (point, tangent, overlap);
        }
        let LinePlace { tangent, overlap, .. } = local.place(u);
        (line.at(u).point, tangent, overlap)
    };
    let taken = zone_in_frame(index, damping, models, place);
    let deepest = deepest_within(search, &models.strips.u);
    let deepest = deepest.map_or(0.0, |contact| contact.penetration);
    let penetration = taken.contact.penetration.max(deepest);
    TakenZone { contact: Contact { penetration, ..taken.contact }, ..taken }
}

/// The deepest contact between the outermost strips of a zone, which have the parameters `u`, if there is one.
fn deepest_within<'a, T: Real>(search: &'a ContactSearch, u: &[T]) -> Option<&'a Contact> {
    let ends = [u.first()?.value(), u.last()?.value()];
    let inside = search.contacts.iter().filter(|c| c.u >= ends[0] && c.u <= ends[1]);
    inside.max_by(|a, b| a.penetration.total_cmp(&b.penetration))
}

/// As [`take_zone`] with derivatives where the numbers have them; `place` gives point, unit tangent and overlap at a parameter of the line and
/// a coordinate across.
fn zone_in_frame<T: Real>(
    index: usize,
    damping: &StripDamping<T>,
    models: &mut Models<T>,
    mut place: impl FnMut(T, T) -> ([T; 2], [T; 2], T),
) -> TakenZone<T> {
    let Models { strips, rail_strips: all, damping: coefficient, .. } = models;
    strips.clear();
    let mut zone = all.zones[index];
    let range = zone.first..zone.first + zone.count;
    let zero = T::from(0.0);
    let (mut sum, mut tangent, mut origin) = (zero, [zero; 2], [zero; 2]);
    let mut penetration = zero;
    for j in range {
        let (point, direction, overlap) = place(all.u[j], all.y[j]);
        let at = [all.x[j], all.y[j], all.u[j]];
        let factor = damping.factor(*coefficient, at, point, direction, overlap);
        let pressure = all.pressure[j] * factor;
        let load = all.half_length[j] * all.width[j] * pressure;
        sum += load;
        for axis in 0..2 {
            tangent[axis] += load * direction[axis];
            origin[axis] += load * point[axis];
        }
        penetration = penetration.max(overlap);
        strips.y.push(all.y[j]);
        strips.width.push(all.width[j]);
        strips.x.push(all.x[j]);
        strips.half_length.push(all.half_length[j]);
        strips.pressure.push(pressure);
        strips.u.push(all.u[j]);
    }
    let (area, load) = (zone.area, zone.load);
    zone.first = 0;
    strips.summarise(&mut zone);
    let load_factor = if load > 0.0 { zone.load / load } else { T::from(1.0) };
    (zone.area, zone.load) = (area, load);
    let resultant = tangent[0].hypot(tangent[1]);
    let center = zone.y;
    // Normals that diverge carry less together.
    let resultant_share = if sum > 0.0 { resultant / sum } else { zero };
    for (y, pressure) in strips.y.iter_mut().zip(strips.pressure.iter_mut()) {
        *y -= center;
        *pressure /= load_factor;
    }
    zone.y = zero;
    strips.zones.push(zone);
    let contact = Contact {
        u: zone.u,
        rail_s: center,
        penetration,
        origin: origin.map(|o| o / sum.at_least(f64::MIN_POSITIVE)),
        tangent: tangent.map(|t| t / resultant.at_least(f64::MIN_POSITIVE)),
        probes: [0, 0],
    };
    TakenZone { contact, load_factor, resultant_share }
}

/// Overlap along the local normals of a line that moves: found by plain numbers, and moved from there.
struct MovingLocal<'a, T> {
    line: &'a ContactLine<'a, T>,
    rail: &'a RailOutline<'a, T>,
    found: LocalLine<'a>,
}

impl<T: Real> OverlapLine<T> for MovingLocal<'_, T> {
    fn at(&mut self, y: T, guess: f64) -> Place<T> {
        let Some((LinePlace { u, .. }, _)) = self.found.on_normal(y.value(), guess) else {
            // Where a body ends nothing moves.
            let LinePlace { u, overlap, x, tangent, .. } = self.found.across(y.value(), guess);
            let tangent = tangent.map(T::from);
            return Place { u: u.into(), overlap: overlap.into(), x: x.into(), tangent };
        };
        let on = self.rail.at(y);
        let to = |point: [T; 2]| [point[0] - on.point[0], point[1] - on.point[1]];
        let along = |v: [T; 2]| v[0] * on.first[0] + v[1] * on.first[1];
        let (at, derivative) = self.line.even_with_derivative(u.into());
        let u = T::moving(u, -along(to(at.point)) / along(derivative).value());
        let at = self.line.even_at(u);
        let slowness =
            T::from(1.0) / (on.first[0] * on.first[0] + on.first[1] * on.first[1]).sqrt();
        let tangent = on.first.map(|first| first * slowness);
        let to = to(at.point);
        let overlap = to[1] * tangent[0] - to[0] * tangent[1];
        let Some(along) = self.rail.along(y) else {
            return Place { u, overlap, x: at.x, tangent };
        };
        let cosine = T::from(1.0) / along.lean.hypot(1.0.into());
        Place { u, overlap: cosine * overlap, x: at.x + along.ahead, tangent }
    }

    fn section_radius(&mut self, u: T) -> T {
        let even = self.line.wheel_point(u).section_radius;
        if !self.rail.varies() {
            return even;
        }
        let s = self.found.place(u.value()).y;
        let (at, on) = (self.line.even_at(u).point, self.rail.at(s.into()));
        let to = [at[0] - on.point[0], at[1] - on.point[1]];
        let along = |v: [T; 2]| v[0] * on.first[0] + v[1] * on.first[1];
        let slope = along(on.first) - (to[0] * on.second[0] + to[1] * on.second[1]);
        let s = T::moving(s, along(to) / slope.value());
        self.rail.along(s).map_or(even, |along| radius_on_rows(even, &along))
    }
}

/// Zones of one rail with derivatives, into `models.rail_strips`, from the last solution in `found`; false where the equations have none.
pub fn follow<const N: usize>(
    line: &ContactLine<Dual<N>>,
    rail: &RailOutline<Dual<N>>,
    search: &ContactSearch,
    found: &mut Models,
    models: &mut Models<Dual<N>>,
) -> bool {
    let Some(solver) = &mut found.strip_solver else { return false };
    let value = line.value();
    let found = LocalLine::of(&value, rail.rail, search);
    let mut local = MovingLocal { line, rail, found };
    let modulus = models.material.contact_modulus;
    let Models { strip_follower, rail_strips, .. } = models;
    rail_strips.clear();
    // There is one where there is a solver.
    let Some(follower) = strip_follower else { return false };
    follower.follow(solver, &mut local, modulus, rail_strips)
}

/// As [`take_zone`], with derivatives.
pub fn take_moving_zone<T: Real>(
    line: &ContactLine<T>,
    rail: &RailOutline<T>,
    search: &ContactSearch,
    index: usize,
    damping: &StripDamping<T>,
    models: &mut Models<T>,
) -> TakenZone<T> {
    let value = line.value();
    let found = LocalLine::of(&value, rail.rail, search);
    let mut local = MovingLocal { line, rail, found };
    let taken = zone_in_frame(index, damping, models, |u, y| {
        let Place { u, tangent, overlap, .. } = local.at(y, u.value());
        (line.even_at(u).point, tangent, overlap)
    });
    let deepest = deepest_within(search, &models.strips.u);
    let deepest = deepest.and_then(|contact| contact.moving(line, rail));
    let own = taken.contact.penetration;
    let penetration = deepest.map_or(own, |contact| own.max(contact.penetration));
    TakenZone { contact: Contact { penetration, ..taken.contact }, ..taken }
}
