//! The section of a rail where a wheel meets it: rows of elements, and the wheel opposite to each
//! of their elements.

use crate::boundary_element::grid::Grid;
use crate::geometry::curves::arc_length::ArcLength;
use crate::geometry::rail::placed_rail::PlacedRail;
use crate::geometry::rail::rail_outline::RailOutline;
use crate::geometry::rail::varying_rail::Along;
use crate::geometry::wheel::contact_line::ContactLine;
use crate::math::real::Real;

/// A row of elements at one place of the rail's section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// Parameter of the rail's curve [m].
    pub s: f64,
    /// Point (y, z) of the rail [m].
    pub point: [f64; 2],
    /// Unit tangent (y, z) of the rail.
    pub tangent: [f64; 2],
    /// Parameter of the wheel's contact line where the rail's normal meets it [m].
    pub u: f64,
    /// Place along the track at which the bodies are nearest, from the wheel marker [m].
    pub x: f64,
    /// Overlap there [m].
    pub overlap: f64,
    /// The rail along the track there.
    pub course: Course,
    /// From where to where along the track the rail is there, from the wheel marker [m].
    pub ends: [f64; 2],
}

impl Row {
    /// The normal (y, z) into the rail.
    pub fn normal(&self) -> [f64; 2] {
        [-self.tangent[1], self.tangent[0]]
    }

    /// Point (y, z) at `x` from the wheel marker [m] of a wheel that overlaps the row by `overlap`
    /// [m], as if the wheel were laid flat along the row.
    pub fn wheel_point(&self, x: f64, overlap: f64) -> [f64; 2] {
        let ahead = x - self.x;
        let depth = overlap - self.course.lift - self.course.lean * ahead;
        let (beside, normal) = (self.course.drift * ahead, self.normal());
        [0, 1].map(|c| self.point[c] + depth * normal[c] + beside * self.tangent[c])
    }
}

/// A rail along the track, where a wheel meets it; zero where its section does not vary.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Course {
    /// Height of the wheel over its contact line, along the normal of the section [m].
    pub lift: f64,
    /// Tangent of the angle by which the normal of the rail leans forward [-].
    pub lean: f64,
    /// How fast the row drifts across [-].
    drift: f64,
    /// Curvature of the rail; positive where it bulges [1/m].
    pub(super) curvature: f64,
}

impl Course {
    /// What overlaps more than with an even rail, at `x` ahead of where the bodies are nearest [m].
    pub(super) fn more(&self, x: f64) -> f64 {
        self.lift + x * (self.lean - 0.5 * self.curvature * x)
    }

    /// Cosine of the lean [-].
    fn cosine(&self) -> f64 {
        1.0 / self.lean.hypotenuse(1.0)
    }
}

/// The wheel opposite to an element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Opposite {
    /// Overlap of the undeformed bodies along the rail's normal, > 0 [m].
    pub overlap: f64,
    /// N/(N·n), n leaning with the rail: what the overlap grows by when the wheel moves by a unit
    /// along x, y and z.
    pub growth: [f64; 3],
}

/// The section of a rail and the wheel over it.
pub(super) struct Section<'a> {
    pub line: &'a ContactLine<'a>,
    pub rail: &'a PlacedRail,
    pub arcs: &'a ArcLength<'a>,
}

impl Section<'_> {
    /// The row at `arc`, the contact line sought near the parameter `u`.
    pub(super) fn row(&self, arc: f64, mut u: f64) -> Option<Row> {
        let s = self.arcs.parameter(arc)?;
        let on = self.rail.curve().at(s);
        let speed = on.first[0].hypotenuse(on.first[1]);
        let tangent = on.first.map(|d| d / speed);
        let [start, end] = self.line.range();
        let along = |v: [f64; 2]| v[0] * tangent[0] + v[1] * tangent[1];
        for _ in 0..MAX_STEPS {
            if !(u > start && u < end) {
                return None;
            }
            let (at, derivative) = self.line.with_derivative(u);
            let to = [at.point[0] - on.point[0], at.point[1] - on.point[1]];
            let rate = along(derivative);
            if rate < MIN_RATE {
                return None;
            }
            let step = -along(to) / rate;
            u += step;
            if step.abs() <= LAST_STEP {
                let normal = [-tangent[1], tangent[0]];
                let down = |v: [f64; 2]| v[0] * normal[0] + v[1] * normal[1];
                let overlap = down(to) + step * down(derivative);
                let course = Course::default();
                let ends = [f64::NEG_INFINITY, f64::INFINITY];
                let row = Row { s, point: on.point, tangent, u, x: at.x, overlap, course, ends };
                return match self.rail.variation() {
                    None => Some(row),
                    Some(varying) => {
                        let ends = RailOutline::at_rest(self.rail).ends(s).unwrap_or(row.ends);
                        self.met(Row { ends, ..row }, &varying.along(s))
                    }
                };
            }
        }
        None
    }

    /// An even `row` where the wheel meets it on a rail that varies; nothing where the wheel is not
    /// that long.
    fn met(&self, row: Row, along: &Along) -> Option<Row> {
        let x = row.x + along.ahead;
        let even = self.line.surface_along(x, row.point, row.normal(), [row.u, row.overlap])?;
        let Along { lean, drift, curvature, .. } = *along;
        let course = Course { lift: 0.0, lean, drift, curvature };
        let lift = row.overlap / course.cosine() - even.depth;
        Some(Row { x, course: Course { lift, ..course }, ..row })
    }

    /// Finds the wheel opposite to the elements of `row`, from the contact line to both sides as
    /// far as the bodies overlap and the rail goes; a wheel that varies around may do so again
    /// farther on.
    pub(super) fn meet_row(&self, grid: &Grid, row: &Row, opposite: &mut [Option<Opposite>]) {
        let normal = row.normal();
        // Elements go from ahead to behind, and their middles are on the rail.
        let [behind, ahead] = row.ends.map(|end| (grid.leading_x - end) / grid.dx);
        let (first, end) = (ahead.ceil().max(0.0), (behind.floor() + 1.0).min(grid.along as f64));
        if first >= end {
            return;
        }
        let middle = ((grid.leading_x - row.x) / grid.dx).round().clamp(first, end - 1.0);
        let (course, cosine) = (row.course, row.course.cosine());
        let mut meet = |i: usize, guess: &mut [f64; 2]| {
            let x = grid.x(i);
            let Some(at) = self.line.surface_along(x, row.point, normal, *guess) else {
                return false;
            };
            let overlap = cosine * (at.depth + course.more(x - row.x));
            if overlap <= 0.0 {
                *guess = [at.s, at.depth];
                return self.line.varies_around();
            }
            let across = at.normal[1] * normal[0] + at.normal[2] * normal[1];
            let facing = cosine * (course.lean * at.normal[0] + across);
            *guess = [at.s, at.depth];
            opposite[i] = Some(Opposite { overlap, growth: at.normal.map(|n| n / facing) });
            true
        };
        let from = [row.u, row.overlap - course.lift];
        let middle = middle as usize;
        let mut guess = from;
        for i in (first as usize..=middle).rev() {
            if !meet(i, &mut guess) {
                break;
            }
        }
        guess = from;
        for i in middle + 1..end as usize {
            if !meet(i, &mut guess) {
                break;
            }
        }
    }
}

/// Newton steps to the place on a normal of the rail, the last of them [m], and the least rate at
/// which that goes along with the line.
const MAX_STEPS: usize = 10;
pub(super) const LAST_STEP: f64 = 1e-9;
const MIN_RATE: f64 = 0.05;
