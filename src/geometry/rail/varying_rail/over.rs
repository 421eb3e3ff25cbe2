//! The wheel above a rail, as its rows meet it.

use super::waves::Waves;
use super::wheel_table::CELL;
use crate::geometry::rail::course::Course;
use crate::geometry::sections::rows::met::Met;
use crate::geometry::sections::rows::plane::dot;
use crate::geometry::sections::rows::surface::{REACH, RowPoint, Surface, Within};
use crate::geometry::wheel::contact_line::ContactLine;
use crate::geometry::wheel::wheel_pose::WheelPose;
use crate::math::real::Real;

/// How far below the wheel rows surely stay of which a few are enough: nothing touches there [m].
const APART: f64 = 3e-4;
/// Steepest flank of any wheel [-].
const STEEPEST_FLANK: f64 = 3.0;
/// Newton steps to a point of the contact line, and the last of them [m].
const MAX_STEPS: usize = 12;
const STRAIGHT: f64 = 1e-6;
/// Farthest place of touch from the axle along rows that drift or rise: flanges touch rows that
/// come from the side far ahead [m].
pub(super) const REACH_ALONG: f64 = 0.3;
/// Steps to a place along such a row, and how near they come to it [m].
const MAX_STEPS_ALONG: usize = 12;
const NEAR_ALONG: f64 = 1e-12;
/// Least share of its parameter by which the contact line goes across: a flank is not followed as
/// if it stood upright.
const MIN_RATE: f64 = 0.1;

/// The wheel above the rail.
pub(super) struct Over<'a, T: Real = f64> {
    line: &'a ContactLine<'a, T>,
    marker: [T; 2],
    /// The axes in which it is seen, where the rows drift or rise.
    course: Option<Course<T>>,
    /// Deviations of the wheel over its angle, where it has any.
    waves: Option<Waves<'a>>,
    /// Directions to the right and down in the plane across the track [-].
    pub right: [T; 2],
    pub down: [T; 2],
    /// Whether the contact line may lie ahead of the axle or behind.
    leads: bool,
    /// How far to either side and below a yawed and rolled wheel may be beyond its table [m].
    pub margin: [f64; 2],
    /// Place of the axle [m].
    pub station: T,
    /// The slices around it.
    pub within: Within,
}

/// A point of the contact line.
#[derive(Clone, Copy)]
pub(super) struct Opposite<T = f64> {
    pub u: T,
    /// Its place along the track, and the derivative of that across [m, -].
    pub x: T,
    pub advance: T,
    /// Normal into the rail, and curvature of the wheel across, positive where it bulges [1/m].
    pub normal: [T; 2],
    pub curvature: T,
}

/// A place of the contact line.
pub(super) struct OnLine<T> {
    /// Along the track [m].
    pub x: T,
    /// Across the track (y, z) [m].
    pub point: [T; 2],
    /// Normal into the rail.
    pub normal: [T; 2],
}

impl<'a, T: Real> Over<'a, T> {
    /// The wheel of `line`, which stands at `pose` above `station` [m].
    pub fn new(
        line: &'a ContactLine<'a, T>,
        pose: &WheelPose<T>,
        station: T,
        within: Within,
    ) -> Self {
        let (sine, cosine) = pose.roll.sin_cos();
        let yaw = pose.yaw.value();
        let yawed = STEEPEST_FLANK * line.nominal_radius() * yaw * yaw;
        Self {
            line,
            marker: [pose.marker[1], pose.marker[2]],
            right: [cosine, sine],
            down: [-sine, cosine],
            waves: None,
            course: None,
            leads: T::HAS_SLOPES || yaw != 0.0 || line.varies_around(),
            margin: [CELL + yawed, APART + 0.5 * STEEPEST_FLANK * yawed],
            station,
            within,
        }
    }

    /// The same with deviations over its angle.
    pub fn with_waves(self, waves: Option<Waves<'a>>) -> Self {
        Self { waves, ..self }
    }

