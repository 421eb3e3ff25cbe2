//! The strip model on a wheel and a rail with derivatives: the solution of plain numbers, moved.

use super::cut_strip::{self, CutStrip};
use super::local_line::{LocalLine, radius_on_rows};
use super::strip_damping::StripDamping;
use super::taken_zone::{TakenZone, deepest_within, zone_in_frame};
use crate::element::contact::models::Models;
use crate::geometry::contacts::contact::Contact;
use crate::geometry::contacts::contact_search::ContactSearch;
use crate::geometry::rail::rail_outline::RailOutline;
use crate::geometry::wheel::contact_line::ContactLine;
use crate::math::dual::Dual;
use crate::math::real::Real;
use crate::normal::strips_on_grid::{Line, LinePlace, OverlapLine, Place};

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
    /// The place at coordinate `y` across, its strip as if the rail had no end.
    fn whole_place(&mut self, y: T, guess: f64) -> Place<T> {
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

    /// What the end of a rail that varies leaves of the strip at a `place` with coordinate `y`.
    fn cut(&self, y: T, place: &Place<T>) -> Option<CutStrip<T>> {
        let ends = self.rail.ends(y)?.map(|end| end - place.x);
        let along = self.rail.along(y)?;
        let even = self.line.wheel_point(place.u).section_radius;
        cut_strip::cut(self.depth, along.gap, radius_on_rows(even, &along), ends)
    }
}

impl<T: Real> OverlapLine<T> for MovingLocal<'_, T> {
    fn at(&mut self, y: T, guess: f64) -> Place<T> {
        let place = self.whole_place(y, guess);
        match self.cut(y, &place) {
            None => place,
            Some(CutStrip { ahead, less, .. }) => {
                Place { overlap: place.overlap - less, x: place.x + ahead, ..place }
            }
        }
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
        let radius = self.rail.along(s).map_or(even, |along| radius_on_rows(even, &along));
        if self.rail.ends(s).is_none() {
            return radius;
        }
        let place = self.whole_place(s, u.value());
        self.cut(s, &place).map_or(radius, |cut| radius * cut.radius_share)
    }
}

/// Zones of one rail with derivatives, into `models.rail_strips`, from the last solution in
/// `found`; false where the equations have none.
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
    let mut local = MovingLocal { line, rail, found, depth: depth(line, rail, search) };
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
