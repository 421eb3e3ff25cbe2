//! Where the tread of a rail changes over to its gauge face.

use super::table::Table;
use crate::defaults::with_defaults;

with_defaults! {
    /// Where the tread changes over to the gauge face. By default from 19 to 39 degrees: between
    /// the gauge corner of a new rail and its face.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Changeover {
        /// Inclination of the rail's surface in the middle of it, negative towards the gauge face
        /// [rad].
        pub inclination: f64 = -0.5,
        /// Difference of inclination from one end to the other, > 0 [rad].
        pub width: f64 = 0.35,
    }
}

impl Changeover {
    /// Share of the gauge face over the direction z/(|y| + |z|) of the rail's tangent, 1 towards
    /// the gauge face [-].
    pub(crate) fn gauge_face_share(&self) -> Table {
        let half = 0.5 * self.width;
        Table::over_inclination(&[[self.inclination - half, 1.0], [self.inclination + half, 0.0]])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::friction::direction;
    use crate::friction::table::OFF;
    use approx::assert_abs_diff_eq;

    #[test]
    fn the_share_of_the_gauge_face_grows_across_the_change_over() {
        let share = Changeover { inclination: -0.5, width: 0.2 }.gauge_face_share();
        for (inclination, expected) in
            [(1.2, 0.0), (-0.4, 0.0), (-0.45, 0.25), (-0.5, 0.5), (-0.6, 1.0), (-1.5, 1.0)]
        {
            let tangent = [f64::cos(inclination), f64::sin(inclination)];
            assert_abs_diff_eq!(
                share.at(direction(tangent), &mut 0),
                expected,
                epsilon = 5.0 * OFF
            );
        }
    }
}
