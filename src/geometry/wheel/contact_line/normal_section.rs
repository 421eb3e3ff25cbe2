//! The section of the wheel along the track at a place of its contact line, and heights above it.

use super::ContactLine;
use crate::math::real::Real;

/// Least share along the normal of a unit of height, at a face that stands upright.
const MIN_SHARE: f64 = 0.05;

impl<T: Real> ContactLine<'_, T> {
    /// Radius of the circles that the wheel shows the rail at parameter `s`: r, and of a yawed
    /// wheel what its section has [m].
    pub fn circle_radius(&self, s: T) -> T {
        let wheel = self.wheel_point(s);
        if self.is_straight() {
            return wheel.rolling_radius;
        }
        let tangent = self.at(s).tangent;
        let length = tangent[0].hypotenuse(tangent[1]);
        let normal = [-tangent[1] / length, tangent[0] / length];
        wheel.section_radius * self.share_of_height(normal)
    }

    /// Component along a contact normal (y, z) of a unit of height [-].
    pub fn share_of_height(&self, normal: [T; 2]) -> T {
        (normal[0] * self.down[0] + normal[1] * self.down[1]).at_least(MIN_SHARE)
    }
}
