//! An out-of-round wheel above a rail that varies along the track: the deviation of its surface
//! from the round wheel of its contact line.
//!
//! A place at x, y across and z below the axle has the distance ρ from the axle of that round
//! wheel, whose radius opposite is z_l. The amount by which the wheel is larger there,
//!
//! ```text
//! e = ρ - z_l,  ρ = sqrt((x - x_l)² + z²)
//! ```
//!
//! for a z on its surface, brings it nearer to the rail by as much. Of a wheel with deviations
//! over its angle e is that at the angle of the place about the axle; of one whose section varies
//! around, straight lines down meet the surface.

use super::over::{Opposite, Over};
use super::waves::Waves;
use crate::geometry::sections::rows::plane::dot;

/// How far the wheel is from the round one at a place.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Deviation<T = f64> {
    /// By how much its radius is larger [m].
    pub raised: T,
    /// Derivatives of that along the track, to the right and down [-].
    pub slopes: [T; 3],
    /// Second derivative along the track [1/m].
    pub bend: T,
    /// Curvature along the track, of a wheel with sections around that of its surface, of others
    /// beyond that of the round wheel; positive where it bulges [1/m].
    pub curvature: T,
}

impl Over<'_> {
    /// How far the wheel is from the round one at `x`, `y` to the right and `z` below the marker
    /// [m], where the point `wheel` of its contact line is opposite.
    pub fn deviation(&self, x: f64, [y, z]: [f64; 2], wheel: &Opposite) -> Deviation {
        if self.varies_around() {
            return self.around(x, [y, z], wheel).unwrap_or_default();
        }
        let Some(Waves { surface, below, forward: [cosine, sine], .. }) = self.waves() else {
            return Deviation::default();
        };
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
            curvature: -(raised + self.nominal_radius() * self.nominal_radius() * bend) / squared,
        }
    }

    /// The same for a wheel whose section varies around; nothing where that stands upright.
    fn around(&self, x: f64, [y, z]: [f64; 2], wheel: &Opposite) -> Option<Deviation> {
        let (line, down, right) = (self.line(), self.down, self.right);
        let below = line.wheel_below(x, self.beside_marker(y), [right, down], [wheel.u, z])?;
        let [_, radius] = self.across_and_down(line.even_at(wheel.u).point);
        let tangent = [wheel.normal[1], -wheel.normal[0]];
        let away = x - wheel.x;
        let distance = away.hypot(below.depth);
        let [by_x, by_y] = below.slopes;
        let along = (away + below.depth * by_x) / distance;
        let across = (below.depth * by_y - away * wheel.advance) / distance;
        Some(Deviation {
            raised: distance - radius,
            slopes: [along, across - dot(tangent, down) / dot(tangent, right), 0.0],
            bend: (1.0 + by_x * by_x + below.depth * below.bend - along * along) / distance,
            curvature: -below.bend / (1.0 + by_x * by_x).powf(1.5),
        })
    }

    /// Curvature of the wheel at a place with `deviation` beyond that of its section on the contact
    /// line, at `y` to the right and `z` below the marker where the point `wheel` of that is [1/m].
    pub fn bulge(&self, deviation: &Deviation, [y, z]: [f64; 2], wheel: &Opposite) -> f64 {
        let on_line = if self.varies_around() {
            self.around(wheel.x, [y, z], wheel).map_or(deviation.curvature, |own| own.curvature)
        } else {
            0.0
        };
        deviation.curvature - on_line
    }
}
