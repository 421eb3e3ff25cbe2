//! The deviation of a wheel's surface, above a rail that varies along the track, from the circle
//! about the axle through its contact line.
//!
//! A place at x, y across and z below the axle has the distance ρ from that axle, and the contact
//! line opposite the height z_l. The amount by which the wheel is larger there,
//!
//! ```text
//! e = ρ - z_l,  ρ = sqrt((x - x_l)² + z²)
//! ```
//!
//! for a z on its surface, brings it nearer to the rail by as much. A wheel without yaw has such
//! circles. The sections along the track of one that yaws have not, nor has one whose section varies
//! around: straight lines down meet its surface. Deviations over the angle add to that, at the angle
//! of the place about the axle.

use super::over::{Opposite, Over};
use super::waves::Waves;
use crate::geometry::sections::rows::plane::dot;
use crate::geometry::wheel::surface_point::Below;
use crate::math::real::Real;

/// How far the wheel is from the round one at a place.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Deviation<T = f64> {
    /// By how much its radius is larger [m].
    pub raised: T,
    /// Derivatives of that along the track, to the right and down [-].
    pub slopes: [T; 3],
    /// Second derivative along the track [1/m].
    pub bend: T,
    /// Curvature of the surface without waves along the track, positive where it bulges; of a
    /// wheel without yaw zero [1/m].
    pub curvature: T,
    /// Curvature of waves [1/m].
    pub waves: T,
    /// How much of that a round wheel does not have [m].
    pub unround: T,
    /// How far ahead of the place that a round wheel's normal would come from, and of how far the
    /// contact line is ahead of that of a round wheel, the normal passes the axle [m].
    pub lever: T,
}

impl<T: Real> Deviation<T> {
    /// Of a wheel whose surface is `below` a place `away` along the track from its contact line, of
    /// which the point `wheel` is opposite, `radius` below the axle; `lateral` is the slope of the
    /// line there.
    fn of_surface(below: &Below<T>, [away, radius, lateral]: [T; 3], wheel: &Opposite<T>) -> Self {
        let [by_x, by_y] = below.slopes;
        let distance = away.hypotenuse(below.depth);
        let along = (away + below.depth * by_x) / distance;
        let across = (below.depth * by_y - away * wheel.advance) / distance;
        let steep = by_x * by_x + 1.0;
        Self {
            raised: distance - radius,
            slopes: [along, across - lateral, T::from(0.0)],
            bend: (steep + below.depth * below.bend - along * along) / distance,
            curvature: -below.bend / steep.three_halves(),
            ..Self::default()
        }
    }
}

impl<T: Real> Over<'_, T> {
    /// Height below the axle of the point `wheel` of the contact line, and its slope across [m, -].
    fn of_line(&self, wheel: &Opposite<T>) -> [T; 2] {
        let [_, radius] = self.across_and_down(self.line().even_at(wheel.u).point);
        let tangent = [wheel.normal[1], -wheel.normal[0]];
        [radius, dot(tangent, self.down) / dot(tangent, self.right)]
    }

    /// How far a round wheel is at `x` and `y` to the right of the marker from the circle about the
    /// axle through its contact line, which is at `on_line` along the track [m], where the point
    /// `wheel` is opposite; nothing where it stands upright.
    fn of_round(&self, x: T, y: T, wheel: &Opposite<T>, on_line: T) -> Option<Deviation<T>> {
        let [radius, lateral] = self.of_line(wheel);
        let below = self.line().round_below(x, y, wheel.u.value())?;
        Some(Deviation::of_surface(&below, [x - on_line, radius, lateral], wheel))
    }

    /// How far a round wheel that yaws is from the circle of its contact line at `x` and `y` to the
    /// right of the marker [m], where the point `wheel` of that is opposite, and its curvature there
    /// beyond that on the line [1/m].
    pub fn round_deviation(&self, x: T, y: T, wheel: &Opposite<T>) -> (Deviation<T>, T) {
        let at = |x: T| self.of_round(x, y, wheel, wheel.x);
        let Some((here, on_line)) = at(x).zip(at(wheel.x)) else { return Default::default() };
        (here, here.curvature - on_line.curvature)
    }
}

impl Over<'_> {
    /// How far the wheel is from the circle of its contact line at `x`, `y` to the right and `z`
    /// below the marker [m], where the point `wheel` of that is opposite.
    pub fn deviation(&self, x: f64, place: [f64; 2], wheel: &Opposite) -> Deviation {
        let own = self.of_surface(x, place, wheel).unwrap_or_default();
        let Some(waves) = self.waves() else { return own };
        let more = self.of_waves(&waves, x, place);
        Deviation {
            raised: own.raised + more.raised,
            slopes: [0, 1, 2].map(|i| own.slopes[i] + more.slopes[i]),
            bend: own.bend + more.bend,
            waves: more.waves,
            unround: own.unround + more.raised,
            lever: own.lever + more.lever,
            ..own
        }
    }

    /// That of deviations over the angle.
    fn of_waves(&self, waves: &Waves, x: f64, [y, z]: [f64; 2]) -> Deviation {
        let Waves { surface, below, forward: [cosine, sine], .. } = waves;
        let ahead = x * cosine + y * sine;
        let squared = ahead * ahead + z * z;
        let scale = self.nominal_radius() / squared;
        let [raised, slope, bend] = surface.at(below + self.nominal_radius() * ahead.atan2(z));
        let by_x = cosine * z * scale;
        Deviation {
            raised,
            slopes: [by_x, sine * z * scale, -ahead * scale].map(|turn| slope * turn),
            bend: bend * by_x * by_x - slope * 2.0 * cosine * by_x * ahead / squared,
            // Of a polar curve, whose circles beside the axle are as round.
            waves: -(raised + self.nominal_radius() * self.nominal_radius() * bend) / squared,
            unround: raised,
            lever: squared.sqrt() * slope * by_x,
            ..Deviation::default()
        }
    }

    /// That of the surface without them, of which a wheel without yaw has none; nothing where it
    /// stands upright.
    fn of_surface(&self, x: f64, [y, z]: [f64; 2], wheel: &Opposite) -> Option<Deviation> {
        if !self.leads() {
            return None;
        }
        let ahead = self.line().ahead_of_round(wheel.u);
        let round = self.of_round(x, y, wheel, wheel.x - ahead);
        if !self.varies_around() {
            return round;
        }
        let directions = [self.right, self.down];
        let below = self.line().wheel_below(x, self.beside_marker(y), directions, [wheel.u, z])?;
        let [radius, lateral] = self.of_line(wheel);
        let own = Deviation::of_surface(&below, [x - wheel.x, radius, lateral], wheel);
        let unround = own.raised - round.unwrap_or_default().raised;
        let lever = self.line().lever([x, y], &below) - ahead;
        Some(Deviation { unround, lever, ..own })
    }

    /// Curvature of the wheel at a place with `deviation` beyond that of its section on the contact
    /// line, at `y` to the right and `z` below the marker where the point `wheel` of that is [1/m].
    pub fn bulge(&self, deviation: &Deviation, place: [f64; 2], wheel: &Opposite) -> f64 {
        let on_line = if self.leads() {
            self.of_surface(wheel.x, place, wheel).map_or(deviation.curvature, |own| own.curvature)
        } else {
            0.0
        };
        deviation.curvature - on_line
    }
}
