//! The frame of a rail marker, in which contacts are found.

use nalgebra::Vector3;

use crate::element::input::{RailMotion, WheelMotion};
use crate::geometry::rail::course::Course;
use crate::geometry::rail::placed_rail::PlacedRail;
use crate::geometry::wheel::contact_line::WheelPose;
use crate::kinematics::creepage::RelativeMotion;
use crate::math::real::Real;

/// The frame of a rail that may have moved and rolled from its design position.
#[derive(Clone, Copy, Debug)]
pub struct RailFrame<T = f64> {
    /// Rail marker in the track frame [m].
    pub marker: Vector3<T>,
    /// Roll of the rail [rad].
    pub roll: T,
    sine: T,
    cosine: T,
    /// Distance of the marker from the axle of a roller; 0 for a straight rail [m].
    roller_radius: f64,
    /// Axes along the rows of the rail, where these drift or rise.
    rows: Option<AlongRows<T>>,
}

/// Axes along the rows of a rail.
#[derive(Clone, Copy, Debug)]
struct AlongRows<T> {
    course: Course<T>,
    /// The same axes in the track frame, and the place there that they count from [m].
    axes: [Vector3<T>; 3],
    origin: Vector3<T>,
}

impl<T: Real> RailFrame<T> {
    /// The frame of a rail that has moved by `motion` from its design position.
    pub fn new(rail: &PlacedRail, motion: &RailMotion<T>) -> Self {
        let (sine, cosine) = motion.roll.sin_cos();
        let marker =
            Vector3::new(T::from(0.0), motion.y + rail.marker[0], motion.z + rail.marker[1]);
        let roller_radius = rail.roller_radius();
        Self { marker, roll: motion.roll, sine, cosine, roller_radius, rows: None }
    }

    /// The same frame with axes along the rows of the rail, where these drift or rise.
    #[must_use]
    pub fn along_rows(self, course: Option<Course<T>>) -> Self {
        let rows = course.map(|course| {
            let axes = course.axes.map(|[x, y, z]| {
                Vector3::new(x, y * self.cosine - z * self.sine, y * self.sine + z * self.cosine)
            });
            AlongRows { course, axes, origin: self.marker + axes[0] * course.ahead }
        });
        Self { rows, ..self }
    }

    /// The axes along the rows of the rail, where these drift or rise.
    pub fn course(&self) -> Option<&Course<T>> {
        self.rows.as_ref().map(|rows| &rows.course)
    }

    /// The wheel as seen from the rail.
    pub fn pose(&self, wheel: &WheelMotion<T>) -> WheelPose<T> {
        let to = Vector3::from(wheel.position) - self.marker;
        let pose = WheelPose {
            // x counts from the wheel marker.
            marker: [
                T::from(0.0),
                to.y * self.cosine + to.z * self.sine,
                to.z * self.cosine - to.y * self.sine,
            ],
            roll: wheel.roll - self.roll,
            yaw: wheel.yaw,
        };
        self.rows.map_or(pose, |rows| rows.course.pose(&pose))
    }

    /// Motion of the `wheel` against the rail with `motion`, both with their x from the wheel
    /// marker, which is `x` ahead of the origin of the track: the axle of a roller crosses that.
    pub fn relative_motion(
        &self,
        wheel: &WheelMotion<T>,
        motion: &RailMotion<T>,
        x: T,
    ) -> RelativeMotion<T> {
        let relative = RelativeMotion::new(wheel, motion, self.marker);
        if self.roller_radius == 0.0 {
            return relative;
        }
        let (zero, radius) = (T::from(0.0), T::from(self.roller_radius));
        let axle = self.marker + self.direction([zero, radius]) - Vector3::x() * x;
        relative.on_roller(axle, self.direction([T::from(1.0), zero]) * motion.pitch_rate)
    }

    /// The direction (y, z) down in the rail's frame.
    pub fn down(&self) -> [T; 2] {
        match &self.rows {
            None => [self.sine, self.cosine],
            Some(AlongRows { axes: [_, right, down], .. }) => [right.z, down.z],
        }
    }

    /// The direction along the rail in the track frame.
    pub fn along(&self) -> Vector3<T> {
        self.rows.as_ref().map_or(Vector3::x(), |rows| rows.axes[0])
    }

    /// A direction (y, z) of the rail's frame in the track frame.
    pub fn direction(&self, [y, z]: [T; 2]) -> Vector3<T> {
        match &self.rows {
            None => Vector3::new(
                T::from(0.0),
                y * self.cosine - z * self.sine,
                y * self.sine + z * self.cosine,
            ),
            Some(AlongRows { axes: [_, right, down], .. }) => *right * y + *down * z,
        }
    }

    /// The point (y, z) of the rail's frame at `x` along the rail from the wheel marker in the track
    /// frame, x from the wheel marker there too [m].
    pub fn point(&self, point: [T; 2], x: T) -> Vector3<T> {
        match &self.rows {
            None => self.marker + self.direction(point) + Vector3::x() * x,
            Some(AlongRows { axes: [along, ..], origin, .. }) => {
                *origin + self.direction(point) + *along * x
            }
        }
    }
}
