//! Waves of a rail that varies and of the wheel over it, at places where both are near.

use super::{Stand, VaryingRail};
use crate::geometry::rail::course::Course;
use crate::geometry::sections::rows::surface::Surface;
use crate::geometry::uneven::bridge::Bridge;
use crate::geometry::uneven::waviness::Waviness;
use crate::geometry::uneven::wavy_section::{SPACING, Waves, WavySection};
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

    /// The parabola that a strip is taken for whose even bodies have a `circle` together, by its radius
    /// and how deep it overlaps at most along the height, about the point (x, y, z) [m]; x from the
    /// marker of the wheel that passed last, y and z of the outline.
    pub fn bridge(&self, point: [f64; 3], circle: [f64; 2]) -> Bridge<f64> {
        self.bridge_under(&self.stand, self.course(), point, circle)
    }

    /// The same under a wheel that stands so, in the axes along `course`.
    pub(super) fn bridge_under<T: Real>(
        &self,
        stand: &Stand<T>,
        course: Option<&Course<T>>,
        point: [T; 3],
        circle: [T; 2],
    ) -> Bridge<T> {
        let corrugation = &self.surface.corrugation;
        let is_there = |waves: &Waviness| !waves.is_empty();
        let rail = is_there(corrugation)
            .then(|| on_line(point, |point| self.place_on_rail(stand, course, point)));
        let wheel = is_there(&self.waves)
            .then(|| on_line(point, |point| self.place_on_wheel(stand, point)));
        let bodies = [(corrugation, rail), (&self.waves, wheel)];
        let [one, other] = bodies.map(|(waves, _)| waves.bounds());
        let range = one.range[1] - one.range[0] + other.range[1] - other.range[0];
        let spacing = one.spacing.min(other.spacing).clamp(SPACING[0], SPACING[1]);
        let bridge = Bridge::new(circle, [range, spacing], |x| {
            bodies.map(|(waves, line)| {
                let Some([at, rate]) = line else { return [T::from(0.0); 2] };
                let [height, slope, _] = waves.moving(at + rate * x);
                [height, slope * rate]
            })
        });
        // All of it is the rail's where the wheel has none.
        let [rail, wheel] = bridge.slopes;
        let none = T::from(0.0);
        let slopes = if self.waves.is_empty() { [rail + wheel, none] } else { bridge.slopes };
        Bridge { slopes, ..bridge }
    }

    /// Slopes of the waves of rail and wheel at the point (x, y, z) of the outline, x from the marker
    /// of the wheel that passed last, along the track [-], and the curvature of those of the rail
    /// [1/m].
    pub fn wave_slopes(&self, point: [f64; 3]) -> ([f64; 2], f64) {
        self.wave_slopes_under(&self.stand, self.course(), point)
    }

    /// How far ahead of its axle the normal of the wheel passes at the same point, over the slope of its
    /// waves there [m].
    pub fn lever_per_slope(&self, point: [f64; 3]) -> f64 {
        self.lever_per_slope_under(&self.stand, point)
    }

    /// As [`wave_slopes`](Self::wave_slopes), under a wheel that stands so, in the axes along `course`.
    pub(super) fn wave_slopes_under<T: Real>(
        &self,
        stand: &Stand<T>,
        course: Option<&Course<T>>,
        point: [T; 3],
    ) -> ([T; 2], T) {
        let [at, rate] = on_line(point, |point| self.place_on_rail(stand, course, point));
        let [_, rail, curvature] = self.surface.corrugation.moving(at);
        let [on_wheel, wheel_rate] = on_line(point, |point| self.place_on_wheel(stand, point));
        let [_, wheel, _] = self.waves.moving(on_wheel);
        ([rail * rate, wheel * wheel_rate], curvature * rate * rate)
    }

    /// As [`lever_per_slope`](Self::lever_per_slope), of a wheel that stands so.
    pub(super) fn lever_per_slope_under<T: Real>(&self, stand: &Stand<T>, point: [T; 3]) -> T {
        let [_, rate] = on_line(point, |point| self.place_on_wheel(stand, point));
        T::from(self.nominal_radius) / rate
    }

    /// Whether the rows go straight on along the track but for a corrugation.
    pub fn is_straight(&self) -> bool {
        self.is_straight
    }

    /// The waves of rail and wheel about the point (x, y, z) of [`bridge`](Self::bridge), over x from
    /// the marker.
    pub fn waves_about(&self, [x, y, z]: [f64; 3]) -> WavySection<'_> {
        let about = |surface, place: &dyn Fn([f64; 3]) -> f64| {
            let [here, rate] = on_line([x, y, z], place);
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

    /// How much higher a roller gets at the point (x, z), as of [`bridge`](Self::bridge), as the
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

/// The place on a body at the point (x, y, z) [m], and how fast it goes with x [-].
fn on_line<T: Real>([x, y, z]: [T; 3], place: impl Fn([T; 3]) -> T) -> [T; 2] {
    let [behind, ahead] = [x - RATE_REACH, x + RATE_REACH].map(|x| place([x, y, z]));
    [place([x, y, z]), (ahead - behind) / (2.0 * RATE_REACH)]
}