    /// The same in axes along the `course` of the rows, of line and pose too.
    pub fn along(self, course: Option<Course<T>>) -> Self {
        Self { course, ..self }
    }

    /// Row `j` of the `surface` on a `run` of slices at `x` [m].
    pub fn row(&self, surface: &Surface, j: usize, run: [usize; 2], x: T) -> RowPoint<T> {
        let Some(course) = &self.course else {
            return surface.at(j, run, self.station + x, self.within.slice);
        };
        let at = |place: T| surface.at(j, run, self.station + place, self.within.slice);
        let missing =
            |place: T, p: &RowPoint<T>| x - course.place([place, p.value[0], p.value[1]])[0];
        let [along, ..] = course.axes;
        let mut place = x;
        let mut p = at(place);
        for _ in 0..MAX_STEPS_ALONG {
            let left = missing(place, &p);
            let rate = along[0] + along[1] * p.first[0] + along[2] * p.first[1];
            let is_near = left.value().abs() <= NEAR_ALONG;
            if is_near && !T::HAS_SLOPES {
                break;
            }
            place += left / rate;
            p = at(place);
            // The last step leaves derivatives.
            if is_near {
                break;
            }
        }
        course.row_point(place, &p)
    }

    /// From where to where row `j` of the `surface` on a `run` of slices is within reach [m].
    pub fn reach(&self, surface: &Surface, j: usize, run: [usize; 2]) -> Option<[T; 2]> {
        let ends = surface.reach(run, self.station)?;
        let Some(course) = &self.course else { return Some(ends) };
        let [from, to] = ends.map(|end| {
            if end.value().abs() >= REACH {
                return T::from(REACH_ALONG.copysign(end.value()));
            }
            let p = surface.at(j, run, self.station + end, self.within.slice);
            course.place([end, p.value[0], p.value[1]])[0].within(-REACH_ALONG, REACH_ALONG)
        });
        (from <= to).then_some([from, to])
    }

    /// Height over the track of the place at `x` of a row at (y, z), down positive, as the rows are
    /// given [m].
    pub fn height_of(&self, x: T, p: &RowPoint<T>) -> T {
        let [y, z] = [p.value[0], p.value[1]];
        self.course.map_or(z, |course| course.on_rail([x, y, z])[2])
    }

    /// The contact line.
    pub fn line(&self) -> &'a ContactLine<'a, T> {
        self.line
    }

