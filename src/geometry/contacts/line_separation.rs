//! The separation of a wheel's contact line and a rail in the frame of a contact.
//!
//! The distance of the two lines along the normal of the frame, measured from the point of first
//! touch: for a point of the contact line the opposite point of the rail has the same lateral
//! coordinate.

mod lanes;

use crate::geometry::contacts::contact::Contact;
use crate::geometry::contacts::separation::{FrameSeparation, Separation, SeparationPoint};
use crate::geometry::rail::placed_rail::PlacedRail;
use crate::geometry::wheel::contact_line::ContactLine;
use crate::math::real::Real;

/// The separation of a contact line and a rail in the frame of a contact.
#[derive(Clone, Debug)]
pub struct LineSeparation<'a> {
    line: &'a ContactLine<'a>,
    rail: &'a PlacedRail,
    contact: Contact,
    /// Parameter of the rail and lateral coordinate of the last point, and the derivative of the
    /// one by the other: the next point is near.
    near: [f64; 3],
}

/// The separation of a contact line and a rail, with derivatives where the numbers have them.
pub trait RailSeparation<T: Real>: FrameSeparation<T> {
    /// Parameter of the rail's curve opposite to parameter `u` of the line; that of the contact
    /// point where there is none [m].
    fn rail_parameter(&mut self, u: T) -> T;
}

/// Cosine of the angle to the contact frame beyond which a line counts as ended.
pub(in crate::geometry) const MIN_COSINE: f64 = 0.15;
/// Distance over which the rail's curve is as good as a parabola [m].
const OPPOSITE: f64 = 3e-6;
/// Newton steps for the point of the rail opposite to one of the wheel.
const MAX_OPPOSITE_STEPS: usize = 24;

impl<'a> LineSeparation<'a> {
    /// The separation in the frame of `contact`.
    pub fn new(line: &'a ContactLine<'a>, rail: &'a PlacedRail, contact: Contact) -> Self {
        Self { line, rail, contact, near: [contact.rail_s, 0.0, 1.0] }
    }

    /// Place of the contact line at parameter `u`, from the wheel marker [m].
    pub fn centre(&self, u: f64) -> f64 {
        self.line.at(u).x
    }

    /// Parameter of the rail opposite to lateral coordinate `y` of the frame, the rail's coordinate
    /// along the normal and its derivative by `y`; nothing where the rail ends or turns away
    /// before.
    fn opposite(&mut self, y: f64) -> Option<[f64; 3]> {
        let [near_s, near_y, rate] = self.near;
        // From the last point it takes a step or two. Only the way from the contact point tells
        // that there is none, so that the result does not depend on the point before.
        self.opposite_from(near_s + rate * (y - near_y), y)
            .or_else(|| self.opposite_from(self.contact.rail_s, y))
    }

    /// As [`opposite`](Self::opposite), by Newton steps from the parameter `guess`.
    #[inline]
    fn opposite_from(&mut self, guess: f64, y: f64) -> Option<[f64; 3]> {
        let (tangent, normal) = (self.contact.tangent, self.contact.normal());
        let curve = self.rail.curve();
        let (start, end) = (curve.start(), curve.end());
        let mut s = guess.clamp(start, end);
        let mut good = None;
        for _ in 0..MAX_OPPOSITE_STEPS {
            let p = curve.at(s);
            let cosine = p.first[0] * tangent[0] + p.first[1] * tangent[1];
            if cosine < MIN_COSINE {
                // Too far: half way back to where the rail still faced the normal.
                s = 0.5 * (s + good?);
                continue;
            }
            good = Some(s);
            let to = [p.point[0] - self.contact.origin[0], p.point[1] - self.contact.origin[1]];
            let error = to[0] * tangent[0] + to[1] * tangent[1] - y;
            let steepness = 1.0 / cosine;
            let step = -error * steepness;
            if step.abs() <= OPPOSITE {
                // The last step needs no new point: over it the curve is a parabola.
                let turn = p.second[0] * tangent[0] + p.second[1] * tangent[1];
                let bend = step * turn * steepness;
                let step = step * (1.0 - 0.5 * bend);
                let along = |v: &[f64; 2]| v[0] * normal[0] + v[1] * normal[1];
                let rate = steepness * (1.0 - bend);
                self.near = [s + step, y, rate];
                let (first, second) = (along(&p.first), along(&p.second));
                let depth = along(&to) + step * (first + 0.5 * step * second);
                return Some([s + step, depth, rate * (first + step * second)]);
            }
            let next = s + step;
            if (next < start && s <= start) || (next > end && s >= end) {
                return None;
            }
            s = next.clamp(start, end);
        }
        None
    }

    /// The separation, but for where along the track that is, and its derivative by the parameter of the
    /// line [m, -].
    #[inline]
    fn with_slope(&mut self, u: f64) -> (SeparationPoint, f64) {
        let (at, derivative) = self.line.with_derivative(u);
        let (tangent, normal) = (self.contact.tangent, self.contact.normal());
        let to = [at.point[0] - self.contact.origin[0], at.point[1] - self.contact.origin[1]];
        let y = to[0] * tangent[0] + to[1] * tangent[1];
        let depth = to[0] * normal[0] + to[1] * normal[1];
        let dy = derivative[0] * tangent[0] + derivative[1] * tangent[1];
        let rail = if dy < MIN_COSINE { None } else { self.opposite(y) };
        let [_, rail, rise] = rail.unwrap_or([f64::NAN, f64::INFINITY, f64::NAN]);
        let f = rail - depth + self.contact.penetration;
        let rate = rise * dy - (derivative[0] * normal[0] + derivative[1] * normal[1]);
        (SeparationPoint { y, dy: dy.max(MIN_COSINE), f, x: at.x }, rate)
    }

    /// Parameter of the rail's curve opposite to the last point that had a finite separation [m].
    pub fn last_rail_parameter(&self) -> f64 {
        self.near[0]
    }

    /// As [`RailSeparation::rail_parameter`]; nothing where no point of the rail lies opposite.
    pub(in crate::geometry) fn opposite_parameter(&mut self, u: f64) -> Option<f64> {
        let point = self.line.at(u).point;
        let [o, t] = [self.contact.origin, self.contact.tangent];
        let y = (point[0] - o[0]) * t[0] + (point[1] - o[1]) * t[1];
        self.opposite(y).map(|found| found[0])
    }
}

impl RailSeparation<f64> for LineSeparation<'_> {
    fn rail_parameter(&mut self, u: f64) -> f64 {
        self.opposite_parameter(u).unwrap_or(self.contact.rail_s)
    }
}

impl Separation for LineSeparation<'_> {
    #[inline]
    fn at(&mut self, u: f64) -> SeparationPoint {
        let (point, _) = self.with_slope(u);
        let Some(varying) = self.rail.variation() else { return point };
        let x = point.x + varying.ahead(self.near[0]);
        SeparationPoint { x, ..point }
    }

    fn fill(&mut self, us: &[f64], found: &mut [SeparationPoint]) {
        self.fill_lanes(us, found);
    }

    #[inline]
    fn with_rate(&mut self, u: f64) -> Option<[f64; 2]> {
        let (point, rate) = self.with_slope(u);
        Some([point.f, rate])
    }

    fn along(&mut self, u: f64) -> f64 {
        if self.rail.variation().is_some() {
            return self.at(u).x;
        }
        self.line.at(u).x
    }
}
