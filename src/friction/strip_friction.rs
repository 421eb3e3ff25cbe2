//! Coefficient of friction of one strip.

use crate::math::numbers::numbers;
use crate::math::real::Real;

/// Coefficient of friction of one strip, before slip changes it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StripFriction<T = f64> {
    /// Coefficient where the strip is of the tread, ≥ 0 [-].
    pub tread: T,
    /// Coefficient where it is of the gauge face, ≥ 0 [-].
    pub gauge_face: T,
    /// Share of the gauge face in the strip, 0 to 1 [-].
    pub gauge_face_share: T,
}

numbers!(StripFriction: tread, gauge_face, gauge_face_share);

impl<T: Real> StripFriction<T> {
    /// The same coefficient on tread and gauge face.
    pub fn of(coefficient: T) -> Self {
        Self { tread: coefficient, gauge_face: coefficient, gauge_face_share: T::from(0.0) }
    }

    /// What is between this and `other`, of which it has the `share`, 0 to 1.
    pub fn towards(&self, other: &Self, share: T) -> Self {
        let between = |from: T, to: T| from + share * (to - from);
        Self {
            tread: between(self.tread, other.tread),
            gauge_face: between(self.gauge_face, other.gauge_face),
            gauge_face_share: between(self.gauge_face_share, other.gauge_face_share),
        }
    }

    /// The coefficient when slip changes that of tread and gauge face by `factors` [-].
    #[inline]
    pub fn under(&self, factors: &[T; 2]) -> T {
        let tread = self.tread * factors[0];
        // From the tread on, so that two alike give the same to the last bit.
        tread + self.gauge_face_share * (self.gauge_face * factors[1] - tread)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn tread_and_gauge_face_fall_by_their_own_laws() {
        let own = StripFriction { tread: 0.4, gauge_face: 0.1, gauge_face_share: 0.25 };
        assert_relative_eq!(own.under(&[0.5, 1.0]), 0.75 * 0.2 + 0.25 * 0.1, max_relative = 1e-15);
    }
}
