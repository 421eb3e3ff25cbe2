//! The strip model on a wheel and a rail with derivatives: the solution of plain numbers, moved.

use super::cut_strip::{self, CutStrip};
use super::local_line::{LocalLine, MIN_RATE, radius_on_rows, section_over_waves, whole_strip};
use super::local_place::LocalPlace;
use super::strip_damping::StripDamping;
use super::taken_zone::{TakenZone, deepest_within, of_last_zone, zone_in_frame};
use crate::element::contact::models::Models;
use crate::geometry::contacts::contact::Contact;
use crate::geometry::contacts::contact_search::ContactSearch;
use crate::geometry::rail::rail_outline::{RailOutline, StripOverWaves};
use crate::geometry::rail::varying_rail::VaryingRail;
use crate::geometry::wheel::contact_line::ContactLine;
use crate::math::real::Real;
use crate::normal::least_energy::{LinePlace, OverlapLine, Section, StripNumber};

/// Overlap along the local normals of a line that moves: found by plain numbers, and moved from
/// there.
struct MovingLocal<'a, T> {
    line: &'a ContactLine<'a, T>,
    rail: &'a RailOutline<'a, T>,
    found: LocalLine<'a>,
    /// Deepest penetration of all contacts [m].
    depth: T,
}

/// Deepest penetration of all contacts of a `search` as it moves; at rest where a body ends there
/// [m].
fn depth<T: Real>(line: &ContactLine<T>, rail: &RailOutline<T>, search: &ContactSearch) -> T {
    let deepest = search.contacts.iter().max_by(|a, b| a.penetration.total_cmp(&b.penetration));
    deepest.map_or(T::from(0.0), |found| {
        found.moving(line, rail).map_or(found.penetration.into(), |moving| moving.penetration)
    })
}

impl<T: Real> MovingLocal<'_, T> {
    /// The place at parameter `u`, its strip as if the rail had no end.
    fn whole_place(&mut self, u: T) -> LinePlace<T> {
        let found = self.found.whole_place(u.value());
        let (at, derivative) = self.line.with_derivative(u);
        let on = self.rail.at(found.y.into());
        let to = |point: [T; 2]| [at.point[0] - point[0], at.point[1] - point[1]];
        let dot = |a: [T; 2], b: [T; 2]| a[0] * b[0] + a[1] * b[1];
        // The nearest point moves so that it stays the nearest one; the end of a body does not.
        let bending = dot(on.first, on.first) - dot(to(on.point), on.second);
        let away = dot(to(on.point), on.first);
        let y = if away.value().abs() < AT_END * bending.value() {
            T::moving(found.y, away / bending.value())
        } else {
            T::from(found.y)
        };
        let on = self.rail.at(y);
        let bending = dot(on.first, on.first) - dot(to(on.point), on.second);
        let slowness = T::from(1.0) / dot(on.first, on.first).sqrt();
        let tangent = on.first.map(|first| first * slowness);
        let down = |v: [T; 2]| v[1] * tangent[0] - v[0] * tangent[1];
        let (overlap, overlap_slope) = (down(to(on.point)), down(derivative));
        let dy = (dot(derivative, on.first) / bending).at_least(MIN_RATE);
        let x = self.rail.strip_place(y, at.x);
        LinePlace { u, y, dy, overlap, overlap_slope, x, tangent }
    }

    /// What the end of a rail that varies leaves of the strip at a `place`.
    fn cut(&self, place: &LinePlace<T>) -> Option<CutStrip<T>> {
        let ends = self.rail.ends(place.y)?.map(|end| end - place.x);
        let gap = self.rail.along(place.y)?.gap;
        cut_strip::cut(self.depth, gap, self.whole_section(place).radius, ends)
    }

    /// The strip at `place` as far as the rail goes.
    fn on_rail(&self, place: LinePlace<T>) -> LinePlace<T> {
        self.cut(&place).map_or(place, |cut| cut.of(place))
    }

    /// The strip at `place` over waves of either body, if there are any.
    fn over_waves(&self, place: &LinePlace<T>) -> Option<StripOverWaves<T>> {
        if !self.rail.has_waves() {
            return None;
        }
        let even = self.line.wheel_point(place.u).section_radius;
        let at = [place.y, place.x, place.overlap];
        self.rail.over_waves(at, |along| radius_on_rows(even, along))
    }

    /// The section at a `place` as if the rail had no end.
    fn whole_section(&self, place: &LinePlace<T>) -> Section<T> {
        if let Some(strip) = self.over_waves(place) {
            return section_over_waves(&strip, place);
        }
        let even = self.line.wheel_point(place.u).section_radius;
        let along = self.rail.along(place.y);
        Section::even(along.map_or(even, |along| radius_on_rows(even, &along)))
    }
}

