//! The outline of a rail that varies, with derivatives.

use super::{Stand, VaryingRail};
use crate::geometry::curves::curve::CurvePoint;
use crate::geometry::rail::course::Course;
use crate::geometry::sections::rows::along::Along;
use crate::geometry::sections::rows::envelope::Envelope;
use crate::geometry::sections::rows::met::Met;
use crate::geometry::uneven::bridge::Bridge;
use crate::geometry::wheel::wheel_pose::WheelPose;
use crate::math::fixed_vec::FixedVec;
use crate::math::real::Real;

/// The outline of a rail that varies, as it moves with the wheel that meets it.
#[derive(Clone, Debug)]
pub struct MovingOutline<T> {
    pub(super) envelope: Envelope<T>,
    pub(super) met: FixedVec<Met<T>>,
    pub(super) stand: Stand<T>,
    pub(super) course: Option<Course<T>>,
}

impl<T: Real> MovingOutline<T> {
    /// Room for an outline of `count` rows.
    pub fn new(count: usize) -> Self {
        let (met, stand) = (FixedVec::new(count), Stand::default());
        Self { envelope: Envelope::new(count), met, stand, course: None }
    }

    /// Point and derivatives of the outline at parameter `s` [m].
    pub fn at(&self, s: T) -> CurvePoint<T> {
        self.envelope.at(s)
    }

    /// How far ahead of the even contact line the wheel meets the rail at parameter `s` of the
    /// outline [m].
    pub fn ahead(&self, s: T) -> T {
        self.envelope.ahead(s)
    }

    /// Where the wheel meets the rail at parameter `s` of the outline.
    pub fn along(&self, s: T) -> Along<T> {
        self.envelope.along(s)
    }

    /// Takes the axes along the rows of the `rail` near a wheel that stands at `pose` above `station`
    /// [m].
    pub fn follow_rows(&mut self, rail: &VaryingRail, pose: &WheelPose<T>, station: T) {
        self.course = rail.course_under(pose, station).filter(|_| rail.course().is_some());
    }

    /// The axes along the rows near the wheel, where these drift or rise.
    pub fn course(&self) -> Option<Course<T>> {
        self.course
    }

    /// As [`VaryingRail::bridge`], of the `rail` that this is the outline of.
    pub fn bridge(&self, rail: &VaryingRail, point: [T; 3], circle: [T; 2]) -> Bridge<T> {
        rail.bridge_under(&self.stand, self.course.as_ref(), point, circle)
    }

    /// As [`VaryingRail::wave_slopes`].
    pub fn wave_slopes(&self, rail: &VaryingRail, point: [T; 3]) -> ([T; 2], T) {
        rail.wave_slopes_under(&self.stand, self.course.as_ref(), point)
    }

    /// As [`VaryingRail::lever_per_slope`].
    pub fn lever_per_slope(&self, rail: &VaryingRail, point: [T; 3]) -> T {
        rail.lever_per_slope_under(&self.stand, point)
    }

    /// A place (x, y, z) of the rail, x from the wheel marker, along the rows as the wheel moves on
    /// [m].
    pub fn passed(&self, [x, y, z]: [f64; 3]) -> T {
        let x = T::moving(x, -self.stand.station);
        self.course.map_or(x, |course| course.place([x, y.into(), z.into()])[0])
    }
}
