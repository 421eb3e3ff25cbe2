//! The frame of the rails of one side, in which they run along x as those of an element do.
//!
//! Contact sees wheel and rail: rails that run at an angle to the track are rails along x under a
//! wheel that is turned, moves and stands accordingly. Velocities stay those against the ground:
//! rails lie still, so that what slips is what it is, and a wheel that follows its rails does not
//! come nearer to them.

use nalgebra::{Matrix3, Vector3};

use super::track::{RailLine, TrackTurn};
use crate::element::output::Wrench;
use crate::kinematics::motion::WheelMotion;
use crate::math::real::Real;

/// Axes of the rails of a side, and the point of the track that has the same coordinates in both
/// frames but for the deviation of the rails.
#[derive(Clone, Debug)]
pub struct RailFrame<T: Real> {
    /// Unit vectors along the rails, across and horizontal, and down, by columns.
    axes: Matrix3<T>,
    pivot: Vector3<T>,
    shift: Vector3<T>,
}

impl<T: Real> RailFrame<T> {
    /// Of rails on a `line` of a track that turns, `y` [m] to the right of its middle, under a
    /// wheelset at `x` [m].
    pub fn new(line: &RailLine<T>, turn: &TrackTurn<T>, x: T, y: f64) -> Self {
        let zero = T::from(0.0);
        let design = turn.direction(T::from(y));
        let [a, b, c] = [design.x, design.y + line.y_slope, design.z + line.z_slope];
        let flat = a.hypotenuse(b);
        let (sin_yaw, cos_yaw) = (b / flat, a / flat);
        let long = flat.hypotenuse(c);
        let (sin_dip, cos_dip) = (c / long, flat / long);
        let axes = Matrix3::from_columns(&[
            Vector3::new(cos_dip * cos_yaw, cos_dip * sin_yaw, sin_dip),
            Vector3::new(-sin_yaw, cos_yaw, zero),
            Vector3::new(-sin_dip * cos_yaw, -sin_dip * sin_yaw, cos_dip),
        ]);
        let pivot = Vector3::new(x, T::from(y), zero);
        Self { axes, pivot, shift: Vector3::new(zero, line.y, line.z) }
    }

    /// A motion in the track frame, as the rails see it.
    pub fn motion(&self, motion: &WheelMotion<T>) -> WheelMotion<T> {
        let back = self.axes.transpose();
        let position = Vector3::from(motion.position) - self.pivot - self.shift;
        let moved = WheelMotion {
            position: (self.pivot + back * position).into(),
            velocity: (back * Vector3::from(motion.velocity)).into(),
            ..*motion
        };
        moved.seen_from(&self.axes)
    }

    /// A force and moment in the frame of the rails, in the track frame.
    pub fn wrench(&self, wrench: &Wrench<T>) -> Wrench<T> {
        let out = |vector: [T; 3]| (self.axes * Vector3::from(vector)).into();
        Wrench { force: out(wrench.force), moment: out(wrench.moment) }
    }

    /// The reverse of [`wrench`](Self::wrench).
    pub fn wrench_within(&self, wrench: &Wrench<T>) -> Wrench<T> {
        let within = |vector: [T; 3]| (self.axes.transpose() * Vector3::from(vector)).into();
        Wrench { force: within(wrench.force), moment: within(wrench.moment) }
    }

    /// A place in the frame of the rails, in the track frame [m].
    pub fn place(&self, place: [T; 3]) -> [T; 3] {
        let arm = Vector3::from(place) - self.pivot;
        (self.pivot + self.shift + self.axes * arm).into()
    }

    /// The reverse of [`place`](Self::place).
    pub fn place_within(&self, place: [T; 3]) -> [T; 3] {
        let arm = Vector3::from(place) - self.pivot - self.shift;
        (self.pivot + self.axes.transpose() * arm).into()
    }

    /// Height in the track frame of a body that stands at `z` there and at `within` in the frame of
    /// the rails, when it is lifted along the former's z axis to a height `found` in the latter's
    /// [m].
    pub fn height(&self, z: T, [within, found]: [T; 2]) -> T {
        z + (found - within) / self.axes[(2, 2)]
    }

    /// The reverse of [`height`](Self::height).
    pub fn height_within(&self, within: T, [z, found]: [T; 2]) -> T {
        within + (found - z) * self.axes[(2, 2)]
    }
}