impl<T: Real> OverlapLine<T> for MovingLocal<'_, T> {
    fn place(&mut self, u: T) -> LinePlace<T> {
        let place = self.whole_place(u);
        self.on_rail(place)
    }

    fn section(&mut self, at: &LinePlace<T>) -> Section<T> {
        // Where an end is near, without what that leaves out.
        let is_near_end = self.rail.rail.variation().is_some_and(VaryingRail::is_near_end);
        let place = if is_near_end { self.whole_place(at.u) } else { *at };
        let section = self.whole_section(&place);
        let share = self.cut(&place).map_or(T::from(1.0), |cut| cut.radius_share);
        Section { radius: section.radius * share, ..section }
    }

    fn body_end(&mut self, u: f64) -> T {
        let [start, end] = self.line.range();
        if u <= start || u >= end {
            // That of the wheel.
            return T::from(u);
        }
        // The place that stays opposite to the end of the rail.
        let LinePlace { y, dy, .. } = self.whole_place(T::from(u));
        T::moving(u, (T::from(y.value()) - y) / dy.value())
    }
}

/// How far a point may be from the normal of the rail that it was found on [m].
const AT_END: f64 = 1e-6;

/// Zones of one rail with derivatives, into `models.rail_strips`, from the last solution in
/// `found`; false where the equations have none.
pub fn follow<T: StripNumber>(
    line: &ContactLine<T>,
    rail: &RailOutline<T>,
    search: &ContactSearch,
    found: &mut Models,
    models: &mut Models<T>,
) -> bool {
    let Some(solver) = &mut found.strip_solver else { return false };
    let value = line.value();
    let found = LocalLine::of(&value, rail.rail, search);
    let mut local = MovingLocal { line, rail, found, depth: depth(line, rail, search) };
    let modulus = models.material.contact_modulus;
    let Models { strip_follower, rail_strips, .. } = models;
    rail_strips.clear();
    // There is one where there is a solver.
    let Some(follower) = strip_follower else { return false };
    follower.follow(solver, &mut local, modulus, rail_strips)
}

/// As [`strip_contact`](super::strip_contact) takes a zone, with derivatives.
pub fn take_zone<T: Real>(
    line: &ContactLine<T>,
    rail: &RailOutline<T>,
    search: &ContactSearch,
    index: usize,
    damping: &StripDamping<T>,
    models: &mut Models<T>,
) -> TakenZone<T> {
    let value = line.value();
    let found = LocalLine::of(&value, rail.rail, search);
    let local = MovingLocal { line, rail, found, depth: depth(line, rail, search) };
    let taken = zone_in_frame(index, damping, models, |[u, y]| {
        let at = line.at(u);
        let strip = local.on_rail(whole_strip(at, rail, [u, y]));
        let over_waves = local.over_waves(&strip);
        LocalPlace::of(&at, &strip, over_waves.as_ref(), rail.along(y))
    });
    let deepest = deepest_within(search, of_last_zone(&models.strips));
    let deepest = deepest.and_then(|contact| contact.moving(line, rail));
    let own = taken.contact.penetration;
    let penetration = deepest.map_or(own, |contact| own.max(contact.penetration));
    TakenZone { contact: Contact { penetration, ..taken.contact }, ..taken }
}
