//! Where the tread of a rail changes over to its gauge face.

use crate::math::real::Real;

/// Where the tread changes over to the gauge face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Changeover {
    /// Inclination of the rail's surface in the middle of it, negative towards the gauge face [rad].
    pub inclination: f64,
    /// Difference of inclination from one end to the other, > 0 [rad].
    pub width: f64,
}

impl Default for Changeover {
    /// From 19 to 39 degrees: between the gauge corner of a new rail and its face.
    fn default() -> Self {
        Self { inclination: -0.5, width: 0.35 }
    }
}

impl Changeover {
    /// Share of the gauge face where the surface has that `inclination` [rad].
    #[inline]
    #[must_use]
    pub fn gauge_face_share<T: Real>(&self, inclination: T) -> T {
        ((-inclination + self.inclination) / self.width + 0.5).within(0.0, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;

    #[test]
    fn the_share_of_the_gauge_face_grows_across_the_change_over() {
        let changeover = Changeover { inclination: -0.5, width: 0.2 };
        for (inclination, expected) in
            [(1.2, 0.0), (-0.4, 0.0), (-0.45, 0.25), (-0.5, 0.5), (-0.6, 1.0), (-1.5, 1.0)]
        {
            let share: f64 = changeover.gauge_face_share(inclination);
            assert_abs_diff_eq!(share, expected, epsilon = 1e-15);
        }
    }
}
