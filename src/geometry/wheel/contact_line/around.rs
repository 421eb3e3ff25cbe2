//! The contact line of a wheel whose section varies around.

use super::{ContactLine, LinePoint, MIN_SECTION_SHARE};
use crate::geometry::wheel::surface_point::{Below, SurfacePoint};
use crate::geometry::wheel::varying_wheel::{BesideRound, VaryingWheel};
use crate::math::real::Real;

/// Reach over the distance of samples below which differences are no better than the curvature itself.
const MIN_REACH: f64 = 1e-2;

impl<T: Real> ContactLine<'_, T> {
    /// A `point` of the round wheel at parameter `s`, where the wheel that varies around is met.
    #[inline]
    pub(super) fn met(&self, s: T, point: LinePoint<T>) -> LinePoint<T> {
        if self.around.is_none() {
            return point;
        }
        LinePoint { x: point.x + self.ahead_of_round(s), ..point }
    }

    /// The round wheel that takes the place of one whose section varies around.
    pub fn round(&self) -> Self {
        Self { around: None, ..*self }
    }

    /// How far ahead of the round wheel the one whose section varies around is met at parameter `s`
    /// [m].
    pub fn ahead_of_round(&self, s: T) -> T {
        self.around.map_or(0.0, |around| around.beside_round(s.value()).ahead).into()
    }

    /// Whether the section of the wheel varies around.
    pub fn varies_around(&self) -> bool {
        self.around.is_some()
    }

    /// Curvature of the section along x at parameter `s`, of which `round` is that of the round
    /// wheel and `straight` that of one that does not yaw [1/m].
    pub(super) fn section_around(&self, s: T, round: T, straight: T) -> T {
        let Some(around) = self.around else { return round };
        let BesideRound { curvature, share_across, .. } = around.beside_round(s.value());
        let section = round + self.mean_curvature(s) * share_across + curvature;
        section.max(straight * MIN_SECTION_SHARE)
    }
}

impl<'a> ContactLine<'a> {
    /// The line of a wheel whose section varies `around` and was laid into the profile.
    #[must_use]
    pub fn varying(self, around: &'a VaryingWheel) -> Self {
        Self { around: Some(around), ..self }
    }

    /// As [`surface_along`](Self::surface_along), of the wheel whose section varies `around`.
    pub(super) fn surface_around(
        &self,
        around: &VaryingWheel,
        x: f64,
        from: [f64; 2],
        direction: [f64; 2],
        guess: [f64; 2],
    ) -> Option<SurfacePoint> {
        let axes = self.axes();
        let start =
            self.seen([x - self.marker[0], from[0] - self.marker[1], from[1] - self.marker[2]]);
        let met =
            around.surface_along(start, self.seen([0.0, direction[0], direction[1]]), guess)?;
        let normal =
            [0, 1, 2].map(|i| axes.iter().zip(met.normal).map(|(axis, n)| n * axis[i]).sum());
        Some(SurfacePoint { normal, ..met })
    }

    /// The surface of a wheel whose section varies around, along the radius from a place given by its
    /// parts along the axle, forward and down from the marker, sought near the parameter of the line
    /// and the depth of `guess` [m]; its normal has such parts. Nothing where it is not there.
    pub(in crate::geometry) fn along_radius(
        &self,
        from: [f64; 3],
        guess: [f64; 2],
    ) -> Option<SurfacePoint> {
        let [_, forward, down] = from;
        let size = forward.hypot(down);
        self.around?.surface_along(from, [0.0, forward / size, down / size], guess)
    }

    /// What the wheel is more curved along the track than the round one in its place, over the
    /// distance `reach` to either side of a place along the track, `own` and that `of_round`, at
    /// which both lean alike: by their distances from the point `from` of the rail (y, z) and those
    /// ahead of it and behind, along the unit `direction` into the rail, sought near the parameter
    /// and the depth of `guess`. Nothing where differences are no better than the curvature at the
    /// place itself, and where the wheel ends [1/m].
    pub fn mean_curvature_around(
        &self,
        [own, of_round]: [f64; 2],
        from: [f64; 2],
        direction: [f64; 2],
        guess: [f64; 2],
        reach: f64,
    ) -> Option<f64> {
        self.around.filter(|around| reach > MIN_REACH * around.spacing())?;
        let mean = |line: &Self, x: f64| {
            let met = |x| line.surface_along(x, from, direction, guess);
            let [here, ahead, behind] = [met(x)?, met(x + reach)?, met(x - reach)?];
            Some((2.0 * here.depth - ahead.depth - behind.depth) / (reach * reach))
        };
        Some(mean(self, own)? - mean(&self.round(), of_round)?)
    }

    /// The surface of a wheel whose section varies around below the point (`x`, `from`), with the
    /// directions (y, z) to the right and down, sought near the parameter of the line and the depth
    /// of `guess`; nothing where it is not there.
    pub fn wheel_below(
        &self,
        x: f64,
        from: [f64; 2],
        [right, down]: [[f64; 2]; 2],
        guess: [f64; 2],
    ) -> Option<Below> {
        let start =
            self.seen([x - self.marker[0], from[0] - self.marker[1], from[1] - self.marker[2]]);
        let directions = [[1.0, 0.0, 0.0], [0.0, right[0], right[1]], [0.0, down[0], down[1]]];
        self.around?.below(start, directions.map(|way| self.seen(way)), guess)
    }

    /// How far ahead of the axle the normal of the surface passes it which is `below` the place at `x`
    /// along the track and `y` to the right of the marker, of round wheels nowhere [m].
    ///
    /// As it turns the wheel moves by u × r: with n along (-z_x, -z_y, 1) that is
    /// -n · (u × r)/cos ψ.
    pub fn lever(&self, [x, y]: [f64; 2], below: &Below) -> f64 {
        let (sine, cosine) = (-self.axle[0], self.cosine);
        let [by_x, by_y] = below.slopes;
        let forward = x * cosine + y * sine;
        (below.depth * (by_x * cosine + by_y * sine) + forward) / cosine
    }

    /// How far ahead of where a round wheel would be met or behind one whose section varies around
    /// may be met on an even rail [m].
    pub fn reach_around(&self) -> f64 {
        self.around.map_or(0.0, |around| around.reach(0.0))
    }

    /// The parts of a vector along the axle, forward and down.
    fn seen(&self, v: [f64; 3]) -> [f64; 3] {
        self.axes().map(|a| a[0] * v[0] + a[1] * v[1] + a[2] * v[2])
    }

    /// Places along the track between which a wheel that is met at parameter `s` and the place `met`
    /// and overlaps a rail by up to `depth` there may do so, all [m].
    pub fn reach(&self, s: f64, met: f64, depth: f64) -> Option<[f64; 2]> {
        let reach = self.around?.reach(depth);
        let x = met - self.ahead_of_round(s);
        Some([x - reach, x + reach])
    }
}
