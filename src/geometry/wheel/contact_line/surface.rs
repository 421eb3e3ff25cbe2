//! The surface of the wheel itself: where straight lines across the track meet it.
//!
//! A point P of the surface of revolution has its axial coordinate and its distance from the axle
//! on the profile,
//!
//! ```text
//! (P - M)·u = y_w(s),  |(P - M) - ((P - M)·u) u| = R0 + z_w(s)
//! ```
//!
//! and the normal y_w' n - z_w' u, with n the radial direction there. Rails are even along the
//! track; of a wheel whose section varies around the surface is that of its rows.

use super::ContactLine;
pub use crate::geometry::wheel::surface_point::SurfacePoint;

/// Newton steps to a point; three are the rule.
const MAX_STEPS: usize = 12;
/// Newton step that is the last one [m]: what is left is of the order of its square.
const LAST_STEP: f64 = 1e-8;
/// Least cosine of the angle between line and normal: lines that graze the wheel meet it nowhere
/// for sure.
const MIN_COSINE: f64 = 0.1;

impl ContactLine<'_> {
    /// Where the line from the point (`x`, `from`) across the track in the unit direction
    /// `direction` (y, z) meets the wheel's surface from inside, sought near the profile parameter
    /// `s` and at the distance `depth`; nothing where it does not.
    pub fn surface_along(
        &self,
        x: f64,
        from: [f64; 2],
        direction: [f64; 2],
        [mut s, mut depth]: [f64; 2],
    ) -> Option<SurfacePoint> {
        if let Some(around) = self.around {
            return self.surface_around(around, x, from, direction, [s, depth]);
        }
        let [ux, uy, uz] = self.axle;
        let start = [x - self.marker[0], from[0] - self.marker[1], from[1] - self.marker[2]];
        let axial_rate = direction[0] * uy + direction[1] * uz;
        for _ in 0..MAX_STEPS {
            if !(s > self.profile.start() && s < self.profile.end()) {
                return None;
            }
            let to = [start[0], start[1] + depth * direction[0], start[2] + depth * direction[1]];
            let axial = to[0] * ux + to[1] * uy + to[2] * uz;
            let radial = [to[0] - axial * ux, to[1] - axial * uy, to[2] - axial * uz];
            let radius =
                (radial[0] * radial[0] + radial[1] * radial[1] + radial[2] * radial[2]).sqrt();
            let outward = radial.map(|r| r / radius);
            let radial_rate = outward[1] * direction[0] + outward[2] * direction[1];
            let p = self.profile.at(s);
            let speed = (p.first[0] * p.first[0] + p.first[1] * p.first[1]).sqrt();
            let [dy, dz] = p.first.map(|d| d / speed);
            let facing = dy * radial_rate - dz * axial_rate;
            if facing <= MIN_COSINE {
                return None;
            }
            let missing = [p.point[0] - axial, p.point[1] + self.nominal_radius - radius];
            let step = (dy * missing[1] - dz * missing[0]) / facing;
            let along = (axial_rate * missing[1] - radial_rate * missing[0]) / (facing * speed);
            depth += step;
            s += along;
            if step.abs() + along.abs() <= LAST_STEP {
                let normal = [
                    dy * outward[0] - dz * ux,
                    dy * outward[1] - dz * uy,
                    dy * outward[2] - dz * uz,
                ];
                return Some(SurfacePoint { s, depth, normal });
            }
        }
        None
    }

    /// How far the surface of the round wheel is below the place at `x` along the track and `y` to the
    /// right of the marker, across track and axle, sought near the profile parameter `s` [m]; nothing
    /// where the wheel ends or stands upright.
    ///
    /// With v = y cos ψ - x sin ψ along the axle and f = x cos ψ + y sin ψ forward it is z below
    /// the axle, z² = R(v)² - f².
    pub fn round_below(&self, x: f64, y: f64, mut s: f64) -> Option<f64> {
        let (sine, cosine) = (-self.axle[0], self.cosine);
        let (axial, forward) = (y * cosine - x * sine, x * cosine + y * sine);
        for _ in 0..MAX_STEPS {
            let p = self.profile.at(s);
            let step = (axial - p.point[0]) / p.first[0];
            // Not a number where the profile stands upright.
            if !(s + step > self.profile.start() && s + step < self.profile.end()) {
                return None;
            }
            if step.abs() <= LAST_STEP {
                let radius = p.point[1] + step * p.first[1] + self.nominal_radius;
                return Some((radius * radius - forward * forward).max(0.0).sqrt());
            }
            s += step;
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use crate::geometry::profiles::profile::ProfileKind;
    use crate::geometry::wheel::contact_line::{ContactLine, WheelPose};
    use crate::io::load_profile;
    use approx::assert_relative_eq;

    const POSE: WheelPose = WheelPose { marker: [0.0, -0.01, -0.46], roll: 0.004, yaw: -0.012 };

    #[test]
    fn a_point_on_a_line_has_its_place_on_the_profile_and_the_normal_of_the_surface() {
        let wheel = load_profile("wheel", "S1002", ProfileKind::Wheel, 0.0, &[]).unwrap();
        let line = ContactLine::new(&wheel.curve, 0.46, &POSE);
        let [start, end] = line.range();
        for (y, angle) in [(0.01, -0.02), (-0.03, -0.3), (-0.038, -1.1)] {
            let places = (0..=1000).map(|i| start + (end - start) * f64::from(i) / 1000.0);
            let away = |s: &f64| (wheel.curve.at(*s).point[0] - y).abs();
            let s = places.min_by(|a, b| away(a).total_cmp(&away(b))).unwrap();
            let (sine, cosine) = f64::sin_cos(angle);
            // From 0.3 mm beside the outline of the wheel, along a normal of the rail.
            let at = line.at(s);
            let direction = [-sine, cosine];
            let from = [0, 1].map(|i| at.point[i] - 3e-4 * direction[i]);
            let on =
                |x: f64, guess: [f64; 2]| line.surface_along(x, from, direction, guess).unwrap();
            let middle = on(at.x, [s, 0.0]);
            assert_relative_eq!(middle.depth, 3e-4, epsilon = 1e-12);
            assert_relative_eq!(middle.s, s, epsilon = 1e-12);
            // The outline is where the normal has no part along x.
            assert_relative_eq!(middle.normal[0], 0.0, epsilon = 1e-12);
            let h = 1e-5;
            for x in [at.x - 5e-3, at.x + 4e-3] {
                let [a, b, c] = [x - h, x, x + h].map(|x| on(x, [s, 3e-4]));
                assert_relative_eq!(
                    b.normal.iter().map(|n| n * n).sum::<f64>(),
                    1.0,
                    epsilon = 1e-12
                );
                // The depth falls along x as the normal says.
                let facing = b.normal[1] * direction[0] + b.normal[2] * direction[1];
                assert_relative_eq!(
                    (c.depth - a.depth) / (2.0 * h),
                    -b.normal[0] / facing,
                    epsilon = 1e-6
                );
                assert!(b.depth < middle.depth);
            }
        }
    }

    #[test]
    fn a_line_beside_the_wheel_meets_it_nowhere() {
        let wheel = load_profile("wheel", "S1002", ProfileKind::Wheel, 0.0, &[]).unwrap();
        let line = ContactLine::new(&wheel.curve, 0.46, &POSE);
        assert!(line.surface_along(0.0, [0.5, 0.0], [0.0, 1.0], [0.02, 0.0]).is_none());
        // Along the axle.
        assert!(line.surface_along(0.0, [0.0, 0.0], [1.0, 0.0], [0.0, 0.0]).is_none());
    }
}
