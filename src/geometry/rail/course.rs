//! Axes along the mean course of the rows of a rail.
//!
//! Sections that drift evenly to the side by d and rise by l along the track are an even rail in
//! the direction (1, d, l). In axes along that, with the right hand level,
//!
//! ```text
//! a = (1, d, l)/n,   b = (-d, 1, 0)/m,   c = a × b = (-l, -l d, 1 + d²)/(n m)
//! ```
//!
//! its rows are straight lines along the first axis, and the wheel is one that yaws and rolls
//! otherwise. The frame lies where the wheel marker has no part along the first axis, so that
//! places still count from there.

use crate::geometry::sections::rows::surface::RowPoint;
use crate::geometry::wheel::wheel_pose::WheelPose;
use crate::math::real::Real;

/// Axes along the mean course of the rows of a rail, under a wheel, in the frame of the rail with
/// x from the wheel marker.
#[derive(Clone, Copy, Debug)]
pub struct Course<T = f64> {
    /// Unit vectors along the rows, to the right and down.
    pub axes: [[T; 3]; 3],
    /// How far along the rows the wheel marker is from the rail marker [m].
    pub ahead: T,
}

/// Scalar product.
fn dot<T: Real>(a: [T; 3], b: [T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

impl<T: Real> Course<T> {
    /// Those along rows that go by `drift` to the right and by `fall` down for each unit along the
    /// track, under a wheel whose marker is at `marker`.
    pub fn new([drift, fall]: [T; 2], marker: [T; 3]) -> Self {
        let one = T::from(1.0);
        let level = drift * drift + 1.0;
        let (n, m) = (one / (level + fall * fall).sqrt(), one / level.sqrt());
        let along = [n, drift * n, fall * n];
        let right = [T::from(0.0) - drift * m, m, T::from(0.0)];
        let down =
            [T::from(0.0) - fall * n * m, T::from(0.0) - fall * drift * n * m, level * n * m];
        let ahead = along[1] * marker[1] + along[2] * marker[2];
        Self { axes: [along, right, down], ahead }
    }

    /// The pose of a wheel that stands at `pose` against the rail, in these axes.
    pub fn pose(&self, pose: &WheelPose<T>) -> WheelPose<T> {
        let marker = self.place(pose.marker);
        let (sin_roll, cos_roll) = pose.roll.sin_cos();
        let (sin_yaw, cos_yaw) = pose.yaw.sin_cos();
        let axle = [T::from(0.0) - sin_yaw, cos_yaw * cos_roll, cos_yaw * sin_roll];
        let [x, y, z] = self.axes.map(|axis| dot(axis, axle));
        WheelPose {
            marker: [T::from(0.0), marker[1], marker[2]],
            roll: z.atan2(y),
            yaw: (T::from(0.0) - x).atan2(y.hypotenuse(z)),
        }
    }

    /// A place of the rail in these axes [m].
    pub(in crate::geometry) fn place(&self, place: [T; 3]) -> [T; 3] {
        let [x, y, z] = self.axes.map(|axis| dot(axis, place));
        [x - self.ahead, y, z]
    }

    /// A place in these axes in the frame of the rail [m].
    pub fn on_rail(&self, [x, y, z]: [T; 3]) -> [T; 3] {
        let [along, right, down] = self.axes;
        [0, 1, 2].map(|c| along[c] * (x + self.ahead) + right[c] * y + down[c] * z)
    }

    /// A vector in these axes in the frame of the rail.
    pub(in crate::geometry) fn direction_on_rail(&self, [x, y, z]: [T; 3]) -> [T; 3] {
        let [along, right, down] = self.axes;
        [0, 1, 2].map(|c| along[c] * x + right[c] * y + down[c] * z)
    }

    /// The parts to the right and down in these axes of a vector of the rail.
    pub(in crate::geometry) fn across(&self, v: [T; 3]) -> [T; 2] {
        let [_, right, down] = self.axes;
        [dot(right, v), dot(down, v)]
    }

    /// How fast the row of which `p` is a point goes along these axes as it goes along the track
    /// [-].
    fn rate(&self, p: &RowPoint<T>) -> T {
        let [along, ..] = self.axes;
        along[0] + along[1] * p.first[0] + along[2] * p.first[1]
    }

    /// The same, and first and second derivatives to the right and down of the row by its place
    /// along these axes.
    pub(in crate::geometry) fn way(&self, p: &RowPoint<T>) -> (T, [[T; 2]; 2]) {
        let [along, ..] = self.axes;
        let rate = self.rate(p);
        let slowness = T::from(1.0) / rate;
        let bent = (along[1] * p.second[0] + along[2] * p.second[1]) * slowness;
        let way = self.across([T::from(1.0), p.first[0], p.first[1]]);
        let bend = self.across([T::from(0.0), p.second[0], p.second[1]]);
        let squared = slowness * slowness;
        let second = [0, 1].map(|c| (bend[c] - way[c] * bent) * squared);
        (rate, [way.map(|v| v * slowness), second])
    }

    /// Direction straight across these axes from row to row, at the point `p` of one.
    pub(in crate::geometry) fn straight_across(&self, p: &RowPoint<T>) -> [T; 2] {
        let [along, ..] = self.axes;
        let slowness = T::from(1.0) / self.rate(p);
        let [zero, one] = [0.0, 1.0].map(T::from);
        // By how much the place along the track falls back so that one across goes straight.
        let back = (along[1] * p.value[2] + along[2] * p.value[3]) * slowness;
        let across = self.across([zero, p.value[2], p.value[3]]);
        let way = self.across([one, p.first[0], p.first[1]]);
        [0, 1].map(|c| across[c] - way[c] * back)
    }

    /// What the pitch of a wheel that stands at `pose` against the rail is less in these axes,
    /// where it stands at `turned` [rad].
    pub fn pitch(&self, pose: &WheelPose<T>, turned: &WheelPose<T>) -> T {
        let [_, right, down] = self.axes;
        let (sine, cosine) = turned.roll.sin_cos();
        let below = [0, 1, 2].map(|c| down[c] * cosine - right[c] * sine);
        let (sin_roll, cos_roll) = pose.roll.sin_cos();
        let (sin_yaw, cos_yaw) = pose.yaw.sin_cos();
        let forward = [cos_yaw, sin_yaw * cos_roll, sin_yaw * sin_roll];
        dot(below, forward).atan2(dot(below, [T::from(0.0), -sin_roll, cos_roll]))
    }
}
