//! Overlap of a wheel's contact line with a rail along the local normals.
//!
//! The overlap is the distance of the contact line from the nearest point of the rail, and the
//! coordinate across is the arc along the rail.

use super::cut_strip::{self, CutStrip};
use crate::geometry::contacts::contact::Contact;
use crate::geometry::contacts::contact_search::ContactSearch;
use crate::geometry::rail::placed_rail::PlacedRail;
use crate::geometry::rail::rail_outline::{RailOutline, StripOverWaves};
use crate::geometry::rail::varying_rail::{Along, VaryingRail};
use crate::geometry::wheel::contact_line::{ContactLine, LinePoint};
use crate::math::real::Real;
use crate::normal::least_energy::{LinePlace, OverlapLine, Section};

/// Least curvature along the track over that of the even wheel: in a trough that is hollow even for
/// the wheel there is no Hertzian ellipse.
pub(in crate::element) const MIN_CURVATURE_SHARE: f64 = 0.02;

/// Place along a strip over its half length at which the chord of a wheel that varies around ends.
const CHORD_SHARE: f64 = 0.7;

/// Last Newton step towards a nearest point [m]: the error is of second order in it.
const NEAREST: f64 = 1e-8;

/// Overlap of a wheel's contact line with a rail along the local normals.
pub(in crate::element) struct LocalLine<'a> {
    line: &'a ContactLine<'a>,
    rail: &'a PlacedRail,
    /// Parameter of the line and of the rail at the last place, and derivative of the one by the
    /// other.
    near: [f64; 3],
    /// Deepest penetration of all contacts [m].
    depth: f64,
}

impl<'a> LocalLine<'a> {
    pub fn new(line: &'a ContactLine<'a>, rail: &'a PlacedRail, contact: &Contact) -> Self {
        Self { line, rail, near: [contact.u, contact.rail_s, 1.0], depth: contact.penetration }
    }

    /// The line of all contacts of a `search`, of which there is at least one.
    pub fn of(line: &'a ContactLine<'a>, rail: &'a PlacedRail, search: &ContactSearch) -> Self {
        let depth = search.contacts.iter().map(|c| c.penetration).fold(0.0, f64::max);
        Self { depth, ..Self::new(line, rail, &search.contacts[0]) }
    }

    /// Radius of the section of wheel and rail together at a `place`, where these meet `along` the
    /// rows of a rail that varies, under a wheel whose section may vary around [m].
    fn radius_by(&self, place: &LinePlace, along: &Along) -> f64 {
        let LinePlace { u, y, x, tangent: [ty, tz], overlap, .. } = *place;
        if !self.line.varies_around() {
            return radius_on_rows(self.line.wheel_point(u).section_radius, along);
        }
        let on_rail = self.rail.curve().at(y).point;
        let round = self.line.round().wheel_point(u).section_radius;
        let reach = chord(round, self.depth);
        let places = [x, x - self.line.ahead_of_round(u) - along.lever];
        let direction = [-tz, ty];
        let more = self.line.mean_curvature_around(places, on_rail, direction, [u, overlap], reach);
        match more {
            Some(more) => {
                radius_on_rows(round, &Along { bulge: more * along.shortening(), ..*along })
            }
            None => radius_on_rows(self.line.wheel_point(u).section_radius, along),
        }
    }

    /// The strip at `place` over waves of either body, if there are any.
    pub fn over_waves(&self, place: &LinePlace) -> Option<StripOverWaves<f64>> {
        let outline = RailOutline::at_rest(self.rail);
        if !outline.has_waves() {
            return None;
        }
        let at = [place.y, place.x, place.overlap];
        outline.over_waves(at, |along| self.radius_by(place, along))
    }

    /// The section at a `place` as if the rail had no end.
    fn whole_section(&self, place: &LinePlace) -> Section {
        if let Some(strip) = self.over_waves(place) {
            return section_over_waves(&strip, place);
        }
        let along = RailOutline::at_rest(self.rail).along(place.y).unwrap_or_default();
        Section::even(self.radius_by(place, &along))
    }