    /// Deviations of the wheel over its angle, where it has any.
    pub fn waves(&self) -> Option<Waves<'a>> {
        self.waves
    }

    /// Whether the contact line may lie ahead of the axle or behind.
    pub fn leads(&self) -> bool {
        self.leads
    }

    /// Radius of the nominal rolling circle [m].
    pub fn nominal_radius(&self) -> f64 {
        self.line.nominal_radius()
    }

    /// A point across the track, from the wheel marker [m].
    pub fn seen_from_marker(&self, [y, z]: [T; 2]) -> [T; 2] {
        [y - self.marker[0], z - self.marker[1]]
    }

    /// The point across the track at `y` to the right of the marker [m].
    pub fn beside_marker(&self, y: T) -> [T; 2] {
        [0, 1].map(|i| self.marker[i] + y * self.right[i])
    }

    /// A point across the track by its coordinates to the right and down from the marker [m].
    pub fn across_and_down(&self, point: [T; 2]) -> [T; 2] {
        let to = self.seen_from_marker(point);
        [self.right, self.down].map(|axis| dot(to, axis))
    }

    /// The same of a place of a row [m].
    pub fn in_wheel(&self, p: &RowPoint<T>) -> [T; 2] {
        self.across_and_down([p.value[0], p.value[1]])
    }

    /// Row `j` at `x`, where nothing touches it.
    pub fn under_axle(&self, j: usize, p: &RowPoint<T>, x: T) -> Met<T> {
        let [_, z] = self.in_wheel(p);
        let down = x.hypotenuse(z) - z;
        Met {
            row: j,
            point: [0, 1].map(|i| p.value[i] + down * self.down[i]),
            direction: [p.value[2], p.value[3]],
            x,
            ..Met::default()
        }
    }

    /// The place of the contact line, its point and its normal into the rail at `across`, which is
    /// opposite to about the parameter `u` [m].
    pub fn to_across(&self, u: f64, across: T) -> OnLine<T> {
        let (at, derivative) = self.line.even_with_derivative(u.into());
        let missing = across - dot(self.seen_from_marker(at.point), self.right);
        let u = T::from(u) + missing / dot(derivative, self.right);
        let (at, derivative) = self.line.even_with_derivative(u);
        let size = derivative[0].hypotenuse(derivative[1]);
        let [ty, tz] = derivative.map(|d| d / size);
        OnLine { x: at.x, point: at.point, normal: [T::from(0.0) - tz, ty] }
    }

    /// The point of the contact line at the parameter `u`, and what it still has to go so as to be
    /// at `y` across [m].
    pub fn on_line(&self, u: T, y: T) -> (Opposite<T>, T) {
        let (at, derivative) = self.line.even_with_derivative(u);
        let to = self.seen_from_marker(at.point);
        let rate = dot(derivative, self.right);
        let size = derivative[0].hypotenuse(derivative[1]);
        let [ty, tz] = derivative.map(|d| d / size);
        let zero = T::from(0.0);
        let advance = if self.leads { self.line.advance(u) } else { zero };
        let opposite = Opposite {
            u,
            x: if self.leads { at.x } else { zero },
            advance: advance / rate,
            normal: [-tz, ty],
            curvature: self.line.curvature(u),
        };
        (opposite, y - dot(to, self.right))
    }
}

impl Over<'_> {
    /// Whether the section of the wheel varies around.
    pub fn varies_around(&self) -> bool {
        self.line.varies_around()
    }

    /// Whether the wheel may be hollow for a rail.
    pub fn is_hollow(&self) -> bool {
        self.varies_around() || self.waves.is_some_and(|waves| waves.is_hollow())
    }

    /// How far ahead of its contact line or behind a wheel whose section varies around may be met
    /// on an even rail; 0 for others [m].
    pub fn reach_around(&self) -> f64 {
        self.line.reach_around()
    }

    /// Distance of samples between which the wheel has at most one wave [m].
    pub fn spacing(&self) -> f64 {
        self.waves.map_or(f64::INFINITY, |waves| waves.spacing())
    }

    /// The point of the contact line at `y` across, from the parameter `u` near it; nothing where
    /// the wheel stands upright.
    pub fn opposite(&self, mut u: f64, y: f64) -> Option<Opposite> {
        let [start, end] = self.line.range();
        for _ in 0..MAX_STEPS {
            let (at, derivative) = self.line.even_with_derivative(u);
            let to = self.seen_from_marker(at.point);
            let rate = dot(derivative, self.right);
            if rate < MIN_RATE {
                return None;
            }
            let step = ((y - dot(to, self.right)) / rate).clamp(-CELL, CELL);
            let next = (u + step).clamp(start, end);
            let step = next - u;
            if step.abs() < STRAIGHT || next <= start || next >= end {
                // Over the last step the line is as good as an arc.
                let curvature = self.line.curvature(u);
                let size = derivative[0].hypotenuse(derivative[1]);
                let [ty, tz] = derivative.map(|d| d / size);
                let turn = -curvature * size * step;
                let tangent = [ty - turn * tz, tz + turn * ty];
                let advance = if self.leads { self.line.advance(u) } else { 0.0 };
                let x = if self.leads { at.x + advance * step } else { 0.0 };
                let normal = [-tangent[1], tangent[0]];
                return Some(Opposite { u: next, x, advance: advance / rate, normal, curvature });
            }
            u = next;
        }
        None
    }
}
