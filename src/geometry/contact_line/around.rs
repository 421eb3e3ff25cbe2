//! The contact line of a wheel whose section varies around.

use super::{ContactLine, LEAST_SECTION_SHARE, LinePoint};
use crate::geometry::varying_wheel::{BesideRound, VaryingWheel};
use crate::math::real::Real;

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
    #[must_use]
    pub fn round(&self) -> Self {
        Self { around: None, ..*self }
    }

    /// How far ahead of the round wheel the one whose section varies around is met at parameter `s` [m].
    #[must_use]
    pub fn ahead_of_round(&self, s: T) -> T {
        self.around.map_or(0.0, |around| around.beside_round(s.value()).ahead).into()
    }

    /// Whether the section of the wheel varies around.
    #[must_use]
    pub fn varies_around(&self) -> bool {
        self.around.is_some()
    }

    /// Curvature of the section along x at parameter `s`, of which `round` is that of the round wheel and `straight` that of one that does not yaw [1/m].
    pub(super) fn section_around(&self, s: T, round: T, straight: T) -> T {
        let Some(around) = self.around else { return round };
        let BesideRound { curvature, share_across, .. } = around.beside_round(s.value());
        let section = round + self.mean_curvature(s) * share_across + curvature;
        section.max(straight * LEAST_SECTION_SHARE)
    }
}

impl<'a> ContactLine<'a> {
    /// The line of a wheel whose section varies `around` and was laid into the profile.
    #[must_use]
    pub fn varying(self, around: &'a VaryingWheel) -> Self {
        Self { around: Some(around), ..self }
    }
}
