//! The separation of wheel and rail in the frame of a contact that moves, with derivatives.

use crate::geometry::contacts::contact::Contact;
use crate::geometry::contacts::line_separation::{LineSeparation, MIN_COSINE, RailSeparation};
use crate::geometry::contacts::moving_contact::moving_place;
use crate::geometry::contacts::separation::{FrameSeparation, Probe, Separation, SeparationPoint};
use crate::geometry::rail::rail_outline::RailOutline;
use crate::geometry::wheel::contact_line::ContactLine;
use crate::math::real::Real;

/// As [`LineSeparation`] of even bodies, with derivatives: searches are left to that.
#[derive(Clone, Debug)]
pub struct MovingSeparation<'a, T> {
    values: LineSeparation<'a>,
    line: &'a ContactLine<'a, T>,
    rail: RailOutline<'a, T>,
    contact: Contact<T>,
    /// Whether anything had no derivative.
    pub has_kink: bool,
}

impl<'a, T: Real> MovingSeparation<'a, T> {
    /// The separation of the moving `line`, whose values are those of `values`, in the frame of
    /// `contact`.
    pub fn new(
        values: LineSeparation<'a>,
        line: &'a ContactLine<'a, T>,
        rail: RailOutline<'a, T>,
        contact: Contact<T>,
    ) -> Self {
        Self { values, line, rail, contact, has_kink: false }
    }

    /// From the contact point to a point of the frame's plane, across and along the normal.
    fn in_frame(&self, point: [T; 2]) -> [T; 2] {
        let to = [point[0] - self.contact.origin[0], point[1] - self.contact.origin[1]];
        let (tangent, normal) = (self.contact.tangent, self.contact.normal());
        [to[0] * tangent[0] + to[1] * tangent[1], to[0] * normal[0] + to[1] * normal[1]]
    }

    /// Where the bodies are nearest along the track, for a point of the line at `x` opposite to the
    /// parameter `s` of the rail.
    fn met(&self, x: T, s: T) -> T {
        self.rail.ahead(s).map_or(x, |ahead| x + ahead)
    }

    /// The parameter of the rail with the value `s` whose point lies at `y` across, as it moves;
    /// its depth and its slope in the frame.
    fn opposite(&self, s: f64, y: T) -> [T; 3] {
        let on = self.rail.at(T::from(s));
        let (tangent, normal) = (self.contact.tangent, self.contact.normal());
        let along = |axis: [T; 2]| on.first[0] * axis[0] + on.first[1] * axis[1];
        let across = along(tangent);
        let error = self.in_frame(on.point)[0] - y;
        let s = T::moving(s, -error / across);
        let point = self.rail.at(s).point;
        [s, self.in_frame(point)[1], along(normal) / across]
    }
}

impl<T: Real> FrameSeparation<T> for MovingSeparation<'_, T> {
    fn point(&mut self, u: T) -> SeparationPoint<T> {
        let found = self.values.at(u.value());
        let (at, derivative) = self.line.with_derivative(u);
        let [y, depth] = self.in_frame(at.point);
        let tangent = self.contact.tangent;
        let dy = (derivative[0] * tangent[0] + derivative[1] * tangent[1]).at_least(MIN_COSINE);
        let [s, rail, _] = self.opposite(self.values.last_rail_parameter(), y);
        let f = if found.f.is_finite() {
            rail - depth + self.contact.penetration
        } else {
            found.f.into()
        };
        SeparationPoint { y, dy, f, x: self.met(at.x, s) }
    }

    fn centre_at(&mut self, u: T) -> T {
        let at = self.line.at(u);
        if !self.rail.varies() {
            return at.x;
        }
        self.values.at(u.value());
        let [y, _] = self.in_frame(at.point);
        let [s, ..] = self.opposite(self.values.last_rail_parameter(), y);
        self.met(at.x, s)
    }

    fn value(&mut self, u: f64) -> f64 {
        self.values.at(u).f
    }

    fn value_with_rate(&mut self, u: f64) -> Option<[f64; 2]> {
        self.values.with_rate(u)
    }

    fn edge(&mut self, u: f64, level: T) -> T {
        let excess = self.point(u.into()).f - level;
        let (at, derivative) = self.line.with_derivative(u.into());
        let (tangent, normal) = (self.contact.tangent, self.contact.normal());
        let along = |axis: [T; 2]| derivative[0] * axis[0] + derivative[1] * axis[1];
        let y = self.in_frame(at.point)[0];
        let [_, _, rise] = self.opposite(self.values.last_rail_parameter(), y);
        let slope = (rise * along(tangent) - along(normal)).value();
        // Where the zone is cut off because a body ends, its edge stays.
        if excess.value().abs() > EDGE_SHARE * level.value() || slope == 0.0 {
            self.has_kink = true;
            return u.into();
        }
        T::moving(u, -excess / slope)
    }

    fn minimum(&mut self, probe: &Probe) -> T {
        let near = self.values.opposite_parameter(probe.u);
        let point = self.line.value().at(probe.u).point;
        let near = near.unwrap_or_else(|| self.rail.rail.coarse_nearest(point));
        let s = self.rail.rail.nearest(point, near, NEAREST).s;
        if let Some([u, _]) = moving_place(self.line, &self.rail, probe.u, s) {
            return self.point(u).f;
        }
        self.has_kink = true;
        probe.f.into()
    }
}

/// Difference of the separation from the level, over the level, up to which a place is an edge and
/// not the end of a body.
const EDGE_SHARE: f64 = 1e-6;
/// Last Newton step towards a nearest point [m].
const NEAREST: f64 = 1e-9;

impl<T: Real> RailSeparation<T> for MovingSeparation<'_, T> {
    fn rail_parameter(&mut self, u: T) -> T {
        match self.values.opposite_parameter(u.value()) {
            Some(s) => {
                let [y, _] = self.in_frame(self.line.at(u).point);
                self.opposite(s, y)[0]
            }
            None => self.contact.rail_s,
        }
    }
}
