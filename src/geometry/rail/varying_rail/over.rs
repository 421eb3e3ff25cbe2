//! The wheel above a rail, as its rows meet it.

use super::waves::Waves;
use super::wheel_table::CELL;
use crate::geometry::rail::course::Course;
use crate::geometry::sections::rows::met::{Gap, Met};
use crate::geometry::sections::rows::plane::dot;
use crate::geometry::sections::rows::surface::{REACH, RowPoint, Surface, Within};
use crate::geometry::wheel::contact_line::{ContactLine, Followed};
use crate::geometry::wheel::wheel_pose::WheelPose;
use crate::math::real::Real;

/// How far below the wheel rows surely stay of which a few are enough: nothing touches there [m].
const APART: f64 = 3e-4;
/// Steepest flank of any wheel [-].
const STEEPEST_FLANK: f64 = 3.0;
/// Newton steps to a point of the contact line, and the last of them: over it the line is as good
/// as an arc [m].
const MAX_STEPS: usize = 12;
const STRAIGHT: f64 = 1e-8;
/// Farthest place of touch from the axle along rows that drift or rise: flanges touch rows that
/// come from the side far ahead [m].
pub(super) const REACH_ALONG: f64 = 0.3;
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
    /// Its height below the axle, and the slope of the line across [m, -].
    pub radius: T,
    pub lateral: T,
    /// Curvature of the round wheel along the track there [1/m].
    pub section: T,
}

impl Opposite {
    /// The same in other numbers, which do not move.
    fn fixed<T: Real>(&self) -> Opposite<T> {
        Opposite {
            u: self.u.into(),
            x: self.x.into(),
            advance: self.advance.into(),
            normal: self.normal.map(T::from),
            curvature: self.curvature.into(),
            radius: self.radius.into(),
            lateral: self.lateral.into(),
            section: self.section.into(),
        }
    }
}

/// A place of a row.
#[derive(Clone, Copy)]
pub(super) struct OnRow<T = f64> {
    /// Along the track, and in the axes in which the wheel is seen [m].
    pub place: T,
    pub x: T,
    /// The row there, and how far to the right of the marker and below it that is [m].
    pub point: RowPoint<T>,
    pub across: [T; 2],
    /// How fast x grows along the track.
    pub rate: T,
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

    /// Row `j` of the `surface` on a `run` of slices at the `place` along the track [m].
    pub fn row(&self, surface: &Surface, j: usize, run: [usize; 2], place: T) -> OnRow<T> {
        let point = surface.at(j, run, self.station + place, self.within.slice);
        let (point, x, rate) = match &self.course {
            None => (point, place, T::from(1.0)),
            Some(course) => {
                let [along, ..] = course.axes;
                let rate = along[0] + along[1] * point.first[0] + along[2] * point.first[1];
                let [x, ..] = course.place([place, point.value[0], point.value[1]]);
                (course.row_point(place, &point), x, rate)
            }
        };
        let across = self.across_and_down([point.value[0], point.value[1]]);
        OnRow { place, x, point, across, rate }
    }

    /// From where to where along the track row `j` of the `surface` on a `run` of slices is within
    /// reach [m].
    pub fn reach(&self, surface: &Surface, run: [usize; 2]) -> Option<[T; 2]> {
        let ends = surface.reach(run, self.station)?;
        if self.course.is_none() {
            return Some(ends);
        }
        let farther = |end: T| {
            if end.value().abs() >= REACH {
                return T::from(REACH_ALONG.copysign(end.value()));
            }
            end
        };
        Some(ends.map(farther))
    }

    /// Height over the track of a place of a row, down positive, as the rows are given [m].
    pub fn height_of(&self, row: &OnRow<T>) -> T {
        let [y, z] = [row.point.value[0], row.point.value[1]];
        self.course.map_or(z, |course| course.on_rail([row.x, y, z])[2])
    }

    /// Whether it is seen in axes along rows that drift or rise.
    pub fn is_along_rows(&self) -> bool {
        self.course.is_some()
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

    /// Row `j` at a place where nothing touches it.
    pub fn under_axle(&self, j: usize, row: &OnRow<T>) -> Met<T> {
        let OnRow { place, x, point, across: [_, z], .. } = *row;
        let down = (x * x + z * z).sqrt() - z;
        Met {
            row: j,
            point: [0, 1].map(|i| point.value[i] + down * self.down[i]),
            direction: [point.value[2], point.value[3]],
            place,
            x,
            gap: Gap { height: f64::INFINITY, share: 1.0, growth: 0.0 },
            ..Met::default()
        }
    }

    /// The point of the contact line at the parameter `u`, and what it still has to go so as to be
    /// at `y` across [m].
    pub fn on_line(&self, u: T, y: T) -> (Opposite<T>, T) {
        let line = self.line.followed(u);
        let [across, radius] = self.across_and_down(line.at.point);
        (self.met_at(u, &line, [T::from(0.0), radius]), y - across)
    }

    /// The point of the contact line at `y` across, which the same wheel at rest, `fixed`, has near
    /// the parameter `u`; nothing where the wheel stands upright.
    pub fn opposite_to(&self, fixed: &Over, u: f64, y: T) -> Option<Opposite<T>> {
        let found = fixed.opposite(u, y.value())?;
        if !T::HAS_SLOPES {
            return Some(found.fixed());
        }
        let (_, missing) = self.on_line(found.u.into(), y);
        let rate = self.line.followed(T::from(found.u)).derivative;
        Some(self.on_line(T::moving(found.u, missing / dot(rate, self.right)), y).0)
    }

    /// The point of the `line` at the parameter `u`, of which the `step` is the last one and which
    /// is `radius` below the axle before that [m].
    fn met_at(&self, u: T, line: &Followed<T>, [step, radius]: [T; 2]) -> Opposite<T> {
        let [dy, dz] = line.derivative;
        let size = (dy * dy + dz * dz).sqrt();
        let [ty, tz] = [dy / size, dz / size];
        let turn = line.curvature * size * step;
        let tangent = [ty + turn * tz, tz - turn * ty];
        let [right, down] = [self.right, self.down].map(|axis| dot(tangent, axis));
        let zero = T::from(0.0);
        let (x, advance) = if self.leads {
            (line.at.x + line.advance * step, line.advance / (right * size))
        } else {
            (zero, zero)
        };
        Opposite {
            u: u + step,
            x,
            advance,
            normal: [zero - tangent[1], tangent[0]],
            curvature: line.curvature,
            radius: radius + dot(line.derivative, self.down) * step,
            lateral: down / right,
            section: line.section,
        }
    }
}

impl Over<'_> {
    /// Whether the section of the wheel varies around.
    pub fn varies_around(&self) -> bool {
        self.line.varies_around()
    }

    /// Whether the wheel may be hollow for a rail.
    pub fn is_hollow(&self) -> bool {
        self.varies_around() || self.has_hollow_waves()
    }

    /// Whether waves over its angle may make it so.
    pub fn has_hollow_waves(&self) -> bool {
        self.waves.is_some_and(|waves| waves.is_hollow())
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
            let line = self.line.followed(u);
            let [across, radius] = self.across_and_down(line.at.point);
            let rate = dot(line.derivative, self.right);
            if rate < MIN_RATE {
                return None;
            }
            let step = ((y - across) / rate).clamp(-CELL, CELL);
            let next = (u + step).clamp(start, end);
            let step = next - u;
            if step.abs() < STRAIGHT || next <= start || next >= end {
                return Some(self.met_at(u, &line, [step, radius]));
            }
            u = next;
        }
        None
    }
}
