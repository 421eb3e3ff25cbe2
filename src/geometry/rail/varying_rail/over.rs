//! The wheel above a rail, as its rows meet it.

use super::waves::WheelWaves;
use super::wheel_table::CELL;
use crate::geometry::rail::course::Course;
use crate::geometry::sections::rows::plane::dot;
use crate::geometry::sections::rows::surface::{REACH, REACH_ALONG, RowPoint, Surface, Within};
use crate::geometry::wheel::contact_line::{ContactLine, Followed};
use crate::geometry::wheel::wheel_pose::WheelPose;
use crate::math::real::Real;

/// Steepest flank of any wheel [-].
const STEEPEST_FLANK: f64 = 3.0;
/// Newton steps to a point of the contact line, and one over which nothing changes [m].
const MAX_STEPS: usize = 12;
const LAST_STEP: f64 = 1e-13;

/// The wheel above the rail.
pub(super) struct Over<'a, T: Real = f64> {
    line: &'a ContactLine<'a, T>,
    /// The wheel marker across, in the axes of the outline [m].
    marker: [T; 2],
    /// The same along the track, to the right and down, and the directions of the axle, forward and
    /// down across it, in the axes of the track.
    pub centre: [T; 3],
    pub axes: [[T; 3]; 3],
    /// The axes of the outline, where the rows drift or rise.
    course: Option<Course<T>>,
    /// Deviations of the wheel over its angle, where it has any.
    waves: Option<WheelWaves<'a, T>>,
    /// Directions to the right and down in the plane across the track, in the axes of the outline
    /// [-].
    pub right: [T; 2],
    pub down: [T; 2],
    /// How far to either side and below a yawed and rolled wheel may be beyond its table [m].
    pub margin: [f64; 2],
    /// Place of the axle [m].
    pub station: T,
    /// The slices around it.
    pub within: Within,
}

/// How a row goes on where it is, in the axes of the outline.
#[derive(Clone, Copy)]
pub(super) struct Way<T = f64> {
    /// Where it is along them [m], and how fast that grows along the track [-].
    pub x: T,
    pub rate: T,
    /// Derivatives of its place across by x [-, 1/m].
    pub first: [T; 2],
    pub second: [T; 2],
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
            centre: pose.marker,
            axes: line.axes(),
            right: [cosine, sine],
            down: [-sine, cosine],
            waves: None,
            course: None,
            margin: [CELL + yawed, 0.5 * STEEPEST_FLANK * yawed],
            station,
            within,
        }
    }

    /// The same with deviations over its angle.
    pub fn with_waves(self, waves: Option<WheelWaves<'a, T>>) -> Self {
        Self { waves, ..self }
    }

    /// The same where line and pose are seen in axes along the `course` of the rows.
    pub fn along(self, course: Option<Course<T>>) -> Self {
        let Some(seen) = &course else { return self };
        let centre = seen.on_rail(self.centre);
        let axes = self.axes.map(|axis| seen.direction_on_rail(axis));
        Self { centre, axes, course, ..self }
    }

    /// A point across the track at `place` by its parts along the axle, forward and down, from the
    /// wheel marker [m].
    pub fn about_axle(&self, place: T, [y, z]: [T; 2]) -> [T; 3] {
        let to = [place - self.centre[0], y - self.centre[1], z - self.centre[2]];
        self.axes.map(|a| a[0] * to[0] + a[1] * to[1] + a[2] * to[2])
    }

    /// How a row goes on at the `place` along the track [m], where it is at the `point`.
    pub fn way(&self, place: T, point: &RowPoint<T>) -> Way<T> {
        match &self.course {
            None => {
                let (first, second) = ([point.first[0], point.first[1]], point.second);
                Way { x: place, rate: T::from(1.0), first, second }
            }
            Some(course) => {
                let (rate, [first, second]) = course.way(point);
                let [x, ..] = course.place([place, point.value[0], point.value[1]]);
                Way { x, rate, first, second }
            }
        }
    }

    /// The parts across of a vector along the track, to the right and down, in the axes of the
    /// outline.
    pub fn across(&self, [x, y, z]: [T; 3]) -> [T; 2] {
        self.course.as_ref().map_or([y, z], |course| course.across([x, y, z]))
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

    /// The axes of the outline, where the rows drift or rise.
    pub fn course(&self) -> Option<&Course<T>> {
        self.course.as_ref()
    }

    /// The contact line.
    pub fn line(&self) -> &'a ContactLine<'a, T> {
        self.line
    }

    /// Whether the section of the wheel varies around.
    pub fn varies_around(&self) -> bool {
        self.line.varies_around()
    }

    /// Deviations of the wheel over its angle, where it has any.
    pub fn waves(&self) -> Option<&WheelWaves<'a, T>> {
        self.waves.as_ref()
    }

    /// Radius of the nominal rolling circle [m].
    pub fn nominal_radius(&self) -> f64 {
        self.line.nominal_radius()
    }

    /// Where a point across the track at `place` is in the axes of the outline [m].
    pub fn beside(&self, place: T, [y, z]: [T; 2]) -> [T; 2] {
        self.course.as_ref().map_or([y, z], |course| {
            let [_, y, z] = course.place([place, y, z]);
            [y, z]
        })
    }

    /// The point of the contact line from which the point `here` across is straight on along the
    /// radius, sought near the parameter `s`, and how far that is [m]; the one that was sought last
    /// where they do not settle.
    pub fn opposite(&self, here: [T; 2], mut s: T) -> (Followed<T>, T) {
        let mut line = self.line.followed(s);
        let away = |line: &Followed<T>| [0, 1].map(|i| here[i] - line.at.point[i]);
        let aside = |v: [T; 2], line: &Followed<T>| v[0] * line.radial[1] - v[1] * line.radial[0];
        for _ in 0..MAX_STEPS {
            let to = away(&line);
            let turning = to[0] * line.turning[1] - to[1] * line.turning[0];
            let step = aside(to, &line) / (aside(line.derivative, &line) - turning);
            let is_last = step.value().abs() <= LAST_STEP || step.value().is_nan();
            // The last one is made for what moves.
            if is_last && !T::HAS_SLOPES {
                break;
            }
            s += step.within(-CELL, CELL);
            line = self.line.followed(s);
            if is_last {
                break;
            }
        }
        let straight = dot(away(&line), line.radial) / dot(line.radial, line.radial);
        (line, straight)
    }

    /// The point across at `y` to the right of the marker, in the axes of the outline [m].
    pub fn beside_marker(&self, y: T) -> [T; 2] {
        [0, 1].map(|i| self.marker[i] + y * self.right[i])
    }

    /// A point across the track, from the wheel marker, both in the axes of the outline [m].
    pub fn seen_from_marker(&self, [y, z]: [T; 2]) -> [T; 2] {
        [y - self.marker[0], z - self.marker[1]]
    }
}

impl Over<'_> {
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
}
