//! The contact line where wheel and rail are not even along the track.

use super::{ContactLine, LinePoint, OnCircle};
use crate::geometry::curves::curve::CurvePoint;
use crate::geometry::uneven::longitudinal::Longitudinal;
use crate::math::real::Real;

/// Least share of its parameter by which the line moves: at the fold of a line, where it stands, a
/// slope over its length has no bound.
const MIN_SPEED: f64 = 0.05;
/// Least share along the normal of a lift, at a face that stands upright.
const MIN_SHARE: f64 = 0.05;

impl<'a, T: Real> ContactLine<'a, T> {
    /// Deviations of wheel and rail along the track, where there are any.
    #[must_use]
    pub fn deviations(&self) -> Option<&'a Longitudinal> {
        self.deviations
    }

    /// Radius of the circles that the wheel shows the rail at parameter `s`: r, and of a yawed
    /// wheel what its section has [m].
    #[must_use]
    pub fn lifting_radius(&self, s: T) -> T {
        let wheel = self.wheel_point(s);
        if self.is_straight() {
            return wheel.rolling_radius;
        }
        let tangent = self.even_at(s).tangent;
        let length = tangent[0].hypotenuse(tangent[1]);
        let normal = [-tangent[1] / length, tangent[0] / length];
        wheel.section_radius * self.lifting_share(normal)
    }

    /// Component along a contact normal (y, z) of a unit of lift [-].
    #[must_use]
    pub fn lifting_share(&self, normal: [T; 2]) -> T {
        (normal[0] * self.down[0] + normal[1] * self.down[1]).at_least(MIN_SHARE)
    }

    /// Derivative of the even line's x with respect to its parameter.
    pub(crate) fn advance(&self, s: T) -> T {
        let p = self.profile.at(s);
        let on = self.circle(&p);
        if self.follows_rim(&p) {
            return self.rim(s, &p, &on).advance();
        }
        self.advance_at(&p, &on)
    }

    /// The same where the profile point `p` is on no rim.
    pub(super) fn advance_at(&self, p: &CurvePoint<T>, on: &OnCircle<T>) -> T {
        let turning = self.turning(p, on);
        p.first[0] * self.axle[0] + self.cosine * (p.first[1] * on.sine + on.radius * turning)
    }
}

impl ContactLine<'_> {
    /// Bound of the derivative of x with respect to the parameter, where
    /// [`stretch_factor`](Self::stretch_factor) is at most `stretch` [1/m].
    #[must_use]
    pub(crate) fn most_advance(&self, stretch: f64) -> f64 {
        self.lead.abs() * (2.0 + 2.0 * self.nominal_radius * stretch)
    }

    /// Bound of the derivative of the lift with respect to the parameter; 0 without deviations.
    #[inline]
    #[must_use]
    pub(crate) fn most_lift_slope(&self, stretch: f64) -> f64 {
        self.deviations.map_or(0.0, |d| self.steepest(d) * self.most_advance(stretch))
    }

    /// Bound of the slope of the lift along the track.
    fn steepest(&self, deviations: &Longitudinal) -> f64 {
        deviations.reach() / (0.5 * self.nominal_radius)
    }

    /// The point at parameter `s` [m], lowered by the lift; x is that of the even line.
    #[cold]
    pub(super) fn lifted(&self, s: f64, deviations: &Longitudinal) -> LinePoint {
        let even = self.even_at(s);
        let radius = self.lifting_radius(s);
        let lift = deviations.lift(even.x, radius);
        let point = [0, 1].map(|i| even.point[i] + lift.height * self.down[i]);
        if self.lead == 0.0 {
            return LinePoint { point, ..even };
        }
        // By how much the lift changes along the line, over the length of the tangent.
        let (_, derivative) = self.even_with_derivative(s);
        let tangent = even.tangent;
        let squared = tangent[0] * tangent[0] + tangent[1] * tangent[1];
        let speed = (derivative[0] * tangent[0] + derivative[1] * tangent[1]) / squared;
        let speed = if speed.abs() < MIN_SPEED { MIN_SPEED.copysign(speed) } else { speed };
        let rate = (lift.x - even.x) / radius * self.advance(s) / speed;
        let tangent = [0, 1].map(|i| tangent[i] + rate * self.down[i]);
        LinePoint { point, tangent, ..even }
    }

    /// The point at parameter `s` [m] where the bodies are nearest to each other, lowered by the
    /// lift, and the derivative of its (y, z); x is where they are, and behind it is the radius of
    /// the circles of the wheel there [m].
    #[must_use]
    pub fn lifted_with_derivative(
        &self,
        s: f64,
        deviations: &Longitudinal,
    ) -> (LinePoint, [f64; 2], f64) {
        let (even, derivative) = self.even_with_derivative(s);
        let radius = self.lifting_radius(s);
        let lift = deviations.lift(even.x, radius);
        // The least of a family of functions changes as the one that is least.
        let rate = (lift.x - even.x) / radius * self.advance(s);
        let lower = |v: [f64; 2], by: f64| [0, 1].map(|i| v[i] + by * self.down[i]);
        let point = lower(even.point, lift.height);
        (LinePoint { x: lift.x, point, ..even }, lower(derivative, rate), radius)
    }

    /// How much longer than the even line the lifted one can be, over
    /// [`stretch_factor`](Self::stretch_factor) [m].
    pub(super) fn lift_stretch(&self, deviations: &Longitudinal) -> f64 {
        2.0 * self.nominal_radius * self.lead.abs() * self.steepest(deviations)
    }
}