    /// What the end of a rail that varies leaves of the strip at `place`; nothing where it is whole.
    fn cut(&self, place: &LinePlace) -> Option<CutStrip<f64>> {
        let varying = self.rail.variation()?;
        let ends = RailOutline::at_rest(self.rail).ends(place.y)?.map(|end| end - place.x);
        let slope = varying.along(place.y).gap;
        cut_strip::cut(self.depth, slope, self.whole_section(place).radius, ends)
    }

    /// The strip at `place` as far as the rail goes.
    pub fn on_rail(&self, place: LinePlace) -> LinePlace {
        self.cut(&place).map_or(place, |cut| cut.of(place))
    }
}

impl LocalLine<'_> {
    /// The place at parameter `u`, its strip as if the rail had no end.
    pub fn whole_place(&mut self, u: f64) -> LinePlace {
        let [start, end] = self.line.range();
        let u = u.clamp(start, end);
        let (at, derivative) = self.line.with_derivative(u);
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
        let dy = (nearest.ratio * along(tangent)).max(MIN_RATE);
        self.near = [u, nearest.s, dy];
        let away = [tangent[1], -tangent[0]];
        LinePlace {
            u,
            y: nearest.s,
            dy,
            overlap: -nearest.distance,
            overlap_slope: -along(away),
            x: RailOutline::at_rest(self.rail).strip_place(nearest.s, at.x),
            tangent,
        }
    }
}

impl OverlapLine for LocalLine<'_> {
    fn place(&mut self, u: f64) -> LinePlace {
        let place = self.whole_place(u);
        self.on_rail(place)
    }

    fn section(&mut self, at: &LinePlace) -> Section {
        let varying = self.rail.variation();
        if varying.is_some_and(VaryingRail::is_near_end) {
            // Without what the end leaves out.
            let place = self.whole_place(at.u);
            let section = self.whole_section(&place);
            let share = self.cut(&place).map_or(1.0, |cut| cut.radius_share);
            return Section { radius: section.radius * share, ..section };
        }
        if varying.is_some() || self.line.varies_around() {
            return self.whole_section(at);
        }
        Section::even(self.line.wheel_point(at.u).section_radius)
    }
}

/// That of a `strip` over waves at `place`.
pub(super) fn section_over_waves<T: Real>(
    strip: &StripOverWaves<T>,
    place: &LinePlace<T>,
) -> Section<T> {
    let (ahead, less) = (strip.middle - place.x, place.overlap - strip.overlap);
    Section { radius: strip.radius, ahead, less }
}

/// The strip `at` a place of the contact line, of parameter `u`, and at `y` of the `rail`, as if that
/// had no end.
///
/// The rail is taken where the strip lies on it. Strips know their parameter of the line less well:
/// its rate jumps where the curvature of a wheel does.
pub(super) fn whole_strip<T: Real>(
    at: LinePoint<T>,
    rail: &RailOutline<T>,
    [u, y]: [T; 2],
) -> LinePlace<T> {
    let on = rail.at(y);
    let slowness = T::from(1.0) / on.first[0].hypotenuse(on.first[1]);
    let tangent = on.first.map(|first| first * slowness);
    let to = [at.point[0] - on.point[0], at.point[1] - on.point[1]];
    LinePlace {
        u,
        y,
        dy: T::from(1.0),
        overlap: to[1] * tangent[0] - to[0] * tangent[1],
        overlap_slope: T::from(0.0),
        x: rail.strip_place(y, at.x),
        tangent,
    }
}

/// Distance to either side over which a wheel that varies around is taken for a circle, whose round
/// section has the radius `even`, at an overlap of `depth`: over the length that a ball of it touches
/// along [m].
fn chord(even: f64, depth: f64) -> f64 {
    (even * depth).sqrt() * CHORD_SHARE
}

/// Radius of the section of wheel and rail together along the rows of a rail that varies, for a
/// wheel whose even section has the radius `even` [m].
pub(in crate::element) fn radius_on_rows<T: Real>(even: T, along: &Along<T>) -> T {
    even / (along.relative(even) / (along.drift * along.drift + 1.0)).at_least(MIN_CURVATURE_SHARE)
}

/// Distance along the contact line beyond which a nearest point is looked for anew [m].
const FAR: f64 = 8e-3;

/// Least rate at which the nearest point moves with the contact line: where bodies end it may stand
/// still.
pub(super) const MIN_RATE: f64 = 0.05;
