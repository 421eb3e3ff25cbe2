//! Damping of the normal motion of strips.

use super::local_place::LocalPlace;
use crate::element::contact::rail_frame::RailFrame;
use crate::geometry::rail::rail_outline::RailOutline;
use crate::geometry::wheel::contact_line::ContactLine;
use crate::kinematics::creepage::RelativeMotion;
use crate::math::real::Real;
use crate::normal::damping;

/// Least pressure with damping over that without: strips that part keep a trace, by which their
/// zone has a normal.
const MIN_FACTOR: f64 = f64::EPSILON;

/// Damping of the normal motion, strip by strip with the normal of each: so it does not depend on
/// which strips are taken together as a zone.
pub struct StripDamping<'a, T: Real = f64> {
    /// How wheel and rail move against each other.
    pub motion: &'a RelativeMotion<T>,
    /// The frame of the rail.
    pub frame: &'a RailFrame<T>,
    /// Load of all strips of the rail and deepest penetration, which share one stiffness [N, m].
    pub whole: [T; 2],
    /// The speeds of [`closing_speed`](RailOutline::closing_speed) on a rail that varies along the
    /// track [m/s].
    pub speeds: [T; 2],
    /// The contact line of a wheel whose section varies around.
    pub around: Option<&'a ContactLine<'a, T>>,
}

impl<T: Real> StripDamping<'_, T> {
    /// Pressure with damping over that without [-], for the damping `coefficient` at the reference
    /// stiffness [N s/m], of a strip at `x` along the track and the parameter u of the contact line [m],
    /// whose surfaces meet at `place`.
    pub fn factor(&self, coefficient: f64, [x, u]: [T; 2], place: &LocalPlace<T>) -> T {
        let &LocalPlace { point, tangent, overlap, along, rise, .. } = place;
        // Backwards it may be the damping that counts.
        if coefficient == 0.0 && !T::IS_BACKWARD {
            return T::from(1.0);
        }
        let [load, penetration] = self.whole;
        let normal = [-tangent[1], tangent[0]];
        // The wheel's surface of first touch lies deeper in the rail by the overlap.
        let touch = [0, 1].map(|axis| point[axis] + overlap * normal[axis]);
        let touch = self.frame.point(touch, x);
        let normal = self.frame.direction(normal);
        let even = self.motion.approach_velocity(touch).dot(&normal);
        let even = along
            .map_or(even, |along| even + RailOutline::closing_speed(&along, rise, self.speeds));
        let lever = along.map_or(T::from(0.0), |along| along.lever);
        let ahead = self.around.map_or(lever, |line| line.ahead_of_round(u) + lever);
        let closing = even + self.motion.turning_velocity(self.frame.along() * ahead).dot(&normal);
        (damping::damped_load(load, penetration, closing, coefficient) / load).at_least(MIN_FACTOR)
    }
}
