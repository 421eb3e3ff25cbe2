//! Waves of a rail that varies and of the wheel over it, at places where both are near.

use super::waves::bulge_over;
use super::{Stand, VaryingRail};
use crate::geometry::rail::course::Course;
use crate::geometry::sections::rows::surface::Surface;
use crate::geometry::uneven::wavy_section::{Waves, WavySection};
use crate::geometry::wheel::wheel_pose::WheelPose;
use crate::math::real::Real;

/// Way over which it is told how fast places on waves go with x [m].
const RATE_REACH: f64 = 1e-3;

impl VaryingRail {
    /// How far waves of rail and wheel bring both nearer to each other at most [m].
    pub fn highest(&self) -> f64 {
        self.surface.corrugation.bounds().range[1] + self.waves.bounds().range[1]
    }

    /// Whether rail or wheel have waves over their even surfaces.
    pub fn has_waves(&self) -> bool {
        self.is_corrugated() || !self.waves.is_empty()
    }

    /// Whether the wheel has.
    pub fn wheel_has_waves(&self) -> bool {
        !self.waves.is_empty()
    }

    /// Whether all rows are higher by a corrugation.
    pub fn is_corrugated(&self) -> bool {
        self.surface.is_corrugated()
    }

    /// By how much a corrugation is more curved over the distance `reach` to either side of the
    /// point (x, y, z) than there [m], x from the marker of the wheel that passed last, y and z of
    /// the outline, positive where it bulges more [1/m]; nothing where it is as good as that.
    pub fn bridged(&self, point: [f64; 3], reach: f64) -> Option<f64> {
        self.bridged_under(&self.stand, self.course(), point, reach)
    }

    /// Curvature of the waves of the wheel over the distance `reach` to either side of the same
    /// point [m], positive where they bulge [1/m]; nothing where that of the place is as good.
    pub fn waves_over(&self, point: [f64; 3], reach: f64) -> Option<f64> {
        self.waves_over_under(&self.stand, point, reach)
    }

    /// As [`bridged`](Self::bridged), under a wheel that stands so, in the axes along `course`.
    pub(super) fn bridged_under<T: Real>(
        &self,
        stand: &Stand<T>,
        course: Option<&Course<T>>,
        point: [T; 3],
        reach: T,
    ) -> Option<T> {
        let corrugation = &self.surface.corrugation;
        let place = self.place_on_rail(stand, course, point);
        Some(bulge_over(corrugation, place, reach)? + corrugation.moving(place)[2])
    }

    /// As [`waves_over`](Self::waves_over), of a wheel that stands so.
    pub(super) fn waves_over_under<T: Real>(
        &self,
        stand: &Stand<T>,
        point: [T; 3],
        reach: T,
    ) -> Option<T> {
        bulge_over(&self.waves, self.place_on_wheel(stand, point), reach)
    }

    /// The waves of rail and wheel about the same point, over x from the marker.
    pub fn waves_about(&self, [x, y, z]: [f64; 3]) -> WavySection<'_> {
        let about = |surface, place: &dyn Fn([f64; 3]) -> f64| {
            let [behind, here, ahead] =
                [-RATE_REACH, 0.0, RATE_REACH].map(|way| place([x + way, y, z]));
            let rate = (ahead - behind) / (2.0 * RATE_REACH);
            Waves { surface, at: here - rate * x, rate }
        };
        WavySection::new(
            about(&self.surface.corrugation, &|point| {
                self.place_on_rail(&self.stand, self.course(), point)
            }),
            about(&self.waves, &|point| self.place_on_wheel(&self.stand, point)),
        )
    }

    /// Place on the corrugation at that point [m].
    fn place_on_rail<T: Real>(
        &self,
        stand: &Stand<T>,
        course: Option<&Course<T>>,
        [x, y, z]: [T; 3],
    ) -> T {
        let along_track = course.map_or(x, |course| course.on_rail([x, y, z])[0]);
        let place = stand.station + along_track;
        self.surface.roller.map_or(place, |roller| roller.arc(place, z))
    }

    /// Place on the nominal rolling circle at that point [m].
    fn place_on_wheel<T: Real>(&self, stand: &Stand<T>, [x, y, z]: [T; 3]) -> T {
        let WheelPose { marker, roll, yaw } = stand.pose;
        let (sine, cosine) = roll.sin_cos();
        let (y, z) = (y - marker[1], z - marker[2]);
        let (across, below) = (y * cosine + z * sine, z * cosine - y * sine);
        let (sine, cosine) = yaw.sin_cos();
        let angle = (x * cosine + across * sine).atan2(below);
        (angle - stand.pitch) * self.nominal_radius
    }

    /// How much higher a roller gets at the point (x, z), as of [`bridged`](Self::bridged), as the
    /// arc on its top grows; 0 for a rail, which lies still [-].
    pub fn rise(&self, [x, z]: [f64; 2]) -> f64 {
        let Surface { roller, corrugation, .. } = &self.surface;
        match roller {
            Some(roller) if !corrugation.is_empty() => {
                roller.rise(corrugation, self.stand.station + x, z)
            }
            _ => 0.0,
        }
    }
}
